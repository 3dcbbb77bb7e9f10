"""Explicit Runge-Kutta steps of one size: the classical method of order 4 and Dormand and Prince's of order 8.

Opponents of the multirate schemes, compiled like them. The tableau of order 8 is SciPy's (E. Hairer's dop853).
"""

from __future__ import annotations

from abc import abstractmethod

import casadi as ca
import numpy as np

from runtime.engine.program import Fields, Program
from runtime.schemes.one_step import OneStep
from runtime.schemes.options import ClosureOptions, Options
from runtime.schemes.stage_equations import ClosedConfiguration, StageEquations
from runtime.schemes.step_limit import StepLimit, limit_between_the_axes


class ExplicitRungeKutta(OneStep):
    """A fixed step of the tableau (A, b, nodes) of a subclass."""

    options: ClosureOptions
    reach: float  # the largest stable h w of an undamped mode w
    decay_reach: float  # the largest stable h d of a pure decay d

    @staticmethod
    @abstractmethod
    def tableau() -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """A (s, s), b (s,) and the nodes (s,) of s stages."""

    @classmethod
    def limited(cls, options: Options) -> bool:
        """Yes: explicit."""
        return True

    def step_limit(self, A_q: np.ndarray, A_v: np.ndarray) -> StepLimit | None:
        """Of the tableau's stability region."""
        return limit_between_the_axes(A_q, A_v, self.reach, self.decay_reach)

    def program(self) -> Program:
        """One stage, all slopes inside."""
        return self.stage("runge_kutta", self._step)

    def evaluations(self) -> tuple[int, int]:
        """One for each slope."""
        return len(self.tableau()[1]), 0

    def _step(self, z: Fields, equations: StageEquations) -> dict[str, ca.SX]:
        h, t, n = equations.h[0], self.now(z, equations), len(self.model.q_i)
        y = ca.vertcat(z["x"], z["v"], z["loop"])
        A, b, nodes = self.tableau()
        slopes: list[ca.SX] = []
        motions: list[ClosedConfiguration] = []
        for k, row in enumerate(A):
            at = y + h * combined(row[:k], slopes)
            motion = equations.close(at[:n], at[2 * n :], t + float(nodes[k]) * h, self.options.closure_iterations)
            if k == 0:  # start from the closed position: a guess that was never corrected would drift
                y = ca.vertcat(y[: 2 * n], equations.loop_part(motion.q_d))
            a, v = equations.accelerations(motion, at[n : 2 * n]), at[n : 2 * n]
            slopes.append(ca.vertcat(equations.turning(motion, v), a, equations.loop_part(equations.rates(motion, v))))
            motions.append(motion)
        y = y + h * combined(b, slopes)
        end = self.arrived(equations, y[:n], y[2 * n :], t + h)
        ends = {**self.rebased(z, end, y[2 * n :]), "v": y[n : 2 * n], "n": z["n"] + 1}
        return {**ends, **self.closed(z, *motions)}


class ClassicalRungeKutta(ExplicitRungeKutta):
    """Order 4, four evaluations; an undamped mode is stable to h w = 2 sqrt(2), a decay to h d = 2.785."""

    reach, decay_reach, order = 2.8284, 2.7853, 4

    @staticmethod
    def tableau() -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Kutta's."""
        A = np.array([[0, 0, 0, 0], [0.5, 0, 0, 0], [0, 0.5, 0, 0], [0, 0, 1.0, 0]])
        return A, np.array([1, 2, 2, 1]) / 6, np.array([0, 0.5, 0.5, 1.0])


class DormandPrince8(ExplicitRungeKutta):
    """Order 8, twelve evaluations; an undamped mode is stable to h w = 5.96, a decay to h d = 6.39."""

    reach, decay_reach, order = 5.9604, 6.3936, 8

    @staticmethod
    def tableau() -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """SciPy's; its import takes a third of a second, which a run with another scheme need not spend."""
        from scipy.integrate import DOP853

        return DOP853.A, DOP853.B, DOP853.C


def combined(weights: np.ndarray, slopes: list[ca.SX]) -> ca.SX:
    """The sum of slopes by their weights, those of weight zero left out."""
    total = ca.SX(0)
    for weight, slope in zip(weights, slopes, strict=True):
        if weight:
            total = total + float(weight) * slope
    return total
