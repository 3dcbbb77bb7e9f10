"""Steps of a tolerance that end at an event: the step in which one is flagged is made again, as long as it takes.

The step that runs across an event has seen what is beyond it: a force that kinks there, an input that changes. So it
is not cut, but made anew from its start to the event, which is located on such steps: see event_search.py. The next
step begins there anew, as behind a jump in time.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from runtime.schemes.adaptive.adaptive_steps import AdaptiveSteps
from runtime.schemes.switching.dips import first_bracket, looked_at
from runtime.schemes.switching.event_search import first_passage
from runtime.schemes.switching.watched import NEVER, are_kinks, passed, quiet_until

Runs = Callable[[np.ndarray], None]  # one application of the program, in place
FAR = 1e15  # steps
MOST_PARTS = 100  # steps that one step becomes when its end is rejected


def ended_at_event(scheme: AdaptiveSteps, z: np.ndarray, constants: np.ndarray, run: Runs) -> list[int]:
    """End the last step of z (whole, flat) in place where an event has just happened; which ones do.

    None may: then the step has only come near to one, and z goes on from its end. constants: as stages read them.
    """
    own = scheme.layout.slice
    start, end = float(z[own("t_from")][0]), float(z[own("t_to")][0])
    asleep = quiet_until(scheme, z) > start
    found: dict[float, np.ndarray] = {end - start: z.copy()}
    values = {0.0: z[own("event_before")].copy(), end - start: z[own("event_values")].copy()}

    def ask(old: np.ndarray, new: np.ndarray) -> list[int]:
        return passed(scheme, old, new, asleep)

    def at(s: float) -> np.ndarray:
        if s not in values:
            found[s] = _made_again(scheme, z, start + s, run)
            values[s] = found[s][own("event_values")]
        return values[s]

    reached = 0.0
    for _ in range(MOST_PARTS):
        bracket = _bracket(scheme, z, constants, asleep, reached)
        if bracket is None:
            break
        low, high = ((s, at(s)) for s in bracket)
        if ask(low[1], high[1]):  # on steps that end there, too
            s, before = first_passage(ask, at, low, high, end - start)
            z[:] = found[s]
            z[own("event_step")], z[own("cold")] = NEVER, 1.0
            return ask(before, z[own("event_values")])
        reached = bracket[1]
    z[own("event_step")] = NEVER
    return []


def _bracket(
    scheme: AdaptiveSteps, z: np.ndarray, constants: np.ndarray, asleep: np.ndarray, reached: float
) -> tuple[float, float] | None:
    """Where on the last step of z, from `reached` [s] on, an event happens first."""
    own = scheme.layout.slice
    before, after = z[own("event_before")], z[own("event_values")]
    length = float(z[own("t_to")][0] - z[own("t_from")][0])
    between = looked_at(scheme.events_between, z[: scheme.layout.size], constants)
    kinks = are_kinks(scheme)

    def values(s: np.ndarray) -> np.ndarray:
        e = between(s / length)
        e[s == 0], e[s == length] = before, after  # as they were seen while stepping
        return e

    found = None
    if not kinks.all():
        found = first_bracket(lambda a, b: bool(passed(scheme, a, b, asleep | kinks)), values, reached, length)
    if passed(scheme, values(np.array([reached]))[0], after, asleep | ~kinks):
        return reached, length if found is None else found[1]
    return found


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


def shown_at_end(scheme: AdaptiveSteps, z: np.ndarray, dt: float, run: Runs) -> None:
    """Let z (whole, flat) be seen at the end of its last step: one state of dt [s] more."""
    own = scheme.layout.slice
    t, n = float(z[own("t_to")][0]), float(z[own("n")][0]) + 1
    z[own("t0")] = t - n * dt
    while float(z[own("t0")][0]) + n * dt > t:
        z[own("t0")] = np.nextafter(z[own("t0")], -np.inf)
    run(z)
