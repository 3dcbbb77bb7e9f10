"""Which elements carry which stress: geometric stiffness of solids and of frames for given displacements."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from symgen.fe.material import Material
from symgen.fe.structure import AXES, Integers, StressStiffness
from symgen.modes.cleaning import Array


def solid_stress(basis: Any, material: Material) -> StressStiffness:
    """Of a solid with this scalar basis, rows x, y, z of node after node.

    sigma = lame tr(eps) + 2 G eps at the points of the quadrature.
    """

    def gradients(vector: Array) -> Array:
        """(component, direction, points)."""
        parts = [np.asarray(basis.interpolate(np.ascontiguousarray(vector[c::AXES])).grad) for c in range(AXES)]
        return np.stack(parts).reshape(AXES, AXES, -1)

    def stiffness(displacements: Array, shapes: Array) -> Array:
        weights = np.asarray(basis.dx).ravel()
        modes = np.stack([gradients(shape) for shape in shapes.T]) if shapes.size else np.zeros((0, 3, 3, len(weights)))
        flat = modes.reshape(len(modes), -1)
        found = np.zeros((displacements.shape[1], len(modes), len(modes)))
        for k, displacement in enumerate(displacements.T):
            strain = gradients(displacement)
            stress = material.G * (strain + strain.transpose(1, 0, 2))
            stress[range(AXES), range(AXES)] += material.lame * np.einsum("iip->p", strain)
            found[k] = flat @ np.einsum("ijp,acjp->acip", stress * weights, modes).reshape(len(modes), -1).T
        return found

    return stiffness


def frame_stress(
    dofs: Integers, turns: Sequence[Array], lengths: Array, stretching: Array, polar: Array
) -> StressStiffness:
    """Of beams by their axial forces: rows dofs (m, 12), axes (12 x 12 each), lengths [m], E A [N], I_p / A [m^2].

    N int (v'^2 + w'^2 + (I_p / A) twist'^2) dx; shear forces and moments of the stress state are left out.
    """

    def stiffness(displacements: Array, shapes: Array) -> Array:
        nf = shapes.shape[1]
        found = np.zeros((displacements.shape[1], nf, nf))
        for rows, turn, length, tension, square in zip(dofs, turns, lengths, stretching, polar, strict=True):
            moved, local = turn @ displacements[rows], turn @ shapes[rows]
            force = tension / length * (moved[6] - moved[0])
            found += force[:, None, None] * (local.T @ _unit_tension(float(length), float(square)) @ local)
        return found

    return stiffness


def _unit_tension(length: float, square: float) -> Array:
    """Geometric stiffness (12, 12) of a cubic element under N = 1, in its own axes."""
    h, result = length, np.zeros((12, 12))
    bending = np.array(
        [
            [36.0, 3.0 * h, -36.0, 3.0 * h],
            [3.0 * h, 4.0 * h * h, -3.0 * h, -h * h],
            [-36.0, -3.0 * h, 36.0, -3.0 * h],
            [3.0 * h, -h * h, -3.0 * h, 4.0 * h * h],
        ]
    ) / (30.0 * h)
    for rows, sign in (([1, 5, 7, 11], 1.0), ([2, 4, 8, 10], -1.0)):
        signs = np.array([1.0, sign, 1.0, sign])
        result[np.ix_(rows, rows)] += np.outer(signs, signs) * bending
    result[np.ix_([3, 9], [3, 9])] += square / h * np.array([[1.0, -1.0], [-1.0, 1.0]])
    return result
