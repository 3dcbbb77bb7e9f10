"""Events in the state of a scheme: their values after the last step, and the first step in which one passed zero.

An event with a cool-down is not looked for until `event_quiet`, the time at which that of its last happening is over.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import casadi as ca
import numpy as np

from runtime.engine.program import Fields, Program, Sequence
from runtime.schemes.scheme import Scheme
from runtime.schemes.stage_equations import StageEquations

NEVER = 1e300


def watch_events(scheme: Scheme) -> None:
    """Give z the fields, where the model has events. Before anything of the scheme is built.

    Steps of a tolerance keep the values at their start, too: they end where an event is flagged.
    """
    events = scheme.model.description.events
    if not events or watches(scheme):
        return
    sizes = {"event_values": len(events), "event_step": 1}
    if any(event.cool_down for event in events):
        sizes["event_quiet"] = len(events)
    scheme.keep_account({**sizes, "event_before": len(events)} if scheme.adaptive else sizes)


def watches(scheme: Scheme) -> bool:
    """Has z the fields?"""
    return "event_step" in scheme.layout.sizes


def event_values(scheme: Scheme, z: np.ndarray, c: np.ndarray) -> np.ndarray:
    """(n_e,) at a state z (at least the scheme's part, flat); c as the stages read it."""

    def build() -> ca.Function:
        symbols = ca.SX.sym("z", scheme.layout.size), ca.SX.sym("c", scheme.c_size)
        equations = scheme.equations(symbols[1], scheme.layout.unpack(symbols[0]))
        return ca.Function("events", list(symbols), [_values(scheme, symbols[0], equations)["events"]])

    return np.asarray(scheme.derived("events", build)(z[: scheme.layout.size], c)).ravel()


def action_values(scheme: Scheme, z: np.ndarray, c: np.ndarray) -> np.ndarray:
    """(n_a,) what inputs become by the events' actions, event by event."""

    def build() -> ca.Function:
        symbols = ca.SX.sym("z", scheme.layout.size), ca.SX.sym("c", scheme.c_size)
        equations = scheme.equations(symbols[1], scheme.layout.unpack(symbols[0]))
        found = _values(scheme, symbols[0], equations).get("actions", ca.SX(0, 1))
        return ca.Function("actions", list(symbols), [found])

    return np.asarray(scheme.derived("actions", build)(z[: scheme.layout.size], c)).ravel()


def begin_events(scheme: Scheme, z: np.ndarray, c: np.ndarray, shown: np.ndarray | None = None) -> None:
    """Look from a state z (n_z,) on, at least the scheme's part; c as the stages read it.

    shown: the same state as it is seen, where z is at the end of a step that nobody has seen yet.
    """
    if watches(scheme):
        z[scheme.layout.slice("event_values")] = event_values(scheme, z if shown is None else shown, c)
        z[scheme.layout.slice("event_step")] = NEVER


def all_awake(scheme: Scheme, z: np.ndarray) -> None:
    """No event has happened yet at z (n_z,)."""
    if "event_quiet" in scheme.layout.sizes:
        z[scheme.layout.slice("event_quiet")] = -NEVER


def cool_down(scheme: Scheme, z: np.ndarray, happened: list[int], t: float) -> None:
    """These events have happened at t [s], the time of z (n_z,)."""
    if "event_quiet" in scheme.layout.sizes:
        quiet, events = z[scheme.layout.slice("event_quiet")], scheme.model.description.events
        for k in happened:
            quiet[k] = t + events[k].cool_down if events[k].cool_down else -NEVER


def quiet_until(scheme: Scheme, z: np.ndarray) -> np.ndarray:
    """(n_e,) until when events are not looked for [s]."""
    if "event_quiet" in scheme.layout.sizes:
        return z[scheme.layout.slice("event_quiet")]
    return np.full(len(scheme.model.description.events), -NEVER)


def with_events(scheme: Scheme, program: Program) -> Program:
    """A major step, and a look at the events where z has their fields; steps of a tolerance look themselves."""
    if not watches(scheme) or scheme.adaptive:
        return program

    def looked(z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        seen = _values(scheme, scheme.layout.pack(z), equations)
        flag = flagged(scheme, z, z["event_values"], seen["events"], seen["t"])
        return {"event_values": seen["events"], "event_step": ca.fmin(z["event_step"], ca.if_else(flag, z["n"], NEVER))}

    return Sequence((program, scheme.stage("events", looked)))


def flagged(scheme: Scheme, z: Fields, old: ca.SX, new: ca.SX, t: ca.SX) -> ca.SX:
    """Does an event whose cool-down is over by t pass zero between two sets of values (n_e,)?"""
    found = ca.SX(0)
    for k, event in enumerate(scheme.model.description.events):
        one = passes(old[k], new[k], event.direction)
        found = ca.fmax(found, one * (t > z["event_quiet"][k]) if "event_quiet" in z else one)
    return found > 0


def passes(old: Any, new: Any, direction: str) -> Any:
    """Does a value pass zero that way from old to new (SX, or arrays)? One that begins at zero does not."""
    rising, falling = (old < 0) * (new >= 0), (old > 0) * (new <= 0)
    return {"rising": rising, "falling": falling}.get(direction, rising + falling)


def passed(scheme: Scheme, old: np.ndarray, new: np.ndarray, asleep: np.ndarray | None = None) -> list[int]:
    """Which events happen between two sets of values (n_e,); asleep (n_e,): those that do not."""
    events = scheme.model.description.events
    found = [k for k, event in enumerate(events) if passes(old[k], new[k], event.direction)]
    return found if asleep is None else [k for k in found if not asleep[k]]


def _values(scheme: Scheme, z: ca.SX, equations: StageEquations) -> dict[str, ca.SX]:
    seen = scheme.observer(z=z, c=ca.vertcat(equations.c, equations.h))
    q, q_dot = (equations.joined(seen[f"q_i{end}"], seen[f"q_d{end}"]) for end in ("", "_dot"))
    return {**event_outputs(equations, seen["t"], q, q_dot), "t": seen["t"]}


def event_outputs(equations: StageEquations, t: ca.SX, q: ca.SX, q_dot: ca.SX) -> dict[str, ca.SX]:
    """`events` (n_e,), and `actions` where there are any, at all coordinates and rates (n,)."""
    found = equations.model.evaluate("events", q=q, q_dot=q_dot, t=t, c=equations.c)
    return {name: ca.densify(value) for name, value in found.items()}
