"""Inertia shape integrals of a finite-element body in its frame (the numbers of Eq. 20 for a body in space)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import scipy.linalg as la
import scipy.sparse as sp

from symgen.fe.errors import FiniteElementError
from symgen.fe.structure import AXES, RIGID_MOTIONS, FEStructure
from symgen.modes.cleaning import RELATIVE_ZERO, Array, clean, fixed, symmetric

DUST = 1e-9  # entries below this share of what they could be are round-off of the mode shapes
SCALAR_MASS = 1e-9  # how nearly M must be a scalar mass in each direction to be taken as one
COARSEST = 0.5  # largest departure of the nodal masses from M_ff that a scaling may bridge


@dataclass(frozen=True, eq=False)
class InertiaIntegrals:
    """rho0: place in the undeformed body from the frame's origin [m]; phi_a: shape of mode a (unit of q_f: any).

    mass [kg].  first_moment (3,): int rho0 dm [kg m].  moments (3, 3): int rho0_i rho0_j dm [kg m^2].
    M_ff (nf, nf), phi_integral (3, nf): int phi_a dm.  rho_phi (nf, 3, 3): [a][i][j] = int rho0_i phi_a,j dm.
    phi_phi (nf, nf, 3, 3): [a][b][i][j] = int phi_a,i phi_b,j dm; its trace over i = j is M_ff.
    """

    mass: float
    first_moment: Array
    moments: Array
    M_ff: Array
    phi_integral: Array
    rho_phi: Array
    phi_phi: Array


def inertia_integrals(body: FEStructure, shapes: Array, origin: Array) -> InertiaIntegrals:
    """Integrals for mass-orthonormal shapes (n_dof, nf) about `origin` (3,) [m].

    What is linear in the shapes or free of them and belongs to rigid motion comes from M itself: mass, first
    moment, inertia, int phi dm, int rho0 x phi dm. The other products need to know where the mass is. Where
    M holds the same scalar mass for x, y and z (solids), that is used exactly. Else each node gets the mass,
    its first moment and the rotary inertia of its rows of M (summed); the shapes in these products are then
    scaled by the symmetric matrix that makes the trace equal M_ff.
    Raises FiniteElementError if that scaling is far from one.
    """
    rigid = body.rigid(origin)
    massed = body.M @ rigid
    moved = massed.T @ shapes  # (6, nf): int phi dm and int rho0 x phi dm
    tensor = rigid.T @ massed
    mass = float(np.trace(tensor[:AXES, :AXES])) / AXES
    inertia = symmetric(tensor[AXES:, AXES:])
    moments = 0.5 * np.trace(inertia) * np.eye(AXES) - inertia
    rho_phi, phi_phi = _scalar_products(body, shapes, origin) or _nodal_products(body, shapes, origin)
    rho_phi = _with_skew_part(rho_phi, moved[AXES:])
    reach = float(np.sqrt(np.trace(moments)))
    coupling = tensor[AXES:, :AXES]  # rows: int rho0 x e_j dm
    return InertiaIntegrals(
        mass=mass,
        first_moment=fixed(dusted(_vector(coupling), np.sqrt(mass) * reach)),
        moments=fixed(dusted(moments, reach**2)),
        M_ff=fixed(np.eye(shapes.shape[1])),
        phi_integral=fixed(dusted(moved[:AXES], np.sqrt(mass))),  # the shapes have unit modal mass
        rho_phi=fixed(dusted(rho_phi, reach)),
        phi_phi=fixed(dusted(phi_phi, 1.0)),
    )


def scalar_mass(body: FEStructure) -> sp.csr_matrix | None:
    """The (n, n) mass that x, y and z have in common, or None where M is not of that kind."""
    if body.n_dof != AXES * len(body.ids) or np.any(body.component >= AXES):
        return None
    x, y, z = (body.rows[:, axis] for axis in range(AXES))
    scalar = body.M[x][:, x]
    limit = SCALAR_MASS * float(np.max(np.abs(body.M.data)))
    for one, two in ((y, y), (z, z), (x, y), (x, z), (y, z)):
        rest = body.M[one][:, two] - (scalar if one is two else 0.0 * scalar)
        if float(np.max(np.abs(rest.data), initial=0.0)) > limit:
            return None
    return scalar


def _scalar_products(body: FEStructure, shapes: Array, origin: Array) -> tuple[Array, Array] | None:
    """rho_phi and phi_phi by the common scalar mass, exact."""
    scalar = scalar_mass(body)
    if scalar is None:
        return None
    phi = body.nodal(shapes, 0)  # (n, 3, nf)
    n, _, nf = phi.shape
    massed = (scalar @ phi.reshape(n, AXES * nf)).reshape(n, AXES, nf)
    rho_phi = np.einsum("ki,kja->aij", body.positions - origin, massed)
    phi_phi = np.einsum("kia,kjb->abij", phi, massed)
    return rho_phi, phi_phi


def nodal_inertia(body: FEStructure) -> tuple[Array, Array, Array]:
    """Mass (n,) [kg], first moment (n, 3) [kg m], rotary inertia (n, 3, 3) [kg m^2] of the nodes: rows of M summed.

    The first moment says that the mass of a node at the end of a beam lies a sixth of an element inwards, the
    end correction of the trapezium rule; it vanishes between equal elements.
    """
    unit = np.zeros((body.n_dof, RIGID_MOTIONS))
    unit[np.arange(body.n_dof), body.component] = 1.0
    massed = body.M @ unit
    mass = np.einsum("kii->k", body.nodal(massed[:, :AXES], 0)) / AXES
    coupling = body.nodal(massed[:, :AXES], AXES)
    return mass, _vector(coupling), symmetric(body.nodal(massed[:, AXES:], AXES))


def _nodal_products(body: FEStructure, shapes: Array, origin: Array) -> tuple[Array, Array]:
    """rho_phi and phi_phi from the mass, the first moment and the rotary inertia of the nodes."""
    mass, first, inertia = nodal_inertia(body)
    spread = 0.5 * np.einsum("kii->k", inertia)[:, None, None] * np.eye(AXES) - inertia  # int s_i s_j dm of a node
    phi, turn = body.nodal(shapes, 0), body.nodal(shapes, AXES)
    arms = body.positions - origin
    # A particle at s from its node moves by phi + turn x s; tilt[k, i, l, a] s_l is the second term.
    tilt = np.zeros((*phi.shape[:2], AXES, phi.shape[2]))
    for i, j, m in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        tilt[:, i, m], tilt[:, i, j] = turn[:, j], -turn[:, m]
    spread_tilt = np.einsum("kln,kjna->klja", spread, tilt)
    shifted = np.einsum("kina,kn->kia", tilt, first)
    impulse = mass[:, None, None] * phi + shifted  # int (phi + turn x s) dm of a node
    rho_phi = (
        np.einsum("ki,kja->aij", arms, impulse)
        + np.einsum("ki,kja->aij", first, phi)
        + np.einsum("kija->aij", spread_tilt)
    )
    phi_phi = (
        np.einsum("kia,kjb->abij", phi, impulse)
        + np.einsum("kia,kjb->abij", shifted, phi)
        + np.einsum("kila,kljb->abij", tilt, spread_tilt)
    )
    scale = _scaling(np.einsum("abii->ab", phi_phi))
    rho_phi = np.einsum("aij,ac->cij", rho_phi, scale)
    return rho_phi, np.einsum("abij,ac,bd->cdij", phi_phi, scale, scale)


def _scaling(trace: Array) -> Array:
    """The symmetric matrix S with S trace S = 1."""
    value, vector = la.eigh(symmetric(trace)) if trace.size else (np.zeros(0), trace)
    worst = float(np.max(np.abs(value - 1.0), initial=0.0))
    if worst > COARSEST:
        raise FiniteElementError(
            "mass",
            f"masses lumped at the nodes differ by {100 * worst:.0f} % from those of the {len(value)} modes",
            "refine the mesh, ask for fewer modes, or take mass='lumped'",
        )
    return (vector / np.sqrt(value)) @ vector.T


def _vector(coupling: Array) -> Array:
    """The c with coupling[..., r, j] = e_r . (c x e_j), (..., 3)."""
    turned = 0.5 * (coupling - np.swapaxes(coupling, -1, -2))
    return np.stack([turned[..., 2, 1], turned[..., 0, 2], turned[..., 1, 0]], axis=-1)


def _with_skew_part(rho_phi: Array, turning: Array) -> Array:
    """rho_phi with int rho0 x phi_a dm = turning[:, a], (3, nf), exactly: its skew part is that vector's."""
    result = 0.5 * (rho_phi + np.swapaxes(rho_phi, 1, 2))
    for i, j, m in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        result[:, i, j] += 0.5 * turning[m]
        result[:, j, i] -= 0.5 * turning[m]
    return result


def dusted(values: Array, scale: float) -> Array:
    """Copy with entries below 1e-9 of `scale` (in their unit) as exact zeros."""
    return clean(values, DUST / RELATIVE_ZERO * float(scale))
