"""One spatial body of a scene: its points and axes, and its share of M and Q_v (Eqs. 15-20).

The body has a floating frame of reference (Shabana): R_o and the orientation of its axes, in which q_f deforms it.
Q_v is the quadratic velocity force.

Quaternions that move with coordinates: value, rows over q, rate, and acceleration without second derivatives.

Products follow the product rule, so the constraint of a joint that places a body, e_child = e_parent K, has its rows,
its velocity and its acceleration terms from the factors of K.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import casadi as ca

from symgen.algebra.rows import Row, add_scaled, add_to, nonzero
from symgen.algebra.scalar import ONE, ZERO, div, dot, mul, neg, sub, total
from symgen.algebra.vectors import (
    Matrix,
    Vector,
    conjugate,
    cross,
    inertia_times,
    minus,
    plus,
    quaternion_product,
    scaled,
    times,
    traced,
    weighted,
    zeros,
)
from symgen.bodies.spatial_moments import (
    Deformation,
    DeformedMarker,
    LocalMotion,
    SpatialIntegrals,
    SpatialMoments,
    SpatialPoint,
)
from symgen.bodies.spatial_orientation import Orientation, fixed_orientation


@dataclass(frozen=True)
class QuaternionMotion:
    """value (4), rows[i]: column of q -> dvalue_i/dq, rate = rows q_dot, bias = rows_dot q_dot."""

    value: Vector
    rows: list[Row]
    rate: Vector
    bias: Vector

    def times(self, other: QuaternionMotion) -> QuaternionMotion:
        """Quaternion product self other."""
        rows: list[Row] = [{} for _ in range(4)]
        for column in dict.fromkeys(column for motion in (self, other) for row in motion.rows for column in row):
            left = quaternion_product([row.get(column, ZERO) for row in self.rows], other.value)
            right = quaternion_product(self.value, [row.get(column, ZERO) for row in other.rows])
            for i, entry in enumerate(plus(left, right)):
                add_to(rows[i], column, entry)
        rate = plus(quaternion_product(self.rate, other.value), quaternion_product(self.value, other.rate))
        mixed = quaternion_product(self.rate, other.rate)
        bias = plus(
            quaternion_product(self.bias, other.value), quaternion_product(self.value, other.bias), mixed, mixed
        )
        return QuaternionMotion(quaternion_product(self.value, other.value), rows, rate, bias)

    def conjugate(self) -> QuaternionMotion:
        """The opposite rotation."""
        turned: list[Row] = [self.rows[0], *({c: neg(value) for c, value in row.items()} for row in self.rows[1:])]
        return QuaternionMotion(conjugate(self.value), turned, conjugate(self.rate), conjugate(self.bias))


def fixed_quaternion(value: Vector) -> QuaternionMotion:
    """One that does not move."""
    return QuaternionMotion(value, [{} for _ in range(4)], zeros(4), zeros(4))


def free_quaternion(value: Vector, rate: Vector, columns: list[int]) -> QuaternionMotion:
    """Euler parameters that are coordinates themselves."""
    return QuaternionMotion(value, [{column: ONE} for column in columns], rate, zeros(4))


def turn_about(axis: int, angle: ca.SX, rate: ca.SX, column: int) -> QuaternionMotion:
    """Rotation about coordinate axis `axis` (0, 1, 2) by the coordinate of `column`."""
    half = div(angle, ca.SX(2))
    cosine, sine, half_rate = ca.cos(half), ca.sin(half), div(rate, ca.SX(2))
    value, slope = zeros(4), zeros(4)
    value[0], value[1 + axis] = cosine, sine
    slope[0], slope[1 + axis] = div(neg(sine), ca.SX(2)), div(cosine, ca.SX(2))
    return QuaternionMotion(
        value,
        [nonzero({column: entry}) for entry in slope],
        scaled(rate, slope),
        scaled(neg(mul(half_rate, half_rate)), value),
    )


def small_turn(turn: Vector, turn_rate: Vector, turn_columns: list[Row]) -> QuaternionMotion:
    """Rotation by deformation: (1, psi/2) of unit length for psi = turn, linear in q with rows turn_columns."""
    if all(component.is_zero() for component in turn) and not any(turn_columns):
        return fixed_quaternion([ONE, ZERO, ZERO, ZERO])
    half, half_rate = scaled(ca.SX(0.5), turn), scaled(ca.SX(0.5), turn_rate)
    square, mixed, rates = 1 + dot(half, half), dot(half, half_rate), dot(half_rate, half_rate)
    length = 1 / ca.sqrt(square)  # n, with n_dot = -mixed n^3 and n_ddot (psi_ddot = 0) = (3 mixed^2 n^2 - rates) n^3
    cube = length**3
    length_rate, length_bias = -mixed * cube, (3 * mixed**2 * length**2 - rates) * cube
    raw, raw_rate = [ONE, *half], [ZERO, *half_rate]
    rows: list[Row] = [{} for _ in range(4)]
    for k in range(3):
        add_scaled(rows[1 + k], ca.SX(0.5) * length, turn_columns[k])
        for i in range(4):
            add_scaled(rows[i], -(cube * raw[i] * half[k]) / 2, turn_columns[k])
    rate = plus(scaled(length_rate, raw), scaled(length, raw_rate))
    bias = plus(scaled(length_bias, raw), scaled(2 * length_rate, raw_rate))
    return QuaternionMotion(scaled(length, raw), [nonzero(row) for row in rows], rate, bias)


def minus_rows(rows: Row, other: Row) -> Row:
    """rows - other."""
    result = dict(rows)
    for column, value in other.items():
        result[column] = sub(result.get(column, ZERO), value)
    return nonzero(result)


@dataclass(frozen=True)
class SpatialCoordinates:
    """A body's share of q and q_dot as SX scalars, and its columns in q: R_o, theta, q_f. Ground has none."""

    columns: list[int]
    R_o: Vector
    theta: Vector
    q_f: Vector
    R_o_dot: Vector
    theta_dot: Vector
    q_f_dot: Vector

    @staticmethod
    def ground() -> SpatialCoordinates:
        """Coordinates of the ground: constant zero, no columns."""
        return SpatialCoordinates([], zeros(), [], [], zeros(), [], [])

    @property
    def orientation_columns(self) -> list[int]:
        """Columns of theta."""
        return self.columns[3 : 3 + len(self.theta)]

    @property
    def elastic(self) -> list[int]:
        """Columns of q_f."""
        return self.columns[3 + len(self.theta) :]


@dataclass(frozen=True)
class SpatialMarker:
    """A marker's motion: position r, its turning, axes (columns x, y, z in the world).

    r_columns[i] and turn_rows[i] map a column of q to dr_i/dq and to the virtual rotation about world axis i; bias and
    turn_bias are the parts of r_ddot and omega_dot without second derivatives.
    """

    r: Vector
    r_dot: Vector
    bias: Vector
    r_columns: list[Row]
    axes: list[Vector]
    omega: Vector
    turn_rows: list[Row]
    turn_bias: Vector
    local_quaternion: QuaternionMotion


class SpatialBody:
    """A rigid (nf = 0) or flexible body in space; ground is a body without coordinates or mass."""

    def __init__(
        self, name: str, coordinates: SpatialCoordinates, orientation: Orientation, integrals: SpatialIntegrals | None
    ) -> None:
        self.name, self.coordinates, self.orientation, self.integrals = name, coordinates, orientation, integrals

    @staticmethod
    def ground() -> SpatialBody:
        """The fixed frame."""
        return SpatialBody("ground", SpatialCoordinates.ground(), fixed_orientation(), None)

    def about(self, point: SpatialPoint) -> SpatialBody:
        """The body with its masses seen from a point that moves with its modes."""
        return SpatialBody(self.name, self.coordinates, self.orientation, self._require_mass().about(point))

    @cached_property
    def _moments(self) -> SpatialMoments:
        q = self.coordinates
        return SpatialMoments(self._require_mass(), q.q_f, q.q_f_dot)

    @cached_property
    def _arms(self) -> list[Vector]:
        """d(A h)/dtheta_k: the first moment's part in the translation."""
        world = self.orientation.rotate(self._moments.h)
        return [self.orientation.derivative(k, world) for k in range(len(self.coordinates.theta))]

    def mass_entries(self) -> list[tuple[int, int, ca.SX]]:
        """Upper triangle of the body's mass matrix (Eq. 20) as (row, column, value) in system columns.

        In body axes a unit rate of a turn moves the masses with axis x rho and one of a mode with phi_a: what both have
        in common are the moments of the body.
        """
        moments, data, axes = self._moments, self._require_mass(), self.orientation.body_axes
        columns, turns, elastic = (
            self.coordinates.columns,
            self.coordinates.orientation_columns,
            self.coordinates.elastic,
        )
        M_RR = data.mass
        found = [(columns[i], columns[i], M_RR) for i in range(3)]
        for k, column in enumerate(turns):
            M_Rtheta, turned = self._arms[k], inertia_times(moments.J, axes[k])
            found += [(columns[i], column, M_Rtheta[i]) for i in range(3)]
            M_thetatheta = [dot(axes[other], turned) for other in range(k + 1)]
            found += [(turns[other], column, value) for other, value in enumerate(M_thetatheta)]
        for a, column in enumerate(elastic):
            M_Rf, M_thetaf = self._pulls[a], [dot(axis, moments.B[a]) for axis in axes]
            found += [(columns[i], column, M_Rf[i]) for i in range(3)]
            found += [(turns[k], column, value) for k, value in enumerate(M_thetaf)]
            found += [(column, elastic[b], data.M_ff[a][b]) for b in range(a, len(elastic))]
        return [(row, column, value) for row, column, value in found if not value.is_zero()]

    @cached_property
    def _pulls(self) -> list[Vector]:
        """A s_a of each mode."""
        return [self.orientation.rotate(s) for s in self._moments.s]

    def quadratic_velocity_force(self) -> Row:
        """Q_v of Eq. (20) by system column.

        In body axes a mass point accelerates by w x (w x rho) + 2 w x rho' + nu, where shapes of second order leave
        nu = -q_f'^T H q_f'; its pairs with others are beyond the second order that the energy keeps.
        """
        moments, coordinates, w = self._moments, self.coordinates, self.orientation.omega_body
        twice = scaled(ca.SX(2), w)
        linear = minus(cross(plus(cross(w, moments.h), scaled(ca.SX(2), moments.hd)), w), moments.hn)
        moment = minus(cross(w, times(moments.J, w)), traced(weighted(moments.L, coordinates.q_f_dot), twice, False))
        force = dict(zip(coordinates.columns, self.orientation.rotate(linear), strict=False))
        for column, axis in zip(coordinates.orientation_columns, self.orientation.body_axes, strict=True):
            force[column] = dot(axis, moment)
        square = dot(w, w)
        for L, Gd, column in zip(moments.L, moments.Gd, coordinates.elastic, strict=True):
            outward = sub(mul(square, total(L[i][i] for i in range(3))), dot(w, times(L, w)))
            force[column] = sub(outward, dot(twice, Gd))
        return nonzero(force)

    def modal_matrices(self) -> tuple[Matrix, Matrix]:
        """K_ff and D_ff."""
        return self._require_mass().K_ff, self._require_mass().D_ff

    def gravity_force(self, gravity: Vector) -> Row:
        """Generalised force of a uniform field of acceleration `gravity` (m/s^2)."""
        columns, mass = self.coordinates.columns, self._require_mass().mass
        force = {columns[i]: mul(mass, gravity[i]) for i in range(3)}
        for k, column in enumerate(self.coordinates.orientation_columns):
            force[column] = dot(self._arms[k], gravity)
        for column, pull in zip(self.coordinates.elastic, self._pulls, strict=True):
            force[column] = dot(pull, gravity)
        return force

    def gravity_potential(self, gravity: Vector) -> ca.SX:
        """-int r . g dm, zero at the world origin."""
        mass = self._require_mass().mass
        return neg(dot(gravity, plus(scaled(mass, self.coordinates.R_o), self.orientation.rotate(self._moments.h))))

    def marker(self, point: SpatialPoint) -> SpatialMarker:
        """Motion of a point of the body and of the axes there (Eq. 19)."""
        q, orientation = self.coordinates, self.orientation
        local = LocalMotion(point, q.q_f, q.q_f_dot)
        arm, b, nu = (orientation.rotate(vector) for vector in (local.rho, local.rho_dot, local.nu))
        rows: list[Row] = [{column: ONE} for column in q.columns[:3]] or [{}, {}, {}]
        for k, column in enumerate(q.orientation_columns):
            for i, entry in enumerate(orientation.derivative(k, arm)):
                add_to(rows[i], column, entry)
        for a, column in enumerate(q.elastic):
            for i, entry in enumerate(orientation.rotate(local.shapes[a])):
                add_to(rows[i], column, entry)
        inner = plus(cross(orientation.omega, arm), b)
        bias = plus(cross(orientation.omega, plus(inner, b)), nu)
        spin = _MarkerSpin(self, point, local)
        return SpatialMarker(
            plus(q.R_o, arm),
            plus(q.R_o_dot, inner),
            bias,
            rows,
            spin.axes,
            spin.omega,
            spin.rows,
            spin.bias,
            spin.local,
        )

    def quaternion(self) -> QuaternionMotion:
        """The frame's."""
        if not self.coordinates.columns:
            return fixed_quaternion([ONE, ZERO, ZERO, ZERO])
        return free_quaternion(self.coordinates.theta, self.coordinates.theta_dot, self.coordinates.orientation_columns)

    def _require_mass(self) -> SpatialIntegrals:
        assert self.integrals is not None, "the ground has no mass"
        return self.integrals


class _MarkerSpin:
    """Axes and angular velocity of a marker: the frame's, and the rotation by deformation."""

    def __init__(self, body: SpatialBody, point: SpatialPoint, local: LocalMotion) -> None:
        q, orientation = body.coordinates, body.orientation
        self.rows: list[Row] = [{}, {}, {}]
        for k, column in enumerate(q.orientation_columns):
            for i, entry in enumerate(orientation.world_axes[k]):
                add_to(self.rows[i], column, entry)
        columns = LocalMotion.turn_rows(point, q.elastic)
        self.omega, self.bias, axes = orientation.omega, zeros(), point.axes
        if any(columns):
            axes = self._deformed(orientation, Deformation(point, q.q_f, q.q_f_dot, q.elastic).now, q.elastic)
        self.axes = [orientation.rotate([axes[i][j] for i in range(3)]) for j in range(3)]
        self.local = small_turn(local.psi, local.psi_dot, columns).times(fixed_quaternion(point.quaternion))

    def _deformed(self, orientation: Orientation, deformed: DeformedMarker, elastic: list[int]) -> list[Vector]:
        """Add the deformation's share to omega, bias and rows; the marker's axes in the frame."""
        for a, column in enumerate(elastic):
            for i, entry in enumerate(orientation.rotate(deformed.spins[a])):
                add_to(self.rows[i], column, entry)
        world = orientation.rotate(deformed.omega)
        self.bias = plus(self.bias, cross(orientation.omega, world), orientation.rotate(deformed.fading))
        self.omega = plus(self.omega, world)
        return deformed.R
