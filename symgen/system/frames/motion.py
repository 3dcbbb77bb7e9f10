"""What is passed along a tree of frames, all in the axes of the frame it stands at: motions, wrenches, inertia.

A frame moves with the angular velocity omega and the angular acceleration alpha; its origin has the acceleration a. No
linear velocity occurs. A point fixed at rho has the acceleration a + G rho with G = alpha~ + omega~^2.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property

import casadi as ca

from symgen.algebra.scalar import ZERO, add, dot, mul, neg, sub
from symgen.algebra.vectors import Vector, cross, plus, product, scaled, times, zeros

Matrix = list[Vector]


@dataclass(frozen=True)
class Twist:
    """Motion of a frame for a unit rate of a coordinate: angular velocity, velocity of its origin."""

    omega: Vector
    v: Vector


@dataclass(frozen=True)
class Lever:
    """What gives a moment arm x A^T F: an arm in the frame's axes, F in those of the world."""

    arm: Vector
    F: Vector


@dataclass(frozen=True)
class Wrench:
    """Force f and moment n about the frame's origin; world: f in world axes where it is known.

    Where there are levers, n is also what they and the `rest` give: the shorter of the two ways is taken later.
    """

    f: Vector
    n: Vector
    world: Vector | None = None
    levers: tuple[Lever, ...] = ()
    rest: Vector | None = None

    def along(self, twist: Twist) -> ca.SX:
        """Power on a twist."""
        return add(dot(twist.omega, self.n), dot(twist.v, self.f))

    def plus(self, other: Wrench) -> Wrench:
        """Sum about the same origin."""
        known = self.world is not None and other.world is not None
        world = plus(self.world, other.world) if known else None  # type: ignore[arg-type]
        rest, levers = None, (*self.levers, *other.levers)
        if levers:
            rest = plus(*(one.n if one.rest is None else one.rest for one in (self, other)))
        return Wrench(plus(self.f, other.f), plus(self.n, other.n), world, levers, rest)


NOTHING = Wrench(zeros(), zeros(), zeros())


@dataclass(frozen=True)
class Held:
    """A frame's axes in the world, A by rows, and the acceleration of its origin there.

    swings: does another body on a ball carry the origin? Then A (e_i x h) are needed anyway, as momenta of unit rates.
    """

    A: Matrix
    a: Vector
    swings: bool


@dataclass(frozen=True)
class Motion:
    """omega, alpha, and the acceleration a of the frame's origin less gravity; held: where a ball gives the axes."""

    omega: Vector
    alpha: Vector
    a: Vector
    held: Held | None = None

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

    def turning_moment(self, Sigma: Matrix) -> Vector:
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

    def swung(self, held: Held, arm: Vector) -> Vector:
        """G arm in world axes; arms along the same axis share a rotation."""
        along = only_axis([arm])
        if along is None:
            return times(held.A, times(self.G, arm))
        return scaled(arm[along], times(held.A, [row[along] for row in self.G]))


@dataclass(frozen=True)
class Composite:
    """Mass m, first moment h = int rho dm and second moments Sigma = int rho rho^T dm about the frame's origin.

    The inertia tensor is tr(Sigma) - Sigma. A shift changes three entries of Sigma where it changes five of the tensor.
    """

    m: ca.SX
    h: Vector
    Sigma: Matrix

    def plus(self, other: Composite) -> Composite:
        """Of both bodies together, about the same origin."""
        Sigma = [plus(row, more) for row, more in zip(self.Sigma, other.Sigma, strict=True)]
        return Composite(add(self.m, other.m), plus(self.h, other.h), Sigma)

    def turned(self, R: Matrix) -> Composite:
        """In axes in which those of the frame are the columns of R."""
        half = product(R, self.Sigma)
        upper = [[dot(half[i], R[j]) if i <= j else ZERO for j in range(3)] for i in range(3)]
        return Composite(self.m, times(R, self.h), symmetric_of(upper))

    def about(self, axis: int, cosine: ca.SX, sine: ca.SX) -> Composite:
        """In axes from which the frame's are turned about one of them."""
        i, j = (axis + 1) % 3, (axis + 2) % 3
        h = list(self.h)
        h[i], h[j] = turned_back(h[i], h[j], cosine, sine)
        return Composite(self.m, h, both_turned_back(self.Sigma, axis, cosine, sine))

    def shifted(self, arm: Vector) -> Composite:
        """About the point from which the origin is at `arm`."""
        h = plus(self.h, scaled(self.m, arm))
        upper = [
            [
                add(self.Sigma[i][j], add(mul(arm[i], self.h[j]), mul(h[i], arm[j]))) if i <= j else ZERO
                for j in range(3)
            ]
            for i in range(3)
        ]
        return Composite(self.m, h, symmetric_of(upper))

    def turned_mass(self, R: Callable[[], Matrix]) -> Composite:
        """The mass alone, in axes in which those of the frame are the columns of R."""
        return Composite(self.m, zeros(), [zeros() for _ in range(3)])

    def momentum(self, twist: Twist) -> Wrench:
        """Linear momentum and angular momentum about the origin of a twist: int v dm, int rho x v dm."""
        f = plus(scaled(self.m, twist.v), cross(twist.omega, self.h))
        return Wrench(f, plus(cross(self.h, twist.v), inertia_times(self.Sigma, twist.omega)))

    def inertia_wrench(self, motion: Motion) -> Wrench:
        """What moves the masses: f = m a + G h, n = h x a + ax(Sigma G^T)."""
        f = plus(scaled(self.m, motion.a), times(motion.G, self.h))
        turning, held = motion.turning_moment(self.Sigma), motion.held
        n = plus(cross(self.h, motion.a), turning)
        if held is None:
            return Wrench(f, n)
        world = plus(scaled(self.m, held.a), motion.swung(held, self.h))
        if not held.swings:
            return Wrench(f, n, world)
        return Wrench(f, n, world, (Lever(self.h, held.a),), turning)


def no_masses() -> Composite:
    """Nothing."""
    return Composite(ZERO, zeros(), [zeros() for _ in range(3)])


def only_axis(arms: Sequence[Vector]) -> int | None:
    """The axis along which all arms are, by structure."""
    found = {k for arm in arms for k in range(3) if not arm[k].is_zero()}
    return found.pop() if len(found) == 1 else None


def inertia_times(Sigma: Matrix, omega: Vector) -> Vector:
    """(tr(Sigma) - Sigma) omega, with each diagonal entry of the inertia tensor the sum of two of Sigma."""
    result = []
    for i in range(3):
        j, k = (i + 1) % 3, (i + 2) % 3
        own = mul(add(Sigma[j][j], Sigma[k][k]), omega[i])
        result.append(sub(sub(own, mul(Sigma[i][j], omega[j])), mul(Sigma[i][k], omega[k])))
    return result


def traced(block: Matrix, vector: Vector, transposed: bool) -> Vector:
    """(tr B - B^T) vector, or (tr B - B) vector."""
    result = []
    for i in range(3):
        j, k = (i + 1) % 3, (i + 2) % 3
        own = mul(add(block[j][j], block[k][k]), vector[i])
        first, second = (block[i][j], block[i][k]) if transposed else (block[j][i], block[k][i])
        result.append(sub(sub(own, mul(first, vector[j])), mul(second, vector[k])))
    return result


def turned_back(x: ca.SX, y: ca.SX, cosine: ca.SX, sine: ca.SX) -> tuple[ca.SX, ca.SX]:
    """Components in the axes from which a frame is turned, from those in the frame."""
    return sub(mul(cosine, x), mul(sine, y)), add(mul(sine, x), mul(cosine, y))


def both_turned_back(block: Matrix, axis: int, cosine: ca.SX, sine: ca.SX, symmetric: bool = True) -> Matrix:
    """R block R^T for a turn R about an axis: 16 operations for a symmetric block, 23 for any."""
    i, j, k = (axis + 1) % 3, (axis + 2) % 3, axis
    result = [list(row) for row in block]
    both = mul(mul(ca.SX(2), cosine), block[i][j]) if symmetric else mul(cosine, add(block[i][j], block[j][i]))
    off = add(mul(sine, sub(block[i][i], block[j][j])), both)
    across, along = mul(sine, off), mul(cosine, off)
    result[i][i], result[j][j] = sub(block[i][i], across), add(block[j][j], across)
    result[i][j], result[j][i] = sub(along, block[j][i]), sub(along, block[i][j])
    result[i][k], result[j][k] = turned_back(block[i][k], block[j][k], cosine, sine)
    if symmetric:
        result[j][i], result[k][i], result[k][j] = result[i][j], result[i][k], result[j][k]
    else:
        result[k][i], result[k][j] = turned_back(block[k][i], block[k][j], cosine, sine)
    return result


def symmetric_of(upper: Matrix) -> Matrix:
    """The symmetric matrix of an upper triangle."""
    return [[upper[min(i, j)][max(i, j)] for j in range(3)] for i in range(3)]
