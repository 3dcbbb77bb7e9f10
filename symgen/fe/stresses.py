"""Stresses of solids for given displacements, and their geometric stiffness.

The surface of a finite-element body as triangles with its modes, for pictures; thinned where there are many.

Solid meshes of tetrahedra and hexahedra, assembled by scikit-fem.

Stresses of a solid body by the forces that act on it: mode acceleration with inertia relief.

The sum of modal stresses needs the static shapes of all loads among its modes. Here the body is solved statically for
what loads it at each moment. That is linear in its causes (runtime/contract/flexible.py), so that one static
solution of the free body (balanced by its rigid acceleration) for each unit cause suffices.

Gauges: places of a solid whose stress a scene knows.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np
import scipy.sparse as sp
from numpy.typing import ArrayLike

from runtime.contract.flexible import BodyMotion
from symgen.fe.cholesky import elimination_plan
from symgen.fe.inertia import dusted
from symgen.fe.mode_sets import ModeSet
from symgen.fe.recovery import RecoveredPlaces, StressRecovery
from symgen.fe.static import FreeStatics, acting, check_memory
from symgen.fe.structure import (
    AXES,
    RIGID_MOTIONS,
    FEStructure,
    FiniteElementError,
    Integers,
    Interface,
    Material,
    structure,
)
from symgen.modes.cleaning import Array, fixed


@dataclass(frozen=True, eq=False)
class EquilibriumStresses:
    """Stresses of a body per unit cause at points (n, 3) [m] from its frame's origin.

    tensors (k, 3, 3, n) [Pa]: of the fields x_i e_j (9, i slowest), phi_a,i e_j (9 nf, a slowest, then i), and of the
    forces and moments of the interfaces (6 each). interfaces: name -> position (3,) [m] of the marker; nf: modes.
    find_error_rows: the rows of `error_rows` of each point, () inside the elements.
    """

    points: Array
    tensors: Array
    interfaces: dict[str, Array]
    nf: int
    find_error_rows: Callable[[], Sequence[Array]]

    def of(self, motion: BodyMotion) -> Array:
        """(N, 3, 3, n) stress tensors [Pa] of a motion, `solution.body_motion(name)`.

        Raises FiniteElementError for a motion of a body with other modes, and for forces at a marker that is no
        interface.
        """
        return np.asarray(np.tensordot(self._causes(motion), self.tensors, axes=1))

    def von_mises(self, motion: BodyMotion) -> Array:
        """(N, n) von Mises stress [Pa]; arguments and errors as of `of`."""
        return np.array([von_mises(np.tensordot(row, self.tensors, axes=1)) for row in self._causes(motion)])

    def mesh_error(self, motion: BodyMotion) -> Array:
        """Estimate the error [Pa] that the mesh leaves in the stress at the places.

        Parameters
        ----------
        motion : BodyMotion
            N samples, of `solution.body_motion(name)`.

        Returns
        -------
        Array, shape (N, n)
            Von Mises stress [Pa] of how an averaged field differs from the element's own, root mean square over the
            nodes of the element that holds the place. No bound; it does not shrink at a sharp corner, where the stress
            has no limit.

        Raises
        ------
        FiniteElementError
            As `of`; and for points inside the elements, where nothing is averaged: name places, `at=...`.

        References
        ----------
        O. C. Zienkiewicz, J. Z. Zhu, A simple error estimator and adaptive procedure for practical engineering
        analysis, Int. J. Numer. Methods Eng. 24 (1987) 337-357.
        """
        if not self.error_rows:
            raise FiniteElementError("mesh_error", "applies to places only", "take body.equilibrium_stresses(at=...)")
        amounts = self._causes(motion)
        return np.stack([np.linalg.norm(amounts @ rows.T, axis=1) for rows in self.error_rows], axis=1)

    @cached_property
    def error_rows(self) -> Sequence[Array]:
        """Of each place rows (r, k) [Pa]: the length of rows @ amounts of the unit causes is the error of the mesh."""
        return self.find_error_rows()

    def _causes(self, motion: BodyMotion) -> Array:
        """(N, k) amounts of the unit causes."""
        size = float(np.ptp(self.points, axis=0).max()) if len(self.points) > 1 else 1.0
        return acting(motion, self.nf, self.interfaces, size)


def equilibrium_stresses(
    statics: FreeStatics,
    shapes: Array,
    origin: Array,
    interfaces: Mapping[str, Interface],
    at: ArrayLike | None,
    items: Sequence[str] = (),
) -> EquilibriumStresses:
    """For shapes (n_dof, nf) about `origin` (3,) [m]; at: see `FlexibleBody.equilibrium_stresses`, errors too.

    items: names of the places in messages.
    """
    body = statics.body
    stress, solve = solid_stress(body), statics.relief()
    linear = (body.positions - origin)[:, :, None]  # (nodes, i, 1)
    fields = [_along_axes(body, linear), _along_axes(body, body.nodal(shapes, 0))]
    loads = [body.M @ np.hstack(fields), *(np.asarray(part.average.todense()).T for part in interfaces.values())]
    markers = {name: np.asarray(part.position - origin) for name, part in interfaces.items()}
    if at is None:
        bent = solve(np.hstack(loads))
        tensors = np.concatenate([stress.tensors(bent[:, k : k + 1]) for k in range(bent.shape[1])])
        return EquilibriumStresses(fixed(stress.points - origin), fixed(tensors), markers, shapes.shape[1], tuple)
    places = _places(at)
    found = stress.recovery.at(places + origin, items or [f"at[{k}]" for k in range(len(places))], origin)
    around = stress.of_elements(found.elements)
    bent = solve(np.hstack(loads))
    values = np.stack([around.components(bent[:, k : k + 1])[0] @ found.values.T for k in range(bent.shape[1])])
    tensors = np.moveaxis(values[:, TENSOR], 3, -1)

    def rows() -> Sequence[Array]:
        return error_rows(around, bent, found)

    return EquilibriumStresses(fixed(found.places - origin), fixed(tensors), markers, shapes.shape[1], rows)


def error_rows(around: SolidStress, displacements: Array, found: RecoveredPlaces) -> list[Array]:
    """Of each place rows (r, k) [Pa] for displacements (n_dof, k): the length of rows @ amounts is the error there.

    The error is the von Mises stress of `differences`, root mean square over the nodes, a positive quadratic form in
    the amounts; of its directions those are kept that count.
    """
    count = around.basis.Nbfun
    rows: list[Array] = []
    for first in range(0, len(found.places), PLACES_AT_ONCE):
        last = min(first + PLACES_AT_ONCE, len(found.places))
        part = found.differences[first * count : last * count]
        each = [around.components(displacements[:, k : k + 1])[0] @ part.T for k in range(displacements.shape[1])]
        blocks = np.stack(each, axis=-1).reshape(len(VOIGT), last - first, count, -1)  # (6, places, nodes, k)
        equivalent = np.einsum("ab,bpnk->pnak", VON_MISES_ROOT, blocks) / np.sqrt(count)
        rows += [_compressed(block.reshape(-1, block.shape[-1])) for block in equivalent]
    return rows


def _compressed(rows: Array) -> Array:
    """Fewer rows (r, k) with nearly the same length of rows @ amounts, whatever the unit of each amount."""
    sizes = np.linalg.norm(rows, axis=0)
    scale = np.where(sizes > 0.0, sizes, 1.0)
    _, values, directions = np.linalg.svd(rows / scale, full_matrices=False)
    kept = values > DIRECTION_KEPT * max(float(values.max(initial=0.0)), np.finfo(float).tiny)
    return np.asarray((values[kept, None] * directions[kept]) * scale)


def _places(at: ArrayLike) -> Array:
    wanted = np.atleast_2d(np.asarray(at, dtype=float))
    if wanted.shape[1] != AXES or not np.isfinite(wanted).all():
        raise FiniteElementError("at", "has rows that are not points", "give x, y, z in metres")
    return wanted


def _along_axes(body: FEStructure, nodal: Array) -> Array:
    """(n_dof, 9 k) of nodal vectors (nodes, 3, k): for each of them, component i of it along axis j."""
    n, _, k = nodal.shape
    fields = np.zeros((body.n_dof, k, AXES, AXES))
    for j in range(AXES):
        rows = body.component == j
        fields[rows, :, :, j] = nodal[body.node[rows]].transpose(0, 2, 1)
    return fields.reshape(body.n_dof, -1)


Gauges = Mapping[str, int | ArrayLike]  # node id or place [m] by name
MOST_GAUGES = 200


def gauge_fields(
    statics: FreeStatics, modes: ModeSet, origin: Array, interfaces: Mapping[str, Interface], gauges: Gauges
) -> dict[str, dict[str, Any]]:
    """What a scene holds of each gauge, about `origin` (3,) [m]. Raises FiniteElementError."""
    body = statics.body
    if not gauges and solid_stress(body):
        return {}
    if len(gauges) > MOST_GAUGES:
        raise FiniteElementError("gauges", f"{len(gauges)} are named", f"name at most {MOST_GAUGES}")
    places = {name: _place(body, origin, name, given) for name, given in gauges.items()}
    items = [f"gauges['{name}']" for name in places]
    recovered = equilibrium_stresses(statics, modes.shapes, origin, interfaces, list(places.values()), items)
    modal = modal_stresses(body, modes.shapes, origin)
    shapes, own_errors = modal.at(recovered.points), modal.error_rows(recovered.points)
    causes = np.stack([recovered.tensors[:, i, j] for i, j in VOIGT])  # (6, k, gauges)
    found = {}
    for place, name in enumerate(places):
        fields, forces = _by_cause(recovered, causes[:, :, place])
        error_fields, error_forces = _by_cause(recovered, recovered.error_rows[place])
        found[name] = {
            "position": recovered.points[place].tolist(),
            "shapes": _clean(shapes[place]),
            "fields": fields,
            "forces": forces,
            "error_shapes": _clean(own_errors[place]),
            "error_fields": error_fields,
            "error_forces": error_forces,
        }
    return found


def _by_cause(recovered: EquilibriumStresses, rows: Array) -> tuple[list[list[float]], dict[str, list[list[float]]]]:
    """Rows (r, k): those of the fields, and of the forces at each interface."""
    first = 9 + 9 * recovered.nf
    starts = range(first, rows.shape[1], RIGID_MOTIONS)
    forces = {
        marker: _clean(rows[:, start : start + RIGID_MOTIONS])
        for marker, start in zip(recovered.interfaces, starts, strict=True)
    }
    return _clean(rows[:, :first]), forces


def _place(body: FEStructure, origin: Array, name: str, given: int | ArrayLike) -> Array:
    item = f"gauges['{name}']"
    if isinstance(given, int | np.integer):
        return np.asarray(body.positions[body.places(item, [int(given)])[0]] - origin)
    point = np.asarray(given, dtype=float)
    if point.shape != (AXES,) or not np.isfinite(point).all():
        raise FiniteElementError(item, f"{given!r} is not a place", "give x, y, z in metres, or the id of a node")
    return point


def _clean(values: Array) -> list[list[float]]:
    found: list[list[float]] = dusted(values, float(np.abs(values).max(initial=0.0))).tolist()
    return found


VOIGT = ((0, 0), (1, 1), (2, 2), (1, 2), (0, 2), (0, 1))
TENSOR = np.array([[0, 5, 4], [5, 1, 3], [4, 3, 2]])  # places of the components in VOIGT
# The length of this matrix times xx yy zz yz xz xy is the von Mises stress.
VON_MISES_ROOT = np.array(
    [
        [0.5**0.5, -(0.5**0.5), 0.0, 0.0, 0.0, 0.0],
        [0.0, 0.5**0.5, -(0.5**0.5), 0.0, 0.0, 0.0],
        [-(0.5**0.5), 0.0, 0.5**0.5, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 3.0**0.5, 0.0, 0.0],
        [0.0, 0.0, 0.0, 0.0, 3.0**0.5, 0.0],
        [0.0, 0.0, 0.0, 0.0, 0.0, 3.0**0.5],
    ]
)
DIRECTION_KEPT = 0.01  # of the largest: directions of an error that count
PLACES_AT_ONCE = 100  # of which errors are known at once


@dataclass(frozen=True, eq=False)
class SolidStress:
    """Stresses of a solid with this scalar basis, rows x, y, z of node after node: sigma = lame tr(eps) + 2 G eps.

    They are taken at the points of the quadrature, inside the elements, where they are most exact.
    """

    basis: Any
    material: Material

    @cached_property
    def points(self) -> Array:
        """(points, 3) [m]."""
        return np.asarray(self.basis.global_coordinates()).reshape(AXES, -1).T

    @cached_property
    def recovery(self) -> StressRecovery:
        """Stress at places from that at the points."""
        return StressRecovery(self.basis)

    def of_elements(self, elements: Integers) -> SolidStress:
        """The same stresses at the points of these elements (e,) only."""
        return SolidStress(self.basis.with_elements(elements), self.material)

    def components(self, vectors: Array) -> Array:
        """(k, 6, points) stress xx yy zz yz xz xy [Pa] of displacements (n_dof, k) [m]."""
        tensors = self.tensors(vectors)
        return np.stack([tensors[:, i, j] for i, j in VOIGT], axis=1)

    def tensors(self, vectors: Array) -> Array:
        """(k, 3, 3, points) stress [Pa] of displacements (n_dof, k) [m]."""
        found = np.stack([self._gradients(vector) for vector in vectors.T]) if vectors.size else self._none()
        stress = self.material.G * (found + found.transpose(0, 2, 1, 3))
        stress[:, range(AXES), range(AXES)] += self.material.lame * np.einsum("kiip->kp", found)[:, None]
        return np.asarray(stress)

    def __call__(self, displacements: Array, shapes: Array) -> Array:
        """Geometric stiffness (k, nf, nf) of shapes (n_dof, nf) under the stresses of displacements (n_dof, k)."""
        weights = np.asarray(self.basis.dx).ravel()
        modes = np.stack([self._gradients(shape) for shape in shapes.T]) if shapes.size else self._none()
        flat, found = modes.reshape(len(modes), -1), np.zeros((displacements.shape[1], len(modes), len(modes)))
        for k in range(displacements.shape[1]):
            stress = self.tensors(displacements[:, k : k + 1])[0] * weights
            found[k] = flat @ np.einsum("ijp,acjp->acip", stress, modes).reshape(len(modes), -1).T
        return found

    def _gradients(self, vector: Array) -> Array:
        """(component, direction, points)."""
        parts = [np.asarray(self.basis.interpolate(np.ascontiguousarray(vector[c::AXES])).grad) for c in range(AXES)]
        return np.stack(parts).reshape(AXES, AXES, -1)

    def _none(self) -> Array:
        return np.zeros((0, AXES, AXES, len(self.points)))


@dataclass(frozen=True, eq=False)
class ModalStresses:
    """Stresses of a body per unit of q_f: tensors (nf, 3, 3, n) [Pa/m] at points (n, 3) [m] from its frame's origin.

    stress, shapes (n_dof, nf), origin (3,) [m]: what they are made from.
    """

    points: Array
    tensors: Array
    stress: SolidStress
    shapes: Array
    origin: Array

    def of(self, q_f: ArrayLike) -> Array:
        """(N, 3, 3, n) stress tensors [Pa] for modal coordinates (N, nf): the sum of the modal stresses."""
        return np.asarray(np.tensordot(np.atleast_2d(np.asarray(q_f, dtype=float)), self.tensors, axes=1))

    def at(self, places: ArrayLike) -> Array:
        """Stresses per unit of q_f at places in and on the body (symgen/fe/recovery.py).

        Parameters
        ----------
        places : array_like, shape (m, 3)
            From the origin of the body's frame [m]; one beside the body by less than a tenth of a cell moves to its
            surface.

        Returns
        -------
        Array, shape (m, 6, nf)
            Components xx yy zz yz xz xy [Pa per unit of q_f].

        Raises
        ------
        FiniteElementError
            For rows that are not points, and for a place farther outside.
        """
        found = self._recovered(places)
        columns = self._columns(found)
        parts = [self.tensors[:, i, j][:, columns] @ found.values.T for i, j in VOIGT]  # (nf, m) each
        return np.ascontiguousarray(np.moveaxis(np.stack(parts), 2, 0))

    def error_rows(self, places: ArrayLike) -> list[Array]:
        """Of each place (m, 3) [m] rows (r, nf) [Pa]: the length of rows @ q_f is the error that the mesh leaves there.

        See `EquilibriumStresses.mesh_error`. Raises as `at`.
        """
        found = self._recovered(places)
        return error_rows(self.stress.of_elements(found.elements), self.shapes, found)

    def _recovered(self, places: ArrayLike) -> RecoveredPlaces:
        wanted = _places(places)
        return self.stress.recovery.at(wanted + self.origin, [f"at[{k}]" for k in range(len(wanted))], self.origin)

    def _columns(self, found: RecoveredPlaces) -> Integers:
        each = self.stress.recovery.points_each
        return (found.elements[:, None] * each + np.arange(each)).ravel()

    def von_mises(self, q_f: ArrayLike) -> Array:
        """(N, n) von Mises stress [Pa] for modal coordinates (N, nf)."""
        rows = np.atleast_2d(np.asarray(q_f, dtype=float))
        return np.array([von_mises(self.of(row)[0]) for row in rows])  # one at a time: tensors of all points are large


def von_mises(tensors: Array) -> Array:
    """(n,) von Mises stress of stress tensors (3, 3, n) [Pa]."""
    deviator = tensors - np.eye(AXES)[:, :, None] * np.einsum("iip->p", tensors) / AXES
    return np.asarray(np.sqrt(1.5 * np.einsum("ijp,ijp->p", deviator, deviator)))


def modal_stresses(body: FEStructure, shapes: Array, origin: Array) -> ModalStresses:
    """Of shapes (n_dof, nf) about `origin` (3,) [m]; errors as of `solid_stress`."""
    stress = solid_stress(body)
    return ModalStresses(fixed(stress.points - origin), fixed(stress.tensors(shapes)), stress, shapes, origin)


def solid_stress(body: FEStructure) -> SolidStress:
    """The stresses of a body. Raises FiniteElementError for one that is not made from a solid mesh."""
    if isinstance(body.stress, SolidStress):
        return body.stress
    remedy = "make it with from_mesh from tetrahedra or hexahedra"
    raise FiniteElementError("stresses", "the body is not made from a solid mesh", remedy)


ROUNDS = ((0, 1, 2, 3), (0, 1, 3, 2), (0, 2, 1, 3))  # the three ways around four corners
GROWTH = 1.25  # of the cells in which vertices are made one


def boundary_triangles(mesh: Any) -> Integers:
    """Triangles (m, 3) of vertices on the boundary of a scikit-fem mesh; a quadrilateral gives two."""
    facets = np.asarray(mesh.facets[:, mesh.boundary_facets()], dtype=np.int64).T
    if facets.shape[1] == AXES:
        return facets
    corners = np.asarray(mesh.p).T[facets]  # (m, 4, 3); scikit-fem sorts the corners of a facet by number
    around = [np.linalg.norm(corners[:, order] - corners[:, np.roll(order, 1)], axis=2).sum(axis=1) for order in ROUNDS]
    ordered = np.take_along_axis(facets, np.array(ROUNDS)[np.argmin(around, axis=0)], axis=1)
    return np.concatenate([ordered[:, [0, 1, 2]], ordered[:, [0, 2, 3]]])


def thinned(positions: Array, triangles: Integers, most: int) -> tuple[Integers, Integers]:
    """(places of the vertices that are kept, triangles of them), at most so many.

    Vertices in the same cell of a grid become the first of them; the grid is made coarser until it suffices.
    """
    used, triangles = np.unique(triangles, return_inverse=True)
    triangles = triangles.reshape(-1, AXES)
    kept, coarse = np.arange(len(used)), triangles
    size = float(np.ptp(positions[used], axis=0).max()) * most**-0.5 / 2.0
    while len(coarse) > most:
        size *= GROWTH
        cells = np.floor((positions[used] - positions[used].min(axis=0)) / size).astype(np.int64)
        _, kept, which = np.unique(cells, axis=0, return_index=True, return_inverse=True)
        coarse = which.reshape(-1)[triangles]
        whole = (coarse[:, 0] != coarse[:, 1]) & (coarse[:, 1] != coarse[:, 2]) & (coarse[:, 2] != coarse[:, 0])
        coarse = coarse[whole]
        coarse = coarse[np.unique(np.sort(coarse, axis=1), axis=0, return_index=True)[1]]
    return used[kept], coarse


def surface_data(positions: Array, nodal: Array, triangles: Integers, origin: Array, most: int) -> dict[str, Array]:
    """vertices (n, 3) [m] from `origin`, triangles (m, 3), shapes (n, 3, nf) of the nodes' positions and shapes.

    Raises FiniteElementError without triangles, and for fewer than 4 of them.
    """
    if not len(triangles):
        raise FiniteElementError("surface", "matrices and beams have no faces", "make the body from a solid mesh")
    if most < 4:
        raise FiniteElementError("max_triangles", f"is {most}", "give at least 4")
    kept, found = thinned(positions, triangles, most)
    return {
        "vertices": np.array(positions[kept] - origin, dtype=np.float32),
        "triangles": found.astype(np.int32),
        "shapes": np.array(nodal[kept], dtype=np.float32),
    }


BYTES_AN_ENTRY = 60  # of the stiffness, while it is assembled

# Quadrature of this degree integrates the mass of each element exactly (per direction for hexahedra).
DEGREE = {"P1": 2, "P2": 4, "Q1": 3, "Q2": 5}


def solid_structure(mesh: Any, material: Material, order: int = 2) -> FEStructure:
    """Stiffness and consistent mass of a scikit-fem MeshTet or MeshHex; elements P1/Q1 (order 1) or P2/Q2 (order 2).

    The first node ids are the mesh's vertices 0, 1, ...; order 2 adds nodes on edges, faces and in cells.
    Linear hexahedra bend too stiffly; take them for compact parts only.
    Raises FiniteElementError without scikit-fem, for other meshes and orders, and for cells turned inside out.
    """
    skfem, scalar = _checked_basis(mesh, order)
    gradients = _gradient_products(skfem, scalar)
    mass = material.rho * skfem.BilinearForm(lambda u, v, _: u * v).assemble(scalar)
    K = _elastic(gradients, material)
    n = scalar.N
    # Rows so far: all x, all y, all z. Sort them node by node.
    order_rows = np.arange(AXES * n).reshape(AXES, n).T.ravel()
    K = sp.csr_matrix(K)[order_rows][:, order_rows]
    M = sp.kron(mass, sp.eye(AXES), format="csr")
    body = structure(
        K,
        M,
        np.arange(n),
        np.array(scalar.doflocs.T, dtype=np.float64),
        np.repeat(np.arange(n), AXES),
        np.tile(np.arange(AXES), n),
    )
    return replace(body, facets=boundary_triangles(mesh), stress=SolidStress(scalar, material))


def _checked_basis(mesh: Any, order: int) -> tuple[Any, Any]:
    """(scikit-fem, the scalar basis of the mesh with its quadrature); raises FiniteElementError."""
    try:
        import skfem
    except ImportError as error:
        raise FiniteElementError("scikit-fem", "it is not installed", "pip install 'symgen[fe]'") from error
    kinds = {
        (skfem.MeshTet, 1): ("P1", skfem.ElementTetP1),
        (skfem.MeshTet, 2): ("P2", skfem.ElementTetP2),
        (skfem.MeshHex, 1): ("Q1", skfem.ElementHex1),
        (skfem.MeshHex, 2): ("Q2", skfem.ElementHex2),
    }
    found = [kind for (shape, degree), kind in kinds.items() if isinstance(mesh, shape) and degree == order]
    if not found:
        raise FiniteElementError(
            "mesh",
            f"a {type(mesh).__name__} with elements of order {order}",
            "give a scikit-fem MeshTet or MeshHex and order 1 or 2, or a LineMesh",
        )
    name, element = found[0]
    _check_size(skfem, mesh, element())
    with np.errstate(divide="ignore", invalid="ignore"):  # flat cells are refused below
        basis = skfem.Basis(mesh, element(), intorder=DEGREE[name])
    volume = np.asarray(basis.mapping.detDF(basis.X))
    bad = np.flatnonzero(volume.min(axis=-1) * volume.max(axis=-1) <= 0.0)
    if bad.size:
        raise FiniteElementError(
            "mesh",
            f"{bad.size} cells have no volume or are turned inside out, the first is {bad[0]}",
            "repair the mesh",
        )
    return skfem, basis


def _check_size(skfem: Any, mesh: Any, element: Any) -> None:
    """Raises FiniteElementError where the matrices and the factor of the stiffness do not fit into memory."""
    with np.errstate(divide="ignore", invalid="ignore"):
        light = skfem.Basis(mesh, element, intorder=1, disable_doflocs=False)
    cells = np.asarray(light.element_dofs)
    n, places = int(light.N), np.asarray(light.doflocs, dtype=np.float64).T
    entries = (np.ones(cells.size, dtype=np.int32), (cells.ravel(), np.tile(np.arange(cells.shape[1]), len(cells))))
    meets = sp.csr_matrix(entries, shape=(n, cells.shape[1]))
    graph = sp.csr_matrix(meets @ meets.T)
    factor = AXES**2 * elimination_plan(graph, np.arange(n), places).bytes_at_peak
    check_memory(f"{AXES * n:,} degrees of freedom", factor + AXES**2 * graph.nnz * BYTES_AN_ENTRY)


def _gradient_products(skfem: Any, basis: Any) -> list[list[sp.csr_matrix]]:
    """[i][j]: int d_i v d_j u dV, (n, n) each; the lower half by transposition."""
    products: list[list[Any]] = [[None] * AXES for _ in range(AXES)]
    for i in range(AXES):
        for j in range(i, AXES):
            form = skfem.BilinearForm(lambda u, v, _, i=i, j=j: v.grad[i] * u.grad[j])
            products[i][j] = form.assemble(basis)
            products[j][i] = products[i][j].T
    return products


def _elastic(products: list[list[sp.csr_matrix]], material: Material) -> sp.csr_matrix:
    """int lame div u div v + 2 G eps(u) : eps(v) dV from the products of gradients; rows x, then y, then z."""
    diffusion = products[0][0] + products[1][1] + products[2][2]
    blocks = [[material.lame * products[i][j] + material.G * products[j][i] for j in range(AXES)] for i in range(AXES)]
    for i in range(AXES):
        blocks[i][i] = blocks[i][i] + material.G * diffusion
    return sp.csr_matrix(sp.bmat(blocks))
