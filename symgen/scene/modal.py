"""A flexible body given by its modal matrices and its shape functions at named points (Eq. 16-20)."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Annotated, Any, Literal

import numpy as np
from numpy.typing import NDArray
from pydantic import Field, ValidationInfo, field_validator

from symgen.scene.bodies import Position
from symgen.schema.fields import (
    MARKER_ANGLE,
    Bound,
    Fault,
    Flag,
    Matrix,
    Meaning,
    N,
    Name,
    Quantity,
    StrictModel,
    Vector,
    components_fault,
    size,
    size_faults,
)


def _zeros(rows: int) -> Any:
    """A default of ``rows`` rows of nf zeros (rows = 0: one vector; rows < 0: nf rows)."""

    def make(data: dict[str, Any]) -> Any:
        nf = len(data["M_ff"])
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
    foreshortening: Foreshortening | None = None
    free: Flag = False
    markers: dict[Name, ModalMarker] = Field(default_factory=dict)

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
