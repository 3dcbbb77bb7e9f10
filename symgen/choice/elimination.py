"""Which coordinates are dependent: pivots chosen along the structure first, numerically for loops (Eqs. 29-31).

A structural pivot is a coordinate that enters a constraint row with a constant coefficient, so it is solved in
closed form at every position (a joint that is linear in a body's R_o). Only rows without one - loop closures -
need Newton; their unknowns are chosen by pivoting on the remaining Jacobian at the initial state. Eliminating a
coordinate whose coefficient is constant can never divide by a vanishing sine. Structural pivots are what equation-based
modelling calls alias elimination, loop unknowns its tearing variables.

Constraint rows that the others imply: redundant everywhere, or only at the position where the scene starts.

Redundant rows are left out of the elimination and checked with all others. At a singular position the rows depend
on each other without being redundant; nothing may be left out there. A small motion tells the two apart.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

from symgen.system.build import System
from symgen.system.constraint import DerivationError
from symgen.system.equations import Equations

PIVOT_THRESHOLD = 0.1  # of the largest entry: lets a later body's coordinate be dependent rather than the crank's
RANK_TOLERANCE = 1e-9


@dataclass(frozen=True)
class Elimination:
    """q_d in the order it is computed: loop unknowns first, then structural (row, column) pairs.

    redundant: rows that the others imply at every position; nothing is solved from them.
    """

    structural: list[tuple[int, int]]
    loop_rows: list[int]
    loop_columns: list[int]
    independent: list[int]
    dependent: list[int] = field(default_factory=list)
    redundant: list[int] = field(default_factory=list)


def structural_pivots(
    system: System, left_out: frozenset[int] = frozenset()
) -> tuple[list[tuple[int, int]], list[int]]:
    """((row, column) pairs in the order in which they can be evaluated, rows left for loops), without left_out.

    The rows and columns of U in (30) that are triangular by structure.
    """
    equations, topology, placed = system.equations, system.topology, system.reduced.placed_columns
    orientations = system.reduced.rotation_vectors
    constraints = [*equations.constraints, *system.reduced.constraints[len(equations.constraints) :]]
    left_out = left_out | {
        k for k, row in enumerate(constraints) if row.label in {f"{t.body}.norm" for t in orientations}
    }
    column_distance = {c: topology.distance_of(b) for b, columns in equations.body_columns.items() for c in columns}
    keep, turns = _requested_independent(system), system.reduced.turn_columns  # no row is linear in a turn
    joint_depth = topology.depth()
    rows = sorted(
        (r for r in range(len(constraints)) if r not in left_out),
        key=lambda r: (joint_depth.get(constraints[r].joint, 0), r),
    )
    placing = {joint: placement.child for joint, placement in topology.placements.items()} if placed else {}
    placing |= system.orientations.children
    rows.sort(key=lambda r: constraints[r].joint not in placing)
    depends_on: dict[int, set[int]] = {}
    used: set[int] = set()  # columns that some dependent one depends on
    pairs: list[tuple[int, int]] = []
    loops: list[int] = []
    for row in rows:
        entries = constraints[row].C_q
        child = placing.get(constraints[row].joint)
        own = placed & set(equations.body_columns[child]) if child is not None else None
        candidates = [
            c
            for c, value in entries.items()
            if value.is_constant()
            and (c not in placed if own is None else c in own)
            and c not in depends_on
            and c not in equations.elastic_columns
            and c not in turns
            and c not in keep
            and not (c in used and _reaches(depends_on, set(entries) - {c}, c))
        ]
        if not candidates:
            loops.append(row)
            continue
        column = max(candidates, key=lambda c: (column_distance.get(c, 0), -c))
        depends_on[column] = set(entries) - {column}
        used |= depends_on[column]
        pairs.append((row, column))
    return _evaluation_order(pairs, depends_on), sorted(loops)


def _evaluation_order(pairs: list[tuple[int, int]], depends_on: dict[int, set[int]]) -> list[tuple[int, int]]:
    """The pairs by how many others each has to wait for, one after the other; those that wait as long as they come."""
    rounds: dict[int, int] = {}
    stack = [column for _, column in pairs]
    while stack:
        column = stack[-1]
        before = [c for c in depends_on[column] if c in depends_on]
        waiting = [c for c in before if c not in rounds]
        if waiting:
            stack += waiting
            continue
        rounds[column] = 1 + max((rounds[c] for c in before), default=0)
        stack.pop()
    return sorted(pairs, key=lambda pair: rounds[pair[1]])


def _reaches(depends_on: dict[int, set[int]], start: set[int], target: int) -> bool:
    """Does anything in `start` depend, directly or not, on `target`?"""
    stack, seen = list(start), set()
    while stack:
        column = stack.pop()
        if column == target:
            return True
        if column not in seen:
            seen.add(column)
            stack += depends_on.get(column, ())
    return False


def _requested_independent(system: System) -> set[int]:
    return {system.reduced.names.index(name) for name in system.requested.independent}


def dependent_rows(
    equations: Equations,
    structural: list[tuple[int, int]],
    loop_rows: list[int],
    jacobian: np.ndarray,
    scales: np.ndarray,
) -> list[int]:
    """Loop rows of C_q (rows x columns) that depend on the others at this position, by pivoting on scaled rows.

    scales (rows): what is left of a row is judged against it.
    """
    free = _free_columns(equations, structural)
    rigid = [k for k, c in enumerate(free) if c not in equations.elastic_columns]
    elastic = [k for k, c in enumerate(free) if c in equations.elastic_columns]
    pairs = _pivot(_reduce(jacobian, structural, loop_rows, free), rigid, elastic, scales[loop_rows])
    picked = {row for row, _ in pairs}
    return [row for k, row in enumerate(loop_rows) if k not in picked]


def choose_loops(
    system: System,
    structural: list[tuple[int, int]],
    loop_rows: list[int],
    jacobian: np.ndarray,
    scales: np.ndarray,
    redundant: list[int],
) -> Elimination:
    """Complete the choice with loop unknowns by pivoting on C_q (rows x columns) at the start: U, R of (29)-(30).

    loop_rows: independent rows, without the `redundant` ones. scales: as in `dependent_rows`. Raises
    DerivationError when the user's q_i cannot be independent.
    """
    equations, requested = system.reduced, system.requested.independent
    free = _free_columns(equations, structural)
    reduced = _reduce(jacobian, structural, loop_rows, free)
    keep = _requested_independent(system)
    rigid = [k for k, c in enumerate(free) if c not in keep and c not in equations.elastic_columns]
    elastic = [k for k, c in enumerate(free) if c not in keep and c in equations.elastic_columns]
    picked = [column for _, column in _pivot(reduced, rigid, elastic, scales[loop_rows])]
    if len(picked) < len(loop_rows):
        _refuse(equations, reduced, loop_rows)
    loop_columns = sorted(free[k] for k in picked)
    independent = [c for c in free if c not in loop_columns]
    if requested and keep != set(independent):
        _refuse_choice(equations, keep, independent)
    if keep:
        independent = [equations.names.index(name) for name in requested]
    dependent = loop_columns + [column for _, column in structural]
    return Elimination(structural, loop_rows, loop_columns, independent, dependent, redundant)


def _free_columns(equations: Equations, structural: list[tuple[int, int]]) -> list[int]:
    columns = {column for _, column in structural}
    return [c for c in range(len(equations.names)) if c not in columns]


def row_scales(jacobian: np.ndarray) -> np.ndarray:
    """Largest entry of each row of C_q in all coordinates, where a row has entries however redundant it is."""
    return np.asarray(np.abs(jacobian).max(axis=1, initial=0.0))


def _reduce(jacobian: np.ndarray, structural: list[tuple[int, int]], rows: list[int], free: list[int]) -> np.ndarray:
    """Loop rows of C_q after substituting the structural pivots."""
    work = jacobian.astype(float).copy()
    for row, column in reversed(structural):
        for target in rows:
            factor = work[target, column] / work[row, column]
            if factor != 0:
                work[target] -= factor * work[row]
    return work[np.ix_(rows, free)]


def _pivot(matrix: np.ndarray, rigid: list[int], elastic: list[int], scales: np.ndarray) -> list[tuple[int, int]]:
    """(row, column) of a nonsingular block, rigid columns first, the last acceptable one preferred.

    A row whose entries fall below RANK_TOLERANCE of its scale depends on those picked before and is passed over.
    """
    work, rows, pairs = matrix.copy(), list(range(matrix.shape[0])), []
    for pool in (list(rigid), list(elastic)):
        while rows and pool:
            block = np.abs(work[np.ix_(rows, pool)])
            block[block <= RANK_TOLERANCE * scales[rows, None]] = 0.0
            largest = block.max()
            if largest == 0.0:
                break
            good = [k for k in range(len(pool)) if block[:, k].max() >= PIVOT_THRESHOLD * largest]
            line = block[:, good[-1]]
            column = pool.pop(good[-1])
            row = rows.pop(int(np.flatnonzero(line >= (1 - RANK_TOLERANCE) * line.max())[0]))
            for other in rows:
                work[other] -= work[other, column] / work[row, column] * work[row]
            pairs.append((row, column))
    return pairs


def _refuse(equations: Equations, reduced: np.ndarray, rows: list[int]) -> None:
    left = np.linalg.svd(reduced)[0][:, -1] if reduced.size else np.ones(len(rows))
    names = sorted(
        {equations.constraints[row].joint for row, weight in zip(rows, left, strict=True) if abs(weight) > 1e-6}
    )
    raise DerivationError(
        "partition.independent",
        "the constraints cannot be solved for the remaining coordinates "
        f"at the initial state (loop of {', '.join(names)})",
        "choose other independent coordinates or leave the choice to symgen",
    )


def _refuse_choice(equations: Equations, keep: set[int], independent: list[int]) -> None:
    missing = sorted(set(independent) - keep)
    surplus = sorted(keep - set(independent))
    text = [f"{equations.names[c]} must be independent too" for c in missing]
    text += [f"{equations.names[c]} is determined by the joints" for c in surplus]
    raise DerivationError(
        "partition.independent",
        "; ".join(text),
        f"the scene has {len(independent)} degrees of freedom: "
        f"for instance {', '.join(equations.names[c] for c in independent)}",
    )


MOVE, MOVE_ELASTIC = 0.05, 1e-3  # rad or m: far enough to see a singular position, near enough to assemble again
MOVE_TIME = 0.0437  # s: rows with prescribed motions must agree at other times too
STILL_HOLDS = 1e-9  # C of an implied row after the motion, in rad or mechanism lengths
TRIALS, ELIMINATION_ITERATIONS = 3, 30

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
    for _ in range(ELIMINATION_ITERATIONS):
        C, C_q = constraints(moved, t)
        if not len(kept) or np.abs(C[kept]).max() <= 1e-14:
            break
        moved = moved - reach * np.linalg.lstsq(C_q[kept] * reach, C[kept], rcond=1e-13)[0]
    C, C_q = constraints(moved, t)
    scale = max(1.0, float(np.abs(C_q).max(initial=0.0)))
    return bool(np.abs(C[dropped]).max(initial=0.0) <= STILL_HOLDS * scale)
