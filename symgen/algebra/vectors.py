"""Vectors in space as lists of three SX scalars, and quaternions as lists of four (scalar first)."""

from __future__ import annotations

from collections.abc import Sequence

import casadi as ca

from symgen.algebra.scalar import ONE, ZERO, add, dot, mul, neg, sub

Vector = list[ca.SX]
Matrix = list[Vector]  # rows, or columns
Columns = Sequence[Sequence[ca.SX]]


def zeros(n: int = 3) -> Vector:
    """n zeros."""
    return [ZERO] * n


def identity() -> list[Vector]:
    """The unit vectors of three axes, as columns: no rotation."""
    return [[ONE if i == j else ZERO for i in range(3)] for j in range(3)]


def plus(*vectors: Sequence[ca.SX]) -> Vector:
    """Sum of vectors."""
    result = list(vectors[0])
    for vector in vectors[1:]:
        result = [add(a, b) for a, b in zip(result, vector, strict=True)]
    return result


def minus(a: Sequence[ca.SX], b: Sequence[ca.SX]) -> Vector:
    """a - b."""
    return [sub(x, y) for x, y in zip(a, b, strict=True)]


def scaled(factor: ca.SX, vector: Sequence[ca.SX]) -> Vector:
    """factor times vector."""
    return [mul(factor, x) for x in vector]


def negative(vector: Sequence[ca.SX]) -> Vector:
    """-vector."""
    return [neg(x) for x in vector]


def cross(a: Sequence[ca.SX], b: Sequence[ca.SX]) -> Vector:
    """a x b."""
    return [
        sub(mul(a[1], b[2]), mul(a[2], b[1])),
        sub(mul(a[2], b[0]), mul(a[0], b[2])),
        sub(mul(a[0], b[1]), mul(a[1], b[0])),
    ]


def times(matrix: Columns, vector: Sequence[ca.SX]) -> Vector:
    """matrix (a list of rows) times vector."""
    return [dot(row, vector) for row in matrix]


def transposed_times(matrix: Columns, vector: Sequence[ca.SX]) -> Vector:
    """Transpose of a matrix (a list of rows) times vector."""
    return [dot([row[j] for row in matrix], vector) for j in range(len(matrix[0]))]


def product(a: Columns, b: Columns) -> list[Vector]:
    """Matrix product of two lists of rows."""
    columns = list(zip(*b, strict=True))
    return [[dot(row, column) for column in columns] for row in a]


def combination(columns: Columns, factors: Sequence[ca.SX]) -> Vector:
    """Sum of factors[k] columns[k]; three zeros for none."""
    result = zeros(len(columns[0]) if columns else 3)
    for column, factor in zip(columns, factors, strict=True):
        result = plus(result, scaled(factor, column))
    return result


def axial(matrix: Columns) -> Vector:
    """sum over k, l of epsilon_ikl matrix[k][l]: int a x b dm of the matrix int a b^T dm."""
    return [sub(matrix[1][2], matrix[2][1]), sub(matrix[2][0], matrix[0][2]), sub(matrix[0][1], matrix[1][0])]


def quaternion_product(a: Sequence[ca.SX], b: Sequence[ca.SX]) -> Vector:
    """Product of two quaternions: first the rotation b, seen in the frame that a turns."""
    scalar = sub(mul(a[0], b[0]), dot(a[1:], b[1:]))
    return [scalar, *plus(scaled(a[0], b[1:]), scaled(b[0], a[1:]), cross(a[1:], b[1:]))]


def conjugate(a: Sequence[ca.SX]) -> Vector:
    """The opposite rotation."""
    return [a[0], *negative(a[1:])]
