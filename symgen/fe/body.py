"""A flexible body from a finite-element model: modes, markers and inertia shape integrals.

Choices that a flexible body is made with, checked: interfaces, markers, origin.

Node tables and dof maps: `id x y z`, `node component`.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any, TypeAlias

import numpy as np
import scipy.sparse as sp
from numpy.typing import ArrayLike

from runtime.contract.arguments import BY_NAME, CALLED, Kind, arguments
from runtime.contract.errors import shown_value
from runtime.contract.meter import Meter
from symgen.fe.frame import EquilibriumForces, LineMesh, equilibrium_forces, frame_structure, struts
from symgen.fe.inertia import (
    InertiaIntegrals,
    Marker,
    StressStiffening,
    dusted,
    inertia_integrals,
    lumped,
    modal_fields,
    stress_stiffening,
)
from symgen.fe.mesh_files import FileMesh, interface_of
from symgen.fe.mode_sets import MODE_SETS, ModeSet, fixed_interface_modes, free_modes, mixed_modes, with_static_shapes
from symgen.fe.reduced import ReducedBody, reduced_body
from symgen.fe.report import (
    FlexibilityLoss,
    RigidCheck,
    body_report,
    check_free_body,
    effective_masses,
    flexibility_losses,
    rigid_check,
)
from symgen.fe.static import FreeStatics
from symgen.fe.stresses import (
    EquilibriumStresses,
    Gauges,
    ModalStresses,
    equilibrium_stresses,
    gauge_fields,
    modal_stresses,
    solid_structure,
    surface_data,
)
from symgen.fe.structure import (
    AXES,
    RIGID_MOTIONS,
    FEStructure,
    FiniteElementError,
    Integers,
    Interface,
    Material,
    NodeSet,
    interface,
    structure,
)
from symgen.fe.units import LENGTHS, check_material, check_plausible, known_units, sparse_in_si
from symgen.modes.cleaning import Array, fixed

Matrix: TypeAlias = sp.spmatrix | sp.sparray | ArrayLike


def read_nodes(source: ArrayLike) -> tuple[Integers, Array]:
    """Ids (n,) and positions (n, 3) [m] of a node table: rows `x y z` (ids count from 1) or `id x y z`.

    Raises FiniteElementError for anything else.
    """
    table = _table("nodes", source)
    if table.ndim != 2 or table.shape[1] not in (AXES, AXES + 1) or not len(table):
        raise FiniteElementError("nodes", f"the table has shape {table.shape}", "give rows of x y z or of id x y z")
    if table.shape[1] == AXES:
        return np.arange(1, len(table) + 1), table
    return _whole("nodes", table[:, 0]), table[:, 1:]


def read_dofs(source: int | ArrayLike, ids: Integers) -> tuple[Integers, Integers]:
    """Place of the node and component 0 ... 5 of each row of the matrices.

    `source` is 3 or 6 for so many per node, node by node; or rows `node component`, components counted from 1
    (4, 5, 6 are rotations). Raises FiniteElementError for anything else and for nodes that are not in the table.
    """
    if isinstance(source, int):
        if source not in (AXES, RIGID_MOTIONS):
            raise FiniteElementError("dofs", f"{source} per node", "give 3, 6, or a dof map")
        return np.repeat(np.arange(len(ids)), source), np.tile(np.arange(source), len(ids))
    table = _table("dofs", source)
    if table.ndim != 2 or table.shape[1] != 2:
        raise FiniteElementError("dofs", f"the dof map has shape {table.shape}", "give rows of node, component")
    node, component = _whole("dofs", table[:, 0]), _whole("dofs", table[:, 1])
    place = {int(name): k for k, name in enumerate(ids)}
    unknown = sorted({int(name) for name in node if int(name) not in place})
    if unknown or component.min(initial=1) < 1 or component.max(initial=1) > RIGID_MOTIONS:
        problem = f"nodes {unknown[:5]} are not in the node table" if unknown else "a component is not 1 ... 6"
        raise FiniteElementError("dofs", problem, "give the map that belongs to the matrices and to this node table")
    return np.array([place[int(name)] for name in node], dtype=np.int64), component - 1


def _table(item: str, source: ArrayLike) -> Array:
    try:
        return np.asarray(source, dtype=np.float64)
    except (TypeError, ValueError) as error:
        remedy = "give an array; np.loadtxt and scipy.io.mmread read files"
        raise FiniteElementError(item, "not a table of numbers", remedy) from error


def _matrix(item: str, source: Matrix) -> sp.csr_matrix:
    found: Any = source if sp.issparse(source) else _table(item, source)
    if found.ndim != 2:
        raise FiniteElementError(item, f"has the shape {found.shape}", "give a square matrix")
    return sp.csr_matrix(found)


def _whole(item: str, values: Sequence[float] | Array) -> Integers:
    numbers = np.asarray(values, dtype=np.float64)
    if not np.all(np.isfinite(numbers)) or np.any(numbers != np.round(numbers)):
        raise FiniteElementError(item, "an id or a count is not a whole number", "check the columns of the table")
    return numbers.astype(np.int64)


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
    try:
        point = np.asarray(value, dtype=np.float64)
    except (TypeError, ValueError, OverflowError, RecursionError):
        point = np.zeros(0)
    if point.shape != (AXES,) or not np.all(np.isfinite(point)):
        raise FiniteElementError(item, f"{shown_value(value)} is not a point", "give x, y, z in metres")
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


MATERIAL = Kind(lambda value: isinstance(value, Material), "give a Material(E, nu, rho), such as STEEL")


@dataclass(frozen=True, eq=False)
class FlexibleBody:
    """Deformation u = Phi q_f of a finite-element model (Eqs. 15-20), the shapes mass-orthonormal.

    structure: the model the modes are those of.  interfaces, markers: by name.  integrals: about `origin` (3,) [m].
    statics: static solutions of the free body, by a factor that is kept.
    """

    structure: FEStructure
    interfaces: Mapping[str, Interface]
    markers: Mapping[str, Marker]
    mode_set: str
    origin: Array
    modes: ModeSet
    integrals: InertiaIntegrals
    statics: FreeStatics
    stiffening: StressStiffening | None = None

    @classmethod
    @arguments()
    def from_matrices(
        cls,
        K: Matrix,
        M: Matrix,
        nodes: ArrayLike,
        *,
        dofs: int | ArrayLike = 3,
        units: str = "SI",
        **choices: Any,
    ) -> FlexibleBody:
        """Build it from stiffness and mass of the body without supports; `symgen.fe.read_matrix` reads them.

        Parameters
        ----------
        K, M : matrix, shape (n, n)
            Stiffness [N/m] and mass [kg], sparse or dense.
        nodes : array_like, shape (k, 3) or (k, 4)
            Rows `x y z` or `id x y z` [m].
        dofs : int or array_like, shape (n, 2)
            3 or 6 per node, node by node; or rows `node component` as of `symgen.fe.read_dof_map`.
        units : {"SI", "mm-t-s", "mm-kg-s"}
            Of K, M and nodes. Other lengths among the choices are in metres.
        **choices
            Those of `from_structure`.

        Returns
        -------
        FlexibleBody
            With its modes and integrals.

        Raises
        ------
        FiniteElementError
            As `from_structure`; for matrices and tables that do not belong together.
        """
        ids, positions = read_nodes(nodes)
        node, component = read_dofs(dofs, ids)
        pair = [_matrix("stiffness", K), _matrix("mass", M)]
        if known_units(units) != "SI":
            pair = [sparse_in_si(one, component >= AXES, units) for one in pair]
            positions = positions * LENGTHS[units]
        return cls.from_structure(structure(pair[0], pair[1], ids, positions, node, component), **choices)

    @classmethod
    def from_reduced(
        cls,
        K: Any,
        M: Any,
        *,
        interface: Mapping[str, ArrayLike],
        modes: int | None = None,
        recovery: Mapping[str, Any] | None = None,
        origin: str | ArrayLike = (0.0, 0.0, 0.0),
        rho_psi: ArrayLike | None = None,
        psi_psi: ArrayLike | None = None,
        units: str = "SI",
    ) -> ReducedBody:
        """Build it from reduced matrices (Craig-Bampton, a superelement) of a body without supports.

        Parameters
        ----------
        K, M : matrix, shape (n, n)
            Rows: six motions of each interface node in the order of `interface`, then the modal coordinates.
        interface : mapping of str to array_like, shape (3,)
            Name and place of each interface node.
        modes : int, optional
            How many free modes are kept, all n - 6 where left out.
        recovery : mapping, optional
            Name to the stress xx yy zz yz xz xy per reduced coordinate, (6, n), or to {"position": ..., "stress": ...}.
        origin : str or array_like, shape (3,)
            Of the body's frame: an interface or a place.
        rho_psi, psi_psi : array_like, shapes (n, 3, 3) and (n, n, 3, 3), optional
            [a, i, j] = int rho_i psi_a,j dm about the origin and [a, b, i, j] = int psi_a,i psi_b,j dm of the reduced
            shapes psi, which K and M do not say; without them a warning says what is left out.
        units : {"SI", "mm-t-s", "mm-kg-s"}
            Of everything here.

        Returns
        -------
        ReducedBody
            `fields()` for `Scene.flexible`, `frequencies`.

        Raises
        ------
        FiniteElementError
            Where rigid motions of the interfaces strain the body, where not six motions are free of strain, and for
            wrong sizes.

        References
        ----------
        R. R. Craig, M. C. C. Bampton, Coupling of substructures for dynamic analyses, AIAA J. 6 (1968) 1313-1319.
        """
        return reduced_body(
            K,
            M,
            interface=interface,
            modes=modes,
            recovery=recovery,
            origin=origin,
            rho_psi=rho_psi,
            psi_psi=psi_psi,
            units=units,
        )

    @classmethod
    def from_file(
        cls,
        path: str | Path,
        *,
        material: Material,
        interface: Mapping[str, str | NodeSet],
        units: str = "SI",
        order: int = 2,
        **choices: Any,
    ) -> FlexibleBody:
        """Build it from a mesh file, read by meshio (extra `files`).

        Parameters
        ----------
        path : str or Path
            `.inp` (Abaqus, CalculiX), `.bdf` (Nastran), `.msh` (Gmsh), `.vtu`, `.med`: tetrahedra or hexahedra, linear
            or quadratic. Elements of 20 nodes get nodes in their faces and middle, their edges stay as they are.
        material : Material
            In SI, whatever the file holds.
        interface : mapping
            Name to the name of a node or element set of the file, or as in `from_structure`.
        units : {"SI", "mm-t-s", "mm-kg-s"}
            Of the places in the file. Lengths among the choices are in metres.
        order : {1, 2}
            Of the elements on a linear mesh; quadratic meshes have 2.
        **choices
            Those of `from_structure`.

        Returns
        -------
        FlexibleBody
            With its modes and integrals.

        Raises
        ------
        FiniteElementError
            For other elements, by name and number; for sets that are not there; for files that cannot be read.
        """
        if not isinstance(material, Material):
            raise FiniteElementError(
                "material", f"{material!r} is not a material", "give Material(E, nu, rho) in SI, or STEEL"
            )
        found = FileMesh(path, units)
        return cls.from_mesh(
            found.mesh,
            material,
            order=2 if found.quadratic else order,
            interface=interface_of(found, interface),
            **choices,
        )

    @classmethod
    @arguments(material=MATERIAL)
    def from_mesh(cls, mesh: Any, material: Material, *, order: int = 2, **choices: Any) -> FlexibleBody:
        """Build it from a mesh of scikit-fem.

        Parameters
        ----------
        mesh : MeshTet, MeshHex or LineMesh
            Places [m]; node ids count from 0, vertices of the mesh first.
        material : Material
            In SI units.
        order : {1, 2}
            Of the elements of a solid.
        **choices
            Those of `from_structure`.

        Returns
        -------
        FlexibleBody
            With its modes and integrals.

        Raises
        ------
        FiniteElementError
            As `from_structure`; for other meshes.
        """
        check_material(material)
        body = frame_structure(mesh, material) if isinstance(mesh, LineMesh) else solid_structure(mesh, material, order)
        return cls.from_structure(body, **choices)

    @classmethod
    @arguments(interface=BY_NAME, marker_positions=BY_NAME, progress=CALLED)
    def from_structure(
        cls,
        body: FEStructure,
        *,
        interface: Mapping[str, NodeSet],
        modes: int,
        mode_set: str = "free",
        fixed: Sequence[str] = (),
        mass: str = "consistent",
        origin: str | ArrayLike = (0.0, 0.0, 0.0),
        marker_positions: Mapping[str, ArrayLike] | None = None,
        stiffening: bool = False,
        static: Sequence[str] = (),
        progress: Callable[[float, float], None] | bool | None = None,
    ) -> FlexibleBody:
        """Build it from a checked FEStructure.

        Parameters
        ----------
        body : FEStructure
            Stiffness, mass and nodes.
        interface : mapping of str to node set
            Named node sets (ids, or a function of all positions); each becomes a marker.
        modes : int
            Number of modes; for "fixed_interface" of the normal modes beside the constraint modes.
        mode_set : {"free", "fixed_interface", "mixed"}
            Free modes; those of Craig and Bampton; or modes with the interfaces `fixed` held.
        fixed : sequence of str
            Interfaces that are held, for "mixed".
        mass : {"consistent", "lumped"}
            The mass matrix.
        origin : str or array_like, shape (3,)
            Of the body's frame: the name of an interface or a point [m]; the axes are those of the mesh.
        marker_positions : mapping, optional
            Where a marker is [m], if not at the mean of its nodes; it moves with their average.
        stiffening : bool
            Whether to find the geometric stiffness by the stresses of accelerations, rates and interface
            forces; of meshes.
        static : sequence of str
            Loads whose static shapes are modes beside the others: "weight_x", "turn_x", "spin_x" and so on, or
            the name of an interface for the six loads there.
        progress : bool or callable, optional
            True shows how far the factorisation of the stiffness is; a function is called with (done, all), in
            thousand million operations.

        Returns
        -------
        FlexibleBody
            With its modes and integrals.

        Raises
        ------
        FiniteElementError
            For sets that are empty or unknown, for modes that the structure does not have, and for a structure whose
            factor does not fit into memory, before it is computed.

        Notes
        -----
        Modes and integrals are those of Eqs. 15-20.

        References
        ----------
        R. R. Craig, M. C. C. Bampton, Coupling of substructures for dynamic analyses, AIAA J. 6 (1968) 1313-1319.
        """
        if progress is True:
            with Meter("stiffness", counted="thousand million operations") as meter:
                return cls.from_structure(
                    body, interface=interface, modes=modes, mode_set=mode_set, fixed=fixed, mass=mass, origin=origin,
                    marker_positions=marker_positions, stiffening=stiffening, static=static, progress=meter,
                )  # fmt: skip
        check_choices(mode_set, mass, fixed)
        body = lumped(body) if mass == "lumped" else body
        parts = interfaces_of(body, interface, marker_positions or {})
        for name in fixed:
            known_choice("fixed", name, tuple(parts))
        statics = FreeStatics(body, progress or None)
        check_free_body(statics)
        if mode_set == "free":
            found = free_modes(statics, modes)
        elif mode_set == "mixed":
            found = mixed_modes(statics, [parts[name] for name in fixed], modes)
        else:
            found = fixed_interface_modes(statics, list(parts.values()), modes)
        at = origin_of(origin, parts)
        if static:
            found = with_static_shapes(body, found, static, parts, at)
        markers = {name: marker_of(part, found.shapes, at) for name, part in parts.items()}
        bent = None
        if stiffening:
            held = found.elastic if mode_set == "mixed" else statics.supported
            bent = stress_stiffening(body, found.shapes, at, list(parts.values()), held)
        integrals = inertia_integrals(body, found.shapes, at)
        check_plausible(integrals.mass, float(np.ptp(body.positions, axis=0).max()))
        return cls(body, parts, markers, mode_set, at, found, integrals, statics, bent)

    @property
    def nf(self) -> int:
        """Number of modes."""
        return len(self.modes.eigenvalues)

    @cached_property
    def check(self) -> RigidCheck:
        """What says that it is one free body."""
        return rigid_check(self.statics, float(self.frequencies[0]) if self.mode_set == "free" and self.nf else None)

    @property
    def frequencies(self) -> Array:
        """Frequencies of the modes [Hz], (nf,)."""
        return np.sqrt(self.modes.eigenvalues) / (2.0 * np.pi)

    @arguments(gauges=BY_NAME)
    def fields(
        self, damping_ratio: float | Sequence[float] = 0.0, surface: int = 0, gauges: Gauges | None = None
    ) -> dict[str, Any]:
        """Collect plain numbers and lists for `Scene.flexible`.

        Parameters
        ----------
        damping_ratio : float or sequence of float
            Of all modes, or of each [1].
        surface : int
            How many triangles of its surface go with it at most, for pictures; 0: none.
        gauges : mapping, optional
            Where the stress of a solid is known: name to a place [m] from the origin, shape (3,), or to the id
            of a node.

        Returns
        -------
        dict
            Fields of `Scene.flexible`: M_ff = 1 [kg], K_ff = omega^2 [N/m] and D_ff = 2 zeta omega [N s/m] are
            diagonal.

        Raises
        ------
        FiniteElementError
            For a ratio that is negative, a wrong number of ratios, and gauges that are no places or on a body
            without known stresses.

        Notes
        -----
        The integrals are those of Eqs. 15-20.
        """
        looks, values = self.surface(surface) if surface else {}, self.modes.eigenvalues
        found = modal_fields(self.integrals, values, self.markers, self.stiffening, damping_ratio, looks)
        found |= {"struts": self.struts} if self.struts else {}
        if gauges is not None:
            found["gauges"] = gauge_fields(self.statics, self.modes, self.origin, self.interfaces, gauges)
        return found

    @cached_property
    def struts(self) -> list[dict[str, Any]]:
        """Loads [N] at which the body buckles between two interfaces; none where the elements are not known.

        markers: their names; held: in place at both; first, second: clamped at this one only.
        """
        return struts(self.statics, self.modes.shapes, list(self.interfaces.values()))

    def surface(self, max_triangles: int = 20_000) -> dict[str, Array]:
        """Find the boundary of a solid, with shapes and stresses.

        Parameters
        ----------
        max_triangles : int
            How many triangles it has at most.

        Returns
        -------
        dict of str to np.ndarray
            vertices (n, 3) [m], triangles (m, 3), shapes (n, 3, nf), stresses (n, 6, nf) xx yy zz yz xz xy
            [Pa], per unit of q_f.

        Raises
        ------
        FiniteElementError
            For a body that is not made from a solid mesh.
        """
        body = self.structure
        shapes, faces = body.nodal(self.modes.shapes, 0), body.facets
        found = surface_data(body.positions, shapes, faces, self.origin, max_triangles)
        return {**found, "stresses": self.stresses().at(found["vertices"]).astype(np.float32)}

    def stresses(self) -> ModalStresses:
        """Find the stress tensors per unit of q_f inside the elements of a solid.

        Returns
        -------
        ModalStresses
            `von_mises(q_f)` [Pa] of the coordinates of a motion.

        Raises
        ------
        FiniteElementError
            For a body that is not made from a solid mesh.
        """
        return modal_stresses(self.structure, self.modes.shapes, self.origin)

    def equilibrium_stresses(self, at: ArrayLike | None = None) -> EquilibriumStresses:
        """Prepare stresses by the forces of a motion: `of(solution.body_motion("rod"))`.

        Parameters
        ----------
        at : array_like, shape (m, 3), optional
            Places [m] from the origin, as of `stresses().at`; points in the elements if left out.

        Returns
        -------
        EquilibriumStresses
            By mode acceleration with inertia relief.

        Raises
        ------
        FiniteElementError
            For a body that is not made from a solid mesh.
        """
        return equilibrium_stresses(self.statics, self.modes.shapes, self.origin, self.interfaces, at)

    def section_forces(self) -> EquilibriumForces:
        """Prepare section forces of a frame by the forces of a motion, line by line.

        Returns
        -------
        EquilibriumForces
            `of(solution.body_motion("frame"))` by mode acceleration with inertia relief; `of_modes(q_f)`, the
            sum of modal forces.

        Raises
        ------
        FiniteElementError
            For a body that is not made from a LineMesh.
        """
        return equilibrium_forces(self.statics, self.modes.shapes, self.origin, self.interfaces)

    def losses(self) -> list[FlexibilityLoss]:
        """Compare the static flexibility of the modes with that of the full model at each interface.

        Returns
        -------
        list of FlexibilityLoss
            First with the body free ("mixed": held as its modes are), then with the first interface held.
        """
        parts = list(self.interfaces.values())
        losses = flexibility_losses(self.structure, self.modes, parts, None)
        if self.mode_set == "mixed":
            return losses
        return losses + flexibility_losses(self.structure, self.modes, parts, parts[0])

    def report(self) -> str:
        """Report frequencies, effective modal masses, what truncation loses and the check of rigid modes.

        Returns
        -------
        str
            In Markdown.
        """
        body, modes = self.structure, self.modes
        held = (np.sqrt(modes.held_eigenvalues) / (2.0 * np.pi), effective_masses(body, modes.held_shapes))
        title = f"{body.n_dof} degrees of freedom, {self.nf} modes ({self.mode_set}), {self.integrals.mass:.6g} kg"
        return body_report(
            title,
            self.frequencies,
            effective_masses(body, modes.shapes),
            held if self.mode_set == "fixed_interface" else None,
            self.losses(),
            self.check,
            self.origin,
            {name: marker.position for name, marker in self.markers.items()},
        )
