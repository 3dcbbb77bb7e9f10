"""A spatial flexible body given by its modal matrices and shape integrals, as symgen.fe gives it (Eqs. 15-20).

What a finite-element body bears between two of its markers before it buckles.

Gauges: places of a finite-element body whose stress is known.

The surface of a flexible body for pictures: triangles that move with the modes, and their stresses.

A linear structure without bodies: M x'' + D x' + K x = F(t) (Eq. 3-14).

A flexible body given by its modal matrices and its shape functions at named points (Eq. 16-20).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Annotated, Any, Literal

import numpy as np
from numpy.typing import NDArray
from pydantic import BeforeValidator, Field, ValidationInfo, field_validator

from runtime.contract.records import packed, unpacked
from symgen.scene.appearance import MOST_TRIANGLES
from symgen.scene.bodies import MARKERS, Free, MarkerDirections, Orientation, Position, orientation_fault
from symgen.schema.errors import did_you_mean
from symgen.schema.fields import (
    MARKER_ANGLE,
    Bound,
    Fault,
    Matrix,
    Meaning,
    N,
    Name,
    Number,
    Quantity,
    Scope,
    StrictModel,
    Vector,
    about,
    components_fault,
    refuse,
    size,
    size_faults,
)


def _zeros(rows: int) -> Any:
    """A default of ``rows`` rows of nf zeros (rows = 0: one vector; rows < 0: nf rows)."""

    def make(data: dict[str, Any]) -> Any:
        nf = len(data.get("M_ff", ()))  # pydantic before 2.12 asks for it though M_ff is missing or wrong
        zero = (0.0,) * nf
        return zero if rows == 0 else (zero,) * (nf if rows < 0 else rows)

    return Field(default_factory=make)


SYMMETRIC, POSITIVE = size(N, N, form="symmetric"), size(N, N, form="positive")
SEMIDEFINITE, SKEW = size(N, N, form="semidefinite"), size(N, N, form="skew")
NO_MODES = Fault("M_ff", "the body has no modes", "give M_ff and K_ff, or describe a rigid body")


class ModalMarker(StrictModel):
    """A point of a modal body: rho = position + Phi q_f, marker angle = theta + angle + slope.q_f.

    position [m]; angle [rad]; shape_x, shape_y: the rows of Phi at the point, nf each; slope: nf;
    foreshortening: H at the point, nf x nf, or none. Shapes left out are zero.
    """

    position: Position = (0.0, 0.0)
    angle: Annotated[Quantity, MARKER_ANGLE] = 0.0
    shape_x: Annotated[Vector, Meaning("shape functions at the point, x", "m per unit of q_f"), size(N)] = ()
    shape_y: Annotated[Vector, Meaning("shape functions at the point, y", "m per unit of q_f"), size(N)] = ()
    slope: Annotated[Vector, Meaning("rotation of the marker per unit of q_f", "rad per unit of q_f"), size(N)] = ()
    foreshortening: Annotated[Matrix | None, Meaning("H at the point", "m per unit of q_f^2"), SYMMETRIC] = None

    def faults(self, scene: Any) -> Iterator[Fault]:
        """Components of its position."""
        yield from components_fault("position", self.position, scene)

    def with_zeros(self, nf: int) -> ModalMarker:
        """The same marker with the shapes that were left out filled with nf zeros."""
        missing = [key for key in ("shape_x", "shape_y", "slope") if not getattr(self, key)]
        return self.model_copy(update={key: (0.0,) * nf for key in missing})


class Foreshortening(StrictModel):
    """Integrals of the foreshortening matrix: H [int H dm] and xH [int x H dm], nf x nf each."""

    H: Annotated[Matrix, Meaning("int H dm", "kg m per unit of q_f^2"), SYMMETRIC]
    xH: Annotated[Matrix, Meaning("int x H dm", "kg m^2 per unit of q_f^2"), SYMMETRIC]


class ModalBody(StrictModel):
    """A flexible body with given modal mass, stiffness, damping and inertia shape integrals (Eq. 20).

    mass [kg]; first_moment: int rho0 dm [kg m]; inertia: int |rho0|^2 dm [kg m^2], about the frame origin;
    M_ff, K_ff, D_ff: nf x nf; phi_integral: 2 x nf, int Phi dm; rho_dot_phi: nf, int rho0.Phi dm;
    rho_cross_phi: nf, int (x Phi_y - y Phi_x) dm; phi_cross_phi: nf x nf, skew,
    int (Phi_x,a Phi_y,b - Phi_y,a Phi_x,b) dm. Integrals left out are zero.
    """

    references = (
        "A. A. Shabana, Dynamics of Multibody Systems, 5th ed., Cambridge University Press, 2020, chapter 5.",
    )
    type: Literal["modal"] = "modal"
    name: Name
    mass: Annotated[Quantity, Meaning("mass", "kg", Bound.POSITIVE)]
    first_moment: Annotated[tuple[Quantity, Quantity], Meaning("int rho0 dm", "kg m")] = (0.0, 0.0)
    inertia: Annotated[Quantity, Meaning("int |rho0|^2 dm about the frame origin", "kg m^2", Bound.NON_NEGATIVE)]
    M_ff: Annotated[Matrix, Meaning("modal mass matrix", "kg m^2 per unit of q_f^2"), POSITIVE]
    K_ff: Annotated[Matrix, Meaning("modal stiffness matrix", "N m per unit of q_f^2"), SEMIDEFINITE]
    D_ff: Annotated[Matrix | None, Meaning("modal damping matrix", "N m s per unit of q_f^2"), SEMIDEFINITE] = None
    phi_integral: Annotated[Matrix, Meaning("int Phi dm, 2 x nf", "kg m per unit of q_f"), size(2, N)] = _zeros(2)
    rho_dot_phi: Annotated[Vector, Meaning("int rho0.Phi dm", "kg m^2 per unit of q_f"), size(N)] = _zeros(0)
    rho_cross_phi: Annotated[Vector, Meaning("int (x Phi_y - y Phi_x) dm", "kg m^2 per unit of q_f"), size(N)] = _zeros(
        0
    )
    phi_cross_phi: Annotated[Matrix, Meaning("int (Phi_x Phi_y - Phi_y Phi_x) dm, skew", "kg m^2"), SKEW] = _zeros(-1)
    foreshortening: Annotated[Foreshortening | None, about("integrals of second order for geometric stiffening")] = None
    free: Free = False
    markers: Annotated[
        dict[Name, ModalMarker], about(f"{MARKERS}; each has a position [m] and its shape functions")
    ] = Field(default_factory=dict)

    def faults(self, scene: Any) -> Iterator[Fault]:
        """Sizes that do not fit its modes."""
        if scene.space == "spatial":
            yield Fault("type", "a modal body is planar", 'use type = "flexible" in a spatial scene')
        if self.nf == 0:
            yield NO_MODES
        yield from size_faults(self, self.nf)

    def mass_matrix(self, number: Callable[[Any], NDArray[np.float64]]) -> NDArray[np.float64]:
        """The (3 + nf) x (3 + nf) mass matrix of Eq. 20 at theta = 0, q_f = 0; number: of quantities."""
        mass, inertia, moment_x, moment_y = number((self.mass, self.inertia, *self.first_moment))
        matrix = np.zeros((3 + self.nf, 3 + self.nf))
        matrix[:3, :3] = [[mass, 0, -moment_y], [0, mass, moment_x], [-moment_y, moment_x, inertia]]
        matrix[:2, 3:] = number(self.phi_integral)
        matrix[2, 3:] = number(self.rho_cross_phi)
        matrix[3:, :3] = matrix[:3, 3:].T
        matrix[3:, 3:] = number(self.M_ff)
        return matrix

    @property
    def nf(self) -> int:
        """Number of elastic coordinates: the order of M_ff."""
        return len(self.M_ff)

    @field_validator("markers")
    @classmethod
    def _fill_shapes(cls, markers: dict[str, ModalMarker], info: ValidationInfo) -> dict[str, ModalMarker]:
        if "M_ff" not in info.data:
            return markers
        nf = len(info.data["M_ff"])
        return {name: marker.with_zeros(nf) for name, marker in markers.items()}

    def implicit_markers(self) -> dict[str, ModalMarker]:
        """The frame's origin, which the deformation does not move."""
        return {"origin": ModalMarker().with_zeros(self.nf)}


Load = Annotated[Number, Field(gt=0)]


class FlexibleStrut(StrictModel):
    """Critical loads [N] along the line between two markers, as FlexibleBody.fields gives them.

    held: both markers are held in place; first, second: this one is clamped, the other free. Left out: no such load.
    """

    markers: tuple[Name, Name]
    held: Load | None = None
    first: Load | None = None
    second: Load | None = None


Rows = tuple[tuple[Number, ...], ...]
ALL_GAUGES = "all"
COMPONENTS = ("xx", "yy", "zz", "yz", "xz", "xy")  # rows of all arrays


class StressGauge(StrictModel):
    """Stress at a place of a flexible body, in its axes, as FlexibleBody.fields(gauges=...) gives it.

    position [m]; shapes (6 x nf): xx yy zz yz xz xy [Pa] per unit of q_f; fields (6 x (9 + 9 nf)) and forces (6 x 6 for
    each interface, by its marker): per unit of each cause of runtime.contract.flexible, or left out. error_shapes
    (r x nf), error_fields, error_forces (r x ...): rows [Pa] whose sum has the length of the error of the mesh.
    """

    position: tuple[Number, Number, Number] = (0.0, 0.0, 0.0)
    shapes: Rows
    fields: Rows = ()
    forces: dict[Name, Rows] = Field(default_factory=dict)
    error_shapes: Rows = ()
    error_fields: Rows = ()
    error_forces: dict[Name, Rows] = Field(default_factory=dict)

    def misfits(self, name: str, body: SpatialModalBody) -> Iterator[Fault]:
        """What does not fit its body; name: its own."""
        nf, markers = body.nf, list(body.markers)
        remedy = "take what FlexibleBody.fields(gauges=...) gives for these modes"
        if name == ALL_GAUGES:
            yield Fault("", f"'{name}' stands for all gauges", "give it another name")
        wide = {".shapes": (self.shapes, nf), ".fields": (self.fields, 9 + 9 * nf)}
        for key, (rows, columns) in wide.items():
            if (rows or key == ".shapes") and not _six_rows(rows, columns):
                yield Fault(key, f"is not 6 x {columns}, for {nf} modes", remedy)
        for marker, rows in self.forces.items():
            if marker not in markers:
                yield Fault(".forces", f"body '{body.name}' has no marker '{marker}'", did_you_mean(marker, markers))
            if not _six_rows(rows, len(COMPONENTS)):
                yield Fault(f".forces.{marker}", "is not 6 x 6", remedy)
        yield from self._error_misfits(nf, remedy)

    def _error_misfits(self, nf: int, remedy: str) -> Iterator[Fault]:
        if any(len(row) != nf for row in self.error_shapes):
            yield Fault(".error_shapes", f"has rows that are not {nf} long", remedy)
        causes = {"error_fields": (self.error_fields, 9 + 9 * nf)}
        causes |= {f"error_forces.{marker}": (rows, len(COMPONENTS)) for marker, rows in self.error_forces.items()}
        for key, (rows, columns) in causes.items():
            if len(rows) != len(self.error_fields) or any(len(row) != columns for row in rows):
                yield Fault(f".{key}", f"is not {len(self.error_fields)} x {columns}", remedy)
        if self.error_fields and (lacking := sorted(set(self.forces) - set(self.error_forces))):
            yield Fault(".error_forces", f"has no rows of '{lacking[0]}', which forces has", remedy)


def _six_rows(rows: Rows, columns: int) -> bool:
    return len(rows) == len(COMPONENTS) and all(len(row) == columns for row in rows)


REMEDY = "take what FlexibleBody.surface gives"


def _as_text(kind: str) -> Any:
    """Arrays and lists of numbers as packed text, as a scene file holds them; text is seen to hold numbers."""

    def text(value: object) -> str:
        try:
            numbers = unpacked(value, kind) if isinstance(value, str) else np.asarray(value, dtype=kind)
        except (TypeError, ValueError, OverflowError):
            raise refuse("is neither numbers nor their packed text", REMEDY) from None
        if not np.isfinite(numbers).all():
            raise refuse("holds numbers that are not finite", REMEDY)
        return packed(numbers, kind)

    return BeforeValidator(text)


Numbers = Annotated[str, _as_text("<f4")]
Places = Annotated[str, _as_text("<i4")]


class FlexibleSurface(StrictModel):
    """Arrays, kept as text (base64 of float32 and int32): vertices (n, 3) [m] in the body frame; triangles (m, 3),
    places of vertices; shapes (n, 3, nf) per unit of q_f; stresses (n, 6, nf), xx yy zz yz xz xy [Pa] per unit of
    q_f, or left out where they are not known.
    """

    vertices: Numbers
    triangles: Places
    shapes: Numbers
    stresses: Numbers = ""

    def fault(self, nf: int) -> str:
        """What does not fit a body with nf modes; "" if all does."""
        sizes = {key: len(unpacked(getattr(self, key))) for key in ("vertices", "shapes", "stresses")}
        places, n = unpacked(self.triangles, "<i4"), sizes["vertices"] // 3
        if sizes["vertices"] != 3 * n or sizes["shapes"] != 3 * n * nf or sizes["stresses"] not in (0, 6 * n * nf):
            return f"vertices, shapes and stresses hold {list(sizes.values())} numbers, for {nf} modes"
        if n > 3 * MOST_TRIANGLES:
            return f"vertices are {n}, more than the corners of {MOST_TRIANGLES} triangles"
        if len(places) % 3 or not 3 <= len(places) <= 3 * MOST_TRIANGLES:
            return f"triangles hold {len(places)} places: three for each, of 1 to {MOST_TRIANGLES} triangles"
        if places.min() < 0 or places.max() >= n:
            return f"triangles name vertices from {places.min()} to {places.max()} of {n}"
        return ""


class Structure(StrictModel):
    """Coordinates x (n names) and the matrices mass, damping, stiffness (n x n); force: n entries."""

    coordinates: tuple[Name, ...]
    mass: Annotated[Matrix, Meaning("mass matrix", "kg"), POSITIVE]
    damping: Annotated[Matrix | None, Meaning("damping matrix", "N s/m"), size(N, N)] = None
    stiffness: Annotated[Matrix, Meaning("stiffness matrix", "N/m"), SYMMETRIC]
    force: Annotated[Vector | None, Meaning("force", "N", scope=Scope.TIME), size(N)] = None

    def faults(self, scene: Any) -> Iterator[Fault]:
        """Sizes that do not fit its coordinates."""
        names = self.coordinates
        if not names:
            yield Fault("coordinates", "is empty", "name at least one coordinate")
        for index, name in enumerate(names):
            if name in names[:index]:
                yield Fault(f"coordinates[{index}]", f"'{name}' appears twice", "rename one of them")
        yield from size_faults(self, len(names))


Block = tuple[tuple[Number, Number, Number], tuple[Number, Number, Number], tuple[Number, Number, Number]]
Point = Annotated[tuple[Quantity, Quantity, Quantity], Meaning("position in the body frame, (x, y, z)", "m")]


class FlexibleMarker(MarkerDirections):
    """A point of a flexible body: rho = position + shape q_f, turned by the small rotation vector rotation q_f.

    position [m]; shape, rotation: 3 x nf, or left out where the deformation does not move or turn the point.
    foreshortening: H_i at the point, 3 x nf x nf, for a displacement -1/2 q_f^T H_i q_f of second order along axis i.
    """

    position: Point = (0.0, 0.0, 0.0)
    shape: Annotated[Matrix, Meaning("shape functions at the point, 3 x nf", "m per unit of q_f"), size(3, N)] = ()
    rotation: Annotated[Matrix, Meaning("rotation of the point, 3 x nf", "rad per unit of q_f"), size(3, N)] = ()
    foreshortening: Annotated[tuple[tuple[tuple[Number, ...], ...], ...], size(3, N, N)] = ()


class FlexibleStiffening(StrictModel):
    """Second-order displacement -1/2 q_f^T H_i q_f along axis i: H[i] = int H_i dm, xH[i, j] = int x_i H_j dm, nf x nf.

    They give centrifugal and other geometric stiffness.
    """

    H: Annotated[tuple[tuple[tuple[Number, ...], ...], ...], size(3, N, N)] = ()
    xH: Annotated[tuple[tuple[tuple[tuple[Number, ...], ...], ...], ...], size(3, 3, N, N)] = ()


class SpatialModalBody(StrictModel):
    """A flexible body in space: modal mass, stiffness, damping and shape integrals over the undeformed position rho0.

    mass [kg]; first_moment: int rho0 dm [kg m]; inertia_moments: int rho0_i rho0_j dm [kg m^2], 3 x 3 about the frame
    origin; M_ff, K_ff, D_ff: nf x nf; phi_integral: int Phi dm, 3 x nf; rho_phi[a, i, j] = int rho0_i Phi_ja dm;
    phi_phi[a, b, i, j] = int Phi_ia Phi_jb dm (left out: no terms of second order in q_f in the inertia); surface: for
    pictures; gauges: where stresses are known; struts: between which markers it buckles.
    """

    references = (
        "A. A. Shabana, Dynamics of Multibody Systems, 5th ed., Cambridge University Press, 2020, chapter 5.",
    )
    type: Literal["flexible"] = "flexible"
    name: Name
    mass: Annotated[Quantity, Meaning("mass", "kg", Bound.POSITIVE)]
    first_moment: Annotated[tuple[Quantity, Quantity, Quantity], Meaning("int rho0 dm", "kg m")] = (0.0, 0.0, 0.0)
    inertia_moments: Annotated[Matrix, Meaning("int rho0_i rho0_j dm", "kg m^2"), size(3, 3, form="symmetric")]
    M_ff: Annotated[Matrix, Meaning("modal mass matrix", "kg m^2 per unit of q_f^2"), POSITIVE]
    K_ff: Annotated[Matrix, Meaning("modal stiffness matrix", "N m per unit of q_f^2"), SEMIDEFINITE]
    D_ff: Annotated[Matrix | None, Meaning("modal damping matrix", "N m s per unit of q_f^2"), SEMIDEFINITE] = None
    phi_integral: Annotated[Matrix, Meaning("int Phi dm, 3 x nf", "kg m per unit of q_f"), size(3, N)] = ()
    rho_phi: Annotated[
        tuple[Block, ...], size(N), about("int rho0_i Phi_ja dm as [a, i, j], nf x 3 x 3 [kg m^2 per unit of q_f]")
    ] = ()
    phi_phi: Annotated[
        tuple[tuple[Block, ...], ...],
        size(N, N),
        about(
            "int Phi_ia Phi_jb dm as [a, b, i, j], nf x nf x 3 x 3 [kg m^2 per unit of q_f^2]; "
            "left out: no terms of second order in q_f in the inertia"
        ),
    ] = ()
    stiffening: Annotated[FlexibleStiffening | None, about("integrals of second order for geometric stiffening")] = None
    orientation: Orientation = "euler_parameters"
    free: Free = False
    surface: Annotated[
        FlexibleSurface | None, about("triangles for pictures, as `FlexibleBody.surface` gives them")
    ] = None
    gauges: Annotated[
        dict[Name, StressGauge], about("places where stresses are known, as `FlexibleBody.fields` gives them")
    ] = Field(default_factory=dict)
    struts: Annotated[
        tuple[FlexibleStrut, ...], about("loads at which it buckles, as `FlexibleBody.fields` gives them")
    ] = ()
    markers: Annotated[
        dict[Name, FlexibleMarker], about(f"{MARKERS}; each has a position [m] and its shape functions")
    ] = Field(default_factory=dict)

    def faults(self, scene: Any) -> Iterator[Fault]:
        """Sizes that do not fit its modes, and struts between markers that it does not have."""
        if self.nf == 0:
            yield NO_MODES
        yield from self.size_faults()
        yield from orientation_fault(self.orientation, scene)
        if self.surface is not None and (fault := self.surface.fault(self.nf)):
            yield Fault("surface", fault, "take what FlexibleBody.surface gives for these modes")
        for index, strut in enumerate(self.struts):
            for name in strut.markers:
                if name not in self.markers:
                    remedy = did_you_mean(name, list(self.markers))
                    yield Fault(f"struts[{index}].markers", f"there is no marker '{name}'", remedy)
        for name, gauge in self.gauges.items():
            for key, problem, remedy in gauge.misfits(name, self):
                yield Fault(f"gauges.{name}{key}", problem, remedy)

    def mass_matrix(self, number: Callable[[Any], NDArray[np.float64]]) -> NDArray[np.float64]:
        """The (6 + nf) x (6 + nf) mass matrix of Eq. 20 at q_f = 0, in body axes; number: of quantities."""
        matrix = np.zeros((6 + self.nf, 6 + self.nf))
        (x, y, z), moments = number(self.first_moment), number(self.inertia_moments)
        matrix[:3, :3] = number((self.mass,))[0] * np.eye(3)
        matrix[:3, 3:6] = -np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
        matrix[3:6, 3:6] = np.trace(moments) * np.eye(3) - moments
        if self.phi_integral:
            matrix[:3, 6:] = number(self.phi_integral)
        for a, block in enumerate(np.array(self.rho_phi, dtype=float)):
            matrix[3:6, 6 + a] = [block[1, 2] - block[2, 1], block[2, 0] - block[0, 2], block[0, 1] - block[1, 0]]
        matrix[3:, :3], matrix[6:, 3:6] = matrix[:3, 3:].T, matrix[3:6, 6:].T
        matrix[6:, 6:] = number(self.M_ff)
        return matrix

    def size_faults(self) -> Iterator[Fault]:
        """Matrices whose sizes do not fit its modes."""
        yield from size_faults(self, self.nf)

    @property
    def nf(self) -> int:
        """Number of elastic coordinates: the order of M_ff."""
        return len(self.M_ff)

    def implicit_markers(self) -> dict[str, Any]:
        """The frame's origin, which the deformation does not move."""
        return {"origin": FlexibleMarker()}
