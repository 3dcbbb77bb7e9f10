"""Interfaces: named sets of nodes as markers, averaged or held as one rigid piece."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
import scipy.sparse as sp

from symgen.fe.structure import AXES, RIGID_MOTIONS, FEStructure, FiniteElementError, Flags, Integers
from symgen.modes.cleaning import Array

NodeSet = Sequence[int] | Callable[[Array], Flags]

FLAT = 1e-8  # relative size of the smallest moment of the nodes below which they lie on a line


@dataclass(frozen=True, eq=False)
class Interface:
    """A set of nodes that one marker stands for.

    places (k,): where the nodes are in the table.  position (3,) [m]: of the marker.
    average (6, n_dof), sparse: displacement of the marker with the set, and the set's rotation, from the rows of u;
    its transpose spreads a force and a torque at the marker over the nodes.
    """

    name: str
    places: Integers
    position: Array
    average: sp.csr_matrix

    def rows(self, body: FEStructure) -> Integers:
        """All rows of the nodes, ascending."""
        rows = body.rows[self.places]
        return np.sort(rows[rows >= 0])


def interface(body: FEStructure, name: str, nodes: NodeSet, position: Array | None = None) -> Interface:
    """The interface of these nodes: ids, or a function of all positions (n, 3) [m] that says which, (n,) of bool.

    position (3,) [m]: of the marker, which moves with the average; the mean position of the nodes unless given.
    All nodes weigh the same, whatever their mass or area.

    One node with rotations: its own six motions. Else u = mean u_k, and the rotation is the omega for which
    sum |u_k - u - omega x s_k|^2 is least, s_k from the mean position; nodes on one line take the mean of
    their own rotations. Raises FiniteElementError for unknown nodes, and where no rotation can be told.
    """
    item = f"interface '{name}'"
    places = body.places(item, body.ids[np.asarray(nodes(body.positions), dtype=bool)] if callable(nodes) else nodes)
    rows = body.rows[places]
    if np.any(rows[:, :AXES] < 0):
        raise FiniteElementError(item, "a node of it has no translations", "choose nodes with x, y and z")
    middle = body.positions[places].mean(axis=0)
    arms = body.positions[places] - middle
    moment = np.sum(arms**2) * np.eye(AXES) - arms.T @ arms
    average = np.zeros((RIGID_MOTIONS, body.n_dof))
    for axis in range(AXES):
        average[axis, rows[:, axis]] = 1.0 / len(places)
    if np.linalg.eigvalsh(moment)[0] > FLAT * max(np.trace(moment), np.finfo(float).tiny):
        inverse = np.linalg.inv(moment)
        for place_rows, arm in zip(rows, arms, strict=True):
            average[AXES:, place_rows[:AXES]] += inverse @ _cross(arm)
    elif np.all(rows >= 0):
        for axis in range(AXES, RIGID_MOTIONS):
            average[axis, rows[:, axis]] = 1.0 / len(places)
    else:
        raise FiniteElementError(
            item,
            "its nodes lie on one line and have no rotations, so that they tell none",
            "take three or more nodes that are not on a line",
        )
    if position is None:
        return Interface(name, places, middle, sp.csr_matrix(average))
    average[:AXES] -= _cross(position - middle) @ average[AXES:]  # omega x offset = -offset x omega
    return Interface(name, places, position, sp.csr_matrix(average))


def spider(body: FEStructure, at: Interface) -> Array:
    """Motion of the interface as one rigid piece: (rows of the interface, 6), about its position."""
    return body.rigid(at.position)[at.rows(body)]


def check_apart(body: FEStructure, interfaces: list[Interface]) -> None:
    """Raises FiniteElementError if a node belongs to two interfaces: as rigid pieces they would be one."""
    owner: dict[int, str] = {}
    for one in interfaces:
        for place in one.places:
            other = owner.setdefault(int(place), one.name)
            if other != one.name:
                raise FiniteElementError(
                    f"interface '{one.name}'",
                    f"node {body.ids[place]} is also of '{other}'",
                    "interfaces that are held must not share nodes",
                )


def _cross(arm: Array) -> Array:
    """Matrix of arm x."""
    x, y, z = arm
    return np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
