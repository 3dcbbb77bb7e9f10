"""One spatial body of a scene: templates of its inertia and orientation evaluated with its SX values (Eqs. 15-20)."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import casadi as ca

from symgen.algebra.rows import Row, add_to, nonzero
from symgen.algebra.scalar import ONE, ZERO, dot, mul, neg, sub
from symgen.algebra.vectors import Vector, cross, minus, plus, scaled, times, zeros
from symgen.bodies import spatial_template as template
from symgen.bodies.deformation import Bent, Deformation
from symgen.bodies.quaternion_motion import QuaternionMotion, fixed_quaternion, free_quaternion, small_turn
from symgen.bodies.spatial_moments import LocalMotion, SpatialIntegrals, SpatialMoments, SpatialPoint
from symgen.bodies.spatial_orientation import Orientation, fixed_orientation


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
    def turning(self) -> list[int]:
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
        self, name: str, coordinates: SpatialCoordinates, turning: Orientation, integrals: SpatialIntegrals | None
    ) -> None:
        self.name, self.coordinates, self.orientation, self.integrals = name, coordinates, turning, integrals

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
        return SpatialMoments(self._require_mass(), q.q_f, q.q_f_dot, self.orientation.omega_body)

    @cached_property
    def _whole(self) -> dict[str, ca.SX]:
        """Outputs of the body template that belong to no mode."""
        per_mode = (*template.PER_MODE, template.FORCE_ON_MODE)
        names = [name for name in template.body_template().outputs if name not in per_mode]
        return template.body_template().evaluate(self._moments.values(), names)

    @cached_property
    def _arms(self) -> list[Vector]:
        """d(A h)/dtheta_k: the first moment's part in the translation."""
        world = self.orientation.rotate(self._moments.h)
        return [self.orientation.turned(k, world) for k in range(len(self.coordinates.theta))]

    def _mode(self, a: int) -> dict[str, ca.SX]:
        names = [*template.PER_MODE, template.FORCE_ON_MODE]
        return template.body_template().evaluate(self._moments.mode_values(a), names)

    @cached_property
    def _modes(self) -> list[dict[str, ca.SX]]:
        return [self._mode(a) for a in range(len(self.coordinates.q_f))]

    def _inertia(self) -> list[Vector]:
        return [[self._whole[f"M_turnturn_{i}{j}"] for j in range(3)] for i in range(3)]

    def mass_entries(self) -> list[tuple[int, int, ca.SX]]:
        """Upper triangle of the body's mass matrix (Eq. 20) as (row, column, value) in system columns."""
        columns, data, axes = self.coordinates.columns, self._require_mass(), self.orientation.body_axes
        turning, elastic = self.coordinates.turning, self.coordinates.elastic
        found = [(columns[i], columns[i], self._whole["M_RR"]) for i in range(3)]
        inertia = self._inertia()
        for k, column in enumerate(turning):
            found += [(columns[i], column, self._arms[k][i]) for i in range(3)]
            turned = times(inertia, axes[k])
            found += [(turning[other], column, dot(axes[other], turned)) for other in range(k + 1)]
        for a, column in enumerate(elastic):
            mode = self._modes[a]
            world = self.orientation.rotate([mode[f"M_Rf_{i}"] for i in range(3)])
            found += [(columns[i], column, world[i]) for i in range(3)]
            B = [mode[f"M_turnf_{i}"] for i in range(3)]
            found += [(turning[k], column, dot(axes[k], B)) for k in range(len(turning))]
            found += [(column, elastic[b], data.M_ff[a][b]) for b in range(a, len(elastic))]
        return [(row, column, value) for row, column, value in found if not value.is_zero()]

    def quadratic_velocity_force(self) -> Row:
        """Q_v of Eq. (20) by system column."""
        columns, axes, drift = self.coordinates.columns, self.orientation.body_axes, self.orientation.bias_body
        whole = self._whole
        linear = minus([whole[f"Q_R_{i}"] for i in range(3)], cross(drift, self._moments.h))
        moment = minus([whole[f"Q_turn_{i}"] for i in range(3)], times(self._inertia(), drift))
        force = dict(zip(columns, self.orientation.rotate(linear), strict=False))
        for k, column in enumerate(self.coordinates.turning):
            force[column] = dot(axes[k], moment)
        for a, column in enumerate(self.coordinates.elastic):
            mode = self._modes[a]
            force[column] = sub(mode[template.FORCE_ON_MODE], dot([mode[f"M_turnf_{i}"] for i in range(3)], drift))
        return nonzero(force)

    def stiffness_entries(self) -> list[tuple[int, int, ca.SX]]:
        """K of Eq. (20), non-zero in K_ff only, as (row, column, value) in system columns."""
        K_ff, modes = self._require_mass().K_ff, self.coordinates.elastic
        return [
            (row, column, K_ff[a][b])
            for a, row in enumerate(modes)
            for b, column in enumerate(modes)
            if not K_ff[a][b].is_zero()
        ]

    def damping_force(self) -> Row:
        """-D_ff q_f_dot by system column (modal damping)."""
        D_ff, coordinates = self._require_mass().D_ff, self.coordinates
        return {column: neg(dot(D_ff[a], coordinates.q_f_dot)) for a, column in enumerate(coordinates.elastic)}

    def gravity_force(self, gravity: Vector) -> Row:
        """Generalised force of a uniform field of acceleration `gravity` (m/s^2)."""
        columns, mass = self.coordinates.columns, self._require_mass().mass
        force = {columns[i]: mul(mass, gravity[i]) for i in range(3)}
        for k, column in enumerate(self.coordinates.turning):
            force[column] = dot(self._arms[k], gravity)
        for a, column in enumerate(self.coordinates.elastic):
            force[column] = dot(self.orientation.rotate([self._modes[a][f"M_Rf_{i}"] for i in range(3)]), gravity)
        return force

    def gravity_potential(self, gravity: Vector) -> ca.SX:
        """-int r . g dm, zero at the world origin."""
        mass = self._require_mass().mass
        return neg(dot(gravity, plus(scaled(mass, self.coordinates.R_o), self.orientation.rotate(self._moments.h))))

    def elastic_energy(self) -> tuple[ca.SX, ca.SX]:
        """(1/2 q_f^T K_ff q_f, power lost in D_ff)."""
        data, q = self._require_mass(), self.coordinates
        stored = dot(q.q_f, times(data.K_ff, q.q_f)) if q.q_f else ZERO
        lost = dot(q.q_f_dot, times(data.D_ff, q.q_f_dot)) if q.q_f else ZERO
        return mul(ca.SX(0.5), stored), lost

    def marker(self, point: SpatialPoint) -> SpatialMarker:
        """Motion of a point of the body and of the axes there (Eq. 19)."""
        q, turning = self.coordinates, self.orientation
        local = LocalMotion(point, q.q_f, q.q_f_dot)
        arm, b, nu = (turning.rotate(vector) for vector in (local.rho, local.rho_dot, local.nu))
        rows: list[Row] = [{column: ONE} for column in q.columns[:3]] or [{}, {}, {}]
        for k, column in enumerate(q.turning):
            for i, entry in enumerate(turning.turned(k, arm)):
                add_to(rows[i], column, entry)
        for a, column in enumerate(q.elastic):
            for i, entry in enumerate(turning.rotate(local.shapes[a])):
                add_to(rows[i], column, entry)
        inner = plus(cross(turning.omega, arm), b)
        bias = plus(cross(turning.omega, plus(inner, b)), cross(turning.bias, arm), nu)
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
        return free_quaternion(self.coordinates.theta, self.coordinates.theta_dot, self.coordinates.turning)

    def _require_mass(self) -> SpatialIntegrals:
        assert self.integrals is not None, "the ground has no mass"
        return self.integrals


class _MarkerSpin:
    """Axes and angular velocity of a marker: the frame's, and the rotation by deformation."""

    def __init__(self, body: SpatialBody, point: SpatialPoint, local: LocalMotion) -> None:
        q, turning = body.coordinates, body.orientation
        self.rows: list[Row] = [{}, {}, {}]
        for k, column in enumerate(q.turning):
            for i, entry in enumerate(turning.world_axes[k]):
                add_to(self.rows[i], column, entry)
        columns = LocalMotion.turn_rows(point, q.elastic)
        self.omega, self.bias, axes = turning.omega, turning.bias, point.axes
        if any(columns):
            axes = self._deformed(turning, Deformation(point, q.q_f, q.q_f_dot, q.elastic).now, q.elastic)
        self.axes = [turning.rotate([axes[i][j] for i in range(3)]) for j in range(3)]
        self.local = small_turn(local.psi, local.psi_dot, columns).times(fixed_quaternion(point.quaternion))

    def _deformed(self, turning: Orientation, bent: Bent, elastic: list[int]) -> list[Vector]:
        """Add the deformation's share to omega, bias and rows; the marker's axes in the frame."""
        for a, column in enumerate(elastic):
            for i, entry in enumerate(turning.rotate(bent.turned[a])):
                add_to(self.rows[i], column, entry)
        world = turning.rotate(bent.omega)
        self.bias = plus(self.bias, cross(turning.omega, world), turning.rotate(bent.fading))
        self.omega = plus(self.omega, world)
        return bent.R
