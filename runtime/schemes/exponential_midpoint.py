"""Symmetric steps for very long undamped motion: stiff deflections exactly, the rest at the mean of both ends. Order 2.

With q_m = (q_n + q_{n+1}) / 2 and v_m likewise, one solution with 1 + n_s right-hand sides at (q_m, v_m) gives a_m and
X = M_hat^-1 B, and the step follows

    q'' = a_m - X (K (s - s_m) + D (s' - s'_m)),   s = B^T q,

exactly but for |R| = 1 (stiff_motion.py), iterated until q_m and v_m are the mean of the ends that they lead to. Then
the step from the end leads back to the start, so errors of energy do not add up. On linear mechanisms the force that is
held does the work F^T (q_{n+1} - q_n), which for F = -K_L q_m is what q^T K_L q / 2 loses: energy is kept to rounding
whatever the step, where a force held at the place that the motion passes in the middle feeds resonances in.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import partial

import casadi as ca
import numpy as np

from runtime.engine.program import Fields, Program, Sequence, Until
from runtime.schemes.one_step import OneStep
from runtime.schemes.options import MOST_ITERATIONS, ClosureOptions, Options, tolerances, whole_number
from runtime.schemes.scheme import LARGEST, ROUNDING, StateField, control, work
from runtime.schemes.sparse_lu import Number
from runtime.schemes.stage_equations import ClosedConfiguration, StageEquations, StiffResponse, stiff_directions
from runtime.schemes.step_limit import StepLimit, limit_beside_deflections
from runtime.schemes.stiff_motion import StiffMotion, StiffTreeMotion

USUAL_ITERATIONS = 6
STALLED = 512  # roundings of the state below which a change that no longer falls is what rounding leaves
REACH = 2.0  # h w and h d of the rest up to which the iteration converges


@dataclass(frozen=True)
class ExponentialMidpointOptions(ClosureOptions):
    """closure_iterations: Newton steps on the loop unknowns in each evaluation.

    eps: change of q(t + h) and h q_dot(t + h) by an iteration, relative to what they change in the step, at which it
        stops. max_iterations: the most in a step.
    """

    eps: tuple[float, ...] = tolerances(1e-14)
    max_iterations: int = whole_number(100, most=MOST_ITERATIONS)


class ExponentialMidpoint(OneStep):
    """x_end, v_end: the last iterate; response: what it was made with; change: by how much it differed."""

    options: ExponentialMidpointOptions

    def further_fields(self) -> dict[str, StateField]:
        """See above. What the iteration starts from does not act on what it converges to."""
        n, loops = len(self.model.q_i), len(self.model.loop_unknowns)
        n_s = 0 if self.by_tree else stiff_directions(self.model).shape[1]
        values = {"x_end": work(n), "v_end": work(n), "loop_dot": work(loops)}
        steering = {"response": n * (1 + n_s), "unconverged": 1, "change": 1}
        return values | {name: control(size) for name, size in steering.items()}

    @classmethod
    def limited(cls, options: Options) -> bool:
        """Yes, by what is not a stiff deflection."""
        return True

    def step_limit(self, A_q: np.ndarray, A_v: np.ndarray) -> StepLimit | None:
        """Where the iteration stops to converge, for the motion in which deflections follow as in equilibrium."""
        return limit_beside_deflections(A_q, A_v, stiff_directions(self.model), REACH, REACH)

    @property
    def iteration_limit(self) -> int:
        """The option max_iterations."""
        return self.options.max_iterations

    def program(self) -> Program:
        """Start from the last step's forces, iterate, finish."""
        iteration = self.stage("midpoint_iterate", self._iterate)
        flag = self.layout.slice("unconverged").start
        return Sequence(
            (
                self.stage("midpoint_begin", self._begin),
                Until(iteration, flag, self.options.max_iterations, USUAL_ITERATIONS),
                self.stage("midpoint_finish", self._finish),
            )
        )

    def evaluations(self) -> tuple[int, int]:
        """Of the usual number of iterations; a run counts its own."""
        return USUAL_ITERATIONS, 0

    @property
    def by_tree(self) -> bool:
        """Are there many deflections along a tree?"""
        return self.model.has("shifted_solution")

    def started(
        self, t0: ca.SX, q_i: ca.SX, q_i_dot: ca.SX, loop: ca.SX, equations: StageEquations
    ) -> Mapping[str, ca.SX]:
        """The response at the start."""
        fields = super().started(t0, q_i, q_i_dot, loop, equations)
        motion = equations.close(q_i, fields["loop"], t0, 1)
        return {**fields, "response": self._response(equations, motion, q_i_dot)}

    def _begin(self, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        start = None
        if self.by_tree:
            start = equations.close(z["x"], z["loop"], self.now(z, equations), self.options.closure_iterations)
        x, v = self._moved(z, equations, z["response"], start)
        return {"x_end": x, "v_end": v, "unconverged": self.alive(z), "change": ca.SX(LARGEST)}

    def _iterate(self, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        h, t = equations.h[0], self.now(z, equations) + equations.h[0] / 2
        x_m, v_m = (z["x"] + z["x_end"]) / 2, (z["v"] + z["v_end"]) / 2
        motion = equations.close(x_m, z["loop"], t, self.options.closure_iterations)
        response = self._response(equations, motion, v_m)
        x, v = self._moved(z, equations, response, motion)
        change = _largest(x - z["x_end"], h * (v - z["v_end"]))
        allowed = self.options.eps[0] * _largest(x - z["x"], h * (v - z["v"]))
        arrived = ca.logic_and(change >= z["change"], change <= STALLED * ROUNDING * _largest(x, h * v))
        settled = ca.logic_or(change <= allowed, arrived) * (change < LARGEST)
        return {
            "x_end": x,
            "v_end": v,
            "loop": equations.loop_part(motion.q_d),
            "loop_dot": equations.loop_part(equations.rates(motion, v_m)),
            "response": response,
            "unconverged": 1 - settled,
            "change": change,
            "iterations": z["iterations"] + 1,
            **self.closed(z, motion),
        }

    def _finish(self, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        h = equations.h[0]
        ahead = z["loop"] + h * z["loop_dot"]
        end = self.arrived(equations, z["x_end"], ahead, self.now(z, equations) + h)
        return {
            **self.rebased(z, end, ahead),
            "v": z["v_end"],
            "n": z["n"] + 1,
            "failures": z["failures"] + z["unconverged"],
        }

    # ---- the motion of a step -------------------------------------------------------------------------------

    def _response(self, equations: StageEquations, motion: ClosedConfiguration, v: ca.SX) -> ca.SX:
        """Accelerations without those of K and D, and X where there are few deflections."""
        if self.by_tree:
            return equations.accelerations(motion, v) + self._pushed(equations, motion, motion.q_i, v)
        found = equations.stiff_response(motion, v)
        rest = found.a + ca.mtimes(found.X, found.force(motion.q_i, v))
        return ca.vertcat(rest, ca.vec(ca.densify(found.X)))

    def _moved(
        self, z: Fields, equations: StageEquations, response: ca.SX, at: ClosedConfiguration | None
    ) -> tuple[ca.SX, ca.SX]:
        """Where the motion from the start of the step leads with a response; at: where a tree has its inertia."""
        x, v, h, n = z["x"], z["v"], equations.h[0], len(self.model.q_i)
        stiff = equations.deflections()
        motion: StiffMotion | StiffTreeMotion
        if at is not None and self.by_tree:
            a, solution = response - self._pushed(equations, at, x, v), partial(equations.shifted_solution, at)
            motion = StiffTreeMotion(x, v, a, stiff, h, solution)
        else:
            X = ca.reshape(response[n:], n, stiff.B.shape[1])
            a = response[:n] - ca.mtimes(X, stiff.force(x, v))
            motion = StiffMotion(x, v, StiffResponse(stiff.B, stiff.K, stiff.D, a, X), h, halves=True)
        end = motion.to(2)
        return end.q, end.v

    @staticmethod
    def _pushed(equations: StageEquations, at: ClosedConfiguration, x: ca.SX, v: ca.SX) -> ca.SX:
        """M_hat^-1 B (K s + D s')."""
        none = Number(ca.SX(0))
        return equations.shifted_solution(at, none, none, Number(equations.deflections().force(x, v))).re


def _largest(*vectors: ca.SX) -> ca.SX:
    return ca.norm_inf(ca.vertcat(*vectors))
