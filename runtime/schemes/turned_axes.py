"""Derivatives by turns: along rotations in the axes of their bodies, in a chart, and in axes that move.

With dphi = S dq_i the rotation of a body in its axes (S: rows of dq/dq_i along angular velocities; unit rows for turns
that are independent), to first order about theta = 0

    omega = theta' - theta x theta'/2,   theta'' = omega' + theta x omega'/2 - w x (theta x w)/6,   w = omega there,

and in axes that move with the body d omega = dphi' + omega x dphi: the rates of q_i change by W dq_i, where the rows of
W are those of omega~ S that belong to independent turns.
"""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca

from runtime.schemes.rotation_vectors import chart_rate
from runtime.schemes.stage_records import ClosedConfiguration
from runtime.schemes.turns_in_loops import TurningEquations


@dataclass(frozen=True)
class Turned:
    """An orientation with independent turns: axes among x, y, z, their positions in q_i, all positions, and S."""

    axes: list[int]
    positions: list[int]
    own: list[int]
    S: ca.SX


def turned_bodies(equations: TurningEquations, motion: ClosedConfiguration) -> list[Turned]:
    """The orientations of a model that have independent turns."""
    charts, n = equations.charts, equations.charts.n
    S = ca.SX.eye(n)
    if not charts.all_independent:
        v = ca.SX.sym("v", n)
        S = ca.vertcat(S, ca.jacobian(equations.rates(motion, v), v))
    found = []
    for own in charts.turns:
        axes = [axis for axis, k in enumerate(own) if k < n]
        if axes:
            found.append(Turned(axes, [own[axis] for axis in axes], own, S[own, :]))
    return found


def _all(equations: TurningEquations, motion: ClosedConfiguration, v: ca.SX) -> ca.SX:
    """q_i_dot, and q_d_dot where turns stand there."""
    return v if equations.charts.all_independent else ca.vertcat(v, equations.rates(motion, v))


def turning(equations: TurningEquations, motion: ClosedConfiguration, v: ca.SX) -> ca.SX:
    """W (n_i x n_i)."""
    W, rates = ca.SX(equations.charts.n, equations.charts.n), _all(equations, motion, v)
    for body in turned_bodies(equations, motion):
        W[body.positions, :] = ca.mtimes(ca.skew(rates[body.own]), body.S)[body.axes, :]
    return W


def turning_and_rate(
    equations: TurningEquations, motion: ClosedConfiguration, v: ca.SX, a: ca.SX
) -> tuple[ca.SX, ca.SX]:
    """(W, W') at the accelerations q_i_ddot = a."""
    v_d = equations.rates(motion, v)
    q_i, q_d, t = ca.SX.sym("q_i", motion.q_i.numel()), ca.SX.sym("q_d", motion.q_d.numel()), ca.SX.sym("t")
    at = ClosedConfiguration(q_i, q_d, t, motion.C_loop, motion.det_loop)
    W, rate = turning(equations, at, v), ca.SX(equations.charts.n, equations.charts.n)
    rates, accelerations = ca.vertcat(v, v_d), ca.vertcat(a, equations.dependent_accelerations(motion, v, a))
    old, new = ca.vertcat(q_i, q_d, t), ca.vertcat(motion.q_i, motion.q_d, motion.t)
    for body in turned_bodies(equations, at):
        S_dot = ca.jtimes(body.S, ca.vertcat(q_i, q_d), rates) + ca.jtimes(body.S, t, ca.SX(1))
        bent = ca.mtimes(ca.skew(accelerations[body.own]), body.S) + ca.mtimes(ca.skew(rates[body.own]), S_dot)
        rate[body.positions, :] = bent[body.axes, :]
    W, rate = ca.substitute([W, rate], [old], [new])
    return W, rate


def in_chart(
    equations: TurningEquations,
    motion: ClosedConfiguration,
    v: ca.SX,
    a: ca.SX,
    matrices: tuple[ca.SX, ca.SX, ca.SX],
) -> ca.SX:
    """J_q of M x'' = ... + J_q dx + J_v dx' at theta = 0, of (M_hat, J_q, J_v) along rotations."""
    M_hat, J_q, J_v = matrices
    bodies = turned_bodies(equations, motion)
    if not bodies:
        return J_q
    rates, accelerations = _all(equations, motion, v), a
    if not equations.charts.all_independent:
        accelerations = ca.vertcat(a, equations.dependent_accelerations(motion, v, a))
    changed = ca.SX(J_q)
    for body in bodies:
        w = rates[body.own]
        bend = -ca.skew(accelerations[body.own]) / 2 - (ca.dot(w, w) * ca.SX.eye(3) - ca.mtimes(w, w.T)) / 6
        change = ca.mtimes(J_v[:, body.positions], (ca.skew(w) / 2)[body.axes, :])
        change = change + ca.mtimes(M_hat[:, body.positions], bend[body.axes, :])
        changed = changed + ca.mtimes(change, body.S)
    return ca.densify(changed)


def along_rotations(equations: TurningEquations, motion: ClosedConfiguration, slope: ca.SX) -> ca.SX:
    """Derivatives by q_i (any x n_i), those by turns along rotations in the axes of their bodies."""
    bodies = turned_bodies(equations, motion)
    if not bodies:
        return slope
    theta = motion.q_i if equations.charts.all_independent else ca.vertcat(motion.q_i, motion.q_d)
    P = ca.SX.eye(equations.charts.n)
    for body in bodies:
        rates = ca.horzcat(*(chart_rate(theta[body.own], column) for column in ca.horzsplit(ca.densify(body.S))))
        P[body.positions, :] = rates[body.axes, :]
    return ca.mtimes(slope, P)
