"""Orientations in time steps: rotation vectors theta from charts, one chart a step.

    e = chart o exp(theta),    omega = T(theta) theta',    theta' = T^-1(theta) omega,

    T    = 1 - (1/2 - s/24 + ...) theta~ + (1/6 - s/120 + ...) theta~^2,         s = theta.theta
    T^-1 = 1 + theta~/2 + g(s) theta~^2,  g = 1/12 + s/720 + s^2/30240 + ...

At theta = 0 both are 1, and theta'' = omega'. The turn that a step made is put into the chart at its end: chart <-
chart o exp(theta), theta <- 0. A turn d of the last step is d in the new chart too, and its beginning is at -d there.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import factorial

import casadi as ca

from runtime.contract.model import Model

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
    half = ca.sqrt(ca.dot(theta, theta) / 4 + SMALLEST)
    w, v = ca.cos(half), ca.sin(half) / half / 2 * theta
    turned = ca.vertcat(chart[0] * w - ca.dot(chart[1:], v), chart[0] * v + w * chart[1:] + ca.cross(chart[1:], v))
    return turned * (1.5 - ca.dot(turned, turned) / 2)  # a Newton step to unit length, near which it is


def along_rotations(model: Model, q_i: ca.SX, slope: ca.SX) -> ca.SX:
    """Derivatives by q_i (any x n_i), those by turns along rotations in the axes of their bodies."""
    changed = ca.SX(slope)
    for turns in model.places.turns:
        own = [int(k) for k in turns]
        unit = ca.SX.eye(3)
        columns = ca.mtimes(slope[:, own], ca.horzcat(*(chart_rate(q_i[own], unit[:, k]) for k in range(3))))
        for position, k in enumerate(own):
            changed[:, k] = columns[:, position]
    return changed


class Charts:
    """The orientations of a model in vectors of q_i; all does nothing where there are none."""

    def __init__(self, model: Model) -> None:
        self.turns = [[int(k) for k in turns] for turns in model.places.turns]
        self.size = 4 * len(self.turns)

    def within(self, positions: Sequence[int]) -> list[int]:
        """Positions in q_i of the turns among some."""
        return [k for turns in self.turns for k in turns if k in positions]

    def _each(self, value: ca.SX, of: Mapping[int, ca.SX]) -> ca.SX:
        changed = ca.SX(value)
        for number, own in of.items():
            for position, k in enumerate(self.turns[number]):
                changed[k] = own[position]
        return changed

    def velocities(self, x: ca.SX, rate: ca.SX) -> ca.SX:
        """q_i_dot (with omega) of the rates of x."""
        return self._each(rate, {n: angular_velocity(x[own], rate[own]) for n, own in enumerate(self.turns)})

    def rates(self, x: ca.SX, v: ca.SX) -> ca.SX:
        """Rates of x of q_i_dot (with omega)."""
        return self._each(v, {n: chart_rate(x[own], v[own]) for n, own in enumerate(self.turns)})

    def accelerations(self, x: ca.SX, rate: ca.SX, v: ca.SX, a: ca.SX) -> ca.SX:
        """Second rates of x of q_i_ddot (with omega')."""
        found = {n: chart_acceleration(x[k], rate[k], v[k], a[k]) for n, k in enumerate(self.turns)}
        return self._each(a, found)

    def seen_in(self, model: Model, q: ca.SX, rate: ca.SX | None = None) -> ca.SX:
        """q_i of all coordinates q, every chart where its body is; or of their rates or accelerations at q."""
        at, source = model.places, q if rate is None else rate
        found = ca.SX.zeros(len(model.q_i))
        for k, column in zip(at.plain, at.columns, strict=True):
            found[int(k)] = source[int(column)]
        for own, e in zip(self.turns, at.parameters, strict=True):
            if rate is not None:  # 2 conj(e) o e', and of e'' too: conj(e') o e' is a scalar
                e_0, e_v, r = q[int(e[0])], q[e[1:].tolist()], rate[e.tolist()]
                omega = 2 * (e_0 * r[1:] - r[0] * e_v - ca.cross(e_v, r[1:]))
                for position, k in enumerate(own):
                    found[k] = omega[position]
        return found

    def zeroed(self, x: ca.SX, members: Sequence[int] | None = None) -> ca.SX:
        """x with its turns (among the members) at zero."""
        chosen = range(x.numel()) if members is None else members
        changed = ca.SX(x)
        for k in self.within(chosen):
            changed[k] = 0
        return changed

    @staticmethod
    def unit(e: ca.SX) -> ca.SX:
        """Quaternions one after another, made of unit length."""
        parts = [e[k : k + 4] for k in range(0, e.numel(), 4)]
        return ca.vertcat(*(part / ca.sqrt(ca.dot(part, part)) for part in parts)) if parts else e

    def parameter_rates(self, e: ca.SX, v: ca.SX) -> ca.SX:
        """e' = e o (0, omega) / 2 of quaternions one after another."""
        parts = []
        for k, own in enumerate(self.turns):
            e_0, e_v, w = e[4 * k], e[4 * k + 1 : 4 * k + 4], v[own]
            parts += [-ca.dot(e_v, w) / 2, (e_0 * w + ca.cross(e_v, w)) / 2]
        return ca.vertcat(*parts) if parts else e

    def turned(self, chart: ca.SX, x: ca.SX, members: Sequence[int] | None = None) -> ca.SX:
        """The charts after the turns x (of the members)."""
        chosen = range(x.numel()) if members is None else members
        parts = [
            turned_chart(chart[4 * n : 4 * n + 4], x[own]) if own[0] in chosen else chart[4 * n : 4 * n + 4]
            for n, own in enumerate(self.turns)
        ]
        return ca.vertcat(*parts) if parts else ca.SX(0, 1)

    def tangents(self, J_q: ca.SX, J_v: ca.SX, M_hat: ca.SX, v: ca.SX, a: ca.SX) -> ca.SX:
        """J_q of M x'' = ... + J_q dx + J_v dx' at theta = 0 of that by local rotations and angular velocities.

        To first order omega = theta' - theta x theta' / 2 and, with w = omega there,
        theta'' = omega' + theta x omega' / 2 - w x (theta x w) / 6.
        """
        changed = ca.SX(J_q)
        for own in self.turns:
            w = v[own]
            bend = -ca.skew(a[own]) / 2 - (ca.dot(w, w) * ca.SX.eye(3) - ca.mtimes(w, w.T)) / 6
            change = ca.mtimes(J_v[:, own], ca.skew(w) / 2) + ca.mtimes(M_hat[:, own], bend)
            for position, k in enumerate(own):
                changed[:, k] = changed[:, k] + change[:, position]
        return changed
