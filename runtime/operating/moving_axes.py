"""Small turns in axes that move with their bodies: d omega = dphi' + omega x dphi, so q_i' changes by W dq_i."""

from __future__ import annotations

import casadi as ca
import numpy as np

from runtime.contract.model import Model
from runtime.contract.orientations import tilde
from runtime.schemes.stage_equations import StageEquations
from runtime.schemes.turned_axes import turning_and_rate

CLOSURE_ITERATIONS = 3


def axes_turning(
    model: Model, c: np.ndarray, t: float, q_i: np.ndarray, v: np.ndarray, a: np.ndarray, loop: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """(W, W') (n_i x n_i) at a state, where q_i_ddot = a."""
    if not model.places.all_independent:
        W, rate = model.derived("axes_turning", lambda: _built(model))(t, q_i, v, a, loop, c)
        return np.asarray(W), np.asarray(rate)
    found = np.zeros((2, len(q_i), len(q_i)))
    for own in model.places.turns:
        found[0][np.ix_(own, own)], found[1][np.ix_(own, own)] = tilde(v[own]), tilde(a[own])
    return found[0], found[1]


def in_moving_axes(
    turning: tuple[np.ndarray, np.ndarray], M: np.ndarray, J_q: np.ndarray, J_v: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """J_q and J_v (n_i x n_i) in such axes, of M a'' = J_q da + J_v dv; turning: W and W'."""
    W, rate = turning
    return J_q + J_v @ W - M @ rate, J_v - M @ W


def _built(model: Model) -> ca.Function:
    """(t, q_i, q_i_dot, q_i_ddot, loop unknowns, c) -> W, W'."""
    n = len(model.q_i)
    t, q, v, a = ca.SX.sym("t"), ca.SX.sym("q", n), ca.SX.sym("v", n), ca.SX.sym("a", n)
    loop, c = ca.SX.sym("loop", len(model.loop_unknowns)), ca.SX.sym("c", model.c_size)
    equations = StageEquations(model, c)
    found = turning_and_rate(equations, equations.close(q, loop, t, CLOSURE_ITERATIONS), v, a)
    return ca.Function("axes_turning", [t, q, v, a, loop, c], [ca.densify(one) for one in found])
