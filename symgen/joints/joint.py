"""What a joint type is: its fields in a scene, its equations, its coordinates, what it carries and how it is drawn.

All who treat joints ask this record; none asks for a joint's type.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal, NamedTuple, Protocol

from runtime.contract.records import ConstraintKind, CoordinateKind, JointDrawing
from symgen.joints.friction import Friction
from symgen.schema.errors import did_you_mean
from symgen.schema.fields import SPATIAL, Bound, Fault, MarkerRef, Meaning, Name, Quantity, StrictModel, about

X, Y, Z = 0, 1, 2


@dataclass(frozen=True)
class Turn:
    """A turn about an axis of the frame reached so far; `name`: its coordinate, the angle [rad].

    damping: the field with its viscous damping [N m s/rad]; lead: the field with the travel along the axis of a whole
    turn [m].
    """

    axis: int
    name: str
    damping: str = ""
    lead: str = ""
    kind: ClassVar[CoordinateKind] = "angle"


@dataclass(frozen=True)
class Slide:
    """A slide along an axis of the frame reached so far; `name`: its coordinate, the travel [m].

    damping: the field with its viscous damping [N s/m].
    """

    axis: int
    name: str
    damping: str = ""
    lead: ClassVar[str] = ""
    kind: ClassVar[CoordinateKind] = "position"


class Motor(StrictModel):
    """A rotor on the body of marker a, about the axis of the joint: its inertia [kg m^2] and the turns of it, against
    that body, for a turn of the joint (for a slide: radians a metre). The body's own inertia is without it."""

    inertia: Annotated[Quantity, Meaning("inertia of the rotor about its axis", "kg m^2", Bound.NON_NEGATIVE)]
    ratio: Annotated[Quantity, Meaning("turns of the rotor for a turn of the joint", "1 or rad/m")] = 1.0


class Equation(NamedTuple):
    """A constraint row C = 0: its label within the joint, what it measures (its unit), C, and C as pages say it."""

    label: str
    kind: ConstraintKind
    C: Any
    text: str = ""


class AxisPair(NamedTuple):
    """Axes of marker a and of marker b that stay perpendicular: the row b . a = 0 with its label."""

    label: str
    of_a: int
    of_b: int


PARALLEL = (AxisPair("parallel_x", X, Z), AxisPair("parallel_y", Y, Z))  # z_b along z_a
ALIGNED = (*PARALLEL, AxisPair("twist", Y, X))  # all axes of b along those of a


class InPlane(Protocol):
    """SymPy symbols of two planar markers: d = r_b - r_a, unit vectors t_a along and n_a across marker a's x-axis."""

    d: Sequence[Any]
    t_a: Sequence[Any]
    n_a: Sequence[Any]
    phi_a: Any
    phi_b: Any

    def dot(self, u: Sequence[Any], v: Sequence[Any]) -> Any:
        """u . v."""

    def field(self, name: str) -> Any:
        """A quantity of the joint: a constant, or a function of t where its scope is Scope.TIME."""


class InSpace(Protocol):
    """SymPy symbols of two spatial markers: d = r_b - r_a, their axes x, y, z; travel: along the axes of marker a."""

    d: Sequence[Any]
    a: Sequence[Sequence[Any]]
    b: Sequence[Sequence[Any]]
    travel: Sequence[Any]

    def dot(self, u: Sequence[Any], v: Sequence[Any]) -> Any:
        """u . v."""

    def cos_sin(self, angle: Any) -> tuple[Any, Any]:
        """Cosine and sine."""

    def field(self, name: str) -> Any:
        """A quantity of the joint: a constant, or a function of t where its scope is Scope.TIME."""


class Surroundings(Protocol):
    """What a joint, a coupling or a load asks of its scene to check itself."""

    @property
    def space(self) -> str:
        """ "planar" or "spatial"."""

    @property
    def bodies(self) -> Sequence[Any]:
        """In scene order."""

    @property
    def joints(self) -> Sequence[Joint]:
        """In scene order."""

    def placing(self) -> set[str]:
        """Names of the joints that have coordinates in q."""

    def joint_of(self, coordinate: str) -> tuple[Joint, Turn | Slide]:
        """The joint and its motion behind "joint.angle"."""


Reaction = Literal["force", "moment", "force and moment"]


class Joint(StrictModel):
    """A joint between two markers (Eq. 21). Its file sets the fields `type` and those of its own, and of the following
    what does not stand here already.

    equation: its rows in the plane as pages say them; with it goes `rows_in_plane`.
    points, perpendicular: its rows in space: where point b stays (on point a, on marker a's z-axis, in its xy-plane),
    and axes that stay perpendicular. A joint with other rows overrides `rows_in_space`.
    motions: in space b is displaced from a by these turns and slides, one after the other, which are the joint's
    coordinates where it places a body; X(q), S(q) and its rate follow from them. None: it places no body.
    drives: the name of the coordinate of another joint between the same markers that it prescribes.
    on_beam: are its rows those of a point on the bent line of the beam of marker a?
    at_a, at_b: what it puts on the bodies there, in the plane as in space; a moment not about axes it turns freely on.
    drawing: what pictures show.
    """

    name: Name
    marker_a: Annotated[MarkerRef, about('marker a, `"body.marker"`')]
    marker_b: Annotated[MarkerRef, about('marker b, `"body.marker"`')]
    if TYPE_CHECKING:
        type: Any  # of each file: its name in scenes

    equation: ClassVar[str] = ""
    points: ClassVar[Literal["together", "on_axis", "in_plane"] | None] = None
    perpendicular: ClassVar[tuple[AxisPair, ...]] = ()
    motions: ClassVar[tuple[Turn | Slide, ...] | None] = None
    drives: ClassVar[str] = ""
    on_beam: ClassVar[bool] = False
    at_a: ClassVar[Reaction] = "force and moment"
    at_b: ClassVar[Reaction] = "force and moment"
    drawing: ClassVar[JointDrawing] = "pivot"

    @property
    def markers(self) -> dict[str, str]:
        """The markers that it names, by field."""
        return {"marker_a": self.marker_a, "marker_b": self.marker_b}

    @classmethod
    def rows_in_plane(cls, m: InPlane) -> list[Equation]:
        """Rows between two planar markers; none: the joint exists in space only."""
        return []

    @classmethod
    def rows_in_space(cls, m: InSpace) -> list[Equation]:
        """Rows between two spatial markers; none: the joint needs coordinates, it can close no loop."""
        rows = []
        if cls.points == "together":
            rows = together(m)
        elif cls.points == "on_axis":
            rows = [Equation(f"across_{'xy'[k]}", "distance", m.dot(m.a[k], m.d), f"{'xy'[k]}_a.(r_b - r_a)")
                    for k in (X, Y)]  # fmt: skip
        elif cls.points == "in_plane":
            rows = [Equation("normal", "distance", m.dot(m.a[Z], m.d), "z_a.(r_b - r_a)")]
        return rows + [
            Equation(label, "direction", m.dot(m.b[j], m.a[i]), f"{'xyz'[j]}_b.{'xyz'[i]}_a")
            for label, i, j in cls.perpendicular
        ]

    def faults(self, scene: Any) -> Iterator[Fault]:
        """A type that the plane does not have, a name that coordinates of a body have."""
        if scene.space == "planar" and not self.planar():
            yield Fault("type", f"a {self.type} joint needs three dimensions", SPATIAL)
        if scene.space == "spatial" and any(body.name == self.name for body in scene.bodies):
            remedy = "rename one of them: joints of a spatial scene have coordinates too"
            yield Fault("", "has the name of a body", remedy)
        for key in ("limits", "backlash", "friction"):
            if (part := getattr(self, key, None)) is not None:
                yield from part.faults(scene)
                yield from self._angle_faults(key, scene)
        if (friction := self.rubs()) is not None:
            yield from friction.lever_faults(any(motion.kind == "angle" for motion in self.motions or ()))

    def rubs(self) -> Friction | None:
        """The friction of its one free direction, which the types have that leave one free."""
        return getattr(self, "friction", None)

    def rigid_ends(self) -> list[str]:
        """Ends of its way that are rigid stops: lower, upper."""
        limits = getattr(self, "limits", None)
        given = ("lower", "upper") if limits is not None and limits.rigid else ()
        return [key for key in given if getattr(limits, key) is not None]

    def _angle_faults(self, key: str, scene: Surroundings) -> Iterator[Fault]:
        """Of what needs a coordinate of its own, where the joint closes a loop in space."""
        turns = any(motion.kind == "angle" for motion in self.motions or ())
        if scene.space == "spatial" and turns and self.name not in scene.placing():
            remedy = "put the joint nearer to the ground, or another joint of the loop where this one is"
            yield Fault(key, "the joint closes a loop and has no angle of its own", remedy)

    @classmethod
    def planar(cls) -> bool:
        """May it stand in a planar scene?"""
        return bool(cls.equation)

    @classmethod
    def closes_loops(cls) -> bool:
        """Has it rows in space that need no coordinate of its own?"""
        own_rows = cls.rows_in_space.__func__ is not Joint.rows_in_space.__func__  # type: ignore[attr-defined]
        return own_rows or cls.points is not None

    @classmethod
    def is_ball(cls) -> bool:
        """Does it hold a point of b and nothing else, so that b turns with an angular velocity of its own?"""
        return cls.points == "together" and not cls.perpendicular

    @classmethod
    def row_quantities(cls) -> list[str]:
        """The fields that its rows are written in: quantities that no motion takes."""
        taken = {key for motion in cls.motions or () for key in (motion.damping, motion.lead)}
        fields = cls.model_fields.items()
        return [
            key for key, field in fields if key not in taken and any(isinstance(m, Meaning) for m in field.metadata)
        ]

    @classmethod
    def turn_at(cls, side: Literal["marker_a", "marker_b"]) -> Turn | None:
        """The turn about an axis of the marker there, if the joint has one."""
        turns = [motion for motion in cls.motions or () if isinstance(motion, Turn)]
        return turns[0 if side == "marker_a" else -1] if turns else None

    @classmethod
    def motion_of(cls, name: str) -> Turn | Slide:
        """The motion with this coordinate. Raises KeyError."""
        return {motion.name: motion for motion in cls.motions or ()}[name]

    @classmethod
    def relative(cls) -> bool:
        """Are its motions those about and along one axis of marker a, whether it has coordinates for them or not?"""
        motions = cls.motions or ()
        return len({motion.axis for motion in motions}) == 1 and not any(motion.lead for motion in motions)


def together(m: InSpace) -> list[Equation]:
    """r_b - r_a is the travel along the axes of marker a: none for a joint that has no slide."""
    a, travel = m.a, m.travel
    return [
        Equation(
            label,
            "distance",
            m.d[i] - travel[0] * a[X][i] - travel[1] * a[Y][i] - travel[2] * a[Z][i],
            f"(r_b - r_a)_{label}",
        )
        for i, label in enumerate("xyz")
    ]


def beam_faults(key: str, name: str, scene: Surroundings, moving: bool = False) -> Iterator[Fault]:
    """Of a body that is not a beam, or not one on which something can move."""
    body = next((one for one in scene.bodies if one.name == name), None)
    beams = [one.name for one in scene.bodies if one.type == "beam"]
    if body is None or body.type != "beam":
        what = "there is no body" if body is None else "is not a beam: body"
        yield Fault(key, f"{what} '{name}'", did_you_mean(name, beams) if beams else "add a body of type beam")
    elif moving and body.stiffening:
        yield Fault(key, f"'{name}' shortens as it bends", "take no stiffening: it is not known along the beam")
