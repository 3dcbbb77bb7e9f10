"""Which nodes step how often: groups by themselves, or as they are named (the paper's Fig. 1, Eqs. 5-9, 72).

A node is fast when the step of the group would be too long for its row. Around it stand two rings of neighbours
that step as fast though they need not: without them sub-cycling has windows of growth at 7 to 30 % of all steps,
with one ring at up to 1.5 %, with two at none below 0.93 of the limit (docs/theory/schemes.md).
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
import scipy.sparse as sp
from numpy.typing import NDArray

from runtime.structures.limits import damped_limit, largest_frequency, row_limits
from runtime.structures.structure import Array, LinearStructure, StructureError

RINGS_OF_REGION = 2
SAFETY = 0.9  # of the limit: the share of it that a step of a group takes
WORTH_OF_GROUP = 0.9  # one group more must bring the operations below this share
RATIOS = (2, 3, 4, 5, 6, 7, 8, 10, 12, 16)
MOST_GROUPS = 4
LARGEST_RATIO = 64

Mask = NDArray[np.bool_]


class Group(NamedTuple):
    """nodes: numbers of blocks; sub_steps: steps of the next faster group in one of this (1 for the fastest);
    limit [s]: the longest stable step of its own block of K.
    """

    nodes: NDArray[np.int64]
    sub_steps: int
    limit: float


@dataclass(frozen=True)
class Regions:
    """groups, fastest first; step [s] of the fastest; operations of a major step over those with one step for all."""

    groups: tuple[Group, ...]
    step: float
    share: float

    @property
    def fastest(self) -> list[int]:
        """Steps of the fastest group in one of each group."""
        return [int(times) for times in np.cumprod([group.sub_steps for group in self.groups])]

    @property
    def steps(self) -> list[float]:
        """The step [s] of each group."""
        return [self.step * times for times in self.fastest]

    def with_step(self, step: float) -> Regions:
        """The same groups with another step of the fastest."""
        return Regions(self.groups, step, self.share)


def node_graph(structure: LinearStructure) -> sp.csr_matrix:
    """Which nodes have an entry of K (or D) in common; ones, with the diagonal."""
    blocks = sp.bsr_matrix(structure.stiffness, blocksize=(structure.width, structure.width))
    graph = sp.csr_matrix(
        (np.ones(len(blocks.indices)), blocks.indices, blocks.indptr), shape=(blocks.shape[0] // structure.width,) * 2
    )
    graph = graph + sp.identity(graph.shape[0], format="csr")
    if structure.damping is not None:
        damper = sp.bsr_matrix(structure.damping, blocksize=(structure.width, structure.width))
        graph = graph + sp.csr_matrix((np.ones(len(damper.indices)), damper.indices, damper.indptr), shape=graph.shape)
    graph.data[:] = 1.0
    return sp.csr_matrix(graph)


def grown(graph: sp.csr_matrix, nodes: Mask, rings: int) -> Mask:
    """The nodes with so many rings of neighbours."""
    for _ in range(rings):
        nodes = (graph @ nodes.astype(float)) > 0
    return nodes


def stiffness_damping(structure: LinearStructure) -> float:
    """b [s] with D <= b K on the fastest motion, from rows: what shortens the step as D does."""
    if structure.damping is None:
        return 0.0
    rows = np.asarray(abs(structure.damping).sum(axis=1)).ravel()
    stiff = np.asarray(abs(structure.stiffness).sum(axis=1)).ravel()
    with np.errstate(divide="ignore", invalid="ignore"):
        return float(np.nan_to_num((rows / stiff)[rows > 0], posinf=0.0).max(initial=0.0))


def region_limit(structure: LinearStructure, nodes: NDArray[np.int64] | None = None) -> float:
    """The longest stable step [s] of some nodes, the others at rest; of all by default."""
    K, mass = structure.stiffness, structure.mass
    if nodes is not None:
        rows = coordinates_of(nodes, structure.width)
        K, mass = K[rows][:, rows], mass[rows]
    return damped_limit(largest_frequency(K, mass), stiffness_damping(structure), structure.mass_damping)


def coordinates_of(nodes: NDArray[np.int64], width: int) -> NDArray[np.int64]:
    """The coordinates of nodes, node by node."""
    return (np.asarray(nodes)[:, None] * width + np.arange(width)).ravel()


def one_group(structure: LinearStructure, step: float | None = None) -> Regions:
    """One step for all nodes: SAFETY of the limit by default. Raises StructureError for a step beyond the limit."""
    nodes = np.arange(structure.size // structure.width)
    limit = region_limit(structure)
    checked_step(step, limit, "dt")
    return Regions((Group(nodes, 1, limit),), step or SAFETY * limit, 1.0)


def checked_step(step: float | None, limit: float, item: str) -> None:
    """Raises StructureError for a step that is not a positive number, or beyond a limit."""
    if step is None:
        return
    if not (np.isfinite(step) and step > 0):
        raise StructureError(item, f"{step!r} s", "give a positive step")
    if step > limit:
        raise StructureError(
            item,
            f"{step:.4g} s is beyond the limit of {limit:.4g} s",
            f"give at most {SAFETY * limit:.4g} s, or leave it out",
        )


def choose_regions(
    structure: LinearStructure, ratios: Sequence[int] | None = None, rings: int = RINGS_OF_REGION
) -> Regions:
    """Groups by the limits of rows: the cheapest by operations; ratios: sub-steps of each next slower group, if
    given.

    The step of the fastest group is SAFETY of its limit; each slower group's must be within SAFETY of its own.
    """
    limits = row_limits(structure.stiffness, structure.mass).reshape(-1, structure.width).min(axis=1)
    graph = node_graph(structure)
    entries = np.diff(graph.indptr)
    least = SAFETY * region_limit(structure)
    scale = least / (SAFETY * limits.min())  # rows bound from below: compare them by what they say of the shortest
    best = one_group(structure, least)
    for count in range(2, MOST_GROUPS + 1):
        offers = sorted(
            _offers(limits * scale, graph, entries, least, count, ratios, rings), key=lambda offer: offer.share
        )
        taken = next((found for offer in offers[:8] if (found := _within_limits(structure, offer)) is not None), None)
        if taken is None or (taken.share > WORTH_OF_GROUP * best.share and ratios is None):
            if count > 2 or ratios is not None:
                break
            continue
        best = taken
    return best


def _offers(
    limits: Array,
    graph: sp.csr_matrix,
    entries: NDArray[np.int32],
    step: float,
    count: int,
    ratios: Sequence[int] | None,
    rings: int,
) -> Iterator[Regions]:
    """Regions of so many groups, for products of whole ratios; limits of groups not yet looked at."""
    if ratios is not None and len(ratios) != count - 1:
        return
    for chosen in [tuple(ratios)] if ratios is not None else itertools.product(RATIOS, repeat=count - 1):
        if np.prod(chosen) > LARGEST_RATIO or step * np.prod(chosen) > SAFETY * limits.max():
            continue
        found = _grouped(limits, graph, chosen, step, rings)
        if found is None:
            continue
        times = np.cumprod([1, *chosen])
        share = sum(entries[nodes].sum() / n for nodes, n in zip(found, times, strict=True)) / entries.sum()
        groups = [Group(nodes, m, np.inf) for nodes, m in zip(found, (1, *chosen), strict=True)]
        yield Regions(tuple(groups), step, float(share))


def _grouped(
    limits: Array, graph: sp.csr_matrix, ratios: tuple[int, ...], step: float, rings: int
) -> list[NDArray[np.int64]] | None:
    """Nodes of each group, fastest first; None where one has none."""
    found, taken = [], np.zeros(len(limits), dtype=bool)
    for times in np.cumprod(ratios):
        too_long = limits * SAFETY < step * times
        own = grown(graph, too_long | taken, rings) & ~taken if too_long.any() or taken.any() else too_long
        found.append(np.flatnonzero(own))
        taken |= own
    found.append(np.flatnonzero(~taken))
    return found if all(len(nodes) for nodes in found) else None


def _within_limits(structure: LinearStructure, offer: Regions) -> Regions | None:
    """The offer with the limit of each group by Lanczos; None where a step is beyond SAFETY of one (by 1 %:
    Lanczos).
    """
    groups = []
    for group, step in zip(offer.groups, offer.steps, strict=True):
        limit = region_limit(structure, group.nodes)
        if step > 1.01 * SAFETY * limit:
            return None
        groups.append(group._replace(limit=limit))
    return Regions(tuple(groups), offer.step, offer.share)


def named_regions(
    structure: LinearStructure, nodes: Sequence[NDArray[np.int64]], ratios: Sequence[int], rings: int = RINGS_OF_REGION
) -> Regions:
    """Groups as somebody names them, fastest first (the last gets all other nodes), with rings around each.

    Raises StructureError for a group without nodes, and for a step beyond a group's limit, with the limit.
    """
    if len(ratios) != len(nodes) - 1:
        raise StructureError("m", f"{len(ratios)} ratios for {len(nodes)} groups", "give one for each but the fastest")
    graph, taken, found = node_graph(structure), np.zeros(structure.size // structure.width, dtype=bool), []
    for own in nodes[:-1]:
        mask = taken.copy()
        mask[np.asarray(own, dtype=int)] = True
        ring = grown(graph, mask, rings) & ~taken
        found.append(np.flatnonzero(ring))
        taken |= ring
    found.append(np.flatnonzero(~taken))
    if empty := [k for k, own in enumerate(found) if not len(own)]:
        raise StructureError("groups", f"group {empty[0]} (fastest is 0) has no node", "leave it out")
    groups = tuple(Group(own, int(m), region_limit(structure, own)) for own, m in zip(found, (1, *ratios), strict=True))
    times = np.cumprod([group.sub_steps for group in groups])
    whole = region_limit(structure)
    step = SAFETY * min(whole, *(group.limit / n for group, n in zip(groups, times, strict=True)))
    entries = np.diff(graph.indptr)
    share = sum(entries[group.nodes].sum() / n for group, n in zip(groups, times, strict=True)) / entries.sum()
    return Regions(groups, float(step), float(share))
