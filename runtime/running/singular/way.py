"""The motion through a singular position: tightly integrated before and behind it, a polynomial across it."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from runtime.engine.rows import evaluate
from runtime.running.segment import Segment
from runtime.running.singular.crossing import Crossing, between
from runtime.running.singular.tight_integrator import TightIntegrator
from runtime.schemes.switching.dips import first_bracket
from runtime.schemes.switching.event_search import first_passage
from runtime.schemes.switching.watched import passed

NEAREST = 0.1  # of the way behind the position within the step over it: from there on its equations are well enough


@dataclass(frozen=True)
class Way:
    """From (t, y) on [s], through a crossing; behind: integrates after it."""

    integrator: TightIntegrator
    t: float
    y: np.ndarray
    crossing: Crossing
    behind: TightIntegrator

    @property
    def leaves(self) -> tuple[float, np.ndarray]:
        """(t, y) from where it is integrated behind the position: where it begins, if not too near to it."""
        end, begun = self.crossing, self.integrator is not self.behind
        clear = end.t_s + NEAREST * (end.t - end.t_s) if begun else end.t
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

    def gone_on(self, t: float, y: np.ndarray, integrator: TightIntegrator) -> Way:
        """The rest of it from (t, y) on, by this integrator behind the position."""
        return replace(self, t=t, y=y, behind=integrator)

    def first_event(
        self, segment: Segment, asleep: np.ndarray, end: float, known: dict[int, float]
    ) -> tuple[float, list[int], np.ndarray] | None:
        """(when [s], which events happen, all their values (n_e,) then) on it first until `end` [s].

        asleep (n_e,): those that do not. known: values of those that have just happened where it begins.
        """
        if not segment.watches_events or not end > self.t:
            return None
        model, scheme = segment.model, segment.plan.scheme

        def values(s: np.ndarray) -> np.ndarray:
            times = self.t + s
            q, q_dot = self.states(times)
            at = {"q": q, "q_dot": q_dot, "t": times[:, None]}
            found = evaluate(model.kernel("events"), at, segment.c)["events"]
            for k, value in known.items():
                found[s == 0, k] = value  # past zero, whatever rounding makes of it
            return found

        def ask(old: np.ndarray, new: np.ndarray) -> list[int]:
            return passed(scheme, old, new, asleep)

        length = end - self.t
        bracket = first_bracket(lambda a, b: bool(ask(a, b)), values, 0.0, length)
        if bracket is None:
            return None
        low, high = ((s, values(np.array([s]))[0]) for s in bracket)
        s, before = first_passage(ask, lambda s: values(np.array([s]))[0], low, high, length)
        after = values(np.array([s]))[0]
        return self.t + s, ask(before, after), after
