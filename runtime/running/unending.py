"""Steps without an end across jumps in time and events: looked for as time goes on, always over the same stretches."""

from __future__ import annotations

from collections.abc import Sequence

import casadi as ca
import numpy as np

from runtime.contract.consistent_state import ConsistentState
from runtime.contract.errors import ArgumentError
from runtime.contract.model import Model
from runtime.contract.status import Event, Status
from runtime.running.happenings import Happenings
from runtime.running.stepped_model import SteppedModel
from runtime.running.time_functions import refuse_position_jumps
from runtime.schemes.switching.impulse import moves_in_time
from runtime.schemes.switching.steps_with_stops import StepsWithStops
from runtime.schemes.switching.times import has_switching_times, switches_by_inputs, switching_times

STRETCH = 4096  # steps over which jumps are looked for at a time: the same in one call or in many


def may_jump(model: Model) -> bool:
    """Does a condition change with time, by the scene, by inputs that move, or by functions given for them?"""
    if not has_switching_times(model):
        return False
    if model.sources:
        return True
    t, c = ca.SX.sym("t"), ca.SX.sym("c", model.c_size)
    return bool(ca.depends_on(model.evaluate("switching", t=t, c=c)["switching"], t))


def may_break(model: Model) -> bool:
    """Do steps end at jumps or at events?"""
    return bool(model.description.events) or may_jump(model)


class UnendingSteps:
    """Advances a z (whole, flat) that stays where it is; t0 [s] is where its grid of steps begins.

    happenings: the events since the grid began, and the status where one has ended it.
    """

    def __init__(self, own: SteppedModel, z: np.ndarray) -> None:
        self._own, self._z, self.t0 = own, z, float(z[0])
        self._first, self._broken = -1, StepsWithStops(own.stepper, self.t0, own.plan.grid.dt_L, [], own.c)
        self._jumps, self.happenings = may_jump(own.model), Happenings(own)
        self._by_inputs = self._jumps and (switches_by_inputs(own.model) or moves_in_time(own.model))

    def begin(self, t0: float) -> None:
        """The grid of steps begins there [s]."""
        self.t0, self.happenings = t0, Happenings(self._own)
        self.forget()
        self._look(self._own.with_inputs(self._z))
        self._z[0] = t0 + (self._broken.grid.clock(int(self._z[1])) - self._broken.grid.time(int(self._z[1])))
        self._own.begin_events(self._z)

    def go_back(self, t0: float, events: Sequence[Event], ended: Status | None) -> None:
        """To a grid that began there [s], and what had happened on it."""
        self.t0, self.happenings = t0, Happenings(self._own)
        self.happenings.told, self.happenings.status = list(events), ended
        self.forget()

    def look_anew(self) -> None:
        """At events: inputs or parameters have changed."""
        if self._own.watches_events:
            self._own.look_anew(self._z)

    def forget(self) -> None:
        """Parameters have changed: look again."""
        self._first = -1

    def take_inputs(self) -> None:
        """Inputs have changed: look again where times of jumps, or how far positions jump, hang on them."""
        if self._by_inputs:
            self.forget()

    def run(self, steps: int) -> None:
        """Make so many major steps, fewer where an event ends them.

        Raises ModelError for a prescribed motion whose position jumps in them, ArgumentError where an event has ended
        all steps before.
        """
        if (ended := self.happenings.status) is not None:
            raise ArgumentError(
                f"{ended.cause} has ended the motion", "there is no further step", "reset or restore it"
            )
        end = int(self._z[1]) + steps
        while (step := int(self._z[1])) < end and self.happenings.status is None:
            c = self._own.with_inputs(self._z)
            if self._first != step // STRETCH * STRETCH:
                self._look(c)
            self._advance(c, min(end, self._first + STRETCH) - step)

    def _advance(self, c: np.ndarray, steps: int) -> None:
        """So many of them within a stretch, or up to the end of the first in which events happen."""
        own, z, before = self._own, self._z, self._z.copy() if self._own.watches_events else self._z
        self._broken.run(z, own.ready, c, steps)
        at = own.first_event(z)
        if at is None:
            return
        z[:] = before
        sooner = at - 1 - int(z[1])
        if sooner:
            self._broken.run(z, own.ready, c, sooner)
        if self.happenings.step(z, self._broken) is not None:
            self.take_inputs()

    def _look(self, c: np.ndarray) -> None:
        own, h = self._own, self._own.plan.grid.dt_L
        self._first = int(self._z[1]) // STRETCH * STRETCH
        ends = self.t0 + self._first * h, self.t0 + (self._first + STRETCH) * h
        found = switching_times(own.model, c, *ends) if self._jumps else []
        if found and moves_in_time(own.model):
            seen = own.observed([own.state(self._z)])
            refuse_position_jumps(own.model, c, ConsistentState(seen.q[0], seen.q_dot[0], {}), found, *ends)
        self._broken = StepsWithStops(own.stepper, self.t0, h, found, c)
