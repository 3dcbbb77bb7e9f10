"""Derivatives by turns: along rotations in the axes of their bodies, in a chart, and in axes that move.

With dphi = S dq_i the rotation of a body in its axes (S: rows of dq/dq_i along angular velocities; unit rows for turns
that are independent), to first order about theta = 0

    omega = theta' - theta x theta'/2,   theta'' = omega' + theta x omega'/2 - w x (theta x w)/6,   w = omega there,

and in axes that move with the body d omega = dphi' + omega x dphi: the rates of q_i change by W dq_i, where the rows of
W are those of omega~ S that belong to independent turns.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

import casadi as ca

from runtime.schemes.charts import Charts, chart_rate
from runtime.schemes.sparse_lu import solve_general


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


# Rates of rotation vectors and angular velocities where closed loops split an orientation.
#
# Some turns of such a body are independent, the others follow: omega_d = B q_i' + b. In a chart
# theta_i' = (T^-1(theta) omega)_i takes all of omega, so that velocities follow from rates by a small linear system.


class TurningEquations(Protocol):
    """What is asked of a model's equations here."""

    charts: Charts

    def rates(self, motion: ClosedConfiguration, q_i_dot: ca.SX) -> ca.SX:
        """q_d_dot."""

    def dependent_accelerations(self, motion: ClosedConfiguration, q_i_dot: ca.SX, q_i_ddot: ca.SX) -> ca.SX:
        """q_d_ddot."""


def rates_of(equations: TurningEquations, motion: ClosedConfiguration, v: ca.SX) -> ca.SX:
    """Rates of q_i (with those of rotation vectors) of velocities (with angular velocities)."""
    charts = equations.charts
    if not charts.split:
        return charts.rates(motion.q_i, v)
    whole = ca.vertcat(motion.q_i, motion.q_d)
    return charts.rates(whole, ca.vertcat(v, equations.rates(motion, v)))[: charts.n]


def velocities_of(equations: TurningEquations, motion: ClosedConfiguration, rate: ca.SX) -> ca.SX:
    """Velocities (with angular velocities) of rates of q_i (with those of rotation vectors)."""
    found, parts = equations.charts.velocities(motion.q_i, rate), equations.charts.parts
    if not parts:
        return found
    v, known = ca.SX.sym("v", rate.numel()), ca.SX(found)
    turning = rates_of(equations, motion, v)[parts]
    for k in parts:
        known[k] = 0
    P, turned = ca.substitute([ca.jacobian(turning, v)[:, parts], turning], [v], [known])
    solved = solve_general(P, rate[parts] - turned)
    for position, k in enumerate(parts):
        found[k] = solved[position]
    return found


def second_rates_of(equations: TurningEquations, motion: ClosedConfiguration, rate: ca.SX, v: ca.SX, a: ca.SX) -> ca.SX:
    """Second rates of q_i of its rates, its velocities v and accelerations a."""
    charts = equations.charts
    if not charts.split:
        return charts.accelerations(motion.q_i, rate, v, a)
    whole, w = ca.vertcat(motion.q_i, motion.q_d), ca.vertcat(v, equations.rates(motion, v))
    b = ca.vertcat(a, equations.dependent_accelerations(motion, v, a))
    return charts.accelerations(whole, charts.rates(whole, w), w, b)[: charts.n]


def second_rates_from(
    equations: TurningEquations, end: ClosedConfiguration, motion: ClosedConfiguration, v: ca.SX, a: ca.SX
) -> ca.SX:
    """Second rates of q_i of velocities and accelerations of a motion, in the charts at an end of it."""
    charts = equations.charts
    if not charts.split:
        return charts.accelerations_from(end.q_i, motion.q_i, v, a)
    there, w = ca.vertcat(motion.q_i, motion.q_d), ca.vertcat(v, equations.rates(motion, v))
    b = ca.vertcat(a, equations.dependent_accelerations(motion, v, a))
    return charts.accelerations_from(ca.vertcat(end.q_i, end.q_d), there, w, b)[: charts.n]


# What the equations of a stage give: closed configurations, linear systems.


@dataclass(frozen=True)
class ClosedConfiguration:
    """A configuration with consistent q_d; C_loop is the largest error before the last Newton step, det_loop the
    determinants of the loop blocks there.
    """

    q_i: ca.SX
    q_d: ca.SX
    t: ca.SX
    C_loop: ca.SX
    det_loop: ca.SX


@dataclass(frozen=True)
class LinearisedEquations:
    """M_hat dv' = Q_hat - M_hat a + J_q dq + J_v dv about a state with q_i_ddot = a; J_q is d(Q_hat - M_hat a)/dq_i.

    Turns are at theta = 0 of their charts, and dq, dv of them rotation vectors there and their rates.
    """

    M_hat: ca.SX
    Q_hat: ca.SX
    a: ca.SX
    J_q: ca.SX
    J_v: ca.SX
