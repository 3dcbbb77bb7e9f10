"""Steps of a tolerance that end at an event: the step in which one is flagged is made again, as long as it takes.

The step that runs across an event has seen what is beyond it: a force that kinks there, an input that changes. So it
is not cut, but made anew from its start to the event, which is located on such steps: see event_search.py. The next
step begins there anew, as behind a jump in time.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from runtime.schemes.adaptive.adaptive_steps import AdaptiveSteps
from runtime.schemes.switching.event_search import first_passage
from runtime.schemes.switching.watched import NEVER, passed, quiet_until
from runtime.schemes.work import accounted, power_of

Runs = Callable[[np.ndarray], None]  # one application of the program, in place
FAR = 1e15  # steps
MOST_PARTS = 100  # steps that one step becomes when its end is rejected


def ended_at_event(scheme: AdaptiveSteps, z: np.ndarray, run: Runs) -> list[int]:
    """End the last step of z (whole, flat) in place where an event has just happened; which ones do."""
    own = scheme.layout.slice
    start, end = float(z[own("t_from")][0]), float(z[own("t_to")][0])
    before, after = z[own("event_before")].copy(), z[own("event_values")].copy()
    asleep = quiet_until(scheme, z) > start

    def ask(old: np.ndarray, new: np.ndarray) -> list[int]:
        return passed(scheme, old, new, asleep)

    found: dict[float, np.ndarray] = {end - start: z.copy()}

    def at(s: float) -> np.ndarray:
        found[s] = _made_again(scheme, z, start + s, run)
        return found[s][own("event_values")]

    s = first_passage(ask, at, before, after, end - start)
    z[:] = found[s]
    z[own("event_step")], z[own("cold")] = NEVER, 1.0
    return ask(before, z[own("event_values")])


def _made_again(scheme: AdaptiveSteps, z: np.ndarray, end: float, run: Runs) -> np.ndarray:
    """A copy of z with its last step ended there [s]."""
    own, z = scheme.layout.slice, z.copy()
    z[own("h_next")] = z[own("t_to")] - z[own("t_from")]
    z[own("fresh")] = z[own("cold")] = 0.0
    for name in ("t", "q", "v", "loop"):
        z[own(f"{name}_to")] = z[own(f"{name}_from")]
    z[own("accepted")] -= 1
    z[own("stops")], z[own("event_values")] = end, z[own("event_before")]
    kept = {name: z[own(name)].copy() for name in ("beside", "n")}
    z[own("beside")], z[own("n")] = 0.0, FAR  # no state on the way is seen
    for _ in range(MOST_PARTS):
        z[own("event_step")] = NEVER
        run(z)
        if z[own("t_to")][0] >= end or scheme.is_stuck(z):
            break
    for name, value in kept.items():
        z[own(name)] = value
    return z


def settled(scheme: AdaptiveSteps, z: np.ndarray, constants: np.ndarray) -> None:
    """Bring the account of the work in z (whole, flat) up to the end of its last step: something changes there."""
    own = scheme.layout.slice
    if not accounted(scheme) or not z[own("pending")][0]:
        return
    seen = scheme.at_end(z)[: scheme.layout.size]
    seen[own("t0")] -= z[own("beside")]
    P, h = power_of(scheme, seen, constants), z[own("pending")].copy()
    start, middle = z[own("power")].copy(), z[own("power_mid")].copy()
    done = h / 6 * (start + 4 * middle + P)
    z[own("work_from")] += done
    z[own("bends")] += np.abs(done - h / 2 * (start + P))
    z[own("pending")], z[own("power")] = 0.0, P


def shown_at_end(scheme: AdaptiveSteps, z: np.ndarray, dt: float, run: Runs) -> None:
    """Let z (whole, flat), whose work is settled, be seen at the end of its last step: one state of dt [s] more."""
    own = scheme.layout.slice
    t, n = float(z[own("t_to")][0]), float(z[own("n")][0]) + 1
    z[own("t0")] = t - n * dt
    while float(z[own("t0")][0]) + n * dt > t:
        z[own("t0")] = np.nextafter(z[own("t0")], -np.inf)
    run(z)
    if accounted(scheme):
        z[own("work")] = z[own("work_from")]
