"""Does a step by regions grow? Eigenvalues of the major step A without its matrix, by Arnoldi's method on powers of
A.

All eigenvalues of a stable undamped step lie on the unit circle, so that Arnoldi never converges on A itself; on
A^100 and on A^1000 what grows stands out. Windows of growth between a fast region and its neighbours are local: the
second look takes the fast nodes and eight rings of neighbours alone.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
import scipy.sparse.linalg as spl

from runtime.structures.central_difference import CentralDifference
from runtime.structures.regions import Group, Regions, coordinates_of, grown, node_graph
from runtime.structures.structure import Array, LinearStructure

POWER_ITERATIONS = (100, 1000)  # of the whole, and of the neighbourhood of what is fast
NEIGHBOURHOOD = 8
POWER_VECTORS = 20
HUGE = 1e60


@dataclass(frozen=True)
class Growth:
    """What was looked at, and what was found.

    spectral_radius: of the major step, the largest found. below: growth a major step below which nothing was looked
    for. limits [s] of each group's own step, fastest first; steps [s] taken.
    """

    spectral_radius: float
    below: float
    limits: tuple[float, ...]
    steps: tuple[float, ...]

    @property
    def stable(self) -> bool:
        """Was no growth found above `below`?"""
        return self.spectral_radius <= 1 + self.below

    def __str__(self) -> str:
        share = max(step / limit for step, limit in zip(self.steps, self.limits, strict=True))
        found = f"grows by {self.spectral_radius - 1:.2g} a major step" if not self.stable else "no growth found"
        looked = f"nothing was looked for below {self.below:g} a major step"
        return f"{found} ({looked}); steps are at most {share:.2f} of their limits"


def growth(structure: LinearStructure, regions: Regions) -> Growth:
    """The largest growth of a major step that two looks find: of the whole, then of what is fast with its
    neighbours.
    """
    quiet = replace(structure, loads=(), laws=None, law_texts=(), coordinates=structure.names)
    radius, below = _radius(quiet, regions, POWER_ITERATIONS[0]), 1e-3
    if len(regions.groups) > 1:
        local, groups = _neighbourhood(quiet, regions)
        radius, below = max(radius, _radius(local, groups, POWER_ITERATIONS[1])), 1e-4
    limits = tuple(group.limit for group in regions.groups)
    return Growth(radius, below, limits, tuple(regions.steps))


def _radius(structure: LinearStructure, regions: Regions, power: int) -> float:
    """The spectral radius of the major step from the largest eigenvalue of its power; 1 where none stands out."""
    step = CentralDifference(structure, regions)
    size = len(step.state())
    if size <= 200:
        columns = np.column_stack([_mapped(step, unit, 1) for unit in np.eye(size)])
        return float(np.abs(np.linalg.eigvals(columns)).max())

    def apply(state: Array) -> Array:
        return _mapped(step, state, power)

    operator = spl.LinearOperator((size, size), matvec=apply, dtype=float)
    start = np.random.default_rng(0).standard_normal(size)
    while power > 1 and not np.abs(apply(start)).max() < HUGE:  # what grows fast is seen in fewer steps
        power //= 10
    try:
        found = spl.eigs(operator, k=1, v0=start, ncv=POWER_VECTORS, maxiter=3, tol=1e-2, return_eigenvectors=False)
    except spl.ArpackNoConvergence as error:
        found = error.eigenvalues
    return float(np.abs(found).max(initial=1.0) ** (1 / power))


def _mapped(step: CentralDifference, state: Array, steps: int) -> Array:
    step.set_state(state)
    step.advance(steps)
    return step.state()


def _neighbourhood(structure: LinearStructure, regions: Regions) -> tuple[LinearStructure, Regions]:
    """The groups but the slowest, with rings of the slowest around them; the rest held."""
    count = structure.size // structure.width
    mask = np.zeros(count, dtype=bool)
    for group in regions.groups[:-1]:
        mask[group.nodes] = True
    mask = grown(node_graph(structure), mask, NEIGHBOURHOOD)
    nodes = np.flatnonzero(mask)
    rows = coordinates_of(nodes, structure.width)
    local = replace(
        structure,
        stiffness=structure.stiffness[rows][:, rows],
        mass=np.asarray(structure.mass)[rows],
        damping=None if structure.damping is None else structure.damping[rows][:, rows],
        coordinates=[structure.names[row] for row in rows],
        points=None,
        cells=None,
    )
    place = np.full(count, -1)
    place[nodes] = np.arange(len(nodes))
    groups = tuple(
        Group(place[group.nodes[mask[group.nodes]]], group.sub_steps, group.limit) for group in regions.groups
    )
    return local, replace(regions, groups=groups)
