"""Frequencies and decay rates at a sample of a solution: what limits the step of an explicit scheme there."""

from __future__ import annotations

from typing import Any

import numpy as np

from runtime.coupled_frequencies import coupled_frequencies
from runtime.model import ModelError
from runtime.solution import Solution


def state_of(solution: Solution, k: int) -> dict[str, Any]:
    """q_i, q_d, their rates and t at sample k, by the names of kernel arguments."""
    model = solution.model
    q, v = solution.q[k], solution.q_dot[k]
    return {"q_i": q[model.independent_columns], "q_d": q[model.dependent_columns], "t": float(solution.t[k]),
            "q_i_dot": v[model.independent_columns], "q_d_dot": v[model.dependent_columns]}


def frequencies(solution: Solution, k: int) -> np.ndarray:
    """Coupled frequencies [rad/s] at sample k, ascending. Raises ModelError where they cannot be computed."""
    found = coupled_frequencies(solution.model, state_of(solution, k), solution.model.constants(solution.parameters))
    if found is None:
        raise ModelError(f"model {solution.model.name}: no frequencies at sample {k}; was dQ_hat_dq_i generated?")
    return found


def fastest_decay(solution: Solution, k: int) -> float:
    """Largest -Re of the eigenvalues of M_hat dv' = dQ_hat/dq_i dq + dQ_hat/dq_i_dot dv at sample k [1/s]."""
    model = solution.model
    values = {**state_of(solution, k), "c": model.constants(solution.parameters)}

    def call(name: str, output: str) -> np.ndarray:
        kernel = model.kernel(name)
        return np.asarray(kernel(**{key: values[key] for key in kernel.name_in()})[output])

    M_hat = call("condensed", "M_hat")
    n = len(M_hat)
    slopes = np.hstack([call("dQ_hat_dq_i", "dQ_hat_dq_i"), call("dQ_hat_dq_i_dot", "dQ_hat_dq_i_dot")])
    A = np.vstack([np.hstack([np.zeros((n, n)), np.eye(n)]), np.linalg.solve(M_hat, slopes)])
    return float(-np.linalg.eigvals(A).real.min())
