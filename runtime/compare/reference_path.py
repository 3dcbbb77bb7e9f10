"""A reference path that can be asked at any time."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from scipy.integrate import solve_ivp

from runtime.initial import ConsistentState
from runtime.model import Model
from runtime.reference import right_hand_side


class ReferenceError(RuntimeError):
    """The reference could not be computed."""


def reference_path(model: Model, c: np.ndarray, state: ConsistentState, t_end: float, rtol: float,
                   atol: float) -> Callable[[np.ndarray], np.ndarray]:
    """times (N,) -> q_i (N, n): DOP853 with its dense output. Raises ReferenceError."""
    columns, n = model.independent_columns, len(model.q_i)
    loop = [state.q[model.coordinates.index(name)] for name in model.loop_unknowns]
    y0 = np.concatenate([state.q[columns], state.q_dot[columns], loop])
    rhs, _ = right_hand_side(model)
    buffers: Any = rhs.buffer()
    buffer, call = buffers
    clock, position, slope = np.zeros(1), np.zeros(len(y0)), np.zeros(len(y0))
    for k, array in enumerate((clock, position, c)):
        buffer.set_arg(k, array.data)
    buffer.set_res(0, slope.data)

    def function(t: float, y: np.ndarray) -> np.ndarray:
        clock[0], position[:] = t, y
        call()
        return slope.copy()

    result = solve_ivp(function, (0.0, t_end), y0, method="DOP853", dense_output=True, rtol=rtol, atol=atol)
    if not result.success or not np.isfinite(result.y[:, -1]).all():
        raise ReferenceError(f"the reference stopped at t = {result.t[-1]:.6g} s: {result.message}")
    return lambda times: result.sol(np.clip(times, 0.0, t_end)).T[:, :n]
