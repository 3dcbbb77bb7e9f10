"""A spatial flexible body given by its modal matrices and shape integrals, as symgen.fe gives it (Eqs. 15-20).

What a finite-element body bears between two of its markers before it buckles.

Gauges: places of a finite-element body whose stress is known.

The surface of a flexible body for pictures: triangles that move with the modes, and their stresses.

A linear structure without bodies: M x'' + D x' + K x = F(t) (Eq. 3-14).
"""

from __future__ import annotations

from typing import Annotated, Any, Literal

import numpy as np
from pydantic import AfterValidator, BeforeValidator, Field

from runtime.contract.records import packed, unpacked
from symgen.scene.appearance import MOST_TRIANGLES
from symgen.scene.bodies import MarkerDirections, Orientation
from symgen.schema.fields import (
    Bound,
    Flag,
    Matrix,
    Meaning,
    Name,
    Number,
    Quantity,
    Scope,
    StrictModel,
    Vector,
    refuse,
)


def _positive(value: float) -> float:
    if value <= 0.0:
        raise refuse(f"{value:g} is not positive", "leave it out where the body does not buckle")
    return value


Load = Annotated[Number, AfterValidator(_positive)]


class FlexibleStrut(StrictModel):
    """Critical loads [N] along the line between two markers, as FlexibleBody.fields gives them.

    held: both markers are held in place; first, second: this one is clamped, the other free. Left out: no such load.
    """

    markers: tuple[Name, Name]
    held: Load | None = None
    first: Load | None = None
    second: Load | None = None


Rows = tuple[tuple[Number, ...], ...]
COMPONENTS = ("xx", "yy", "zz", "yz", "xz", "xy")  # rows of all arrays


class StressGauge(StrictModel):
    """Stress at a place of a flexible body, in its axes, as FlexibleBody.fields(gauges=...) gives it.

    position [m]; shapes (6 x nf): xx yy zz yz xz xy [Pa] per unit of q_f; fields (6 x (9 + 9 nf)) and forces (6 x 6 for
    each interface, by its marker): per unit of each cause of runtime.contract.flexible, or left out.
    """

    position: tuple[Number, Number, Number] = (0.0, 0.0, 0.0)
    shapes: Rows
    fields: Rows = ()
    forces: dict[Name, Rows] = Field(default_factory=dict)


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
    mass: Annotated[Matrix, Meaning("mass matrix", "kg")]
    damping: Annotated[Matrix | None, Meaning("damping matrix", "N s/m")] = None
    stiffness: Annotated[Matrix, Meaning("stiffness matrix", "N/m")]
    force: Annotated[Vector | None, Meaning("force", "N", scope=Scope.TIME)] = None


Block = tuple[tuple[Number, Number, Number], tuple[Number, Number, Number], tuple[Number, Number, Number]]
Point = Annotated[tuple[Quantity, Quantity, Quantity], Meaning("position in the body frame, (x, y, z)", "m")]


class FlexibleMarker(MarkerDirections):
    """A point of a flexible body: rho = position + shape q_f, turned by the small rotation vector rotation q_f.

    position [m]; shape, rotation: 3 x nf, or left out where the deformation does not move or turn the point.
    foreshortening: H_i at the point, 3 x nf x nf, for a displacement -1/2 q_f^T H_i q_f of second order along axis i.
    """

    position: Point = (0.0, 0.0, 0.0)
    shape: Annotated[Matrix, Meaning("shape functions at the point, 3 x nf", "m per unit of q_f")] = ()
    rotation: Annotated[Matrix, Meaning("rotation of the point, 3 x nf", "rad per unit of q_f")] = ()
    foreshortening: tuple[tuple[tuple[Number, ...], ...], ...] = ()


class FlexibleStiffening(StrictModel):
    """Second-order displacement -1/2 q_f^T H_i q_f along axis i: H[i] = int H_i dm, xH[i][j] = int x_i H_j dm, nf x nf.

    They give centrifugal and other geometric stiffness.
    """

    H: tuple[tuple[tuple[Number, ...], ...], ...] = ()
    xH: tuple[tuple[tuple[tuple[Number, ...], ...], ...], ...] = ()


class SpatialModalBody(StrictModel):
    """A flexible body in space: modal mass, stiffness, damping and shape integrals over the undeformed position rho0.

    mass [kg]; first_moment: int rho0 dm [kg m]; inertia_moments: int rho0_i rho0_j dm [kg m^2], 3 x 3 about the frame
    origin; M_ff, K_ff, D_ff: nf x nf; phi_integral: int Phi dm, 3 x nf; rho_phi[a][i][j] = int rho0_i Phi_ja dm;
    phi_phi[a][b][i][j] = int Phi_ia Phi_jb dm (left out: no terms of second order in q_f in the inertia); surface: for
    pictures; gauges: where stresses are known; struts: between which markers it buckles.
    """

    type: Literal["flexible"] = "flexible"
    name: Name
    mass: Annotated[Quantity, Meaning("mass", "kg", Bound.POSITIVE)]
    first_moment: Annotated[tuple[Quantity, Quantity, Quantity], Meaning("int rho0 dm", "kg m")] = (0.0, 0.0, 0.0)
    inertia_moments: Annotated[Matrix, Meaning("int rho0_i rho0_j dm", "kg m^2")]
    M_ff: Annotated[Matrix, Meaning("modal mass matrix", "kg m^2 per unit of q_f^2")]
    K_ff: Annotated[Matrix, Meaning("modal stiffness matrix", "N m per unit of q_f^2")]
    D_ff: Annotated[Matrix | None, Meaning("modal damping matrix", "N m s per unit of q_f^2")] = None
    phi_integral: Annotated[Matrix, Meaning("int Phi dm, 3 x nf", "kg m per unit of q_f")] = ()
    rho_phi: tuple[Block, ...] = ()
    phi_phi: tuple[tuple[Block, ...], ...] = ()
    stiffening: FlexibleStiffening | None = None
    orientation: Orientation = "euler_parameters"
    free: Flag = False
    surface: FlexibleSurface | None = None
    gauges: dict[Name, StressGauge] = Field(default_factory=dict)
    struts: tuple[FlexibleStrut, ...] = ()
    markers: dict[Name, FlexibleMarker] = Field(default_factory=dict)

    @property
    def nf(self) -> int:
        """Number of elastic coordinates: the order of M_ff."""
        return len(self.M_ff)

    def implicit_markers(self) -> dict[str, Any]:
        """The frame's origin, which the deformation does not move."""
        return {"origin": FlexibleMarker()}
