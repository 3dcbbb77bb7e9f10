"""Parameters that loads depend on, solved for so that no coordinate needs a holding force."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import casadi as ca
import numpy as np

from runtime.contract.model import EmittedModel
from runtime.operating.balance import Clamped
from runtime.operating.functions import ALREADY_CLOSED, rates_and_forces
from runtime.operating.mode_solver import State
from runtime.schemes.stage_equations import StageEquations

TRIM_ITERATIONS = 50
TRIM_TOLERANCE = 1e-12  # of the largest correction, relative to the largest value
BALANCED = 1e-9  # what may be left of the forces, relative to those before


def force_by_parameters(model: EmittedModel, names: Sequence[str], drives_move: bool = True) -> ca.Function:
    """(t, q_i, q_i_dot, a, loop unknowns, p) -> d(Q_hat - M_hat a)/d(p of these names) (n_i x k), q_d = f(q_i, p)."""
    index = [[parameter.name for parameter in model.parameters].index(name) for name in names]
    n = len(model.q_i)
    t, q, v, a = ca.SX.sym("t"), ca.SX.sym("q", n), ca.SX.sym("v", n), ca.SX.sym("a", n)
    loop, p = ca.SX.sym("loop", len(model.loop_unknowns)), ca.SX.sym("p", len(model.parameters))
    equations = StageEquations(model, model.kernel("constants")(p))
    _, M, Q = rates_and_forces(equations, equations.close(q, loop, t, ALREADY_CLOSED), v, drives_move)
    slope = ca.jacobian(Q - ca.mtimes(M, a), p)[:, index]
    return ca.Function("by_parameters", [t, q, v, a, loop, p], [ca.densify(slope)])


def _reciprocal(sizes: np.ndarray) -> np.ndarray:
    """1 / sizes; 1 for what has none, as the row of a coordinate on which nothing depends."""
    return 1.0 / np.where(sizes > 1e-300, sizes, 1.0)


@dataclass(frozen=True)
class Trimmed:
    """q_i, p and the iterations it took; converged. clamped: with the constants of the last p."""

    clamped: Clamped
    q_i: np.ndarray
    p: np.ndarray
    iterations: int
    converged: bool


def trimmed(model: EmittedModel, clamped: Clamped, q_i: np.ndarray, p: np.ndarray, names: Sequence[str]) -> Trimmed:
    """Newton on Q_hat(q_i, p) = 0 and the clamped coordinates' values, over q_i and the named parameters.

    It begins at the equilibrium with holding forces.
    """
    drives_move = clamped.functions.drives_move
    by_parameters = force_by_parameters(model, names, drives_move)
    index = [[parameter.name for parameter in model.parameters].index(name) for name in names]
    n, p = len(q_i), p.copy()
    start = np.inf
    for iteration in range(TRIM_ITERATIONS):
        clamped = clamped.with_constants(model.constants(p))
        at = clamped.values(q_i)
        if at is None:
            break
        state = State(clamped.t, q_i, clamped.rates(q_i), at.loop)
        Q_p = np.asarray(by_parameters(state.t, state.q_i, state.q_i_dot, np.zeros(n), state.loop, p))
        k = len(clamped.rows)
        matrix = np.block([[clamped.unknowns_slope(at), Q_p], [at.directions[clamped.rows], np.zeros((k, len(index)))]])
        side = np.concatenate([at.Q, at.places[clamped.rows] - clamped.goal])
        scale = _reciprocal(np.abs(matrix).max(axis=1))
        columns = _reciprocal(np.abs(matrix * scale[:, None]).max(axis=0))
        step = -columns * np.linalg.lstsq(matrix * np.outer(scale, columns), scale * side, rcond=1e-13)[0]
        size = float(np.abs(at.Q).max())
        start = size if iteration == 0 else start
        done = np.abs(step[:n]).max() <= TRIM_TOLERANCE * max(1.0, float(np.abs(q_i).max()))
        done = done and bool(np.all(np.abs(step[n:]) <= 1e-11 * np.maximum(np.abs(p[index]), 1e-300)))
        if done or size == 0:
            return Trimmed(clamped, q_i, p, iteration, size <= BALANCED * max(start, 1e-300) or iteration == 0)
        q_i = q_i + step[:n]
        p[index] += step[n:]
    return Trimmed(clamped, q_i, p, TRIM_ITERATIONS, False)
