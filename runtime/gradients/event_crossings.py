"""Where the events of a differentiated run happen: the run is made once as `simulate` makes it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import casadi as ca
import numpy as np

from runtime.contract.errors import ArgumentError, NoResult
from runtime.contract.model import EmittedModel
from runtime.contract.signals import SINCE
from runtime.gradients.course import ALIKE_SLOPES, EventCrossing, Hold
from runtime.gradients.impacts import rows_of
from runtime.gradients.started_run import StartedRun
from runtime.gradients.switches import MEETING
from runtime.running.events import EventHandler, LocatedEvents, state_of
from runtime.running.problem import Plan
from runtime.running.step_driver import StepDriver
from runtime.running.stepped_model import SteppedModel
from runtime.schemes.scheme import direct
from runtime.schemes.switching.stop_program import loop_guess
from runtime.schemes.switching.times import JUMP_AT_STEP
from runtime.schemes.switching.watched import NEVER, are_kinks, held_kinks, values_at, watched_events, watches

BATCH = 64  # steps after which events are looked at
NEARER, NEARINGS = 16.0, 7  # steps end before a kink, and begin behind it, nearer by that factor so many times
GRAZING = 1e-3  # least slope of a passage, over that of the way to it since the start of the step


class EventCrossings:
    """Of a plan of its own, whose scheme gets the fields of events."""

    def __init__(self, model: EmittedModel, plan: Plan) -> None:
        self._model, self._plan = model, plan
        self._events = watched_events(plan.scheme)
        self._names = [event.name for event in self._events]

    def over(self, t0: float, dt: float, steps: int) -> EventCrossings:
        """The same with so many steps of dt from t0 on [s]."""
        scheme = self._plan.scheme.with_step(dt)
        return EventCrossings(self._model, replace(self._plan, scheme=scheme, t0=t0, steps=steps, end=None))

    def refuse(self, samples: bool) -> None:
        """Raises ArgumentError for events that are not differentiated; samples: do inputs change in the run?"""
        events = self._model.description.events
        ends = [event.name for event in events if event.terminal]
        if ends:
            raise ArgumentError(
                f"events {', '.join(ends)} of model {self._model.name}",
                "end the run at a time that depends on `by`: the derivative leaves that out",
                "remove them, or make them non-terminal",
            )
        sets, modes = any(event.sets for event in events), any(event.mode for event in events)
        filtered = SINCE in self._model.signals.names
        if (sets and samples) or ((sets or modes) and filtered):
            others = "rates or filters change" if filtered else "samples change"
            raise ArgumentError(
                f"events of model {self._model.name}",
                f"set inputs, and {others} inputs too: that is not differentiated together",
                "give constants, or functions of time",
            )

    def found(
        self, started: StartedRun, holds: Sequence[Hold] = ()
    ) -> tuple[dict[int, list[EventCrossing]], list[Hold]]:
        """By the step in which they happen; and the modes of elements that change where samples do.

        holds: what inputs are set to, at ends of steps. Raises NoResult for a run that they end.
        """
        plan, modes = self._plan, list[Hold]()
        if not watches(plan.scheme):
            return {}, []
        own = SteppedModel.prepared(self._model, plan, started.x[: len(self._model.parameters)], "auto")
        own.find_switches(plan.t0, plan.t_end)
        assert own.broken is not None
        z = own.stepper.start(own.broken.grid.clock(0), *started.state, own.c, plan.grid.dt_L)
        own.begin_events(z)
        made, crossings, kinks = list[LocatedEvents](), dict[int, list[EventCrossing]](), list[float]()
        driver = StepDriver(own, made)
        event_handler = driver.event_handler
        changes = {step: [one for one in holds if one.step == step] for step in sorted({one.step for one in holds})}
        while int(z[1]) < plan.steps:
            if (now := changes.pop(int(z[1]), None)) is not None:
                modes += self._sampled(own, event_handler, z, [(one, one.number(started.values)) for one in now])
            until = min([plan.steps, *changes]) - int(z[1])
            driver.advance(z, min(BATCH, until))
            if event_handler.status is not None:
                raise NoResult(
                    f"model {self._model.name}", f"the run has no derivative, it ends: {event_handler.status}"
                )
            if made:
                crossings[int(z[1]) - 1] = self._event_crossings(own, driver.start, made)
                kinks += [one.t for one in made if are_kinks(plan.scheme)[one.events].any()]
                made.clear()
                event_handler.reported.clear()
        return self._approached(crossings, kinks), modes

    def _sampled(
        self, own: SteppedModel, event_handler: EventHandler, z: np.ndarray, values: Sequence[tuple[Hold, float]]
    ) -> list[Hold]:
        """Inputs take these values at z (n_z,), in place, as a run does it; what sticks or opens from there on.

        The time of a sample stands still, and rates go on: nothing but the modes has to be known. Raises NoResult for
        an impact there.
        """
        inputs = own.plan.scheme.layout.slice("inputs")
        w, elements = z[inputs].copy(), self._model.element_modes
        for hold, value in values:
            w[hold.row - inputs.start] = value
        own.hold(z, w)
        own.look_anew(z)
        before = len(event_handler.reported)
        settled = event_handler.settle(z)
        struck = [event.name for event in event_handler.reported[before:] if event.kind == "impact"]
        del event_handler.reported[before:]
        if struck:
            raise NoResult(
                f"sample of an input at t = {z[0] + z[1] * own.plan.grid.dt_L:.6g} s",
                f"coincides with an impact on {struck[0]}",
                "move it a little",
            )
        if settled is None:
            return []
        step = int(z[1])
        changed = np.flatnonzero(settled[elements] != w[elements])
        return [Hold(step, inputs.start + int(elements[k]), float(settled[elements[k]])) for k in changed]

    def _approached(
        self, crossings: dict[int, list[EventCrossing]], kinks: Sequence[float]
    ) -> dict[int, list[EventCrossing]]:
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
                    if 0 <= step < self._plan.steps and JUMP_AT_STEP < share < 1 - JUMP_AT_STEP:
                        crossings.setdefault(step, []).append(EventCrossing(near))
        return {step: sorted(found, key=lambda one: one.clock) for step, found in crossings.items()}

    def _event_crossings(
        self, own: SteppedModel, start: np.ndarray, made: Sequence[LocatedEvents]
    ) -> list[EventCrossing]:
        """Of one step from a state (whole, flat)."""
        scheme, found = own.plan.scheme, list[EventCrossing]()
        t, values = float(start[0] + start[1] * self._plan.grid.dt_L), start[scheme.layout.slice("event_values")]
        for one in made:
            acting = [k for k in one.events if self._events[k].sets or self._events[k].mode or self._jumps(own, one, k)]
            if not acting:
                found.append(EventCrossing(one.t))
                continue
            sets = any(self._events[k].sets for k in acting)
            must_be_alone = sets or any(k in held_kinks(scheme) for k in acting)
            if len(acting) > 1 and (must_be_alone or not self._alike(one, acting)):
                raise NoResult(
                    f"events {', '.join(self._events[k].name for k in acting)} of model {self._model.name}",
                    f"act at one time, t = {one.t:.6g} s, and separate when these change:",
                    "move one of them a little, or let one event do both",
                )
            mean_slope = abs(float(values[acting[0]])) / max(one.t - t, 1e-300) if one is made[0] else 0.0
            found.append(EventCrossing(one.t, acting[0], GRAZING * mean_slope, sets, *self._settled(own, one)))
        return found

    def _jumps(self, own: SteppedModel, one: LocatedEvents, k: int) -> bool:
        """Does a force jump at kink k, so that its time counts?"""
        scheme, held = own.plan.scheme, held_kinks(own.plan.scheme)
        if k not in held:
            return False

        def build() -> ca.Function:
            z, c, side = ca.SX.sym("z", scheme.layout.size), ca.SX.sym("c", scheme.c_size), ca.SX.sym("side", len(held))
            shown, fields = scheme.observer(z=z, c=c), scheme.layout.unpack(z)
            equations = scheme.equations(c, {**fields, "side": side})
            motion = equations.close_well(shown["q_i"], loop_guess(scheme, shown["q_d"]), shown["t"])
            return ca.Function("held", [z, c, side], [ca.densify(equations.accelerations(motion, shown["q_i_dot"]))])

        z, c = one.observed.z[: scheme.layout.size], one.observed.c
        at = np.where(np.array([*held]) == k, NEVER, 0.0)
        low, high = (direct(scheme, "accelerations on a side", build)(z, c, side) for side in (-at, at))
        return bool(np.abs(high - low).max() > MEETING * max(np.abs(high).max(), np.abs(low).max()))

    def _settled(self, own: SteppedModel, one: LocatedEvents) -> Sequence[Any]:
        """Modes, push, rows and struck of what elements did, see EventCrossing."""
        scheme, model = own.plan.scheme, self._model
        if one.settled is None:
            return ()
        at = state_of(scheme, one.observed.z, one.observed.c)
        c = np.concatenate([own.c[: len(own.c) - len(one.inputs)], one.inputs])
        first = scheme.layout.slice("inputs").start
        modes = tuple(Hold(0, first + int(k), float(one.inputs[k])) for k in model.element_modes)
        return (modes, one.settled.push, *rows_of(model, at, c, one.settled))

    def _alike(self, one: LocatedEvents, acting: Sequence[int]) -> bool:
        """Do these events stay together, whatever disturbs the motion?"""
        scheme = self._plan.scheme
        z, c = ca.SX.sym("z", scheme.layout.size), ca.SX.sym("c", scheme.c_size)
        observed = values_at(scheme, z, scheme.equations(c, scheme.layout.unpack(z)))
        moving = np.setdiff1d(np.arange(z.numel()), scheme.layout.slice("inputs").start + self._model.element_modes)
        by = ca.jacobian(observed["events"][list(acting)], ca.vertcat(z[moving.tolist()], c[: self._model.c_size]))
        moves = ca.Function("moves", [z, c], [ca.densify(ca.diag(1 / observed["slopes"][list(acting)]) @ by)])
        found = np.asarray(moves(one.observed.z[: scheme.layout.size], one.observed.c))
        return bool(np.abs(found - found[0]).max() <= ALIKE_SLOPES * np.abs(found).max())
