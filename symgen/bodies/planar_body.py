"""One planar body of a scene: the SymPy template of its type evaluated with its SX values (Eqs. 15-20)."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import casadi as ca

from symgen.bodies import planar_point as point
from symgen.bodies import planar_template as template
from symgen.bodies.shape_integrals import PointShape, ShapeIntegrals
from symgen.rows import Row, scalars


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

    @staticmethod
    def ground() -> BodyCoordinates:
        """Coordinates of the ground: constant zero, no columns."""
        zero = ca.SX(0)
        return BodyCoordinates([], [zero, zero], zero, [], [zero, zero], zero, [])


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
            self.cosine, self.sine = ca.SX(1), ca.SX(0)

    def rotate(self, x: ca.SX, y: ca.SX) -> tuple[ca.SX, ca.SX]:
        """World components A(theta) (x, y)."""
        return self.cosine * x - self.sine * y, self.sine * x + self.cosine * y

    @cached_property
    def _moments(self) -> _Moments:
        assert self.integrals is not None
        return _Moments(self, self.integrals)

    def mass_entries(self) -> list[tuple[int, int, ca.SX]]:
        """Upper triangle of the body's mass matrix (Eq. 20) as (row, column, value) in system columns."""
        integrals, columns, moments = self._require_mass(), self.coordinates.columns, self._moments
        x, y, angle, modes = columns[0], columns[1], columns[2], columns[3:]
        block = template.body_template().evaluate(moments.values(None), [
            "M_RR", "M_Rtheta_x", "M_Rtheta_y", "M_thetatheta"])
        entries = [(x, x, block["M_RR"]), (y, y, block["M_RR"]), (x, angle, block["M_Rtheta_x"]),
                   (y, angle, block["M_Rtheta_y"]), (angle, angle, block["M_thetatheta"])]
        for a, column in enumerate(modes):
            row = template.body_template().evaluate(moments.values(a), ["M_Rf_x", "M_Rf_y", "M_thetaf"])
            entries += [(x, column, row["M_Rf_x"]), (y, column, row["M_Rf_y"]), (angle, column, row["M_thetaf"])]
            entries += [(column, modes[b], integrals.M_ff[a, b]) for b in range(a, len(modes))]
        return [(row, column, value) for row, column, value in entries if not value.is_zero()]

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

    def elastic_force(self) -> Row:
        """-K_ff q_f - D_ff q_f_dot by system column (K of Eq. 20, modal damping)."""
        integrals, q_f, q_f_dot = self._require_mass(), self.coordinates.q_f, self.coordinates.q_f_dot
        modes = self.coordinates.columns[3:]
        force: Row = {}
        for a, column in enumerate(modes):
            spring = sum((integrals.K_ff[a, b] * q_f[b] for b in range(len(modes))), ca.SX(0))
            damper = sum((integrals.D_ff[a, b] * q_f_dot[b] for b in range(len(modes))), ca.SX(0))
            force[column] = -spring - damper
        return force

    def gravity_force(self, gravity: list[ca.SX]) -> Row:
        """Generalised force of a uniform field of acceleration `gravity` (m/s^2)."""
        moments, columns = self._moments, self.coordinates.columns
        g_x, g_y = gravity
        force = {columns[0]: self._require_mass().mass * g_x, columns[1]: self._require_mass().mass * g_y,
                 columns[2]: moments.h[0] * g_y - moments.h[1] * g_x}
        for a, column in enumerate(columns[3:]):
            force[column] = moments.s[a][0] * g_x + moments.s[a][1] * g_y
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
        local = _LocalPoint(shape, q.q_f, q.q_f_dot)
        a_x, a_y = self.rotate(*local.rho)
        b_x, b_y = self.rotate(*local.rho_dot)
        n_x, n_y = self.rotate(local.nu, ca.SX(0))
        values = {point.a_x: a_x, point.a_y: a_y, point.b_x: b_x, point.b_y: b_y, point.n_x: n_x, point.n_y: n_y,
                  point.R_x: q.R_o[0], point.R_y: q.R_o[1], point.R_dot_x: q.R_o_dot[0],
                  point.R_dot_y: q.R_o_dot[1], point.theta_dot: q.theta_dot}
        motion = point.kinematics_template().evaluate(values)
        rows: list[Row] = [{}, {}]
        phi_row: Row = {}
        if columns:
            rows = [{columns[0]: ca.SX(1), columns[2]: motion["theta_x"]},
                    {columns[1]: ca.SX(1), columns[2]: motion["theta_y"]}]
            phi_row = {columns[2]: ca.SX(1)}
        for a, column in enumerate(columns[3:]):
            rows[0][column], rows[1][column] = self.rotate(*local.shapes[a])
            phi_row[column] = local.slope[a]
        turn = sum((s * qf for s, qf in zip(local.slope, q.q_f, strict=True)), ca.SX(0))
        turn_rate = sum((s * rate for s, rate in zip(local.slope, q.q_f_dot, strict=True)), ca.SX(0))
        return MarkerMotion(
            r=[motion["r_x"], motion["r_y"]], r_dot=[motion["r_dot_x"], motion["r_dot_y"]],
            bias=[motion["bias_x"], motion["bias_y"]], r_columns=[_nonzero(row) for row in rows],
            phi=q.theta + shape.angle + turn, phi_dot=q.theta_dot + turn_rate, phi_row=_nonzero(phi_row),
            direction=self._direction(shape.angle, turn))

    def _direction(self, angle: ca.SX, turn: ca.SX) -> list[ca.SX]:
        """(cos phi, sin phi) of a marker, without new trigonometry where the marker does not turn."""
        offset = angle + turn
        if offset.is_zero():
            return [self.cosine, self.sine]
        return list(self.rotate(ca.cos(offset), ca.sin(offset)))

    def _require_mass(self) -> ShapeIntegrals:
        assert self.integrals is not None, "the ground has no mass"
        return self.integrals


class _LocalPoint:
    """Body-frame quantities of one point: rho, its shapes dRho/dq_a, rho_dot and the bias -q_f'^T H q_f' e_x."""

    def __init__(self, shape: PointShape, q_f: list[ca.SX], q_f_dot: list[ca.SX]) -> None:
        modes = range(len(q_f))
        Hq = [sum((shape.H[a, b] * q_f[b] for b in modes), ca.SX(0)) for a in modes]
        Hv = [sum((shape.H[a, b] * q_f_dot[b] for b in modes), ca.SX(0)) for a in modes]
        self.shapes = [(shape.Phi[0, a] - Hq[a], shape.Phi[1, a] + 0) for a in modes]
        foreshortening = sum((q_f[a] * Hq[a] for a in modes), ca.SX(0)) / 2
        self.rho = (shape.position[0] + sum((shape.Phi[0, a] * q_f[a] for a in modes), ca.SX(0)) - foreshortening,
                    shape.position[1] + sum((shape.Phi[1, a] * q_f[a] for a in modes), ca.SX(0)))
        self.rho_dot = (sum((self.shapes[a][0] * q_f_dot[a] for a in modes), ca.SX(0)),
                        sum((self.shapes[a][1] * q_f_dot[a] for a in modes), ca.SX(0)))
        self.nu = -sum((q_f_dot[a] * Hv[a] for a in modes), ca.SX(0))
        self.slope = scalars(shape.slope)


class _Moments:
    """Shape integrals at the current q_f, in the symbols of the body template."""

    def __init__(self, body: PlanarBody, data: ShapeIntegrals) -> None:
        q_f, q_f_dot, modes = body.coordinates.q_f, body.coordinates.q_f_dot, range(data.nf)

        def times(matrix: ca.SX, vector: list[ca.SX]) -> list[ca.SX]:
            return [sum((matrix[a, b] * vector[b] for b in modes), ca.SX(0)) for a in modes]

        def dot(u: list[ca.SX], v: list[ca.SX]) -> ca.SX:
            return sum((x * y for x, y in zip(u, v, strict=True)), ca.SX(0))

        S_Hq, S_Hv = times(data.S_H, q_f), times(data.S_H, q_f_dot)
        local_s = [(data.Sb[0, a] - S_Hq[a], data.Sb[1, a] + 0) for a in modes]
        i1 = scalars(data.i1)
        h_x = data.S1[0] + sum((data.Sb[0, a] * q_f[a] for a in modes), ca.SX(0)) - dot(q_f, S_Hq) / 2
        h_y = data.S1[1] + sum((data.Sb[1, a] * q_f[a] for a in modes), ca.SX(0))
        hd = [sum((local_s[a][axis] * q_f_dot[a] for a in modes), ca.SX(0)) for axis in (0, 1)]
        self.mass = data.mass
        self.h = body.rotate(h_x, h_y)
        self.hd = body.rotate(hd[0], hd[1])
        self.hn = body.rotate(-dot(q_f_dot, S_Hv), ca.SX(0))
        self.s = [body.rotate(*local) for local in local_s]
        # k_a = 1/2 dI/dq_a and I = I0 + q_f . (i1 + k)
        self.k = [i + m - g for i, m, g in zip(i1, times(data.M_ff, q_f), times(data.G_H, q_f), strict=True)]
        self.inertia = data.I0 + dot(q_f, [i + k for i, k in zip(i1, self.k, strict=True)])
        self.kd = dot(self.k, q_f_dot)
        self.g = [B - Gq for B, Gq in zip(scalars(data.B), times(data.G, q_f), strict=True)]
        self.Gd = times(data.G, q_f_dot)
        self.theta_dot = body.coordinates.theta_dot

    def values(self, mode: int | None) -> dict:
        """Values of the template's symbols; `mode` selects the representative mode a."""
        t = template
        values = {t.m: self.mass, t.h_x: self.h[0], t.h_y: self.h[1], t.hd_x: self.hd[0], t.hd_y: self.hd[1],
                  t.hn_x: self.hn[0], t.hn_y: self.hn[1], t.I_theta: self.inertia, t.kd: self.kd,
                  t.theta_dot: self.theta_dot}
        if mode is not None:
            values |= {t.k_a: self.k[mode], t.g_a: self.g[mode], t.Gd_a: self.Gd[mode],
                       t.s_x: self.s[mode][0], t.s_y: self.s[mode][1]}
        return values


def _nonzero(row: Row) -> Row:
    return {column: value for column, value in row.items() if not value.is_zero()}
