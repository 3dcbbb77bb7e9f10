"""The state a run starts from: the model's own, or one with values and parameters changed by the user."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from runtime.contract.consistent_state import ConsistentState, InitialStateError
from runtime.contract.coordinates import Initial, values_by_name
from runtime.contract.model import EmittedModel
from runtime.operating.given_state import given_state

STARTS = ("given", "quasi_static", "quasi_static_unstable", "equilibrium")


def start_state(
    model: EmittedModel, p: np.ndarray, c: np.ndarray, t0: float, initial: Initial, start: str | None = None
) -> ConsistentState:
    """Consistent q and q_dot for parameters p at t0, keeping the model's q_i except for the user's changes.

    initial: what has a state, or coordinate names and `<coordinate>_dot` rates; they are kept exactly, within rigid
    stops. start: one of STARTS, the scene's own by default; elastic coordinates that the user changed are `given`.
    Raises InitialStateError.
    """
    chosen = start or str(model.simulation.get("start", "given"))
    if chosen not in STARTS:
        raise InitialStateError(f"start must be one of {', '.join(STARTS)}, not {chosen!r}")
    changes = values_by_name(initial)

    def started(more: Mapping[str, float]) -> ConsistentState:
        state = given_state(model, p, c, t0, {**(changes or {}), **more} if more else changes)
        if chosen == "given" or (start is None and _names_elastic(model, changes or {})):
            return state
        if chosen == "equilibrium":
            from runtime.start.quasi_static import equilibrium_state

            return equilibrium_state(model, p, c, t0, state)
        from runtime.start.quasi_static import quasi_static_state

        return quasi_static_state(model, c, t0, state, unstable=chosen == "quasi_static_unstable")

    state = started({})
    if any(event.side for event in model.mode_events):
        from runtime.operating.at_stops import within_stops

        return within_stops(model, c, t0, state, started)
    return state


def _names_elastic(model: EmittedModel, changes: Mapping[str, float]) -> bool:
    return any(name in changes or f"{name}_dot" in changes for name in model.elastic)
