"""Beyond a rigid stop: a start is refused by name, or moved to it where its scene says so."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace

import numpy as np

from runtime.contract.consistent_state import ConsistentState, InitialStateError
from runtime.contract.coordinates import parts, rate_parts
from runtime.contract.model import EmittedModel

ON_IT = 1e-9  # m or rad: so far beyond a stop is on it
MOST_CORRECTIONS = 20  # corrections
Assemble = Callable[[Mapping[str, float]], ConsistentState]


def within_stops(
    model: EmittedModel, c: np.ndarray, t: float, state: ConsistentState, assemble: Assemble
) -> ConsistentState:
    """The state (with constants c at t [s]), or one that is moved to the stops which it is beyond.

    assemble: coordinates by name that are kept -> a state. Raises InitialStateError by the name of a stop.
    """
    stops, given, moved = [one for one in model.mode_events if one.side], state, set[str]()
    for _ in range(MOST_CORRECTIONS):
        gap, G = gaps(model, c, t, state.q, state.q_dot)
        beyond = np.flatnonzero(gap < -ON_IT)
        if not len(beyond):
            break
        kept = [k for k in beyond if not stops[k].moves]
        if kept:
            raise InitialStateError(
                f"{stops[kept[0]].name} of model {model.name}",
                f"the motion starts {-float(gap[kept[0]]):.6g} beyond it",
                'begin within it, or give its limits beyond = "moved"',
            )
        moved |= {stops[k].name for k in beyond}
        rows = np.array([stops[k].side * G[stops[k].row] for k in beyond])
        by = np.linalg.lstsq(rows, -gap[beyond], rcond=None)[0]
        q_i, _ = parts(model, state.q)
        state = assemble({model.q_i[k]: float(q_i[k] + by[k]) for k in np.flatnonzero(by)})
    else:
        raise InitialStateError(
            f"{', '.join(sorted(moved))} of model {model.name}", "no start within them was found", "begin within them"
        )
    if not moved:
        return state
    changed = {
        name: (float(a), float(b))
        for name, a, b in zip(model.coordinates, given.q, state.q, strict=True)
        if abs(a - b) > ON_IT
    }
    return replace(state, changed={**given.changed, **changed})


def gaps(
    model: EmittedModel, c: np.ndarray, t: float, q: np.ndarray, q_dot: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """(n_stop,) gaps of rigid stops, and G (n_e, n_i) of the directions that they are of."""
    (q_i, q_d), (v, v_d) = parts(model, q), rate_parts(model, q, q_dot)
    found = model.evaluate("elements", q_i=q_i, q_d=q_d, q_i_dot=v, q_d_dot=v_d, t=t, c=c)
    return np.asarray(found["gap"], dtype=float).ravel(), np.asarray(found["G"], dtype=float)
