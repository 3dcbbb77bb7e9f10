"""Event location in adaptive steps: the step in which an event is flagged is made again, as long as it takes.

The step that runs across an event has seen what is beyond it: a force that kinks there, an input that changes. So it
is not cut, but made anew from its start to the event, which is located on such steps: see switching/event_search.py.
The next step begins there anew, as behind a jump in time.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

import casadi as ca
import numpy as np

from runtime.engine.program import Fields
from runtime.schemes.stage_equations import ClosedConfiguration, StageEquations
from runtime.schemes.switching.event_search import LOOK_NODES, ValuesInStep, first_bracket, first_passage, looked_at
from runtime.schemes.switching.watched import (
    NEVER,
    are_kinks,
    awake_sides,
    event_outputs,
    flagged,
    next_values,
    passed,
    quiet_until,
)

if TYPE_CHECKING:
    from runtime.schemes.adaptive_scheme import AdaptiveScheme

MOST_BRACKETS = 100  # of one step, in which something may happen

# ---- Stages of the program: which accepted steps an event may lie in.


def look(scheme: AdaptiveScheme, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
    """Where z watches for events: their values after an accepted step; one that happens ends the loop."""
    motion = equations.close_well(z["q_to"], z["loop_to"], z["t_to"])
    seen = _events_at(scheme, equations, motion, z["v_to"])
    found, held = seen["events"], {}
    flag = flagged(scheme, z, z["event_values"], found, z["t_to"])
    if "side" in z:
        held = {"side_before": z["side"], "side": awake_sides(scheme, z, seen["sides"], z["t_to"])}
    return {"event_before": z["event_values"], **next_values(scheme, z, found), **_stopped(z, flag, NEVER), **held}


def look_inside(scheme: AdaptiveScheme, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
    """The same where one may have happened and ended within the step; the next one is not too long to tell."""
    new, h = z["event_values"], z["t_to"] - z["t_from"]
    values = [z["event_before"], *(event_values_inside(scheme, z, equations, share) for share in LOOK_NODES), new]
    inside = ValuesInStep([one[: len(scheme.model.description.events)] for one in values])
    flag, longest = flagged(scheme, z, new, new, z["t_to"], inside.room_for_zero()), inside.longest(h, equations.h[0])
    shorter = scheme.planned(z, equations, z["t_to"], longest)
    next_one = {name: ca.if_else(longest < z["h_next"], one, z[name]) for name, one in shorter.items()}
    # ends alone tell nothing of values that turn within steps: the next one is looked at, too
    change = ca.if_else(inside.resolved(), z["event_change"], NEVER)
    return {**_stopped(z, flag, z["event_step"]), **next_one, "event_near": ca.SX(0), "event_change": change}


def _stopped(z: Fields, flag: ca.SX, otherwise: ca.SX | float) -> dict[str, ca.SX]:
    """Nothing remains to be gone where an event is flagged."""
    step, remaining = ca.if_else(flag, z["n"], otherwise), ca.if_else(flag, 0.0, z["remaining"])
    return {"event_step": step, "remaining": remaining}


def _events_at(
    scheme: AdaptiveScheme, equations: StageEquations, motion: ClosedConfiguration, v: ca.SX
) -> dict[str, ca.SX]:
    return event_outputs(scheme, equations, motion, v, equations.rates(motion, v))


def event_values_inside(scheme: AdaptiveScheme, z: Fields, equations: StageEquations, share: float | ca.SX) -> ca.SX:
    """(n_e,) by the dense output at a share of the last step."""
    tau = share * (z["t_to"] - z["t_from"])
    q, v = scheme.method.between(z, equations, tau)
    guess = z["loop_from"] + share * (z["loop_to"] - z["loop_from"])
    motion = equations.close_well(q, guess, z["t_from"] + tau)
    return _events_at(scheme, equations, motion, v)["events"]


def events_between(scheme: AdaptiveScheme) -> ca.Function:
    """(z, c, share of the last step) -> values of events (n_e,)."""
    z, c, share = ca.SX.sym("z", scheme.layout.size), ca.SX.sym("c", scheme.c_size), ca.SX.sym("share")
    fields = scheme.layout.unpack(z)
    found = event_values_inside(scheme, fields, scheme.equations(c, fields), share)
    return ca.Function("events_between", [z, c, share], [ca.densify(found)])


# ---- Where in the last step the first event lies.


@dataclass(frozen=True)
class LocatedEvents:
    """Events that happen together: z (whole, flat) with its last step ended there, and which ones they are."""

    z: np.ndarray
    events: list[int]


def first_event_in_step(
    scheme: AdaptiveScheme, z: np.ndarray, constants: np.ndarray, ended_sooner: Callable[[float], np.ndarray]
) -> LocatedEvents | None:
    """The first of the last step of z (whole, flat); None: the step has only come near to one.

    constants: as stages read them. ended_sooner(t): z with its last step made again up to t [s].
    """
    own = scheme.layout.slice
    start, end = float(z[own("t_from")][0]), float(z[own("t_to")][0])
    asleep = quiet_until(scheme, z) > start
    found: dict[float, np.ndarray] = {end - start: z.copy()}
    values = {0.0: z[own("event_before")].copy(), end - start: z[own("event_values")].copy()}

    def which(old: np.ndarray, new: np.ndarray) -> list[int]:
        return passed(scheme, old, new, asleep)

    def at(s: float) -> np.ndarray:
        if s not in values:
            found[s] = ended_sooner(start + s)
            values[s] = found[s][own("event_values")]
        return values[s]

    reached = 0.0
    for _ in range(MOST_BRACKETS):
        bracket = _bracket(scheme, z, constants, asleep, reached)
        if bracket is None:
            break
        low, high = ((s, at(s)) for s in bracket)
        if which(low[1], high[1]):  # on steps that end there, too
            s, before = first_passage(which, at, low, high, end - start)
            return LocatedEvents(found[s], which(before, found[s][own("event_values")]))
        reached = bracket[1]
    return None


def _bracket(
    scheme: AdaptiveScheme, z: np.ndarray, constants: np.ndarray, asleep: np.ndarray, reached: float
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
    first = length if found is None else found[0]
    low, high = values(np.array([reached, first]))
    return (reached, first) if passed(scheme, low, high, asleep | ~kinks) else found
