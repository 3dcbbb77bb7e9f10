"""A finite-element model as numbers: stiffness, mass, nodes, and which row is which motion of which node.

The one error that finite-element data can raise.

An isotropic linear elastic material.

Interfaces: named sets of nodes as markers, averaged or held as one rigid piece.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np
import scipy.sparse as sp
from numpy.typing import NDArray

from runtime.contract.arguments import Kind
from runtime.contract.errors import SymgenError, shown_value
from symgen.modes.cleaning import Array

NodeSet = Sequence[int] | Callable[[Array], NDArray[np.bool_]]

FLAT_NODES = 1e-8  # relative size of the smallest moment of the nodes below which they lie on a line


def _are_nodes(value: Any) -> bool:
    listed = isinstance(value, Iterable) and not isinstance(value, str | bytes | Mapping)
    return listed and getattr(value, "ndim", 1) == 1 and all(isinstance(one, int | np.integer) for one in value)


NODES = Kind(_are_nodes, "give ids of nodes, or a function of their positions")


@dataclass(frozen=True, eq=False)
class Interface:
    """A set of nodes that one marker stands for.

    places (k,): where the nodes are in the table.  position (3,) [m]: of the marker.
    average (6, n_dof), sparse: displacement of the marker with the set, and the set's rotation, from the rows of u;
    its transpose spreads a force and a torque at the marker over the nodes.
    """

    name: str
    places: Integers
    position: Array
    average: sp.csr_matrix

    def rows(self, body: FEStructure) -> Integers:
        """All rows of the nodes, ascending."""
        rows = body.rows[self.places]
        return np.sort(rows[rows >= 0])


def interface(body: FEStructure, name: str, nodes: NodeSet, position: Array | None = None) -> Interface:
    """The interface of these nodes: ids, or a function of all positions (n, 3) [m] that says which, (n,) of bool.

    position (3,) [m]: of the marker, which moves with the average; the mean position of the nodes unless given.
    All nodes weigh the same, whatever their mass or area.

    One node with rotations: its own six motions. Else u = mean u_k, and the rotation is the omega for which
    sum |u_k - u - omega x s_k|^2 is least, s_k from the mean position; nodes on one line take the mean of
    their own rotations. Raises FiniteElementError for unknown nodes, and where no rotation can be told.
    """
    item = f"interface '{name}'"
    places = body.places(item, body.ids[np.asarray(nodes(body.positions), dtype=bool)] if callable(nodes) else nodes)
    rows = body.rows[places]
    if np.any(rows[:, :AXES] < 0):
        raise FiniteElementError(item, "a node of it has no translations", "choose nodes with x, y and z")
    middle = body.positions[places].mean(axis=0)
    arms = body.positions[places] - middle
    moment = np.sum(arms**2) * np.eye(AXES) - arms.T @ arms
    average = np.zeros((RIGID_MOTIONS, body.n_dof))
    for axis in range(AXES):
        average[axis, rows[:, axis]] = 1.0 / len(places)
    if np.linalg.eigvalsh(moment)[0] > FLAT_NODES * max(np.trace(moment), np.finfo(float).tiny):
        inverse = np.linalg.inv(moment)
        for place_rows, arm in zip(rows, arms, strict=True):
            average[AXES:, place_rows[:AXES]] += inverse @ _cross(arm)
    elif np.all(rows >= 0):
        for axis in range(AXES, RIGID_MOTIONS):
            average[axis, rows[:, axis]] = 1.0 / len(places)
    else:
        raise FiniteElementError(
            item,
            "its nodes lie on one line and have no rotations, so the rotation about that line is undefined",
            "take three or more nodes that are not on a line",
        )
    if position is None:
        return Interface(name, places, middle, sp.csr_matrix(average))
    average[:AXES] -= _cross(position - middle) @ average[AXES:]  # omega x offset = -offset x omega
    return Interface(name, places, position, sp.csr_matrix(average))


def spider(body: FEStructure, at: Interface) -> Array:
    """Motion of the interface as one rigid piece: (rows of the interface, 6), about its position."""
    return body.rigid(at.position)[at.rows(body)]


def check_apart(body: FEStructure, interfaces: list[Interface]) -> None:
    """Raises FiniteElementError if a node belongs to two interfaces: as rigid pieces they would be one."""
    owner: dict[int, str] = {}
    for one in interfaces:
        for place in one.places:
            other = owner.setdefault(int(place), one.name)
            if other != one.name:
                raise FiniteElementError(
                    f"interface '{one.name}'",
                    f"node {body.ids[place]} is also of '{other}'",
                    "interfaces that are held must not share nodes",
                )


def _cross(arm: Array) -> Array:
    """Matrix of arm x."""
    x, y, z = arm
    return np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])


class FiniteElementError(SymgenError, ValueError):
    """Something in finite-element data is wrong; says where, what, and what to do.

    Args:
        item: what is wrong, such as ``stiffness`` or ``interface 'pin'``.
        problem: what is wrong with it.
        remedy: what to do about it.
    """


class FiniteElementWarning(UserWarning):
    """Something in finite-element data can be used, but may not be what was meant."""


Integers = NDArray[np.int64]
Flags = NDArray[np.bool_]
# displacements (n_dof, k) of k stress states and shapes (n_dof, nf) -> geometric stiffness (k, nf, nf)
StressStiffness = Callable[[Array, Array], Array]

AXES = 3
RIGID_MOTIONS = 6
SYMMETRY_TOLERANCE = 1e-6  # matrices written with 7 digits pass; a triangle or a permuted matrix does not


@dataclass(frozen=True, eq=False)
class FEStructure:
    """An unsupported structure: K u = f - M u'' in n_dof rows.

    K [N/m], M [kg]: sparse (n_dof, n_dof), symmetric.  ids (n,): names of the nodes.  positions (n, 3) [m].
    node (n_dof,): place of the row's node in `ids`.  component (n_dof,): 0, 1, 2 for the translations and
    3, 4, 5 for the rotations about x, y, z.  facets (m, 3): triangles of places of nodes, for pictures.
    stress: geometric stiffness, where the elements are known.  Build it with `structure`, which checks.
    """

    K: sp.csr_matrix
    M: sp.csr_matrix
    ids: Integers
    positions: Array
    node: Integers
    component: Integers
    facets: Integers = field(default_factory=lambda: np.zeros((0, AXES), dtype=np.int64))
    stress: StressStiffness | None = None

    @property
    def n_dof(self) -> int:
        """Number of rows."""
        return len(self.node)

    @cached_property
    def rows(self) -> Integers:
        """Row of each node's six components, (n, 6); -1 where the node has no such freedom."""
        table = np.full((len(self.ids), RIGID_MOTIONS), -1, dtype=np.int64)
        table[self.node, self.component] = np.arange(self.n_dof)
        return table

    def rigid(self, origin: Array) -> Array:
        """The six rigid motions, (n_dof, 6): unit translations, then unit rotations about `origin` (3,)."""
        arms = (self.positions - origin)[self.node]
        motions = np.zeros((self.n_dof, RIGID_MOTIONS))
        for row_component in range(AXES):
            here = self.component == row_component
            motions[here, row_component] = 1.0
            one, two = (row_component + 1) % AXES, (row_component + 2) % AXES
            # (omega x arm)_i = omega_j arm_k - omega_k arm_j for (i, j, k) in cyclic order
            motions[here, AXES + one] = arms[here, two]
            motions[here, AXES + two] = -arms[here, one]
            motions[self.component == AXES + row_component, AXES + row_component] = 1.0
        return motions

    def nodal(self, vectors: Array, first: int) -> Array:
        """Components first, first + 1, first + 2 of `vectors` (n_dof, k) at the nodes, (n, 3, k); 0 where absent."""
        rows = self.rows[:, first : first + AXES]
        return np.where((rows >= 0)[:, :, None], vectors[rows], 0.0)

    def places(self, item: str, ids: Iterable[int]) -> Integers:
        """Places of nodes in the table. Raises FiniteElementError for unknown or repeated ids, or for none."""
        if not NODES.holds(ids):
            raise FiniteElementError(item, f"{shown_value(ids)} is not a list of nodes", NODES.wanted)
        wanted = np.asarray(list(ids), dtype=np.int64)
        place = {int(name): k for k, name in enumerate(self.ids)}
        unknown = [int(name) for name in wanted if int(name) not in place]
        if unknown:
            raise FiniteElementError(
                item,
                f"nodes {unknown[:5]} are not in the node table",
                f"the table has ids from {min(place)} to {max(place)}",
            )
        if len(wanted) == 0 or len(np.unique(wanted)) < len(wanted):
            raise FiniteElementError(
                item, "the list of nodes is empty or names a node twice", "name each node of the interface once"
            )
        return np.array([place[int(name)] for name in wanted], dtype=np.int64)


def structure(
    K: sp.spmatrix, M: sp.spmatrix, ids: Integers, positions: Array, node: Integers, component: Integers
) -> FEStructure:
    """A checked FEStructure; arguments as its fields.

    Raises FiniteElementError for wrong sizes, NaN, unsymmetric matrices, doubled rows of the dof map,
    rows without stiffness and mass, and negative diagonals.
    """
    n = len(node)
    if np.shape(positions) != (len(ids), AXES) or not np.all(np.isfinite(positions)):
        raise FiniteElementError(
            "nodes",
            f"the table has shape {np.shape(positions)} or entries that are not finite",
            "give x, y, z of every node",
        )
    if len(np.unique(ids)) < len(ids):
        raise FiniteElementError("nodes", "an id appears twice in the table", "give each node one row")
    if len(np.unique(np.stack([node, component]), axis=1).T) < n:
        raise FiniteElementError("dofs", "a motion of a node appears twice in the dof map", "give each one row")
    stiffness, mass = _checked("stiffness", K, n), _checked("mass", M, n)
    empty = np.flatnonzero((stiffness.diagonal() == 0.0) & (mass.diagonal() == 0.0))
    if empty.size:
        row = int(empty[0])
        raise FiniteElementError(
            "stiffness",
            f"{empty.size} rows have neither stiffness nor mass, the first is component "
            f"{component[row] + 1} of node {ids[node[row]]}",
            "leave these rows out of the matrices and of the dof map",
        )
    return FEStructure(
        stiffness,
        mass,
        np.asarray(ids, dtype=np.int64),
        np.asarray(positions, dtype=np.float64),
        np.asarray(node, dtype=np.int64),
        np.asarray(component, dtype=np.int64),
    )


def _checked(item: str, matrix: sp.spmatrix, n: int) -> sp.csr_matrix:
    """The matrix as csr, exactly symmetric, or FiniteElementError."""
    if matrix.shape != (n, n):
        raise FiniteElementError(
            item,
            f"the matrix is {matrix.shape[0]} x {matrix.shape[1]}, the nodes have {n} dofs",
            "check the number of dofs per node, or give a dof map with one row (node, component) "
            "for each row of the matrix",
        )
    values = sp.csr_matrix(matrix, dtype=np.float64)
    values.sum_duplicates()
    if not np.all(np.isfinite(values.data)):
        raise FiniteElementError(item, "an entry is not a finite number", "export the matrix again")
    size = float(np.max(np.abs(values.data), initial=0.0))
    lacking = float(np.max(np.abs((values - values.T).data), initial=0.0))
    if lacking > SYMMETRY_TOLERANCE * size:
        raise FiniteElementError(
            item,
            f"the matrix is not symmetric (by {lacking:.3g}, largest entry {size:.3g})",
            "a file with one triangle must say 'symmetric' in its header",
        )
    if values.diagonal().min(initial=0.0) < 0.0:
        raise FiniteElementError(
            item,
            f"row {int(values.diagonal().argmin()) + 1} has a negative diagonal",
            "check the units and the export; a matrix of inertia or stiffness has none",
        )
    return sp.csr_matrix(0.5 * (values + values.T))


@dataclass(frozen=True)
class Material:
    """Young's modulus E [Pa], Poisson's ratio nu, density rho [kg/m^3].

    Raises FiniteElementError for values that no material has.
    """

    E: float
    nu: float
    rho: float

    def __post_init__(self) -> None:
        for name in ("E", "rho"):
            value = getattr(self, name)
            if not (math.isfinite(value) and value > 0.0):
                raise FiniteElementError(f"material.{name}", f"{value!r} is not a positive number", "use SI units")
        if not -1.0 < self.nu < 0.5:
            raise FiniteElementError("material.nu", f"{self.nu!r} is not between -1 and 0.5", "steel has 0.3")

    @property
    def G(self) -> float:
        """Shear modulus [Pa]."""
        return self.E / (2.0 * (1.0 + self.nu))

    @property
    def lame(self) -> float:
        """Lame's first constant [Pa]."""
        return self.E * self.nu / ((1.0 + self.nu) * (1.0 - 2.0 * self.nu))


STEEL = Material(E=2.1e11, nu=0.3, rho=7850.0)
