"""Arithmetic on SX scalars for the inner loops of the derivation.

CasADi's Python operators try every overload of their arguments (about 20 us); SX.binary goes straight to the
operation (3 us) with the same simplifications, which is what makes a 50-body scene generate in seconds. Where one
argument is complex, so is the result.

Complex SX scalars, so that an elimination can run with a complex shift.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import cast

import casadi as ca

from runtime.contract.tape import shared

_binary, _unary = ca.SX.binary, ca.SX.unary
_ADD, _SUB, _MUL, _DIV, _NEG = ca.OP_ADD, ca.OP_SUB, ca.OP_MUL, ca.OP_DIV, ca.OP_NEG
_ZERO = ca.SX(0)


@dataclass(frozen=True)
class ComplexScalar:
    """re + i im; what is real has a structurally zero im, and costs what real numbers cost."""

    re: ca.SX
    im: ca.SX

    @staticmethod
    def of(value: ca.SX | ComplexScalar) -> ComplexScalar:
        """A value as a complex one."""
        return value if isinstance(value, ComplexScalar) else ComplexScalar(value, _ZERO)

    def is_zero(self) -> bool:
        """Are both parts structurally zero?"""
        return bool(self.re.is_zero() and self.im.is_zero())

    def plus(self, other: ComplexScalar, operation: int = _ADD) -> ComplexScalar:
        """self + other, or self - other."""
        return ComplexScalar(_binary(operation, self.re, other.re), _binary(operation, self.im, other.im))

    def minus(self, other: ComplexScalar) -> ComplexScalar:
        """self - other."""
        return self.plus(other, _SUB)

    def times(self, other: ComplexScalar) -> ComplexScalar:
        """self other."""
        re = _binary(_SUB, _binary(_MUL, self.re, other.re), _binary(_MUL, self.im, other.im))
        im = _binary(_ADD, _binary(_MUL, self.re, other.im), _binary(_MUL, self.im, other.re))
        return ComplexScalar(re, im)

    def over(self, other: ComplexScalar) -> ComplexScalar:
        """self / other."""
        if other.im.is_zero():
            return ComplexScalar(_binary(_DIV, self.re, other.re), _binary(_DIV, self.im, other.re))
        square = _binary(_ADD, _binary(_MUL, other.re, other.re), _binary(_MUL, other.im, other.im))
        inverse = _binary(_DIV, ca.SX(1), square)
        return self.times(
            ComplexScalar(_binary(_MUL, other.re, inverse), _binary(_MUL, _unary(_NEG, other.im), inverse))
        )


def complex_number(re: ca.SX, im: ca.SX) -> ca.SX:
    """re + i im where a scalar of symgen/algebra/scalar.py is expected."""
    return cast(ca.SX, ComplexScalar(re, im))


ZERO, ONE = ca.SX(0), ca.SX(1)


def add(a: ca.SX, b: ca.SX) -> ca.SX:
    """a + b."""
    if isinstance(a, ComplexScalar) or isinstance(b, ComplexScalar):
        return cast(ca.SX, ComplexScalar.of(a).plus(ComplexScalar.of(b)))
    return _binary(_ADD, a, b)


def sub(a: ca.SX, b: ca.SX) -> ca.SX:
    """a - b."""
    if isinstance(a, ComplexScalar) or isinstance(b, ComplexScalar):
        return cast(ca.SX, ComplexScalar.of(a).minus(ComplexScalar.of(b)))
    return _binary(_SUB, a, b)


def mul(a: ca.SX, b: ca.SX) -> ca.SX:
    """a b."""
    if isinstance(a, ComplexScalar) or isinstance(b, ComplexScalar):
        return cast(ca.SX, ComplexScalar.of(a).times(ComplexScalar.of(b)))
    return _binary(_MUL, a, b)


def div(a: ca.SX, b: ca.SX) -> ca.SX:
    """a / b."""
    if isinstance(a, ComplexScalar) or isinstance(b, ComplexScalar):
        return cast(ca.SX, ComplexScalar.of(a).over(ComplexScalar.of(b)))
    return _binary(_DIV, a, b)


def neg(a: ca.SX) -> ca.SX:
    """-a."""
    return sub(ZERO, a) if isinstance(a, ComplexScalar) else _unary(_NEG, a)


def total(terms: Iterable[ca.SX]) -> ca.SX:
    """Sum of the terms in order; zero for none."""
    result = ZERO
    for term in terms:
        result = add(result, term)
    return result


def length(expressions: Sequence[ca.SX]) -> int:
    """Number of distinct operations of expressions together."""
    return int(ca.n_nodes(shared([ca.densify(ca.vertcat(*(ca.vec(value) for value in expressions)))])[0]))


def dot(u: Sequence[ca.SX], v: Sequence[ca.SX]) -> ca.SX:
    """Sum of u_k v_k."""
    return total(mul(x, y) for x, y in zip(u, v, strict=True))


def entries(matrix: ca.SX) -> list[list[ca.SX]]:
    """A matrix as a list of rows of scalars; structural zeros become plain zeros."""
    rows, columns = matrix.shape
    if not matrix.numel():
        return [[ZERO] * columns for _ in range(rows)]
    flat = ca.vertsplit(ca.densify(ca.reshape(matrix.T, -1, 1)))
    return [flat[row * columns : (row + 1) * columns] for row in range(rows)]


def vector(column: ca.SX) -> list[ca.SX]:
    """Entries of a column as scalars."""
    return ca.vertsplit(ca.densify(column)) if column.numel() else []
