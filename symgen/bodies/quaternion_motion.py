"""Quaternions that move with coordinates: value, rows over q, rate, and acceleration without second derivatives.

Products follow the product rule, so the constraint of a joint that places a body, e_child = e_parent K, has its rows,
its velocity and its acceleration terms from the factors of K.
"""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca

from symgen.algebra.rows import Row, add_scaled, add_to, nonzero
from symgen.algebra.scalar import ONE, ZERO, div, dot, mul, neg, sub
from symgen.algebra.vectors import Vector, conjugate, plus, quaternion_product, scaled, zeros


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
