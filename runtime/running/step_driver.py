"""The driver of all motions: steps to the next event and through it, in parts where an iteration does not converge.

Runs, resumed runs, steppers in Python and the search for events of differentiated runs step by it. What they look at
between its calls, and what they keep, is theirs.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np

from runtime.running.events import EventHandler, LocatedEvents
from runtime.running.stepped_model import SteppedModel
from runtime.schemes.scheme import verdict

FEWER_STEPS = 8  # times fewer: steps of a call among which one did not converge, made again


class StepsToEvent(NamedTuple):
    """States (N, n_z) at the steps that were asked for, up to the one before an event; the step that has it, if any."""

    rows: np.ndarray
    event: int | None


class StepDriver:
    """Steps a model on states z (whole, flat), in place.

    event_handler: what has happened in the steps. start: the state before the step with events that `advance` made
    last.
    """

    def __init__(self, own: SteppedModel, records: list[LocatedEvents] | None = None) -> None:
        self.own, self.event_handler = own, EventHandler(own, records)
        self.start = np.zeros(0)

    def to_event(
        self, z: np.ndarray, ends: Sequence[int], stop_there: Callable[[], bool] = lambda: False
    ) -> StepsToEvent:
        """Make the steps to the last of these, or to the one before an event: to that itself where steps follow from a
        tolerance, and where who asks stops there for another reason.

        Bits are those of single steps, however many are made in a call.
        """
        own, made = self.own, self._to_ends(z, ends, stop_there)
        if made.event is None or own.plan.scheme.adaptive:
            return made
        if made.event - 1 == int(z[1]):
            return made._replace(rows=made.rows[:0])
        before = [*(end for end in ends if end < made.event - 1), made.event - 1]
        return made._replace(rows=own.run_and_save(z, before))

    def _to_ends(
        self, z: np.ndarray, ends: Sequence[int], stop_there: Callable[[], bool] = lambda: False
    ) -> StepsToEvent:
        """The same, but z is where it began if there is an event in steps of one length."""
        before = z.copy()
        rows = self.own.run_and_save(z, ends)
        event = self.own.first_event(z)
        if event is None or stop_there():
            return StepsToEvent(rows, None)
        if not self.own.plan.scheme.adaptive:
            z[:] = before
        return StepsToEvent(rows, event)

    def through_event(self, z: np.ndarray) -> np.ndarray | None:
        """Make the step with the events that were flagged in it; (n_w,) the inputs if they changed."""
        handler, before = self.event_handler, z.copy()
        mark, changes = handler.mark(), len(self.own.changes)
        while True:
            w = handler.step(z)
            if self.converged(z) or not self.divide(before):
                return w
            handler.go_back(mark)
            del self.own.changes[changes:]
            z[:] = before

    def advance(self, z: np.ndarray, steps: int) -> np.ndarray | None:
        """Make so many steps, or up to the end of the first with events; (n_w,) the inputs if they changed.

        A step that converges in no shorter parts either is left as it is, and z says so.
        """
        end, most = int(z[1]) + steps, steps
        while (step := int(z[1])) < end:
            before, until = z.copy(), min(step + most, end)
            event = self._to_ends(z, [until]).event
            if event is not None:
                passage = self.event_handler.through_events(z, [until])
                if passage is not None and self.converged(passage.z):
                    return self.event_handler.accept(z, passage)
                if event == step + 1:
                    self.start = before
                    return self.through_event(z)
                self.own.advance(z, event - 1 - step)
            made = int(z[1]) - step
            if self.converged(z) or not self.converged(before):
                most = FEWER_STEPS * made
            elif made > 1:
                z[:], most = before, max(1, made // FEWER_STEPS)
            elif self.divide(before):
                z[:] = before
        return None

    def converged(self, z: np.ndarray) -> bool:
        """Did the iterations of all steps that led to z converge?"""
        return verdict(self.own.plan.scheme, z) != "iteration_failed"

    def divide(self, before: np.ndarray) -> bool:
        """Make the step from this state in parts half as long as up to now. False where they are as short as may be."""
        return self.converged(before) and self.own.divide_step(before)
