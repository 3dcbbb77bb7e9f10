"""Static solutions of a structure: held at interfaces, or free and loaded by self-balanced forces.

What loads a finite-element body in a motion, with errors that name what does not fit the body.

Lowest vibration modes through a static solver: K phi = lambda M phi as (solve M) phi = phi / lambda.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np
import scipy.linalg as la
import scipy.sparse as sp
import scipy.sparse.linalg as spla

from runtime.contract.flexible import BodyMotion, UnknownInterface, causes
from symgen.fe.structure import RIGID_MOTIONS, FEStructure, FiniteElementError, Integers
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


def acting(motion: BodyMotion, nf: int, interfaces: Mapping[str, Array], size: float) -> Array:
    """(N, 9 + 9 nf + 6 interfaces) amounts of the unit causes; interfaces: name -> position (3,) [m]; size [m].

    Raises FiniteElementError for a motion of a body with other modes, and for forces at a marker that is no interface.
    """
    given = motion.q_f.shape[1]
    if given != nf:
        raise FiniteElementError("motion", f"{motion.body} has {given} modes, not {nf}", "give that body's motion")
    try:
        return causes(motion, interfaces, size)
    except UnknownInterface as error:
        raise FiniteElementError(
            f"marker '{error}'", "forces act there, but it is not an interface", "name an interface at that place"
        ) from None


SEED = 20080703  # start vector of the iteration: results repeat
ROWS_SOLVED_DENSE = 120  # up to this many rows all modes at once are cheaper than an iteration
TIE = 1e-6  # entries of a shape this near in size count as equal


def lowest_modes(solve: Solve, M: sp.csr_matrix, count: int) -> tuple[Array, Array]:
    """The `count` modes with the largest mu = 1 / lambda: mu (count,) descending, shapes (n, count).

    `solve` is a symmetric inverse of K (or K - sigma M; mu is then 1 / (lambda - sigma)), possibly on a subspace.
    The shapes are mass-orthonormal. Raises FiniteElementError if there are not so many modes.
    """
    n = M.shape[0]
    if count == 0:
        return np.zeros(0), np.zeros((n, 0))
    if n <= ROWS_SOLVED_DENSE or count >= n // 3:
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
