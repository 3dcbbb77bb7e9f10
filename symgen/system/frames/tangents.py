"""How wrenches change where the motion of a frame does, all that is beyond it moving along.

With a change (u, beta, d) of a frame at O, in its axes: u of omega, d of a, and beta = d(alpha) + omega x u, the point
at rho, which moves with V relative to O, gains the acceleration d + beta x rho + 2 u x V. Hence, with p = int V dm,
Lambda = int rho V^T dm and K = tr(Lambda) - Lambda^T,

    df = m d + beta x h + 2 u x p,    dn = h x d + I beta + 2 K u.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import casadi as ca

from symgen.algebra.scalar import ZERO, add, dot, mul
from symgen.algebra.vectors import Vector, cross, plus, product, scaled, times, zeros
from symgen.system.frames.motion import (
    Composite,
    Matrix,
    Motion,
    Twist,
    Wrench,
    both_turned_back,
    inertia_times,
    traced,
)


@dataclass(frozen=True)
class Change:
    """(u, beta, d) of a frame."""

    u: Vector
    beta: Vector
    d: Vector


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

    inertia: Composite
    p: Vector
    Lambda: Matrix

    @staticmethod
    def of(inertia: Composite, motion: Motion) -> Tangent:
        """Of masses that are fixed in the frame: 2 Lambda = 2 omega x the rows of Sigma."""
        twice = scaled(ca.SX(2), motion.omega)
        return Tangent(inertia, cross(twice, inertia.h), [cross(twice, row) for row in inertia.Sigma])

    def moving(self, p: Vector, Lambda: Matrix) -> Tangent:
        """With what motion in the frame adds to 2 p and to 2 Lambda."""
        return replace(self, p=plus(self.p, p), Lambda=_sum(self.Lambda, Lambda))

    def plus(self, other: Tangent) -> Tangent:
        """Of both, about the same origin."""
        return Tangent(self.inertia.plus(other.inertia), plus(self.p, other.p), _sum(self.Lambda, other.Lambda))

    def wrench(self, change: Change) -> Wrench:
        """df and dn."""
        m, h, Sigma = self.inertia.m, self.inertia.h, self.inertia.Sigma
        f = plus(scaled(m, change.d), cross(change.beta, h), cross(change.u, self.p))
        n = plus(cross(h, change.d), inertia_times(Sigma, change.beta), traced(self.Lambda, change.u, False))
        return Wrench(f, n)

    def row(self, twist: Twist) -> RowChange:
        """Of the power on a twist."""
        m, h, Sigma = self.inertia.m, self.inertia.h, self.inertia.Sigma
        return RowChange(
            plus(inertia_times(Sigma, twist.omega), cross(h, twist.v)),
            plus(cross(twist.omega, h), scaled(m, twist.v)),
            plus(traced(self.Lambda, twist.omega, True), cross(self.p, twist.v)),
        )

    def about(self, axis: int, cosine: ca.SX, sine: ca.SX) -> Tangent:
        """In axes from which the frame's are turned about one of them."""
        at_p = Composite(ZERO, self.p, [zeros() for _ in range(3)]).about(axis, cosine, sine).h
        Lambda = both_turned_back(self.Lambda, axis, cosine, sine, symmetric=False)
        return Tangent(self.inertia.about(axis, cosine, sine), at_p, Lambda)

    def turned(self, R: Matrix) -> Tangent:
        """In axes in which those of the frame are the columns of R."""
        back = [list(column) for column in zip(*R, strict=True)]
        return Tangent(self.inertia.turned(R), times(R, self.p), product(product(R, self.Lambda), back))

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
