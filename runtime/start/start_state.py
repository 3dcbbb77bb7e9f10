"""The state a run starts from: the model's own, or one with values and parameters changed by the user."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from runtime.contract.consistent_state import ConsistentState, InitialStateError
from runtime.contract.coordinates import Initial, values_by_name
from runtime.contract.model import Model
from runtime.operating.equilibrium import NoEquilibrium, equilibrium
from runtime.operating.functions import PointFunctions
from runtime.operating.given_state import given_state
from runtime.operating.linearise import rigid_rates
from runtime.start.quasi_static import quasi_static_state

STARTS = ("given", "quasi_static", "quasi_static_unstable", "equilibrium")


def start_state(
    model: Model, p: np.ndarray, c: np.ndarray, t0: float, initial: Initial, start: str | None = None
) -> ConsistentState:
    """Consistent q and q_dot for parameters p at t0, keeping the model's q_i except for the user's changes.

    initial: what has a state, or coordinate names and `<coordinate>_dot` rates; they are kept exactly. start: one of
    STARTS, the scene's own by default; elastic coordinates that the user changed are `given`. Raises InitialStateError.
    """
    chosen = start or str(model.simulation.get("start", "given"))
    if chosen not in STARTS:
        raise InitialStateError(f"start must be one of {', '.join(STARTS)}, not {chosen!r}")
    changes = values_by_name(initial)
    state = given_state(model, p, c, t0, changes)
    if chosen == "given" or (start is None and _names_elastic(model, changes or {})):
        return state
    if chosen == "equilibrium":
        return equilibrium_state(model, p, c, t0, state)
    return quasi_static_state(model, c, t0, state, unstable=chosen == "quasi_static_unstable")


def equilibrium_state(model: Model, p: np.ndarray, c: np.ndarray, t0: float, state: ConsistentState) -> ConsistentState:
    """The equilibrium reached from a state: all coordinates settle but those that turn, which keep their rates.

    Prescribed motions are held while it is sought, and begin with their rates. Raises InitialStateError.
    """
    rates = rigid_rates(model, state.q, state.q_dot)
    values = {one.name: float(value) for one, value in zip(model.parameters, p, strict=True) if value != one.default}
    place = {name: float(state.q[k]) for k, name in enumerate(model.coordinates)}
    try:
        found = equilibrium(model, rates=rates, parameters=values, initial=place, t=t0)
    except NoEquilibrium as error:
        raise InitialStateError(f"start = equilibrium: {error}") from error
    q, q_dot = found.q, PointFunctions(model, c)(found.state).q_dot
    changed = {
        name: (float(before), float(after))
        for name, before, after in zip(model.coordinates, state.q, q, strict=True)
        if before != after
    }
    return replace(state, q=q, q_dot=q_dot, changed={**state.changed, **changed})


def _names_elastic(model: Model, changes: Mapping[str, float]) -> bool:
    return any(name in changes or f"{name}_dot" in changes for name in model.elastic)
