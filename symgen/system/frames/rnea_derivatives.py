"""How wrenches change where the motion of a frame does, all that is beyond it moving along.

With a change (u, beta, d) of a frame at O, in its axes: u of omega, d of a, and beta = d(alpha) + omega x u, the point
at rho, which moves with V relative to O, gains the acceleration d + beta x rho + 2 u x V. Hence, with p = int V dm,
Lambda = int rho V^T dm and K = tr(Lambda) - Lambda^T,

    df = m d + beta x h + 2 u x p,    dn = h x d + I beta + 2 K u.

How the inertia force of a body changes with its own modes, their rates, and the motion of its frame.

How the motion of a frame, and the powers of a wrench on the modes that lead there, change by those modes.

What several modes do alike is done once and each has its share: all that shift a marker along one axis of the body, and
all that turn it about one axis of psi. What one mode does to the turns of another is a form of their axes of psi too.

Derivatives of the inertia forces of a tree of frames by its coordinates and rates, at fixed accelerations.

From the tips to the ground each frame carries what is beyond it: its `Tangent`, for each coordinate there the change of
the wrench that the frame passes on, and for each force there the row that gives it for a change of the frame's motion.
Composite bodies make this O(1) a pair of coordinates, one of which is beyond the other.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from functools import cached_property

import casadi as ca

from symgen.algebra.rows import Row, add_to
from symgen.algebra.scalar import ONE, ZERO, add, dot, mul, neg, sub, vector
from symgen.algebra.vectors import (
    Matrix,
    Vector,
    combination,
    cross,
    inertia_times,
    minus,
    negative,
    plus,
    product,
    scaled,
    times,
    traced,
    weighted,
    zeros,
)
from symgen.bodies.spatial_moments import Deformation, DeformedMarker, SharedMotion
from symgen.system.frames.fields import (
    TWO,
    Change,
    Field,
    FieldPart,
    Rates,
    TransformState,
    cross_wrench,
    joint_parts,
    relative_motion,
)
from symgen.system.frames.joint_transforms import JointNode, MarkerNode, Node
from symgen.system.frames.spatial_algebra import (
    NOTHING,
    Force,
    FrameMotion,
    Inertia,
    Motion,
    both_rotated_back,
    gather,
    no_masses,
    transposed,
)
from symgen.system.frames.tree import GROUND, FlexibleNode, FrameTree, RigidNode


@dataclass(frozen=True)
class RowChange:
    """What a generalised force gains: nu . beta + phi . d + r . u."""

    nu: Vector
    phi: Vector
    r: Vector

    def of(self, change: Change) -> ca.SX:
        """For a change of the frame."""
        return add(add(dot(self.nu, change.beta), dot(self.phi, change.d)), dot(self.r, change.u))

    def scaled(self, factor: ca.SX) -> RowChange:
        """Of a share."""
        return RowChange(scaled(factor, self.nu), scaled(factor, self.phi), scaled(factor, self.r))

    def plus(self, other: RowChange) -> RowChange:
        """Of both."""
        return RowChange(plus(self.nu, other.nu), plus(self.phi, other.phi), plus(self.r, other.r))


@dataclass(frozen=True)
class Tangent:
    """What is beyond a frame: its inertia, 2 p and 2 Lambda."""

    inertia: Inertia
    p: Vector
    Lambda: Matrix

    @staticmethod
    def of(inertia: Inertia, motion: FrameMotion) -> Tangent:
        """Of masses that are fixed in the frame: 2 Lambda = 2 omega x the rows of Sigma."""
        twice = scaled(ca.SX(2), motion.omega)
        return Tangent(inertia, cross(twice, inertia.h), [cross(twice, row) for row in inertia.Sigma])

    def moving(self, p: Vector, Lambda: Matrix) -> Tangent:
        """With what motion in the frame adds to 2 p and to 2 Lambda."""
        return replace(self, p=plus(self.p, p), Lambda=_sum(self.Lambda, Lambda))

    def plus(self, other: Tangent) -> Tangent:
        """Of both, about the same origin."""
        return Tangent(self.inertia.plus(other.inertia), plus(self.p, other.p), _sum(self.Lambda, other.Lambda))

    def wrench(self, change: Change) -> Force:
        """df and dn."""
        m, h, Sigma = self.inertia.m, self.inertia.h, self.inertia.Sigma
        f = plus(scaled(m, change.d), cross(change.beta, h), cross(change.u, self.p))
        n = plus(cross(h, change.d), inertia_times(Sigma, change.beta), traced(self.Lambda, change.u, False))
        return Force(f, n)

    def row(self, twist: Motion) -> RowChange:
        """Of the power on a twist."""
        m, h, Sigma = self.inertia.m, self.inertia.h, self.inertia.Sigma
        return RowChange(
            plus(inertia_times(Sigma, twist.omega), cross(h, twist.v)),
            plus(cross(twist.omega, h), scaled(m, twist.v)),
            plus(traced(self.Lambda, twist.omega, True), cross(self.p, twist.v)),
        )

    def about(self, axis: int, cosine: ca.SX, sine: ca.SX) -> Tangent:
        """In axes from which the frame's are turned about one of them."""
        at_p = Inertia(ZERO, self.p, [zeros() for _ in range(3)]).about(axis, cosine, sine).h
        Lambda = both_rotated_back(self.Lambda, axis, cosine, sine, symmetric=False)
        return Tangent(self.inertia.about(axis, cosine, sine), at_p, Lambda)

    def rotated(self, R: Matrix) -> Tangent:
        """In axes in which those of the frame are the columns of R."""
        rotated = product(product(R, self.Lambda), transposed(R))
        return Tangent(self.inertia.rotated(R), times(R, self.p), rotated)

    def shifted(self, arm: Vector, twice_velocity: Vector) -> Tangent:
        """About the point from which the origin is at `arm`, moving with half of twice_velocity."""
        inertia = self.inertia.shifted(arm)
        p = plus(self.p, scaled(self.inertia.m, twice_velocity))
        h = self.inertia.h
        Lambda = [
            [add(self.Lambda[i][j], add(mul(arm[i], p[j]), mul(h[i], twice_velocity[j]))) for j in range(3)]
            for i in range(3)
        ]
        return Tangent(inertia, p, Lambda)


def _sum(a: Matrix, b: Matrix) -> Matrix:
    return [plus(x, y) for x, y in zip(a, b, strict=True)]


@dataclass(frozen=True)
class ModeChange:
    """Change of the wrench and of the force on each mode, by column."""

    wrench: Force
    modes: Row


def tangent_of(inertia: FlexibleNode, motion: FrameMotion, rates: Row) -> Tangent:
    """Of the body alone."""
    found = Tangent.of(inertia.rigid, motion)
    moments, own = inertia.moments(rates), inertia.own(rates)
    Lambda = [scaled(TWO, row) for row in weighted(moments.L, own)]
    return found.moving(scaled(TWO, moments.hd), Lambda)


def mode_rows(inertia: FlexibleNode, motion: FrameMotion, rates: Row) -> dict[int, RowChange]:
    """Of the force on each mode, by column."""
    moments, twice = inertia.moments(rates), scaled(TWO, motion.omega)
    found = {}
    for a, column in enumerate(inertia.columns):
        r = minus(scaled(TWO, moments.Gd[a]), traced(moments.L[a], twice, True))
        found[column] = RowChange(moments.B[a], moments.s[a], r)
    return found


def by_modes(
    inertia: FlexibleNode, motion: FrameMotion, rates: Row, accelerations: Row
) -> tuple[dict[int, ModeChange], dict[int, ModeChange]]:
    """Derivatives of the inertia force by q_f and by q_f', by column, the motion of the frame held."""
    given = [*motion.omega, *motion.alpha, *motion.a]
    symbols = ca.SX.sym("held", len(given))
    omega, alpha, a = (ca.vertsplit(part) for part in ca.vertsplit(symbols, 3))
    wrench, modes = inertia.inertia_force(FrameMotion(omega, alpha, a), rates, accelerations)
    values, n = ca.vertcat(*wrench.f, *wrench.n, *modes.values()), len(modes)
    slopes = ca.jacobian(values, ca.vertcat(*inertia.q_f, *inertia.own(rates)))
    columns = [vector(column) for column in ca.horzsplit(ca.substitute(slopes, symbols, ca.vertcat(*given)))]
    found = [ModeChange(Force(one[:3], one[3:6]), dict(zip(modes, one[6:], strict=True))) for one in columns]
    return dict(zip(modes, found[:n], strict=True)), dict(zip(modes, found[n:], strict=True))


HALF = ca.SX(0.5)


@dataclass(frozen=True)
class _Bending:
    """A marker's place rho and turning as the modes of its body move them, in body axes, which move with `body`."""

    deformation: Deformation
    body: FrameMotion
    rates: Row
    accelerations: Row

    @cached_property
    def deformed(self) -> DeformedMarker:
        return self.deformation.at(self.rates)

    @cached_property
    def _own(self) -> tuple[Vector, Vector]:
        return self.deformation.of(self.rates), self.deformation.of(self.accelerations)

    def _fading(self, one: SharedMotion) -> tuple[Vector, Vector]:
        """The first two rates of a shape, which is that of one mode where it has any."""
        H = self.deformation.point.H
        if not H:
            return zeros(), zeros()
        b = self.deformation.columns.index(next(iter(one.shares)))
        first, second = ([neg(dot(block[b], values)) for block in H] for values in self._own)
        return first, second

    @cached_property
    def _rotation_vector(self) -> tuple[Vector, Vector, ca.SX, ca.SX]:
        """psi' and psi'' with 1 / (2 k), k' / k and k'' / k, where k = 1 + psi.psi / 4."""
        turns, (speeds, own) = self.deformation.point.turns, self._own
        first, second, deformed = combination(turns, speeds), combination(turns, own), self.deformed
        half = mul(HALF, deformed.inverse)
        rate = mul(half, dot(deformed.psi, first))
        bending = mul(half, add(dot(first, first), dot(deformed.psi, second)))
        return scaled(half, first), scaled(half, second), rate, bending

    def spin(self, one: SharedMotion) -> Rates:
        """The axis about which the marker turns for a unit rate, its D and D^2."""
        if _nothing(one.theta):
            return zeros(), zeros(), zeros()
        deformed, theta = self.deformed, one.theta
        value = scaled(deformed.inverse, plus(theta, scaled(HALF, cross(deformed.psi, theta))))
        first, second, rate, bending = self._rotation_vector
        own = minus(cross(first, theta), scaled(rate, value))
        more = minus(cross(second, theta), plus(scaled(mul(TWO, rate), own), scaled(bending, value)))
        return self._in_axes(value, own, more)

    def shape(self, one: SharedMotion) -> Rates:
        """By what the marker moves for a unit rate, its D and D^2."""
        return self._in_axes(one.shape, *self._fading(one))

    def _in_axes(self, value: Vector, rate: Vector, second: Vector) -> Rates:
        omega = self.body.omega
        first = plus(rate, cross(omega, value))
        return value, first, plus(second, cross(scaled(TWO, omega), rate), times(self.body.G, value))

    def on_turns_changed(self, one: SharedMotion, moment: Vector) -> Vector:
        """d(on_turns(moment)) for a unit of what is shared, at a fixed moment."""
        half, deformed = mul(HALF, self.deformed.inverse), self.deformed
        fewer = scaled(mul(half, dot(deformed.psi, one.theta)), deformed.on_turns(moment))
        return minus(scaled(half, cross(moment, one.theta)), fewer)


def parts_of(transform: Node, moved: TransformState) -> list[FieldPart]:
    """What the coordinates of a transform do."""
    return BendChanges(transform, moved).parts if isinstance(transform, MarkerNode) else joint_parts(transform, moved)


class BendChanges:
    """Of the motion by the modes that lead to a marker or back from it, and of the powers of a wrench on them."""

    def __init__(self, transform: MarkerNode, moved: TransformState) -> None:
        self._move, self._back, self._deformation = transform, transform.back, transform.deformation
        body = moved.after if transform.back else moved.before
        self._bending = _Bending(transform.deformation, body, moved.rates, moved.accelerations)
        self._moved = moved

    @cached_property
    def parts(self) -> list[FieldPart]:
        """By what is shared; back from the marker, the frame moves against it."""
        return [FieldPart(one.shares, self._field(one)) for one in self._deformation.shared]

    def _field(self, one: SharedMotion) -> Field:
        rotation, moving = self._bending.spin(one), self._bending.shape(one)
        if not self._back:
            return Field(rotation, moving).transformed(self._move)
        (t, t1, t2), (s, s1, s2) = ([negative(vector) for vector in rates] for rates in (rotation, moving))
        return Field((t, t1, t2), (s, s1, s2)).shifted(relative_motion(self._move, self._moved))

    def powers(self, column: int, wrench: Force, change: Force) -> Row:
        """Changes of the powers by a mode, for the wrench after the transform and its change in the axes there."""
        bending, point = self._bending, self._deformation.point
        shares = [(one, one.shares[column]) for one in self._deformation.shared if column in one.shares]
        f, moment = self._move.at_marker(wrench)
        df, dn = self._move.at_marker(change)
        rotation = bending.deformed.on_turns(plus(dn, *(self._carried(one, share, f, moment) for one, share in shares)))
        for one, share in shares:
            rotation = plus(rotation, scaled(share, bending.on_turns_changed(one, moment)))
            if not self._back:
                df = plus(df, scaled(share, cross(bending.spin(one)[0], f)))
        found, b = {}, self._deformation.columns.index(column)
        for a, other in enumerate(self._deformation.columns):
            value = add(dot(bending.deformed.shapes[a], df), dot(point.turns[a], rotation))
            for i, H in enumerate(point.H):
                value = sub(value, mul(H[a][b], f[i]))
            found[other] = neg(value) if self._back else value
        return found

    def among(self, wrench: Force) -> list[list[ca.SX]]:
        """Change of the power on each part, by rows, by each part, for a wrench after the transform."""
        shared, point = self._deformation.shared, self._deformation.point
        f, moment = self._move.at_marker(wrench)
        found = [[ZERO] * len(shared) for _ in shared]
        for k, one in enumerate(shared):
            rotation = self._bending.deformed.on_turns(self._carried(one, ONE, f, moment))
            rotation = plus(rotation, self._bending.on_turns_changed(one, moment))
            df = zeros() if self._back else cross(self._bending.spin(one)[0], f)
            for i, row in enumerate(shared):
                value = add(dot(row.shape, df), dot(row.theta, rotation))
                for axis, H in enumerate(point.H):
                    a, b = (self._deformation.columns.index(next(iter(mode.shares))) for mode in (row, one))
                    value = sub(value, mul(H[a][b], f[axis]))
                found[i][k] = neg(value) if self._back else value
        return found

    def _carried(self, one: SharedMotion, share: ca.SX, f: Vector, moment: Vector) -> Vector:
        """Change of the moment in body axes: the wrench turns with the marker, or the marker moves along its force."""
        own = negative(cross(one.shape, f)) if self._back else cross(self._bending.spin(one)[0], moment)
        return scaled(share, own)


def _nothing(values: Vector) -> bool:
    return all(value.is_zero() for value in values)


def has_force_changes(tree: FrameTree) -> bool:
    """Are all transforms of the kinds that are differentiated here: hinges, slides, markers of flexible bodies?"""
    return all(frame.nodes == frame.transforms for frame in tree.frames)


def force_changes(tree: FrameTree, n: int, base: Vector, rates: Row, accelerations: Row) -> tuple[list[Row], list[Row]]:
    """(d/dq, d/dq') of `inverse_dynamics`, n rows by column."""
    sweep = ForceSweep(n, rates, accelerations)
    sweep.tree(tree, base)
    return sweep.K, sweep.D


@dataclass
class Subtree:
    """What a frame carries: by column, the changes of its wrench and the rows of forces."""

    tangent: Tangent
    wrench: Force = NOTHING
    by_position: dict[int, Force] = field(default_factory=dict)
    by_rate: dict[int, Force] = field(default_factory=dict)
    rows: dict[int, RowChange] = field(default_factory=dict)

    def add(self, other: Subtree) -> None:
        """Of both."""
        self.tangent = self.tangent.plus(other.tangent)
        self.wrench = self.wrench.plus(other.wrench)
        gather(self.by_position, other.by_position)
        gather(self.by_rate, other.by_rate)
        for column, row in other.rows.items():
            self.rows[column] = self.rows[column].plus(row) if column in self.rows else row

    def carry_before(self, transform: Node, moved: TransformState, parts: list[FieldPart]) -> None:
        """Carry rows, inertia and wrench to the place before a transform."""
        for part in parts:
            row = self.tangent.row(part.field.twist)
            for column, share in part.shares.items():
                own = row.scaled(share)
                self.rows[column] = self.rows[column].plus(own) if column in self.rows else own
        velocity = scaled(TWO, relative_motion(transform, moved).V)
        self.rows = {column: _row_before(transform, row, velocity) for column, row in self.rows.items()}
        self.tangent = _tangent_before(transform, velocity, self.tangent)
        self.wrench = transform.wrench(self.wrench)


def _no_subtree() -> Subtree:
    return Subtree(Tangent(no_masses(), zeros(), [zeros() for _ in range(3)]))


class ForceSweep:
    """From the tips to the ground at some rates and accelerations; K and D, n rows by column, are the result."""

    def __init__(self, n: int, rates: Row, accelerations: Row) -> None:
        self.K: list[Row] = [{} for _ in range(n)]
        self.D: list[Row] = [{} for _ in range(n)]
        self._rates, self._accelerations = rates, accelerations

    def tree(self, tree: FrameTree, base: Vector) -> None:
        """All frames; base: acceleration of the ground."""
        transforms: list[list[TransformState]] = []
        motions: list[FrameMotion] = []
        for frame in tree.frames:
            motion = FrameMotion(zeros(), zeros(), base) if frame.parent == GROUND else motions[frame.parent]
            transforms.append([])
            for transform in frame.nodes:
                before, motion = motion, transform.motion(motion, self._rates, self._accelerations)
                transforms[-1].append(TransformState(before, motion, self._rates, self._accelerations))
            motions.append(motion)
        states = [_no_subtree() for _ in tree.frames]
        for k in reversed(range(len(tree.frames))):
            frame, state = tree.frames[k], states[k]
            if frame.inertia is not None:
                state.add(self.body(frame.inertia, motions[k]))
            for transform, moved in zip(reversed(frame.nodes), reversed(transforms[k]), strict=True):
                self.through(transform, moved, state)
            if frame.parent != GROUND:
                states[frame.parent].add(state)

    def body(self, inertia: RigidNode | FlexibleNode, motion: FrameMotion) -> Subtree:
        """A body at its frame."""
        wrench, _ = inertia.inertia_force(motion, self._rates, self._accelerations)
        if isinstance(inertia, RigidNode):
            return Subtree(Tangent.of(inertia.rigid, motion), wrench)
        places, speeds = by_modes(inertia, motion, self._rates, self._accelerations)
        for target, changes in ((self.K, places), (self.D, speeds)):
            for column, change in changes.items():
                for row, value in change.modes.items():
                    add_to(target[row], column, value)
        return Subtree(
            tangent_of(inertia, motion, self._rates),
            wrench,
            {column: change.wrench for column, change in places.items()},
            {column: change.wrench for column, change in speeds.items()},
            mode_rows(inertia, motion, self._rates),
        )

    def through(self, transform: Node, moved: TransformState, state: Subtree) -> None:
        """All that is beyond a transform, as seen before it, in place."""
        bending = BendChanges(transform, moved) if isinstance(transform, MarkerNode) else None
        parts = parts_of(transform, moved) if bending is None else bending.parts
        carried: dict[int, Force] = {}
        for part in parts:
            by_position, by_rate = part.field.by_position(moved.after.a), part.field.by_rate
            for row, form in state.rows.items():
                self._shared(self.K, row, part, form.of(by_position))
                self._shared(self.D, row, part, form.of(by_rate))
            gather(state.by_position, _shares(part, state.tangent.wrench(by_position)))
            gather(state.by_rate, _shares(part, state.tangent.wrench(by_rate)))
            gather(carried, _shares(part, cross_wrench(part.field.twist, state.wrench)))
        for column, wrench in state.by_position.items():
            own = bending is not None and column in carried
            powers = bending.powers(column, state.wrench, wrench) if bending and own else transform.powers(wrench)
            for row, value in powers.items():
                add_to(self.K[row], column, value)
            state.by_position[column] = transform.wrench(wrench.plus(carried.get(column, NOTHING)))
        for column, wrench in state.by_rate.items():
            for row, value in transform.powers(wrench).items():
                add_to(self.D[row], column, value)
            state.by_rate[column] = transform.wrench(wrench)
        state.carry_before(transform, moved, parts)

    def _shared(self, target: list[Row], row: int, part: FieldPart, value: ca.SX) -> None:
        for column, share in part.shares.items():
            add_to(target[row], column, mul(share, value))


def _shares(part: FieldPart, wrench: Force) -> dict[int, Force]:
    """Of a wrench, by column."""
    return {column: wrench.scaled(share) for column, share in part.shares.items()}


def _row_before(transform: Node, row: RowChange, velocity: Vector) -> RowChange:
    """Seen before a transform."""
    r = plus(row.r, cross(velocity, row.phi)) if transform.back else row.r
    transformed, r = transform.wrench(Force(row.phi, row.nu)), transform.wrench(Force(r, zeros())).f
    return RowChange(transformed.n, transformed.f, r if transform.back else plus(r, cross(velocity, transformed.f)))


def _tangent_before(transform: Node, velocity: Vector, tangent: Tangent) -> Tangent:
    """Seen before a transform."""
    if isinstance(transform, JointNode):
        if transform.about is not None:
            return tangent.about(transform.axis, *transform.about)
        return (tangent if transform.R is None else tangent.rotated(transform.R)).shifted(transform.r, velocity)
    deformed = transform.deformation.still
    if transform.back:
        return tangent.shifted(negative(deformed.rho), velocity).rotated(transposed(deformed.R))
    return tangent.rotated(deformed.R).shifted(deformed.rho, velocity)
