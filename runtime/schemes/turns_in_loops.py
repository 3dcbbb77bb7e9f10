"""Rates of rotation vectors and angular velocities where closed loops split an orientation.

Some turns of such a body are independent, the others follow: omega_d = B q_i' + b. In a chart
theta_i' = (T^-1(theta) omega)_i takes all of omega, so that velocities follow from rates by a small linear system.
"""

from __future__ import annotations

from typing import Protocol

import casadi as ca

from runtime.schemes.charts import Charts
from runtime.schemes.linear_solve import solve_general
from runtime.schemes.stage_records import ClosedConfiguration


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
