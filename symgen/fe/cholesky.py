"""Sparse Cholesky factorisation of a finite-element matrix: nested dissection by places, then dense fronts.

The mesh is halved by planes along its longest side, again and again; what parts two halves is eliminated after them
(George 1973). Each part is one dense front that takes over what is left of the two parts below it (the multifrontal
method, Duff & Reid 1983), so that nearly all work is done by LAPACK. Sizes and operations are known before a number is
computed: memory is checked, progress is exact, and Ctrl-C is heard between fronts.

References: A. George, Nested dissection of a regular finite element mesh, SIAM J. Numer. Anal. 10 (1973) 345-363.
I. S. Duff, J. K. Reid, The multifrontal solution of indefinite sparse symmetric linear equations, ACM Trans. Math.
Softw. 9 (1983) 302-325.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np
import scipy.sparse as sp
from numpy.typing import NDArray
from scipy.linalg.blas import dsyrk, dtrsm
from scipy.linalg.lapack import dpotrf

from symgen.modes.cleaning import Array

SAME_PLANE = 1e-6  # of the extent: nodes so near are in one plane
LEAF_NODES = 48  # parts of up to so many nodes are not halved again
NOT_HALVED = -1
Integers = NDArray[np.int64]
Flags = NDArray[np.bool_]
Progress = Callable[[float, float], None]  # thousand million operations done, of all


class NotPositiveDefinite(ValueError):
    """A pivot is not positive: row says where in the matrix."""

    def __init__(self, row: int) -> None:
        super().__init__(f"the pivot of row {row} is not positive")
        self.row = row


@dataclass(frozen=True, eq=False)
class Front:
    """Rows first ... last - 1 of the elimination order, which meet the later rows `boundary` (b,), ascending."""

    first: int
    last: int
    boundary: Integers
    children: tuple[int, ...]

    @property
    def pivots(self) -> int:
        """How many rows are eliminated."""
        return self.last - self.first

    @property
    def operations(self) -> float:
        """Multiplications and additions of its elimination."""
        p, b = float(self.pivots), float(len(self.boundary))
        return p**3 / 3.0 + p * p * b + p * b * b


@dataclass(frozen=True, eq=False)
class EliminationPlan:
    """order (n,): rows of the matrix as they are eliminated; fronts, children before parents."""

    order: Integers
    fronts: list[Front]

    @property
    def operations(self) -> float:
        """Of the factorisation."""
        return sum(front.operations for front in self.fronts)

    @property
    def bytes_of_factor(self) -> int:
        """What the factor takes."""
        return sum(8 * front.pivots * (front.pivots + len(front.boundary)) for front in self.fronts)

    @property
    def bytes_at_peak(self) -> int:
        """The factor and the fronts that wait for their parents, at the worst moment."""
        kept = waiting = worst = 0
        for front in self.fronts:
            b = len(front.boundary)
            kept += 8 * front.pivots * (front.pivots + b)
            worst = max(worst, kept + waiting + 8 * b * b)
            waiting += 8 * b * b - sum(8 * len(self.fronts[child].boundary) ** 2 for child in front.children)
        return worst


def elimination_plan(matrix: sp.csr_matrix, node: Integers, positions: Array) -> EliminationPlan:
    """Plan for a symmetric matrix (n, n) whose row r belongs to node[r] at positions[node[r]], (3,) [m]."""
    used, compact = np.unique(node, return_inverse=True)
    n, count = len(node), len(used)
    members = sp.csr_matrix((np.ones(n, dtype=np.int32), (compact, np.arange(n))), shape=(count, n))
    pattern = sp.csr_matrix((np.ones(len(matrix.data), dtype=np.int32), matrix.indices, matrix.indptr), shape=(n, n))
    graph = sp.csr_matrix(members @ pattern @ members.T)
    parts = list(_parts(graph, positions[used]))
    order = np.concatenate([nodes for nodes, _ in parts])
    place = np.empty(count, dtype=np.int64)
    place[order] = np.arange(count)
    starts = np.concatenate([[0], np.cumsum(np.bincount(compact, minlength=count)[order])])
    fronts: list[Front] = []
    later: list[Integers] = []  # boundary of each front, as places of nodes
    end = 0
    for nodes, children in parts:
        end += len(nodes)
        near = np.unique(np.concatenate([place[_neighbours(graph, nodes)], *(later[child] for child in children)]))
        later.append(near[near >= end])
        fronts.append(
            Front(int(starts[end - len(nodes)]), int(starts[end]), _ranges(starts, later[-1]), tuple(children))
        )
    return EliminationPlan(np.argsort(place[compact], kind="stable"), fronts)


def _parts(graph: sp.csr_matrix, places: Array) -> Iterator[tuple[Integers, list[int]]]:
    """(nodes of a part, indices of its children), children first."""
    side = np.zeros(graph.shape[0], dtype=np.int8)
    made = 0
    # A stack instead of recursion: nodes still to be halved, or a separator that waits for its two halves.
    done: list[int] = []
    todo: list[tuple[Integers, int]] = [(np.arange(graph.shape[0]), NOT_HALVED)]
    while todo:
        nodes, halves = todo.pop()
        if halves != NOT_HALVED or len(nodes) <= LEAF_NODES:
            children = [done.pop() for _ in range(max(halves, 0))]
            yield nodes, children[::-1]
            done.append(made)
            made += 1
            continue
        low, high, separator = _halves(graph, places, nodes, side)
        parts = [part for part in (high, low) if len(part)]
        todo += [(separator, len(parts)), *((part, NOT_HALVED) for part in parts)]


def _halves(
    graph: sp.csr_matrix, places: Array, nodes: Integers, side: NDArray[np.int8]
) -> tuple[Integers, Integers, Integers]:
    """Two halves that do not meet, and the nodes between them."""
    along = places[nodes, int(np.ptp(places[nodes], axis=0).argmax())]
    middle, extent = float(np.median(along)), float(np.ptp(along))
    below = along < middle - SAME_PLANE * extent
    if 4 * int(below.sum()) < len(nodes):  # a layer of nodes stays in one piece, unless it is most of them
        below = along < middle + SAME_PLANE * extent
    if not 0 < int(below.sum()) < len(nodes):
        below = np.arange(len(nodes)) < len(nodes) // 2
    low, high = nodes[below], nodes[~below]
    side[low], side[high] = 1, 2
    edges = [_touching(graph, low, side == 2), _touching(graph, high, side == 1)]
    side[nodes] = 0
    if edges[0].sum() <= edges[1].sum():
        return low[~edges[0]], high, low[edges[0]]
    return low, high[~edges[1]], high[edges[1]]


def _touching(graph: sp.csr_matrix, nodes: Integers, others: Flags) -> Flags:
    """Which of the nodes have a neighbour among the others, (n,) of bool."""
    rows = graph[nodes]  # none of them is empty: a node meets itself
    return np.asarray(np.add.reduceat(np.append(others[rows.indices], False), rows.indptr[:-1]) > 0)


def _neighbours(graph: sp.csr_matrix, nodes: Integers) -> Integers:
    return np.asarray(graph[nodes].indices, dtype=np.int64)


def _ranges(starts: Integers, places: Integers) -> Integers:
    """All rows of the nodes at these places, ascending."""
    counts = starts[places + 1] - starts[places]
    offsets = np.repeat(starts[places] - np.concatenate([[0], np.cumsum(counts)[:-1]]), counts)
    return np.asarray(offsets + np.arange(int(counts.sum())), dtype=np.int64)


@dataclass(frozen=True, eq=False)
class Cholesky:
    """A = L L^T of a sparse symmetric positive definite A; panels: columns of L, front by front.

    smallest_pivot: the least of L_ii^2 / A_ii, near round-off where A is singular.
    """

    plan: EliminationPlan
    panels: list[tuple[Array, Array]]
    smallest_pivot: float

    def solve(self, force: Array) -> Array:
        """Solve A x = force, shape (n,) or (n, k)."""
        x = np.asarray(force, dtype=np.float64).reshape(len(self.plan.order), -1)[self.plan.order]
        for front, (top, below) in zip(self.plan.fronts, self.panels, strict=True):
            own = dtrsm(1.0, top, x[front.first : front.last], lower=1)
            x[front.first : front.last] = own
            x[front.boundary] -= below @ own
        for front, (top, below) in zip(self.plan.fronts[::-1], self.panels[::-1], strict=True):
            own = x[front.first : front.last] - below.T @ x[front.boundary]
            x[front.first : front.last] = dtrsm(1.0, top, own, lower=1, trans_a=1)
        result = np.empty_like(x)
        result[self.plan.order] = x
        return result.reshape(np.shape(force))


def cholesky(matrix: sp.csr_matrix, plan: EliminationPlan, progress: Progress | None = None) -> Cholesky:
    """Factorise by the plan. Raises NotPositiveDefinite, with the row."""
    n, order = len(plan.order), plan.order
    place = np.empty(n, dtype=np.int64)
    place[order] = np.arange(n)
    local = np.empty(n, dtype=np.int64)  # of the rows of the front at hand
    waiting: dict[int, Array] = {}
    panels: list[tuple[Array, Array]] = []
    done, total = 0.0, plan.operations
    for index, front in enumerate(plan.fronts):
        p, b = front.pivots, len(front.boundary)
        local[front.first : front.last] = np.arange(p)
        local[front.boundary] = p + np.arange(b)
        panel, update = np.zeros((p + b, p), order="F"), np.zeros((b, b), order="F")
        rows = matrix[order[front.first : front.last]]
        columns = place[rows.indices]
        later = columns >= front.first
        panel[local[columns[later]], np.repeat(np.arange(p), np.diff(rows.indptr))[later]] = rows.data[later]
        for child in front.children:
            if child in waiting:
                _take_over(panel, update, local[plan.fronts[child].boundary], waiting.pop(child))
        top, failed = dpotrf(panel[:p], lower=1, clean=0)
        if failed:
            raise NotPositiveDefinite(int(order[front.first + failed - 1]))
        below = dtrsm(1.0, top, panel[p:], side=1, lower=1, trans_a=1)
        if b:
            waiting[index] = dsyrk(-1.0, below, beta=1.0, c=update, lower=1, overwrite_c=1)
        panels.append((top, below))
        done += front.operations
        if progress is not None:
            progress(1e-9 * done, 1e-9 * total)
    pivots = np.concatenate([np.diag(top) for top, _ in panels]) ** 2
    return Cholesky(plan, panels, float(np.min(pivots / matrix.diagonal()[order], initial=1.0)))


def _take_over(panel: Array, update: Array, rows: Integers, rest: Array) -> None:
    """Add what a child left, (len(rows), len(rows)), lower triangle."""
    p = panel.shape[1]
    inner = int(np.searchsorted(rows, p))
    panel[rows[:, None], rows[:inner]] += rest[:, :inner]
    update[np.ix_(rows[inner:] - p, rows[inner:] - p)] += rest[inner:, inner:]
