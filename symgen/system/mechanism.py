"""The equations of a mechanism: bodies, joints, measures and loads put together in scene order (Eqs. 15-28).

What a body, a joint or a load *is* depends on the dimensions of the scene and stands in planar.py and spatial.py.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial, reduce
from typing import TYPE_CHECKING, Any, Generic, Protocol, TypeVar

import casadi as ca
import numpy as np

from runtime.contract.orientations import NAMES
from symgen.algebra.parameters import ParameterTable
from symgen.algebra.rows import Row, add_scaled, add_to, nonzero
from symgen.algebra.scalar import ONE, ZERO, add, div, dot, mul, neg, sub, total
from symgen.algebra.vectors import Matrix, times
from symgen.bodies.outlines import Picture
from symgen.couplings import Coupling
from symgen.joints import Joint
from symgen.joints.backlash import Backlash
from symgen.joints.friction import Friction
from symgen.joints.joint import Motor
from symgen.joints.limits import Limits
from symgen.loads import Load
from symgen.loads.load import LoadEffect, Scalar
from symgen.scene import BeamBody, BeamMarker, SpatialModalBody
from symgen.scene.flexible import ALL_GAUGES
from symgen.scene.measures import (
    ExpressionMeasure,
    ForceMeasure,
    MarkerMeasure,
    Measure,
    SectionForceMeasure,
    StressMeasure,
    accelerated,
    known_late,
)
from symgen.schema.fields import Scope, StrictModel
from symgen.system.axial_force import AxialForce, BeamFrame
from symgen.system.constraint import ConstraintRow, DerivationError, Motion, combined
from symgen.system.equations import Element, Equations, Rotor, Rubbing, Stop
from symgen.system.one_sided import Push, against, beyond_play, hunt_crossley
from symgen.system.signals import modes_of, motion_derivatives
from symgen.system.structure import ExpressionReader, Read
from symgen.system.topology import Topology

if TYPE_CHECKING:
    from symgen.mechanism.scene import SceneRecord


class ModalCoordinates(Protocol):
    """The modes of a body: columns in q, values, rates."""

    @property
    def elastic(self) -> list[int]:
        """Columns."""

    @property
    def q_f(self) -> list[ca.SX]:
        """Values."""

    @property
    def q_f_dot(self) -> list[ca.SX]:
        """Rates."""


class MovingBody(Protocol):
    """What the assembly asks of a body that moves."""

    @property
    def coordinates(self) -> ModalCoordinates:
        """Its modes."""

    def mass_entries(self) -> list[tuple[int, int, ca.SX]]:
        """Upper triangle of its mass matrix."""

    def modal_matrices(self) -> tuple[Matrix, Matrix]:
        """K_ff and D_ff of its modes."""

    def quadratic_velocity_force(self) -> Row:
        """Its Q_v."""

    def gravity_force(self, gravity: list[ca.SX]) -> Row:
        """Its weight."""

    def gravity_potential(self, gravity: list[ca.SX]) -> ca.SX:
        """Potential of its weight."""


FRICTION_LIMITS = ("coulomb", "breakaway", "stribeck", "viscous", "mu", "mu_static")
LIMIT_ROUNDING = 1e-12  # of what holds: its parts are added up
MOST_POWER = 9.0  # what is no polynomial counts as this power of the place


@dataclass(frozen=True)
class Spin:
    """A turning rate about an axis: row . q', and what the row leaves of its derivative.

    gyroscopic: generalised force of a unit of angular momentum about the axis for the turning of the axis itself.
    """

    row: Row
    rate: ca.SX
    bias: ca.SX
    gyroscopic: Row


Marker = TypeVar("Marker")


class Space(ABC, Generic[Marker]):
    """Kinematics of a planar or a spatial scene."""

    axes: str
    inertia_of_bodies = True  # do the bodies state their inertia and weight?
    table: ParameterTable

    @abstractmethod
    def add_body(self, name: str, columns: list[int], q: list[ca.SX], q_dot: list[ca.SX]) -> tuple[MovingBody, int]:
        """Build a body from the columns that begin with its own; (body, how many are its own)."""

    @abstractmethod
    def marker(self, reference: str) -> Marker:
        """Motion of "body.marker"."""

    @abstractmethod
    def joint_rows(self, joint: Joint, motions: Mapping[str, Motion]) -> list[ConstraintRow]:
        """Constraint rows of a joint."""

    @abstractmethod
    def coordinate_row(self, name: str) -> ConstraintRow:
        """The coordinate "joint.angle" of a joint as a row that would hold it at zero."""

    @abstractmethod
    def carrier_spin(self, joint: Joint) -> Spin:
        """How the body of marker a turns about the joint's axis."""

    def body_rows(self) -> list[ConstraintRow]:
        """Constraint rows of the bodies' own coordinates: none of angles."""
        return []

    @abstractmethod
    def coordinate(self, name: str) -> Scalar:
        """The coordinate "joint.angle" of a joint: its value, its rate, and the row of a force on it."""

    def joint_friction(self, joint: Joint) -> Iterator[LoadEffect]:
        """Viscous friction of what a joint leaves free."""
        for motion in joint.motions or ():
            if motion.damping and getattr(joint, motion.damping) != 0:
                own, damping = self.coordinate(f"{joint.name}.{motion.name}"), self.table.of(joint, motion.damping)
                force: Row = {}
                add_scaled(force, mul(neg(damping), own.rate), own.row)
                yield LoadEffect(force, dissipated=damping * own.rate**2)

    @abstractmethod
    def measure(self, kind: str, a: str, b: str, axes: str) -> ca.SX:
        """A scalar of the motion between two markers."""

    @abstractmethod
    def resolved(self, vector: Sequence[ca.SX], axes: str) -> list[ca.SX]:
        """Components of a world vector along the axes of a marker, or of the world."""

    @abstractmethod
    def distance(self, a: str, b: str) -> tuple[ca.SX, ca.SX]:
        """The distance between two markers, and its rate."""

    @abstractmethod
    def section_force(self, body: BeamBody, kind: str, at: float) -> ca.SX:
        """Normal force, shear force or bending moment of a beam at a fraction of its length."""

    @abstractmethod
    def beam_frame(self, body: BeamBody, q_ddot: Sequence[ca.SX]) -> BeamFrame:
        """Motion of the frame of a beam, at accelerations by column."""

    @abstractmethod
    def load(self, load: Load, read: Read, reader: ExpressionReader, q: ca.SX, q_dot: ca.SX) -> LoadEffect:
        """Effect of a load; read: its expressions."""

    @abstractmethod
    def picture(self) -> Picture:
        """What shows the bodies."""


class Mechanism(Generic[Marker]):
    """Puts the equations together; `equations` is the result."""

    def __init__(
        self, scene: SceneRecord, table: ParameterTable, space: Space[Marker], equations: Equations, topology: Topology
    ) -> None:
        self.scene, self.table, self.space, self.equations = scene, table, space, equations
        self.topology, self.reader = topology, ExpressionReader(scene, equations)
        gravity = [*scene.gravity, 0.0][: len(space.axes)]
        self.gravity = equations.gravity = [
            table.quantity(g, f"gravity.{axis}", "m/s^2", "gravity")
            for g, axis in zip(gravity, space.axes, strict=True)
        ]
        self._add_bodies()
        for joint in scene.joints:
            self._add_joint(joint)
        for coupling in scene.couplings:
            self._add_coupling(coupling)
        equations.constraints += space.body_rows()
        self.environment: Mapping[str, Any] = {**table.environment(), "t": equations.t, **equations.u}
        self._add_measures()
        self._add_states()
        self._add_elements()
        q, q_dot = ca.vertcat(*equations.q), ca.vertcat(*equations.q_dot)
        for load in scene.loads:
            effect = space.load(load, self._expression, self.reader, q, q_dot)
            self._add_effect(load.name, effect)
            equations.load_actions[load.name] = effect.action
            if effect.beyond is not None:
                equations.loads_beyond[load.name] = effect.beyond
            equations.load_spans[load.name] = [min(part, MOST_POWER) for part in effect.along]
            if effect.touching:
                parts = zip(("normal_force", "friction_force", "normal_velocity"), effect.touching, strict=True)
                units = ("N", "N", "m/s")
                equations.one_sided |= {
                    f"{load.name}.{part}": (value, unit) for (part, value), unit in zip(parts, units, strict=True)
                }
            if effect.size is not None:
                equations.load_sizes[load.name] = effect.size
        self._add_late_measures()
        if space.inertia_of_bodies:
            self._add_accelerated_measures()
        self._add_events()
        equations.picture = space.picture()

    def _add_bodies(self) -> None:
        eq, first = self.equations, 0
        bodies: list[MovingBody] = []
        for description in self.scene.moving_bodies:
            columns = list(range(first, len(eq.names)))
            body, size = self.space.add_body(description.name, columns, eq.q[first:], eq.q_dot[first:])
            columns, first = columns[:size], first + size
            eq.body_columns[description.name] = columns
            bodies.append(body)
            self._add_body(body)
        eq.masses, eq.velocity_forces = partial(_masses, eq, bodies), partial(_velocity_forces, eq, bodies)
        for placement in self.topology.placements.values():
            eq.body_columns[placement.child] += [eq.names.index(name) for name in placement.coordinates]
        eq.joint_columns = frozenset(range(first, len(eq.names))) - set(eq.states.values()) - eq.turn_columns

    def _add_body(self, body: MovingBody) -> None:
        """Stiffness and damping of its modes, Q = -D_ff q_f' - K_ff q_f; its weight."""
        eq, own = self.equations, body.coordinates
        K_ff, D_ff = body.modal_matrices()
        for a, row in enumerate(own.elastic):
            for b, column in enumerate(own.elastic):
                add_to(eq.K[row], column, K_ff[a][b])
            eq.Q_F[row] = sub(eq.Q_F[row], dot(D_ff[a], own.q_f_dot))
        if own.elastic:
            eq.elastic = eq.elastic + dot(own.q_f, times(K_ff, own.q_f)) / 2
            eq.dissipated = eq.dissipated + dot(own.q_f_dot, times(D_ff, own.q_f_dot))
        if self.space.inertia_of_bodies:
            self._add_force(body.gravity_force(self.gravity))
            eq.potential = eq.potential + body.gravity_potential(self.gravity)

    def _add_force(self, force: Row) -> None:
        for column, value in force.items():
            self.equations.Q_F[column] = add(self.equations.Q_F[column], value)

    def _add_effect(self, name: str, effect: LoadEffect) -> None:
        eq = self.equations
        for column, value in effect.force.items():
            add_to(eq.load_forces.setdefault(name, {}), column, value)
        self._add_force(effect.force)
        if effect.spring is not None and not effect.spring.stiffness.is_zero():
            eq.springs[name] = effect.spring
        eq.elastic = eq.elastic + effect.potential
        eq.dissipated = eq.dissipated + effect.dissipated
        eq.applied = eq.applied + effect.applied

    def _add_joint(self, joint: Joint) -> None:
        eq = self.equations
        motions = {name: self._motion(joint, name) for name in joint.row_quantities()}
        eq.constraints += self.space.joint_rows(joint, motions)
        for effect in self.space.joint_friction(joint):
            self._add_effect(joint.name, effect)
        if (motor := getattr(joint, "motor", None)) is not None:
            self._add_rotor(joint, motor)
        limits: Limits | None = getattr(joint, "limits", None)
        backlash = getattr(joint, "backlash", None)
        if limits is None and backlash is None:
            return
        (motion, *_) = joint.motions or ()
        own, turns = self.space.coordinate_row(f"{joint.name}.{motion.name}"), motion.kind == "angle"
        if backlash is not None:
            self._add_one_sided(joint.name, "backlash", own, self._backlash(joint.name, backlash, own), turns)
        if limits is not None:
            self._bound_limits(joint.name, limits)
            if not limits.rigid:
                self._add_one_sided(joint.name, "stop", own, self._limits(joint.name, limits, own), turns)

    def _add_elements(self) -> None:
        """Friction and rigid stops of joints, whose limits may depend on measures and states."""
        eq = self.equations
        for joint in self.scene.joints:
            if not (modes := modes_of(joint)):
                continue
            own = self.space.coordinate_row(f"{joint.name}.{(joint.motions or ())[0].name}")
            friction, limits = joint.rubs(), getattr(joint, "limits", None)
            rubbing = None if friction is None else self._friction(joint.name, friction, own, eq.u[modes["friction"]])
            ends = [] if limits is None else [(limits, end) for end in joint.rigid_ends()]
            stops = [self._stop(joint.name, limits, end, own, eq.u[modes[end]]) for limits, end in ends]
            eq.elements.append(Element(joint.name, dict(own.C_q), self._rate(own), own.gamma, rubbing, stops))

    def _stop(self, name: str, limits: Limits, end: str, own: ConstraintRow, mode: ca.SX) -> Stop:
        item, side = f"{name}.limits", 1 if end == "lower" else -1
        gap = mul(ca.SX(side), sub(own.C, self._quantity(limits, end, item)))
        restitution = self._quantity(limits, "restitution", item)
        return Stop(f"{item}.{end}", mode, side, gap, restitution, limits.beyond == "moved")

    def _bound_limits(self, name: str, limits: Limits) -> None:
        """Parameters may not cross them later, nor take a restitution above one."""
        item = f"{name}.limits"
        if limits.lower is not None and limits.upper is not None:
            lower, upper = (self._quantity(limits, key, item) for key in ("lower", "upper"))
            self.table.require(item, "upper - lower", sub(upper, lower))
        if limits.rigid:
            e = self._quantity(limits, "restitution", item)
            self.table.require(f"{item}.restitution", "1 - restitution", sub(ONE, e))

    def _friction(self, name: str, friction: Friction, own: ConstraintRow, s: ca.SX) -> Rubbing:
        """-s (coulomb + stribeck exp(-s v / v_s)) - viscous v where v slides to the side s, nothing where it sticks.

        By the joint's force R, which is left open here, mu R and mu R radius are in place of coulomb and of what holds.
        """
        item, reaction, by = f"{name}.friction", None, ONE
        changing = {key for key in FRICTION_LIMITS if self._changes(getattr(friction, key), f"{item}.{key}")}

        def of(key: str, otherwise: ca.SX = ZERO) -> ca.SX:
            if key in changing:
                return self._expression(getattr(friction, key), f"{item}.{key}", {})
            return otherwise if getattr(friction, key) is None else self._quantity(friction, key, item)

        slides, most = ("coulomb", "breakaway") if friction.mu is None else ("mu", "mu_static")
        if friction.mu is not None:
            reaction = ca.SX.sym(f"{item}.reaction")
            by = mul(of("radius", ONE), reaction)
        least, speed, viscous = of(slides), of("stribeck_velocity", ONE), of("viscous")
        holds = of(most, least)
        beyond = of("stribeck", sub(holds, least))
        margins = [of(key) for key in FRICTION_LIMITS if key in changing]
        if getattr(friction, most) is not None and not {slides, most} & changing:
            self.table.require(f"{item}.{most}", f"{most} - {slides}", sub(holds, least))
        elif getattr(friction, most) is not None:
            margins.append(holds * (1 + LIMIT_ROUNDING) - least - of("stribeck"))
        v, law = self._rate(own), least
        if not beyond.is_zero():  # steps look behind a reversal before they end there: it must not explode
            law = add(law, mul(beyond, ca.exp(ca.fmin(neg(div(mul(s, v), speed)), 1))))
        force = neg(add(mul(s, mul(by, law)), mul(viscous, v)))
        row = {column: mul(force, value) for column, value in own.C_q.items()}
        self._add_effect(name, LoadEffect(row, dissipated=neg(mul(force, v))))
        margin = reduce(ca.fmin, margins) if margins else None
        drops = getattr(friction, most) is not None and friction.stribeck is not None
        slides_at = mul(by, add(least, beyond)) if drops else None
        return Rubbing(item, s, force, mul(by, holds), reaction, margin, slides_at)

    def _changes(self, value: float | str | None, item: str) -> bool:
        """Does a quantity depend on more than parameters, so that it changes during a run?"""
        if not isinstance(value, str):
            return False
        names = ("t", *self.equations.u, *self.equations.measures)
        fixed = self.table.environment().keys()
        return not self.scene.expression(value, item, names).names <= fixed

    def _add_one_sided(
        self, name: str, kind: str, own: ConstraintRow, sides: Sequence[tuple[int, Push]], turns: bool
    ) -> None:
        """kind: "stop" or "backlash", of which the force along the direction, and its velocity, are outputs."""
        self._add_effect(name, against(own.C_q, sides))
        force = -sum((side * push.force for side, push in sides), ca.SX(0))
        self.equations.one_sided |= {
            f"{name}.{kind}_force": (force, "N m" if turns else "N"),
            f"{name}.{kind}_velocity": (self._rate(own), "rad/s" if turns else "m/s"),
        }
        for _, push in sides:
            for value in push.kinks:
                self.reader.switch(name, value)

    def _quantity(self, part: StrictModel, key: str, item: str) -> ca.SX:
        """Of a record within a joint or a coupling."""
        meaning = part.meaning(key)
        return self.table.quantity(
            getattr(part, key), f"{item}.{key}", meaning.unit, meaning.description, meaning.bound.value
        )

    def _rate(self, own: ConstraintRow) -> ca.SX:
        return total(mul(value, self.equations.q_dot[c]) for c, value in own.C_q.items())

    def _limits(self, name: str, limits: Limits, own: ConstraintRow) -> list[tuple[int, Push]]:
        """At both ends of a coordinate."""
        item = f"{name}.limits"
        ends = {
            key: self._quantity(limits, key, item) for key in ("lower", "upper") if getattr(limits, key) is not None
        }
        stiffness = self._quantity(limits, "stiffness", item)
        damping = ZERO if limits.damping is None else self._quantity(limits, "damping", item)
        rate, sides = self._rate(own), {"lower": -1, "upper": 1}
        return [
            (side, hunt_crossley(side * (own.C - ends[key]), side * rate, stiffness, damping, limits.exponent or 1.0))
            for key, side in sides.items()
            if key in ends
        ]

    def _backlash(self, name: str, backlash: Backlash, own: ConstraintRow) -> list[tuple[int, Push]]:
        """To both sides of zero."""
        gap, *law = (self._quantity(backlash, key, f"{name}.backlash") for key in ("gap", "stiffness", "damping"))
        rate = self._rate(own)
        return [(side, beyond_play(side * own.C - gap / 2, side * rate, *law)) for side in (-1, 1)]

    def _add_rotor(self, joint: Joint, motor: Motor) -> None:
        """T = J s^2 / 2 of a rotor at the rate s = (turn of the body of marker a) + ratio (rate of the joint)."""
        eq, motions = self.equations, joint.motions or ()
        own = self.space.coordinate_row(f"{joint.name}.{motions[0].name}")
        spin, values = self.space.carrier_spin(joint), []
        for key in ("inertia", "ratio"):
            meaning, item = motor.meaning(key), f"{joint.name}.motor.{key}"
            given = getattr(motor, key)
            values.append(self.table.quantity(given, item, meaning.unit, meaning.description, meaning.bound.value))
        inertia, ratio = values
        row = dict(spin.row)
        add_scaled(row, ratio, own.C_q)
        rate = add(spin.rate, mul(ratio, total(mul(value, eq.q_dot[c]) for c, value in own.C_q.items())))
        rotation: Row = {}
        add_scaled(rotation, mul(inertia, rate), spin.gyroscopic)
        rotor = Rotor(inertia, nonzero(row), sub(spin.bias, mul(ratio, own.gamma)), rotation)
        eq.rotors.append(rotor)

    def _add_coupling(self, coupling: Coupling) -> None:
        """x_1 + a_2 x_2 + ... = constant; divided by a_2 where x_1 is to be independent, so that x_2 follows."""
        eq, table = self.equations, self.table
        rows = [self.space.coordinate_row(name) for name in coupling.named]
        factors = [ONE, *coupling.coefficients(lambda key: table.of(coupling, key))]
        constant = coupling.constant(lambda key: table.of(coupling, key)) + ZERO
        if coupling.from_start:
            values = [
                table.quantity(value, f"{coupling.name}.start.{name}", "rad or m", "value at the start")
                for name, value in zip(coupling.named, self._at_start([row.C for row in rows]), strict=True)
            ]
            constant = dot(factors, values)
        chosen = {eq.names.index(name) for name in self.scene.partition.independent or () if name in eq.names}
        free = [k for k, row in enumerate(rows) if not chosen & row.C_q.keys()]
        if free and free[0] != 0:
            pivot = factors[free[0]]
            factors = [ONE if k == free[0] else div(factor, pivot) for k, factor in enumerate(factors)]
            constant = div(constant, pivot)
        row = combined(coupling.name, rows, factors, constant)
        if coupling.backlash is None:
            eq.constraints.append(row)
        else:
            turns = self.scene.joint_of(coupling.named[0])[1].kind == "angle"
            self._add_one_sided(
                coupling.name, "backlash", row, self._backlash(coupling.name, coupling.backlash, row), turns
            )

    def _at_start(self, values: list[ca.SX]) -> list[float]:
        """At the coordinates that the scene gives for the start, the others at rest, at default parameters."""
        eq, given = self.equations, self.scene.initial.coordinates
        q = [float(given[one.name].value) if one.name in given else one.at_rest for one in eq.coordinates]
        of = ca.Function("start", [self.table.vector(), ca.vertcat(*eq.q)], [ca.vertcat(*values)])
        return [float(value) for value in np.array(of([entry.default for entry in self.table.entries], q)).ravel()]

    def _motion(self, joint: Joint, name: str) -> Motion:
        """A quantity of a joint's rows with its first two derivatives in time."""
        if joint.meaning(name).scope is not Scope.TIME:
            return [self.table.of(joint, name), ZERO, ZERO]
        eq, item = self.equations, f"joints.{joint.name}.{name}"
        env: Mapping[str, Any] = {**self.table.environment(), "t": eq.t, **eq.u}
        f = self.reader.read(getattr(joint, name), item, joint.name, env)
        motion = motion_derivatives(self.scene, f, eq.t, eq.u, item)
        self._check_start(motion, item)
        return motion

    def _check_start(self, motion: Motion, item: str) -> None:
        """Raises DerivationError for a motion that has no value, rate or acceleration at t = 0."""
        eq, table = self.equations, self.table
        u, given = ca.vertcat(*eq.u.values()), [entry.default for entry in table.entries]
        found = ca.Function("start", [table.vector(), eq.t, u], [ca.vertcat(*motion)])(given, 0.0, eq.input_defaults)
        for what, value in zip(("value", "rate", "acceleration"), np.array(found).ravel(), strict=True):
            if not np.isfinite(value):
                raise DerivationError(
                    item,
                    f"has no finite {what} at t = 0 ({value})",
                    "give a motion with two derivatives there: t**2 begins smoothly where sqrt(t) does not",
                )

    def _add_measures(self) -> None:
        """Those that loads may use."""
        eq, late = self.equations, known_late(self.scene.measures) | accelerated(self.scene)
        moving = {name: q for name, q in zip(eq.names, eq.q, strict=True)}
        moving |= {f"{name}_dot": q_dot for name, q_dot in zip(eq.names, eq.q_dot, strict=True)}
        states = {name: eq.q_dot[column] for name, column in eq.states.items()}
        self.environment = {**self.environment, **moving, **states}
        early = [one for one in self.scene.measures if one.name not in late]
        for measure in sorted(early, key=lambda one: isinstance(one, ExpressionMeasure)):
            self._add_measure(measure)
        self._in_order()

    def _add_late_measures(self) -> None:
        """Forces of loads, and expressions of them."""
        late = known_late(self.scene.measures) - accelerated(self.scene)
        for measure in sorted(self.scene.measures, key=lambda one: isinstance(one, ExpressionMeasure)):
            if measure.name in late:
                self._add_measure(measure)
        self._in_order()
        eq = self.equations
        eq.measures |= {name: value for name, (value, _) in eq.one_sided.items()}
        eq.measure_units |= {name: unit for name, (_, unit) in eq.one_sided.items()}

    def _add_accelerated_measures(self) -> None:
        """Those of normal forces by equilibrium, and expressions of them: all else is known by now."""
        names, eq = accelerated(self.scene), self.equations
        if not names:
            return
        eq.q_ddot = [ca.SX.sym(f"{name}_ddot") for name in eq.names]
        eq.lam = [ca.SX.sym(f"lam.{row.label}") for row in eq.constraints]
        for measure in sorted(self.scene.measures, key=lambda one: isinstance(one, ExpressionMeasure)):
            if measure.name not in names:
                continue
            if isinstance(measure, ExpressionMeasure):
                value, unit = self._of_expression(measure), measure.unit
            else:
                assert isinstance(measure, StressMeasure)
                value, unit = self._stress(measure), "Pa"
            eq.accelerated[measure.name] = value
            eq.measure_units[measure.name] = unit
            self.environment = {**self.environment, measure.name: value}

    def _in_order(self) -> None:
        """Measures as the scene has them, states behind them."""
        eq = self.equations
        names = [name for one in self.scene.measures for name in (one.name, f"{one.name}_dot") if name in eq.measures]
        eq.measures = {**{name: eq.measures[name] for name in names}, **eq.measures}

    def _add_measure(self, measure: Measure) -> None:
        eq = self.equations
        rate: ca.SX | None
        if measure.type == "distance":
            value, rate = self.space.distance(measure.relative_to, measure.of)
            unit = "m"
        elif isinstance(measure, ExpressionMeasure):
            value, unit = self._of_expression(measure), measure.unit
            rate = self._rate_of(value)
        elif isinstance(measure, ForceMeasure):
            value, unit, rate = self._force_of(measure), "N" if measure.type == "force" else "N m", None
        else:
            value, unit = self._measured(measure)
            rate = ca.jtimes(value, ca.vertcat(*eq.q), ca.vertcat(*eq.q_dot))
        found = {measure.name: value} if rate is None else {measure.name: value, f"{measure.name}_dot": rate}
        eq.measures |= found
        eq.measure_units |= dict(zip(found, (unit, f"{unit or '1'}/s"), strict=False))
        self.environment = {**self.environment, **found}

    def _of_expression(self, measure: ExpressionMeasure) -> ca.SX:
        """Its value; whoever uses the measure looks for jumps and kinks in the definition."""
        item = f"measures.{measure.name}.of"
        if not isinstance(measure.of, str):
            return ca.SX(measure.of)
        angles = [name for name in self.scene.angles() if name in measure.of]
        environment = {**self.environment, **{name: self._euler_angle(name) for name in angles}}
        names = ("t", *self.equations.u, *environment)
        expression = self.scene.expression(measure.of, item, names)
        self.reader.definitions[measure.name] = expression.node.with_definitions(self.reader.definitions)
        return expression.to_casadi(environment)

    def _rate_of(self, value: ca.SX) -> ca.SX | None:
        """Its derivative in time, where it uses no rates, nor inputs whose rates are not known."""
        eq, rated = self.equations, [name for name in self.equations.u if f"{name}_dot" in self.equations.u]
        unknown = [*eq.q_dot, *(symbol for name, symbol in eq.u.items() if name not in rated)]
        if ca.depends_on(value, ca.vertcat(*unknown)):
            return None
        moving = ca.vertcat(*eq.q, eq.t, *(eq.u[name] for name in rated))
        return ca.jtimes(value, moving, ca.vertcat(*eq.q_dot, 1, *(eq.u[f"{name}_dot"] for name in rated)))

    def _force_of(self, measure: ForceMeasure) -> ca.SX:
        """Of a load: along its own line, or a component; of a contact; of what pushes in a joint or a coupling."""
        eq, size = self.equations, len(self.space.axes)
        if measure.component in ("normal", "friction"):
            return eq.one_sided[f"{measure.of}.{measure.component}_force"][0]
        if measure.of not in eq.load_actions:
            parts = [eq.one_sided.get(f"{measure.of}.{kind}_force") for kind in ("stop", "backlash")]
            return sum((part[0] for part in parts if part is not None), ca.SX(0))
        if measure.component == "own":
            return ca.SX(eq.load_sizes[measure.of])
        action = list(eq.load_actions[measure.of])
        if measure.type == "moment" and size == 2:
            return action[2]
        vector = action[:size] if measure.type == "force" else action[size:]
        return self.space.resolved(vector, measure.axes)["xyz".index(measure.component)]

    def _euler_angle(self, name: str) -> ca.SX:
        """`body.theta1`, ...: read off the body's Euler parameters."""
        from symgen.bodies.spatial_orientation import euler_angle

        body, _, own = name.partition(".")
        e = [self.equations.q[self.equations.names.index(f"{body}.e{k}")] for k in range(4)]
        return euler_angle(self.scene.euler_angles()[body], NAMES.index(own), e)

    def _measured(self, measure: Measure) -> tuple[ca.SX, str]:
        """(value, SI unit) of a measure."""
        if measure.type == "coordinate" and measure.of not in self.equations.names:
            return self._euler_angle(measure.of), "rad"
        if measure.type == "coordinate":
            column = self.equations.names.index(measure.of)
            return self.equations.q[column], self.equations.coordinates[column].unit
        if isinstance(measure, SectionForceMeasure):
            unit = "N m" if "moment" in measure.type else "N"
            body, at = self._place(measure.of)
            return self.space.section_force(body, measure.type, at), unit
        if isinstance(measure, StressMeasure):
            return self._stress(measure), "Pa"
        assert isinstance(measure, MarkerMeasure)
        value = self.space.measure(measure.type, measure.relative_to, measure.of, measure.axes)
        return value, "rad" if measure.type == "angle" else "m"

    def _place(self, reference: str) -> tuple[BeamBody, float]:
        """The beam of a marker, and the fraction of its length."""
        body, marker = self.scene.marker(reference)
        assert isinstance(body, BeamBody) and isinstance(marker, BeamMarker)
        return body, float(marker.at)

    def _stress(self, measure: StressMeasure) -> ca.SX:
        """Of a finite-element body at a gauge, of a beam at a marker, or the largest of all."""
        from symgen.bodies.stresses import beam_stress, gauge_stress

        eq, (name, _, gauge) = self.equations, measure.of.partition(".")
        body = self.scene.body(name)
        if isinstance(body, BeamBody):
            places = None if gauge == ALL_GAUGES else (self._place(measure.of)[1],)
            force = partial(self.space.section_force, body)
            if measure.name in accelerated(self.scene):
                force = partial(self._section_force, self._axial_force(body, f"measures.{measure.name}"))
            return beam_stress(body, force, places, self.table)
        assert isinstance(body, SpatialModalBody)
        q_f = [eq.q[column] for column in eq.body_columns[name] if eq.coordinates[column].elastic]
        return gauge_stress(body, gauge, measure.component, q_f, self.table)

    def _axial_force(self, body: BeamBody, item: str) -> AxialForce:
        frame = self.space.beam_frame(body, self.equations.q_ddot)
        return AxialForce(self.scene, body, frame, self.equations, self.table, item)

    def _section_force(self, axial: AxialForce, kind: str, at: float) -> ca.SX:
        """The normal force by equilibrium, all else by the shapes."""
        return axial.at(at) if kind == "normal_force" else self.space.section_force(axial.body, kind, at)

    def _add_states(self) -> None:
        """s' = g(q, q', s, u, t) as the motion of a coordinate of unit inertia whose rate is s."""
        eq = self.equations
        if not eq.states:
            return
        self.environment = {**self.environment, **{name: eq.q_dot[column] for name, column in eq.states.items()}}
        names = (*eq.measures, *eq.states)
        rates: dict[str, ca.SX] = {}
        for name, column in eq.states.items():
            state = self.scene.states[name]
            item = f"states.{name}.rate"
            if isinstance(state.rate, str):
                rates[name] = self.reader.read(state.rate, item, name, self.environment, *names)
            else:
                rates[name] = self.table.quantity(state.rate, item, f"{state.unit or '1'}/s")
            eq.Q_F[column] = rates[name]
        for name, column in eq.states.items():
            unit = self.scene.states[name].unit
            eq.measures |= {name: eq.q_dot[column], f"{name}_dot": rates[name]}
            eq.measure_units |= {name: unit, f"{name}_dot": f"{unit or '1'}/s"}
        eq.body_columns["states"] = list(eq.states.values())
        self.environment = {**self.environment, **eq.measures}

    def _add_events(self) -> None:
        for name, event in self.scene.events.items():
            action = {target: self._plain(value, f"events.{name}.action") for target, value in event.action.items()}
            self.equations.events[name] = self._plain(event.when, f"events.{name}.when"), action

    def _plain(self, text: float | str, item: str) -> ca.SX:
        """An expression whose own jumps no step needs to end at."""
        if not isinstance(text, str):
            return ca.SX(text)
        names = ("t", *self.equations.u, *self.equations.measures)
        return self.scene.expression(text, item, names).to_casadi(self.environment)

    def _expression(self, text: float | str, item: str, local: Mapping[str, ca.SX]) -> ca.SX:
        if not isinstance(text, str):
            return self.table.quantity(text, item, "N or N m")
        names = (*self.equations.measures, *local)
        return self.reader.read(text, item, item.partition(".")[0], {**self.environment, **local}, *names)


def _masses(eq: Equations, bodies: Sequence[MovingBody]) -> list[Row]:
    """M of bodies, and a unit for each state of controllers, which no body knows of."""
    M: list[Row] = [{} for _ in eq.q]
    for body in bodies:
        for row, column, value in body.mass_entries():
            add_to(M[row], column, value)
            if row != column:
                add_to(M[column], row, value)
    return with_rotors(with_states(M, eq), eq)


def with_rotors(M: list[Row], eq: Equations) -> list[Row]:
    """M with the rank-one terms of the rotors of motors."""
    for rotor in eq.rotors:
        rotor.add_to(M)
    return M


def with_states(M: list[Row], eq: Equations) -> list[Row]:
    """M with a unit for each state of controllers, which no body knows of."""
    for column in eq.states.values():
        M[column] = {column: ONE}
    return M


def _velocity_forces(eq: Equations, bodies: Sequence[MovingBody]) -> list[ca.SX]:
    Q_v = [ZERO] * len(eq.q)
    for body in bodies:
        for column, value in body.quadratic_velocity_force().items():
            Q_v[column] = add(Q_v[column], value)
    for rotor in eq.rotors:
        for column, value in rotor.force({}).items():
            Q_v[column] = sub(Q_v[column], value)
    return Q_v
