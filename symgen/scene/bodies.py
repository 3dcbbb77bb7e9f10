"""Ground, rigid bodies and uniform beams, with their markers (Eq. 15-20), planar or spatial."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, Any, ClassVar, Literal

import numpy as np
from pydantic import Field, Strict

from symgen.scene.appearance import Shapes
from symgen.schema.fields import (
    MARKER_ANGLE,
    SPATIAL,
    Bound,
    Fault,
    Flag,
    Inertia,
    Meaning,
    Name,
    Number,
    Quantity,
    StrictModel,
    about,
    components_fault,
)

LATERAL_ENDS = Literal[
    "pinned-pinned", "clamped-free", "free-free", "clamped-pinned", "clamped-clamped", "free-clamped", "pinned-free",
    "free-pinned", "welded-welded", "welded-pinned", "pinned-welded", "welded-heavy",
]  # fmt: skip
AXIAL_ENDS = Literal["fixed-free", "free-free", "fixed-fixed", "free-fixed", "fixed-loaded"]
LIGHT = "its modes need inertia: give a small density (1e-6 does no harm), or a link that is a rigid body with mass = 0"
ALONG = 1.0 - 1e-9  # an axis this much along the body's x-axis takes the body's z-axis for its x-axis
Modes = Annotated[int, Strict(), Field(ge=1, le=500)]
Elements = Annotated[int, Strict(), Field(ge=1, le=1000)]
Position = Annotated[tuple[Quantity, ...], Meaning("position in the body frame, (x, y) or (x, y, z)", "m")]
Products = Annotated[tuple[Quantity, ...], Meaning("entries xy, xz, yz of the inertia tensor", "kg m^2")]
Direction = tuple[Number, Number, Number]
TWISTING = {
    "shear_modulus": "give the shear modulus, E / (2 (1 + nu)) of an isotropic material",
    "torsion_constant": "give the torsion constant of the section",
}
Orientation = Annotated[
    Literal["euler_parameters", "xyz", "xzy", "yxz", "yzx", "zxy", "zyx", "xyx", "xzx", "yxy", "yzy", "zxz", "zyz"],
    about("spatial: a sequence of axes if the body's Euler angles are wanted as input and output"),
]
Free = Annotated[Flag, about("whether it stands without a joint on purpose, so that none is asked for")]
MARKERS = 'points by name, which joints, loads and measures refer to as `"body.marker"`'
PICTURED = about("how pictures show it, instead of rods between its markers: boxes, cylinders, spheres, meshes")


class MarkerDirections(StrictModel):
    """How a marker is turned in its body: by ``angle`` [rad] in a planar scene, by its axes in a spatial one.

    axis: direction of the marker's z-axis in the body frame, of any length; x_axis: a direction in its xz-plane, on the
    side of its x-axis (left out: the body's x-axis, or its z-axis where axis is along x).
    """

    angle: Annotated[Quantity, MARKER_ANGLE] = 0.0
    axis: Direction = (0.0, 0.0, 1.0)
    x_axis: Direction | None = None

    def faults(self, scene: Any) -> Iterator[Fault]:
        """Components of its position, and directions that its space does not have or that are none."""
        if (position := getattr(self, "position", None)) is not None:
            yield from components_fault("position", position, scene)
        z, x = self.axis, self.x_axis
        if scene.space == "planar":
            if z != (0.0, 0.0, 1.0) or x is not None:
                remedy = 'give angle, or set space = "spatial"'
                yield Fault("axis", "a planar marker is turned by its angle", remedy)
            return
        if self.angle != 0:
            yield Fault("angle", "a spatial marker is turned by its axes", "give axis and x_axis")
        if all(entry == 0 for entry in z):
            yield Fault("axis", "has no direction", "give a vector that is not zero")
        elif x is not None:
            cross = (z[1] * x[2] - z[2] * x[1], z[2] * x[0] - z[0] * x[2], z[0] * x[1] - z[1] * x[0])
            size = max(abs(entry) for entry in z) * max(abs(entry) for entry in x)
            if max(abs(entry) for entry in cross) <= 1e-9 * size:
                yield Fault("x_axis", "is along the axis, or zero", "give a direction across it")

    def own_axes(self) -> np.ndarray:
        """Columns: the marker's x-, y- and z-axis in the body frame (3 x 3, a rotation)."""
        z = _unit(np.array(self.axis))
        beside = (1.0, 0.0, 0.0) if abs(z[0]) < ALONG else (0.0, 0.0, 1.0)
        x = np.array(beside if self.x_axis is None else self.x_axis)
        x = _unit(x - (x @ z) * z)
        found = np.column_stack([x, np.cross(z, x), z])
        found[np.abs(found) < 1e-15] = 0.0
        return found


def _unit(vector: np.ndarray) -> np.ndarray:
    scaled = vector / np.abs(vector).max()
    return np.asarray(scaled / np.linalg.norm(scaled))


def quaternion_of(R: np.ndarray) -> np.ndarray:
    """Euler parameters e0 ... e3 of a rotation matrix, e0 not negative: the column of largest norm of 4 e e^T."""
    t, a = np.trace(R), [R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]]
    whole = np.zeros((4, 4))
    whole[0, 0], whole[0, 1:], whole[1:, 0] = 1 + t, a, a
    whole[1:, 1:] = R + R.T + (1 - t) * np.eye(3)
    column = whole[:, int(np.argmax(np.diag(whole)))]
    found = column / np.linalg.norm(column) * (1.0 if column[0] >= 0 else -1.0)
    found[np.abs(found) < 1e-15] = 0.0
    return np.asarray(found)


class RigidMarker(MarkerDirections):
    """A point and directions on the ground or on a rigid body. position [m]."""

    example: ClassVar[str] = "{position = [0.5, 0.0]}"

    position: Position = (0.0, 0.0)


def orientation_fault(orientation: str, scene: Any) -> Iterator[Fault]:
    """Angles of a body in the plane, which has one."""
    if scene.space == "planar" and orientation != "euler_parameters":
        yield Fault("orientation", "a planar body is oriented by its angle theta", "remove it")


class GroundBody(StrictModel):
    """The fixed frame. A scene has one even when it does not mention it."""

    type: Literal["ground"] = "ground"
    name: Literal["ground"] = "ground"
    markers: Annotated[
        dict[Name, RigidMarker], about(f"{MARKERS}; each has a position [m] and an angle [rad], or axes in space")
    ] = Field(default_factory=dict)
    shape: Annotated[Shapes, PICTURED] = ()

    @property
    def nf(self) -> int:
        """Number of elastic coordinates: none."""
        return 0

    def implicit_markers(self) -> dict[str, RigidMarker]:
        """The marker every ground has."""
        return {"origin": RigidMarker()}


class RigidBody(StrictModel):
    """A rigid body with coordinates R_o, theta of its frame.

    mass [kg]; inertia [kg m^2] about the centre of mass: one number in a planar scene, the entries xx, yy, zz of the
    inertia tensor in a spatial one, where products are its entries xy, xz, yz; center_of_mass [m] in the body frame.
    orientation (spatial): a sequence of axes if the body's Euler angles are wanted as input and output.
    ``free = true`` says that no joint is intended. shape: how pictures show it, in place of rods between its markers.
    ``as_given = true`` takes moments of inertia that no mass distribution has.
    """

    type: Literal["rigid"] = "rigid"
    name: Name
    mass: Annotated[Quantity, Meaning("mass", "kg", Bound.NON_NEGATIVE)]
    inertia: Annotated[Inertia, Meaning("moment of inertia about the centre of mass", "kg m^2", Bound.NON_NEGATIVE)]
    products: Products = (0.0, 0.0, 0.0)
    center_of_mass: Position = (0.0, 0.0)
    orientation: Orientation = "euler_parameters"
    free: Free = False
    as_given: Annotated[Flag, about("whether moments of inertia that no mass distribution has are taken")] = False
    markers: Annotated[
        dict[Name, RigidMarker], about(f"{MARKERS}; each has a position [m] and an angle [rad], or axes in space")
    ] = Field(default_factory=dict)
    shape: Annotated[Shapes, PICTURED] = ()

    def faults(self, scene: Any) -> Iterator[Fault]:
        """Moments of inertia and components of the other space."""
        three = isinstance(self.inertia, tuple)
        if three != (scene.space == "spatial"):
            problem = f"a {scene.space} body has {'one moment' if three else 'three moments'} of inertia"
            remedy = "give one number" if three else "give the moments about x, y, z: [xx, yy, zz]"
            yield Fault("inertia", problem, remedy)
        if len(self.products) != 3:
            yield Fault("products", f"has {len(self.products)} entries", "give the entries xy, xz, yz")
        elif scene.space == "planar" and any(value != 0 for value in self.products):
            yield Fault("products", "a planar body has no products of inertia", "remove it")
        yield from components_fault("center_of_mass", self.center_of_mass, scene)
        yield from orientation_fault(self.orientation, scene)

    @property
    def nf(self) -> int:
        """Number of elastic coordinates: none."""
        return 0

    def implicit_markers(self) -> dict[str, RigidMarker]:
        """The frame's origin and the centre of mass."""
        return {"origin": RigidMarker(), "center": RigidMarker(position=self.center_of_mass)}


class LateralModes(StrictModel):
    """Which bending shapes are kept (Eq. 19): `modes` of them, static shapes of welded ends among them.

    ends, start first: "free", "pinned" and "clamped" are conditions of the modes; with "welded" the set holds the
    static shapes of an end that carries forces and moments; a "heavy" end has a mass as well. Left out: what the joints
    and loads at the ends ask for.
    """

    ends: LATERAL_ENDS | None = None
    modes: Modes


class AxialModes(StrictModel):
    """Which axial shapes are kept (Eq. 19): with "loaded" the static one of an end that carries a force is among them.

    ends left out: what the joints and loads at the ends ask for.
    """

    ends: AXIAL_ENDS | None = None
    modes: Modes


class TorsionModes(StrictModel):
    """Which shapes of torsion are kept: those of stretching, with angles for displacements and moments for forces.

    ends left out: what the joints and loads at the ends ask for.
    """

    ends: AXIAL_ENDS | None = None
    modes: Modes


class BeamMarker(MarkerDirections):
    """A point of a beam: ``at`` is the fraction of the length, 0 at the start, 1 at the end."""

    example: ClassVar[str] = "{at = 0.5}"

    at: Number

    def faults(self, scene: Any) -> Iterator[Fault]:
        """A place outside the beam, besides."""
        if not 0 <= self.at <= 1:
            yield Fault("at", f"{self.at} lies outside the beam", "give a fraction from 0 to 1")
        yield from super().faults(scene)


class BeamBody(StrictModel):
    """A uniform beam (Eq. 15-20).

    length [m], density [kg/m^3], area [m^2], second_moment [m^4], youngs_modulus [Pa]; damping_ratio [1] of
    all modes; with damping_frequency [rad/s] it holds there, and damping is proportional to stiffness (Rayleigh), so
    that welded pieces have the ratio of the whole. The frame lies at the start with x along the undeformed beam. q_f
    holds the lateral modes, then the axial ones. In a spatial scene second_moment and lateral are those of bending in
    the xy-plane; second_moment_z and lateral_z those of bending in the xz-plane, whose modes come between the two.
    Torsion modes, the last ones, turn the sections about x [rad], with the stiffness shear_modulus [Pa] times
    torsion_constant [m^4], without warping. Measures of stress need section_modulus [m^3] (I over the distance of the
    outermost fibre), section_modulus_z, torsion_modulus [m^3] (torque over the largest shear stress) and shear_factor,
    the largest shear stress of a shear force over its mean: 1.5 of rectangles, 4/3 of circles.
    ``stiffening`` keeps the foreshortening (geometric stiffening) terms. mesh: "exact" shapes in closed form, or in a
    plane "lumped", the paper's mesh of so many `elements` with masses at its nodes (Eqs. 15-20), a modal body then.
    """

    references = (
        "A. A. Shabana, Dynamics of Multibody Systems, 5th ed., Cambridge University Press, 2020, chapter 5.",
        "T. R. Kane, R. R. Ryan, A. K. Banerjee, Dynamics of a cantilever beam attached to a moving base, "
        "J. Guid. Control Dyn. 10 (1987) 139-151.",
    )
    type: Literal["beam"] = "beam"
    name: Name
    length: Annotated[Quantity, Meaning("length", "m", Bound.POSITIVE)]
    density: Annotated[Quantity, Meaning("density", "kg/m^3", Bound.POSITIVE, remedy=LIGHT)]
    area: Annotated[Quantity, Meaning("area of the cross-section", "m^2", Bound.POSITIVE)]
    second_moment: Annotated[Quantity, Meaning("second moment of area", "m^4", Bound.POSITIVE)]
    youngs_modulus: Annotated[Quantity, Meaning("Young's modulus", "Pa", Bound.POSITIVE)]
    lateral: Annotated[LateralModes | None, about("bending modes, in a spatial scene of the xy-plane")] = None
    second_moment_z: Annotated[
        Quantity, Meaning("second moment of area for the xz-plane", "m^4", Bound.NON_NEGATIVE)
    ] = 0.0
    lateral_z: Annotated[LateralModes | None, about("bending modes of the xz-plane (spatial)")] = None
    axial: Annotated[AxialModes | None, about("stretching modes")] = None
    shear_modulus: Annotated[Quantity, Meaning("shear modulus", "Pa", Bound.NON_NEGATIVE)] = 0.0
    torsion_constant: Annotated[Quantity, Meaning("torsion constant of the section", "m^4", Bound.NON_NEGATIVE)] = 0.0
    section_modulus: Annotated[Quantity | None, Meaning("section modulus", "m^3", Bound.POSITIVE)] = None
    section_modulus_z: Annotated[
        Quantity | None, Meaning("section modulus for the xz-plane", "m^3", Bound.POSITIVE)
    ] = None
    torsion_modulus: Annotated[Quantity | None, Meaning("section modulus of torsion", "m^3", Bound.POSITIVE)] = None
    shear_factor: Annotated[
        Quantity, Meaning("largest shear stress over its mean in the section", "1", Bound.NON_NEGATIVE)
    ] = 1.5
    torsion: Annotated[TorsionModes | None, about("torsion modes (spatial)")] = None
    stiffening: Annotated[Flag, about("whether to keep the foreshortening terms (geometric stiffening)")] = False
    damping_ratio: Annotated[Quantity, Meaning("damping ratio of all modes", "1", Bound.NON_NEGATIVE)] = 0.0
    damping_frequency: Annotated[
        Quantity | None, Meaning("frequency at which the damping ratio holds", "rad/s", Bound.POSITIVE)
    ] = None
    mesh: Annotated[
        Literal["exact", "lumped"], about("shapes in closed form, or the paper's lumped mesh (planar, Eqs. 15-20)")
    ] = "exact"
    elements: Annotated[Elements | None, about("number of elements of a lumped mesh")] = None
    orientation: Orientation = "euler_parameters"
    free: Free = False
    markers: Annotated[
        dict[Name, BeamMarker], about(f"{MARKERS}; `at` is a fraction of the length; `start` and `end` are there")
    ] = Field(default_factory=dict)

    def faults(self, scene: Any) -> Iterator[Fault]:
        """Modes that are none or too many, and shapes of the other space."""
        spatial = scene.space == "spatial"
        if self.elements is not None and self.mesh == "exact":
            yield Fault("elements", "belongs to a mesh", 'give mesh = "lumped", or leave it out')
        if self.nf == 0:
            yield Fault("", "the beam has no modes", "give lateral or axial modes, or describe it as a rigid body")
        if self.stiffening and self.lateral is None and self.lateral_z is None:
            yield Fault("stiffening", "only bending shortens a beam", "give lateral modes, or remove it")
        yield from orientation_fault(self.orientation, scene)
        if not spatial and (self.lateral_z is not None or self.second_moment_z != 0):
            yield Fault("lateral_z", "a planar beam bends in its plane only", SPATIAL)
        if spatial and self.second_moment_z == 0:
            yield Fault("second_moment_z", "is missing", "give the second moment of area for the xz-plane")
        if self.torsion is not None and not spatial:
            yield Fault("torsion", "a planar beam does not twist", SPATIAL)
        for key, remedy in TWISTING.items():
            if self.torsion is not None and spatial and getattr(self, key) == 0:
                yield Fault(key, "is missing, which torsion needs", remedy)

    @property
    def nf(self) -> int:
        """Number of elastic coordinates: lateral modes, axial modes and those of torsion."""
        sets = (self.lateral, self.lateral_z, self.axial, self.torsion)
        return sum(modes.modes for modes in sets if modes is not None)

    def implicit_markers(self) -> dict[str, BeamMarker]:
        """The two ends of the beam."""
        return {"start": BeamMarker(at=0.0), "end": BeamMarker(at=1.0)}
