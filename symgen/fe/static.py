"""Static solutions of a structure: held at interfaces, or free and loaded by self-balanced forces."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import scipy.linalg as la
import scipy.sparse as sp
import scipy.sparse.linalg as spla

from symgen.fe.errors import FiniteElementError
from symgen.fe.structure import RIGID_MOTIONS, Integers
from symgen.modes.cleaning import Array

Solve = Callable[[Array], Array]  # forces (n,) or (n, k) to displacements of the same shape


def factorised(matrix: sp.spmatrix, item: str, remedy: str) -> Solve:
    """Solver of a symmetric positive definite sparse system. Raises FiniteElementError if it is singular."""
    try:
        # Diagonal pivots only: keeps the symmetric ordering, which is right for a positive definite matrix.
        factor = spla.splu(
            sp.csc_matrix(matrix), permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options={"SymmetricMode": True}
        )
    except RuntimeError as error:
        raise FiniteElementError(item, "the matrix is singular", remedy) from error
    pivots = factor.U.diagonal()
    if not np.all(pivots > 0.0):
        raise FiniteElementError(
            item, f"the matrix is not positive definite ({int(np.sum(pivots <= 0.0))} pivots are not positive)", remedy
        )
    return lambda force: factor.solve(np.ascontiguousarray(force))


def held_solve(K: sp.csr_matrix, held: Integers) -> Solve:
    """Displacements of the structure with the rows `held` fixed at zero, for forces on all rows."""
    free = np.setdiff1d(np.arange(K.shape[0]), held)
    solve = factorised(
        K[free][:, free],
        "stiffness",
        "with its supports the structure still moves freely: "
        "hold it at more interfaces, or look for parts that are not connected",
    )

    def displacements(force: Array) -> Array:
        result = np.zeros_like(force, dtype=np.float64)
        result[free] = solve(np.asarray(force, dtype=np.float64)[free])
        return result

    return displacements


def inertia_relief(K: sp.csr_matrix, M: sp.csr_matrix, rigid: Array) -> Solve:
    """Elastic displacements of a free structure (inertia relief), for forces on all rows.

    rigid (n, 6) spans the rigid motions. The forces are balanced by the inertia of the rigid acceleration they
    cause; the answer is M-orthogonal to `rigid`. Six rows that restrain `rigid` are held for the solution:
    balanced forces have no reactions there, so that which rows are taken does not matter.
    """
    massed = M @ rigid
    inertia = la.cho_factor(rigid.T @ massed)
    scaled = rigid / np.linalg.norm(rigid, axis=0)
    support = la.qr(scaled.T, mode="r", pivoting=True)[1][:RIGID_MOTIONS]
    solve = held_solve(K, support)

    def displacements(force: Array) -> Array:
        balanced = force - massed @ la.cho_solve(inertia, rigid.T @ force)
        moved = solve(balanced)
        return np.asarray(moved - rigid @ la.cho_solve(inertia, massed.T @ moved))

    return displacements
