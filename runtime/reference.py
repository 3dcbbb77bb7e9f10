"""A tight reference path: DOP853 on the emitted functions, for judging the step schemes by.

The loop unknowns ride along as states, so that the right-hand side is a pure function: they only serve as the
guess from which the closure is solved to rounding.
"""

from __future__ import annotations

import time
from collections.abc import Mapping
from typing import Any

import casadi as ca
import numpy as np
from scipy.integrate import solve_ivp

from runtime.model import Model
from runtime.observe import assemble_solution, evaluate, join
from runtime.schemes.kernels import StepKernels
from runtime.schemes.linear_solve import solve_symmetric
from runtime.solution import Solution
from runtime.start_state import start_state
from runtime.status import Status

CLOSURE_ITERATIONS = 3


def right_hand_side(model: Model) -> tuple[ca.Function, ca.Function]:
    """(t, y, c) -> y_dot and (t, y, c) -> q_i, q_d, q_i_dot, q_d_dot, q_i_ddot, q_d_ddot; y = [q_i, q_i_dot, loop]."""
    n, loops = len(model.q_i), len(model.loop_unknowns)
    t, y, c = ca.SX.sym("t"), ca.SX.sym("y", 2 * n + loops), ca.SX.sym("c", model.kernel("constants").size1_out(0))
    q_i, v, loop = y[:n], y[n:2 * n], y[2 * n:]
    kernels = StepKernels(model, c)
    motion = kernels.close(q_i, loop, t, CLOSURE_ITERATIONS)
    M_hat, Q_hat = kernels.condensed(motion, v)
    a = solve_symmetric(M_hat, Q_hat)
    v_d = kernels.rates(motion, v)
    a_d = ca.SX(0, 1)
    if model.q_d:
        a_d = kernels.call("accelerations", q_i=q_i, q_d=motion.q_d, q_i_dot=v, q_d_dot=v_d, q_i_ddot=a,
                           t=t)["q_d_ddot"]
    slope = ca.vertcat(v, a, kernels.loop_part(v_d)) if loops else ca.vertcat(v, a)
    rhs = ca.Function("rhs", [t, y, c], ca.cse([ca.densify(slope)]))
    names = ["q_i", "q_d", "q_i_dot", "q_d_dot", "q_i_ddot", "q_d_ddot"]
    observe = ca.Function("observe", [t, y, c], ca.cse([q_i, motion.q_d, v, v_d, a, a_d]), ["t", "y", "c"], names)
    return rhs, observe


def reference_solution(
    model: Model, *, t_end: float, times: np.ndarray | None = None, rtol: float = 1e-11, atol: float = 1e-13,
    parameters: Mapping[str, float] | None = None, initial: Mapping[str, float] | None = None,
    start: str | None = None,
) -> Solution:
    """Integrate the condensed equations from 0 to t_end with DOP853 at the given tolerances.

    times: where to report (the end only by default). Raises ModelError or InitialStateError for bad arguments.
    """
    p = model.parameter_vector(parameters)
    c = model.constants(p)
    state = start_state(model, p, c, 0.0, initial, start)
    columns = model.independent_columns
    loop = [state.q[model.coordinates.index(name)] for name in model.loop_unknowns]
    y0 = np.concatenate([state.q[columns], state.q_dot[columns], loop])
    rhs, observe = right_hand_side(model)
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

    t = np.array([t_end]) if times is None else np.asarray(times, dtype=float)
    started = time.perf_counter()
    result = solve_ivp(function, (0.0, t_end), y0, method="DOP853", t_eval=t, rtol=rtol, atol=atol)
    wall = time.perf_counter() - started
    seen = evaluate(observe, {"t": result.t[:, None], "y": result.y.T}, c)
    status = Status("completed", t_end) if result.success else Status("not_finite", float(result.t[-1]), None,
                                                                      str(result.message), "Loosen the tolerances.")
    return assemble_solution(
        model, result.t, join(model, seen["q_i"], seen["q_d"]), join(model, seen["q_i_dot"], seen["q_d_dot"]),
        join(model, seen["q_i_ddot"], seen["q_d_ddot"]), p, c, "DOP853", 0.0, [],
        {"evaluations": int(result.nfev), "wall_seconds": wall, "rtol": rtol, "atol": atol}, status)
