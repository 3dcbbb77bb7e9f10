"""Quasi-static starts by pure functions, so that runs in lanes share the bits of a run by itself.

Newton's method on r(q_e) = 0, as long as it stays in one valley of the potential: the symmetric part of -dr/dq_e is
positive definite at every step, no step is long, and each takes at most a quarter of the work r^T d of the one before
until only rounding is left. There the method of runtime/operating/newton.py makes the same steps, and the equilibrium
is one that small vibrations do not leave. Where it does not stay, that method decides.
"""

from __future__ import annotations

import casadi as ca
import numpy as np

from runtime.contract.coordinates import joined, whole
from runtime.contract.model import Model
from runtime.operating.newton import LARGEST_STEP, LEAST_SCALE, NO_STIFFNESS, STAGNANT, TOLERANCE
from runtime.schemes.scheme import LARGEST
from runtime.schemes.sparse_lu import Number, factor, solve
from runtime.start.elastic_residual import elastic_residual, positions

PASSES = 3  # equilibrium and rates depend on each other weakly
SMALL_MOTION = 1e-4  # rad or m that rigid coordinates move between the two equilibria whose difference is the rate
MAX_STEPS = 30
MOST_ELASTIC = 20  # coordinates, above which the slope is not factorised in straight-line code
CONTRACTION = 0.25


def settles(model: Model) -> bool:
    """Is this for the model?"""
    return 0 < len(positions(model)) <= MOST_ELASTIC and model.has("condensed")


def settling(model: Model) -> ca.Function:
    """One step of q_e: (t, q_i, q_i_dot, loop, c, work before) -> (q_i, is it open?, is it in its valley?, work).

    The work before the first step is LARGEST. Built once for a model.
    """

    def build() -> ca.Function:
        n, elastic = len(model.q_i), positions(model)
        t, q, v, before = ca.SX.sym("t"), ca.SX.sym("q", n), ca.SX.sym("v", n), ca.SX.sym("before")
        loop, c = ca.SX.sym("loop", len(model.loop_unknowns)), ca.SX.sym("c", model.c_size)
        r, slope = elastic_residual(model)(t, q, v, loop, c)[:2]
        K = -slope
        step = solve(factor(Number(K)), Number(ca.densify(r))).re
        size, scale, work = ca.norm_inf(step), ca.fmax(LEAST_SCALE, ca.norm_inf(q[elastic])), ca.dot(r, step)
        less = work <= CONTRACTION * before
        open_ = ca.logic_and(size > TOLERANCE * scale, ca.logic_or(less, size > STAGNANT * scale))
        usual = ca.logic_and(size <= LARGEST_STEP, ca.logic_or(less, size <= STAGNANT * scale))
        valley = ca.logic_and(usual, ca.logic_and(_is_positive(0.5 * (K + K.T)), ca.sum1(ca.fabs(step)) < LARGEST))
        q_next = ca.SX(q)
        q_next[elastic] = q[elastic] + step
        values = [ca.densify(value) for value in (q_next, open_, valley, work)]
        return ca.Function("settling", [t, q, v, loop, c, before], values)

    return model.derived("settling", build)


def _is_positive(S: ca.SX) -> ca.SX:
    """Is a symmetric matrix positive definite, by more than rounding?"""
    reciprocals = ca.diag(factor(Number(S), symmetric=True).re)
    most = 1 / (NO_STIFFNESS * ca.norm_inf(ca.diag(S)))
    found = ca.SX(1)
    for k in range(S.size1()):
        found = ca.logic_and(found, ca.logic_and(reciprocals[k] > 0, reciprocals[k] < most))
    return found


def leading(model: Model) -> ca.Function:
    """(q_i, q_i_dot, q_d, t, c) -> time [s] in which the fastest coordinate but the elastic ones moves by SMALL_MOTION.

    0 at rest. Built once for a model.
    """

    def build() -> ca.Function:
        n_i, n_d = len(model.q_i), len(model.q_d)
        q_i, v, q_d, t = ca.SX.sym("q_i", n_i), ca.SX.sym("v", n_i), ca.SX.sym("q_d", n_d), ca.SX.sym("t")
        c = ca.SX.sym("c", model.c_size)
        q_d_dot = ca.SX(0, 1)
        if n_d:
            q_d_dot = model.evaluate("velocities", q_i=q_i, q_d=q_d, q_i_dot=v, t=t, c=c)["q_d_dot"]
        q_dot = joined(model, v, q_d_dot)
        fastest = ca.norm_inf(
            ca.vertcat(*(q_dot[k] for k, name in enumerate(model.coordinates) if name not in model.elastic))
        )
        return ca.Function("leading", [q_i, v, q_d, t, c], [ca.if_else(fastest > 0, SMALL_MOTION / fastest, 0)])

    return model.derived("leading", build)


def settled(
    model: Model, c: np.ndarray, t: float, q_i: np.ndarray, v: np.ndarray, q_d: np.ndarray
) -> tuple[np.ndarray, np.ndarray] | None:
    """(q, q_dot) with the elastic coordinates in equilibrium; None where they leave their valley.

    q_i, v (n_i,) and q_d (n_d,): a state that fits. The steps are those of runtime/studies/ensemble/settle.py.
    """
    if not settles(model):
        return None
    elastic, q_i, v = positions(model), q_i.copy(), v.copy()
    rigid = [k for k in range(len(q_i)) if k not in elastic]
    loop = q_d[[model.q_d.index(name) for name in model.loop_unknowns]]
    lead = float(leading(model)(q_i, v, q_d, t, c))

    def solved(t: float, start: np.ndarray) -> np.ndarray | None:
        q, before = start, LARGEST
        for _ in range(MAX_STEPS):
            q, open_, valley, before = settling(model)(t, q, v, loop, c, before)
            if not float(valley) > 0:
                return None
            if not float(open_) > 0:
                return np.asarray(q).ravel()
        return None

    for _ in range(PASSES):
        found = solved(t, q_i)
        if found is None:
            return None
        q_i = found
        if lead > 0:
            ends = []
            for at in (lead, -lead):
                moved = q_i.copy()
                moved[rigid] = moved[rigid] + at * v[rigid]
                end = solved(t + at, moved)
                if end is None:
                    return None
                ends.append(end[elastic])
            v[elastic] = (ends[0] - ends[1]) / (2 * lead)
    q_d, q_d_dot = elastic_residual(model)(t, q_i, v, loop, c)[3:]
    return whole(model, q_i, np.asarray(q_d).ravel()), whole(model, v, np.asarray(q_d_dot).ravel())
