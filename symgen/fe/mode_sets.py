"""The three mode sets: free, fixed-interface (Craig-Bampton), mixed.

Modal reduction of a finite-element body (model order reduction, component mode synthesis). Free modes move no mass as a
whole: the frame of the body is that of mean axes (Tisserand), its reference conditions.

Static shapes of loads as modes (attachment modes, static correction): what the body
does at rest under them is then held exactly, and so are its stresses.

weight_x, ...: a unit acceleration along an axis; turn_x, ...: a unit angular acceleration about an axis through the
origin; spin_x, ...: a unit angular velocity about it, squared; the name of an interface: unit forces and moments there.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from symgen.fe.inertia import linear_fields
from symgen.fe.static import FreeStatics, Solve, held_solve, lowest_modes, rayleigh_ritz, signed
from symgen.fe.structure import (
    AXES,
    RIGID_MOTIONS,
    FEStructure,
    FiniteElementError,
    Integers,
    Interface,
    check_apart,
    spider,
)
from symgen.modes.cleaning import Array

MODE_SETS = ("free", "fixed_interface", "mixed")
GUARD = 4  # modes computed beyond those asked for: the last ones converge with them
RIGID_RATIO = 1e-3  # a zero mode's frequency is below this share of the lowest elastic one's
ORTHONORMAL = 1e-9


@dataclass(frozen=True, eq=False)
class ModeSet:
    """Elastic modes of a body: mass-orthonormal shapes (n_dof, nf), eigenvalues lambda = omega^2 (nf,).

    elastic: the static solver whose displacements the modes stand for (free: inertia relief; mixed: held).
    held_shapes (n_dof, k), held_eigenvalues (k,): the normal modes with all interfaces held, Craig-Bampton only.
    """

    shapes: Array
    eigenvalues: Array
    elastic: Solve
    held_shapes: Array
    held_eigenvalues: Array


def free_modes(statics: FreeStatics, count: int) -> ModeSet:
    """The `count` lowest modes of the free body, without the rigid ones: they are M-orthogonal to these."""
    _enough(statics.body, count, RIGID_MOTIONS)
    return _modes(statics.body, statics.relief(), count, RIGID_MOTIONS)


def mixed_modes(statics: FreeStatics, fixed: Sequence[Interface], count: int) -> ModeSet:
    """The `count` lowest modes with the nodes of `fixed` held, the other interfaces free.

    An interface tells a rotation, so that holding one leaves no rigid motion.
    Raises FiniteElementError if none is held.
    """
    if not fixed:
        raise FiniteElementError(
            "fixed",
            "a mixed mode set needs an interface that is held",
            "name it, fixed=['pin'], or take mode_set='free'",
        )
    body = statics.body
    held = held_rows(body, fixed)
    _enough(body, count, len(held))
    return _modes(body, held_solve(body, held, statics.progress), count, len(held))


def fixed_interface_modes(statics: FreeStatics, interfaces: Sequence[Interface], count: int) -> ModeSet:
    """Craig-Bampton: six constraint modes per interface and `count` normal modes with all interfaces held.

    Each interface moves as one rigid piece. The reduced problem is made orthonormal in the mass and its six
    rigid modes are removed: 6 (number of interfaces) + count - 6 modes remain.
    Raises FiniteElementError without interfaces, for shared nodes, and if not six rigid modes are found.
    """
    if not interfaces:
        raise FiniteElementError(
            "interface", "fixed-interface modes need at least one interface", "name one, or take mode_set='free'"
        )
    body = statics.body
    check_apart(body, list(interfaces))
    held = held_rows(body, interfaces)
    _enough(body, count, len(held))
    solve = held_solve(body, held, statics.progress)
    normal = _modes(body, solve, count, len(held))
    basis = np.hstack([_constraint_modes(body, one, solve) for one in interfaces] + [normal.shapes])
    value, shapes = _without_rigid(body, statics.rigid, basis)
    return ModeSet(signed(body, shapes), value, statics.relief(), normal.shapes, normal.eigenvalues)


def _constraint_modes(body: FEStructure, at: Interface, solve: Solve) -> Array:
    """Static displacements (n_dof, 6) for the six unit motions of one interface, the others held."""
    moved = np.zeros((body.n_dof, RIGID_MOTIONS))
    moved[at.rows(body)] = spider(body, at)
    return moved - solve(body.K @ moved)


def _without_rigid(body: FEStructure, rigid: Array, basis: Array) -> tuple[Array, Array]:
    """Elastic modes of the reduced body: eigenvalues and shapes, the six rigid ones taken out."""
    value, shapes = rayleigh_ritz(body.K, body.M, basis / np.sqrt(np.sum(basis * (body.M @ basis), axis=0)))
    if len(value) <= RIGID_MOTIONS:
        raise FiniteElementError(
            "modes",
            "one interface and no normal modes give rigid motions only",
            "ask for modes, or name a second interface",
        )
    found = int(np.sum(value <= RIGID_RATIO**2 * value[RIGID_MOTIONS]))
    if found != RIGID_MOTIONS:
        raise FiniteElementError(
            "modes",
            f"{found} rigid modes among the reduced ones, a free body has "
            f"{RIGID_MOTIONS}; frequencies {_hertz(value[: RIGID_MOTIONS + 2])} Hz",
            "check the interfaces and the supports in the matrices",
        )
    kept = shapes[:, RIGID_MOTIONS:]
    massed = body.M @ rigid
    kept = kept - rigid @ np.linalg.solve(rigid.T @ massed, massed.T @ kept)
    return rayleigh_ritz(body.K, body.M, kept)


def _modes(body: FEStructure, solve: Solve, count: int, lost: int) -> ModeSet:
    """The lowest modes of K on the subspace that `solve` maps to, refined once, signed."""
    nothing = np.zeros((body.n_dof, 0))
    if count == 0:
        return ModeSet(nothing, np.zeros(0), solve, nothing, np.zeros(0))
    spare = min(GUARD, _massive(body) - lost - count)
    _, found = lowest_modes(solve, body.M, count + max(spare, 0))
    # One more inverse iteration: what the eigenvalue solver left of higher modes shrinks once more.
    value, shapes = rayleigh_ritz(body.K, body.M, solve(body.M @ found))
    shapes, value = signed(body, shapes[:, :count]), value[:count]
    if np.max(np.abs(shapes.T @ (body.M @ shapes) - np.eye(count))) > ORTHONORMAL or value[0] <= 0.0:
        raise FiniteElementError(
            "modes",
            "the modes found are not mass-orthonormal with positive frequencies",
            "check that the matrices are those of one connected structure",
        )
    return ModeSet(shapes, value, solve, nothing, np.zeros(0))


def _massive(body: FEStructure) -> int:
    """Number of rows that carry mass."""
    return int(np.sum(body.M.diagonal() > 0.0))


def _enough(body: FEStructure, count: int, lost: int) -> None:
    available = _massive(body) - lost
    if count < 0 or count > available:
        raise FiniteElementError(
            "modes",
            f"{count} modes asked for, the model has {max(available, 0)}",
            "ask for fewer modes or refine the mesh",
        )


def _hertz(values: Array) -> list[float]:
    return [float(f"{np.sqrt(abs(value)) / (2.0 * np.pi):.3g}") for value in values]


def held_rows(body: FEStructure, interfaces: Sequence[Interface]) -> Integers:
    """All rows of the nodes of these interfaces, ascending."""
    return np.unique(np.concatenate([one.rows(body) for one in interfaces]))


KINDS = ("weight", "turn", "spin")
ENERGY_ROUNDING = 1e-10  # of a shape's strain energy: what the modes leave of it is rounding


def with_static_shapes(
    body: FEStructure, modes: ModeSet, names: Sequence[str], interfaces: Mapping[str, Interface], origin: Array
) -> ModeSet:
    """The modes with the static shapes of the loads named, orthonormal in the mass; origin (3,) [m].

    A shape that the modes hold already adds none. Raises FiniteElementError for unknown names and for loads that do
    not bend the body, such as a weight on a free one.
    """
    fields = linear_fields(body, origin)
    shapes, eigenvalues = modes.shapes, modes.eigenvalues
    for name in names:
        loads = _loads(name, fields, interfaces)
        for static in modes.elastic(loads).T:
            energy = float(static @ (body.K @ static))
            if energy <= ENERGY_ROUNDING * _largest(body, loads):
                raise FiniteElementError(
                    "static",
                    f"{name!r} does not deform the body with its interfaces held",
                    "leave it out, or hold an interface",
                )
            rest = static - shapes @ (shapes.T @ (body.K @ static) / eigenvalues)
            left = float(rest @ (body.K @ rest))
            if left > ENERGY_ROUNDING * energy:
                basis = np.column_stack([shapes, rest / np.sqrt(float(rest @ (body.M @ rest)))])
                eigenvalues, shapes = rayleigh_ritz(body.K, body.M, basis)
    return replace(modes, shapes=signed(body, shapes), eigenvalues=eigenvalues)


def _loads(name: str, fields: Array, interfaces: Mapping[str, Interface]) -> Array:
    """(n_dof, k) of the load named."""
    if name in interfaces:
        return np.asarray(interfaces[name].average.todense()).T
    kind, _, axis = name.partition("_")
    if kind not in KINDS or axis not in ("x", "y", "z"):
        known = [*(f"{one}_{along}" for one in KINDS for along in "xyz"), *interfaces]
        raise FiniteElementError("static", f"{name!r} is not known", f"choose from {', '.join(known)}")
    k = "xyz".index(axis)
    i, j = (k + 1) % AXES, (k + 2) % AXES
    linear = fields[:, AXES:].reshape(len(fields), AXES, AXES)  # M x_i e_j
    if kind == "weight":
        found = fields[:, k]
    elif kind == "turn":
        found = linear[:, i, j] - linear[:, j, i]
    else:
        found = linear[:, i, i] + linear[:, j, j]
    return np.asarray(found[:, None])


def _largest(body: FEStructure, loads: Array) -> float:
    """Energy [J] that says what is nothing: of the loads on the stiffness of their own rows."""
    diagonal = body.K.diagonal()
    acting = diagonal > 0.0
    return float(np.max(np.sum(loads[acting] ** 2 / diagonal[acting, None], axis=0)))
