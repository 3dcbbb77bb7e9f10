"""What assembly did to coordinates that nobody gave: told where it moved them far, or might have gone elsewhere."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace

import numpy as np

from runtime.contract.consistent_state import SAME, ConsistentState, less_turns
from runtime.contract.records import Coordinate
from runtime.contract.status import EventKind

ASSEMBLED: EventKind = "assembled"
QUARTER = np.pi / 2
SHOWN = 4  # coordinates that a text names


def with_words(state: ConsistentState, coordinates: Sequence[Coordinate], given: Collection[str]) -> ConsistentState:
    """The state with `told` of what assembly did; given: names of coordinates that were."""
    told: list[str] = []
    if state.placed is not None:
        far = [k for k in _left_open(coordinates, given) if _is_far(coordinates, k, state.placed, state.q)]
        moves = [f"{coordinates[k].name} {state.placed[k]:.4g} -> {state.q[k]:.4g}" for k in far]
        if moves:
            told.append(
                f"closing the loops moved far what was not given: {_shown(moves)}. Give them to choose the branch"
            )
    if state.other is not None:
        other = state.other
        apart = [k for k in _left_open(coordinates, given) if abs(less_turns(other[k] - state.q[k])) > SAME]
        places = [f"{coordinates[k].name} = {other[k]:.4g}, not {state.q[k]:.4g}" for k in apart]
        if places:
            told.append(f"another branch lies about as near: {_shown(places)}. Give one of them to choose it")
    return replace(state, told=(*state.told, *((ASSEMBLED, text) for text in told)))


def _left_open(coordinates: Sequence[Coordinate], given: Collection[str]) -> list[int]:
    """Angles first, which say more than places."""
    columns = [k for k, one in enumerate(coordinates) if one.name not in given and one.kind not in ("modal", "state")]
    return sorted(columns, key=lambda k: not coordinates[k].turns)


def _is_far(coordinates: Sequence[Coordinate], k: int, placed: np.ndarray, q: np.ndarray) -> bool:
    """More than a quarter turn, or than the extent of the mechanism?"""
    if coordinates[k].kind == "angle":
        return abs(float(q[k] - placed[k])) > QUARTER
    if coordinates[k].kind == "euler_parameter":
        own = [
            j for j, one in enumerate(coordinates) if (one.owner, one.kind) == (coordinates[k].owner, "euler_parameter")
        ]
        return k == own[0] and abs(float(q[own] @ placed[own])) < np.cos(QUARTER / 2)
    origins = [j for j, one in enumerate(coordinates) if one.kind == "position"]
    extent = float(np.ptp(q[origins]))
    return 0 < extent < abs(float(q[k] - placed[k]))


def _shown(parts: list[str]) -> str:
    return ", ".join(parts[:SHOWN]) + (", ..." if len(parts) > SHOWN else "")
