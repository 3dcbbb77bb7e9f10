"""The augmented form (Eq. 28) solved as it stands, by SciPy: cross-check of the condensed form.

All coordinates and all multipliers are unknowns; constraints are satisfied at acceleration level only, so positions
drift away from them.
"""

from __future__ import annotations

import time
from collections.abc import Mapping
from typing import Any

import casadi as ca
import numpy as np

from runtime import Solution, Status
from runtime.model import Model
from runtime.solutions.observe import assemble_solution
from runtime.start.start_state import start_state


def augmented_accelerations(model: Model) -> ca.Function:
    """(t, q, q_dot, c) -> q_ddot (n), lam (n_c): [M C_q^T; C_q 0][q_ddot; lam] = [Q*; gamma].

    Redundant rows are left out of the system; lam has least norm then.
    """
    n, kept = len(model.coordinates), [int(row) for row in model.kept_rows]
    rows = len(kept)
    q, q_dot, t = ca.SX.sym("q", n), ca.SX.sym("q_dot", n), ca.SX.sym("t")
    c = ca.SX.sym("c", model.kernel("constants").size1_out(0))
    result = model.evaluate("augmented", q=q, q_dot=q_dot, t=t, c=c)
    parts = [result["M"], result["Q_star"]]
    parts += [result["C_q"], result["gamma"]] if rows else [ca.SX(0, n), ca.SX(0, 1)]
    blocks = ca.Function("blocks", [t, q, q_dot, c], [ca.densify(part) for part in parts])
    arguments = [ca.MX.sym("t"), ca.MX.sym("q", n), ca.MX.sym("q_dot", n), ca.MX.sym("c", c.numel())]
    M, Q_star, all_C_q, all_gamma = blocks(*arguments)
    C_q, gamma = all_C_q[kept, :], all_gamma[kept]
    matrix = ca.vertcat(ca.horzcat(M, C_q.T), ca.horzcat(C_q, ca.MX(rows, rows)))
    solved = ca.solve(matrix, ca.vertcat(Q_star, gamma), "lapacklu")
    lam = _spread(C_q, all_C_q, solved[n:]) if model.redundant else solved[n:]
    return ca.Function("augmented", arguments, [solved[:n], lam], ["t", "q", "q_dot", "c"], ["q_ddot", "lam"])


def _spread(C_q: ca.MX, all_C_q: ca.MX, lam: ca.MX) -> ca.MX:
    """Least-norm multipliers of all rows that act like lam of the kept ones: all_C_q = E C_q, E^T lam_all = lam."""
    E = ca.solve(ca.mtimes(C_q, C_q.T), ca.mtimes(C_q, all_C_q.T), "lapacklu").T
    return ca.mtimes(E, ca.solve(ca.mtimes(E.T, E), lam, "lapacklu"))


def augmented_run(
    model: Model,
    *,
    t_end: float,
    times: np.ndarray,
    rtol: float = 1e-9,
    atol: float = 1e-11,
    parameters: Mapping[str, float] | None = None,
    initial: Mapping[str, float] | None = None,
    start: str | None = None,
) -> Solution:
    """Integrate (28) in all coordinates from 0 to t_end with DOP853, reporting at `times`.

    Raises ModelError or InitialStateError for bad arguments.
    """
    from scipy.integrate import solve_ivp  # when it is needed: importing it takes a third of a second

    p = model.parameter_vector(parameters)
    c = model.constants(p)
    state = start_state(model, p, c, 0.0, initial, start)
    n = len(model.coordinates)
    function: Any = augmented_accelerations(model)

    def slope(t: float, y: np.ndarray) -> np.ndarray:
        q_ddot, _ = function(t, y[:n], y[n:], c)
        return np.concatenate([y[n:], np.asarray(q_ddot).ravel()])

    started = time.perf_counter()
    result = solve_ivp(
        slope,
        (0.0, t_end),
        np.concatenate([state.q, state.q_dot]),
        method="DOP853",
        t_eval=np.asarray(times, dtype=float),
        rtol=rtol,
        atol=atol,
    )
    wall = time.perf_counter() - started
    accelerations = np.array([slope(t, y)[n:] for t, y in zip(result.t, result.y.T, strict=True)])
    status = (
        Status("completed", t_end)
        if result.success
        else Status(
            "not_finite",
            float(result.t[-1]),
            None,
            str(result.message),
            "Loosen the tolerances.",
        )
    )
    return assemble_solution(
        model,
        result.t,
        result.y[:n].T,
        result.y[n:].T,
        accelerations,
        p,
        c,
        "augmented DOP853",
        0.0,
        [],
        {"evaluations": int(result.nfev), "wall_seconds": wall},
        status,
    )
