"""A flexible body given by its modal matrices and its shape functions at named points (Eq. 16-20)."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import Field, ValidationInfo, field_validator

from symgen.scene.bodies import Position
from symgen.schema.fields import MARKER_ANGLE, Bound, Flag, Matrix, Meaning, Name, Quantity, StrictModel, Vector


def _zeros(rows: int) -> Any:
    """A default of ``rows`` rows of nf zeros (rows = 0: one vector; rows < 0: nf rows)."""

    def make(data: dict[str, Any]) -> Any:
        nf = len(data["M_ff"])
        zero = (0.0,) * nf
        return zero if rows == 0 else (zero,) * (nf if rows < 0 else rows)

    return Field(default_factory=make)


class ModalMarker(StrictModel):
    """A point of a modal body: rho = position + Phi q_f, marker angle = theta + angle + slope.q_f.

    position [m]; angle [rad]; shape_x, shape_y: the rows of Phi at the point, nf each; slope: nf;
    foreshortening: H at the point, nf x nf, or none. Shapes left out are zero.
    """

    position: Position = (0.0, 0.0)
    angle: Annotated[Quantity, MARKER_ANGLE] = 0.0
    shape_x: Annotated[Vector, Meaning("shape functions at the point, x", "m per unit of q_f")] = ()
    shape_y: Annotated[Vector, Meaning("shape functions at the point, y", "m per unit of q_f")] = ()
    slope: Annotated[Vector, Meaning("rotation of the marker per unit of q_f", "rad per unit of q_f")] = ()
    foreshortening: Annotated[Matrix | None, Meaning("H at the point", "m per unit of q_f^2")] = None

    def with_zeros(self, nf: int) -> ModalMarker:
        """The same marker with the shapes that were left out filled with nf zeros."""
        missing = [key for key in ("shape_x", "shape_y", "slope") if not getattr(self, key)]
        return self.model_copy(update={key: (0.0,) * nf for key in missing})


class Foreshortening(StrictModel):
    """Integrals of the foreshortening matrix: H [int H dm] and xH [int x H dm], nf x nf each."""

    H: Annotated[Matrix, Meaning("int H dm", "kg m per unit of q_f^2")]
    xH: Annotated[Matrix, Meaning("int x H dm", "kg m^2 per unit of q_f^2")]


class ModalBody(StrictModel):
    """A flexible body with given modal mass, stiffness, damping and inertia shape integrals (Eq. 20).

    mass [kg]; first_moment: int rho0 dm [kg m]; inertia: int |rho0|^2 dm [kg m^2], about the frame origin;
    M_ff, K_ff, D_ff: nf x nf; phi_integral: 2 x nf, int Phi dm; rho_dot_phi: nf, int rho0.Phi dm;
    rho_cross_phi: nf, int (x Phi_y - y Phi_x) dm; phi_cross_phi: nf x nf, skew,
    int (Phi_x,a Phi_y,b - Phi_y,a Phi_x,b) dm. Integrals left out are zero.
    """

    type: Literal["modal"] = "modal"
    name: Name
    mass: Annotated[Quantity, Meaning("mass", "kg", Bound.POSITIVE)]
    first_moment: Annotated[tuple[Quantity, Quantity], Meaning("int rho0 dm", "kg m")] = (0.0, 0.0)
    inertia: Annotated[Quantity, Meaning("int |rho0|^2 dm about the frame origin", "kg m^2", Bound.NON_NEGATIVE)]
    M_ff: Annotated[Matrix, Meaning("modal mass matrix", "kg m^2 per unit of q_f^2")]
    K_ff: Annotated[Matrix, Meaning("modal stiffness matrix", "N m per unit of q_f^2")]
    D_ff: Annotated[Matrix | None, Meaning("modal damping matrix", "N m s per unit of q_f^2")] = None
    phi_integral: Annotated[Matrix, Meaning("int Phi dm, 2 x nf", "kg m per unit of q_f")] = _zeros(2)
    rho_dot_phi: Annotated[Vector, Meaning("int rho0.Phi dm", "kg m^2 per unit of q_f")] = _zeros(0)
    rho_cross_phi: Annotated[Vector, Meaning("int (x Phi_y - y Phi_x) dm", "kg m^2 per unit of q_f")] = _zeros(0)
    phi_cross_phi: Annotated[Matrix, Meaning("int (Phi_x Phi_y - Phi_y Phi_x) dm, skew", "kg m^2")] = _zeros(-1)
    foreshortening: Foreshortening | None = None
    free: Flag = False
    markers: dict[Name, ModalMarker] = Field(default_factory=dict)

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
