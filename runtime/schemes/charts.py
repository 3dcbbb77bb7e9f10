"""Orientations in time steps: rotation vectors theta from charts, one chart a step.

    e = chart o exp(theta),    omega = T(theta) theta',    theta' = T^-1(theta) omega

The turn that a step made is put into the chart at its end: chart <- chart o exp(theta), theta <- 0. A turn d of the
last step is d in the new chart too, and its beginning is at -d there, component by component: so it is all the same
whether a component is independent or follows from a closed loop.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence

import casadi as ca

from runtime.contract.model import Model
from runtime.schemes.rotation_vectors import angular_velocity, chart_acceleration, chart_rate, turn_since, turned_chart


class Charts:
    """The orientations of a model in vectors of q_i, or of q_i and q_d; all does nothing where there are none.

    turns: positions of each in q_i followed by q_d. What converts rates works on the orientations that stand in the
    vectors as a whole: in those of q_i on the ones that are independent.
    """

    def __init__(self, model: Model) -> None:
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
        seen = self._each(x, {n: turn_since(end[own], x[own]) for n, own in self._in(x)})
        return self.accelerations(seen, self.rates(seen, v), v, a)

    def seen_in(self, model: Model, q: ca.SX, rate: ca.SX | None = None) -> tuple[ca.SX, ca.SX]:
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
