"""The motion of a mechanism whose stiff deflections are followed exactly while the rest accelerates as a polynomial.

With g = a_n + b1 tau + b2 tau^2/2, I1 and I2 its first and second integral, and w = s - s_n for s = B^T q, it is

    q'' = g + A w + A_v (w' - w'_n),   w'' = B^T g + J w + J_v (w' - w'_n),   J = B^T A, J_v = B^T A_v,

n_s linear equations for w, by sub-steps of h/2 on one set of factors (linear_propagation.py). What q and v are follows
from w and w' without integrating again. For A = -X K, A_v = -X D (the stiffness of the deflections) all is along X:

    q = q_n + tau v_n + I2 + X Lambda^-1 (w  - B^T (tau v_n + I2)),
    v = v_n + I1           + X Lambda^-1 (w' - B^T (v_n + I1)),      Lambda = B^T X.

For any other A (the tangent), with U and V the first and second integral of w, from its equation and that integrated,

    J U = w' - w'_n - B^T I1 - J_v (w - tau w'_n),   J V = w - B^T (tau v_n + I2) - J_v (U - tau^2/2 w'_n),
    v = v_n + I1 + A U + A_v (w - tau w'_n),         q = q_n + tau v_n + I2 + A V + A_v (U - tau^2/2 w'_n).
"""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca

from runtime.schemes.linear_propagation import Factors, LinearSystem, factors_of, poles, propagate
from runtime.schemes.sparse_lu import Number, factor, solve
from runtime.schemes.stiff_deflections import StiffResponse


@dataclass(frozen=True)
class MotionStage:
    """Where a motion over tau [s] has come: q_i and q_i_dot (n_i), and what of q_i_ddot the stiff part accounts for."""

    tau: ca.SX
    q: ca.SX
    v: ca.SX
    accounted: ca.SX


class StiffMotion:
    """Motions from the start (x, v) of a step of h [s], with what they share.

    tangent: (A, A_v), n_i x n_s each; None for those of the constant stiffness and damping.
    """

    def __init__(self, x: ca.SX, v: ca.SX, found: StiffResponse, h: ca.SX, tangent: tuple[ca.SX, ca.SX] | None) -> None:
        self.x, self.v, self.a, self.found, self.h, self.tangent = x, v, found.a, found, h, tangent
        self.n_s = found.B.shape[1]
        if tangent is None:
            J, J_v = -ca.mtimes(found.Lambda, found.K), -ca.mtimes(found.Lambda, found.D)
        else:
            J, J_v = (ca.mtimes(found.B.T, one) for one in tangent)
        self.system = LinearSystem(ca.SX.eye(self.n_s), J, J_v)
        self.factors: Factors = factors_of(self.system, h / 2) if self.n_s else ()
        self.rate = ca.mtimes(found.B.T, v)

    def to(self, halves: int, b1: ca.SX, b2: ca.SX, at_once: bool = False) -> MotionStage:
        """The motion over so many half steps with accelerations a_n + b1 tau + b2 tau^2 / 2 beside the stiff part.

        at_once: both halves in one sub-step that lets what is fast die out, with factors of its own: less exact where
        modes are not resolved.
        """
        a, tau = self.a, halves * self.h / 2
        I1 = tau * (a + tau / 2 * (b1 + tau / 3 * b2))
        I2 = tau * (self.v + tau / 2 * (a + tau / 3 * (b1 + tau / 4 * b2)))  # with tau v_n
        if not self.n_s:
            return MotionStage(tau, self.x + I2, self.v + I1, ca.SX.zeros(a.numel()))
        B = self.found.B
        G = (ca.mtimes(B.T, a) - ca.mtimes(self.system.J_v, self.rate), ca.mtimes(B.T, b1), ca.mtimes(B.T, b2))
        w, u = ca.SX.zeros(self.n_s), self.rate
        if at_once and halves == 2:
            shifts = tuple(pole.r for pole in poles(decaying=True))
            factors = factors_of(self.system, self.h, shifts)
            w, u = propagate(self.system, factors, w, u, G, ca.SX(0), self.h, decaying=True)
        else:
            for k in range(halves):
                w, u = propagate(self.system, self.factors, w, u, G, k * self.h / 2, self.h / 2)
        if self.tangent is not None:
            return self._by_tangent(tau, w, u, I1, I2)
        q = self.x + I2 + self.found.along(w - ca.mtimes(B.T, I2))
        v = self.v + I1 + self.found.along(u - self.rate - ca.mtimes(B.T, I1))
        force = ca.mtimes(self.found.K, w) + ca.mtimes(self.found.D, u - self.rate)
        return MotionStage(tau, q, v, -ca.mtimes(self.found.X, force))

    def _by_tangent(self, tau: ca.SX, w: ca.SX, u: ca.SX, I1: ca.SX, I2: ca.SX) -> MotionStage:
        assert self.tangent is not None
        (A, A_v), B, J_v = self.tangent, self.found.B, self.system.J_v
        factors = factor(Number(self.system.J_q))

        def over_J(side: ca.SX) -> ca.SX:
            return solve(factors, Number(ca.densify(side))).re

        turned = w - tau * self.rate
        U = over_J(u - self.rate - ca.mtimes(B.T, I1) - ca.mtimes(J_v, turned))
        turned_twice = U - tau * tau / 2 * self.rate
        V = over_J(w - ca.mtimes(B.T, I2) - ca.mtimes(J_v, turned_twice))
        q = self.x + I2 + ca.mtimes(A, V) + ca.mtimes(A_v, turned_twice)
        v = self.v + I1 + ca.mtimes(A, U) + ca.mtimes(A_v, turned)
        return MotionStage(tau, q, v, ca.mtimes(A, w) + ca.mtimes(A_v, u - self.rate))

    def remainder(self, a: ca.SX, stage: MotionStage) -> ca.SX:
        """d: what accelerations at a stage are beside a_n and what the stiff part accounts for."""
        return a - self.a - stage.accounted
