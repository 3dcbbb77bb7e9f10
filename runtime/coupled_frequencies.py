"""Coupled, condensed frequencies: generalised eigenvalues of -dQ_hat/dq_i against M_hat at a state.

The step limit of an explicit scheme follows from these, not from a body's clamped modes: they can be 0.65 to 5.8
times as high.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
import scipy.linalg

from runtime.model import Model

STATE = ("q_i", "q_d", "q_i_dot", "q_d_dot", "t")


def coupled_frequencies(model: Model, state: Mapping[str, Any], c: np.ndarray) -> np.ndarray | None:
    """Frequencies [rad/s] in ascending order at a state (q_i, q_d, q_i_dot, q_d_dot, t).

    None if the model was generated without dQ_hat_dq_i or the state is not finite. Directions of negative stiffness
    count as zero.
    """
    if not model.has("dQ_hat_dq_i"):
        return None
    values = {name: state[name] for name in STATE} | {"c": c}

    def call(name: str, output: str) -> np.ndarray:
        kernel = model.kernel(name)
        return np.asarray(kernel(**{key: values[key] for key in kernel.name_in()})[output])

    M_hat, stiffness = call("condensed", "M_hat"), -call("dQ_hat_dq_i", "dQ_hat_dq_i")
    if not (np.all(np.isfinite(M_hat)) and np.all(np.isfinite(stiffness))):
        return None
    return np.sort(np.sqrt(np.maximum(scipy.linalg.eigvals(stiffness, M_hat).real, 0.0)))


def fastest_frequency(model: Model, state: Mapping[str, Any], c: np.ndarray) -> float | None:
    """The largest coupled frequency [rad/s], or None where it cannot be computed."""
    frequencies = coupled_frequencies(model, state, c)
    return None if frequencies is None or not len(frequencies) else float(frequencies[-1])
