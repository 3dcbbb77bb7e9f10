"""The normal force of a beam without axial shapes, by equilibrium of the part beyond a section.

    N(x) = e(x) . [ joint forces and loads beyond x  -  int_x^L (a - g) dm ]

e(x) is the axis of the section, turned as a marker there is; a is the acceleration of the mass points (Eqs. 15-20),
which q'' makes known. What a joint does to the frame is -C_q^T lam (Eq. 22). Joints and loads act at one marker of the
beam; loads along it say what of them is beyond a section. `runtime/results/section_forces.py` has the like for results,
with moments and shear forces.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, NoReturn

import casadi as ca
import numpy as np

from runtime.contract.flexible import gauss_points, panels_for
from symgen.algebra.parameters import ParameterTable
from symgen.algebra.rows import Row
from symgen.algebra.scalar import ONE, ZERO, div, dot, entries, mul, neg, sub
from symgen.algebra.vectors import Matrix, Vector, cross, minus, plus, scaled, transposed_times, zeros
from symgen.bodies.beam_sets import BENDING_AXES, mode_sets
from symgen.scene import BeamBody, BeamMarker
from symgen.system.constraint import DerivationError
from symgen.system.equations import Equations

if TYPE_CHECKING:
    from symgen.mechanism.scene import SceneRecord


@dataclass(frozen=True)
class BeamFrame:
    """Motion of the frame of a beam: three components each, those out of the plane zero.

    mesh: key of the shapes. place, turning, elastic: columns of R_o, of the orientation and of the modes. A: its axes
    in the world, by rows. turns: turning axis of a unit rate of each coordinate of `turning`, in the axes of the body;
    gram: the sum of their squares along each axis. omega, alpha: angular velocity and acceleration, a_o: acceleration
    of the origin, in the axes of the body.
    """

    mesh: str
    place: list[int]
    turning: list[int]
    elastic: list[int]
    A: Matrix
    turns: list[Vector]
    gram: float
    omega: Vector
    alpha: Vector
    a_o: Vector

    def force(self, row: Row) -> Vector:
        """In the axes of the body, of a generalised force."""
        return self.into_body([row.get(column, ZERO) for column in self.place])

    def moment(self, row: Row) -> Vector:
        """About the origin, in the axes of the body, of a generalised force."""
        parts = [scaled(row.get(column, ZERO), axis) for column, axis in zip(self.turning, self.turns, strict=True)]
        return scaled(ca.SX(1 / self.gram), plus(*parts))

    def into_body(self, world: Vector) -> Vector:
        """A vector of the world, of two or three components."""
        return transposed_times(self.A, [*world, *zeros(3 - len(world))])


@dataclass(frozen=True)
class Attached:
    """What acts on the frame of a beam by a generalised force, at the fraction `at` of its length; None: it slides."""

    force: Row
    at: float | None


class AxialForce:
    """N of one beam at any section.

    Raises DerivationError, naming `item`, where a force on the beam has no one place on it, or no law.
    """

    def __init__(
        self, scene: SceneRecord, body: BeamBody, frame: BeamFrame, eq: Equations, table: ParameterTable, item: str
    ) -> None:
        self.body, self.frame, self.eq, self.table = body, frame, eq, table
        self.length = table.of(body, "length")
        attachments = _Attachments(scene, body, frame, eq, item)
        self.attached, self.spread = attachments.at_places(), attachments.along_the_beam()
        self.gravity = frame.into_body(list(eq.gravity))

    def at(self, xi: float) -> ca.SX:
        """N [N], tension positive, at the fraction xi of the length."""
        spread = [self.frame.into_body(list(beyond(xi))) for beyond in self.spread]
        force = plus(self._inertia(xi), *(self._beyond(one, xi) for one in self.attached), *spread)
        return dot(self._axis(xi), force)

    def _inertia(self, xi: float) -> Vector:
        """-int (a - g) dm over the part beyond xi, in the axes of the body."""
        eq, frame, own = self.eq, self.frame, self.frame.elastic
        mass = self.table.of(self.body, "density") * self.table.of(self.body, "area") * self.length
        span, center = self._numbers([[1.0 - xi, (1.0 - xi**2) / 2]], f"{xi!r}.span")[0]
        rho, rate, a = ([ZERO] * 3 for _ in range(3))
        rho[0] = mul(center, self.length)
        first = 0
        for axis, modes in mode_sets(self.body):
            columns = own[first : first + modes.modes]
            first += modes.modes
            b, b_dot, b_ddot = ([source[c] for c in columns] for source in (eq.q, eq.q_dot, eq.q_ddot))
            if axis in BENDING_AXES:
                phi = self._numbers(_beyond_of(modes.functions.at, modes.modes, xi)[None, :], f"{xi!r}.{axis}.phi")[0]
                for vector, values in ((rho, b), (rate, b_dot), (a, b_ddot)):
                    vector[axis] = dot(phi, values)
            if not self.body.stiffening:
                continue
            H = self._numbers(_shortening_beyond(modes.functions.at, modes.modes, xi), f"{xi!r}.{axis}.H")
            by = div(self._polar(axis), self.length)
            rho[0] = sub(rho[0], mul(by, _form(b, H, b)) / 2)
            rate[0] = sub(rate[0], mul(by, _form(b, H, b_dot)))
            a[0] = sub(a[0], mul(by, _form(b_dot, H, b_dot) + _form(b, H, b_ddot)))
        omega, alpha = frame.omega, frame.alpha
        turned = plus(cross(alpha, rho), cross(omega, cross(omega, rho)), scaled(ca.SX(2), cross(omega, rate)))
        whole = plus(a, turned, scaled(span, minus(frame.a_o, self.gravity)))
        return scaled(neg(mass), whole)

    def _polar(self, axis: int) -> ca.SX:
        """What foreshortening by these shapes is multiplied by: I_p / A of torsion [m^2]."""
        if axis in BENDING_AXES:
            return ONE
        return (
            self.table.of(self.body, "second_moment") + self.table.of(self.body, "second_moment_z")
        ) / self.table.of(self.body, "area")

    def _axis(self, xi: float) -> Vector:
        """The axis of the section in the axes of the body, turned by the rotation vector psi as a marker there is."""
        point, first = np.array([xi]), 0
        psi = zeros()
        for axis, modes in mode_sets(self.body):
            columns = self.frame.elastic[first : first + modes.modes]
            first += modes.modes
            order = 1 if axis in BENDING_AXES else 0
            values = self._numbers([modes.functions.at(point, order)[0]], f"{xi!r}.{axis}.turn")[0]
            turn = dot(values, [self.eq.q[c] for c in columns])
            if axis not in BENDING_AXES:
                psi[0] = turn
            elif axis == 1:
                psi[2] = div(turn, self.length)
            else:
                psi[1] = neg(div(turn, self.length))
        if len(self.frame.turning) == 1:
            return [ca.cos(psi[2]), ca.sin(psi[2]), ZERO]
        x, y, z = psi  # first column of 1 + (psi~ + psi~ psi~ / 2) / (1 + psi^2 / 4)
        k = 1 + dot(psi, psi) / 4
        return [1 - (y * y + z * z) / (2 * k), (z + x * y / 2) / k, (x * z / 2 - y) / k]

    def _beyond(self, one: Attached, xi: float) -> Vector:
        """The force of what acts beyond xi, in the axes of the body."""
        F = self.frame.force(one.force)
        if one.at is not None:
            return F if one.at > xi or one.at == xi == 1.0 else zeros()
        M = self.frame.moment(one.force)
        square = F[1] ** 2 + F[2] ** 2
        place = (M[2] * F[1] - M[1] * F[2]) / ca.fmax(square, NO_FORCE)
        return scaled(ca.if_else(place > xi * self.length, ONE, ZERO), F)

    def _numbers(self, values: Sequence[Sequence[float]] | np.ndarray, label: str) -> Matrix:
        name = f"{self.frame.mesh}>{label}"
        return entries(self.table.data(np.array(values), name, "1", "integral of the shapes beyond a section"))


NO_FORCE = 1e-300  # N^2: keeps the place of a force that is not there finite
Shapes = Callable[..., np.ndarray]


def _beyond_of(shapes: Shapes, count: int, xi: float) -> np.ndarray:
    """(n,) int_xi^1 phi."""
    points, weights = gauss_points(panels_for(count), 1.0 - xi)
    return np.asarray(weights @ shapes(xi + points))


def _shortening_beyond(shapes: Shapes, count: int, xi: float) -> np.ndarray:
    """(n, n) int_xi^1 int_0^s phi'^T phi' ds' ds = (1 - xi) int_0^xi phi'^T phi' + int_xi^1 (1 - s) phi'^T phi'."""
    found = np.zeros((count, count))
    for start, end, constant in ((0.0, xi, True), (xi, 1.0, False)):
        points, weights = gauss_points(panels_for(count), end - start)
        rate = shapes(start + points, 1)
        weights = weights * ((1.0 - xi) if constant else (1.0 - start - points))
        found += rate.T @ (weights[:, None] * rate)
    return found


def _form(left: Sequence[ca.SX], H: Matrix, right: Sequence[ca.SX]) -> ca.SX:
    return dot(left, [dot(row, right) for row in H])


class _Attachments:
    """What acts on a beam, each with its place. Raises DerivationError for what has none."""

    def __init__(self, scene: SceneRecord, body: BeamBody, frame: BeamFrame, eq: Equations, item: str) -> None:
        self.scene, self.body, self.frame, self.eq, self.item = scene, body, frame, eq, item

    def along_the_beam(self) -> list[Callable[[float], Sequence[ca.SX]]]:
        """Of loads that act along it: what of them acts beyond a fraction of the length, in the world."""
        on_it = [load.name for load in self.scene.loads if self.body.name in load.acts_at]
        return [self.eq.loads_beyond[name] for name in on_it if name in self.eq.loads_beyond]

    def at_places(self) -> list[Attached]:
        """Of joints by their multipliers, then of loads at markers."""
        self._refuse_held()
        self._refuse_straps()
        pulling: dict[str, Row] = {}
        for row, lam in zip(self.eq.constraints, self.eq.lam, strict=True):
            if self._pulls(row.C_q):
                force = pulling.setdefault(row.joint, {})
                for column in (*self.frame.place, *self.frame.turning):
                    if column in row.C_q:
                        force[column] = sub(force.get(column, ZERO), mul(row.C_q[column], lam))
        acting = [(name, row) for name, row in self.eq.load_forces.items() if name not in self.eq.loads_beyond]
        acting = [*pulling.items(), *((name, row) for name, row in acting if self._pulls(row))]
        return [Attached(force, self._where(name)) for name, force in acting]

    def _pulls(self, row: Mapping[int, ca.SX]) -> bool:
        return any(column in row and not row[column].is_zero() for column in self.frame.place)

    def _refuse_held(self) -> None:
        for one in self.eq.elements:
            if self._pulls(one.row):
                self._refuse(f"what holds joint '{one.joint}' on it, where it sticks or rests, is no force of a law")

    def _refuse_straps(self) -> None:
        """Loads between two places of the beam, whose resultant on it is none."""
        for load in self.scene.loads:
            own = [one for one in load.record(self.scene)[1].values() if self._fraction(one) is not None]
            if len(own) > 1 and "force" in load.reaction_kind(self.scene):
                self._refuse(f"'{load.name}' acts on it at more than one marker")

    def _where(self, name: str) -> float | None:
        """The fraction of the length at which a joint or a load acts; None of what slides along the beam."""
        joint = next((one for one in self.scene.joints if one.name == name), None)
        load = next((one for one in self.scene.loads if one.name == name), None)
        markers: list[str] = []
        if joint is not None:
            if joint.on_beam and joint.marker_a.partition(".")[0] == self.body.name:
                return None
            markers = [joint.marker_a, joint.marker_b]
        elif load is not None:
            markers = list(load.record(self.scene)[1].values())
        places = [at for one in markers if (at := self._fraction(one)) is not None]
        if len(places) != 1:
            self._refuse(f"'{name}' acts on it at {'no' if not places else 'more than one'} marker")
        return places[0]

    def _fraction(self, reference: str) -> float | None:
        """Where a marker is along the beam; None of another body."""
        body, marker = self.scene.marker(reference)
        return float(marker.at) if body.name == self.body.name and isinstance(marker, BeamMarker) else None

    def _refuse(self, reason: str) -> NoReturn:
        raise DerivationError(
            self.item,
            f"needs the normal force of beam '{self.body.name}', and {reason}",
            f"give '{self.body.name}' axial modes, whose stretch is its normal force",
        )
