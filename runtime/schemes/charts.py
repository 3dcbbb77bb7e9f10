"""Orientations in time steps: rotation vectors theta from charts, one chart a step.

    e = chart o exp(theta),    omega = T(theta) theta',    theta' = T^-1(theta) omega

The turn that a step made is put into the chart at its end: chart <- chart o exp(theta), theta <- 0. A turn d of the
last step is d in the new chart too, and its beginning is at -d there, component by component: so it is all the same
whether a component is independent or follows from a closed loop.

In the words of Lie group integrators (Munthe-Kaas): theta are coordinates in the tangent space of the manifold of
rotations SO(3) at the chart, and exp is the retraction that brings a step back to it.

References
----------
E. Hairer, C. Lubich, G. Wanner: Geometric Numerical Integration, 2nd ed., Springer 2006, section IV.8.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from math import factorial

import casadi as ca

from runtime.contract.model import EmittedModel


class Charts:
    """The orientations of a model in vectors of q_i, or of q_i and q_d; all does nothing where there are none.

    turns: positions of each in q_i followed by q_d. What converts rates works on the orientations that stand in the
    vectors as a whole: in those of q_i on the ones that are independent.
    """

    def __init__(self, model: EmittedModel) -> None:
        at = model.places
        self.turns = [[int(k) for k in turns] for turns in at.turns]
        self.n, self.size = at.n_i, 4 * len(self.turns)
        self.split, self.all_independent = at.split, at.all_independent
        loop = {int(k) + self.n: position for position, k in enumerate(at.loops)}
        self._loops = [{axis: loop[k] for axis, k in enumerate(own) if k >= self.n} for own in self.turns]

    def within(self, positions: Sequence[int]) -> list[int]:
        """Positions in q_i of the turns among some."""
        return [k for turns in self.turns for k in turns if k < self.n and k in positions]

    @property
    def independent(self) -> list[int]:
        """Positions in q_i of all turns."""
        return [k for turns in self.turns for k in turns if k < self.n]

    @property
    def loop_turns(self) -> list[list[int]]:
        """Positions among the loop unknowns of the turns of each orientation."""
        return [list(own.values()) for own in self._loops]

    @property
    def parts(self) -> list[int]:
        """Positions in q_i of the turns of orientations that are split."""
        apart = [own for own in self.turns if min(own) < self.n <= max(own)]
        return [k for own in apart for k in own if k < self.n]

    def _each(self, value: ca.SX, of: Mapping[int, ca.SX]) -> ca.SX:
        changed = ca.SX(value)
        for number, own in of.items():
            for position, k in enumerate(self.turns[number]):
                changed[k] = own[position]
        return changed

    def _in(self, vector: ca.SX) -> list[tuple[int, list[int]]]:
        return [(n, own) for n, own in enumerate(self.turns) if max(own) < vector.numel()]

    def velocities(self, x: ca.SX, rate: ca.SX) -> ca.SX:
        """Velocities (with omega) of the rates of x."""
        return self._each(rate, {n: angular_velocity(x[own], rate[own]) for n, own in self._in(x)})

    def rates(self, x: ca.SX, v: ca.SX) -> ca.SX:
        """Rates of x of velocities (with omega)."""
        return self._each(v, {n: chart_rate(x[own], v[own]) for n, own in self._in(x)})

    def accelerations(self, x: ca.SX, rate: ca.SX, v: ca.SX, a: ca.SX) -> ca.SX:
        """Second rates of x of accelerations (with omega')."""
        return self._each(a, {n: chart_acceleration(x[k], rate[k], v[k], a[k]) for n, k in self._in(x)})

    def accelerations_from(self, end: ca.SX, x: ca.SX, v: ca.SX, a: ca.SX) -> ca.SX:
        """Second rates of x of velocities and accelerations (with omega and omega') there, in the charts at an end."""
        moved = self._each(x, {n: turn_since(end[own], x[own]) for n, own in self._in(x)})
        return self.accelerations(moved, self.rates(moved, v), v, a)

    def in_charts(self, model: EmittedModel, q: ca.SX, rate: ca.SX | None = None) -> tuple[ca.SX, ca.SX]:
        """(q_i, q_d) of all coordinates q, every chart where its body is; or of their rates or accelerations at q."""
        at, source = model.places, q if rate is None else rate
        found = ca.SX.zeros(self.n + len(model.q_d))
        for k, column in zip([*at.plain, *(self.n + at.dependent_plain)], [*at.columns, *at.dependent], strict=True):
            found[int(k)] = source[int(column)]
        for own, e in zip(self.turns, at.parameters, strict=True):
            if rate is not None:  # 2 conj(e) o e', and of e'' too: conj(e') o e' is a scalar
                e_0, e_v, r = q[int(e[0])], q[e[1:].tolist()], rate[e.tolist()]
                omega = 2 * (e_0 * r[1:] - r[0] * e_v - ca.cross(e_v, r[1:]))
                for position, k in enumerate(own):
                    found[k] = omega[position]
        return found[: self.n], found[self.n :]

    def zeroed(self, x: ca.SX, members: Collection[int] | None = None) -> ca.SX:
        """q_i with its turns (among the members) at zero."""
        changed = ca.SX(x)
        for own in self.turns:
            for k in own:
                if k < self.n and (members is None or k in members):
                    changed[k] = 0
        return changed

    def zeroed_dependent(self, q_d: ca.SX) -> ca.SX:
        """q_d with its turns at zero."""
        changed = ca.SX(q_d)
        for own in self.turns:
            for k in own:
                if k >= self.n:
                    changed[k - self.n] = 0
        return changed

    def zeroed_loops(self, loop: ca.SX) -> ca.SX:
        """The loop unknowns with their turns at zero."""
        changed = ca.SX(loop)
        for positions in self._loops:
            for position in positions.values():
                changed[position] = 0
        return changed

    @staticmethod
    def unit(e: ca.SX) -> ca.SX:
        """Quaternions one after another, made of unit length."""
        parts = [e[k : k + 4] for k in range(0, e.numel(), 4)]
        return ca.vertcat(*(part / ca.sqrt(ca.dot(part, part)) for part in parts)) if parts else e

    def parameter_rates(self, e: ca.SX, v: ca.SX, v_d: ca.SX) -> ca.SX:
        """e' = e o (0, omega) / 2 of quaternions one after another."""
        parts, velocities = [], ca.vertcat(v, v_d)
        for k, own in enumerate(self.turns):
            e_0, e_v, w = e[4 * k], e[4 * k + 1 : 4 * k + 4], velocities[own]
            parts += [-ca.dot(e_v, w) / 2, (e_0 * w + ca.cross(e_v, w)) / 2]
        return ca.vertcat(*parts) if parts else e

    def moves(self, number: int, members: Collection[int] | None) -> bool:
        """Does an orientation go into its chart when these members of q_i have moved? One of loops alone always."""
        own = [k for k in self.turns[number] if k < self.n]
        return members is None or not own or own[0] in members

    def turned(self, chart: ca.SX, x: ca.SX, q_d: ca.SX, members: Collection[int] | None = None) -> ca.SX:
        """The charts after the turns in x and q_d (of those that move with the members)."""
        whole, parts = x if self.all_independent else ca.vertcat(x, q_d), []
        for n, own in enumerate(self.turns):
            old = chart[4 * n : 4 * n + 4]
            parts.append(turned_chart(old, whole[own]) if self.moves(n, members) else old)
        return ca.vertcat(*parts) if parts else ca.SX(0, 1)

    def loops_from(self, loop: ca.SX, q_d: ca.SX, members: Collection[int] | None = None) -> ca.SX:
        """Loop unknowns from the charts that the turns in q_d led to (of those that move with the members)."""
        changed = ca.SX(loop)
        for n, own in enumerate(self.turns):
            for axis, position in self._loops[n].items():
                if self.moves(n, members):
                    changed[position] = loop[position] - q_d[own[axis] - self.n]
        return changed


# Rotation vectors theta of orientations, and the rates and accelerations that go with angular velocities.
#
#     e = chart o exp(theta),    omega = T(theta) theta',    theta' = T^-1(theta) omega,
#
#     T    = 1 - (1/2 - s/24 + ...) theta~ + (1/6 - s/120 + ...) theta~^2,         s = theta.theta
#     T^-1 = 1 + theta~/2 + g(s) theta~^2,  g = 1/12 + s/720 + s^2/30240 + ...
#
# At theta = 0 both are 1, and theta'' = omega'. The turn that a step made is put into the chart at its end: chart <-
# chart o exp(theta), theta <- 0. A turn d of the last step is d in the new chart too, and its beginning is at -d there.
# What lies between has other components there: exp(theta_new) = exp(-d) o exp(theta).

SERIES_TERMS = 9  # of the series of T: rounding up to theta = 2 rad
G = (1 / 12, 1 / 720, 1 / 30240, 1 / 1209600, 1 / 47900160, 691 / 1307674368000, 1 / 74724249600)
LEAST_SQUARED_ANGLE = 1e-300  # of a squared angle: keeps its root from zero, where it has no derivative


def _series(coefficients: Sequence[float], s: ca.SX) -> ca.SX:
    result = ca.SX(coefficients[-1])
    for value in reversed(coefficients[:-1]):
        result = value + s * result
    return result


FIRST_TERMS = tuple((-1) ** k / factorial(2 * k + 2) for k in range(SERIES_TERMS))
SECOND = tuple((-1) ** k / factorial(2 * k + 3) for k in range(SERIES_TERMS))


def angular_velocity(theta: ca.SX, rate: ca.SX) -> ca.SX:
    """omega = T(theta) theta', 3."""
    s, across = ca.dot(theta, theta), ca.cross(theta, rate)
    return rate - _series(FIRST_TERMS, s) * across + _series(SECOND, s) * ca.cross(theta, across)


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
    half = ca.sqrt(ca.dot(between[1:], between[1:]) + LEAST_SQUARED_ANGLE)
    return 2 * ca.atan2(half, between[0]) / half * between[1:]


def _exponential(theta: ca.SX) -> ca.SX:
    """The unit quaternion of a rotation vector."""
    half = ca.sqrt(ca.dot(theta, theta) / 4 + LEAST_SQUARED_ANGLE)
    return ca.vertcat(ca.cos(half), ca.sin(half) / half / 2 * theta)


def _product(a: ca.SX, b: ca.SX) -> ca.SX:
    """a o b of quaternions, scalar first."""
    return ca.vertcat(a[0] * b[0] - ca.dot(a[1:], b[1:]), a[0] * b[1:] + b[0] * a[1:] + ca.cross(a[1:], b[1:]))
