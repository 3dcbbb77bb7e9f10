"""The beams of a frame one by one: their matrices, the forces at their ends, and their geometric stiffness."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import scipy.sparse as sp

from symgen.fe.errors import FiniteElementError
from symgen.fe.structure import AXES, FEStructure, Integers
from symgen.modes.cleaning import Array

ROWS = 12  # of a beam: three displacements and three rotations at each end


@dataclass(frozen=True, eq=False)
class FrameElements:
    """m beams: rows dofs (m, 12), axes turns (m, 12, 12), lengths [m], E A [N], I_p / A [m^2] (m,).

    stiffness [N/m], mass [kg]: (m, 12, 12) in the axes of the mesh. Called, it gives the geometric stiffness by the
    axial forces N int (v'^2 + w'^2 + (I_p / A) twist'^2) dx; shear forces and moments of the stress state are left out.
    """

    dofs: Integers
    turns: Array
    lengths: Array
    stretching: Array
    polar: Array
    stiffness: Array
    mass: Array

    @property
    def directions(self) -> Array:
        """(m, 3) unit vectors along the beams."""
        return np.asarray(self.turns[:, 0, :AXES])

    def assembled(self, blocks: Array, size: int) -> sp.csr_matrix:
        """Sum of matrices (m, 12, 12) of the beams at their rows."""
        rows = np.repeat(self.dofs, ROWS, axis=1).ravel()
        columns = np.tile(self.dofs, (1, ROWS)).ravel()
        return sp.csr_matrix((blocks.ravel(), (rows, columns)), shape=(size, size))

    def ends(self, displacements: Array, accelerations: Array) -> Array:
        """(k, m, 2, 6) forces and moments in each beam at both ends, in its axes: of what is beyond on what is before.

        displacements (n_dof, k); accelerations (m, 12, k) of the beams, M a + K u = forces at the ends: exact where a
        cubic holds the acceleration along a beam.
        """
        forces = np.einsum("eab,ebk->eak", self.stiffness, displacements[self.dofs])
        forces += np.einsum("eab,ebk->eak", self.mass, accelerations)
        found = np.einsum("eab,ebk->kea", self.turns, forces).reshape(-1, len(self.dofs), 2, 6)
        found[:, :, 0] *= -1.0  # at its start the part before acts on the beam
        return np.asarray(found)

    def __call__(self, displacements: Array, shapes: Array) -> Array:
        """Geometric stiffness (k, nf, nf) of shapes (n_dof, nf) under the axial forces of displacements (n_dof, k)."""
        nf = shapes.shape[1]
        found = np.zeros((displacements.shape[1], nf, nf))
        several = zip(self.dofs, self.turns, self.lengths, self.stretching, self.polar, strict=True)
        for rows, turn, length, tension, square in several:
            moved, local = turn @ displacements[rows], turn @ shapes[rows]
            force = tension / length * (moved[6] - moved[0])
            found += force[:, None, None] * (local.T @ _unit_tension(float(length), float(square)) @ local)
        return found


def frame_elements(body: FEStructure) -> FrameElements:
    """The beams of a body. Raises FiniteElementError for one that is not made from a LineMesh."""
    if isinstance(body.stress, FrameElements):
        return body.stress
    raise FiniteElementError("section forces", "the body is not a frame", "make it with from_mesh from a LineMesh")


def _unit_tension(length: float, square: float) -> Array:
    """Geometric stiffness (12, 12) of a cubic element under N = 1, in its own axes."""
    h, result = length, np.zeros((ROWS, ROWS))
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
