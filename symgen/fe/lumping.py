"""A consistent mass matrix as masses at the nodes."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import scipy.sparse as sp

from symgen.fe.errors import FiniteElementError
from symgen.fe.inertia import nodal_inertia, scalar_mass
from symgen.fe.structure import AXES, FEStructure


def lumped(body: FEStructure) -> FEStructure:
    """The same structure with its mass at the nodes; total mass and, for straight-sided elements, its centre stay.

    The rows of M are summed. Quadratic elements whose row sums are not positive (tetrahedra) take their diagonal
    instead, scaled to the mass; that is right for meshes of one element type. Nodes with rotations keep the
    rotary inertia that their rows sum up to; what M says of masses away from their node is dropped.
    Raises FiniteElementError for other sums that are not positive.
    """
    scalar = scalar_mass(body)
    mass, _, inertia = nodal_inertia(body)
    if scalar is not None and mass.min() <= 0.0:
        mass = scalar.diagonal() * scalar.sum() / scalar.diagonal().sum()
    if mass.min() < 0.0:
        raise FiniteElementError(
            "mass", f"lumping gives node {body.ids[mass.argmin()]} a negative mass", "take mass='consistent'"
        )
    diagonal = np.where(body.component < AXES, mass[body.node], 0.0)
    blocks = sp.lil_matrix(sp.diags(diagonal))
    turning = body.rows[:, AXES:]
    for i in range(AXES):
        for j in range(AXES):
            both = (turning[:, i] >= 0) & (turning[:, j] >= 0) & (inertia[:, i, j] != 0.0)
            blocks[turning[both, i], turning[both, j]] = inertia[both, i, j]
    return replace(body, M=sp.csr_matrix(blocks))
