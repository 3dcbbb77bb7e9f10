"""Rotation vectors theta of orientations, and the rates and accelerations that go with angular velocities.

    e = chart o exp(theta),    omega = T(theta) theta',    theta' = T^-1(theta) omega,

    T    = 1 - (1/2 - s/24 + ...) theta~ + (1/6 - s/120 + ...) theta~^2,         s = theta.theta
    T^-1 = 1 + theta~/2 + g(s) theta~^2,  g = 1/12 + s/720 + s^2/30240 + ...

At theta = 0 both are 1, and theta'' = omega'. The turn that a step made is put into the chart at its end: chart <-
chart o exp(theta), theta <- 0. A turn d of the last step is d in the new chart too, and its beginning is at -d there.
What lies between has other components there: exp(theta_new) = exp(-d) o exp(theta).
"""

from __future__ import annotations

from collections.abc import Sequence
from math import factorial

import casadi as ca

TERMS = 9  # of the series of T: rounding up to theta = 2 rad
G = (1 / 12, 1 / 720, 1 / 30240, 1 / 1209600, 1 / 47900160, 691 / 1307674368000, 1 / 74724249600)
SMALLEST = 1e-300  # of a squared angle: keeps its root from zero, where it has no derivative


def _series(coefficients: Sequence[float], s: ca.SX) -> ca.SX:
    result = ca.SX(coefficients[-1])
    for value in reversed(coefficients[:-1]):
        result = value + s * result
    return result


FIRST = tuple((-1) ** k / factorial(2 * k + 2) for k in range(TERMS))
SECOND = tuple((-1) ** k / factorial(2 * k + 3) for k in range(TERMS))


def angular_velocity(theta: ca.SX, rate: ca.SX) -> ca.SX:
    """omega = T(theta) theta', 3."""
    s, across = ca.dot(theta, theta), ca.cross(theta, rate)
    return rate - _series(FIRST, s) * across + _series(SECOND, s) * ca.cross(theta, across)


def chart_rate(theta: ca.SX, omega: ca.SX) -> ca.SX:
    """theta' = T^-1(theta) omega, 3."""
    s, across = ca.dot(theta, theta), ca.cross(theta, omega)
    return omega + across / 2 + _series(G, s) * ca.cross(theta, across)


def chart_acceleration(theta: ca.SX, rate: ca.SX, omega: ca.SX, omega_dot: ca.SX) -> ca.SX:
    """theta'' of theta', omega and omega', 3."""
    s, across = ca.dot(theta, theta), ca.cross(theta, omega)
    slope = _series([k * value for k, value in enumerate(G)][1:], s) * 2 * ca.dot(theta, rate)
    mixed = ca.cross(rate, across) + ca.cross(theta, ca.cross(rate, omega))
    turned = ca.cross(rate, omega) / 2 + _series(G, s) * mixed + slope * ca.cross(theta, across)
    return chart_rate(theta, omega_dot) + turned


def turned_chart(chart: ca.SX, theta: ca.SX) -> ca.SX:
    """chart o exp(theta), 4, made of unit length."""
    turned = _product(chart, _exponential(theta))
    return turned * (1.5 - ca.dot(turned, turned) / 2)  # a Newton step to unit length, near which it is


def turn_since(end: ca.SX, there: ca.SX) -> ca.SX:
    """theta with exp(end) o exp(theta) = exp(there), 3, below pi: a place of one chart in the chart at its end."""
    between = _product(_exponential(-end), _exponential(there))
    half = ca.sqrt(ca.dot(between[1:], between[1:]) + SMALLEST)
    return 2 * ca.atan2(half, between[0]) / half * between[1:]


def _exponential(theta: ca.SX) -> ca.SX:
    """The unit quaternion of a rotation vector."""
    half = ca.sqrt(ca.dot(theta, theta) / 4 + SMALLEST)
    return ca.vertcat(ca.cos(half), ca.sin(half) / half / 2 * theta)


def _product(a: ca.SX, b: ca.SX) -> ca.SX:
    """a o b of quaternions, scalar first."""
    return ca.vertcat(a[0] * b[0] - ca.dot(a[1:], b[1:]), a[0] * b[1:] + b[0] * a[1:] + ca.cross(a[1:], b[1:]))
