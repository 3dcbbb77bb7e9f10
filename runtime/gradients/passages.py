"""Where the events of a differentiated run happen: the run is made once as `simulate` makes it."""

from __future__ import annotations

from collections.abc import Sequence
from copy import copy
from dataclasses import replace

import numpy as np

from runtime.contract.errors import ArgumentError, NoResult
from runtime.contract.model import Model, refuse_elements
from runtime.contract.signals import SINCE
from runtime.contract.status import Event
from runtime.gradients.course import EventPassage
from runtime.gradients.start_of_run import Begun
from runtime.running.events import EventActions
from runtime.running.plan import Plan
from runtime.running.stepped_model import SteppedModel
from runtime.schemes.switching.breaks import ON_THE_GRID
from runtime.schemes.switching.watched import watch_events, watched_events, watches

BATCH = 64  # steps after which events are looked at
NEARER, NEARINGS = 16.0, 7  # steps end before a kink, and begin behind it, nearer by that factor so many times
GRAZING = 1e-3  # least slope of a passage, over that of the way to it since the start of the step


class Passages:
    """Of a plan of its own, whose scheme gets the fields of events."""

    def __init__(self, model: Model, plan: Plan) -> None:
        self._model, self._plan = model, plan
        watch_events(plan.scheme)
        self._events = watched_events(plan.scheme)
        self._names = [event.name for event in self._events]

    def over(self, t0: float, dt: float, steps: int) -> Passages:
        """The same with so many steps of dt from t0 on [s]."""
        other = copy(self)
        other._plan = replace(self._plan, scheme=self._plan.scheme.with_step(dt), t0=t0, steps=steps)
        return other

    def refuse(self, samples: bool) -> None:
        """Raises ArgumentError for events that are not differentiated; samples: do inputs change in the run?"""
        refuse_elements(self._model, "is not differentiated", "take a scene without it, or differences")
        events = self._model.description.events
        ends = [event.name for event in events if event.terminal]
        if ends:
            raise ArgumentError(
                f"events {', '.join(ends)} of model {self._model.name}",
                "end the run at a time that moves, of which the derivative of a run does not know",
                "take a scene without them, or let them not be terminal",
            )
        sets = any(event.sets for event in events)
        if sets and (samples or SINCE in self._model.signals.names):
            raise ArgumentError(
                f"events of model {self._model.name}",
                "set inputs, and samples, rates or filters change inputs too: that is not differentiated together",
                "give constants",
            )

    def found(self, begun: Begun) -> dict[int, list[EventPassage]]:
        """By the step in which they happen. Raises NoResult for a run that they end."""
        plan = self._plan
        if not watches(plan.scheme):
            return {}
        own = SteppedModel.prepared(self._model, plan, begun.x[: len(self._model.parameters)], "auto")
        own.find_switches(plan.t0, plan.t_end)
        assert own.broken is not None
        z = own.begin(own.broken.grid.clock(0), *begun.state)
        own.begin_events(z)
        happenings, passages = EventActions(own), dict[int, list[EventPassage]]()
        kinks: list[float] = []
        while int(z[1]) < plan.steps:
            happenings.advance(z, min(BATCH, plan.steps - int(z[1])))
            if happenings.status is not None:
                raise NoResult(f"model {self._model.name}", f"the run has no derivative, it ends: {happenings.status}")
            if happenings.told:
                happened = [event for event in happenings.told if event.kind != "kink_crossed"]
                passages[int(z[1]) - 1] = self._told(own, happenings.start, happened)
                kinks += [event.time for event in happened if event.kind == "kink"]
                happenings.told.clear()
        return self._approached(passages, kinks)

    def _approached(
        self, passages: dict[int, list[EventPassage]], kinks: Sequence[float]
    ) -> dict[int, list[EventPassage]]:
        """With steps that become shorter towards each kink and longer behind it.

        A stage at a kink has the slope of either side, and stages of a whole step are no nearer to the motion than its
        order says: they are on the right side only where they are further from the kink than that. Their force is the
        same from both sides, so values do not need this.
        """
        t0, dt = self._plan.t0, self._plan.grid.dt_L
        for clock in dict.fromkeys(kinks):
            for k in range(1, NEARINGS + 1):
                for near in (clock - dt * NEARER**-k, clock + dt * NEARER**-k):
                    step = int(np.floor((near - t0) / dt))
                    share = (near - t0) / dt - step
                    if 0 <= step < self._plan.steps and ON_THE_GRID < share < 1 - ON_THE_GRID:
                        passages.setdefault(step, []).append(EventPassage(near))
        return {step: sorted(found, key=lambda one: one.clock) for step, found in passages.items()}

    def _told(self, own: SteppedModel, start: np.ndarray, told: Sequence[Event]) -> list[EventPassage]:
        """Of one step from a state (whole, flat)."""
        scheme, events = own.plan.scheme, self._events
        t, values = float(start[0] + start[1] * self._plan.grid.dt_L), start[scheme.layout.slice("event_values")]
        found = list[EventPassage]()
        for clock in dict.fromkeys(event.time for event in told):
            here = [self._names.index(event.name) for event in told if event.time == clock]
            acting = [k for k in here if events[k].sets]
            if len(acting) > 1:
                raise NoResult(
                    f"events {', '.join(self._names[k] for k in acting)} of model {self._model.name}",
                    f"act at one time, t = {clock:.6g} s, and move apart with what is differentiated by",
                    "move one of them a little, or let one event do both",
                )
            if acting:
                least = GRAZING * abs(float(values[acting[0]])) / max(clock - t, 1e-300)
                found.append(EventPassage(clock, acting[0], least))
            else:
                found.append(EventPassage(clock))
        return found
