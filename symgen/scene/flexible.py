"""A spatial flexible body given by its modal matrices and shape integrals, as symgen.fe gives it (Eqs. 15-20)."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import Field

from symgen.scene.bodies import MarkerDirections, Orientation
from symgen.scene.gauges import StressGauge
from symgen.scene.struts import FlexibleStrut
from symgen.scene.surface import FlexibleSurface
from symgen.schema.fields import Bound, Flag, Matrix, Meaning, Name, Number, Quantity, StrictModel

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
