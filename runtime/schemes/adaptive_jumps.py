"""Adaptive steps across jumps in time: where they may go next, and impulses of motions whose velocity jumps."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from runtime.contract.coordinates import whole
from runtime.schemes.adaptive_scheme import AdaptiveScheme
from runtime.schemes.stepper import Stepper
from runtime.schemes.switching.impulse import Impulse, impulse_at, moves_in_time
from runtime.schemes.switching.times import SwitchTime
from runtime.schemes.switching.watched import NEVER


def advance_across_jumps(
    stepper: Stepper,
    z: np.ndarray,
    steps: int,
    ready: np.ndarray,
    c: np.ndarray,
    dt: float,
    jumps: Sequence[SwitchTime],
    given: dict[float, Impulse],
) -> None:
    """Advance z (whole, flat) in place by so many states dt [s] apart; fewer up to an event or the least step.

    ready: what the program reads; c (c_size,): the model's constants with the inputs that hold. given: impulses of
    prescribed motions are entered here by their time.
    """
    scheme = stepper.scheme
    assert isinstance(scheme, AdaptiveScheme)
    end, moves = z[1] + steps, bool(jumps) and moves_in_time(scheme.model)
    event = scheme.layout.slice("event_step") if "event_step" in scheme.layout.sizes else slice(0, 0)

    def look_ahead() -> None:
        """Where no step crosses next; it halts there for impulses."""
        if moves and scheme.has_halted(z):
            if scheme.next_sample(z, dt) <= scheme.reached(z):
                return  # what lies before it is seen first
            given.update(give_impulse(scheme, z, c, jumps, dt))
        scheme.look_ahead(z, jumps, halts=moves)

    while z[1] < end and not scheme.hit_min_step(z) and not (z[event] < NEVER).any():
        look_ahead()
        stepper.run(z, ready, int(end - z[1]))
    if moves:
        look_ahead()


def give_impulse(
    scheme: AdaptiveScheme, z: np.ndarray, c: np.ndarray, jumps: Sequence[SwitchTime], dt: float
) -> dict[float, Impulse]:
    """Of the jump at the end of the last step of z (n_z,), in place: rates just after it; {} where none jumps.

    c (c_size,): the model's constants; dt [s]: from one state that is seen to the next.
    """
    model, reached = scheme.model, scheme.reached(z)
    there = next((one for one in jumps if one.time == reached), None)
    if there is None:
        return {}
    constants = scheme.constants(c)
    shown = scheme.observer(z=scheme.at_end(z)[: scheme.layout.size], c=constants)
    parts = {name: np.asarray(value).ravel() for name, value in shown.items()}
    q = whole(model, parts["q_i"], parts["q_d"])
    found = impulse_at(model, c, q, parts["q_i_dot"], there.before, there.after)
    if found is None:
        return {}
    change, impulse = found
    scheme.jump_at_end(z, change, dt, there.after)
    return {there.time: impulse}
