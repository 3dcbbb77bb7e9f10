"""Stresses of a solid body by the forces that act on it: mode acceleration with inertia relief.

The sum of modal stresses needs the static shapes of all loads among its modes. Here the body is solved statically for
what loads it at each moment. That is linear in its causes (runtime/contract/flexible.py), so that one static
solution of the free body (balanced by its rigid acceleration) for each unit cause suffices.

Gauges: places of a solid whose stress a scene knows, named by the user or found where stresses are largest.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from runtime.contract.flexible import BodyMotion
from symgen.fe.inertia import dusted
from symgen.fe.interfaces import Interface
from symgen.fe.mode_sets import ModeSet
from symgen.fe.static import acting, inertia_relief
from symgen.fe.stresses import VOIGT, ModalStresses, linear_fit, modal_stresses, solid_stress, von_mises
from symgen.fe.structure import AXES, RIGID_MOTIONS, FEStructure, FiniteElementError
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


Gauges = Mapping[str, int | ArrayLike] | int  # node id or place [m] by name; or how many to find
MOST_GAUGES = 200
DRAWS = 400  # random deflections of equal energy in every mode, among which the largest stresses are looked for


def gauge_places(
    body: FEStructure,
    origin: Array,
    gauges: Gauges,
    stresses: ModalStresses,
    omega: Array,
    parts: Mapping[str, Interface],
) -> dict[str, Array]:
    """Name -> place (3,) [m] from `origin`; omega (nf,) [rad/s] of the modes. Raises FiniteElementError."""
    if isinstance(gauges, int):
        if isinstance(gauges, bool) or not 1 <= gauges <= MOST_GAUGES:
            raise FiniteElementError(
                "gauges", f"{gauges!r} cannot be found", f"ask for 1 to {MOST_GAUGES}, or name them"
            )
        found = most_stressed(body, origin, gauges, stresses, omega, parts)
        return {f"g{k + 1}": place for k, place in enumerate(found)}
    if len(gauges) > MOST_GAUGES:
        raise FiniteElementError("gauges", f"{len(gauges)} are named", f"name at most {MOST_GAUGES}")
    return {name: _place(body, origin, name, given) for name, given in gauges.items()}


def gauge_fields(
    body: FEStructure, modes: ModeSet, origin: Array, interfaces: Mapping[str, Interface], gauges: Gauges
) -> dict[str, dict[str, Any]]:
    """What a scene holds of each gauge, about `origin` (3,) [m]. Raises FiniteElementError."""
    stresses = modal_stresses(body, modes.shapes, origin)
    places = gauge_places(body, origin, gauges, stresses, np.sqrt(modes.eigenvalues), interfaces)
    if not places:
        return {}
    recovered = equilibrium_stresses(body, modes.shapes, origin, interfaces, list(places.values()))
    near, weights = linear_fit(stresses.points, np.array(list(places.values())))
    modal = np.stack([np.einsum("amk,mk->ma", stresses.tensors[:, i, j][:, near], weights) for i, j in VOIGT], axis=1)
    causes = np.stack([recovered.tensors[:, i, j] for i, j in VOIGT])  # (6, k, gauges)
    first = 9 + 9 * recovered.nf
    found = {}
    for place, name in enumerate(places):
        own = causes[:, :, place]
        forces = {
            marker: _clean(own[:, start : start + RIGID_MOTIONS])
            for marker, start in zip(recovered.interfaces, range(first, own.shape[1], RIGID_MOTIONS), strict=True)
        }
        found[name] = {
            "position": places[name].tolist(),
            "shapes": _clean(modal[place]),
            "fields": _clean(own[:, :first]),
            "forces": forces,
        }
    return found


def most_stressed(
    body: FEStructure, origin: Array, count: int, stresses: ModalStresses, omega: Array, parts: Mapping[str, Interface]
) -> Array:
    """(count, 3) places of the surface which together come nearest to the largest von Mises stress of deflections.

    One after another, the next where it adds most, over random deflections. Nearer to an interface than its own size
    stresses tell how its force is spread: no place is there.
    """
    from scipy.spatial import KDTree  # when it is needed: importing it takes long

    surface = np.unique(body.facets)
    for part in parts.values():
        own = body.positions[part.places]
        apart = KDTree(own).query(body.positions[surface])[0]
        surface = surface[apart > float(np.linalg.norm(np.ptp(own, axis=0)))]
    if len(surface) < count:
        raise FiniteElementError(
            "gauges", f"the surface has {len(surface)} nodes away from the interfaces", "ask for fewer, or name them"
        )
    places = body.positions[surface] - origin
    draws = np.random.default_rng(0).standard_normal((DRAWS, len(omega))) / omega
    xx, yy, zz, yz, xz, xy = np.moveaxis(stresses.at(places) @ draws.T, 1, 0)  # (nodes, draws) each
    mises = np.sqrt(((xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2) / 2 + 3 * (yz**2 + xz**2 + xy**2))
    mises /= mises.max(axis=0)
    best, chosen = np.zeros(DRAWS), []
    for _ in range(count):
        chosen.append(int(np.maximum(mises, best).sum(axis=1).argmax()))
        best = np.maximum(best, mises[chosen[-1]])
    return np.asarray(places[chosen])


def _place(body: FEStructure, origin: Array, name: str, given: int | ArrayLike) -> Array:
    item = f"gauges['{name}']"
    if isinstance(given, int | np.integer):
        return np.asarray(body.positions[body.places(item, [int(given)])[0]] - origin)
    point = np.asarray(given, dtype=float)
    if point.shape != (AXES,) or not np.isfinite(point).all():
        raise FiniteElementError(item, f"{given!r} is no place", "give x, y, z in metres, or the id of a node")
    return point


def _clean(values: Array) -> list[list[float]]:
    found: list[list[float]] = dusted(values, float(np.abs(values).max(initial=0.0))).tolist()
    return found
