"""Geometric stiffness of a finite-element body from the stresses of unit loads, reduced to its modes (Eqs. 15-20).

A stress field s gives the energy q^T K_s q / 2 with K_s = int (grad phi_a)^T s (grad phi_b) dV. The stress of a load is
linear in it, so K_s of any motion is a sum over loads: of unit accelerations of the frame, of the fields x_i e_j that
angular velocities and accelerations make, and of unit forces at the interfaces. Each K_s is the work of its load on a
displacement of second order, -q^T H(x) q / 2: the body template takes int H_i dm, int x_i H_j dm and H at markers.
Loads in a motion balance, inertia forces among them, so that the supports of the single solutions drop out of the sum.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import scipy.linalg as la

from symgen.fe.errors import FiniteElementError
from symgen.fe.inertia import dusted
from symgen.fe.interfaces import Interface
from symgen.fe.static import Solve, held_solve
from symgen.fe.structure import AXES, RIGID_MOTIONS, FEStructure
from symgen.modes.cleaning import Array, fixed, symmetric


@dataclass(frozen=True, eq=False)
class StressStiffening:
    """Displacements of second order -q^T H_i q / 2 along axis i, mass-orthonormal shapes [1/m per kg].

    H (3, nf, nf): int H_i dm.  xH (3, 3, nf, nf): [i][j] = int x_i H_j dm.  at: (3, nf, nf) at each interface, by name.
    """

    H: Array
    xH: Array
    at: dict[str, Array]


def stress_stiffening(
    body: FEStructure, shapes: Array, origin: Array, parts: Sequence[Interface], held: Solve | None
) -> StressStiffening:
    """For shapes (n_dof, nf) about `origin` (3,) [m]; held: solver of the held body, None for six plain supports.

    Raises FiniteElementError where the elements that carry the stresses are not known.
    """
    if body.stress is None:
        raise FiniteElementError(
            "stiffening",
            "the stresses of a body from matrices are not known",
            "make it from a mesh (from_mesh), or leave stiffening out",
        )
    loads = [linear_fields(body, origin), *(np.asarray(part.average[:AXES].todense()).T for part in parts)]
    solve = held if held is not None else _supported(body)
    stiffness = symmetric(body.stress(solve(np.hstack(loads)), shapes))
    nf = shapes.shape[1]
    inertial, forces = stiffness[: AXES + AXES**2], stiffness[AXES + AXES**2 :].reshape(len(parts), AXES, nf, nf)
    xH = inertial[AXES:].reshape(AXES, AXES, nf, nf)
    return StressStiffening(
        fixed(_dusted(inertial[:AXES])),
        fixed(_dusted(xH)),
        {part.name: fixed(_dusted(force)) for part, force in zip(parts, forces, strict=True)},
    )


def linear_fields(body: FEStructure, origin: Array) -> Array:
    """M v (n_dof, 12) of the displacement fields v = e_j, then x_i e_j with i slowest, which turn by e_i x e_j / 2."""
    fields = np.zeros((body.n_dof, AXES + AXES**2))
    arms = (body.positions - origin)[body.node]
    for j in range(AXES):
        along = body.component == j
        fields[along, j] = 1.0
        for i in range(AXES):
            column = AXES + AXES * i + j
            fields[along, column] = arms[along, i]
            turn = 0.5 * np.cross(np.eye(AXES)[i], np.eye(AXES)[j])
            for axis in range(AXES):
                fields[body.component == AXES + axis, column] = turn[axis]
    return np.asarray(body.M @ fields)


def _supported(body: FEStructure) -> Solve:
    """Held at six rows that restrain the rigid motions."""
    rigid = body.rigid(body.positions.mean(axis=0))
    support = la.qr((rigid / np.linalg.norm(rigid, axis=0)).T, mode="r", pivoting=True)[1][:RIGID_MOTIONS]
    return held_solve(body.K, support)


def _dusted(values: Array) -> Array:
    return dusted(values, float(np.abs(values).max(initial=0.0)))
