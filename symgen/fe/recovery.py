"""Stress at a place of a solid: the field of the element that holds it, averaged at the nodes.

The points of the quadrature know the stress best, but a place of interest lies on the surface, where none of them is.
Each element continues its own points by the polynomial that its stress has there; what the elements around a node say
of it is averaged, and the shape functions of the element that holds the place lead from its nodes to the place.

Of linear tetrahedra, whose stress is one constant a cell, a plane is fitted to the cells around, weighted to the place.

The same sums tell an error of the mesh: a stress of the true field has no jumps, so that how an averaged field differs
from an element's own is of the size of what its stress lacks (Zienkiewicz and Zhu 1987). Of quadratic hexahedra the
averaged one continues the 2 x 2 x 2 superconvergent points (Barlow 1976): the full polynomials hardly jump, and would
tell a fifth of the error. As the stress itself it would be less exact (Lame's cylinder, a pressed hollow sphere).
"""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import product
from typing import Any

import numpy as np
import scipy.sparse as sp
from numpy.typing import NDArray

from symgen.fe.structure import AXES, FiniteElementError, FiniteElementWarning, Integers
from symgen.modes.cleaning import Array

OUTSIDE = 0.1  # of a cell, in its own coordinates: a place so far outside snaps to the surface
CELL_REACH = 0.5  # of the longest side of a cell's box: cells that may hold a place or lie beside it
PLACE_AT_NODE = 1e-6  # of the size of the body: a place so near to a node is that node
CONVERGED = 1e-10  # of the size of the body
PLACE_NEWTON_STEPS = 25
WEIGHT_DECAY = 2.0  # a plane through the cells around is weighted by exp(-NARROW d^2), d the distance over the farthest
FLAT_CELLS = 1e-3  # cells around that do not spread in a direction say nothing of it
INSIDE_CELL = 1e-9
ONE_SHARE = 1e-4  # how nearly shares add up to 1 where a place is snapped
COARSE = (
    "linear tetrahedra have one stress a cell: at a place it is 10 % wrong and more; take order=2 where stress matters"
)


@dataclass(frozen=True, eq=False)
class RecoveredPlaces:
    """What leads from the stress at the points of the quadrature to that at m places.

    places (m, 3) [m]: snapped to the body.  elements (e,): those whose points enter.  values (m, e points), sparse:
    weights of the points.  differences (m nodes, e points), sparse: averaged minus own stress at the nodes of the
    element that holds the place.
    """

    places: Array
    elements: Integers
    values: sp.csr_matrix
    differences: sp.csr_matrix


@dataclass(frozen=True, eq=False)
class StressRecovery:
    """Of a solid with this scalar basis of scikit-fem, elements P1, P2, Q1 or Q2 on straight or curved cells."""

    basis: Any

    def at(self, places: Array, items: Sequence[str], origin: Array) -> RecoveredPlaces:
        """For places (m, 3) [m] in the axes of the mesh; items (m,): their names, origin (3,) [m]: for messages.

        Raises FiniteElementError for a place outside of the body by more than a tenth of a cell.
        """
        if self.constant:
            warnings.warn(COARSE, FiniteElementWarning, stacklevel=2)
        elements, local, nodes = self._holders(places, items, origin)
        shape = self._shape_functions(local)  # (m, nodes of an element)
        around = np.unique(self.basis.element_dofs[:, elements])
        own_nodes = self.basis.element_dofs[:, elements].T  # (m, nodes)
        m, count = own_nodes.shape
        spread = sp.csr_matrix(
            (shape.ravel(), own_nodes.ravel(), np.arange(0, m * count + 1, count)), shape=(m, self.basis.N)
        )
        values = (
            self._fitted(elements, self._points_at(elements, local))
            if self.constant
            else (spread @ self._nodal_means(around, self.extrapolation))
        )
        recovered = sp.csr_matrix(
            (np.ones(m * count), own_nodes.ravel(), np.arange(m * count + 1)), shape=(m * count, self.basis.N)
        )
        differences = sp.csr_matrix(
            recovered @ self._nodal_means(around, self.smooth_extrapolation) - self._own(elements)
        )
        used = np.unique(np.concatenate([values.indices, differences.indices]) // self.points_each)
        columns = (used[:, None] * self.points_each + np.arange(self.points_each)).ravel()
        snapped = self._points_at(elements, local)
        snapped[nodes >= 0] = self.node_places[nodes[nodes >= 0]]
        return RecoveredPlaces(snapped, used, sp.csr_matrix(values[:, columns]), differences[:, columns])

    @property
    def constant(self) -> bool:
        """Is the stress one constant a cell?"""
        return not self.hexahedra and self.basis.Nbfun == AXES + 1

    @cached_property
    def hexahedra(self) -> bool:
        """Hexahedra, or tetrahedra?"""
        return int(self.basis.mesh.t.shape[0]) == 8

    @property
    def points_each(self) -> int:
        """Points of the quadrature in an element."""
        return int(self.basis.X.shape[1])

    @cached_property
    def node_places(self) -> Array:
        """(nodes, 3) [m]."""
        return np.asarray(self.basis.doflocs.T, dtype=float)

    @cached_property
    def extrapolation(self) -> Array:
        """(nodes, points): stress at the nodes of an element from that at its points."""
        return np.asarray(self._monomials(self.own_nodes, self.degree) @ self._coefficients, dtype=float)

    @cached_property
    def smooth_extrapolation(self) -> Array:
        """(nodes, points): the like for the averaged field of the error."""
        if not (self.hexahedra and self.degree == 2):
            return self.extrapolation
        half = 0.5 / 3**0.5
        inner = np.array(list(product([0.5 - half, 0.5 + half], repeat=AXES))).T
        trilinear = self._monomials(self.own_nodes, 1) @ np.linalg.pinv(self._monomials(inner, 1))
        return np.asarray(trilinear @ self._monomials(inner, self.degree) @ self._coefficients, dtype=float)

    @cached_property
    def degree(self) -> int:
        """Of the polynomial that the stress is in an element."""
        order = 2 if self.basis.Nbfun in (10, 27) else 1
        return order if self.hexahedra else order - 1

    @property
    def own_nodes(self) -> Array:
        """(3, nodes): local coordinates of the nodes of an element."""
        return np.asarray(self.basis.elem.doflocs, dtype=float).T

    @cached_property
    def _coefficients(self) -> Array:
        """(terms, points): the polynomial through the stress at the points."""
        return np.asarray(np.linalg.pinv(self._monomials(np.asarray(self.basis.X), self.degree)), dtype=float)

    def _monomials(self, X: Array, degree: int) -> Array:
        """(n, terms) at local coordinates (3, n): of each direction up to the degree, or of all together."""
        powers = [p for p in product(range(degree + 1), repeat=AXES) if self.hexahedra or sum(p) <= degree]
        return np.stack([X[0] ** i * X[1] ** j * X[2] ** k for i, j, k in powers], axis=1)

    def _shape_functions(self, X: Array) -> Array:
        """(n, nodes) at local coordinates (n, 3)."""
        elem = self.basis.elem
        return np.stack([np.broadcast_to(elem.lbasis(X.T, k)[0], len(X)) for k in range(self.basis.Nbfun)], axis=1)

    def _nodal_means(self, nodes: Integers, extrapolation: Array) -> sp.csr_matrix:
        """(all nodes, all points): the mean of what the elements around say; rows of other nodes are empty."""
        dofs = self.basis.element_dofs
        wanted = np.zeros(self.basis.N, dtype=bool)
        wanted[nodes] = True
        local, element = np.nonzero(wanted[dofs])
        node, each = dofs[local, element], self.points_each
        around = np.bincount(node, minlength=self.basis.N)
        columns = element[:, None] * each + np.arange(each)
        weights = extrapolation[local] / around[node][:, None]
        rows = np.repeat(node, each)
        size = (self.basis.N, dofs.shape[1] * each)
        return sp.csr_matrix((weights.ravel(), (rows, columns.ravel())), shape=size)

    def _own(self, elements: Integers) -> sp.csr_matrix:
        """(m nodes, all points): what the elements themselves say at their nodes."""
        each, count = self.points_each, self.basis.Nbfun
        columns = np.repeat(elements[:, None] * each + np.arange(each), count, axis=0).ravel()
        rows = np.arange(0, len(elements) * count * each + 1, each)
        weights = np.tile(self.extrapolation, (len(elements), 1)).ravel()
        size = (len(elements) * count, self.basis.element_dofs.shape[1] * each)
        return sp.csr_matrix((weights, columns, rows), shape=size)

    def _fitted(self, elements: Integers, places: Array) -> sp.csr_matrix:
        """(m, all points): a plane through the stresses of the cells around, weighted to the place."""
        mesh, each = self.basis.mesh, self.points_each
        cells = sp.csr_matrix(
            (np.ones(mesh.t.size), (mesh.t.ravel(), np.tile(np.arange(mesh.t.shape[1]), len(mesh.t)))),
            shape=(mesh.p.shape[1], mesh.t.shape[1]),
        )
        centres, rows, columns, weights = mesh.p[:, mesh.t].mean(axis=1).T, [], [], []
        for row, (element, place) in enumerate(zip(elements, places, strict=True)):
            around = np.unique(cells[mesh.t[:, element]].indices)
            apart = centres[around] - place
            d = apart / np.maximum(np.abs(apart).max(axis=0), np.finfo(float).tiny)
            near = np.exp(-WEIGHT_DECAY * np.sum(d**2, axis=1))
            middle = d.mean(axis=0)
            terms = np.hstack([np.ones((len(d), 1)), d - middle])
            part = (np.r_[1.0, -middle] @ np.linalg.pinv(terms * near[:, None], rcond=FLAT_CELLS)) * near
            columns.append((around[:, None] * each + np.arange(each)).ravel())
            weights.append(np.repeat(part / each, each))
            rows.append(np.full(len(columns[-1]), row))
        size = (len(places), mesh.t.shape[1] * each)
        if not rows:
            return sp.csr_matrix(size)
        return sp.csr_matrix((np.concatenate(weights), (np.concatenate(rows), np.concatenate(columns))), shape=size)

    # ---- Which element holds a place, and where in it.

    def _holders(self, places: Array, items: Sequence[str], origin: Array) -> tuple[Integers, Array, Integers]:
        """Elements (m,), local coordinates (m, 3), and the node at the place or -1, (m,)."""
        from scipy.spatial import KDTree  # when it is needed: importing it takes long

        size = float(np.ptp(self.node_places, axis=0).max())
        apart, near = KDTree(self.node_places).query(places)
        nodes = np.where(apart <= PLACE_AT_NODE * size, near, -1)
        elements, local = np.zeros(len(places), dtype=np.int64), np.zeros((len(places), AXES))
        first, corner = self._element_of_node
        at = nodes >= 0
        elements[at] = first[nodes[at]]
        local[at] = np.asarray(self.basis.elem.doflocs, dtype=float)[corner[nodes[at]]]
        others = np.flatnonzero(~at)
        for k, found in zip(map(int, others), self._nearest(places[others], size), strict=True):
            if found is None:
                nearest = self.node_places[near[k]] - origin
                raise FiniteElementError(
                    items[k],
                    f"({_point(places[k] - origin)}) m lies outside of the body; its nearest node, "
                    f"{apart[k]:.3g} m away, is at ({_point(nearest)}) m",
                    "give a place on or in the body; a point up to a tenth of a cell outside is moved to the surface",
                )
            elements[k], local[k] = found
        return elements, local, nodes

    @cached_property
    def _element_of_node(self) -> tuple[Integers, Integers]:
        """Of each node an element that has it, and its number there."""
        dofs = self.basis.element_dofs
        elements, corners = np.zeros(self.basis.N, dtype=np.int64), np.zeros(self.basis.N, dtype=np.int64)
        for corner, row in enumerate(dofs):
            elements[row], corners[row] = np.arange(dofs.shape[1]), corner
        return elements, corners

    @cached_property
    def _boxes(self) -> tuple[Array, Array]:
        """Lowest and highest corners (elements, 3) [m] of boxes around the cells, with what may lie beside them."""
        corners = self.node_places[self.basis.element_dofs]  # (nodes, elements, 3)
        low, high = corners.min(axis=0), corners.max(axis=0)
        margin = CELL_REACH * (high - low).max(axis=1, keepdims=True)
        return low - margin, high + margin

    def _nearest(self, places: Array, size: float) -> list[tuple[int, Array] | None]:
        """Of each place (m, 3) the element that holds it, and where in it; None where none is near."""
        low, high = self._boxes
        near = [np.flatnonzero(np.all((low <= place) & (place <= high), axis=1)) for place in places]
        counts = [len(one) for one in near]
        if not sum(counts):
            return [None] * len(places)
        every, every_converged = self._inverse(np.repeat(places, counts, axis=0), np.concatenate(near), size)
        ends = np.cumsum(counts)[:-1]
        parts = zip(places, near, np.split(every, ends), np.split(every_converged, ends), strict=True)
        return [self._best(*part) for part in parts]

    def _best(
        self, place: Array, near: Integers, local: Array, converged: NDArray[np.bool_]
    ) -> tuple[int, Array] | None:
        """Of the elements near a place (3,), with its local coordinates (e, 3) in each, the one that holds it."""
        if not near.size:
            return None
        outside = np.maximum(-local.min(axis=1), local.max(axis=1) - 1.0)
        if not self.hexahedra:
            outside = np.maximum(-local.min(axis=1), local.sum(axis=1) - 1.0)
        outside = np.where(converged, np.maximum(outside, 0.0), np.inf)
        best = int(np.argmin(np.where(outside < INSIDE_CELL, 0.0, outside)))
        if outside[best] > OUTSIDE:
            return None
        inside = (
            local[best] if outside[best] < INSIDE_CELL else self._snapped(place, near[best : best + 1], local[best])
        )
        return int(near[best]), inside

    def _snapped(self, place: Array, element: Integers, local: Array) -> Array:
        """Local coordinates (3,) of the point of the element nearest to a place that is a little outside."""
        from scipy.optimize import lsq_linear, nnls  # when it is needed: importing it takes long

        slope = np.asarray(self.basis.mapping.DF(local[:, None, None], tind=element))[:, :, 0, 0]
        corner = place - slope @ local  # where the origin of the coordinates is, the cell taken as straight
        if self.hexahedra:
            return np.asarray(lsq_linear(slope, place - corner, bounds=(0.0, 1.0), method="bvls").x)
        size = float(np.abs(slope).max())
        corners = np.hstack([np.zeros((AXES, 1)), slope / size])  # the shares of four corners are >= 0, their sum is 1
        system = np.vstack([corners, np.full(4, 1.0 / ONE_SHARE)])
        shares = nnls(system, np.append((place - corner) / size, 1.0 / ONE_SHARE))[0]
        return np.asarray(shares[1:] / shares.sum())

    def _inverse(self, places: Array, elements: Integers, size: float) -> tuple[Array, NDArray[np.bool_]]:
        """Local coordinates (e, 3) of places (e, 3) in elements (e,) by Newton's method, and whether it converged."""
        mapping = self.basis.mapping
        local = np.full((AXES, len(elements), 1), 0.5 if self.hexahedra else 0.25)
        for _ in range(PLACE_NEWTON_STEPS):
            apart = places.T - np.asarray(mapping.F(local, tind=elements))[:, :, 0]
            if np.linalg.norm(apart, axis=0).max() <= CONVERGED * size:
                break
            slopes = np.asarray(mapping.DF(local, tind=elements))[:, :, :, 0].transpose(2, 0, 1)
            step = np.linalg.solve(slopes, apart.T[:, :, None])[:, :, 0].T
            local = np.clip(local + np.clip(step, -0.5, 0.5)[:, :, None], -1.0, 2.0)
        apart = places.T - np.asarray(mapping.F(local, tind=elements))[:, :, 0]
        return local[:, :, 0].T, np.linalg.norm(apart, axis=0) <= 1e3 * CONVERGED * size

    def _points_at(self, elements: Integers, local: Array) -> Array:
        """(m, 3) [m] of local coordinates (m, 3) in elements (m,)."""
        found = np.asarray(self.basis.mapping.F(local.T[:, :, None], tind=elements))
        return np.array(found[:, :, 0].T)


def _point(place: Array) -> str:
    return ", ".join(f"{float(x):.6g}" for x in place)
