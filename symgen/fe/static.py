"""Static solutions of a structure: held at interfaces, or free and loaded by self-balanced forces.

What loads a finite-element body in a motion, with errors that name what does not fit the body.

Lowest vibration modes through a static solver: K phi = lambda M phi as (solve M) phi = phi / lambda.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from contextlib import suppress
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np
import scipy.linalg as la
import scipy.sparse as sp
import scipy.sparse.linalg as spla

from runtime.contract.flexible import BodyMotion, UnknownInterface, causes
from symgen.fe.cholesky import Cholesky, NotPositiveDefinite, Progress, cholesky, elimination_plan
from symgen.fe.structure import RIGID_MOTIONS, FEStructure, FiniteElementError, Integers
from symgen.modes.cleaning import Array

Solve = Callable[[Array], Array]  # forces (n,) or (n, k) to displacements of the same shape


def factorised(
    matrix: sp.csr_matrix,
    body: FEStructure,
    rows: Integers,
    item: str,
    remedy: str,
    progress: Progress | None = None,
) -> Cholesky:
    """Factor of a symmetric positive definite matrix, whose row k is the row rows[k] of the body.

    Raises FiniteElementError if it is not positive definite, and if its factor does not fit into memory.
    """
    plan = elimination_plan(matrix, body.node[rows], body.positions)
    check_memory(f"{len(rows):,} degrees of freedom", plan.bytes_at_peak)
    try:
        return cholesky(matrix, plan, progress)
    except NotPositiveDefinite as error:
        row = rows[error.row]
        where = f"component {body.component[row] + 1} of node {body.ids[body.node[row]]}"
        problem = f"the matrix is not positive definite (the pivot of {where} is not positive)"
        raise FiniteElementError(item, problem, remedy) from error


def check_memory(what: str, needed: float) -> None:
    """Raises FiniteElementError where so many bytes are more than the machine has free."""
    free = available_memory()
    if needed > free:
        raise FiniteElementError(
            "mesh",
            f"{what} take {needed / 1e9:.3g} GB of memory, {free / 1e9:.3g} GB are free",
            "coarsen the mesh where no stress is asked for, or take a machine with more memory",
        )


def available_memory() -> float:
    """What this process may still take [bytes]; infinite where the system does not say."""
    limits = [float("inf")]
    with suppress(OSError, ValueError, IndexError):
        known = dict(line.split(":") for line in Path("/proc/meminfo").read_text().splitlines())
        limits.append(1024.0 * float(known["MemAvailable"].split()[0]))
    with suppress(ImportError, OSError, ValueError):
        import resource

        most = resource.getrlimit(resource.RLIMIT_AS)[0]
        if most != resource.RLIM_INFINITY:
            taken = int(Path("/proc/self/statm").read_text().split()[0]) * resource.getpagesize()
            limits.append(float(most - taken))
    return min(limits)


def held_factor(body: FEStructure, held: Integers, progress: Progress | None = None) -> tuple[Cholesky, Integers]:
    """Factor of the stiffness with the rows `held` fixed, and the rows that are free."""
    free = np.setdiff1d(np.arange(body.n_dof), held)
    remedy = (
        "with its supports the structure still moves freely: "
        "hold it at more interfaces, or look for parts that are not connected"
    )
    return factorised(sp.csr_matrix(body.K[free][:, free]), body, free, "stiffness", remedy, progress), free


def held_solve(body: FEStructure, held: Integers, progress: Progress | None = None) -> Solve:
    """Displacements of the structure with the rows `held` fixed at zero, for forces on all rows."""
    factor, free = held_factor(body, held, progress)
    return lambda force: _on_rows(factor, free, force)


def _on_rows(factor: Cholesky, free: Integers, force: Array) -> Array:
    result = np.zeros_like(force, dtype=np.float64)
    result[free] = factor.solve(np.asarray(force, dtype=np.float64)[free])
    return result


@dataclass(frozen=True, eq=False)
class FreeStatics:
    """Static solutions of a free body, all by one factorisation, which is made at the first and kept."""

    body: FEStructure
    progress: Progress | None = None

    @cached_property
    def rigid(self) -> Array:
        """Its rigid motions (n_dof, 6) about the middle, where they are best conditioned."""
        return self.body.rigid(self.body.positions.mean(axis=0))

    @cached_property
    def held(self) -> tuple[Cholesky, Integers]:
        """Factor of the stiffness held at six rows that restrain `rigid`, and the other rows.

        Balanced forces have no reactions there, so that which rows are taken does not matter.
        """
        scaled = self.rigid / np.linalg.norm(self.rigid, axis=0)
        support = la.qr(scaled.T, mode="r", pivoting=True)[1][:RIGID_MOTIONS]
        return held_factor(self.body, support, self.progress)

    def supported(self, force: Array) -> Array:
        """Displacements with these six rows at zero, for forces on all rows."""
        return _on_rows(*self.held, force)

    def relief(self, M: sp.csr_matrix | None = None) -> Solve:
        """Elastic displacements of the free body (inertia relief), for forces on all rows.

        The forces are balanced by the inertia of the rigid acceleration they cause; the answer is M-orthogonal to
        `rigid`. M: the mass, that of the body where it is left out.
        """
        rigid, massed = self.rigid, (self.body.M if M is None else M) @ self.rigid
        inertia = la.cho_factor(rigid.T @ massed)

        def displacements(force: Array) -> Array:
            moved = self.supported(force - massed @ la.cho_solve(inertia, rigid.T @ force))
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
