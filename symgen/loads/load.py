"""What a load type is: its fields in a scene, what it does, where it acts and how it is drawn.

All who treat loads ask this record; none asks for a load's type.
"""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, ClassVar, Protocol

from symgen.joints.joint import Reaction, Surroundings
from symgen.schema.fields import Name, StrictModel

Row = dict[int, Any]  # by column of q
At = Any  # a marker's motion in the plane or in space: r, r_dot in world axes, and what `Acting` knows to read
Vector = Sequence[Any]  # two or three components in world axes, or one moment in the plane and three in space


@dataclass(frozen=True)
class LinearSpring:
    """A spring and damper on the deflection row . q [rad]: stiffness [N m/rad] and damping [N m s/rad]."""

    row: Row
    stiffness: Any
    damping: Any


@dataclass(frozen=True)
class LoadEffect:
    """Generalised force by system column [N, N m]; potential [J]; dissipated and applied power [W] (Q_F of Eq. 20).

    spring: what of it is linear in the coordinates, if it is that.
    action: force [N] and moment [N m] in world axes on the load's marker, or on marker b: x, y and about z in a plane,
    three and three in space.
    along: of a load along a beam, see `LoadRecord`; beyond: of the part of it beyond a fraction of the length the force
    in world axes [N].
    touching: of a contact its normal force, the size of its friction [N], and the speed apart of what touches [m/s].
    size: of a load that `Load.directed` names a direction of, the signed force [N] or moment [N m] in it.
    """

    force: Row = field(default_factory=dict)
    potential: Any = 0
    dissipated: Any = 0
    applied: Any = 0
    spring: LinearSpring | None = None
    action: Sequence[Any] = ()
    along: tuple[float, ...] = ()
    beyond: Callable[[float], Vector] | None = None
    size: Any = None
    touching: Sequence[Any] = ()


@dataclass(frozen=True)
class Scalar:
    """A scalar of the motion that a force or a torque works on: value, rate = row . q', rows over q.

    axis: of the force or moment of unit size that works on it, at marker b, in world axes; turning: is it a moment?
    """

    value: Any
    rate: Any
    row: Row
    axis: Vector
    rotation: bool


class Acting(Protocol):
    """What a load is written in: SX of its quantities and of markers, the same in the plane and in space."""

    def value(self, key: str, **local: Any) -> Any:
        """An expression of the load, or its components; local: names that it may use besides those of the scene."""

    def constant(self, key: str) -> Any:
        """A quantity of the load that stays as it is, or its components."""

    def marker(self, reference: str) -> At:
        """A marker of the scene."""

    def pair(self, a: str, b: str) -> tuple[Any, Any]:
        """Two markers of which only the motion between them counts."""

    def along(self, marker: At, components: Vector) -> Vector:
        """The vector with these components along a marker's axes."""

    def z(self, marker: At) -> Vector:
        """A marker's z-axis, about which moments turn."""

    def spin(self, marker: At) -> Vector:
        """Angular velocity."""

    def dot(self, u: Vector, v: Vector) -> Any:
        """u . v."""

    def part_of_beam(self, beam: str, power: int, start: float, end: float) -> tuple[Any, At]:
        """(integral of s^power ds, its mean point) over a part of a beam, in fractions of the length."""

    def stations(self, beam: str, start: float, end: float) -> list[tuple[Any, Any, At]]:
        """(s, weight ds, point) by which an integral over a part of a beam is exact for its shapes."""

    def frame_of(self, beam: str) -> At:
        """The frame of a beam, which does not bend."""

    def place_on(self, beam: str, place: Any) -> tuple[Any, At]:
        """(is it on the beam? 1 or 0, point) at `place` [m] from the start; the ends stop steps where they can."""

    def beyond(self, beam: str, place: Any, at: float) -> Any:
        """1 where `place` [m] is beyond the fraction `at` of the length, else 0."""

    def symbol(self, name: str) -> Any:
        """A variable."""

    def coefficients(self, values: Vector, variable: Any) -> Sequence[Vector] | None:
        """Of 1, s, s^2, ... up to the sixth power, where the values are a polynomial of the variable s; else None."""

    def at_value(self, values: Vector, variable: Any, value: Any) -> Vector:
        """The values where the variable has this value."""

    def larger(self, a: Any, b: float) -> Any:
        """The larger of two."""

    def push(self, depth: Any, rate: Any, exponent: float) -> Any:
        """What the load's `stiffness` and `damping` do against a depth with its rate: force, stored [J], lost [W]."""

    def generalised(self, *acting: tuple[At, Vector, Vector]) -> Row:
        """By column: of forces and of moments at markers, each empty where there is none."""

    def action(self, force: Vector = (), moment: Vector = ()) -> Sequence[Any]:
        """Force and moment as `LoadEffect.action` has them."""

    def coordinate(self, name: str) -> Scalar:
        """A coordinate of a joint, "joint.angle", whether it is one of q or not."""

    def angle(self, a: str, b: str) -> Scalar:
        """Of marker b about marker a's z-axis: that of the joint between them, or else one between -pi and pi."""

    def spring(self, a: At, b: At, stiffness: Any, damping: Any, free_length: Any) -> Any:
        """Along the line from a to b: force on b [N], potential [J], dissipated [W]."""

    def rate(self, value: Any) -> Any:
        """Derivative in time along the motion, of what depends on q alone."""

    def by_q(self, value: Any) -> Row:
        """Derivatives by q."""

    def by_rates(self, value: Any) -> Row:
        """Derivatives by q'."""


class Load(StrictModel):
    """A load. Its file sets the fields `type` and those of its own, `effect`, and of the following what differs.

    carries: what it puts on the bodies at its markers.
    shown_as: the load type of which records, pictures and pages show it; its own if empty.
    directed: what a force or moment of positive size does, of a load with a line or an axis of its own.
    """

    name: Name
    if TYPE_CHECKING:
        type: Any  # of each file: its name in scenes

    carries: ClassVar[Reaction] = "force and moment"
    shown_as: ClassVar[str] = ""
    directed: ClassVar[str] = ""

    @abstractmethod
    def effect(self, m: Acting) -> LoadEffect:
        """Generalised force, energies and powers."""

    @property
    def markers(self) -> dict[str, str]:
        """The markers that it names, by field."""
        named = {key: getattr(self, key, None) for key in ("marker", "marker_a", "marker_b", "reaction")}
        return {key: reference for key, reference in named.items() if reference is not None}

    @property
    def acts_at(self) -> list[str]:
        """What it acts at, as pages say it."""
        return list(self.markers.values())

    def record(self, scene: Surroundings) -> tuple[str, dict[str, str]]:
        """As which type it is shown, and at which markers."""
        return self.shown_as or self.type, self.markers

    def reaction_kind(self, scene: Surroundings) -> Reaction:
        """What it puts on bodies, which may depend on the joint that it acts on."""
        return self.carries

    def drives(self, coordinate: str) -> bool:
        """Does it act on this coordinate of a joint, about which that joint is then not free?"""
        return False


def on(scalar: Scalar, m: Acting, value: Any, **powers: Any) -> LoadEffect:
    """A force or torque `value` on a scalar of the motion."""
    row = {column: value * entry for column, entry in scalar.row.items()}
    acting = [value * component for component in scalar.axis]
    action = m.action(moment=acting) if scalar.rotation else m.action(force=acting)
    return LoadEffect(row, action=action, size=value, **powers)
