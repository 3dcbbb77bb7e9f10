"""Explicit Runge-Kutta steps of one size: the classical method of order 4 and Dormand and Prince's of order 8.

Opponents of the multirate schemes, compiled like them. Each is a Butcher tableau (`tableau`). That of order 8 is
SciPy's (E. Hairer's dop853).
"""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Mapping
from functools import cached_property, partial

import casadi as ca
import numpy as np

from runtime.engine.program import Call, Fields, Program, Sequence
from runtime.schemes.one_step import Attempt, Method
from runtime.schemes.options import AdaptiveOptions, ClosureOptions, SingleClosureOptions
from runtime.schemes.scheme import StateField, state, work
from runtime.schemes.stage_equations import ClosedConfiguration, StageEquations, tree_is_shorter
from runtime.schemes.step_limit import StepLimit, limit_between_the_axes

LONG_STEP = 50_000  # operations: the code of a step with each evaluation written out is longer than caches hold


class ExplicitRungeKutta(Method):
    """A fixed step of the tableau (A, b, nodes) of a subclass.

    A long step calls one stage for all its evaluations, which is faster than copies of it (0.24 ns an operation in
    place of 0.4) and takes a part of the time to compile. Between them y holds where to evaluate, slope_k what came.
    """

    options: ClosureOptions
    stage_name, by_rates = "runge_kutta", False
    damps = True
    reach: float  # the largest stable h w of an undamped mode w
    decay_reach: float  # the largest stable h d of a pure decay d

    @staticmethod
    @abstractmethod
    def tableau() -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """A (s, s), b (s,) and the nodes (s,) of s stages."""

    def step_limit(self, A_q: np.ndarray, A_v: np.ndarray) -> StepLimit | None:
        """Of the tableau's stability region."""
        return limit_between_the_axes(A_q, A_v, self.reach, self.decay_reach)

    @property
    def counted_evaluations(self) -> tuple[int, int]:  # type: ignore[override]
        """One for each slope."""
        return 1, len(self.tableau()[1]) - 1

    def fields(self) -> dict[str, StateField]:
        """Those between the stages of a long step, too."""
        if not self.is_long:
            return super().fields()
        loops = len(self.model.loop_unknowns)
        size, stages = 2 * len(self.model.q_i) + loops, len(self.tableau()[1])
        slopes = {f"slope_{k}": work(size) for k in range(stages)}
        return {**super().fields(), "y": work(size), "t_there": work(1), "loop_there": work(loops), **slopes}

    @cached_property
    def is_long(self) -> bool:
        """Is a step, with each evaluation written out, longer than code should be?"""
        names = ["closure", "velocities", "forward_dynamics" if tree_is_shorter(self.model) else "condensed"]
        evaluation = sum(self.model.operations_of(name) for name in names if self.model.has(name))
        return evaluation * len(self.tableau()[1]) > LONG_STEP

    def program(self) -> Program:
        """One stage; of a long step several: where to evaluate, and the evaluation, in turns."""
        if not self.is_long:
            return super().program()
        evaluation = self.stage("slope", self._evaluated)
        places = [self.stage(f"place_{k}", partial(self._placed, k)) for k in range(len(self.tableau()[1]))]
        parts: list[Call] = [part for place in places for part in (place, evaluation)]
        return Sequence((*parts, self.stage(self.stage_name, self._ended)))

    def _placed(self, k: int, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        """Where slope k is evaluated, from those before it; each evaluation leaves its slope as the last one's."""
        A, _, nodes = self.tableau()
        t = self.now(z, equations) + float(nodes[k]) * equations.h[0]
        if k == 0:
            return {"y": ca.vertcat(z["x"], z["v"], z["loop"]), "t_there": t}
        kept = {"loop": z["loop_there"]} if k == 1 else {}  # closed where the step starts
        known = {f"slope_{k - 1}": z[f"slope_{len(A) - 1}"]}
        slopes = [known.get(f"slope_{one}", z[f"slope_{one}"]) for one in range(k)]
        start = ca.vertcat(z["x"], z["v"], kept.get("loop", z["loop"]))
        return {**kept, **known, "y": start + equations.h[0] * combined(A[k][:k], slopes), "t_there": t}

    def _evaluated(self, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        """The slope at y, left as the last one, and what its closure was."""
        motion, slope = self.slope(z, equations, z["y"], z["t_there"])
        last = f"slope_{len(self.tableau()[1]) - 1}"
        return {last: slope, "loop_there": equations.loop_part(motion.q_d), **self.closed(z, motion)}

    def _ended(self, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        """The end of the step from all slopes."""
        b, n = self.tableau()[1], len(self.model.q_i)
        slopes = [z[f"slope_{k}"] for k in range(len(b))]
        y = ca.vertcat(z["x"], z["v"], z["loop"]) + equations.h[0] * combined(b, slopes)
        end = self.arrived(equations, y[:n], y[2 * n :], self.now(z, equations) + equations.h[0])
        return {**self.rebased(z, end, y[2 * n :]), "v": y[n : 2 * n], "n": z["n"] + 1}

    def step_start(
        self, z: Fields, equations: StageEquations
    ) -> tuple[ClosedConfiguration, ca.SX, Mapping[str, ca.SX]]:
        """The first slope. Its closed position is where the step starts: a guess never corrected would drift."""
        t = self.time_in_step(z, ca.SX(0), 0)
        start = equations.close(z["q_from"], z["loop_from"], t, self.options.closure_iterations)
        rates = equations.loop_part(equations.rates(start, z["v_from"]))
        return start, equations.accelerations(start, z["v_from"]), {"loop_dot": rates}

    def attempted(self, z: Fields, equations: StageEquations, h: ca.SX) -> Attempt:
        """The other slopes of (q_i, q_i_dot, loop unknowns); no estimate."""
        n = len(self.model.q_i)
        y, _, configurations = self.slopes(z, equations, h)
        none = ca.SX(0, 1)
        return Attempt(y[:n], y[n : 2 * n], y[2 * n :], none, none, {}, configurations)

    def slopes(
        self, z: Fields, equations: StageEquations, h: ca.SX
    ) -> tuple[ca.SX, list[ca.SX], tuple[ClosedConfiguration, ...]]:
        """(end, slopes, where they were evaluated); the first one is that of the start of the step."""
        A, b, nodes = self.tableau()
        start = ca.vertcat(z["q_from"], z["v_from"], z["loop_from"])
        slopes, configurations = [ca.vertcat(z["v_from"], z["a_from"], z["loop_dot"])], list[ClosedConfiguration]()
        for row, node in zip(A[1:], nodes[1:], strict=True):
            y = start + h * combined(row[: len(slopes)], slopes)
            motion, slope = self.slope(z, equations, y, self.time_in_step(z, h, float(node)))
            slopes.append(slope)
            configurations.append(motion)
        return start + h * combined(b, slopes), slopes, tuple(configurations)

    def slope(self, z: Fields, equations: StageEquations, y: ca.SX, t: ca.SX) -> tuple[ClosedConfiguration, ca.SX]:
        """(configuration, rates) of y = (q_i, q_i_dot, loop unknowns)."""
        n = len(self.model.q_i)
        v, motion = y[n : 2 * n], equations.close(y[:n], y[2 * n :], t, self.options.closure_iterations)
        loops = equations.loop_part(equations.rates(motion, v))
        return motion, ca.vertcat(equations.turning(motion, v), equations.accelerations(motion, v), loops)


class ClassicalRungeKutta(ExplicitRungeKutta):
    """Order 4, four evaluations; an undamped mode is stable to h w = 2 sqrt(2), a decay to h d = 2.785.

    References
    ----------
    W. Kutta, Beitrag zur naeherungsweisen Integration totaler Differentialgleichungen, Zeitschrift fuer Mathematik und
    Physik 46, 1901, 435-453.
    E. Hairer, S. P. Norsett and G. Wanner, Solving Ordinary Differential Equations I, 2nd ed., Springer, 1993, II.1.
    """

    options: SingleClosureOptions
    reach, decay_reach, order = 2.8284, 2.7853, 4

    @staticmethod
    def tableau() -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Kutta's."""
        A = np.array([[0, 0, 0, 0], [0.5, 0, 0, 0], [0, 0.5, 0, 0], [0, 0, 1.0, 0]])
        return A, np.array([1, 2, 2, 1]) / 6, np.array([0, 0.5, 0.5, 1.0])


class DormandPrince8(ExplicitRungeKutta):
    """Order 8, twelve evaluations; an undamped mode is stable to h w = 5.96, a decay to h d = 6.39.

    References
    ----------
    P. J. Prince and J. R. Dormand, High order embedded Runge-Kutta formulae, Journal of Computational and Applied
    Mathematics 7 (1), 1981, 67-75.
    E. Hairer, S. P. Norsett and G. Wanner, Solving Ordinary Differential Equations I, 2nd ed., Springer, 1993, II.5.
    """

    options: SingleClosureOptions
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


# Dormand and Prince's explicit pair of orders 5 and 4, by fixed steps or by steps as long as a tolerance asks for.
#
# For motion without stiffness. The last evaluation of a step is the first of the next one, and all that a rejected step
# keeps. Between the ends q_i is the polynomial of degree 5 through q_i, q_i_dot and q_i_ddot at both: order 5.

A = np.array(
    [
        [0, 0, 0, 0, 0, 0],
        [1 / 5, 0, 0, 0, 0, 0],
        [3 / 40, 9 / 40, 0, 0, 0, 0],
        [44 / 45, -56 / 15, 32 / 9, 0, 0, 0],
        [19372 / 6561, -25360 / 2187, 64448 / 6561, -212 / 729, 0, 0],
        [9017 / 3168, -355 / 33, 46732 / 5247, 49 / 176, -5103 / 18656, 0],
    ]
)
WEIGHTS = np.array([35 / 384, 0, 500 / 1113, 125 / 192, -2187 / 6784, 11 / 84])
NODES = np.array([0, 1 / 5, 3 / 10, 4 / 5, 8 / 9, 1])
ERROR = np.array([71 / 57600, 0, -71 / 16695, 71 / 1920, -17253 / 339200, 22 / 525, -1 / 40])  # orders 5 less 4


class DormandPrince5(ExplicitRungeKutta):
    """Order 5, six evaluations; an undamped mode is stable to h w = 0.997, a decay to h d = 3.306.

    References
    ----------
    J. R. Dormand and P. J. Prince, A family of embedded Runge-Kutta formulae, Journal of Computational and Applied
    Mathematics 6 (1), 1980, 19-26.
    """

    options: AdaptiveOptions
    reach, decay_reach, order = 0.997, 3.306, 5
    error_order, counted_evaluations = 5, (0, 6)
    strictness = 300.0  # its estimate is much nearer to the error than that of a method whose last stage is of order 2
    first_same_as_last = True

    @staticmethod
    def tableau() -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Dormand and Prince (1980)."""
        return A, WEIGHTS, NODES

    def method_fields(self) -> dict[str, StateField]:
        """Rates of the loop unknowns at the start, and accelerations and these rates at the end."""
        n, loops = len(self.model.q_i), len(self.model.loop_unknowns)
        return {"a_to": state(n), "loop_dot": state(loops), "loop_dot_to": state(loops)}

    def moved(self, z: Fields) -> Mapping[str, ca.SX]:
        """What was evaluated at the end of the last step."""
        return {"a_from": z["a_to"], "loop_dot": z["loop_dot_to"]}

    def attempted(self, z: Fields, equations: StageEquations, h: ca.SX) -> Attempt:
        """And the slope at the end, with which the step of order 4 is estimated."""
        n = len(self.model.q_i)
        y, slopes, configurations = self.slopes(z, equations, h)
        end, last = self.slope(z, equations, y, self.time_in_step(z, h, 1.0))
        error = h * combined(ERROR, [*slopes, last])
        kept = {"a_to": last[n : 2 * n], "loop_dot_to": last[2 * n :]}
        return Attempt(y[:n], y[n : 2 * n], y[2 * n :], error[:n], error[n : 2 * n], kept, configurations, end)

    def between(self, z: Fields, equations: StageEquations, tau: ca.SX, h: ca.SX | None = None) -> tuple[ca.SX, ca.SX]:
        """The polynomial of degree 5 and its derivative."""
        h = z["t_to"] - z["t_from"] if h is None else h
        q, v, a = (z[f"{name}_to"] for name in "qva")
        to = ClosedConfiguration(q, ca.SX(0, 1), z["t_to"], ca.SX(0), ca.SX(0, 1))
        if self.charts.split:
            to = equations.close(q, z["loop_to"], z["t_to"], self.options.closure_iterations)
        rate = equations.turning(to, v)
        end = equations.coordinate_accelerations(to, rate, v, a)
        place, rate = quintic(tau, h, z["q_from"], z["v_from"], z["a_from"], q, rate, end)
        return place, self.velocities_at(z, equations, tau, place, rate)


def quintic(
    tau: ca.SX, h: ca.SX, q0: ca.SX, v0: ca.SX, a0: ca.SX, q1: ca.SX, v1: ca.SX, a1: ca.SX
) -> tuple[ca.SX, ca.SX]:
    """(q, q') at tau of the polynomial of degree 5 with these values and derivatives at 0 and h."""
    x = tau / h
    bent, turned = q1 - q0 - h * (v0 + h / 2 * a0), h * (v1 - v0 - h * a0)
    curved = h * h * (a1 - a0)
    c3 = 10 * bent - 4 * turned + curved / 2
    c4 = -15 * bent + 7 * turned - curved
    c5 = 6 * bent - 3 * turned + curved / 2
    q = q0 + tau * (v0 + tau / 2 * a0) + x**3 * (c3 + x * (c4 + x * c5))
    return q, v0 + tau * a0 + x * x / h * (3 * c3 + x * (4 * c4 + x * 5 * c5))
