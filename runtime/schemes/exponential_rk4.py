"""Exponential Runge-Kutta steps of order 4 on the stiff deflections only: no Jacobian of the mechanism, O(N) on trees.

Stiff deflections s = B^T q_i (n_s of them: modes, springs between coordinates) have a stiffness K and a damping D. At
the start of a step one solution with 1 + n_s right-hand sides gives

    a_n,   X = M_hat^-1 B,   Lambda = B^T X.

The motion over tau with the accelerations a_n + b1 tau + b2 tau^2/2 beside those of K and D, of which I1 and I2 are the
first and second integrals, is for w = s - s_n

    w'' = B^T (a_n + b1 tau + b2 tau^2/2) - Lambda K w - Lambda D (w' - w'_n),   w(0) = 0, w'(0) = B^T v_n,
    q = q_n + tau v_n + I2 + X Lambda^-1 (w  - B^T (tau v_n + I2)),
    v = v_n + I1           + X Lambda^-1 (w' - B^T (v_n + I1)).

Only the first line is stiff; linear_propagation.py runs it by sub-steps of h/2 on one set of factors. Stages of
Krogstad (2005), with d_i = a(q, v, t) - a_n + X (K w + D (w' - w'_n)) at stage i:

    Y2  to h/2, b1 = b2 = 0        Y3  to h/2, b1 = 4 d2 / h        Y4  to h, b1 = 2 d3 / h
    end to h,   b1 = (2 d2 + 2 d3 - d4) / h,   b2 = 4 (d4 - d2 - d3) / h^2

Without stiff deflections it is an explicit Runge-Kutta method of order 4.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import casadi as ca
import numpy as np

from runtime.engine.program import Fields, Program
from runtime.schemes.linear_propagation import Factors, LinearSystem, factors_of, propagate
from runtime.schemes.one_step import OneStep
from runtime.schemes.options import ClosureOptions, Options
from runtime.schemes.sparse_lu import Number, factor, solve
from runtime.schemes.stage_equations import ClosedConfiguration, StageEquations, StiffResponse
from runtime.schemes.step_limit import StepLimit, limit_beside_deflections

# h w and h d up to which the explicit part is stable: above sqrt(2) a mode grows by 1e-3 a step at 1.6, by 2 % at 2
IMAGINARY_REACH, REAL_REACH = 2**0.5, 2.785


@dataclass(frozen=True)
class Stage:
    """Where a motion over tau has come: tau, positions, rates, and what K and D say of it, K w + D (w' - w'_n)."""

    tau: ca.SX
    q: ca.SX
    v: ca.SX
    force: ca.SX


class _Motion:
    """Motions from the start of a step of h, with what they share."""

    def __init__(self, x: ca.SX, v: ca.SX, found: StiffResponse, h: ca.SX) -> None:
        self.x, self.v, self.found, self.h = x, v, found, h
        self.n_s = found.B.shape[1]
        Lambda = ca.mtimes(found.B.T, found.X)
        self.system = LinearSystem(ca.SX.eye(self.n_s), -ca.mtimes(Lambda, found.K), -ca.mtimes(Lambda, found.D))
        self.factors: Factors = factors_of(self.system, h / 2) if self.n_s else ()
        self.inertia = factor(Number(Lambda), symmetric=True) if self.n_s else Number(Lambda)
        self.rate = ca.mtimes(found.B.T, v)

    def to(self, halves: int, b1: ca.SX, b2: ca.SX) -> Stage:
        """The motion over so many half steps with accelerations a_n + b1 tau + b2 tau^2 / 2."""
        a, tau = self.found.a, halves * self.h / 2
        I1 = tau * (a + tau / 2 * (b1 + tau / 3 * b2))
        I2 = tau * (self.v + tau / 2 * (a + tau / 3 * (b1 + tau / 4 * b2)))
        if not self.n_s:
            return Stage(tau, self.x + I2, self.v + I1, ca.SX(0, 1))
        B = self.found.B
        G = (ca.mtimes(B.T, a) - ca.mtimes(self.system.J_v, self.rate), ca.mtimes(B.T, b1), ca.mtimes(B.T, b2))
        w, u = ca.SX.zeros(self.n_s), self.rate
        for k in range(halves):
            w, u = propagate(self.system, self.factors, w, u, G, k * self.h / 2, self.h / 2)
        q = self.x + I2 + self._along(w - ca.mtimes(B.T, I2))
        v = self.v + I1 + self._along(u - self.rate - ca.mtimes(B.T, I1))
        return Stage(tau, q, v, ca.mtimes(self.found.K, w) + ca.mtimes(self.found.D, u - self.rate))

    def _along(self, change: ca.SX) -> ca.SX:
        """X Lambda^-1 change: what the mechanism does when the deflections change so."""
        return ca.mtimes(self.found.X, solve(self.inertia, Number(ca.densify(change))).re)

    def remainder(self, a: ca.SX, stage: Stage) -> ca.SX:
        """d: what accelerations at a stage are beside a_n and the stiffness and damping of the deflections."""
        return a - self.found.a + ca.mtimes(self.found.X, stage.force)


class ExponentialRungeKutta(OneStep):
    """Four evaluations a step in one stage."""

    options: ClosureOptions
    order = 4

    @classmethod
    def limited(cls, options: Options) -> bool:
        """Yes, by what is not a stiff deflection."""
        return True

    def step_limit(self, A_q: np.ndarray, A_v: np.ndarray) -> StepLimit | None:
        """Of the explicit part, for the motion in which the stiff deflections follow as in equilibrium."""
        B = self.equations(ca.SX.zeros(self.c_size)).deflections().B
        return limit_beside_deflections(A_q, A_v, np.array(ca.DM(B)), IMAGINARY_REACH, REAL_REACH)

    def program(self) -> Program:
        """One stage."""
        return self.stage("exponential_rk4", self._step)

    def evaluations(self) -> tuple[int, int]:
        """Four."""
        return 4, 0

    def _step(self, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        h, t, x, v = equations.h[0], self.now(z, equations), z["x"], z["v"]
        start = equations.close(x, z["loop"], t, self.options.closure_iterations)
        motion = _Motion(x, v, equations.stiff_response(start, v), h)
        loop, loop_dot = equations.loop_part(start.q_d), equations.loop_part(equations.rates(start, v))
        seen: list[ClosedConfiguration] = [start]

        def d(stage: Stage) -> ca.SX:
            guess = loop + stage.tau * loop_dot
            seen.append(equations.close(stage.q, guess, t + stage.tau, self.options.closure_iterations))
            return motion.remainder(equations.accelerations(seen[-1], stage.v), stage)

        none = ca.SX.zeros(len(self.model.q_i))
        d2 = d(motion.to(1, none, none))
        d3 = d(motion.to(1, 4 / h * d2, none))
        d4 = d(motion.to(2, 2 / h * d3, none))
        end = motion.to(2, (2 * d2 + 2 * d3 - d4) / h, 4 / (h * h) * (d4 - d2 - d3))
        ahead = {"loop": equations.loop_part(seen[-1].q_d)} if equations.loops else {}
        return {"x": end.q, "v": end.v, "n": z["n"] + 1, **ahead, **self.closed(z, *seen)}
