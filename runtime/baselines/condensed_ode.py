"""The condensed equations as a first-order system for general-purpose integrators: y = [q_i, q_i_dot, loop unknowns].

Turns stay zero: behind the loop unknowns come the Euler parameters of their bodies, e' = e o (0, omega) / 2, and
each evaluation takes e, made of unit length, for the chart.

The loop unknowns ride along as states, so that the right-hand side is a pure function: they only serve as the
guess from which the closure is solved.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import casadi as ca
import numpy as np

from runtime.contract.coordinates import charts_in, independent, loop_part, whole
from runtime.contract.model import EmittedModel, refuse_events
from runtime.contract.status import Status
from runtime.contract.tape import shared
from runtime.engine.rows import evaluate
from runtime.schemes.charts import Charts
from runtime.schemes.stage_equations import ClosedConfiguration, StageEquations
from runtime.solutions.observe import assemble_solution
from runtime.solutions.solution import Solution
from runtime.start.start_state import start_state

TO_ROUNDING = 3  # Newton steps of the closure from a guess that integration provides
OBSERVED = ("q_i", "q_d", "q_i_dot", "q_d_dot", "q_i_ddot", "q_d_ddot")


class CondensedOde:
    """Expressions: t, y and c are symbols, motion the closed configuration at y.

    closure_iterations: Newton steps a closure. One is enough for integration, as the guess is as good as the states.
    """

    def __init__(self, model: EmittedModel, closure_iterations: int) -> None:
        n, loops = len(model.q_i), len(model.loop_unknowns)
        self.model, self.n = model, n
        self.charts, ends = Charts(model), 2 * n + loops
        self.t, self.c = ca.SX.sym("t"), ca.SX.sym("c", model.c_size)
        self.y = ca.SX.sym("y", ends + self.charts.size)
        self.q_i, self.v, self.e = self.charts.zeroed(self.y[:n]), self.y[n : 2 * n], self.y[ends:]
        at = charts_in(model) if self.charts.size else slice(0, 0)
        c = ca.vertcat(self.c[: at.start], self.charts.unit(self.e), self.c[at.stop :])
        self.equations = StageEquations(model, c)
        self.motion: ClosedConfiguration = self.equations.close(
            self.q_i, self.charts.zeroed_loops(self.y[2 * n : ends]), self.t, closure_iterations
        )
        self.v_d = self.equations.rates(self.motion, self.v)

    def slope(self, a: ca.SX) -> ca.SX:
        """y_dot for q_i_ddot = a."""
        turning = self.charts.parameter_rates(self.e, self.v, self.v_d)
        following = self.equations.loop_part(self.charts.zeroed_dependent(self.v_d))
        return ca.densify(ca.vertcat(self.charts.zeroed(self.v), a, following, turning))

    def accelerations(self) -> ca.SX:
        """q_i_ddot by the cheapest route."""
        return self.equations.accelerations(self.motion, self.v)

    def right_hand_side(self) -> ca.Function:
        """(t, y, c) -> y_dot."""
        return ca.Function("rhs", [self.t, self.y, self.c], shared([self.slope(self.accelerations())]))

    def jacobian(self) -> ca.Function:
        """(t, y, c) -> d y_dot / dy."""
        found = ca.jacobian(self.slope(self.accelerations()), self.y)
        return ca.Function("slope_jacobian", [self.t, self.y, self.c], shared([ca.densify(found)]))

    def observe(self) -> ca.Function:
        """(t, y, c) -> OBSERVED."""
        a, a_d = self.accelerations(), ca.SX(0, 1)
        if self.model.q_d:
            a_d = self.equations.dependent_accelerations(self.motion, self.v, a)
        parts = [self.q_i, self.motion.q_d, self.v, self.v_d, a, a_d]
        return ca.Function("observe", [self.t, self.y, self.c], shared(parts), ["t", "y", "c"], list(OBSERVED))


@dataclass(frozen=True)
class Start:
    """Parameters, constants and y of a run from t = 0."""

    p: np.ndarray
    c: np.ndarray
    y: np.ndarray


def start_of(
    model: EmittedModel, parameters: Mapping[str, float] | None, initial: Mapping[str, float] | None, start: str | None
) -> Start:
    """Raises ModelError or InitialStateError for bad arguments."""
    refuse_events(model, "integrators of other packages")
    p = model.parameter_vector(parameters)
    c = model.constants(p)
    state = start_state(model, p, c, 0.0, initial, start)
    return Start(p, c, integrated(model, state.q, state.q_dot))


def integrated(model: EmittedModel, q: np.ndarray, q_dot: np.ndarray) -> np.ndarray:
    """y of a consistent state of all coordinates."""
    loop = loop_part(model, q)
    return np.concatenate([*independent(model, q, q_dot), loop, q[model.places.parameters.ravel()]])


def observed_solution(
    model: EmittedModel,
    start: Start,
    t: np.ndarray,
    y: np.ndarray,
    name: str,
    stats: dict[str, float | int | str],
    status: Status,
) -> Solution:
    """Solution of the states y (N, size) at times t."""
    observed = evaluate(CondensedOde(model, TO_ROUNDING).observe(), {"t": t[:, None], "y": y}, start.c)
    return assemble_solution(
        model,
        t,
        whole(model, observed["q_i"], observed["q_d"]),
        whole(model, observed["q_i_dot"], observed["q_d_dot"]),
        whole(model, observed["q_i_ddot"], observed["q_d_ddot"]),
        start.p,
        start.c,
        name,
        0.0,
        [],
        stats,
        status,
    )
