"""Constant displacements between frames, written with as few operations as a frame on a hinge axis allows.

From a hinge along z to the next one: a rotation psi about z and a shift e along it, a shift along the common normal
(the new x), a rotation alpha about it, a rotation and a shift about and along the new z. The first two are nothing when
the frame on the first hinge has its x-axis along the common normal, its origin at the foot.
"""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca

from symgen.algebra.scalar import ONE, ZERO, add, div, dot, mul, neg, sub
from symgen.algebra.vectors import Vector, cross, plus, scaled, zeros
from symgen.system.frames.spatial_algebra import SE3, Matrix

STRAIGHT = 0.02  # sine of the angle between two axes below which their common normal may be far away


@dataclass(frozen=True)
class FixedAngle:
    """Cosine and sine of a constant angle."""

    cosine: ca.SX = ONE
    sine: ca.SX = ZERO

    def plus(self, other: FixedAngle) -> FixedAngle:
        """The sum."""
        return FixedAngle(
            sub(mul(self.cosine, other.cosine), mul(self.sine, other.sine)),
            add(mul(self.sine, other.cosine), mul(self.cosine, other.sine)),
        )

    @property
    def nothing(self) -> bool:
        """Is it zero by structure?"""
        return self.cosine.is_one() and self.sine.is_zero()

    def with_coordinate(self, value: ca.SX, sign: ca.SX) -> tuple[ca.SX, ca.SX]:
        """Cosine and sine of the angle plus sign times a coordinate; a right angle costs no addition."""
        if self.cosine.is_constant() and self.sine.is_constant():
            cosine, sine = ca.cos(value), mul(sign, ca.sin(value))
            moved = self.plus(FixedAngle(cosine, sine))
            return moved.cosine, moved.sine
        offset = ca.atan2(self.sine, self.cosine)
        whole = add(value, mul(sign, offset))
        return ca.cos(whole), mul(sign, ca.sin(whole))


@dataclass(frozen=True)
class Screw:
    """A rotation about an axis and a shift along it."""

    angle: FixedAngle = FixedAngle()
    shift: ca.SX = ZERO

    @property
    def displacement(self) -> SE3:
        """About z."""
        c, s = self.angle.cosine, self.angle.sine
        return SE3([[c, neg(s), ZERO], [s, c, ZERO], [ZERO, ZERO, ONE]], [ZERO, ZERO, self.shift])


@dataclass(frozen=True)
class BetweenHinges:
    """start about z, a shift and a rotation about the common normal (`across`), end about the new z."""

    start: Screw
    across: Screw
    end: Screw
    offset: Vector  # a shift across the first axis before the others, where the axes are parallel


def between_hinges(displacement: SE3) -> BetweenHinges:
    """The screws of a constant displacement between axes that are parallel by structure, or not at all."""
    R, r = displacement.R, displacement.r
    z = [row[2] for row in R]
    normal = _normal(z)
    if normal is None:
        return _parallel(R, r, z[2])
    n = [*normal[:2], ZERO]
    sine = normal[2]
    across = cross([ZERO, ZERO, ONE], n)
    turned = plus(scaled(z[2], across), [ZERO, ZERO, sine])  # the new z x n
    x = [row[0] for row in R]
    end = FixedAngle(dot(x, n), dot(x, turned))
    tilt = FixedAngle(z[2], sine)
    far = neg(div(dot(r, across), sine))
    start = sub(r[2], mul(far, z[2]))
    return BetweenHinges(Screw(FixedAngle(n[0], n[1]), start), Screw(tilt, dot(r, n)), Screw(end, far), zeros())


def _normal(z: Vector) -> Vector | None:
    """(cosine, sine) of the common normal in the xy-plane and the sine of the angle about it; None: parallel."""
    x, y = z[0], z[1]
    if x.is_zero() and y.is_zero():
        return None
    if x.is_zero():
        return [ONE, ZERO, neg(y)]
    if y.is_zero():
        return [ZERO, ONE, x]
    sine = ca.sqrt(add(mul(x, x), mul(y, y)))
    return [neg(div(y, sine)), div(x, sine), sine]


def _parallel(R: Matrix, r: Vector, cosine: ca.SX) -> BetweenHinges:
    """Axes that are parallel by structure: a shift in the plane across them."""
    x = [row[0] for row in R]
    end = FixedAngle(x[0], mul(cosine, x[1]))
    return BetweenHinges(Screw(shift=r[2]), Screw(FixedAngle(cosine)), Screw(end), [r[0], r[1], ZERO])
