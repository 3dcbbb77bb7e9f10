"""Stresses of solids for given displacements, and their geometric stiffness."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from symgen.fe.errors import FiniteElementError
from symgen.fe.material import Material
from symgen.fe.structure import AXES, FEStructure, Integers
from symgen.modes.cleaning import Array, fixed

VOIGT = ((0, 0), (1, 1), (2, 2), (1, 2), (0, 2), (0, 1))
NEIGHBOURS = 27
FLAT = 1e-3  # points around that do not spread in a direction say nothing of it


@dataclass(frozen=True, eq=False)
class SolidStress:
    """Stresses of a solid with this scalar basis, rows x, y, z of node after node: sigma = lame tr(eps) + 2 G eps.

    They are taken at the points of the quadrature, inside the elements, where they are most exact.
    """

    basis: Any
    material: Material

    @cached_property
    def points(self) -> Array:
        """(points, 3) [m]."""
        return np.asarray(self.basis.global_coordinates()).reshape(AXES, -1).T

    def tensors(self, vectors: Array) -> Array:
        """(k, 3, 3, points) stress [Pa] of displacements (n_dof, k) [m]."""
        found = np.stack([self._gradients(vector) for vector in vectors.T]) if vectors.size else self._none()
        stress = self.material.G * (found + found.transpose(0, 2, 1, 3))
        stress[:, range(AXES), range(AXES)] += self.material.lame * np.einsum("kiip->kp", found)[:, None]
        return np.asarray(stress)

    def __call__(self, displacements: Array, shapes: Array) -> Array:
        """Geometric stiffness (k, nf, nf) of shapes (n_dof, nf) under the stresses of displacements (n_dof, k)."""
        weights = np.asarray(self.basis.dx).ravel()
        modes = np.stack([self._gradients(shape) for shape in shapes.T]) if shapes.size else self._none()
        flat, found = modes.reshape(len(modes), -1), np.zeros((displacements.shape[1], len(modes), len(modes)))
        for k in range(displacements.shape[1]):
            stress = self.tensors(displacements[:, k : k + 1])[0] * weights
            found[k] = flat @ np.einsum("ijp,acjp->acip", stress, modes).reshape(len(modes), -1).T
        return found

    def _gradients(self, vector: Array) -> Array:
        """(component, direction, points)."""
        parts = [np.asarray(self.basis.interpolate(np.ascontiguousarray(vector[c::AXES])).grad) for c in range(AXES)]
        return np.stack(parts).reshape(AXES, AXES, -1)

    def _none(self) -> Array:
        return np.zeros((0, AXES, AXES, len(self.points)))


@dataclass(frozen=True, eq=False)
class ModalStresses:
    """Stresses of a body per unit of q_f: tensors (nf, 3, 3, n) [Pa/m] at points (n, 3) [m] from its frame's origin."""

    points: Array
    tensors: Array

    def of(self, q_f: ArrayLike) -> Array:
        """(N, 3, 3, n) stress tensors [Pa] for modal coordinates (N, nf): the sum of the modal stresses."""
        return np.asarray(np.tensordot(np.atleast_2d(np.asarray(q_f, dtype=float)), self.tensors, axes=1))

    def at(self, places: ArrayLike) -> Array:
        """(m, 6, nf) stresses xx yy zz yz xz xy [Pa/m] at places (m, 3) [m], also on the surface, as float32.

        From the points around, by the linear field that fits them best: exact where the stress is linear.
        """
        near, weights = linear_fit(self.points, np.asarray(places, dtype=float))
        parts = [self.tensors[:, i, j] for i, j in VOIGT]
        return np.stack([np.einsum("amk,mk->ma", part[:, near], weights) for part in parts], axis=1, dtype=np.float32)

    def von_mises(self, q_f: ArrayLike) -> Array:
        """(N, n) von Mises stress [Pa] for modal coordinates (N, nf)."""
        rows = np.atleast_2d(np.asarray(q_f, dtype=float))
        return np.array([von_mises(self.of(row)[0]) for row in rows])  # one at a time: tensors of all points are large


def von_mises(tensors: Array) -> Array:
    """(n,) von Mises stress of stress tensors (3, 3, n) [Pa]."""
    deviator = tensors - np.eye(AXES)[:, :, None] * np.einsum("iip->p", tensors) / AXES
    return np.asarray(np.sqrt(1.5 * np.einsum("ijp,ijp->p", deviator, deviator)))


def linear_fit(points: Array, places: Array) -> tuple[Integers, Array]:
    """Places of points around and their weights (m, k each): a linear field's values at places (m, 3) [m]."""
    from scipy.spatial import KDTree  # when it is needed: importing it takes long

    _, near = KDTree(points).query(places, k=min(NEIGHBOURS, len(points)))
    apart = points[near] - places[:, None]
    size = np.linalg.norm(apart, axis=2).max(axis=1)[:, None]
    fit = np.concatenate([np.ones((*near.shape, 1)), apart / size[..., None]], axis=2)
    return near, np.linalg.pinv(fit, rcond=FLAT)[:, 0]


def modal_stresses(body: FEStructure, shapes: Array, origin: Array) -> ModalStresses:
    """Of shapes (n_dof, nf) about `origin` (3,) [m]; errors as of `solid_stress`."""
    stress = solid_stress(body)
    return ModalStresses(fixed(stress.points - origin), fixed(stress.tensors(shapes)))


def solid_stress(body: FEStructure) -> SolidStress:
    """The stresses of a body. Raises FiniteElementError for one that is not made from a solid mesh."""
    if isinstance(body.stress, SolidStress):
        return body.stress
    remedy = "make it with from_mesh from tetrahedra or hexahedra"
    raise FiniteElementError("stresses", "the body is not made from a solid mesh", remedy)
