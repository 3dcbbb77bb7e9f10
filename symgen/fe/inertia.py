"""Inertia shape integrals of a finite-element body in its frame (the numbers of Eq. 20 for a body in space).

A consistent mass matrix as masses at the nodes.

Geometric stiffness of a finite-element body from the stresses of unit loads, reduced to its modes (Eqs. 15-20).

A stress field s gives the energy q^T K_s q / 2 with K_s = int (grad phi_a)^T s (grad phi_b) dV. The stress of a load is
linear in it, so K_s of any motion is a sum over loads: of unit accelerations of the frame, of the fields x_i e_j that
angular velocities and accelerations make, and of unit forces at the interfaces. Each K_s is the work of its load on a
displacement of second order, -q^T H(x) q / 2: the body template takes int H_i dm, int x_i H_j dm and H at markers.
Loads in a motion balance, inertia forces among them, so that the supports of the single solutions drop out of the sum.

What a scene is told of a finite-element body: numbers and lists.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import scipy.linalg as la
import scipy.sparse as sp

from runtime.contract.records import packed
from symgen.fe.static import Solve
from symgen.fe.structure import AXES, RIGID_MOTIONS, FEStructure, FiniteElementError, Interface
from symgen.modes.cleaning import RELATIVE_ZERO, Array, clean, fixed, symmetric

SHAPE_ROUNDING = 1e-9  # entries below this share of what they could be are round-off of the mode shapes
SCALAR_MASS = 1e-9  # how nearly M must be a scalar mass in each direction to be taken as one
COARSEST = 0.5  # largest departure of the nodal masses from M_ff that a scaling may bridge


@dataclass(frozen=True, eq=False)
class InertiaIntegrals:
    """rho0: place in the undeformed body from the frame's origin [m]; phi_a: shape of mode a (unit of q_f: any).

    mass [kg].  first_moment (3,): int rho0 dm [kg m].  moments (3, 3): int rho0_i rho0_j dm [kg m^2].
    M_ff (nf, nf), phi_integral (3, nf): int phi_a dm.  rho_phi (nf, 3, 3): [a, i, j] = int rho0_i phi_a,j dm.
    phi_phi (nf, nf, 3, 3): [a, b, i, j] = int phi_a,i phi_b,j dm; its trace over i = j is M_ff.
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
    return clean(values, SHAPE_ROUNDING / RELATIVE_ZERO * float(scale))


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


@dataclass(frozen=True, eq=False)
class StressStiffening:
    """Displacements of second order -q^T H_i q / 2 along axis i, mass-orthonormal shapes [1/m per kg].

    H (3, nf, nf): int H_i dm.  xH (3, 3, nf, nf): [i, j] = int x_i H_j dm.  at: (3, nf, nf) at each interface, by name.
    """

    H: Array
    xH: Array
    at: dict[str, Array]


def stress_stiffening(
    body: FEStructure, shapes: Array, origin: Array, parts: Sequence[Interface], solve: Solve
) -> StressStiffening:
    """For shapes (n_dof, nf) about `origin` (3,) [m]; solve: of the held body.

    Raises FiniteElementError where the elements that carry the stresses are not known.
    """
    if body.stress is None:
        raise FiniteElementError(
            "stiffening",
            "the stresses of a body from matrices are not known",
            "make it from a mesh (from_mesh), or leave stiffening out",
        )
    loads = [linear_fields(body, origin), *(np.asarray(part.average[:AXES].todense()).T for part in parts)]
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


def _dusted(values: Array) -> Array:
    return dusted(values, float(np.abs(values).max(initial=0.0)))


@dataclass(frozen=True, eq=False)
class Marker:
    """An interface on the body: position (3,) [m] from the origin; shape, rotation (3, nf): per unit of q_f."""

    position: Array
    shape: Array
    rotation: Array


def modal_fields(
    these: InertiaIntegrals,
    eigenvalues: Array,
    markers: Mapping[str, Marker],
    stiffening: StressStiffening | None,
    damping_ratio: float | Sequence[float],
    surface: Mapping[str, Array],
) -> dict[str, Any]:
    """See `FlexibleBody.fields`; surface: its arrays, none for no surface. Raises FiniteElementError."""
    ratios = np.asarray(damping_ratio, dtype=np.float64)
    if (
        ratios.shape not in ((), eigenvalues.shape)
        or not np.all(np.isfinite(ratios))
        or np.any((ratios < 0.0) | (ratios >= 1.0))
    ):
        raise FiniteElementError(
            "damping_ratio",
            f"{damping_ratio!r} is not a fraction of critical damping, or one per mode",
            f"give one number from 0 to 1, 0.02 for 2 %, or {len(eigenvalues)}",
        )
    arrays = {
        "first_moment": these.first_moment,
        "inertia_moments": these.moments,
        "M_ff": these.M_ff,
        "K_ff": np.diag(eigenvalues),
        "D_ff": np.diag(2.0 * ratios * np.sqrt(eigenvalues)),
        "phi_integral": these.phi_integral,
        "rho_phi": these.rho_phi,
        "phi_phi": these.phi_phi,
    }
    places: dict[str, dict[str, Any]] = {
        name: {"position": one.position.tolist(), "shape": one.shape.tolist(), "rotation": one.rotation.tolist()}
        for name, one in markers.items()
    }
    fields = {"mass": these.mass, **{key: array.tolist() for key, array in arrays.items()}, "markers": places}
    if stiffening is not None:
        fields["stiffening"] = {"H": stiffening.H.tolist(), "xH": stiffening.xH.tolist()}
        for name, marker in places.items():
            marker["foreshortening"] = stiffening.at[name].tolist()
    if surface:
        kinds = {key: "<i4" if key == "triangles" else "<f4" for key in surface}
        fields["surface"] = {key: packed(array, kinds[key]) for key, array in surface.items()}
    return fields
