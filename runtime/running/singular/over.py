"""States of a run on the way over a singular position, and the events that happen there."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from math import ceil

import numpy as np

from runtime.contract.status import Event, Status
from runtime.engine.rows import evaluate
from runtime.running.events import EventHandler
from runtime.running.singular.crossing import (
    CLOSEST,
    BranchLost,
    Crossing,
    TightIntegrator,
    approach,
    between,
    cross,
    turned_back,
)
from runtime.running.singular.singularity_monitor import NEAR_SINGULAR_DETERMINANT
from runtime.running.stepped_model import SteppedModel
from runtime.schemes.switching.event_search import first_bracket, first_passage
from runtime.schemes.switching.watched import NEVER, are_kinks, passed, quiet_until

NEAREST = CLOSEST[-1]  # determinant, of the largest, down to which a change of forces is followed before the position
LONGEST_LEAVE = 10_000  # steps that the neighbourhood of a singular position may take after it


class Over:
    """Follows a way to the first step whose determinant is good again, where the scheme starts anew.

    block: the loop block in question; largest: its largest determinant. asked: was Ctrl-C pressed?
    """

    def __init__(
        self,
        segment: SteppedModel,
        segments: list[SteppedModel],
        event_handler: EventHandler,
        block: int,
        largest: float,
        asked: Callable[[], bool],
    ) -> None:
        self.segment, self.segments, self.event_handler = segment, segments, event_handler
        self.block, self.largest, self.asked = block, largest, asked
        self._passed: Crossing | None = None
        self._late = 0.0  # by how much a change of inputs is felt late at most [s]

    def go(self, z: np.ndarray, way: CrossingPath) -> tuple[list[np.ndarray], Status | None]:
        """(states to be saved and the last one, the status where an event ends the run), from z (whole, flat) on.

        What an event sets holds from there on; very near to the position from the other side on. Raises BranchLost.
        """
        plan, done, samples = self.segment.plan, int(z[1]), list[np.ndarray]()
        first, end, known = done, self._last_step(way, done), dict[int, float]()
        while True:
            quiet = self._quiet(z)
            until = float(min((one for one in quiet if one > way.t), default=np.inf))
            event = way.first_event(self.segment, quiet > way.t, min(plan.time(end), until), known)
            until = until if event is None else event[0]
            steps = [
                k for k in range(done + 1, end + 1) if (k == end or k % plan.seen_steps == 0) and plan.time(k) <= until
            ]
            samples += self._states(z, way, np.array([plan.time(k) for k in steps]), steps)
            if until > plan.time(end):
                self._passed = way.crossing
                return samples, None
            done = max([done, *steps])
            step = max(done, min(end, ceil((until - plan.t0) / plan.grid.dt_L)))
            (z,) = self._states(z, way, np.array([until]), [step], off_grid=True)
            integrator = way.behind
            known = {} if event is None else {k: float(event[2][k]) for k in event[1]}
            if event is not None and self._happens(z, *event):
                integrator = TightIntegrator(self.segment.model, self.segment.p, self.segment.c, self.asked)
            if self.event_handler.status is not None:
                self._passed = way.crossing if until >= way.crossing.t_s else None
                return [*samples, z], self.event_handler.status
            way = self._gone_on(way, until, integrator)
            end = self._last_step(way, first)

    def _quiet(self, z: np.ndarray) -> np.ndarray:
        """(n_e,) until when events are not looked for [s]: tight steps need not end where a load kinks."""
        if not self.segment.watches_events:
            return np.zeros(0)
        scheme = self.segment.plan.scheme
        return np.where(are_kinks(scheme), NEVER, quiet_until(scheme, z))

    def event(self) -> Event | None:
        """That the position was passed, where it was, and not behind the end of the run."""
        if (found := self._passed) is None or found.t_near == found.t or found.t_s > self.segment.plan.t_end:
            return None
        late = f"; what an event set is felt {self._late:.2g} s late" if self._late > 0 else ""
        return Event(
            found.t_s,
            "singular_position",
            f"passed a singular position at t = {found.t_s:.9g}; branch kept by continuity, energy to "
            f"{abs(found.energy_change):.2g} J{late}",
        )

    def _happens(self, z: np.ndarray, t: float, happened: list[int], values: np.ndarray) -> bool:
        """Events at z, with what they do: do inputs change?"""
        w = self.event_handler.happen_at(z, t, happened, values)
        if w is None:
            return False
        for segment in self.segments:
            segment.take_inputs(w)
        return True

    def _gone_on(self, way: CrossingPath, t: float, integrator: TightIntegrator) -> CrossingPath:
        """From t [s] on, by another integrator where forces have changed. Raises BranchLost where these lead on to a
        position that cannot be passed.
        """
        q, q_dot = (part[0] for part in way.states(np.array([t])))
        y = integrator.pack(q, q_dot)
        if integrator is way.behind:
            return way.gone_on(t, y, integrator)
        if t < way.crossing.t_s and abs(float(integrator.determinants(t, y)[0][self.block])) > NEAREST * self.largest:
            try:
                return CrossingPath(integrator, t, y, cross(integrator, t, y, self.block, self.largest), integrator)
            except BranchLost:
                if approach(integrator, t, y, self.block, NEAREST * self.largest) is not None:
                    raise
                return CrossingPath(integrator, t, y, turned_back(t, y), integrator)
        found = way.gone_on(t, y, integrator)  # too near: the change is felt from the other side on
        self._late = max(self._late, found.leaves[0] - t)
        return found

    def _last_step(self, way: CrossingPath, first: int) -> int:
        """The first step behind the position whose determinant is good again; the last one allowed if there is none."""
        plan, height = self.segment.plan, 1.2 * NEAR_SINGULAR_DETERMINANT * self.largest
        allowed = min(plan.steps, first + LONGEST_LEAVE)
        t, y = way.leaves
        if plan.time(allowed) <= t:
            return allowed
        if abs(float(way.behind.determinants(t, y)[0][self.block])) <= height:
            found = way.behind.until(t, y, plan.time(allowed), self.block, height, 1)
            if found is None:
                return allowed
            t = found[0]
        return min(allowed, max(first + 1, ceil((t - plan.t0) / plan.grid.dt_L)))

    def _states(
        self, z: np.ndarray, way: CrossingPath, times: np.ndarray, steps: list[int], off_grid: bool = False
    ) -> list[np.ndarray]:
        """Whole states at times (N,), the ends of steps unless they are off the grid."""
        if not steps:
            return []
        q, q_dot = way.states(times)
        found, scheme = [], self.segment.plan.scheme
        layout = scheme.layout
        quiet = ("event_quiet",) if "event_quiet" in layout.sizes else ()
        stays = (*scheme.carried, *scheme.carried_by_coordinate, *quiet)
        for k in range(len(steps)):
            at = float(times[k]) if off_grid else None
            one = self.segment.start(q[k], q_dot[k], steps[k], at)
            for name in stays:
                one[layout.slice(name)] = z[layout.slice(name)]
            found.append(one)
        return found


# The motion through a singular position: tightly integrated before and behind it, a polynomial across it.

CLEAR = 0.1  # of the way behind the position within the step over it: from there on its equations are well enough


@dataclass(frozen=True)
class CrossingPath:
    """From (t, y) on [s], through a crossing; behind: integrates after it."""

    integrator: TightIntegrator
    t: float
    y: np.ndarray
    crossing: Crossing
    behind: TightIntegrator

    @property
    def leaves(self) -> tuple[float, np.ndarray]:
        """(t, y) from where it is integrated behind the position: where it begins, if not too near to it."""
        end, started = self.crossing, self.integrator is not self.behind
        clear = end.t_s + CLEAR * (end.t - end.t_s) if started else end.t
        return (self.t, self.y) if self.t >= clear else (end.t, end.y)

    def states(self, times: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """(q, q_dot), each (N, n), at rising times (N,). Raises BranchLost."""
        over = self.crossing.ends(self.integrator)
        q, q_dot = np.zeros((2, len(times), over.q.shape[1]))
        behind = times >= self.leaves[0]
        ahead = (times <= over.t[0]) & ~behind
        for part, by, start in ((ahead, self.integrator, (self.t, self.y)), (behind, self.behind, self.leaves)):
            if part.any():
                found = by.states(times[part], by.path(*start, times[part]))
                q[part], q_dot[part] = found["q"], found["q_dot"]
        for k in np.flatnonzero(~ahead & ~behind):
            q[k], q_dot[k] = between(over, float(times[k]))
        return q, q_dot

    def gone_on(self, t: float, y: np.ndarray, integrator: TightIntegrator) -> CrossingPath:
        """The rest of it from (t, y) on, by this integrator behind the position."""
        return replace(self, t=t, y=y, behind=integrator)

    def first_event(
        self, segment: SteppedModel, asleep: np.ndarray, end: float, known: dict[int, float]
    ) -> tuple[float, list[int], np.ndarray] | None:
        """(when [s], which events happen, all their values (n_e,) then) on it first until `end` [s].

        asleep (n_e,): those that do not. known: values of those that have just happened where it begins.
        """
        if not segment.watches_events or not end > self.t:
            return None
        model, scheme = segment.model, segment.plan.scheme

        looked: dict[float, np.ndarray] = {}

        def values(s: np.ndarray) -> np.ndarray:
            times = self.t + s
            q, q_dot = self.states(times)
            at = {"q": q, "q_dot": q_dot, "t": times[:, None]}
            found = evaluate(model.kernel("events"), at, segment.c)["events"][:, : len(asleep)]
            for k, value in known.items():
                found[s == 0, k] = value  # past zero, whatever rounding makes of it
            looked.update(zip(s.tolist(), found, strict=True))  # many at once may round otherwise than one
            return found

        def ask(old: np.ndarray, new: np.ndarray) -> list[int]:
            return passed(scheme, old, new, asleep)

        length = end - self.t
        bracket = first_bracket(lambda a, b: bool(ask(a, b)), values, 0.0, length)
        if bracket is None:
            return None
        low, high = ((s, looked[s]) for s in bracket)
        s, before = first_passage(ask, lambda s: values(np.array([s]))[0], low, high, length)
        return self.t + s, ask(before, looked[s]), looked[s]
