"""A state beside that of a run: what one major step hands to the next, moved as a small change of the motion asks.

What changes of coordinates and rates make of z is the difference of two starts, one at the state of
the run and one beside it: so every scheme's own memory of earlier steps is moved along, and charts of turns are turned.
"""

from __future__ import annotations

import numpy as np

from runtime.contract.angular import angular_velocity, exponential, parameter_rates, product
from runtime.contract.coordinates import whole
from runtime.contract.model import Model
from runtime.running.segment import Segment
from runtime.schemes.adaptive.adaptive_steps import AdaptiveSteps
from runtime.schemes.state_fields import Lasting

MOVING = {"x": ("x", "q_to"), "v": ("v", "v_to"), "loop": ("loop", "loop_to")}  # fields of steps that vary


def seen_state(segment: Segment, z: np.ndarray, constants: np.ndarray | None = None) -> tuple[np.ndarray, np.ndarray]:
    """All coordinates and rates (n,) of a state; constants: as stages read them, None: those of the run."""
    scheme = segment.plan.scheme
    c = scheme.constants(segment.c) if constants is None else constants
    seen = scheme.observer(z=segment.stepper.state(z), c=c)
    q_i, q_d, v, v_d = (seen[name].full().ravel() for name in ("q_i", "q_d", "q_i_dot", "q_d_dot"))
    return whole(segment.model, q_i, q_d), whole(segment.model, v, v_d)


def stepped_to(segment: Segment, z: np.ndarray) -> np.ndarray:
    """z (whole, flat) seen where its last step ends: up to a step behind what is seen where steps follow from a
    tolerance, and it is from there that they go on.
    """
    scheme = segment.plan.scheme
    return scheme.at_end(z) if isinstance(scheme, AdaptiveSteps) else z


def small_change(
    model: Model, q: np.ndarray, q_dot: np.ndarray, dq: np.ndarray, dq_dot: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Changes (n_i,) of q_i and its rates that small changes (n,) of all coordinates and rates come to.

    Turns count in the axes of their bodies, from where these are, and so do the changes of angular velocities.
    """
    at, change = model.places, np.zeros((2, len(model.q_i)))
    change[:, at.plain] = dq[at.columns], dq_dot[at.columns]
    for turns, e in zip(at.turns, at.parameters, strict=True):
        own = turns < at.n_i
        change[0, turns[own]] = angular_velocity(q[e], dq[e])[own]
        change[1, turns[own]] = (angular_velocity(q[e], dq_dot[e]) + angular_velocity(dq[e], q_dot[e]))[own]
    return change[0], change[1]


def _changed(
    model: Model, q: np.ndarray, q_dot: np.ndarray, di: np.ndarray, dv: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """All coordinates and rates (n,) after changes as in `small_change`; dependent ones are left as they are.

    Of an orientation that a loop splits the part that follows is found by the closure.
    """
    at, q_new, rates = model.places, q.copy(), q_dot.copy()
    q_new[at.columns] += di[at.plain]
    rates[at.columns] += dv[at.plain]
    for turns, e in zip(at.turns, at.parameters, strict=True):
        own, turn, spin = turns < at.n_i, np.zeros(3), angular_velocity(q[e], q_dot[e])
        turn[own] = di[turns[own]]
        spin[own] += dv[turns[own]]
        q_new[e] = product(q[e], exponential(turn))
        rates[e] = parameter_rates(q_new[e], spin)
    return q_new, rates


def _change(segment: Segment, z: np.ndarray, di: np.ndarray, dv: np.ndarray) -> np.ndarray:
    """Change (len(z),) of a state z for changes as in `small_change` where its last step ends."""
    scheme, plan, z = segment.plan.scheme, segment.plan, stepped_to(segment, z)
    layout, clock = scheme.layout, segment.time_of(z)
    c, found, state = segment.with_inputs(z), np.zeros_like(z), seen_state(segment, z)
    states = (_changed(segment.model, *state, k * di, k * dv) for k in (0, 1))
    here, there = (segment.stepper.start(clock, *one, c, plan.grid.dt_L) for one in states)
    moved = there - here
    if "chart" in layout.sizes:  # a quaternion and its negative are one orientation
        charts = (vector[layout.slice("chart")].reshape(-1, 4) for vector in (here, z, moved))
        own, wanted, change = charts
        change *= np.where((own * wanted).sum(axis=1) < 0, -1.0, 1.0)[:, None]
    if isinstance(scheme, AdaptiveSteps):
        for source, fields in MOVING.items():
            for name in fields:
                found[layout.slice(name)] = moved[layout.slice(source)]
        names = ["chart"] if "chart" in layout.sizes else []
    else:
        names = scheme.memory
    for name in names:
        found[layout.slice(name)] = moved[layout.slice(name)]
    return found


def placed_beside(segment: Segment, z: np.ndarray, di: np.ndarray, dv: np.ndarray) -> np.ndarray | None:
    """The state (whole, flat) beside z by changes as in `small_change`; None if it is not finite."""
    scheme, found = segment.plan.scheme, z + _change(segment, z, di, dv)
    if isinstance(scheme, AdaptiveSteps):
        for name in {"cold", "restart"} & {*scheme.layout.sizes}:
            found[scheme.layout.slice(name)] = 1.0  # what was evaluated until the end of the step belongs to the run
    return found if np.isfinite(found).all() else None


def take_given(segment: Segment, z: np.ndarray, other: np.ndarray) -> None:
    """Give `other` what z has from outside."""
    for name in segment.plan.scheme.lasting(Lasting.GIVEN):
        own = segment.plan.scheme.layout.slice(name)
        other[own] = z[own]
