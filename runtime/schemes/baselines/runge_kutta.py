"""Explicit Runge-Kutta steps of one size: the classical method of order 4 and Dormand and Prince's of order 8.

Opponents of the multirate schemes, compiled like them. The tableau of order 8 is SciPy's (E. Hairer's dop853).
"""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Mapping

import casadi as ca
import numpy as np

from runtime.engine.program import Fields
from runtime.schemes.method import Attempt, Method
from runtime.schemes.options import ClosureOptions, Options
from runtime.schemes.stage_equations import ClosedConfiguration, StageEquations
from runtime.schemes.step_limit import StepLimit, limit_between_the_axes


class ExplicitRungeKutta(Method):
    """A fixed step of the tableau (A, b, nodes) of a subclass."""

    options: ClosureOptions
    stage_name, by_rates = "runge_kutta", False
    damps = True
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

    @property
    def counted_evaluations(self) -> tuple[int, int]:  # type: ignore[override]
        """One for each slope."""
        return 1, len(self.tableau()[1]) - 1

    def begun(self, z: Fields, equations: StageEquations) -> tuple[ClosedConfiguration, ca.SX, Mapping[str, ca.SX]]:
        """The first slope. Its closed position is where the step starts: a guess never corrected would drift."""
        t = self.time_in_step(z, ca.SX(0), 0)
        start = equations.close(z["q_from"], z["loop_from"], t, self.options.closure_iterations)
        rates = equations.loop_part(equations.rates(start, z["v_from"]))
        return start, equations.accelerations(start, z["v_from"]), {"loop_dot": rates}

    def attempted(self, z: Fields, equations: StageEquations, h: ca.SX) -> Attempt:
        """The other slopes of (q_i, q_i_dot, loop unknowns); no estimate."""
        n = len(self.model.q_i)
        y, _, seen = self.slopes(z, equations, h)
        none = ca.SX(0, 1)
        return Attempt(y[:n], y[n : 2 * n], y[2 * n :], none, none, {}, seen)

    def slopes(
        self, z: Fields, equations: StageEquations, h: ca.SX
    ) -> tuple[ca.SX, list[ca.SX], tuple[ClosedConfiguration, ...]]:
        """(end, slopes, where they were evaluated); the first one is that of the start of the step."""
        A, b, nodes = self.tableau()
        start = ca.vertcat(z["q_from"], z["v_from"], z["loop_from"])
        slopes, seen = [ca.vertcat(z["v_from"], z["a_from"], z["loop_dot"])], list[ClosedConfiguration]()
        for row, node in zip(A[1:], nodes[1:], strict=True):
            y = start + h * combined(row[: len(slopes)], slopes)
            motion, slope = self.slope(z, equations, y, self.time_in_step(z, h, float(node)))
            slopes.append(slope)
            seen.append(motion)
        return start + h * combined(b, slopes), slopes, tuple(seen)

    def slope(self, z: Fields, equations: StageEquations, y: ca.SX, t: ca.SX) -> tuple[ClosedConfiguration, ca.SX]:
        """(configuration, rates) of y = (q_i, q_i_dot, loop unknowns)."""
        n = len(self.model.q_i)
        v, motion = y[n : 2 * n], equations.close(y[:n], y[2 * n :], t, self.options.closure_iterations)
        loops = equations.loop_part(equations.rates(motion, v))
        return motion, ca.vertcat(equations.turning(motion, v), equations.accelerations(motion, v), loops)


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
