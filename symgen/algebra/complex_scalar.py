"""Complex SX scalars, so that an elimination can run with a complex shift."""

from __future__ import annotations

from dataclasses import dataclass
from typing import cast

import casadi as ca

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
