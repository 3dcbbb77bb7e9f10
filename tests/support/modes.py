"""Coupled, condensed modes: eigenvalues of the equations linearised at a state, with damping, and who takes part."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from runtime import Solution
from runtime.contract.consistent_state import dense_eigenvalues, one_thread
from runtime.operating.mode_solver import ModeSolver, State, parameters_at, state_at


@dataclass(frozen=True)
class Modes:
    """At a state: eigenvalues (2 n) [1/s]; frequencies |lambda| [rad/s] and damping ratios of the n modes, ascending;
    participation (mode, coordinate), rows of sum 1: shares of kinetic energy.

    undamped: frequencies [rad/s] of M_hat w'' = J_q w, ascending; directions of negative stiffness count as zero.
    """

    eigenvalues: np.ndarray
    frequencies: np.ndarray
    damping: np.ndarray
    participation: np.ndarray
    undamped: np.ndarray

    @property
    def fastest_decay(self) -> float:
        """Largest -Re of the eigenvalues [1/s]; 0 if nothing decays."""
        return float((-self.eigenvalues.real).max(initial=0.0))


def modes_of(solver: ModeSolver, state: State) -> Modes:
    """The modes at a state. Raises LinAlgError if it is not finite or M_hat is singular."""
    M, n = solver.matrices(state)[0], solver.n
    A = np.zeros((2 * n, 2 * n))
    A[:n, n:] = np.eye(n)
    A[n:, :n], A[n:, n:] = solver.slopes(state, moving=True)
    undamped = np.sort(np.sqrt(np.maximum(dense_eigenvalues(-A[n:, :n]).real, 0.0)))
    with one_thread(2 * n):
        values, vectors = np.linalg.eig(A)
    chosen = _one_of_each(values, n)
    size = np.abs(values[chosen])
    with np.errstate(divide="ignore", invalid="ignore"):
        damping = np.where(size > 0, -values[chosen].real / size, 0.0)
    moving = np.abs(vectors[n:, chosen].T)  # rates
    weight = moving * (moving @ np.abs(M))
    total = weight.sum(axis=1, keepdims=True)
    return Modes(values, size, damping, weight / np.where(total > 0, total, 1.0), undamped)


def modes_at(solution: Solution, samples: Iterable[int]) -> list[Modes]:
    """Modes at some samples of a solution. Raises ModelError if the model was generated without its Jacobians."""
    model = solution.model
    found, solver = [], None
    for k in samples:
        if solver is None or model.signals.size:
            solver = ModeSolver(model, model.constants(parameters_at(solution, k)))
        found.append(modes_of(solver, state_at(solution, k)))
    return found


def _one_of_each(values: np.ndarray, n: int) -> np.ndarray:
    """Indices of n eigenvalues, ascending by size: one of each conjugate pair, every second of the real ones."""
    upper = [k for k in range(len(values)) if values[k].imag > 0]
    real = sorted((k for k in range(len(values)) if values[k].imag == 0), key=lambda k: abs(values[k]))
    chosen = upper + real[1::2]
    return np.array(sorted(chosen, key=lambda k: abs(values[k]))[:n], dtype=int)
