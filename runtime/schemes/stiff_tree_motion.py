"""The motion of stiff_motion.py on a tree with many stiff deflections, without any matrix of them: O(N).

With g = a_n + b1 tau + b2 tau^2/2, q'' = g - M^-1 B (K w + D (w' - w'_n)), w = B^T (q - q_n), in coordinates of the
tree. q = q_n + tau v_n + I2 + E, where E is what the stiffness adds. A sub-step h of the approximation of
linear_propagation.py is, for each of its poles r with weights w1, w2, w3,

    (M + B (h^2/r^2 K + h/r D) B^T) e = -B ((h^2/r^2 K + h/r D) B^T y / r^2 + h^3 w1/r^3 K B^T v + h^2 w1/r^2 f),
    y = h^2 (w1 g + h w2 g' + h^2 w3 g''),    f = K w + D (w' - w'_n),

at its start, and E <- E + h E' + sum e,  E' <- E' + sum r e / h. For polynomials alone the approximation is exact. Each
solution is one elimination of the tree with a shift; its factors serve all sub-steps of a step.
"""

from __future__ import annotations

from collections.abc import Callable

import casadi as ca

from runtime.schemes.partial_fractions import poles
from runtime.schemes.sparse_lu import Number
from runtime.schemes.stiff_deflections import StiffDeflections
from runtime.schemes.stiff_motion import Along, MotionStage

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
