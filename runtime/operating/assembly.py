"""Dependent coordinates from independent ones by the closure alone: a pure function, so runs in lanes share its bits.

    q_d <- closure(q_i, q_d, t)      Newton on the loop unknowns (32), at most LARGEST_STEP a time, until C is rounding
    fits: |C(q, t)| and |C_q q_dot + C_t| of all rows are rounding, with q_d_dot of (36)

Where it does not fit (redundant rows that disagree, no branch in reach), runtime/contract/consistent_state.py decides.
"""

from __future__ import annotations

import casadi as ca
import numpy as np

from runtime.contract.consistent_state import (
    LARGEST_STEP,
    MAX_ITERATIONS,
    POSITION_TOLERANCE,
    VELOCITY_TOLERANCE,
    ConsistentState,
)
from runtime.contract.coordinates import joined
from runtime.contract.model import Model

FINITE = 1e300  # less than this are all numbers that are no NaN


def closing(model: Model) -> ca.Function:
    """(q_i, q_d, t, c) -> (q_d after one more Newton step, was it open before?), built once for a model."""

    def build() -> ca.Function:
        q_i, q_d, t, c = _symbols(model, "q_i", "q_d", "t", "c")
        found = model.evaluate("closure", q_i=q_i, q_d=q_d, t=t, c=c)
        closed, open_ = ca.SX(found["q_d_next"]), ca.SX(0)
        loops = [model.q_d.index(name) for name in model.loop_unknowns]
        if loops:
            step = closed[loops] - q_d[loops]
            share = ca.fmin(1, LARGEST_STEP / ca.fmax(ca.norm_inf(step), LARGEST_STEP))
            closed[loops] = q_d[loops] + share * step
            open_ = ca.norm_inf(found["C_loop"]) > POSITION_TOLERANCE * _scale(q_d)
        names = ["q_i", "q_d", "t", "c"]
        return ca.Function("closing", [q_i, q_d, t, c], [closed, open_], names, ["q_d_next", "open"])

    return model.derived("closing", build)


def fitting(model: Model) -> ca.Function:
    """(q_i, q_i_dot, q_d, t, c) -> (q, q_dot, does it fit?), built once for a model."""

    def build() -> ca.Function:
        q_i, q_i_dot, q_d, t, c = _symbols(model, "q_i", "q_i_dot", "q_d", "t", "c")
        q_d_dot = model.evaluate("velocities", q_i=q_i, q_d=q_d, q_i_dot=q_i_dot, t=t, c=c)["q_d_dot"]
        q, q_dot = joined(model, q_i, q_d), joined(model, q_i_dot, q_d_dot)
        found = model.evaluate("constraints", q=q, q_dot=q_dot, t=t, c=c)
        C, C_dot = found["C"], ca.mtimes(found["C_q"], q_dot) + found["C_t"]
        fits = ca.logic_and(
            ca.norm_inf(C) <= POSITION_TOLERANCE * _scale(q), ca.norm_inf(C_dot) <= VELOCITY_TOLERANCE * _scale(q_dot)
        )
        # the largest of some numbers hides a NaN among them, their sum does not
        fits = ca.logic_and(fits, ca.sum1(ca.fabs(C)) + ca.sum1(ca.fabs(C_dot)) < FINITE)
        names = ["q_i", "q_i_dot", "q_d", "t", "c"]
        values = [ca.densify(value) for value in (q, q_dot, fits)]
        return ca.Function("fitting", [q_i, q_i_dot, q_d, t, c], values, names, ["q", "q_dot", "fits"])

    return model.derived("fitting", build)


def closable(model: Model) -> bool:
    """Does the model have what this needs?"""
    return bool(model.constraints) and all(model.has(name) for name in ("closure", "velocities", "constraints"))


def closed_state(
    model: Model, c: np.ndarray, t: float, q_i: np.ndarray, q_i_dot: np.ndarray, q_d: np.ndarray
) -> ConsistentState | None:
    """The state with these q_i and q_i_dot (n_i,) exactly, from a guess q_d (n_d,); None if it does not fit."""
    step, open_ = closing(model), True
    for _ in range(MAX_ITERATIONS):
        found = step(q_i, q_d, t, c)
        q_d, open_ = np.asarray(found[0]).ravel(), bool(float(found[1]) > 0)
        if not open_:
            break
    q, q_dot, fits = fitting(model)(q_i, q_i_dot, q_d, t, c)
    if open_ or not float(fits) > 0:
        return None
    return ConsistentState(np.asarray(q).ravel(), np.asarray(q_dot).ravel(), {})


def _symbols(model: Model, *names: str) -> list[ca.SX]:
    n_i, n_d = len(model.q_i), len(model.q_d)
    sizes = {"q_i": n_i, "q_i_dot": n_i, "q_d": n_d, "t": 1, "c": model.c_size}
    return [ca.SX.sym(name, sizes[name]) for name in names]


def _scale(values: ca.SX) -> ca.SX:
    return ca.fmax(1, ca.norm_inf(values))
