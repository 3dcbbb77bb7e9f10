"""Coupled, condensed modes: eigenvalues of the equations linearised at a state, with damping, and who takes part.

M_hat w'' = J_q w + J_v w' with the emitted Jacobians; J_q includes d(M_hat a)/dq_i. Step limits follow from these, not
from a body's clamped modes.
"""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca
import numpy as np

from runtime.model import Model
from runtime.schemes.kernels import StepKernels

CLOSURE_ITERATIONS = 3


@dataclass(frozen=True)
class State:
    """Time [s], independent coordinates, rates, and loop unknowns."""

    t: float
    q_i: np.ndarray
    q_i_dot: np.ndarray
    loop: np.ndarray


@dataclass(frozen=True)
class Modes:
    """At a state: eigenvalues (2 n) [1/s]; frequencies |lambda| [rad/s] and damping ratios of the n modes, ascending;
    participation (mode, coordinate), rows of sum 1: shares of kinetic energy."""

    eigenvalues: np.ndarray
    frequencies: np.ndarray
    damping: np.ndarray
    participation: np.ndarray


class ModeSolver:
    """Modes of a model with constants c. Raises ModelError if the model was generated without its Jacobians."""

    def __init__(self, model: Model, c: np.ndarray) -> None:
        n = len(model.q_i)
        t, q, v = ca.SX.sym("t"), ca.SX.sym("q", n), ca.SX.sym("v", n)
        loop, constants = ca.SX.sym("loop", len(model.loop_unknowns)), ca.SX.sym("c", model.c_size)
        kernels = StepKernels(model, constants)
        motion = kernels.close(q, loop, t, CLOSURE_ITERATIONS)
        found = kernels.linearised(motion, v)
        matrices = [ca.densify(matrix) for matrix in (found.M_hat, found.J_q, found.J_v)]
        self._function = ca.Function("modes", [t, q, v, loop, constants], matrices)
        self.n, self.c = n, c

    def matrices(self, state: State) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """M_hat, J_q, J_v."""
        M, J_q, J_v = self._function(state.t, state.q_i, state.q_i_dot, state.loop, self.c)
        return np.asarray(M), np.asarray(J_q), np.asarray(J_v)

    def __call__(self, state: State) -> Modes:
        """The modes at a state."""
        M, J_q, J_v = self.matrices(state)
        n = self.n
        A = np.zeros((2 * n, 2 * n))
        A[:n, n:] = np.eye(n)
        A[n:, :n], A[n:, n:] = np.linalg.solve(M, J_q), np.linalg.solve(M, J_v)
        values, vectors = np.linalg.eig(A)
        chosen = _one_of_each(values, n)
        size = np.abs(values[chosen])
        with np.errstate(divide="ignore", invalid="ignore"):
            damping = np.where(size > 0, -values[chosen].real / size, 0.0)
        moving = np.abs(vectors[n:, chosen].T)  # rates
        weight = moving * (moving @ np.abs(M))
        total = weight.sum(axis=1, keepdims=True)
        return Modes(values, size, damping, weight / np.where(total > 0, total, 1.0))


def _one_of_each(values: np.ndarray, n: int) -> np.ndarray:
    """Indices of n eigenvalues, ascending by size: one of each conjugate pair, every second of the real ones."""
    upper = [k for k in range(len(values)) if values[k].imag > 0]
    real = sorted((k for k in range(len(values)) if values[k].imag == 0), key=lambda k: abs(values[k]))
    chosen = upper + real[1::2]
    return np.array(sorted(chosen, key=lambda k: abs(values[k]))[:n], dtype=int)
