"""Constraint rows that the others imply: redundant everywhere, or only at the position where the scene starts.

Redundant rows are left out of the elimination and checked with all others. At a singular position the rows depend
on each other without being redundant; nothing may be left out there. A small motion tells the two apart.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from symgen.system.equations import Equations
from symgen.system.errors import DerivationError

MOVE, MOVE_ELASTIC = 0.05, 1e-3  # rad or m: far enough to see a singular position, near enough to assemble again
MOVE_TIME = 0.0437  # s: rows with prescribed motions must agree at other times too
STILL_HOLDS = 1e-9  # C of an implied row after the motion, in rad or mechanism lengths
TRIALS, ITERATIONS = 3, 30

Constraints = Callable[[np.ndarray, float], tuple[np.ndarray, np.ndarray]]


def require_redundant(equations: Equations, constraints: Constraints, q: np.ndarray, dropped: list[int]) -> None:
    """Check that rows which depend on the others at q still hold when the mechanism moves along the others alone.

    constraints(q, t) -> (C, C_q) of all rows. Raises DerivationError if the position is singular, or if the rows agree
    with the others only at t = 0.
    """
    reach = np.full(len(q), MOVE)
    reach[sorted(equations.elastic_columns)] = MOVE_ELASTIC
    kept = [row for row in range(len(equations.constraints)) if row not in dropped]
    joints = ", ".join(sorted({equations.constraints[row].joint for row in dropped}))
    rng = np.random.default_rng(0)
    if not all(_holds_after_motion(constraints, q, 0.0, kept, dropped, rng, reach) for _ in range(TRIALS)):
        raise DerivationError(
            "joints",
            f"the initial position is singular: {joints} and the joints of the same loops depend on each "
            "other there, and only there",
            "start from another position, or remove or weaken one of these joints "
            "(a point_on_line instead of a revolute, for instance)",
        )
    if not all(_holds_after_motion(constraints, q, t, kept, dropped, rng, reach) for t in (MOVE_TIME, -MOVE_TIME)):
        raise DerivationError(
            "joints",
            f"{joints} repeat what other joints already say at t = 0, and contradict them later",
            "give the prescribed motions equal functions of time, or remove all but one of them",
        )


def _holds_after_motion(
    constraints: Constraints,
    q: np.ndarray,
    t: float,
    kept: list[int],
    dropped: list[int],
    rng: np.random.Generator,
    reach: np.ndarray,
) -> bool:
    """Do the dropped rows hold after a random motion along the freedoms that the kept ones leave?

    reach: how far each coordinate may move.
    """
    _, C_q = constraints(q, t)
    _, sizes, right = np.linalg.svd(C_q[kept] * reach) if kept else (None, np.zeros(0), np.eye(len(q)))
    rank = int(np.sum(sizes > STILL_HOLDS * sizes.max(initial=0.0)))
    direction = rng.uniform(-1, 1, len(q) - rank) @ right[rank:]
    moved = q + reach * direction / max(float(np.abs(direction).max(initial=0.0)), 1e-300)
    for _ in range(ITERATIONS):
        C, C_q = constraints(moved, t)
        if not len(kept) or np.abs(C[kept]).max() <= 1e-14:
            break
        moved = moved - reach * np.linalg.lstsq(C_q[kept] * reach, C[kept], rcond=1e-13)[0]
    C, C_q = constraints(moved, t)
    scale = max(1.0, float(np.abs(C_q).max(initial=0.0)))
    return bool(np.abs(C[dropped]).max(initial=0.0) <= STILL_HOLDS * scale)
