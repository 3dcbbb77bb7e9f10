"""Is the structure one free body: six motions without strain, and the six that the node table says?"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import scipy.linalg as la
import scipy.sparse as sp

from symgen.fe.eigen import lowest_modes
from symgen.fe.errors import FiniteElementError
from symgen.fe.static import factorised
from symgen.fe.structure import RIGID_MOTIONS, FEStructure
from symgen.modes.cleaning import Array

ROUND_OFF = 1e4 * np.finfo(np.float64).eps  # strain energy below this share of its terms is none
RIGID_RESIDUAL = 1e-6  # largest share of the stiffness forces that a rigid motion may leave
SHIFT = 1e-8  # of a typical diagonal K / M: well below elastic modes, well above round-off
EXTRA = 3  # modes looked at beyond the six


@dataclass(frozen=True)
class RigidCheck:
    """What was found: zero modes, forces left by rigid motions (share), lowest elastic and highest zero [Hz]."""

    zero_modes: int
    residual: float
    highest_zero: float
    lowest_elastic: float


def check_free_body(body: FEStructure, rigid: Array) -> RigidCheck:
    """Check that `body` has exactly the six zero modes spanned by `rigid` (n_dof, 6).

    Raises FiniteElementError: a mass that is singular, supports in the matrices (fewer than six zero modes),
    a mechanism (more), or rigid motions of the node table that strain the structure.
    """
    _check_mass(body, rigid)
    residual, energy = _left_by(body.K, rigid)
    tolerance = max(ROUND_OFF, 3.0 * energy) if residual < RIGID_RESIDUAL else ROUND_OFF
    value, shapes = _lowest_shifted(body)
    zero = _share(body.K, shapes) <= tolerance
    found = int(zero.sum())
    looked_at = len(value)
    if found != RIGID_MOTIONS:
        raise FiniteElementError(
            "stiffness",
            f"{'at least ' if found == looked_at else ''}{found} motions without strain were found "
            f"among the lowest {looked_at} modes, a free body has {RIGID_MOTIONS}",
            "export the matrices without supports"
            if found < RIGID_MOTIONS
            else "there is a mechanism, or parts are not connected; look near node "
            f"{_loose_node(body, rigid, shapes[:, zero])}",
        )
    if residual > RIGID_RESIDUAL:
        raise FiniteElementError(
            "nodes",
            f"rigid motions built from the node table leave {residual:.2g} of the stiffness forces",
            "the dof map or the coordinates do not belong to these matrices (order of rows, units, local axes)",
        )
    hertz = np.sqrt(np.abs(value)) / (2.0 * np.pi)
    return RigidCheck(found, residual, float(hertz[zero].max()), float(hertz[~zero].min(initial=np.inf)))


def _check_mass(body: FEStructure, rigid: Array) -> None:
    size = float(np.max(np.abs(body.M.diagonal()), initial=0.0))
    inertia = rigid.T @ (body.M @ rigid)
    scale = np.sqrt(np.maximum(np.diag(inertia), np.finfo(np.float64).tiny))
    if size == 0.0 or np.linalg.eigvalsh(inertia / np.outer(scale, scale))[0] < 1e-12:
        raise FiniteElementError(
            "mass",
            "the mass of the rigid body is singular (no mass, or all mass on one line)",
            "give every part a density; a straight beam needs the inertia of its section",
        )
    massive = np.flatnonzero(body.M.diagonal() > 0.0)
    part = body.M[massive][:, massive] + sp.diags(1e-12 * body.M.diagonal()[massive])
    factorised(part, "mass", "inertia is never negative or lost: check the export of the mass matrix")


def _lowest_shifted(body: FEStructure) -> tuple[Array, Array]:
    """The lowest modes of a free structure by a small negative shift: lambda ascending, shapes."""
    massive = body.M.diagonal() > 0.0
    shift = SHIFT * float(np.median(body.K.diagonal()[massive] / body.M.diagonal()[massive]))
    solve = factorised(
        body.K + shift * body.M,
        "stiffness",
        "a part without mass moves freely, or the stiffness is not one of a stable structure",
    )
    mu, shapes = lowest_modes(solve, body.M, min(RIGID_MOTIONS + EXTRA, int(massive.sum())))
    return 1.0 / mu - shift, shapes


def _share(K: sp.csr_matrix, vectors: Array) -> Array:
    """phi^T K phi as a share of the sizes of its terms, per column."""
    energy = np.sum(vectors * (K @ vectors), axis=0)
    return np.asarray(np.abs(energy) / np.sum(np.abs(vectors) * (abs(K) @ np.abs(vectors)), axis=0))


def _left_by(K: sp.csr_matrix, rigid: Array) -> tuple[float, float]:
    """Largest force and energy that the rigid motions leave, as shares of the sizes of their terms."""
    force, terms = np.abs(K @ rigid), abs(K) @ np.abs(rigid)
    return float(np.max(force.max(axis=0) / terms.max(axis=0))), float(np.max(_share(K, rigid)))


def _loose_node(body: FEStructure, rigid: Array, shapes: Array) -> int:
    """Id of the node that moves most in what strain-free motion is left beyond the six rigid ones."""
    basis = la.qr(rigid, mode="economic")[0]
    rest = shapes - basis @ (basis.T @ shapes)
    return int(body.ids[body.node[np.argmax(np.abs(rest).max(axis=1))]])
