"""From a joint type's rows to C, C_q, C_t and gamma in the quantities of its markers (Eqs. 21-27), in SymPy.

Holonomic constraints, their constraint Jacobian C_q and gamma, what is quadratic in the rates.

A joint type states only its rows C = 0. In the plane the direction t_a = (cos phi_a, sin phi_a) of marker a and its
normal n_a turn with phi_a. In space an axis turns with its marker: its virtual change is pi x axis, its rate
omega x axis; axis rates are symbols of their own, which keeps second derivatives short. The chain to the coordinates
of bodies is the markers' business.

The relative (joint) coordinates of a joint that places a body: X(q), the motion subspace S(q) and its rate, from its
motions.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cache

import casadi as ca
import sympy as sp

from symgen.algebra.rows import Row
from symgen.algebra.scalar import ZERO, add, dot, mul, neg
from symgen.algebra.template import Rules, Template, derivative
from symgen.algebra.vectors import Vector, cross, identity, minus, plus, scaled, zeros
from symgen.bodies.spatial_body import SpatialMarker
from symgen.joints.joint import Equation, Joint, Slide, Turn, together
from symgen.schema.fields import Scope

Symbols = tuple[sp.Expr, sp.Expr, sp.Expr]
AXES = "xyz"


@dataclass(frozen=True)
class JointTemplate:
    """Rows of a joint type, in the plane or in space.

    Outputs of row k: C_k; C_k_<slot> for the slots of the markers; C_t_k; drift_k, the second time derivative of C_k
    with all marker accelerations zero, so that gamma_k = -drift_k - C_slot . bias of the markers.
    fields: the quantities of the joint in them, each with the symbols of its value, rate and acceleration.
    """

    rows: tuple[Equation, ...]
    template: Template
    fields: dict[str, tuple[sp.Symbol, sp.Symbol, sp.Symbol]]


@dataclass
class _Markers:
    """What the rows of a joint type are written in."""

    joint: type[Joint] | None
    fields: dict[str, tuple[sp.Symbol, sp.Symbol, sp.Symbol]] = field(default_factory=dict)

    def dot(self, u: Sequence[sp.Expr], v: Sequence[sp.Expr]) -> sp.Expr:
        """u . v."""
        return sp.Add(*(p * q for p, q in zip(u, v, strict=True)))

    def field(self, name: str) -> sp.Symbol:
        """A quantity of the joint."""
        if name not in self.fields:
            letter = f"f{len(self.fields) or ''}"
            value, rate, acceleration = sp.symbols(f"{letter} {letter}_t {letter}_tt")
            self.fields[name] = value, rate, acceleration
        return self.fields[name][0]

    def motion(self) -> dict[sp.Symbol, sp.Expr]:
        """Time derivatives of the quantities that depend on time."""
        rules: dict[sp.Symbol, sp.Expr] = {}
        for name, (value, rate, acceleration) in self.fields.items():
            if self.joint is not None and self.joint.meaning(name).scope is Scope.TIME:
                rules |= {value: rate, rate: acceleration}
        return rules


# ---- the plane -----------------------------------------------------------------------------------------------

r_a = sp.symbols("r_a_x r_a_y")
r_b = sp.symbols("r_b_x r_b_y")
t_a = sp.symbols("t_a_x t_a_y")
phi_a, phi_b = sp.symbols("phi_a phi_b")
r_a_dot = sp.symbols("r_a_dot_x r_a_dot_y")
r_b_dot = sp.symbols("r_b_dot_x r_b_dot_y")
phi_a_dot, phi_b_dot = sp.symbols("phi_a_dot phi_b_dot")
PLANAR_SLOTS = ("r_a_x", "r_a_y", "r_b_x", "r_b_y", "phi_a", "phi_b")
_TURN_A = {t_a[0]: -t_a[1], t_a[1]: t_a[0], phi_a: sp.Integer(1)}


@dataclass
class PlanarMarkers(_Markers):
    """See `symgen.joints.joint.InPlane`."""

    d: Sequence[sp.Expr] = (r_b[0] - r_a[0], r_b[1] - r_a[1])
    t_a: Sequence[sp.Expr] = t_a
    n_a: Sequence[sp.Expr] = (-t_a[1], t_a[0])
    phi_a: sp.Expr = phi_a
    phi_b: sp.Expr = phi_b


@cache
def planar_template(joint: type[Joint]) -> JointTemplate:
    """The template of a joint type in the plane; slots as in PLANAR_SLOTS."""
    markers = PlanarMarkers(joint)
    rows = tuple(joint.rows_in_plane(markers))
    motion = markers.motion()
    rates = {
        **dict(zip(r_a, r_a_dot, strict=True)),
        **dict(zip(r_b, r_b_dot, strict=True)),
        **{symbol: rate * phi_a_dot for symbol, rate in _TURN_A.items()},
        phi_b: phi_b_dot,
        **motion,
    }
    outputs: dict[str, sp.Expr] = {}
    for k, row in enumerate(rows):
        outputs[f"C_{k}"] = row.C
        for slot, symbol in zip(PLANAR_SLOTS, (*r_a, *r_b), strict=False):
            outputs[f"C_{k}_{slot}"] = sp.diff(row.C, symbol)
        outputs[f"C_{k}_phi_a"] = derivative(row.C, _TURN_A)
        outputs[f"C_{k}_phi_b"] = sp.diff(row.C, phi_b)
        outputs[f"C_t_{k}"] = derivative(row.C, motion)
        outputs[f"drift_{k}"] = sp.expand(derivative(derivative(row.C, rates), rates))
    return JointTemplate(rows, Template(outputs), markers.fields)


# ---- space ---------------------------------------------------------------------------------------------------


def _vector(name: str) -> Symbols:
    x, y, z = sp.symbols(f"{name}_x {name}_y {name}_z")
    return x, y, z


VECTORS = {
    name: _vector(name) for name in ("r_a", "r_b", "r_a_dot", "r_b_dot", "omega_a", "omega_b", "travel", "travel_dot")
}
AXES_OF = {f"{axis}_{marker}": _vector(f"{axis}_{marker}") for marker in "ab" for axis in AXES}
AXIS_RATES = {name: _vector(f"{name}_dot") for name in AXES_OF}


@dataclass
class SpatialMarkers(_Markers):
    """See `symgen.joints.joint.InSpace`."""

    d: Sequence[sp.Expr] = tuple(q - p for p, q in zip(VECTORS["r_a"], VECTORS["r_b"], strict=True))
    a: Sequence[Sequence[sp.Expr]] = tuple(AXES_OF.values())[:3]
    b: Sequence[Sequence[sp.Expr]] = tuple(AXES_OF.values())[3:]
    travel: Sequence[sp.Expr] = VECTORS["travel"]

    def cos_sin(self, angle: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
        """Cosine and sine."""
        return sp.cos(angle), sp.sin(angle)

    def rates(self) -> Rules:
        """Time derivatives with all accelerations zero."""
        rules = self.motion()
        for name in ("r_a", "r_b", "travel"):
            rules |= dict(zip(VECTORS[name], VECTORS[f"{name}_dot"], strict=True))
        for name, axis in AXES_OF.items():
            omega = VECTORS[f"omega_{name[-1]}"]
            rules |= dict(zip(axis, AXIS_RATES[name], strict=True))
            rules |= dict(zip(AXIS_RATES[name], _cross(omega, AXIS_RATES[name]), strict=True))
        return rules

    def turn(self, marker: str, k: int) -> Rules:
        """Virtual rotation of a marker about world axis k."""
        unit = [sp.Integer(i == k) for i in range(3)]
        rules: dict[sp.Symbol, sp.Expr] = {}
        for name, axis in AXES_OF.items():
            if name.endswith(marker):
                rules |= dict(zip(axis, _cross(unit, axis), strict=True))
        return rules


def _cross(u: Sequence[sp.Expr], v: Sequence[sp.Expr]) -> list[sp.Expr]:
    return [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]


@cache
def spatial_template(joint: type[Joint]) -> JointTemplate:
    """The template of a joint type in space; slots r_a_x, ..., r_b_x, ..., turn_a_x, ..., turn_b_x, ..., travel_x."""
    markers = SpatialMarkers(joint)
    return _spatial(markers, tuple(joint.rows_in_space(markers)))


@cache
def placing_template() -> JointTemplate:
    """The position of a body that a joint places, r_b - r_a - travel = 0: linear in R_o of both bodies."""
    markers = SpatialMarkers(None)
    return _spatial(markers, tuple(together(markers)))


def _spatial(markers: SpatialMarkers, rows: tuple[Equation, ...]) -> JointTemplate:
    outputs: dict[str, sp.Expr] = {}
    rates, motion = markers.rates(), markers.motion()
    moving = {value: rate for value, rate, _ in markers.fields.values() if value in motion}
    for k, (_, _, C, _) in enumerate(rows):
        outputs[f"C_{k}"] = C
        for symbol in (*VECTORS["r_a"], *VECTORS["r_b"], *VECTORS["travel"]):
            outputs[f"C_{k}_{symbol.name}"] = sp.diff(C, symbol)
        for marker in "ab":
            for i, axis in enumerate(AXES):
                outputs[f"C_{k}_turn_{marker}_{axis}"] = derivative(C, markers.turn(marker, i))
        outputs[f"C_t_{k}"] = derivative(C, moving)
        outputs[f"drift_{k}"] = derivative(derivative(C, rates), rates)
    return JointTemplate(rows, Template(outputs), markers.fields)


@dataclass(frozen=True)
class JointCoordinate:
    """A coordinate of a joint: value, rate and column in q."""

    value: ca.SX
    rate: ca.SX
    column: int


@dataclass(frozen=True)
class Travel:
    """How far a joint has moved along the axes of marker a: values, rates, rows over q, and what rows and rates leave
    of the acceleration."""

    value: Vector = field(default_factory=zeros)
    rate: Vector = field(default_factory=zeros)
    rows: list[Row] = field(default_factory=lambda: [{}, {}, {}])
    bias: Vector = field(default_factory=zeros)


@dataclass(frozen=True)
class JointCoordinates:
    """The motions of a joint, each with its coordinate and the travel along its axis for a unit of a turn (lead)."""

    motions: Sequence[Turn | Slide]
    coordinates: Sequence[JointCoordinate]
    leads: Sequence[ca.SX]

    def place(self, name: str) -> int:
        """Place of a coordinate by its name within the joint."""
        return next(k for k, motion in enumerate(self.motions) if motion.name == name)

    @property
    def subspace(self) -> list[tuple[Vector, Vector]]:
        """S(q) by coordinate: (angular velocity of b, velocity of point b) for a unit rate, both in marker a's axes."""
        R = identity()
        found: list[tuple[Vector, Vector]] = []
        for motion, own, lead in zip(self.motions, self.coordinates, self.leads, strict=True):
            axis = [row[motion.axis] for row in R]
            along = own.value if isinstance(motion, Slide) else mul(lead, own.value)
            way = scaled(along, axis)
            found = [(omega, plus(v, cross(omega, way))) for omega, v in found]
            found.append((axis, scaled(lead, axis)) if isinstance(motion, Turn) else (zeros(), axis))
            if isinstance(motion, Turn):
                R = _turned(R, motion.axis, own.value)
        return found

    def travel(self) -> Travel:
        """Of point b: the translation of X(q), with S(q) as its rows."""
        value, R = zeros(), identity()
        for motion, own, lead in zip(self.motions, self.coordinates, self.leads, strict=True):
            along = own.value if isinstance(motion, Slide) else mul(lead, own.value)
            value = plus(value, scaled(along, [row[motion.axis] for row in R]))
            if isinstance(motion, Turn):
                R = _turned(R, motion.axis, own.value)
        rows: list[Row] = [{}, {}, {}]
        rate = zeros()
        for own, (_, v) in zip(self.coordinates, self.subspace, strict=True):
            for axis in range(3):
                if not v[axis].is_zero():
                    rows[axis][own.column] = v[axis]
                    rate[axis] = add(rate[axis], mul(v[axis], own.rate))
        return Travel(value, rate, rows, self._changes(rate))

    def free_axes(self, a: SpatialMarker, b: SpatialMarker) -> tuple[list[Vector], list[Vector]]:
        """Directions in the world along which the joint passes on no force, and about which no moment (for virtual
        work, at right angles to each other); none for a screw, whose axis carries both."""
        S = self.subspace
        sliding = [k for k, motion in enumerate(self.motions) if isinstance(motion, Slide)]
        rotation = [k for k, motion in enumerate(self.motions) if isinstance(motion, Turn) and not motion.lead]
        slides = [in_world(a, S[k][1]) for k in sliding]
        turns = [in_world(a, S[k][0]) for k in rotation[:-1]]
        turns += [(b if turns else a).axes[self.motions[k].axis] for k in rotation[-1:]]
        return _apart(slides, [S[k][1] for k in sliding]), _apart(turns, [S[k][0] for k in rotation])

    def _changes(self, rate: Vector) -> Vector:
        """Derivatives in time at constant rates."""
        if not self.coordinates:
            return zeros()
        values, rates = (ca.vertcat(*(getattr(own, key) for own in self.coordinates)) for key in ("value", "rate"))
        changes = [ca.jtimes(part, values, rates) for part in rate]
        return [ZERO if change.is_zero() else change for change in changes]


def _turned(R: list[Vector], axis: int, angle: ca.SX) -> list[Vector]:
    """R times a turn about one of its axes."""
    i, j = (axis + 1) % 3, (axis + 2) % 3
    c, s = ca.cos(angle), ca.sin(angle)
    found = [list(row) for row in R]
    for row in found:
        row[i], row[j] = add(mul(c, row[i]), mul(s, row[j])), add(neg(mul(s, row[i])), mul(c, row[j]))
    return found


def in_world(a: SpatialMarker, direction: Vector) -> Vector:
    """A direction given in the axes of marker a."""
    return plus(*(scaled(share, axis) for share, axis in zip(direction, a.axes, strict=True)))


def _apart(axes: list[Vector], in_a: list[Vector]) -> list[Vector]:
    """What two or three directions span, at right angles to each other; in_a: the same in the axes of marker a."""
    if len(axes) == 3:
        return identity()
    if len(axes) < 2 or (along := dot(*in_a)).is_zero():
        return axes
    if along.is_one():
        return axes[:1]
    across = minus(axes[1], scaled(dot(*axes), axes[0]))
    return [axes[0], scaled(1 / ca.sqrt(dot(across, across)), across)]
