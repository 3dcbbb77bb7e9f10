"""Events in the state of a scheme: their values after the last step, and the first step in which one passed zero."""

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
    """Give z the fields, where the model has events. Before anything of the scheme is built."""
    count = len(scheme.model.description.events)
    if count and not scheme.adaptive and "event_step" not in scheme.layout.sizes:
        scheme.keep_account({"event_values": count, "event_step": 1})


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
    """What inputs become by the events' actions, event by event."""

    def build() -> ca.Function:
        symbols = ca.SX.sym("z", scheme.layout.size), ca.SX.sym("c", scheme.c_size)
        equations = scheme.equations(symbols[1], scheme.layout.unpack(symbols[0]))
        found = _values(scheme, symbols[0], equations).get("actions", ca.SX(0, 1))
        return ca.Function("actions", list(symbols), [found])

    return np.asarray(scheme.derived("actions", build)(z[: scheme.layout.size], c)).ravel()


def begin_events(scheme: Scheme, z: np.ndarray, c: np.ndarray) -> None:
    """Look from a state z (at least the scheme's part, flat) on; c as the stages read it."""
    if watches(scheme):
        z[scheme.layout.slice("event_values")] = event_values(scheme, z, c)
        z[scheme.layout.slice("event_step")] = NEVER


def with_events(scheme: Scheme, program: Program) -> Program:
    """A major step, and a look at the events where z has their fields."""
    if not watches(scheme):
        return program

    def looked(z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        found = _values(scheme, scheme.layout.pack(z), equations)["events"]
        passed = ca.SX(0)
        for k, event in enumerate(scheme.model.description.events):
            passed = ca.fmax(passed, passes(z["event_values"][k], found[k], event.direction))
        return {"event_values": found, "event_step": ca.fmin(z["event_step"], ca.if_else(passed > 0, z["n"], NEVER))}

    return Sequence((program, scheme.stage("events", looked)))


def passes(old: Any, new: Any, direction: str) -> Any:
    """Does a value pass zero that way from old to new (SX, or arrays)? One that begins at zero does not."""
    rising, falling = (old < 0) * (new >= 0), (old > 0) * (new <= 0)
    return {"rising": rising, "falling": falling}.get(direction, rising + falling)


def passed(scheme: Scheme, old: np.ndarray, new: np.ndarray) -> list[int]:
    """Which events happen between two sets of values (n_e,)."""
    events = scheme.model.description.events
    return [k for k, event in enumerate(events) if passes(old[k], new[k], event.direction)]


def _values(scheme: Scheme, z: ca.SX, equations: StageEquations) -> dict[str, ca.SX]:
    seen = scheme.observer(z=z, c=ca.vertcat(equations.c, equations.h))
    q, q_dot = (equations.joined(seen[f"q_i{end}"], seen[f"q_d{end}"]) for end in ("", "_dot"))
    found = scheme.model.evaluate("events", q=q, q_dot=q_dot, t=seen["t"], c=equations.c)
    return {name: ca.densify(value) for name, value in found.items()}
