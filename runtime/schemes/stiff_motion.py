"""The motion of a mechanism whose stiff deflections are followed exactly while the rest accelerates as a polynomial.

With w = s - s_n of s = B^T q and g = a_n + b1 tau + b2 tau^2/2 + ..., it is, A = -X K, A_v = -X D (the stiffness of the
deflections) or any other (the tangent),

    q'' = g + A w + A_v (w' - w'_n).

Of q = q_n + I2 + E, I2 the motion of g - A_v w'_n alone, the rest has E'' = A w + A_v w', which is n_s equations. With
J = B^T A, J_v = B^T A_v and y_k = B^T times the k-th derivative of I2 at the start, the approximation of
linear_propagation.py gives over h, for each of its poles r with the weight u of phi_1 (u / r^k of the next ones),

    (r^2 - r h J_v - h^2 J) x = u sum_k (h / r)^k y_k,    k = 1, 2, ...,
    E = h^2 A sum x + h A_v sum r x,    E' = h A sum r x + A_v sum r^2 x,
    w = sum r^2 x,                      w' = R(infinity) y_1 + sum r^3 x / h.

Nothing is divided by J or B^T X, so softness does no harm. A few deflections go through a whole step at once, by an
approximation of higher degree and by inverses of their matrices: then a stage waits for one product. Of more the
factors are what costs: one set serves both halves of a step, where w of the second begins anew, with A w
added to g.
"""

from __future__ import annotations

from collections.abc import Sequence
from copy import copy
from dataclasses import dataclass
from math import factorial

import casadi as ca
import numpy as np

from runtime.schemes.linear_propagation import polynomial
from runtime.schemes.partial_fractions import DEGREE, Pole, poles
from runtime.schemes.sparse_lu import Number, factor, inverse, solve
from runtime.schemes.stiff_deflections import StiffResponse

FEW = 3  # deflections up to which inverses are formed and whole steps have matrices of their own
WHOLE_DEGREE = 5  # of the approximation of a whole step: as exact as two of DEGREE for halves, and more below h w = 5


@dataclass(frozen=True)
class MotionStage:
    """Where a motion over tau [s] has come: q_i and q_i_dot (n_i), and what of q_i_ddot the stiff part accounts for."""

    tau: ca.SX
    q: ca.SX
    v: ca.SX
    accounted: ca.SX


class _Resolvents:
    """Solutions of (r^2 - r h J_v - h^2 J) x = f for the poles r of a sub-step h."""

    def __init__(self, J: ca.SX, J_v: ca.SX, h: ca.SX, chosen: Sequence[Pole]) -> None:
        self.h, self.poles, self._few = h, chosen, J.shape[0] <= FEW
        self._kept = [(inverse if self._few else factor)(_shifted(J, J_v, h, pole.r)) for pole in chosen]

    def part(self, chosen: Sequence[Pole]) -> _Resolvents:
        """The same matrices with the weights for a part of the sub-step."""
        found = copy(self)
        found.poles = chosen
        return found

    def sums(self, y: Sequence[ca.SX]) -> list[ca.SX]:
        """Sums over the poles of h^2 x, h r x, r^2 x and r^3 x / h."""
        scales, sums = (self.h * self.h, self.h, ca.SX(1), 1 / self.h), [ca.SX(0)] * 4
        for pole, kept in zip(self.poles, self._kept, strict=True):
            x = self._solution(pole, kept, y)
            for k, scale in enumerate(scales):
                power = pole.share * pole.r**k
                part = power.real * scale * x.re
                sums[k] = sums[k] + (part if x.im is None else part - power.imag * scale * x.im)
        return sums

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


class StiffMotion:
    """Motions from the start (x, v) of a step of h [s], with what they share.

    tangent: (A, A_v), n_i x n_s each; None for those of the constant stiffness and damping. halves: never go through
    both halves of a step at once: undamped motion that is not resolved keeps its energy better over very many steps.
    decaying: modes that are not resolved die out, and one set of matrices serves the whole step and its half, where
    the approximation is of order 5 only.
    """

    def __init__(
        self,
        x: ca.SX,
        v: ca.SX,
        found: StiffResponse,
        h: ca.SX,
        tangent: tuple[ca.SX, ca.SX] | None = None,
        halves: bool = False,
        decaying: bool = False,
    ) -> None:
        self.x, self.v, self.a, self.B, self.h = x, v, found.a, found.B, h
        if tangent is None:
            tangent = -ca.mtimes(found.X, found.K), -ca.mtimes(found.X, found.D)
        self.A, self.A_v = (ca.sparsify(one) for one in tangent)
        self.J, self.J_v = (ca.sparsify(ca.mtimes(found.B.T, one)) for one in (self.A, self.A_v))
        self.rate = ca.mtimes(found.B.T, v)
        self.decaying, self.whole = decaying, decaying or (not halves and found.B.shape[1] <= FEW)
        self._back = ca.sparsify(ca.SX(np.linalg.pinv(np.array(ca.DM(found.B))).T))
        self._known: dict[tuple[int, bool], _Resolvents] = {}

    def to(self, halves: int, *bends: ca.SX, at_once: bool = False) -> MotionStage:
        """The motion over so many half steps with a_n + b1 tau + b2 tau^2 / 2 + ... beside the stiff part.

        at_once: both halves in one sub-step that lets what is fast die out, with factors of its own: less exact where
        modes are not resolved.
        """
        tau = halves * self.h / 2
        if not self.B.shape[1]:
            return self._stage(tau, *_even(tau, self.v, (self.a, *bends)))
        g = (self.a - ca.mtimes(self.A_v, self.rate), *bends)
        moved, rise = _even(tau, self.v, g)
        by_A, by_A_v, w, rate = self._along(halves, [ca.mtimes(self.B.T, one) for one in g], at_once)
        moved = moved + ca.mtimes(self.A, by_A[0]) + ca.mtimes(self.A_v, by_A_v[0])
        rise = rise + ca.mtimes(self.A, by_A[1]) + ca.mtimes(self.A_v, by_A_v[1])
        return self._stage(tau, self._with(moved, w), self._with(rise, rate - self.rate))

    def _along(
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

    def _resolvents(self, halves: int, decaying: bool) -> _Resolvents:
        """Of a sub-step of so many halves, made once."""
        if self.decaying:
            known = self._known.get((2, True)) or _Resolvents(
                self.J, self.J_v, self.h, poles(WHOLE_DEGREE, decaying=True)
            )
            self._known[2, True] = known
            return known.part(poles(WHOLE_DEGREE, halves / 2, decaying=True))
        if (halves, decaying) not in self._known:
            chosen = poles(DEGREE if decaying or halves == 1 else WHOLE_DEGREE, decaying=decaying)
            self._known[halves, decaying] = _Resolvents(self.J, self.J_v, halves * self.h / 2, chosen)
        return self._known[halves, decaying]

    def _stage(self, tau: ca.SX, moved: ca.SX, rise: ca.SX) -> MotionStage:
        along, faster = ca.mtimes(self.B.T, moved), ca.mtimes(self.B.T, rise)
        accounted = ca.mtimes(self.A, along) + ca.mtimes(self.A_v, faster)
        return MotionStage(tau, self.x + moved, self.v + rise, ca.densify(accounted))

    def remainder(self, a: ca.SX, stage: MotionStage) -> ca.SX:
        """d: what accelerations at a stage are beside a_n and what the stiff part accounts for."""
        return a - (self.a + stage.accounted)


def _even(tau: ca.SX, v: ca.SX, g: Sequence[ca.SX]) -> tuple[ca.SX, ca.SX]:
    """Changes of q and of v by the polynomial alone."""
    rise = sum((tau**k / factorial(k) * one for k, one in enumerate(g, start=1)), ca.SX(0))
    return tau * v + sum((tau**k / factorial(k) * one for k, one in enumerate(g, start=2)), ca.SX(0)), rise
