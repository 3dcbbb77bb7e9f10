"""Sub-steps of the linear system  M w'' = G(tau) + J_q w + J_v w',  G(tau) = G0 + G1 tau + G2 tau^2 / 2.

With A = [0 1; M^-1 J_q, M^-1 J_v] and y = (w, w'), one sub-step h is, for constant A exactly,

    y(tau + h) = y + h phi_1(h A) y'(tau) + h^2 phi_2(h A) (0, M^-1 G'(tau)) + h^3 phi_3(h A) (0, M^-1 G2).

phi_k is replaced by its rational approximation with the denominator of the diagonal Pade approximation of exp:
of order 2 DEGREE, |R(i x)| = 1 for undamped modes and bounded for damped ones however stiff, so that the price does
not grow with the stiffness. A numerator of one degree less lets stiff decays die out at once, at the price of a little
damping of undamped modes (order 5). In partial fractions each sub-step is one real and (DEGREE - 1) / 2 complex solves
with

    r^2 M - r h J_v - h^2 J_q,

whose factors serve all sub-steps of a major step. A part of a sub-step is had from the same factors: the numerator for
exp(part z) is cut off at degree DEGREE, which makes it of order DEGREE only.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass

import casadi as ca

from runtime.schemes.partial_fractions import DEGREE, Pole, poles
from runtime.schemes.sparse_lu import Number, factor, solve


@dataclass(frozen=True)
class LinearSystem:
    """M, J_q and J_v as expressions."""

    M: ca.SX
    J_q: ca.SX
    J_v: ca.SX


Factors = tuple[Number, ...]


def factors_of(system: LinearSystem, h: ca.SX, shifts: tuple[complex, ...] | None = None) -> Factors:
    """Factors of r^2 M - r h J_v - h^2 J_q for every r in shifts, by default the poles of a sub-step h."""
    chosen = tuple(pole.r for pole in poles()) if shifts is None else shifts
    return tuple(factor(_shifted(system, h, r)) for r in chosen)


def _shifted(system: LinearSystem, h: ca.SX, r: complex) -> Number:
    m, k, d = ca.sparsify(system.M), h * h * ca.sparsify(system.J_q), h * ca.sparsify(system.J_v)
    square = r * r
    return Number(square.real * m - r.real * d - k, square.imag * m - r.imag * d if r.imag else None)


def propagate(
    system: LinearSystem,
    factors: Factors,
    w: ca.SX,
    u: ca.SX,
    G: Sequence[ca.SX],
    tau: ca.SX,
    h: ca.SX,
    part: float = 1.0,
    decaying: bool = False,
    echo: tuple[float, ca.SX] | None = None,
    free: Collection[int] = (),
    degree: int = DEGREE,
) -> tuple[ca.SX, ca.SX]:
    """(w, w') after a part of a sub-step h from (w, u) at tau; G: G0, G1, ... The factors are of these poles.

    echo: (share, bend); adds what a force bend tau^2 / 2 does from rest in that share of a sub-step. free: coordinates
    whose even motion is summed apart, so that changes of w' are no differences of large numbers, whose rounding would
    grow with the number of steps: turns of bodies. What is stiff is much smaller than an even motion, and is not.
    """
    slopes = [polynomial(G[k:], tau) for k in range(len(G))]
    slopes[0] = slopes[0] + ca.mtimes(system.J_q, w)  # and J_v u, which _solved takes off again
    even, rest = (ca.vertcat(*(u[k] if (k in free) == own else 0 for k in range(u.numel()))) for own in (True, False))
    slopes[0] = slopes[0] + ca.mtimes(system.J_v, even)
    start = _Start(rest, ca.mtimes(system.M, rest), ca.mtimes(system.J_q, even))
    new_w, new_u = w + part * h * even, u
    echoes = poles(degree, 1.0 if echo is None else echo[0], decaying)
    for pole, echoing, entries in zip(poles(degree, part, decaying), echoes, factors, strict=True):
        extra = None if echo is None else (echoing.weights[2], echo[1])
        x, y = _solved(pole, entries, slopes, start, h, extra)
        new_w, new_u = new_w + pole.share * x, new_u + pole.share * y
    return new_w, new_u


@dataclass(frozen=True)
class _Start:
    """w' that is not summed apart, M times it, and J_q times the even part."""

    u: ca.SX
    Mu: ca.SX
    pull: ca.SX


def polynomial(G: Sequence[ca.SX], tau: ca.SX) -> ca.SX:
    """G0 + G1 tau + G2 tau^2 / 2 + ..."""
    power, value = ca.SX(1), G[0]
    for k, term in enumerate(G[1:], start=1):
        power = power * tau / k
        value = value + power * term
    return value


def _solved(
    pole: Pole,
    factors: Number,
    slopes: Sequence[ca.SX],
    start: _Start,
    h: ca.SX,
    extra: tuple[complex, ca.SX] | None,
) -> tuple[ca.SX, ca.SX]:
    """Real parts of (r - h A)^-1 (p, s) with p = h w1 u and M s = h w1 M a + h^2 w2 G' + h^3 w3 G'' + ..., of the even
    part less p / r in x, which of all poles together is part h u, and nothing in y.

    slopes: M a less J_v rest, G', G'', ...; extra: a weight beside w3 with its G''. Powers of h are made once a run.
    """
    r, w1 = pole.r, pole.weights[0]

    def real_or_imaginary(part: str) -> ca.SX:
        def of(value: complex) -> float:
            return float(getattr(value, part))

        side, power = of(r * w1) * h * start.Mu + of(w1 / r) * h**3 * start.pull, h
        for weight, slope in zip(pole.weights, slopes, strict=False):
            power = power * h
            side = side + of(weight) * power * slope
        return side if extra is None else side + of(extra[0]) * h**4 * extra[1]

    X, Y = solve_shifted(factors, r, real_or_imaginary("real"), real_or_imaginary("imag") if r.imag else None)
    turned = r.real * X - r.imag * Y if r.imag else r.real * X
    return X, turned / h - w1.real * start.u


def solve_shifted(factors: Number, r: complex, re: ca.SX, im: ca.SX | None) -> tuple[ca.SX, ca.SX]:
    """Real and imaginary part of the solution for the right-hand side re + i im; r tells whether it is complex."""
    if im is None or not r.imag:
        return solve(factors, Number(ca.densify(re))).re, ca.SX.zeros(re.numel())
    x = solve(factors, Number(ca.densify(re), ca.densify(im)))
    assert x.im is not None
    return x.re, x.im
