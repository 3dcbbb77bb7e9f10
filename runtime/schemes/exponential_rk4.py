"""Exponential Runge-Kutta steps of order 4 on the stiff deflections only: no Jacobian of the mechanism, O(N) on trees.

Stiff deflections s = B^T q_i (n_s of them: modes, springs between coordinates) have a stiffness K and a damping D. At
the start of a step one solution with 1 + n_s right-hand sides gives

    a_n,   X = M_hat^-1 B.

stiff_motion.py follows the stiff part exactly, beside accelerations a_n + b1 tau + b2 tau^2/2 of the rest. Stages of
Krogstad (2005), with d_i the accelerations at stage i less a_n and less what the stiff part accounts for:

    Y2  to h/2, b1 = b2 = 0        Y3  to h/2, b1 = 4 d2 / h        Y4  to h, b1 = 2 d3 / h
    end to h,   b1 = (2 d2 + 2 d3 - d4) / h,   b2 = 4 (d4 - d2 - d3) / h^2

Without stiff deflections it is an explicit Runge-Kutta method of order 4.

The embedded estimate of the error is nearly free: the end less Y4, which follows the stiff part in one sub-step that
damps where the end takes two, so that it sees modes that are not resolved. A rejected step keeps a_n and X.
The polynomial a_n + b1 tau + b2 tau^2/2 that leads to the end leads to any time before it, with an error of
h^4 in q_i_dot.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial

import casadi as ca
import numpy as np

from runtime.contract.model import EmittedModel
from runtime.engine.program import Fields
from runtime.schemes.linear_propagation import polynomial
from runtime.schemes.one_step import Attempt, Method
from runtime.schemes.options import MOST_UNROLLED, AdaptiveOptions, whole_number
from runtime.schemes.scheme import StateField, state
from runtime.schemes.stage_equations import ClosedConfiguration, StageEquations, StiffResponse, stiff_directions
from runtime.schemes.step_limit import StepLimit, limit_beside_deflections
from runtime.schemes.stiff_motion import Along, MotionStage, StiffMotion, StiffTreeMotion

# h w and h d up to which the explicit part is stable: above sqrt(2) a mode grows by 1e-3 a step at 1.6, by 2 % at 2
IMAGINARY_REACH, REAL_REACH = 2**0.5, 2.785


@dataclass(frozen=True)
class ExponentialRungeKuttaOptions(AdaptiveOptions):
    """closure_iterations: Newton steps on the loop unknowns in each evaluation, from a guess that is right to h^3.

    tolerance, error_of: see AdaptiveOptions.
    """

    closure_iterations: int = whole_number(2, most=MOST_UNROLLED)


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


def along_tree(model: EmittedModel) -> bool:
    """Are there so many deflections along a tree that no matrix of them is formed?"""
    return model.has("shifted_solution")


def motion_along_tree(
    equations: StageEquations, start: ClosedConfiguration, x: ca.SX, v: ca.SX, a: ca.SX, h: ca.SX
) -> StiffTreeMotion:
    """Motions from (x, v), where q_i'' = a, with the inertia of a configuration."""
    return StiffTreeMotion(x, v, a, equations.deflections(), h, partial(equations.shifted_solution, start))


class ExponentialRungeKutta(Method):
    """One evaluation at the start of a step, three more to its end.

    References
    ----------
    S. Krogstad, Generalized integrating factor methods for stiff PDEs, Journal of Computational Physics 203 (1), 2005,
    72-88.
    """

    options: ExponentialRungeKuttaOptions
    order, error_order, counted_evaluations = 4, 4, (1, 3)
    strictness = 1.5
    stage_name = "exponential_rk4"

    def step_limit(self, A_q: np.ndarray, A_v: np.ndarray) -> StepLimit | None:
        """Of the explicit part, for the motion in which the stiff deflections follow as in equilibrium."""
        return limit_beside_deflections(A_q, A_v, stiff_directions(self.model), IMAGINARY_REACH, REAL_REACH)

    def method_fields(self) -> dict[str, StateField]:
        """X = M_hat^-1 B, the polynomial of the accelerations, and rates of the loop unknowns."""
        n, n_s = stiff_directions(self.model).shape
        n_s = 0 if along_tree(self.model) else n_s
        sizes = {
            "X": n * n_s,
            **dict.fromkeys(("loop_dot", "loop_bend"), len(self.model.loop_unknowns)),
            "b1": n,
            "b2": n,
        }
        return {name: state(size) for name, size in sizes.items()}

    def step_start(
        self, z: Fields, equations: StageEquations
    ) -> tuple[ClosedConfiguration, ca.SX, Mapping[str, ca.SX]]:
        """Accelerations, and what forces along the stiff deflections do."""
        t = self.time_in_step(z, ca.SX(0), 0)
        start = equations.close(z["q_from"], z["loop_from"], t, self.options.closure_iterations)
        rates = equations.loop_part(equations.rates(start, z["v_from"]))
        if along_tree(self.model):
            return start, equations.accelerations(start, z["v_from"]), {"loop_dot": rates, "loop_bend": rates}  # none
        found = equations.stiff_response(start, z["v_from"])
        bends = equations.loop_accelerations(start, z["v_from"], found.a)
        return start, found.a, {"loop_dot": rates, "loop_bend": bends, "X": ca.vec(ca.densify(found.X))}

    def attempted(self, z: Fields, equations: StageEquations, h: ca.SX) -> Attempt:
        """Three evaluations."""
        motion = self._motion(z, equations, h)
        configurations: list[ClosedConfiguration] = []

        def d(stage: MotionStage) -> Along:
            share = (0.5, 0.5, 1.0)[len(configurations)]
            guess = polynomial([z["loop_from"], z["loop_dot"], z["loop_bend"]], stage.tau)
            at = equations.close(stage.q, guess, self.time_in_step(z, h, share), self.options.closure_iterations)
            configurations.append(at)
            return motion.remainder(equations.chart_accelerations(at, stage.v), stage)

        found = krogstad(motion, d, rough=self.options.tolerance > 0)
        kept = {"b1": found.b1, "b2": found.b2}
        end, loop = found.end, equations.loop_part(configurations[-1].q_d)
        return Attempt(end.q, end.v, loop, end.q - found.before.q, end.v - found.before.v, kept, tuple(configurations))

    def between(self, z: Fields, equations: StageEquations, tau: ca.SX, h: ca.SX | None = None) -> tuple[ca.SX, ca.SX]:
        """The same motion, ended sooner."""
        motion = self._motion(z, equations, tau)
        stage = motion.to(2, motion.beside(z["b1"]), motion.beside(z["b2"]))
        return stage.q, self.velocities_at(z, equations, tau, stage.q, stage.v)

    def _motion(self, z: Fields, equations: StageEquations, h: ca.SX) -> StiffMotion | StiffTreeMotion:
        if along_tree(self.model):
            t = self.time_in_step(z, ca.SX(0), 0)
            start = equations.close(z["q_from"], z["loop_from"], t, self.options.closure_iterations)
            return motion_along_tree(equations, start, z["q_from"], z["v_from"], z["a_from"], h)
        stiff = equations.deflections()
        n, n_s = stiff.B.shape
        found = StiffResponse(stiff.B, stiff.K, stiff.D, z["a_from"], ca.reshape(z["X"], n, n_s))
        return StiffMotion(z["q_from"], z["v_from"], found, h)
