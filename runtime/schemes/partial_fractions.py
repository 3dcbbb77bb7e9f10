"""Rational approximations of exp and its phi functions in partial fractions, to the last digit of a double.

The denominator is that of the diagonal Pade approximation of exp, or of the one whose numerator is of one degree less.
Who adds what the fractions give to polynomials of the same motion takes differences that are (h w)^2 times as small as
their terms, so poles and weights are found in rational arithmetic and rounded once.
"""

from __future__ import annotations

from collections.abc import Sequence
from copy import copy
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from itertools import zip_longest
from math import factorial

import casadi as ca
import numpy as np

from runtime.schemes.sparse_lu import Number, factor, inverse, solve

FRACTION_DEGREE = 3
PHI = 4  # phi_1 to phi_4
NEWTON_STEPS, GRID_DIGITS = 3, 2**160  # from the digits of a double to those of the grid
Exact = tuple[Fraction, Fraction]  # real and imaginary part


@dataclass(frozen=True)
class Pole:
    """r with weights: part^k phi_k(part z) is about sum_j weights[k - 1] / (r - z), conjugates counted in `share`."""

    r: complex
    weights: tuple[complex, ...]
    share: float


@cache
def poles(degree: int = FRACTION_DEGREE, part: float = 1.0, decaying: bool = False) -> tuple[Pole, ...]:
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
    for root in map(complex, np.sort(np.roots([float(one) for one in reversed(below)]))):
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
        r = (
            Fraction(round((r[0] - by[0]) * GRID_DIGITS), GRID_DIGITS),
            Fraction(round((r[1] - by[1]) * GRID_DIGITS), GRID_DIGITS),
        )
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


# Solutions of (r^2 - r h J_v - h^2 J) x = f for the poles r of a rational approximation, summed over the poles.
#
# With f = u sum_j (h / r)^j y_j, u the weight of phi_1, the motion of stiff_motion.py takes h^2 sum x, h sum r x,
# sum r^2 x and sum r^3 x / h. Without damping and for up to three deflections these are polynomials of Z = h^2 J,
#
#     (r^2 - Z)^-1 = sum_l r^2l Z_l / det(r^2 - Z),    Z_0 = adj Z, Z_1 = Z - tr Z, Z_2 = 1,
#
# or Z_0 = Z - tr Z and Z_1 = 1 of two, so that the poles are a few numbers together, C_p = sum_r u r^p / det, and
#
#     sum r^k x = sum_jl C_(k - j + 2l) Z_l h^j y_j.
#
# With r / share for r the matrices serve a share of the step, too. Diagonals of Z - tr Z and minors are
# written out: no digit is lost where stiffnesses lie far apart. With damping inverses are formed of up to three
# deflections; of more, factors are kept.

FEW_DEFLECTIONS = 3  # deflections up to which inverses are formed and whole steps have matrices of their own


class Adjugate:
    """Z_l of Z (n_s x n_s, up to three), and det(mu - Z) = sum_k d_k mu^k."""

    def __init__(self, Z: ca.SX) -> None:
        n, Z = Z.shape[0], ca.densify(Z)
        unit, d, turned = ca.SX.eye(n), [-ca.trace(Z), ca.SX(1)], ca.SX(Z)
        for k in range(n):
            turned[k, k] = -sum((Z[i, i] for i in range(n) if i != k), ca.SX(0))
        if n == 1:
            self.matrices = [unit]
        elif n == 2:
            self.matrices, d = [turned, unit], [Z[0, 0] * Z[1, 1] - Z[0, 1] * Z[1, 0], *d]
        else:
            adjugate = ca.vertcat(*(ca.cross(Z[:, (k + 1) % 3], Z[:, (k + 2) % 3]).T for k in range(3)))
            self.matrices = [adjugate, turned, unit]
            d = [-ca.dot(adjugate[0, :].T, Z[:, 0]), ca.trace(adjugate), *d]
        self.d = d

    def determinant(self, mu: complex) -> Number:
        """det(mu - Z)."""
        powers = [mu**k for k in range(len(self.d))]
        re = sum((d * power.real for d, power in zip(self.d, powers, strict=True)), ca.SX(0))
        im = sum((d * power.imag for d, power in zip(self.d, powers, strict=True)), ca.SX(0))
        return Number(re, im if mu.imag else None)


class Resolvents:
    """Of a sub-step of a share of h; adjugate: of h^2 J, None where inverses or factors are to be formed."""

    def __init__(
        self, J: ca.SX, J_v: ca.SX, h: ca.SX, share: float, chosen: Sequence[Pole], adjugate: Adjugate | None
    ) -> None:
        self.h, self.poles, self._few = share * h, chosen, J.shape[0] <= FEW_DEFLECTIONS
        self._adjugate, self._share, self._whole = adjugate, share, h
        if adjugate is None:
            self._kept = [(inverse if self._few else factor)(_shifted(J, J_v, self.h, pole.r)) for pole in chosen]
        else:
            self._kept = [adjugate.determinant((pole.r / share) ** 2).reciprocal() for pole in chosen]

    def part(self, chosen: Sequence[Pole]) -> Resolvents:
        """The same matrices with the weights for a part of the sub-step."""
        found = copy(self)
        found.poles = chosen
        return found

    def sums(self, y: Sequence[ca.SX]) -> list[ca.SX]:
        """Sums over the poles of h^2 x, h r x, r^2 x and r^3 x / h."""
        scales = (self.h * self.h, self.h, ca.SX(1), 1 / self.h)
        if self._adjugate is not None:
            return [scale * one for scale, one in zip(scales, self._polynomials(y), strict=True)]
        sums = [ca.SX(0)] * 4
        for pole, kept in zip(self.poles, self._kept, strict=True):
            x = self._solution(pole, kept, y)
            for k, scale in enumerate(scales):
                power = pole.share * pole.r**k
                part = power.real * scale * x.re
                sums[k] = sums[k] + (part if x.im is None else part - power.imag * scale * x.im)
        return sums

    def _polynomials(self, y: Sequence[ca.SX]) -> list[ca.SX]:
        """The same as polynomials of Z."""
        assert self._adjugate is not None
        sums = [ca.SX(0)] * 4
        for j, one in enumerate(y, start=1):  # what is known first is summed first
            parts = [ca.mtimes(Z, self._whole**j * one) for Z in self._adjugate.matrices]
            for k in range(4):
                terms = (self._number(k - j + 2 * power) * part for power, part in enumerate(parts))
                sums[k] = sums[k] + sum(terms, ca.SX(0))
        return [self._share**k * one for k, one in enumerate(sums)]

    def _number(self, power: int) -> ca.SX:
        """Sum over the poles of u r^power / det, r over the share."""
        found = ca.SX(0)
        for pole, kept in zip(self.poles, self._kept, strict=True):
            factor = pole.share * pole.weights[0] * (pole.r / self._share) ** power / self._share**2
            found = found + factor.real * kept.re
            if kept.im is not None:
                found = found - factor.imag * kept.im
        return found

    @property
    def turned(self) -> float:
        """R at infinity: what a rate is multiplied by where nothing else is left of the motion."""
        return 1 - sum((pole.share * pole.weights[0]).real for pole in self.poles)

    def _solution(self, pole: Pole, kept: Number, y: Sequence[ca.SX]) -> Number:
        def side(part: str) -> ca.SX:
            terms = (getattr(pole.weights[0] / pole.r**k, part) * self.h**k * one for k, one in enumerate(y, start=1))
            return ca.densify(sum(terms, ca.SX(0)))

        f = Number(side("real"), side("imag") if pole.r.imag else None)
        return kept @ f if self._few else solve(kept, f)


def _shifted(J: ca.SX, J_v: ca.SX, h: ca.SX, r: complex) -> Number:
    square, unit = r * r, ca.SX.eye(J.shape[0])
    re = square.real * unit - r.real * h * J_v - h * h * J
    return Number(re, square.imag * unit - r.imag * h * J_v if r.imag else None)
