"""Choices that a flexible body is made with, checked: interfaces, markers, origin."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import ArrayLike

from symgen.fe.errors import FiniteElementError
from symgen.fe.inertia import dusted
from symgen.fe.interfaces import Interface, NodeSet, interface
from symgen.fe.modal_fields import Marker
from symgen.fe.mode_sets import MODE_SETS
from symgen.fe.structure import AXES, FEStructure
from symgen.modes.cleaning import Array, fixed

MASSES = ("consistent", "lumped")


def known_choice(item: str, value: str, choices: tuple[str, ...]) -> None:
    """Raises FiniteElementError for a value that is none of the choices."""
    if value not in choices:
        raise FiniteElementError(item, f"{value!r} is not known", f"choose one of {list(choices)}")


def check_choices(mode_set: str, mass: str, fixed: Sequence[str]) -> None:
    """Raises FiniteElementError for sets of modes and masses that are not known."""
    known_choice("mode_set", mode_set, MODE_SETS)
    known_choice("mass", mass, MASSES)
    if fixed and mode_set != "mixed":
        raise FiniteElementError(
            "fixed",
            f"interfaces are held in a mixed set, not in '{mode_set}'",
            "take mode_set='mixed', or leave fixed out",
        )


def interfaces_of(body: FEStructure, sets: Mapping[str, NodeSet], at: Mapping[str, ArrayLike]) -> dict[str, Interface]:
    """By name; at: where their markers are [m], if not at the mean of the nodes."""
    if not sets:
        raise FiniteElementError("interface", "no interface is named", "name the node sets where joints and loads act")
    for name in at:
        known_choice("marker_positions", name, tuple(sets))
    return {
        name: interface(body, name, nodes, _point(f"marker_positions['{name}']", at[name]) if name in at else None)
        for name, nodes in sets.items()
    }


def origin_of(origin: str | ArrayLike, parts: Mapping[str, Interface]) -> Array:
    """(3,) [m]: a point, or the place of an interface."""
    if isinstance(origin, str):
        known_choice("origin", origin, tuple(parts))
        return fixed(parts[origin].position)
    return fixed(_point("origin", origin))


def _point(item: str, value: ArrayLike) -> Array:
    point = np.asarray(value, dtype=np.float64)
    if point.shape != (AXES,) or not np.all(np.isfinite(point)):
        raise FiniteElementError(item, f"{value!r} is not a point", "give x, y, z in metres")
    return point


def marker_of(part: Interface, shapes: Array, origin: Array) -> Marker:
    """The marker of an interface: how the shapes (n_dof, nf) move and turn it."""
    moved = part.average @ shapes
    position = part.position - origin
    return Marker(
        fixed(dusted(position, float(np.linalg.norm(position)))),
        fixed(dusted(moved[:AXES], float(np.max(np.abs(shapes), initial=0.0)))),
        fixed(dusted(moved[AXES:], float(np.max(np.abs(moved[AXES:]), initial=0.0)))),
    )
