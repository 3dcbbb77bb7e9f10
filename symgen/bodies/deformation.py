"""A point of a flexible body and the axes there as its modes move them, in body axes (Eq. 19).

The small rotation psi = sum turn_a q_a turns the axes by the quaternion (1, psi/2) made of unit length: with
k = 1 + psi.psi / 4, A_psi = 1 + (psi~ + psi~^2 / 2) / k, exactly a rotation, and in body axes
omega_psi = (psi_dot + psi x psi_dot / 2) / k, whose own rate without q_f_ddot is -(k_dot / k) omega_psi.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import casadi as ca

from symgen.algebra.rows import Row
from symgen.algebra.scalar import ONE, ZERO, add, div, dot, mul, neg, sub
from symgen.algebra.vectors import Vector, combination, cross, identity, plus, product, scaled, zeros
from symgen.bodies.spatial_moments import LocalMotion, Matrix, SpatialPoint


@dataclass(frozen=True)
class Bent:
    """Place and axes R (by columns) of the point, both by q_f: rho, drho/dq_a = shapes, omega by q_a_dot = turned.

    turning: by a rate of each component of psi. psi and inverse are zero where no mode turns the axes.
    rho_dot, omega and the bias terms nu (of rho_ddot) and fading (of omega_dot in body axes) go with q_f_dot.
    """

    point: SpatialPoint
    psi: Vector
    inverse: ca.SX  # 1 / k
    R: Matrix
    rho: Vector
    shapes: list[Vector]
    turning: list[Vector]
    turned: list[Vector]
    rho_dot: Vector
    nu: Vector
    omega: Vector
    fading: Vector

    @cached_property
    def common_axes(self) -> bool:
        """Do more modes turn the marker than there are axes about which they do?"""
        turning = [turn for turn in self.point.turns if any(not value.is_zero() for value in turn)]
        return sum(any(not turn[k].is_zero() for turn in turning) for k in range(3)) < len(turning)

    def on_turns(self, moment: Vector) -> Vector:
        """(moment + moment x psi / 2) / k: its product with turn_a is the power on `turned` of mode a."""
        if self.inverse.is_zero():
            return zeros()
        return scaled(self.inverse, plus(moment, scaled(ca.SX(0.5), cross(moment, self.psi))))

    def twice_turned(self, a: int, b: int, vector: Vector) -> ca.SX:
        """d(turned_a) / dq_b along a vector."""
        if self.inverse.is_zero():
            return ZERO
        half, (first, second) = mul(ca.SX(0.5), self.inverse), (self.point.turns[k] for k in (a, b))
        own = dot(first, scaled(half, cross(vector, second)))
        return sub(own, mul(mul(half, dot(self.psi, second)), dot(self.turned[a], vector)))

    def drift(self, omega: Vector) -> Vector:
        """2 omega x rho_dot + nu: acceleration of the point by moving in a body that turns with omega."""
        return plus(cross(scaled(ca.SX(2), omega), self.rho_dot), self.nu)


def along_axes(vectors: list[Vector], columns: list[int]) -> dict[int, Row]:
    """Components by axis of the body and column, of the axes along which there are any."""
    found: dict[int, Row] = {}
    for axis in range(3):
        own = {column: one[axis] for column, one in zip(columns, vectors, strict=True) if not one[axis].is_zero()}
        if own:
            found[axis] = own
    return found


@dataclass(frozen=True)
class SharedMotion:
    """A turning theta of psi or a shape, along an axis of the body; shares of it: of the modes, by column."""

    shares: Row
    theta: Vector
    shape: Vector

    def turned(self, bent: Bent) -> Vector:
        """The angular velocity for a unit rate."""
        return combination(bent.turning, self.theta)


@dataclass(frozen=True)
class Deformation:
    """A point with the modal coordinates of its body: values, rates and columns of q_f."""

    point: SpatialPoint
    q_f: Vector
    q_f_dot: Vector
    columns: list[int]

    @property
    def rigid(self) -> bool:
        """Do the modes leave the point and its axes where they are?"""
        moved = [component for vectors in (self.point.shapes, self.point.turns) for row in vectors for component in row]
        return all(component.is_zero() for component in moved) and not self.point.H

    @property
    def shared(self) -> list[SharedMotion]:
        """What modes do alike to the marker, by axis, where there are fewer axes than modes; empty otherwise."""
        turns, shapes = (along_axes(vectors, self.columns) for vectors in (self.point.turns, self.point.shapes))
        if self.point.H or len(turns) + len(shapes) >= len(self.columns):
            return []
        axes, still = identity(), zeros()
        return [SharedMotion(shares, axes[k], still) for k, shares in turns.items()] + [
            SharedMotion(shares, still, axes[k]) for k, shares in shapes.items()
        ]

    @property
    def now(self) -> Bent:
        """With the rates q_f_dot."""
        return self._bent(self.q_f_dot)

    def at(self, rates: Row) -> Bent:
        """With rates by column, zero where absent."""
        return self._bent(self.of(rates))

    def of(self, values: Row) -> Vector:
        """The modes' own part of a vector by column."""
        return [values.get(column, ZERO) for column in self.columns]

    def _bent(self, rates: Vector) -> Bent:
        local = LocalMotion(self.point, self.q_f, rates)
        kinds = local.rho, local.shapes, local.rho_dot, local.nu
        if all(component.is_zero() for turn in self.point.turns for component in turn):
            still, none = [zeros() for _ in self.columns], zeros()
            place = self.point, none, ZERO, self.point.axes, kinds[0], kinds[1]
            return Bent(*place, [none] * 3, still, kinds[2], kinds[3], none, none)
        psi, rate, half = local.psi, local.psi_dot, ca.SX(0.5)
        k = add(ONE, mul(ca.SX(0.25), dot(psi, psi)))
        inverse = div(ONE, k)
        x, y, z = scaled(mul(half, inverse), psi)
        turning = [[inverse, z, neg(y)], [neg(z), inverse, x], [y, neg(x), inverse]]
        turned = [combination(turning, turn) for turn in self.point.turns]
        omega = combination(turning, rate)
        fading = scaled(neg(mul(mul(half, dot(psi, rate)), inverse)), omega)
        R = product(_rotation(psi, inverse), self.point.axes)
        place = self.point, psi, inverse, R, kinds[0], kinds[1]
        return Bent(*place, turning, turned, kinds[2], kinds[3], omega, fading)


def _rotation(psi: Vector, inverse: ca.SX) -> Matrix:
    """1 + (psi~ + psi~^2 / 2) / k."""
    x, y, z = psi
    tilde = [[ZERO, neg(z), y], [z, ZERO, neg(x)], [neg(y), x, ZERO]]
    square = product(tilde, tilde)
    return [
        [add(ONE if i == j else ZERO, mul(inverse, add(tilde[i][j], mul(ca.SX(0.5), square[i][j])))) for j in range(3)]
        for i in range(3)
    ]
