"""One planar body of a scene: the SymPy template of its type evaluated with its SX values (Eqs. 15-20).

The coordinates of one planar body.

Shape integrals and points of a planar body at its current q_f: the values of the templates' symbols (Eq. 20).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import casadi as ca
import sympy as sp

from symgen.algebra.rows import Row, nonzero
from symgen.algebra.scalar import ONE, ZERO, add, dot, entries, mul, neg, sub, total, vector
from symgen.algebra.vectors import Matrix
from symgen.bodies import planar_template as template
from symgen.bodies.shape_integrals import PointShape, ShapeIntegrals


@dataclass(frozen=True)
class BodyCoordinates:
    """A body's share of q and q_dot as SX scalars, and its columns in q. Ground has none."""

    columns: list[int]
    R_o: list[ca.SX]
    theta: ca.SX
    q_f: list[ca.SX]
    R_o_dot: list[ca.SX]
    theta_dot: ca.SX
    q_f_dot: list[ca.SX]

    @property
    def elastic(self) -> list[int]:
        """Columns of q_f."""
        return self.columns[3:]

    @staticmethod
    def ground() -> BodyCoordinates:
        """Coordinates of the ground: constant zero, no columns."""
        return BodyCoordinates([], [ZERO, ZERO], ZERO, [], [ZERO, ZERO], ZERO, [])


HALF = ca.SX(0.5)
Rotation = Callable[[ca.SX, ca.SX], tuple[ca.SX, ca.SX]]


def times(matrix: ca.SX, column: list[ca.SX]) -> list[ca.SX]:
    """matrix @ column on scalars."""
    return [dot(row, column) for row in entries(matrix)]


class LocalPoint:
    """Body-frame quantities of one point: rho, its shapes drho/dq_a, rho_dot and the bias nu = -q_f'^T H q_f'."""

    def __init__(self, shape: PointShape, q_f: list[ca.SX], q_f_dot: list[ca.SX]) -> None:
        along, across = entries(shape.Phi) if q_f else ([], [])
        Hq, Hv = times(shape.H, q_f), times(shape.H, q_f_dot)
        moved = [sub(phi, h) for phi, h in zip(along, Hq, strict=True)]
        self.shapes = list(zip(moved, across, strict=True))
        x, y = vector(shape.position)
        self.rho = (sub(add(x, dot(along, q_f)), mul(HALF, dot(q_f, Hq))), add(y, dot(across, q_f)))
        self.rho_dot = (dot(moved, q_f_dot), dot(across, q_f_dot))
        self.nu = neg(dot(q_f_dot, Hv))
        self.slope = vector(shape.slope)


class Moments:
    """First moments (world) and pair integrals (body frame) of a body, in the symbols of the body template."""

    def __init__(self, coordinates: BodyCoordinates, rotate: Rotation, data: ShapeIntegrals) -> None:
        q_f, q_f_dot = coordinates.q_f, coordinates.q_f_dot
        S_Hq, S_Hv = times(data.S_H, q_f), times(data.S_H, q_f_dot)
        along, across = entries(data.Sb) if q_f else ([], [])
        moved = [sub(s, h) for s, h in zip(along, S_Hq, strict=True)]
        S1_x, S1_y = vector(data.S1)
        i1 = vector(data.i1)
        self.mass = data.mass
        self.h = rotate(sub(add(S1_x, dot(along, q_f)), mul(HALF, dot(q_f, S_Hq))), add(S1_y, dot(across, q_f)))
        self.hd = rotate(dot(moved, q_f_dot), dot(across, q_f_dot))
        self.hn = rotate(neg(dot(q_f_dot, S_Hv)), ZERO)
        self.s = [rotate(x, y) for x, y in zip(moved, across, strict=True)]
        # k_a = 1/2 dI/dq_a and I = I0 + q_f . (i1 + k)
        stretched = [sub(m, g) for m, g in zip(times(data.M_ff, q_f), times(data.G_H, q_f), strict=True)]
        self.k = [add(i, change) for i, change in zip(i1, stretched, strict=True)]
        self.inertia = add(data.I0, total(mul(q, add(i, k)) for q, i, k in zip(q_f, i1, self.k, strict=True)))
        self.kd = dot(self.k, q_f_dot)
        self.g = [sub(B, turn) for B, turn in zip(vector(data.B), times(data.G, q_f), strict=True)]
        self.Gd = times(data.G, q_f_dot)
        self.theta_dot = coordinates.theta_dot

    def values(self, mode: int | None) -> dict[sp.Symbol, ca.SX]:
        """Values of the template's symbols; `mode` selects the representative mode a."""
        t = template
        values = {
            t.m: self.mass,
            t.h_x: self.h[0],
            t.h_y: self.h[1],
            t.hd_x: self.hd[0],
            t.hd_y: self.hd[1],
            t.hn_x: self.hn[0],
            t.hn_y: self.hn[1],
            t.I_theta: self.inertia,
            t.kd: self.kd,
            t.theta_dot: self.theta_dot,
        }
        if mode is not None:
            values |= {
                t.k_a: self.k[mode],
                t.g_a: self.g[mode],
                t.Gd_a: self.Gd[mode],
                t.s_x: self.s[mode][0],
                t.s_y: self.s[mode][1],
            }
        return values


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

    def modal_matrices(self) -> tuple[Matrix, Matrix]:
        """K_ff and D_ff."""
        data = self._require_mass()
        return entries(data.K_ff), entries(data.D_ff)

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

    def marker(self, shape: PointShape) -> MarkerMotion:
        """Motion of a point of the body (Eq. 19), with foreshortening where the body has it."""
        q, columns = self.coordinates, self.coordinates.columns
        local = LocalPoint(shape, q.q_f, q.q_f_dot)
        a_x, a_y = self.rotate(*local.rho)
        b_x, b_y = self.rotate(*local.rho_dot)
        n_x, n_y = self.rotate(local.nu, ZERO)
        values = {
            template.a_x: a_x,
            template.a_y: a_y,
            template.b_x: b_x,
            template.b_y: b_y,
            template.n_x: n_x,
            template.n_y: n_y,
            template.R_x: q.R_o[0],
            template.R_y: q.R_o[1],
            template.R_dot_x: q.R_o_dot[0],
            template.R_dot_y: q.R_o_dot[1],
            template.theta_dot: q.theta_dot,
        }
        motion = template.kinematics_template().evaluate(values)
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
