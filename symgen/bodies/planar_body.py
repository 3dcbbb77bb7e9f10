"""One planar body of a scene: its points, and its share of M and Q_v (Eqs. 15-20).

The body has a floating frame of reference (Shabana): R_o and theta, in which q_f deforms it. Q_v is the quadratic
velocity force.

A point is at r = R_o + A(theta) rho(q_f). In world components, with a = A rho, b = A rho' by q_f', the shape f of a
mode there, n = A rho'' without second derivatives, and J, which turns by 90 degrees, for d/dtheta,

    r' = R_o' + J a theta' + b,    r'' = R_o'' + J a theta'' + sum f q_a'' - a theta'^2 + 2 J b theta' + n.

The virtual work of the inertia forces of all mass points has products of at most two of these vectors. A rotation keeps
dot and cross products, so that integrals of pairs are those of the body-fixed vectors and hold no angle:

    first moments   h = int a dm,  s_a = int f dm,  hd = int b dm,  hn = int n dm          (world components)
    pairs           I = int rho.rho,  k_a = int rho.Phi_a,  g_a = int rho x Phi_a,  M_ff = int Phi_a.Phi_b,
                    kd = int rho.rho_dot,  Gd_a = int Phi_a x rho_dot

The kinetic energy is kept to second order in (q_f, q_f_dot), so pairs with the second-order vector n drop out.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import casadi as ca

from symgen.algebra.rows import Row, nonzero
from symgen.algebra.scalar import ONE, ZERO, add, dot, entries, mul, neg, sub, total, vector
from symgen.algebra.vectors import Matrix
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
    """First moments (world components) and integrals of pairs of a body at its q_f and q_f'."""

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
        moments, M_ff = self._moments, entries(self._require_mass().M_ff)
        x, y, angle, *modes = self.coordinates.columns
        M_RR, M_Rtheta, M_thetatheta = moments.mass, (neg(moments.h[1]), moments.h[0]), moments.inertia
        M_Rf, M_thetaf = moments.s, moments.g
        found = [
            (x, x, M_RR),
            (y, y, M_RR),
            (x, angle, M_Rtheta[0]),
            (y, angle, M_Rtheta[1]),
            (angle, angle, M_thetatheta),
        ]
        for a, column in enumerate(modes):
            found += [(x, column, M_Rf[a][0]), (y, column, M_Rf[a][1]), (angle, column, M_thetaf[a])]
            found += [(column, modes[b], M_ff[a][b]) for b in range(a, len(modes))]
        return [(row, column, value) for row, column, value in found if not value.is_zero()]

    def quadratic_velocity_force(self) -> Row:
        """Q_v of Eq. (20) by system column."""
        self._require_mass()
        moments, omega = self._moments, self.coordinates.theta_dot
        square, twice = mul(omega, omega), mul(ca.SX(2), omega)
        (h_x, h_y), (hd_x, hd_y), (hn_x, hn_y) = moments.h, moments.hd, moments.hn
        x, y, angle, *modes = self.coordinates.columns
        force = {
            x: sub(add(mul(square, h_x), mul(twice, hd_y)), hn_x),
            y: sub(sub(mul(square, h_y), hn_y), mul(twice, hd_x)),
            angle: mul(mul(ca.SX(-2), omega), moments.kd),
        }
        for column, k_a, Gd_a in zip(modes, moments.k, moments.Gd, strict=True):
            force[column] = add(mul(square, k_a), mul(twice, Gd_a))
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
        square, twice = mul(q.theta_dot, q.theta_dot), mul(ca.SX(2), q.theta_dot)
        moved = sub(add(q.R_o_dot[0], b_x), mul(q.theta_dot, a_y)), add(add(q.R_o_dot[1], b_y), mul(q.theta_dot, a_x))
        rotation = sub(sub(n_x, mul(square, a_x)), mul(twice, b_y)), sub(add(n_y, mul(twice, b_x)), mul(square, a_y))
        rows: list[Row] = [{}, {}]
        phi_row: Row = {}
        if columns:
            rows = [{columns[0]: ONE, columns[2]: neg(a_y)}, {columns[1]: ONE, columns[2]: a_x}]
            phi_row = {columns[2]: ONE}
        for a, column in enumerate(columns[3:]):
            rows[0][column], rows[1][column] = self.rotate(*local.shapes[a])
            phi_row[column] = local.slope[a]
        turn, turn_rate = dot(local.slope, q.q_f), dot(local.slope, q.q_f_dot)
        return MarkerMotion(
            r=[add(q.R_o[0], a_x), add(q.R_o[1], a_y)],
            r_dot=[*moved],
            bias=[*rotation],
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
