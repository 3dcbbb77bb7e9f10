"""Rational approximations of exp and its phi functions in partial fractions, to the last digit of a double.

The denominator is that of the diagonal Pade approximation of exp, or of the one whose numerator is of one degree less.
Who adds what the fractions give to polynomials of the same motion takes differences that are (h w)^2 times as small as
their terms, so poles and weights are found in rational arithmetic and rounded once.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from itertools import zip_longest
from math import factorial

from numpy.polynomial import Polynomial

DEGREE = 3
PHI = 4  # phi_1 to phi_4
NEWTON_STEPS, GRID = 3, 2**160  # from the digits of a double to those of the grid
Exact = tuple[Fraction, Fraction]  # real and imaginary part


@dataclass(frozen=True)
class Pole:
    """r with weights: part^k phi_k(part z) is about sum_j weights[k - 1] / (r - z), conjugates counted in `share`."""

    r: complex
    weights: tuple[complex, ...]
    share: float


@cache
def poles(degree: int = DEGREE, part: float = 1.0, decaying: bool = False) -> tuple[Pole, ...]:
    """Partial fractions of the approximations of phi_1, phi_2, phi_3; one of each conjugate pair.

    decaying: from the Pade approximation whose numerator is of one degree less: R(-infinity) = 0.
    """
    top, share = degree - decaying, Fraction(part)
    below = [Fraction(1)]
    for k in range(1, degree + 1):
        below.append(-below[-1] * (degree - k + 1) / ((degree + top - k + 1) * k))
    exponential = [share**k / factorial(k) for k in range(degree + 1)]
    current = [sum((below[j] * exponential[k - j] for j in range(k + 1)), Fraction(0)) for k in range(top + 1)]
    numerators = []
    for k in range(1, PHI + 1):
        start = share ** (k - 1) / factorial(k - 1)
        pairs = zip_longest(current, below, fillvalue=Fraction(0))
        current = [above - start * one for above, one in pairs][1:]  # phi_k = (phi_{k-1} - start) / z
        numerators.append(current)
    slope = [k * one for k, one in enumerate(below)][1:]
    found = []
    for root in map(complex, Polynomial([float(one) for one in below]).roots()):
        if root.imag >= -1e-9:
            r = _sharpened(root if root.imag > 1e-9 else complex(root.real), below, slope)
            weights = tuple(-_rounded(_over(_value(p, r), _value(slope, r))) for p in numerators)
            found.append(Pole(_rounded(r), weights, 2.0 if r[1] else 1.0))
    return tuple(found)


def _sharpened(root: complex, polynomial: list[Fraction], slope: list[Fraction]) -> Exact:
    """A root by Newton's method on the grid."""
    r = (Fraction(root.real), Fraction(root.imag))
    for _ in range(NEWTON_STEPS):
        by = _over(_value(polynomial, r), _value(slope, r))
        r = (Fraction(round((r[0] - by[0]) * GRID), GRID), Fraction(round((r[1] - by[1]) * GRID), GRID))
    return r


def _value(polynomial: list[Fraction], x: Exact) -> Exact:
    re, im = Fraction(0), Fraction(0)
    for one in reversed(polynomial):
        re, im = re * x[0] - im * x[1] + one, re * x[1] + im * x[0]
    return re, im


def _over(a: Exact, b: Exact) -> Exact:
    size = b[0] * b[0] + b[1] * b[1]
    return (a[0] * b[0] + a[1] * b[1]) / size, (a[1] * b[0] - a[0] * b[1]) / size


def _rounded(a: Exact) -> complex:
    return complex(float(a[0]), float(a[1]))
