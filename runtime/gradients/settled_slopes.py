"""How a quasi-static start moves with parameters and rigid coordinates: the equilibrium of the elastic ones.

R(t, q_i, q_i_dot, c) = 0 for the elastic coordinates, so  R_e dq_e = -(R_r dq_r + R_v dv + R_p dp);  their rates are
differences of two such equilibria, as runtime.start.quasi_static takes them, and are differentiated as such.
"""

from __future__ import annotations

import casadi as ca
import numpy as np

from runtime.contract.consistent_state import ConsistentState
from runtime.contract.coordinates import independent, joined, loop_part
from runtime.contract.model import EmittedModel
from runtime.schemes.stage_equations import StageEquations
from runtime.start.quasi_static import (
    SETTLING_PASSES,
    STATIC_CLOSURE_ITERATIONS,
    ElasticEquilibrium,
    elastic_residual,
    small_motion,
    smooth_sides,
)


def settled_slopes(
    model: EmittedModel,
    p: np.ndarray,
    c: np.ndarray,
    t: float,
    given: ConsistentState,
    slopes: np.ndarray,
    unstable: bool,
) -> np.ndarray:
    """d(p, q_i, q_i_dot, loop unknowns) (n_x, n) of the quasi-static start, from those of the state that was given."""
    elastic = [k for k, name in enumerate(model.q_i) if name in model.elastic]
    rigid = [k for k in range(len(model.q_i)) if k not in elastic]
    solver = ElasticEquilibrium(model, elastic, c, unstable)
    n_p, n = len(p), len(model.q_i)
    found = slopes.copy()
    dp, dq, dv = found[:n_p], found[n_p : n_p + n], found[n_p + n : n_p + 2 * n]
    (q, v), loop = independent(model, given.q, given.q_dot), loop_part(model, given.q)
    step, coordinate = small_motion(model, given.q_dot)
    rates = model.derived("rate_slopes", lambda: _rate_slopes(model))(t, q, v, loop, p)
    moving = np.asarray(rates)[coordinate] @ np.concatenate([dq, dv, dp])  # of the speed that sets the step
    dstep = -step * moving / given.q_dot[coordinate] if step else np.zeros(found.shape[1])
    function = model.derived("equilibrium_slopes", lambda: _equilibrium_slopes(model, elastic))

    def settled(at: float, place: np.ndarray, dplace: np.ndarray, dt: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """(q_i, dq_i) with the elastic ones in equilibrium."""
        reached = solver.solve(at, place, v, loop)
        R_q, R_v, R_p, R_t = (np.asarray(value) for value in function(at, reached, v, loop, p))
        moved = dplace.copy()
        side = R_q[:, rigid] @ dplace[rigid] + R_v @ dv + R_p @ dp + np.outer(R_t, dt)
        moved[elastic] = -np.linalg.solve(R_q[:, elastic], side)
        return reached, moved

    still = np.zeros(found.shape[1])
    later, before = (float(side) for side in smooth_sides(model)(t, step, c))
    span = (later + before) * step
    for _ in range(SETTLING_PASSES):
        q, dq[:] = settled(t, q, dq, still)
        if not span:
            continue
        ends = []
        for sign in (later, -before):
            place, dplace = q.copy(), dq.copy()
            place[rigid] += sign * step * v[rigid]
            dplace[rigid] += sign * (step * dv[rigid] + np.outer(v[rigid], dstep))
            ends.append(settled(t + sign * step, place, dplace, sign * dstep))
        v[elastic] = (ends[0][0] - ends[1][0])[elastic] / span
        dv[elastic] = (ends[0][1] - ends[1][1])[elastic] / span - np.outer(v[elastic], dstep / step)
    return found


def _equilibrium_slopes(model: EmittedModel, elastic: list[int]) -> ca.Function:
    """(t, q_i, q_i_dot, loop unknowns, p) -> the slopes of R by q_i, q_i_dot, p and t."""
    n = len(model.q_i)
    t, q, v = ca.SX.sym("t"), ca.SX.sym("q", n), ca.SX.sym("v", n)
    loop, p = ca.SX.sym("loop", len(model.loop_unknowns)), ca.SX.sym("p", len(model.parameters))
    R = elastic_residual(model)(t, q, v, loop, model.kernel("constants")(p))[0]
    outputs = [ca.densify(ca.jacobian(R, by)) for by in (q, v, p, t)]
    return ca.Function("equilibrium_slopes", [t, q, v, loop, p], outputs)


def _rate_slopes(model: EmittedModel) -> ca.Function:
    """(t, q_i, q_i_dot, loop unknowns, p) -> the slopes of all rates by (q_i, q_i_dot, p)."""
    n = len(model.q_i)
    t, q, v = ca.SX.sym("t"), ca.SX.sym("q", n), ca.SX.sym("v", n)
    loop, p = ca.SX.sym("loop", len(model.loop_unknowns)), ca.SX.sym("p", len(model.parameters))
    equations = StageEquations(model, model.kernel("constants")(p))
    rates = equations.rates(equations.close(q, loop, t, STATIC_CLOSURE_ITERATIONS), v)
    slopes = ca.jacobian(joined(model, v, rates), ca.vertcat(q, v, p))
    return ca.Function("rate_slopes", [t, q, v, loop, p], [ca.densify(slopes)])
