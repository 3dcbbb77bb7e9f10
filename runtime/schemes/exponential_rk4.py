"""Exponential Runge-Kutta steps of order 4 on the stiff deflections only: no Jacobian of the mechanism, O(N) on trees.

Stiff deflections s = B^T q_i (n_s of them: modes, springs between coordinates) have a stiffness K and a damping D. At
the start of a step one solution with 1 + n_s right-hand sides gives

    a_n,   X = M_hat^-1 B,   Lambda = B^T X.

stiff_motion.py follows the stiff part exactly, beside accelerations a_n + b1 tau + b2 tau^2/2 of the rest. Stages of
Krogstad (2005), with d_i the accelerations at stage i less a_n and less what the stiff part accounts for:

    Y2  to h/2, b1 = b2 = 0        Y3  to h/2, b1 = 4 d2 / h        Y4  to h, b1 = 2 d3 / h
    end to h,   b1 = (2 d2 + 2 d3 - d4) / h,   b2 = 4 (d4 - d2 - d3) / h^2

Without stiff deflections it is an explicit Runge-Kutta method of order 4.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial

import casadi as ca
import numpy as np

from runtime.contract.model import Model
from runtime.engine.program import Fields, Program
from runtime.schemes.linear_propagation import polynomial
from runtime.schemes.one_step import OneStep
from runtime.schemes.options import MOST_UNROLLED, AdaptiveOptions, Options, one_of, whole_number
from runtime.schemes.stage_equations import ClosedConfiguration, StageEquations
from runtime.schemes.step_limit import StepLimit, limit_beside_deflections
from runtime.schemes.stiff_deflections import StiffResponse
from runtime.schemes.stiff_motion import Along, MotionStage, StiffMotion
from runtime.schemes.stiff_tree_motion import StiffTreeMotion

# h w and h d up to which the explicit part is stable: above sqrt(2) a mode grows by 1e-3 a step at 1.6, by 2 % at 2
IMAGINARY_REACH, REAL_REACH = 2**0.5, 2.785


@dataclass(frozen=True)
class ExponentialRungeKuttaOptions(AdaptiveOptions):
    """closure_iterations: Newton steps on the loop unknowns in each evaluation, from a guess that is right to h^3.

    tolerance, error_of: see AdaptiveOptions.

    linearisation: what the exponentials hold of the deflections: `stiffness`, the constant K and D of the model, or
        `tangent`, the derivative of the accelerations along X Lambda^-1 at the start of the step, where the momentum of
        the other coordinates is held: for undamped motion over very many steps.
    """

    closure_iterations: int = whole_number(2, most=MOST_UNROLLED)
    linearisation: str = one_of("stiffness", "tangent")


@dataclass(frozen=True)
class KrogstadStages:
    """Y3 in the middle, Y4 before the end, the end, and b1, b2 of the polynomial that leads to it."""

    middle: MotionStage
    before: MotionStage
    end: MotionStage
    b1: ca.SX
    b2: ca.SX


def krogstad(
    motion: StiffMotion | StiffTreeMotion, d: Callable[[MotionStage], Along], rough: bool = False
) -> KrogstadStages:
    """The stages of a step of motion.h; d: what accelerations at a stage are beside what the stiff part accounts for.

    Y4 is a result of order 2 and so an estimate of the error; the polynomial with b1, b2 leads through the whole step.
    rough: let Y4 follow the stiff part in one sub-step, so that the estimate sees modes that the steps do not resolve.
    """
    h = motion.h
    d2 = d(motion.to(1))
    middle = motion.to(1, d2 * (4 / h))
    d3 = d(middle)
    before = motion.to(2, d3 * (2 / h), at_once=rough)
    d4 = d(before)
    b1, b2 = (d2 + d3) * (2 / h) - d4 * (1 / h), d4 * (4 / (h * h)) - (d2 + d3) * (4 / (h * h))  # d4 is waited for
    return KrogstadStages(middle, before, motion.to(2, b1, b2), motion.all_of(b1), motion.all_of(b2))


def tangent_of(
    options: ExponentialRungeKuttaOptions,
    equations: StageEquations,
    start: ClosedConfiguration,
    v: ca.SX,
    found: StiffResponse,
) -> tuple[ca.SX, ca.SX] | None:
    """(A, A_v) along X Lambda^-1 where the exponentials hold the tangent; None where they hold K and D."""
    if options.linearisation != "tangent" or not found.B.shape[1]:
        return None
    return equations.directional_derivatives(start, v, found.along(ca.SX.eye(found.B.shape[1])))


def along_tree(model: Model, options: ExponentialRungeKuttaOptions) -> bool:
    """Are there so many deflections along a tree that no matrix of them is formed?"""
    return options.linearisation == "stiffness" and model.has("shifted_solution")


def motion_along_tree(
    equations: StageEquations, start: ClosedConfiguration, x: ca.SX, v: ca.SX, a: ca.SX, h: ca.SX
) -> StiffTreeMotion:
    """Motions from (x, v), where q_i'' = a, with the inertia of a configuration."""
    return StiffTreeMotion(x, v, a, equations.deflections(), h, partial(equations.shifted_solution, start))


class ExponentialRungeKutta(OneStep):
    """Four evaluations a step in one stage."""

    options: ExponentialRungeKuttaOptions
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
        motion: StiffMotion | StiffTreeMotion
        if along_tree(self.model, self.options):
            motion = motion_along_tree(equations, start, x, v, equations.accelerations(start, v), h)
        else:
            found = equations.stiff_response(start, v)
            tangent = tangent_of(self.options, equations, start, v, found)
            motion = StiffMotion(x, v, found, h, tangent, halves=tangent is not None)
        loop = (
            equations.loop_part(start.q_d),
            equations.loop_part(equations.rates(start, v)),
            equations.loop_accelerations(start, v, motion.a),
        )
        seen: list[ClosedConfiguration] = [start]

        def d(stage: MotionStage) -> Along:
            guess = polynomial(loop, stage.tau)
            seen.append(equations.close(stage.q, guess, t + stage.tau, self.options.closure_iterations))
            return motion.remainder(equations.chart_accelerations(seen[-1], stage.v), stage)

        end = krogstad(motion, d).end
        there = equations.loop_part(seen[-1].q_d)
        at = self.arrived(equations, end.q, there, t + h)
        ends = {**self.rebased(z, at, there), "v": equations.velocities(at, end.v), "n": z["n"] + 1}
        return {**ends, **self.closed(z, *seen)}
