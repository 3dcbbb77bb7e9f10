"""Lowest vibration modes through a static solver: K phi = lambda M phi as (solve M) phi = phi / lambda."""

from __future__ import annotations

import numpy as np
import scipy.linalg as la
import scipy.sparse as sp
import scipy.sparse.linalg as spla

from symgen.fe.errors import FiniteElementError
from symgen.fe.static import Solve
from symgen.fe.structure import FEStructure
from symgen.modes.cleaning import Array

SEED = 20080703  # start vector of the iteration: results repeat
DENSE = 120  # up to this many rows all modes at once are cheaper than an iteration
TIE = 1e-6  # entries of a shape this near in size count as equal


def lowest_modes(solve: Solve, M: sp.csr_matrix, count: int) -> tuple[Array, Array]:
    """The `count` modes with the largest mu = 1 / lambda: mu (count,) descending, shapes (n, count).

    `solve` is a symmetric inverse of K (or K - sigma M; mu is then 1 / (lambda - sigma)), possibly on a subspace.
    The shapes are mass-orthonormal. Raises FiniteElementError if there are not so many modes.
    """
    n = M.shape[0]
    if count == 0:
        return np.zeros(0), np.zeros((n, 0))
    if n <= DENSE or count >= n // 3:
        mu, shapes = _dense(solve, M, count)
    else:
        operator = spla.LinearOperator((n, n), matvec=solve, dtype=np.float64)
        # K itself is not applied in this mode of the iteration; it stands for the size only.
        value, shapes = spla.eigsh(
            M, k=count, M=M, sigma=0.0, OPinv=operator, v0=solve(M @ np.random.default_rng(SEED).standard_normal(n))
        )
        mu = 1.0 / value
    order = np.argsort(-mu, kind="stable")
    return mu[order], shapes[:, order]


def _dense(solve: Solve, M: sp.csr_matrix, count: int) -> tuple[Array, Array]:
    """As `lowest_modes`, with full matrices: the symmetric form M^1/2 solve M^1/2 allows rows without mass."""
    value, vector = la.eigh(M.toarray())
    kept = value > 1e-12 * value[-1]
    if count > int(kept.sum()):
        raise FiniteElementError(
            "modes",
            f"{count} modes asked for, {int(kept.sum())} rows carry mass",
            "ask for fewer modes or refine the mesh",
        )
    root = vector[:, kept] * np.sqrt(value[kept])
    flexible = solve(root)
    dynamic = root.T @ flexible
    mu, inner = la.eigh(0.5 * (dynamic + dynamic.T))
    mu, inner = mu[::-1][:count], inner[:, ::-1][:, :count]
    with np.errstate(divide="ignore", invalid="ignore"):
        return mu, (flexible @ inner) / mu


def rayleigh_ritz(K: sp.csr_matrix, M: sp.csr_matrix, basis: Array) -> tuple[Array, Array]:
    """Best modes within a basis (n, k): lambda (k,) ascending and mass-orthonormal shapes (n, k)."""
    stiffness, mass = basis.T @ (K @ basis), basis.T @ (M @ basis)
    value, mix = la.eigh(0.5 * (stiffness + stiffness.T), 0.5 * (mass + mass.T))
    return value, basis @ mix


def signed(body: FEStructure, shapes: Array) -> Array:
    """Shapes with the largest entry positive.

    Of entries equal in size (a symmetric body has such pairs) the one at the largest z, y, x decides, so that
    neither round-off nor the order of the nodes does.
    """
    place = np.round(body.positions / (1e-9 + np.ptp(body.positions, axis=0).max()), 6)[body.node]
    rank = np.lexsort((body.component, place[:, 0], place[:, 1], place[:, 2]))
    result = shapes.copy()
    for column in result.T:
        size = np.abs(column)
        first = rank[np.flatnonzero(size[rank] >= (1.0 - TIE) * size.max())[-1]]
        column *= np.sign(column[first])
    return result
