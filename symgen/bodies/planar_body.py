"""One planar body of a scene: the SymPy template of its type evaluated with its SX values (Eqs. 15-20)."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import casadi as ca

from symgen.algebra.rows import Row, nonzero
from symgen.algebra.scalar import ONE, ZERO, add, dot, entries, mul, neg, sub
from symgen.bodies import planar_point as point
from symgen.bodies import planar_template as template
from symgen.bodies.planar_coordinates import BodyCoordinates
from symgen.bodies.planar_moments import LocalPoint, Moments
from symgen.bodies.shape_integrals import PointShape, ShapeIntegrals


@dataclass(frozen=True)
class MarkerMotion:
    """A marker's motion: position r, velocity, bias acceleration, angle phi, and their rows over q.

    r_columns[axis] and phi_row map a column of q to dr/dq and dphi/dq. direction is (cos phi, sin phi).
    """

    r: list[ca.SX]
    r_dot: list[ca.SX]
    bias: list[ca.SX]
    r_columns: list[Row]
    phi: ca.SX
    phi_dot: ca.SX
    phi_row: Row
    direction: list[ca.SX]


class PlanarBody:
    """A rigid (nf = 0) or flexible planar body; ground is a body without coordinates or mass."""

    def __init__(self, name: str, coordinates: BodyCoordinates, integrals: ShapeIntegrals | None) -> None:
        self.name = name
        self.coordinates = coordinates
        self.integrals = integrals
        if coordinates.columns:
            self.cosine, self.sine = ca.cos(coordinates.theta), ca.sin(coordinates.theta)
        else:
            self.cosine, self.sine = ONE, ZERO

    def rotate(self, x: ca.SX, y: ca.SX) -> tuple[ca.SX, ca.SX]:
        """World components A(theta) (x, y)."""
        return (sub(mul(self.cosine, x), mul(self.sine, y)), add(mul(self.sine, x), mul(self.cosine, y)))

    @cached_property
    def _moments(self) -> Moments:
        assert self.integrals is not None
        return Moments(self.coordinates, self.rotate, self.integrals)

    def mass_entries(self) -> list[tuple[int, int, ca.SX]]:
        """Upper triangle of the body's mass matrix (Eq. 20) as (row, column, value) in system columns."""
        integrals, columns, moments = self._require_mass(), self.coordinates.columns, self._moments
        x, y, angle, modes = columns[0], columns[1], columns[2], columns[3:]
        block = template.body_template().evaluate(
            moments.values(None), ["M_RR", "M_Rtheta_x", "M_Rtheta_y", "M_thetatheta"]
        )
        M_ff = entries(integrals.M_ff)
        found = [
            (x, x, block["M_RR"]),
            (y, y, block["M_RR"]),
            (x, angle, block["M_Rtheta_x"]),
            (y, angle, block["M_Rtheta_y"]),
            (angle, angle, block["M_thetatheta"]),
        ]
        for a, column in enumerate(modes):
            row = template.body_template().evaluate(moments.values(a), ["M_Rf_x", "M_Rf_y", "M_thetaf"])
            found += [(x, column, row["M_Rf_x"]), (y, column, row["M_Rf_y"]), (angle, column, row["M_thetaf"])]
            found += [(column, modes[b], M_ff[a][b]) for b in range(a, len(modes))]
        return [(row, column, value) for row, column, value in found if not value.is_zero()]

    def quadratic_velocity_force(self) -> Row:
        """Q_v of Eq. (20) by system column."""
        columns, moments = self.coordinates.columns, self._moments
        self._require_mass()
        names = ["Q_v_x", "Q_v_y", "Q_v_theta"]
        values = template.body_template().evaluate(moments.values(None), names)
        force = {column: values[name] for column, name in zip(columns, names, strict=False)}
        for a, column in enumerate(columns[3:]):
            force[column] = template.body_template().evaluate(moments.values(a), ["Q_v_f"])["Q_v_f"]
        return force

    def stiffness_entries(self) -> list[tuple[int, int, ca.SX]]:
        """K of Eq. (20), non-zero in K_ff only, as (row, column, value) in system columns."""
        K_ff, modes = entries(self._require_mass().K_ff), self.coordinates.columns[3:]
        return [
            (row, column, K_ff[a][b])
            for a, row in enumerate(modes)
            for b, column in enumerate(modes)
            if not K_ff[a][b].is_zero()
        ]

    def damping_force(self) -> Row:
        """-D_ff q_f_dot by system column (modal damping)."""
        D_ff, coordinates = entries(self._require_mass().D_ff), self.coordinates
        return {column: neg(dot(D_ff[a], coordinates.q_f_dot)) for a, column in enumerate(coordinates.columns[3:])}

    def gravity_force(self, gravity: list[ca.SX]) -> Row:
        """Generalised force of a uniform field of acceleration `gravity` (m/s^2)."""
        moments, columns, mass = self._moments, self.coordinates.columns, self._require_mass().mass
        force = {
            columns[0]: mul(mass, gravity[0]),
            columns[1]: mul(mass, gravity[1]),
            columns[2]: sub(mul(moments.h[0], gravity[1]), mul(moments.h[1], gravity[0])),
        }
        for a, column in enumerate(columns[3:]):
            force[column] = dot(moments.s[a], gravity)
        return force

    def gravity_potential(self, gravity: list[ca.SX]) -> ca.SX:
        """-int r . g dm, zero at the world origin."""
        R_o, h, mass = self.coordinates.R_o, self._moments.h, self._require_mass().mass
        return -gravity[0] * (mass * R_o[0] + h[0]) - gravity[1] * (mass * R_o[1] + h[1])

    def elastic_energy(self) -> tuple[ca.SX, ca.SX]:
        """(1/2 q_f^T K_ff q_f, power lost in D_ff)."""
        integrals = self._require_mass()
        q_f, q_f_dot = ca.vertcat(*self.coordinates.q_f), ca.vertcat(*self.coordinates.q_f_dot)
        return ca.SX(ca.bilin(integrals.K_ff, q_f, q_f) / 2), ca.SX(ca.bilin(integrals.D_ff, q_f_dot, q_f_dot))

    def marker(self, shape: PointShape) -> MarkerMotion:
        """Motion of a point of the body (Eq. 19), with foreshortening where the body has it."""
        q, columns = self.coordinates, self.coordinates.columns
        local = LocalPoint(shape, q.q_f, q.q_f_dot)
        a_x, a_y = self.rotate(*local.rho)
        b_x, b_y = self.rotate(*local.rho_dot)
        n_x, n_y = self.rotate(local.nu, ZERO)
        values = {
            point.a_x: a_x,
            point.a_y: a_y,
            point.b_x: b_x,
            point.b_y: b_y,
            point.n_x: n_x,
            point.n_y: n_y,
            point.R_x: q.R_o[0],
            point.R_y: q.R_o[1],
            point.R_dot_x: q.R_o_dot[0],
            point.R_dot_y: q.R_o_dot[1],
            point.theta_dot: q.theta_dot,
        }
        motion = point.kinematics_template().evaluate(values)
        rows: list[Row] = [{}, {}]
        phi_row: Row = {}
        if columns:
            rows = [{columns[0]: ONE, columns[2]: motion["theta_x"]}, {columns[1]: ONE, columns[2]: motion["theta_y"]}]
            phi_row = {columns[2]: ONE}
        for a, column in enumerate(columns[3:]):
            rows[0][column], rows[1][column] = self.rotate(*local.shapes[a])
            phi_row[column] = local.slope[a]
        turn, turn_rate = dot(local.slope, q.q_f), dot(local.slope, q.q_f_dot)
        return MarkerMotion(
            r=[motion["r_x"], motion["r_y"]],
            r_dot=[motion["r_dot_x"], motion["r_dot_y"]],
            bias=[motion["bias_x"], motion["bias_y"]],
            r_columns=[nonzero(row) for row in rows],
            phi=add(add(q.theta, shape.angle), turn),
            phi_dot=add(q.theta_dot, turn_rate),
            phi_row=nonzero(phi_row),
            direction=self._direction(shape.angle, turn),
        )

    def _direction(self, angle: ca.SX, turn: ca.SX) -> list[ca.SX]:
        """(cos phi, sin phi) of a marker, without new trigonometry where the marker does not turn."""
        offset = add(angle, turn)
        if offset.is_zero():
            return [self.cosine, self.sine]
        return list(self.rotate(ca.cos(offset), ca.sin(offset)))

    def _require_mass(self) -> ShapeIntegrals:
        assert self.integrals is not None, "the ground has no mass"
        return self.integrals
