"""The equations of the whole system in all coordinates q: M, Q*, C, C_q, C_t, gamma, energies (Eqs. 20-28).

Sparse rows of CasADi SX, put together from the scene's bodies, joints and loads. Nothing is condensed here.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property

import casadi as ca

from symgen.bodies.outlines import outline_references
from symgen.bodies.planar_body import BodyCoordinates, MarkerMotion, PlanarBody
from symgen.bodies.points import marker_shape
from symgen.bodies.shape_integrals import body_integrals
from symgen.joints.instance import ConstraintRow, constraint_rows
from symgen.loads import instance as effects
from symgen.loads.instance import LoadEffect
from symgen.parameters import ParameterTable
from symgen.rows import Row, add_to
from symgen.scalar import ZERO, add, dot, mul, sub, total
from symgen.scene import Scene


@dataclass(frozen=True)
class Outline:
    """Polyline that shows a body: world points as pairs of SX."""

    body: str
    points: list[list[ca.SX]]


@dataclass
class Equations:
    """Eqs. (20)-(28) of a scene. Columns follow `names`; M is symmetric with both triangles stored.

    Q_F holds loads, gravity and damping; Q_star = Q_v - K q + Q_F. Energies [J] and powers [W] are scalars.
    """

    names: list[str]
    q: list[ca.SX]
    q_dot: list[ca.SX]
    t: ca.SX
    M: list[Row]
    K: list[Row]
    Q_v: list[ca.SX]
    Q_F: list[ca.SX]
    constraints: list[ConstraintRow]
    elastic: ca.SX = field(default_factory=lambda: ca.SX(0))
    potential: ca.SX = field(default_factory=lambda: ca.SX(0))
    dissipated: ca.SX = field(default_factory=lambda: ca.SX(0))
    applied: ca.SX = field(default_factory=lambda: ca.SX(0))
    measures: dict[str, ca.SX] = field(default_factory=dict)
    elastic_columns: frozenset[int] = frozenset()
    body_columns: dict[str, list[int]] = field(default_factory=dict)
    outlines: list[Outline] = field(default_factory=list)
    baumgarte: tuple[ca.SX, ca.SX] = field(default_factory=lambda: (ca.SX(0), ca.SX(0)))

    @cached_property
    def Q_star(self) -> list[ca.SX]:
        """Q_v - K q + Q_F, per coordinate."""
        springs = matrix_times(self.K, dict(enumerate(self.q)))
        return [add(sub(Q_v, springs.get(row, ZERO)), Q_F)
                for row, (Q_v, Q_F) in enumerate(zip(self.Q_v, self.Q_F, strict=True))]

    @property
    def joints(self) -> list[str]:
        """Names of the joints, in the order of their first constraint row."""
        return list(dict.fromkeys(row.joint for row in self.constraints))

    def kinetic(self) -> ca.SX:
        """1/2 q_dot^T M q_dot."""
        momenta = [total(mul(value, self.q_dot[column]) for column, value in entries.items()) for entries in self.M]
        return dot(self.q_dot, momenta) / 2


def build_equations(scene: Scene, table: ParameterTable) -> Equations:
    """Equations of a scene of bodies, or of a linear structure (Eqs. 3-14)."""
    if scene.structure is not None:
        return _Structure(scene, table).equations
    return _Assembly(scene, table).equations


def _blank(names: list[str]) -> Equations:
    q = [ca.SX.sym(name) for name in names]
    q_dot = [ca.SX.sym(f"{name}_dot") for name in names]
    n = len(names)
    return Equations(names, q, q_dot, ca.SX.sym("t"), [{} for _ in q], [{} for _ in q], [ZERO] * n, [ZERO] * n, [])


class _Structure:
    """M x'' + D x' + K x = F(t): already in independent coordinates."""

    def __init__(self, scene: Scene, table: ParameterTable) -> None:
        structure = scene.structure
        assert structure is not None
        self.equations = eq = _blank(scene.coordinates())
        env = {**table.environment(), "t": eq.t}

        def matrix(rows: Sequence[Sequence[float | str]] | None, label: str, unit: str) -> list[Row]:
            return [{} if rows is None else {
                column: table.quantity(value, f"{label}[{row},{column}]", unit)
                for column, value in enumerate(rows[row]) if value != 0} for row in range(len(eq.names))]

        eq.M = matrix(structure.mass, "M", "kg")
        eq.K = matrix(structure.stiffness, "K", "N/m")
        D = matrix(structure.damping, "D", "N s/m")
        for row in range(len(eq.names)):
            spring = total(mul(value, eq.q[column]) for column, value in eq.K[row].items())
            damper = total(mul(value, eq.q_dot[column]) for column, value in D[row].items())
            load = ca.SX(0)
            if structure.force is not None:
                load = scene.expression(structure.force[row], f"force[{row}]", ("t",)).to_casadi(env)
            eq.Q_F[row] = load - damper
            eq.elastic = eq.elastic + eq.q[row] * spring / 2
            eq.dissipated = eq.dissipated + eq.q_dot[row] * damper
            eq.applied = eq.applied + eq.q_dot[row] * load


class _Assembly:
    """Bodies, joints and loads in scene order."""

    def __init__(self, scene: Scene, table: ParameterTable) -> None:
        self.scene, self.table = scene, table
        self.equations = _blank(scene.coordinates())
        self.bodies: dict[str, PlanarBody] = {}
        self._markers: dict[str, MarkerMotion] = {}
        self.gravity = [table.quantity(g, f"gravity.{axis}", "m/s^2", "gravity")
                        for g, axis in zip(scene.gravity, "xy", strict=True)]
        self._add_bodies()
        self._add_joints()
        self.environment = {**table.environment(), "t": self.equations.t}
        self._add_measures()
        self._add_loads()
        self._add_outlines()
        if scene.baumgarte is not None:
            self.equations.baumgarte = (
                table.quantity(scene.baumgarte.alpha, "baumgarte.alpha", "1/s", "damping of constraint errors"),
                table.quantity(scene.baumgarte.beta, "baumgarte.beta", "1/s", "stiffness of constraint errors"))

    def _add_bodies(self) -> None:
        eq, first = self.equations, 0
        elastic: set[int] = set()
        self.bodies["ground"] = PlanarBody("ground", BodyCoordinates.ground(), None)
        for description in self.scene.bodies:
            if description.type == "ground":
                self.bodies[description.name] = self.bodies["ground"]
                continue
            integrals = body_integrals(self.scene, description.name, self.table)
            columns = list(range(first, first + 3 + integrals.nf))
            first += 3 + integrals.nf
            q, q_dot = [eq.q[c] for c in columns], [eq.q_dot[c] for c in columns]
            body = PlanarBody(description.name, BodyCoordinates(
                columns, q[:2], q[2], q[3:], q_dot[:2], q_dot[2], q_dot[3:]), integrals)
            self.bodies[description.name] = body
            eq.body_columns[description.name] = columns
            elastic.update(columns[3:])
            self._add_inertia(body)
        eq.elastic_columns = frozenset(elastic)

    def _add_inertia(self, body: PlanarBody) -> None:
        eq = self.equations
        for row, column, value in body.mass_entries():
            add_to(eq.M[row], column, value)
            if row != column:
                add_to(eq.M[column], row, value)
        for row, column, value in body.stiffness_entries():
            add_to(eq.K[row], column, value)
        for column, value in body.quadratic_velocity_force().items():
            eq.Q_v[column] = add(eq.Q_v[column], value)
        self._add_force(body.damping_force())
        self._add_force(body.gravity_force(self.gravity))
        elastic, dissipated = body.elastic_energy()
        eq.elastic, eq.dissipated = eq.elastic + elastic, eq.dissipated + dissipated
        eq.potential = eq.potential + body.gravity_potential(self.gravity)

    def _add_force(self, force: Row) -> None:
        for column, value in force.items():
            self.equations.Q_F[column] = add(self.equations.Q_F[column], value)

    def _add_effect(self, effect: LoadEffect) -> None:
        eq = self.equations
        self._add_force(effect.force)
        eq.elastic = eq.elastic + effect.potential
        eq.dissipated = eq.dissipated + effect.dissipated
        eq.applied = eq.applied + effect.applied

    def marker(self, reference: str) -> MarkerMotion:
        """Motion of "body.marker", built once."""
        if reference not in self._markers:
            body, shape = marker_shape(self.scene, reference, self.table)
            self._markers[reference] = self.bodies[body].marker(shape)
        return self._markers[reference]

    def _add_joints(self) -> None:
        eq = self.equations
        for joint in self.scene.joints:
            a, b = self.marker(joint.marker_a), self.marker(joint.marker_b)
            motion = [ca.SX(0)] * 3
            text = getattr(joint, "motion", None)
            if text is not None:
                env: Mapping[str, ca.SX] = {**self.table.environment(), "t": eq.t}
                f = self.scene.expression(text, f"joints.{joint.name}.motion", ("t",)).to_casadi(env)
                f_t = ca.jacobian(f, eq.t)
                motion = [f, f_t, ca.jacobian(f_t, eq.t)]
            eq.constraints += constraint_rows(joint.name, joint.type, a, b, motion)
            damping = getattr(joint, "damping", 0)
            if damping != 0:
                value = self.table.quantity(damping, f"{joint.name}.damping", "N s/m or N m s", "joint damping")
                zero = ca.SX(0)
                self._add_effect(effects.slide_friction(a, b, value) if joint.type == "prismatic"
                                 else effects.rotational_spring_damper(a, b, zero, value, zero))

    def _add_measures(self) -> None:
        eq = self.equations
        for measure in self.scene.measures:
            a, b = self.marker(measure.marker_a), self.marker(measure.marker_b)
            d = [b.r[0] - a.r[0], b.r[1] - a.r[1]]
            value = {"angle": b.phi - a.phi, "x": d[0], "y": d[1]}.get(measure.type)
            if value is None:
                value = ca.sqrt(d[0] ** 2 + d[1] ** 2)
            rate = ca.jtimes(value, ca.vertcat(*eq.q), ca.vertcat(*eq.q_dot))
            eq.measures[measure.name], eq.measures[f"{measure.name}_dot"] = value, rate
        self.environment |= eq.measures

    def _add_outlines(self) -> None:
        for body, shapes in outline_references(self.scene, self.table):
            motions = [self.bodies[body].marker(shape) for shape in shapes]
            self.equations.outlines.append(Outline(body, [motion.r for motion in motions]))

    def _expression(self, text: float | str, item: str) -> ca.SX:
        if not isinstance(text, str):
            return self.table.quantity(text, item, "N or N m")
        names = ("t", *self.equations.measures)
        return self.scene.expression(text, item, names).to_casadi(self.environment)

    def _add_loads(self) -> None:
        for load in self.scene.loads:
            item = load.name
            if load.type == "force":
                components = [self._expression(text, f"{item}.components.{axis}")
                              for axis, text in zip("xy", load.components, strict=True)]
                self._add_effect(effects.point_force(self.marker(load.marker), components, load.frame))
            elif load.type == "torque":
                reaction = self.marker(load.reaction) if load.reaction else None
                self._add_effect(effects.torque(self.marker(load.marker),
                                                self._expression(load.value, f"{item}.value"), reaction))
            else:
                self._add_spring(load)

    def _add_spring(self, load) -> None:  # type: ignore[no-untyped-def]
        turning = load.type == "rotational_spring_damper"
        units = ("N m/rad", "N m s/rad", "rad") if turning else ("N/m", "N s/m", "m")
        fields = ("stiffness", "damping", "free_angle" if turning else "free_length")
        values = [self.table.quantity(getattr(load, field), f"{load.name}.{field}", unit)
                  for field, unit in zip(fields, units, strict=True)]
        effect = effects.rotational_spring_damper if turning else effects.spring_damper
        self._add_effect(effect(self.marker(load.marker_a), self.marker(load.marker_b), *values))


def matrix_times(rows: list[Row], vector: Mapping[int, ca.SX]) -> Row:
    """rows @ vector for a sparse vector, as a sparse vector."""
    result: Row = {}
    for row, entries in enumerate(rows):
        for column, value in entries.items():
            if column in vector:
                add_to(result, row, mul(value, vector[column]))
    return result

