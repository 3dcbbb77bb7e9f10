"""Stresses of a solid body by the forces that act on it: mode acceleration with inertia relief.

The sum of modal stresses needs the static shapes of all loads among its modes. Here the body is solved statically for
what loads it at each moment. That is linear in its causes (runtime/contract/flexible.py), so that one static
solution of the free body (balanced by its rigid acceleration) for each unit cause suffices.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from runtime.contract.flexible import BodyMotion
from symgen.fe.acting import acting
from symgen.fe.errors import FiniteElementError
from symgen.fe.interfaces import Interface
from symgen.fe.static import inertia_relief
from symgen.fe.stresses import linear_fit, solid_stress, von_mises
from symgen.fe.structure import AXES, FEStructure
from symgen.modes.cleaning import Array, fixed


@dataclass(frozen=True, eq=False)
class EquilibriumStresses:
    """Stresses of a body per unit cause at points (n, 3) [m] from its frame's origin.

    tensors (k, 3, 3, n) [Pa]: of the fields x_i e_j (9, i slowest), phi_a,i e_j (9 nf, a slowest, then i), and of the
    forces and moments of the interfaces (6 each). interfaces: name -> position (3,) [m] of the marker; nf: modes.
    """

    points: Array
    tensors: Array
    interfaces: dict[str, Array]
    nf: int

    def of(self, motion: BodyMotion) -> Array:
        """(N, 3, 3, n) stress tensors [Pa] of a motion, `solution.body_motion(name)`.

        Raises FiniteElementError for a motion of a body with other modes, and for forces at a marker that is no
        interface.
        """
        return np.asarray(np.tensordot(self._causes(motion), self.tensors, axes=1))

    def von_mises(self, motion: BodyMotion) -> Array:
        """(N, n) von Mises stress [Pa]; arguments and errors as of `of`."""
        return np.array([von_mises(np.tensordot(row, self.tensors, axes=1)) for row in self._causes(motion)])

    def _causes(self, motion: BodyMotion) -> Array:
        """(N, k) amounts of the unit causes."""
        size = float(np.ptp(self.points, axis=0).max()) if len(self.points) > 1 else 1.0
        return acting(motion, self.nf, self.interfaces, size)


def equilibrium_stresses(
    body: FEStructure, shapes: Array, origin: Array, interfaces: Mapping[str, Interface], at: ArrayLike | None
) -> EquilibriumStresses:
    """For shapes (n_dof, nf) about `origin` (3,) [m]; at: see `FlexibleBody.equilibrium_stresses`, errors too."""
    stress = solid_stress(body)
    points, pick = stress.points - origin, _all
    if at is not None:
        places = _places(at)
        near, weights = linear_fit(points, places)
        points, pick = places, lambda tensors: np.einsum("ijmk,mk->ijm", tensors[:, :, near], weights)
    solve = inertia_relief(body.K, body.M, body.rigid(body.positions.mean(axis=0)))
    linear = (body.positions - origin)[:, :, None]  # (nodes, i, 1)
    fields = [_along_axes(body, linear), _along_axes(body, body.nodal(shapes, 0))]
    loads = [body.M @ np.hstack(fields), *(np.asarray(part.average.todense()).T for part in interfaces.values())]
    bent = solve(np.hstack(loads))
    tensors = [pick(stress.tensors(bent[:, k : k + 1])[0]) for k in range(bent.shape[1])]
    markers = {name: np.asarray(part.position - origin) for name, part in interfaces.items()}
    return EquilibriumStresses(fixed(points), fixed(np.stack(tensors)), markers, shapes.shape[1])


def _places(at: ArrayLike) -> Array:
    wanted = np.atleast_2d(np.asarray(at, dtype=float))
    if wanted.shape[1] != AXES or not np.isfinite(wanted).all():
        raise FiniteElementError("at", "has rows that are no points", "give x, y, z in metres")
    return wanted


def _all(tensors: Array) -> Array:
    return tensors


def _along_axes(body: FEStructure, nodal: Array) -> Array:
    """(n_dof, 9 k) of nodal vectors (nodes, 3, k): for each of them, component i of it along axis j."""
    n, _, k = nodal.shape
    fields = np.zeros((body.n_dof, k, AXES, AXES))
    for j in range(AXES):
        rows = body.component == j
        fields[rows, :, :, j] = nodal[body.node[rows]].transpose(0, 2, 1)
    return fields.reshape(body.n_dof, -1)
