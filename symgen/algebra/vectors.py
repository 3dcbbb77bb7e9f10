"""Vectors in space as lists of three SX scalars, and quaternions as lists of four (scalar first)."""

from __future__ import annotations

from collections.abc import Sequence

import casadi as ca

from symgen.algebra.scalar import ONE, ZERO, add, dot, mul, neg, sub, total

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


def weighted(blocks: Sequence[Columns], factors: Sequence[ca.SX]) -> Matrix:
    """Sum of factors[k] blocks[k]."""
    return [
        [total(mul(factor, block[i][j]) for block, factor in zip(blocks, factors, strict=True)) for j in range(3)]
        for i in range(3)
    ]


def inertia_times(Sigma: Columns, omega: Sequence[ca.SX]) -> Vector:
    """(tr(Sigma) - Sigma) omega, with each diagonal entry of the inertia tensor the sum of two of Sigma."""
    result = []
    for i in range(3):
        j, k = (i + 1) % 3, (i + 2) % 3
        own = mul(add(Sigma[j][j], Sigma[k][k]), omega[i])
        result.append(sub(sub(own, mul(Sigma[i][j], omega[j])), mul(Sigma[i][k], omega[k])))
    return result


def traced(block: Columns, vector: Sequence[ca.SX], transposed: bool) -> Vector:
    """(tr B - B^T) vector, or (tr B - B) vector."""
    result = []
    for i in range(3):
        j, k = (i + 1) % 3, (i + 2) % 3
        own = mul(add(block[j][j], block[k][k]), vector[i])
        first, second = (block[i][j], block[i][k]) if transposed else (block[j][i], block[k][i])
        result.append(sub(sub(own, mul(first, vector[j])), mul(second, vector[k])))
    return result


def quaternion_product(a: Sequence[ca.SX], b: Sequence[ca.SX]) -> Vector:
    """Product of two quaternions: first the rotation b, seen in the frame that a turns."""
    scalar = sub(mul(a[0], b[0]), dot(a[1:], b[1:]))
    return [scalar, *plus(scaled(a[0], b[1:]), scaled(b[0], a[1:]), cross(a[1:], b[1:]))]


def conjugate(a: Sequence[ca.SX]) -> Vector:
    """The opposite rotation."""
    return [a[0], *negative(a[1:])]


def rotation_of(e: Vector) -> Matrix:
    """The rotation matrix by rows of a quaternion of unit length."""
    e0, e1, e2, e3 = e
    twice = scaled(ca.SX(2), e[1:])
    x, y, z = (mul(entry, e0) for entry in twice)
    xx, yy, zz = (mul(entry, own) for entry, own in zip(twice, (e1, e2, e3), strict=True))
    xy, xz, yz = mul(twice[0], e2), mul(twice[0], e3), mul(twice[1], e3)
    return [
        [1 - (yy + zz), xy - z, xz + y],
        [xy + z, 1 - (xx + zz), yz - x],
        [xz - y, yz + x, 1 - (xx + yy)],
    ]
