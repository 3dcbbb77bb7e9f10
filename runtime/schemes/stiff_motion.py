"""The motion of a mechanism whose stiff deflections are followed exactly while the rest accelerates as a polynomial.

With w = s - s_n of s = B^T q and g = a_n + b1 tau + b2 tau^2/2 + ..., it is, with A = -X K and A_v = -X D,

    q'' = g + A w + A_v (w' - w'_n).

Of q = q_n + I2 + E, I2 the motion of g - A_v w'_n alone, the rest has E'' = A w + A_v w', which is n_s equations. With
J = B^T A, J_v = B^T A_v and y_k = B^T times the k-th derivative of I2 at the start, the approximation of
linear_propagation.py gives over h, for each of its poles r with the weight u of phi_1 (u / r^k of the next ones),

    (r^2 - r h J_v - h^2 J) x = u sum_k (h / r)^k y_k,    k = 1, 2, ...,
    E = h^2 A sum x + h A_v sum r x,    E' = h A sum r x + A_v sum r^2 x,
    w = sum r^2 x,                      w' = R(infinity) y_1 + sum r^3 x / h.

Accelerations beside those of the stiff part are a' - A w' - ..., and all that multiplies A is summed before it does: a
coordinate takes one product with its row of A for q and one for q'. Nothing is divided by J or B^T X, so softness does
no harm. A few deflections go through a whole step at once, by an
approximation of higher degree and by inverses of their matrices: then a stage waits for one product. Of more the
factors are what costs: one set serves both halves of a step, where w of the second begins anew, with A w
added to g.
"""

from __future__ import annotations

import operator
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from math import factorial

import casadi as ca
import numpy as np

from runtime.schemes.linear_propagation import polynomial
from runtime.schemes.partial_fractions import FEW_DEFLECTIONS, FRACTION_DEGREE, Adjugate, Resolvents, poles
from runtime.schemes.sparse_lu import Number
from runtime.schemes.stage_equations import StiffDeflections, StiffResponse

LEAST_OTHER_COORDINATES = 4  # coordinates beside the deflections from which it pays to sum what multiplies A first
WHOLE_DEGREE = 5  # of the approximation of a whole step: as exact as two of DEGREE for halves, and more below h w = 5


@dataclass(frozen=True)
class Along:
    """A vector e + A w + A_v w_dot (n_i) in its parts, w and w_dot (n_s) empty on trees; across: B^T times it."""

    e: ca.SX
    w: ca.SX
    w_dot: ca.SX
    across: ca.SX

    def _with(self, change: Callable[..., ca.SX], *others: Along) -> Along:
        names = ("e", "w", "w_dot", "across")
        return Along(*(change(getattr(self, name), *(getattr(one, name) for one in others)) for name in names))

    def __add__(self, other: Along) -> Along:
        return self._with(operator.add, other)

    def __sub__(self, other: Along) -> Along:
        return self._with(operator.sub, other)

    def __mul__(self, factor: ca.SX) -> Along:
        return self._with(lambda part: factor * part)


@dataclass(frozen=True)
class MotionStage:
    """Where a motion over tau [s] has come: q_i and q_i_dot (n_i), and what of q_i_ddot the stiff part accounts for."""

    tau: ca.SX
    q: ca.SX
    v: ca.SX
    accounted: Along


class StiffMotion:
    """Motions from the start (x, v) of a step of h [s], with what they share.

    decaying: modes that are not resolved die out, and one set of matrices serves the whole step and its half, where
    the approximation is of order 5 only.
    """

    def __init__(
        self,
        x: ca.SX,
        v: ca.SX,
        found: StiffResponse,
        h: ca.SX,
        decaying: bool = False,
    ) -> None:
        self.x, self.v, self.a, self.B, self.h = x, v, found.a, found.B, h
        self.A, self.A_v = (ca.sparsify(-ca.mtimes(found.X, one)) for one in (found.K, found.D))
        self.J, self.J_v = (ca.sparsify(ca.mtimes(found.B.T, one)) for one in (self.A, self.A_v))
        self.rate, self._none = ca.mtimes(found.B.T, v), ca.SX.zeros(found.B.shape[1])
        self.decaying, self.whole = decaying, decaying or found.B.shape[1] <= FEW_DEFLECTIONS
        self._back = ca.sparsify(ca.SX(np.linalg.pinv(np.array(ca.DM(found.B))).T))
        self._known: dict[tuple[int, bool], Resolvents] = {}
        often = self.whole and not decaying and self.B.shape[1]  # else inverses are shorter
        self._adjugate = Adjugate(h * h * self.J) if often and not self.J_v.nnz() else None

    def to(self, halves: int, *bends: Along, at_once: bool = False) -> MotionStage:
        """The motion over so many half steps with a_n + b1 tau + b2 tau^2 / 2 + ... beside the stiff part.

        at_once: both halves in one sub-step that lets what is fast die out, with factors of its own: less exact where
        modes are not resolved.
        """
        tau = halves * self.h / 2
        g = (self._kept(self.a, self._none, -self.rate), *bends)
        moved, rise = _even(tau, self.v, g)
        if not self.B.shape[1]:
            return MotionStage(tau, self.x + moved.e, self.v + rise.e, self.beside(0 * self.x))
        by_A, by_A_v, w, rate = self._stiff_part(halves, [one.across for one in g], at_once)
        none = 0 * self.x
        dq = self._with(self.all_of(moved + self.along(none, by_A[0], by_A_v[0])), w)
        dv = self._with(self.all_of(rise + self.along(none, by_A[1], by_A_v[1])), rate - self.rate)
        accounted = self.along(none, ca.mtimes(self.B.T, dq), ca.mtimes(self.B.T, dv))
        return MotionStage(tau, self.x + dq, self.v + dv, accounted)

    def resolved(self, a: ca.SX, w: ca.SX, w_dot: ca.SX) -> Along:
        """d: accelerations beside a_n and what the stiff part accounts for where deflections and rates changed so."""
        return self._kept(a - self.a, -w, -w_dot)

    def _kept(self, e: ca.SX, w: ca.SX, w_dot: ca.SX) -> Along:
        """e + A w + A_v w_dot in parts, where it pays."""
        kept = self.along(e, w, w_dot)
        return kept if self.B.shape[0] - self.B.shape[1] >= LEAST_OTHER_COORDINATES else self.beside(self.all_of(kept))

    def remainder(self, a: ca.SX, stage: MotionStage) -> Along:
        """d at a stage."""
        return self.resolved(a, stage.accounted.w, stage.accounted.w_dot)

    def beside(self, vector: ca.SX) -> Along:
        """A vector of which nothing is kept along A."""
        return self.along(vector, self._none, self._none)

    def along(self, e: ca.SX, w: ca.SX, w_dot: ca.SX) -> Along:
        """e + A w + A_v w_dot."""
        across = ca.mtimes(self.B.T, e) + ca.mtimes(self.J, w) + ca.mtimes(self.J_v, w_dot)
        return Along(e, w, w_dot, across)

    def all_of(self, vector: Along) -> ca.SX:
        """The vector itself."""
        return ca.densify(vector.e + ca.mtimes(self.A, vector.w) + ca.mtimes(self.A_v, vector.w_dot))

    def _stiff_part(
        self, halves: int, g: Sequence[ca.SX], at_once: bool
    ) -> tuple[tuple[ca.SX, ca.SX], tuple[ca.SX, ca.SX], ca.SX, ca.SX]:
        """What multiplies A and A_v in E and in E', and w and w', at the end."""
        none = ca.SX.zeros(self.B.shape[1])
        S, S_dot, R, R_dot, w, rate = none, none, none, none, none, self.rate
        whole = self.whole or at_once
        for k in range(1 if whole else halves):
            resolvents = self._resolvents(halves if whole else 1, at_once and halves == 2)
            h, slopes = resolvents.h, [polynomial(g[j:], k * self.h / 2) for j in range(len(g))]
            slopes[0] = slopes[0] + ca.mtimes(self.J, w)
            by_sum, by_rate, change, faster = resolvents.sums([rate, *slopes])
            S, S_dot = S + h * S_dot + h * h / 2 * w + by_sum, S_dot + h * w + by_rate
            R, R_dot = R + h * R_dot + by_rate, R_dot + change
            w, rate = w + change, resolvents.turned * rate + faster
        return (S, S_dot), (R, R_dot), w, rate

    def _with(self, vector: ca.SX, along: ca.SX) -> ca.SX:
        """A vector whose part along B is known without the cancellation of I2 and E, which grows with (h w)^2."""
        return vector + ca.mtimes(self._back, along - ca.mtimes(self.B.T, vector))

    def _resolvents(self, halves: int, decaying: bool) -> Resolvents:
        """Of a sub-step of so many halves, made once."""
        if self.decaying:
            return self._made(2, True, WHOLE_DEGREE).part(poles(WHOLE_DEGREE, halves / 2, decaying=True))
        return self._made(halves, decaying, FRACTION_DEGREE if decaying or halves == 1 else WHOLE_DEGREE)

    def _made(self, halves: int, decaying: bool, degree: int) -> Resolvents:
        if (halves, decaying) not in self._known:
            chosen = poles(degree, decaying=decaying)
            made = Resolvents(self.J, self.J_v, self.h, halves / 2, chosen, self._adjugate)
            self._known[halves, decaying] = made
        return self._known[halves, decaying]


def _even(tau: ca.SX, v: ca.SX, g: Sequence[Along]) -> tuple[Along, Along]:
    """Changes of q and of v by the polynomial alone."""
    none = 0 * g[0].w
    moved, rise = Along(tau * v, none, none, none), Along(0 * v, none, none, none)
    for k, one in enumerate(g, start=1):
        rise, moved = rise + one * (tau**k / factorial(k)), moved + one * (tau ** (k + 1) / factorial(k + 1))
    return moved, rise


# The motion of stiff_motion.py on a tree with many stiff deflections, without any matrix of them: O(N).
#
# With g = a_n + b1 tau + b2 tau^2/2, q'' = g - M^-1 B (K w + D (w' - w'_n)), w = B^T (q - q_n), in coordinates of the
# tree. q = q_n + tau v_n + I2 + E, where E is what the stiffness adds. A sub-step h of the approximation of
# linear_propagation.py is, for each of its poles r with weights w1, w2, w3,
#
#     (M + B (h^2/r^2 K + h/r D) B^T) e = -B ((h^2/r^2 K + h/r D) B^T y / r^2 + h^3 w1/r^3 K B^T v + h^2 w1/r^2 f),
#     y = h^2 (w1 g + h w2 g' + h^2 w3 g''),    f = K w + D (w' - w'_n),
#
# at its start, and E <- E + h E' + sum e,  E' <- E' + sum r e / h. For polynomials alone the approximation is exact.
# Each solution is one elimination of the tree with a shift; its factors serve all sub-steps of a step.

# (kappa, delta, force) -> (M + B (kappa K + delta D) B^T)^-1 B force; n_s -> n_i
ShiftedSolution = Callable[[Number, Number, Number], Number]


class StiffTreeMotion:
    """Motions from the start (x, v) of a step of h [s], where q_i'' = a."""

    def __init__(
        self, x: ca.SX, v: ca.SX, a: ca.SX, stiff: StiffDeflections, h: ca.SX, solution: ShiftedSolution
    ) -> None:
        self.x, self.v, self.a, self.stiff, self.h, self.solution = x, v, a, stiff, h, solution

    def to(self, halves: int, *bends: Along, at_once: bool = False) -> MotionStage:
        """The motion over so many half steps with accelerations a + b1 tau + b2 tau^2 / 2 beside the stiff part.

        at_once: both halves in one sub-step that lets what is fast die out: less exact where modes are not resolved.
        """
        none = ca.SX.zeros(self.a.numel())
        E, rate = none, none
        b1, b2 = (*(one.e for one in bends), none, none)[:2]
        h, count = (self.h, 1) if at_once and halves == 2 else (self.h / 2, halves)
        for k in range(count):
            E, rate = self._sub_step(k * h, h, b1, b2, E, rate, count < halves)
        tau = halves * self.h / 2
        I1, I2 = self._integrals(tau, b1, b2)
        q, v = self.x + tau * self.v + I2 + E, self.v + I1 + rate
        unshifted = Number(ca.SX(0))
        force = self.stiff.force(q - self.x, v - self.v)
        return MotionStage(tau, q, v, self.beside(-self.solution(unshifted, unshifted, Number(force)).re))

    def remainder(self, a: ca.SX, stage: MotionStage) -> Along:
        """d: what accelerations at a stage are beside a_n and what the stiff part accounts for."""
        return self.beside(a - self.a - stage.accounted.e)

    @staticmethod
    def all_of(vector: Along) -> ca.SX:
        """The vector itself."""
        return vector.e

    @staticmethod
    def beside(vector: ca.SX) -> Along:
        """A vector of which nothing is kept along A."""
        return Along(vector, *[ca.SX(0, 1)] * 3)

    def _integrals(self, tau: ca.SX, b1: ca.SX, b2: ca.SX) -> tuple[ca.SX, ca.SX]:
        I1 = tau * (self.a + tau / 2 * (b1 + tau / 3 * b2))
        return I1, tau * tau / 2 * (self.a + tau / 3 * (b1 + tau / 4 * b2))

    def _sub_step(
        self, tau: ca.SX, h: ca.SX, b1: ca.SX, b2: ca.SX, E: ca.SX, rate: ca.SX, decaying: bool
    ) -> tuple[ca.SX, ca.SX]:
        (K, D), BT = (self.stiff.K, self.stiff.D), self.stiff.B.T
        I1, I2 = self._integrals(tau, b1, b2)
        faster = I1 + rate
        f = self.stiff.force(tau * self.v + I2 + E, faster)
        K_v = ca.mtimes(K, ca.mtimes(BT, self.v + faster))
        g = ca.mtimes(BT, self.a + tau * (b1 + tau / 2 * b2))
        parts = (g, h * ca.mtimes(BT, b1 + tau * b2), h * h * ca.mtimes(BT, b2))
        new, new_rate = E + h * rate, rate
        for pole in poles(decaying=decaying):
            e = self._of_pole(pole.r, pole.weights, h, parts, K_v, f, (K, D))
            new = new + pole.share * e.re
            turned = pole.r.real * e.re - (pole.r.imag * e.im if e.im is not None else 0)
            new_rate = new_rate + pole.share / h * turned
        return new, new_rate

    def _of_pole(
        self,
        r: complex,
        weights: tuple[complex, ...],
        h: ca.SX,
        parts: tuple[ca.SX, ca.SX, ca.SX],
        K_v: ca.SX,
        f: ca.SX,
        matrices: tuple[ca.SX, ca.SX],
    ) -> Number:
        """e of the pole r."""
        w1 = weights[0]

        def real_or_imaginary(part: str) -> ca.SX:
            def of(value: complex) -> float:
                return float(getattr(value, part))

            def combined(factor: complex) -> ca.SX:  # factor y / h^2
                return sum((of(factor * w) * y for w, y in zip(weights, parts, strict=False)), ca.SX(0))

            elastic = h * h * ca.mtimes(matrices[0], combined(1 / r**4)) + h * ca.mtimes(
                matrices[1], combined(1 / r**3)
            )
            return -h * h * (elastic + of(w1 / r**3) * h * K_v + of(w1 / r**2) * f)

        def scaled(value: complex, size: ca.SX) -> Number:
            return Number(value.real * size, value.imag * size if r.imag else None)

        force = Number(real_or_imaginary("real"), real_or_imaginary("imag") if r.imag else None)
        return self.solution(scaled(1 / r**2, h * h), scaled(1 / r, h), force)
