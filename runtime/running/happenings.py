"""What events do in a run: they are told, give inputs other values, and end it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from runtime.contract.records import EventRecord
from runtime.contract.status import Event, Status
from runtime.running.segment import Segment
from runtime.schemes.switching.broken_steps import Leg
from runtime.schemes.switching.watched import action_values, event_values

MOST_IN_A_STEP = 50  # events of one name
MOST_TOLD = 100  # impulses of prescribed motions
NEAR = 1e-6  # of a step: what happens at its end


class Happenings:
    """One major step of a segment in which events happen: `step` makes it; then told and status say what happened."""

    def __init__(self, segment: Segment) -> None:
        self.segment, self.told = segment, list[Event]()
        self.status: Status | None = None
        self._events = segment.model.description.events

    def step(self, z: np.ndarray) -> np.ndarray | None:
        """Advance z in place, to the end of the step or to a terminal event; (n_w,) the inputs if they changed."""
        segment = self.segment
        assert segment.broken is not None
        own = segment.plan.scheme.layout.slice("inputs") if segment.model.inputs else slice(0, 0)
        before = z[own].copy()
        segment.forget_determinants(z)
        segment.broken.step_with_events(z, segment.c, self._acts)
        return None if np.array_equal(before, z[own]) else z[own].copy()

    def _acts(self, leg: Leg, happened: list[int]) -> Leg:
        """A leg at whose end these events happen, with what they do."""
        scheme, t = self.segment.plan.scheme, float(leg.reached)
        constants = scheme.constants(self.segment.c, leg.dt)
        values = action_values(scheme, leg.z, constants)
        slopes = event_values(scheme, leg.z, constants)
        first = np.cumsum([0, *(len(event.sets) for event in self._events)])
        changes: dict[str, float] = {}
        for k in happened:
            event, direction = self._events[k], "rising" if slopes[k] >= 0 else "falling"
            if event.direction != "either":
                direction = event.direction
            changes |= dict(zip(event.sets, values[first[k] : first[k + 1]].tolist(), strict=True))
            self.told.append(Event(t, "event", _text(event, direction, changes), event.name, direction))
            self._judge(event, t)
        z = leg.z
        if changes:
            own = scheme.layout.slice("inputs")
            z = leg.z.copy()
            z[own] = self.segment.model.signals.changed(z[own].copy(), t, changes)
        return replace(leg, z=z, ends=self.status is not None)

    def _judge(self, event: EventRecord, t: float) -> None:
        if event.terminal:
            self.status = Status("event", t, None, f"event {event.name}", "It ends the run, as the scene says.")
        elif sum(told.name == event.name for told in self.told) >= MOST_IN_A_STEP:
            self.status = Status(
                "chattering",
                t,
                None,
                f"event {event.name} happens {MOST_IN_A_STEP} times within one step: its action undoes itself",
                "Give it a hysteresis (two events at two values), or let the force change smoothly.",
            )


def _text(event: EventRecord, direction: str, changes: dict[str, float]) -> str:
    action = ", ".join(f"{name} = {changes[name]:.6g}" for name in event.sets)
    return f"event {event.name}, {direction}" + (f": {action}" if action else "") + (", ends" if event.terminal else "")


def note_impulses(segment: Segment, step: int, events: list[Event]) -> None:
    """Append an event for each impulse of a prescribed motion until the end of a step, unless it is told already."""
    if segment.broken is None:
        return
    told = {event.time for event in events if event.kind == "velocity_jump"}
    until = segment.plan.time(step) + NEAR * segment.plan.grid.dt_L
    for at, impulse in sorted(segment.broken.impulses.items()):
        if at <= until and at not in told and len(told) < MOST_TOLD:
            k = int(np.abs(impulse.jumps).argmax())
            text = (
                f"the velocity of a prescribed motion jumps: its impulse changes the rate of "
                f"{segment.model.coordinates[k]} by {impulse.jumps[k]:.6g}, the energy by {impulse.energy:.6g} J"
            )
            events.append(Event(at, "velocity_jump", text))
            told.add(at)
