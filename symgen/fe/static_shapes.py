"""Static shapes of loads as modes: what the body does at rest under them is then held exactly, and so are its stresses.

weight_x, ...: a unit acceleration along an axis; turn_x, ...: a unit angular acceleration about an axis through the
origin; spin_x, ...: a unit angular velocity about it, squared; the name of an interface: unit forces and moments there.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from symgen.fe.eigen import rayleigh_ritz, signed
from symgen.fe.errors import FiniteElementError
from symgen.fe.interfaces import Interface
from symgen.fe.mode_sets import ModeSet
from symgen.fe.stress_stiffness import linear_fields
from symgen.fe.structure import AXES, FEStructure
from symgen.modes.cleaning import Array

KINDS = ("weight", "turn", "spin")
HELD = 1e-10  # of a shape's strain energy: what the modes leave of it is rounding


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
            if energy <= HELD * _largest(body, loads):
                raise FiniteElementError(
                    "static", f"{name!r} does not bend the body as it is held", "leave it out, or hold an interface"
                )
            rest = static - shapes @ (shapes.T @ (body.K @ static) / eigenvalues)
            left = float(rest @ (body.K @ rest))
            if left > HELD * energy:
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
        raise FiniteElementError("static", f"{name!r} is not known", f"take of {', '.join(known)}")
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
