"""Spatial algebra: motions (twists), wrenches and inertia along a tree of frames, in the axes of the frame they
stand at.

Featherstone's spatial vectors, each as two vectors of three: `Motion`, `Force`, `Inertia`, `ArticulatedInertia`.

A frame moves with the angular velocity omega and the angular acceleration alpha; its origin has the acceleration a. No
linear velocity occurs. A point fixed at rho has the acceleration a + G rho with G = alpha~ + omega~^2.

Inertia of bodies whose joints are free: f = A a + H^T alpha, n = H a + J alpha with A and J symmetric.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TypeVar

import casadi as ca

from symgen.algebra.scalar import ONE, ZERO, add, dot, mul, neg, sub
from symgen.algebra.vectors import (
    Matrix,
    Vector,
    cross,
    identity,
    inertia_times,
    minus,
    plus,
    product,
    scaled,
    times,
    transposed_times,
    zeros,
)


@dataclass(frozen=True)
class SE3:
    """A rigid displacement: the new axes are the columns of R, the new origin is at r."""

    R: Matrix
    r: Vector

    @staticmethod
    def identity() -> SE3:
        """The frame itself."""
        return SE3(identity(), zeros())

    def __mul__(self, other: SE3) -> SE3:
        """Followed by another one."""
        return SE3(product(self.R, other.R), plus(self.r, times(self.R, other.r)))

    def inverse(self) -> SE3:
        """The opposite one."""
        return SE3(transposed(self.R), scaled(neg(ONE), transposed_times(self.R, self.r)))


@dataclass(frozen=True)
class Motion:
    """Motion of a frame for a unit rate of a coordinate: angular velocity, velocity of its origin."""

    omega: Vector
    v: Vector

    def scaled(self, factor: ca.SX) -> Motion:
        """For another rate."""
        return Motion(scaled(factor, self.omega), scaled(factor, self.v))

    def plus(self, other: Motion) -> Motion:
        """Of both."""
        return Motion(plus(self.omega, other.omega), plus(self.v, other.v))


@dataclass(frozen=True)
class LeverArm:
    """What gives a moment arm x A^T F: an arm in the frame's axes, F in those of the world."""

    arm: Vector
    F: Vector


@dataclass(frozen=True)
class Force:
    """Force f and moment n about the frame's origin; world: f in world axes where it is known.

    Where there are lever arms, n is also what they and the `rest` give: the shorter of the two ways is taken later.
    """

    f: Vector
    n: Vector
    world: Vector | None = None
    lever_arms: tuple[LeverArm, ...] = ()
    rest: Vector | None = None

    def along(self, twist: Motion) -> ca.SX:
        """Power on a twist."""
        return add(dot(twist.omega, self.n), dot(twist.v, self.f))

    def plus(self, other: Force) -> Force:
        """Sum about the same origin."""
        known = self.world is not None and other.world is not None
        world = plus(self.world, other.world) if known else None  # type: ignore[arg-type]
        rest, lever_arms = None, (*self.lever_arms, *other.lever_arms)
        if lever_arms:
            rest = plus(*(one.n if one.rest is None else one.rest for one in (self, other)))
        return Force(plus(self.f, other.f), plus(self.n, other.n), world, lever_arms, rest)

    def scaled(self, factor: ca.SX) -> Force:
        """A share of it."""
        return Force(scaled(factor, self.f), scaled(factor, self.n))

    def minus(self, other: Force) -> Force:
        """Difference about the same origin."""
        return Force(minus(self.f, other.f), minus(self.n, other.n))


NOTHING = Force(zeros(), zeros(), zeros())


def gather(target: dict[int, Force], more: Mapping[int, Force]) -> None:
    """Sums by column."""
    for column, wrench in more.items():
        target[column] = target[column].plus(wrench) if column in target else wrench


@dataclass(frozen=True)
class WorldFrame:
    """A frame's axes in the world, A by rows, and the acceleration of its origin there.

    swings: does another body on a ball carry the origin? Then A (e_i x h) are needed anyway, as momenta of unit rates.
    """

    A: Matrix
    a: Vector
    swings: bool


@dataclass(frozen=True)
class FrameMotion:
    """omega, alpha, and the acceleration a of the frame's origin less gravity; in_world: behind a ball."""

    omega: Vector
    alpha: Vector
    a: Vector
    in_world: WorldFrame | None = None

    @cached_property
    def G(self) -> Matrix:
        """alpha~ + omega~^2, by rows."""
        (x, y, z), (ax, ay, az), (xx, yy, zz) = self.omega, self.alpha, self._squares
        xy, xz, yz = mul(x, y), mul(x, z), mul(y, z)
        return [
            [neg(add(yy, zz)), sub(xy, az), add(xz, ay)],
            [add(xy, az), neg(add(xx, zz)), sub(yz, ax)],
            [sub(xz, ay), add(yz, ax), neg(add(xx, yy))],
        ]

    @cached_property
    def _squares(self) -> Vector:
        return [mul(value, value) for value in self.omega]

    def rotation_moment(self, Sigma: Matrix) -> Vector:
        """ax(Sigma G^T), where G_kk - G_jj is omega_k^2 - omega_j^2."""
        G, squares, found = self.G, self._squares, []
        for i in range(3):
            j, k = (i + 1) % 3, (i + 2) % 3
            across = mul(Sigma[j][k], sub(squares[k], squares[j]))
            along = sub(mul(Sigma[i][j], G[k][i]), mul(Sigma[i][k], G[j][i]))
            found.append(add(add(across, along), sub(mul(Sigma[j][j], G[k][j]), mul(Sigma[k][k], G[j][k]))))
        return found

    def carried(self, arm: Vector) -> Vector:
        """Acceleration of the point at `arm`, fixed in the frame."""
        return plus(self.a, times(self.G, arm))

    def swung(self, in_world: WorldFrame, arm: Vector) -> Vector:
        """G arm in world axes; arms along the same axis share a rotation."""
        along = only_axis([arm])
        if along is None:
            return times(in_world.A, times(self.G, arm))
        return scaled(arm[along], times(in_world.A, [row[along] for row in self.G]))


@dataclass(frozen=True)
class Inertia:
    """Spatial inertia: mass m, first moment h = int rho dm and second moments Sigma = int rho rho^T dm about the
    frame's origin.

    The inertia tensor is tr(Sigma) - Sigma. A shift changes three entries of Sigma where it changes five of the tensor.
    """

    m: ca.SX
    h: Vector
    Sigma: Matrix

    def plus(self, other: Inertia) -> Inertia:
        """Of both bodies together, about the same origin."""
        Sigma = [plus(row, more) for row, more in zip(self.Sigma, other.Sigma, strict=True)]
        return Inertia(add(self.m, other.m), plus(self.h, other.h), Sigma)

    def rotated(self, R: Matrix) -> Inertia:
        """In axes in which those of the frame are the columns of R."""
        half = product(R, self.Sigma)
        upper = [[dot(half[i], R[j]) if i <= j else ZERO for j in range(3)] for i in range(3)]
        return Inertia(self.m, times(R, self.h), symmetric_of(upper))

    def about(self, axis: int, cosine: ca.SX, sine: ca.SX) -> Inertia:
        """In axes from which the frame's are turned about one of them."""
        i, j = (axis + 1) % 3, (axis + 2) % 3
        h = list(self.h)
        h[i], h[j] = rotated_back(h[i], h[j], cosine, sine)
        return Inertia(self.m, h, both_rotated_back(self.Sigma, axis, cosine, sine))

    def shifted(self, arm: Vector) -> Inertia:
        """About the point from which the origin is at `arm`."""
        h = plus(self.h, scaled(self.m, arm))
        upper = [
            [
                add(self.Sigma[i][j], add(mul(arm[i], self.h[j]), mul(h[i], arm[j]))) if i <= j else ZERO
                for j in range(3)
            ]
            for i in range(3)
        ]
        return Inertia(self.m, h, symmetric_of(upper))

    def rotated_mass(self, R: Callable[[], Matrix]) -> Inertia:
        """The mass alone, in axes in which those of the frame are the columns of R."""
        return Inertia(self.m, zeros(), [zeros() for _ in range(3)])

    def momentum(self, twist: Motion) -> Force:
        """Linear momentum and angular momentum about the origin of a twist: int v dm, int rho x v dm."""
        f = plus(scaled(self.m, twist.v), cross(twist.omega, self.h))
        return Force(f, plus(cross(self.h, twist.v), inertia_times(self.Sigma, twist.omega)))

    def inertia_wrench(self, motion: FrameMotion) -> Force:
        """What moves the masses: f = m a + G h, n = h x a + ax(Sigma G^T)."""
        f = plus(scaled(self.m, motion.a), times(motion.G, self.h))
        rotation, in_world = motion.rotation_moment(self.Sigma), motion.in_world
        n = plus(cross(self.h, motion.a), rotation)
        if in_world is None:
            return Force(f, n)
        world = plus(scaled(self.m, in_world.a), motion.swung(in_world, self.h))
        if not in_world.swings:
            return Force(f, n, world)
        return Force(f, n, world, (LeverArm(self.h, in_world.a),), rotation)


def no_masses() -> Inertia:
    """Nothing."""
    return Inertia(ZERO, zeros(), [zeros() for _ in range(3)])


def only_axis(arms: Sequence[Vector]) -> int | None:
    """The axis along which all arms are, by structure."""
    found = {k for arm in arms for k in range(3) if not arm[k].is_zero()}
    return found.pop() if len(found) == 1 else None


def rotated_back(x: ca.SX, y: ca.SX, cosine: ca.SX, sine: ca.SX) -> tuple[ca.SX, ca.SX]:
    """Components in the axes from which a frame is turned, from those in the frame."""
    return sub(mul(cosine, x), mul(sine, y)), add(mul(sine, x), mul(cosine, y))


def both_rotated_back(block: Matrix, axis: int, cosine: ca.SX, sine: ca.SX, symmetric: bool = True) -> Matrix:
    """R block R^T for a turn R about an axis: 16 operations for a symmetric block, 23 for any."""
    i, j, k = (axis + 1) % 3, (axis + 2) % 3, axis
    result = [list(row) for row in block]
    both = mul(mul(ca.SX(2), cosine), block[i][j]) if symmetric else mul(cosine, add(block[i][j], block[j][i]))
    off = add(mul(sine, sub(block[i][i], block[j][j])), both)
    across, along = mul(sine, off), mul(cosine, off)
    result[i][i], result[j][j] = sub(block[i][i], across), add(block[j][j], across)
    result[i][j], result[j][i] = sub(along, block[j][i]), sub(along, block[i][j])
    result[i][k], result[j][k] = rotated_back(block[i][k], block[j][k], cosine, sine)
    if symmetric:
        result[j][i], result[k][i], result[k][j] = result[i][j], result[i][k], result[j][k]
    else:
        result[k][i], result[k][j] = rotated_back(block[k][i], block[k][j], cosine, sine)
    return result


def symmetric_of(upper: Matrix) -> Matrix:
    """The symmetric matrix of an upper triangle."""
    return [[upper[min(i, j)][max(i, j)] for j in range(3)] for i in range(3)]


@dataclass(frozen=True)
class ArticulatedInertia:
    """Inertia of what is beyond a frame, its joints free: blocks A (a to f), H (a to n) and J (alpha to n)."""

    A: Matrix
    H: Matrix
    J: Matrix

    @staticmethod
    def of(body: Inertia) -> ArticulatedInertia:
        """Of a body without free joints."""
        (x, y, z), S = body.h, body.Sigma
        A = [[body.m if i == j else ZERO for j in range(3)] for i in range(3)]
        H = [[ZERO, neg(z), y], [z, ZERO, neg(x)], [neg(y), x, ZERO]]
        J = [
            [
                add(S[(i + 1) % 3][(i + 1) % 3], S[(i + 2) % 3][(i + 2) % 3]) if i == j else neg(S[i][j])
                for j in range(3)
            ]
            for i in range(3)
        ]
        return ArticulatedInertia(symmetric_of(A), H, symmetric_of(J))

    def plus(self, other: ArticulatedInertia) -> ArticulatedInertia:
        """Of both, about the same origin."""
        A, H, J = (_sum(mine, own) for mine, own in zip(self._blocks, other._blocks, strict=True))
        return ArticulatedInertia(symmetric_of(A), H, symmetric_of(J))

    @property
    def _blocks(self) -> tuple[Matrix, Matrix, Matrix]:
        return self.A, self.H, self.J

    def rotated(self, R: Matrix) -> ArticulatedInertia:
        """In axes in which those of the frame are the columns of R."""
        back = transposed(R)
        A, H, J = (product(product(R, block), back) for block in self._blocks)
        return ArticulatedInertia(symmetric_of(A), H, symmetric_of(J))

    def rotated_mass(self, R: Callable[[], Matrix]) -> ArticulatedInertia:
        """What a freed ball leaves: no moment, whatever the motion. In axes as in `rotated`."""
        axes = R()
        A = symmetric_of(product(product(axes, self.A), transposed(axes)))
        return ArticulatedInertia(A, [zeros() for _ in range(3)], [zeros() for _ in range(3)])

    def about(self, axis: int, cosine: ca.SX, sine: ca.SX) -> ArticulatedInertia:
        """In axes from which the frame's are turned about one of them."""
        A, J = (both_rotated_back(block, axis, cosine, sine) for block in (self.A, self.J))
        return ArticulatedInertia(A, both_rotated_back(self.H, axis, cosine, sine, symmetric=False), J)

    def shifted(self, arm: Vector) -> ArticulatedInertia:
        """About the point from which the origin is at `arm`: n gains arm x f, a loses arm x alpha."""
        H = _sum(self.H, _columns(lambda column: cross(arm, column), self.A))
        # n = ... + (J + arm~ H^T - (H + arm~ A) arm~) alpha
        left = _columns(lambda column: cross(arm, column), transposed(self.H))
        right = transposed(_columns(lambda column: cross(arm, column), transposed(H)))
        J = [[add(add(self.J[i][j], left[i][j]), right[i][j]) if i <= j else ZERO for j in range(3)] for i in range(3)]
        return ArticulatedInertia(self.A, H, symmetric_of(J))

    def momentum(self, twist: Motion) -> Force:
        """Force for an acceleration."""
        f = plus(times(self.A, twist.v), times(transposed(self.H), twist.omega))
        return Force(f, plus(times(self.H, twist.v), times(self.J, twist.omega)))

    def less(self, wrench: Force, over: Force) -> ArticulatedInertia:
        """With a coordinate freed whose unit acceleration takes this wrench; over: by its own force against that."""
        A, H, J = _more(self.A, wrench.f, over.f), _more(self.H, wrench.n, over.f), _more(self.J, wrench.n, over.n)
        return ArticulatedInertia(symmetric_of(A), H, symmetric_of(J))

    def free_about(self, axis: int) -> ArticulatedInertia:
        """Without what a freed hinge about an axis leaves at zero: no moment about it, whatever the motion."""
        clear = [k == axis for k in range(3)]
        H = [zeros() if clear[i] else list(row) for i, row in enumerate(self.H)]
        J = [[ZERO if clear[i] or clear[j] else value for j, value in enumerate(row)] for i, row in enumerate(self.J)]
        return ArticulatedInertia(self.A, H, symmetric_of(J))


Mass = TypeVar("Mass", Inertia, ArticulatedInertia)


def transposed(block: Matrix) -> Matrix:
    """Rows as columns."""
    return [list(column) for column in zip(*block, strict=True)]


def _sum(a: Matrix, b: Matrix) -> Matrix:
    return [plus(x, y) for x, y in zip(a, b, strict=True)]


def _columns(apply: Callable[[Vector], Vector], block: Matrix) -> Matrix:
    return transposed([apply(column) for column in transposed(block)])


def _more(block: Matrix, left: Vector, right: Vector) -> Matrix:
    return [[add(block[i][j], mul(left[i], right[j])) for j in range(3)] for i in range(3)]
