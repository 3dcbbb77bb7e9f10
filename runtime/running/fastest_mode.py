"""The fastest mode of a motion at its start, by which steps resolve it or not."""

from __future__ import annotations

import numpy as np

from runtime.contract.coordinates import independent, loop_part
from runtime.operating.mode_solver import ModeSolver, State
from runtime.running.monitor import known_slopes
from runtime.running.problem import Problem

RESOLVED_ANGLE = 0.5  # rad of the fastest mode a step


def slopes_at_start(problem: Problem) -> tuple[np.ndarray, np.ndarray] | None:
    """A_q, A_v (n_i x n_i) of w'' = A_q w + A_v w' at the start; None where they are not known."""
    model = problem.model
    if not ModeSolver.possible(model):
        return None
    q_i, rates = independent(model, problem.state.q, problem.state.q_dot)
    state = State(problem.t0, q_i, rates, loop_part(model, problem.state.q))
    return known_slopes(model, model.constants(problem.p), state)


def fastest_mode(problem: Problem) -> float | None:
    """The largest magnitude of an eigenvalue there [rad/s]; None where it is not known."""
    slopes = slopes_at_start(problem)
    if slopes is None:
        return None
    A_q, A_v = slopes
    n = len(A_q)
    return float(np.abs(np.linalg.eigvals(np.block([[np.zeros((n, n)), np.eye(n)], [A_q, A_v]]))).max())
