"""Event handling in a run: events are reported, give inputs other values, and end it. Kinks of loads only end steps.

Impacts and stick-slip are event-driven: a step ends at each change, and the equations behind it are other ones. (Time
stepping in the sense of Moreau and Jean, impulses over steps of one length without events, is not here.)

In which step one lies the scheme tells (schemes/switching/watched.py); event location in it is that of
schemes/switching/event_search.py; what impacts and friction make of the velocities, schemes/switching/settle.py.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cached_property
from itertools import takewhile
from math import ceil
from typing import Any, NamedTuple

import numpy as np

from runtime.contract.records import EventRecord
from runtime.contract.status import Event, Status
from runtime.running.impacts import impacts_given, impacts_of, impulse_given
from runtime.running.stepped_model import SteppedModel
from runtime.schemes.scheme import Scheme
from runtime.schemes.switching.impulse import Impulse, impulse_text, moves_in_time
from runtime.schemes.switching.native_events import EventRecord as NativeRecord
from runtime.schemes.switching.native_events import KinkMemory, native_events
from runtime.schemes.switching.settle import losses, losses_text
from runtime.schemes.switching.steps_with_stops import Passage
from runtime.schemes.switching.stops import Impact
from runtime.schemes.switching.times import JUMP_AT_STEP
from runtime.schemes.switching.watched import (
    Acted,
    action_values,
    begin_events,
    cool_down,
    event_slopes,
    event_values,
    sleep,
    watched_events,
)

MOST_IN_A_STEP = 50  # events of one name
MOST_BOUNCES = 20_000  # upon one stop in a step: of restitution .999 there are so many before they come too close
MOST_KINKS, OF_STEPS = 20, 60  # of one name within so many steps: then it is crossed for 1 step, for 2, for 4, ...
CHATTER = 1e-3  # of the time between states that are seen, in place of a step: where steps follow from a tolerance
MOST_REPORTED = 100  # impulses of prescribed motions
AT_THE_END = 1e-10  # s
EVENT_TIME_ROUNDING = 1e-11  # s: within which an event is located
AT_STEP_END = 1e-6  # of a step: what happens at its end


class _ObservedState(NamedTuple):
    """A state (n_z,) before events act, as it is seen with constants c; values (n_e,): past zero, or at it."""

    z: np.ndarray
    c: np.ndarray
    values: np.ndarray


class LocatedEvents(NamedTuple):
    """Events (positions) at t [s] in a state that was seen; inputs (n_w,) behind them, what elements did, if any."""

    t: float
    events: list[int]
    observed: _ObservedState
    inputs: np.ndarray
    settled: Any


class _Mark(NamedTuple):
    """memory, and how many events and records there were."""

    memory: dict[str, list[float]]
    reported: int
    records: int


class EventHandler:
    """Steps of a model in which events happen: told (of one step, or of a run) and status say what happened.

    records: all of them, where somebody keeps them.
    """

    def __init__(self, own: SteppedModel, records: list[LocatedEvents] | None = None) -> None:
        self.own, self.reported, self._records = own, list[Event](), records
        self.status: Status | None = None
        self._scheme, self._events = own.plan.scheme, watched_events(own.plan.scheme)
        self._declared = len(own.model.description.events)
        self._recent: dict[str, list[float]] = {}  # of kinks behind the number of their sleeps

    @cached_property
    def _driven(self) -> bool:
        return moves_in_time(self.own.model)

    def step(self, z: np.ndarray) -> np.ndarray | None:
        """Advance z in place, to the end of the step or to a terminal event; (n_w,) the inputs if they changed."""
        for event in self._events[: self._declared]:
            self._recent.pop(event.name, None)
        before = z[self._inputs].copy()
        assert self.own.broken is not None
        self.own.broken.step_with_events(z, self.own.ready, self.own.c, self._acts)
        return None if np.array_equal(before, z[self._inputs]) else z[self._inputs].copy()

    def through_events(self, z: np.ndarray, ends: Sequence[int]) -> Passage | None:
        """From z (whole, flat) to these steps, with the events in them, by native code; nothing has happened yet: see
        `accept`. None where they are to be made one by one.
        """
        own = self.own
        if not self.native:
            return None
        kinks = [self._recent.get(event.name, [0.0]) for event in self._events[self._declared :]]
        known = [KinkMemory(sleeps, tuple(steps)) for sleeps, *steps in kinks]
        found: Passage | None = own.broken.through_events(z, own.ready, own.c, np.array(ends, np.int64), known)
        return found

    @property
    def native(self) -> bool:
        """Are steps made with the events in them, where nothing is to be looked at closely?"""
        own = self.own
        return own.broken is not None and own.watches_events and self._records is None and own.broken.native

    def accept(self, z: np.ndarray, passage: Passage) -> np.ndarray | None:
        """What happened in a passage is told, and z is behind it; (n_w,) the inputs if they changed."""
        before = z[self._inputs].copy()
        self.own.broken.accept(passage)
        self._tell_records(passage.records)
        z[:] = passage.z
        return None if np.array_equal(before, z[self._inputs]) else z[self._inputs].copy()

    def end_step(self, z: np.ndarray) -> list[int]:
        """Where steps follow from a tolerance: end that of z (n_z,) in which an event is flagged there; which ones are.

        None may be. Nothing has happened yet: states before the event can still be seen.
        """
        return self._scheme.end_at_event(z, self._scheme.constants(self.own.c), self._once)

    def lie_within(self, z: np.ndarray) -> bool:
        """Is the end of the last step of z (n_z,) not behind the end of the run?"""
        plan = self.own.plan
        return int(z[1]) < plan.steps or self._scheme.reached(z) <= plan.t_end + AT_THE_END

    def settle(self, z: np.ndarray) -> np.ndarray | None:
        """Decide which elements stick at a state z (n_z,) that is seen, in place; (n_w,) the inputs if they changed.

        Where the run starts, and where inputs change.
        """
        if not self.own.model.element_modes.size:
            return None
        found, scheme = z.copy(), self._scheme
        if self.native:
            known = self._settled_natively(z)
            if known is not None:
                return known if len(known) else None
        observed = _ObservedState(z, scheme.constants(self.own.c), np.zeros(len(self._events)))
        push = self._velocity_jump(self._settle(found, float(z[0] + z[1] * self.own.plan.grid.dt_L), [], observed))
        w = found[self._inputs]
        changed = not np.array_equal(w, z[self._inputs])
        if changed or push.any():
            self.own.restart(z, w, push)
            self.own.look_anew(z)
        return w if changed else None

    def _settled_natively(self, z: np.ndarray) -> np.ndarray | None:
        """`settle` by native code; without entries where the inputs stay. None: rates change, or nothing is
        consistent.
        """
        own, w, modes = self.own, z[self._inputs].copy(), self.own.model.element_modes
        code = native_events(own.stepper)
        assert code is not None
        found = code.decided(z, self._scheme.constants(own.c), own.c, w)
        if found is None or not found[1]:
            return None
        new = found[0]
        if np.array_equal(new, w):
            return w[:0]
        self._tell_modes(float(z[0] + z[1] * own.plan.grid.dt_L), w[modes], new[modes])
        own.restart(z, new, np.zeros(len(own.model.q_i)))
        own.look_anew(z)
        return new

    def happen(self, z: np.ndarray, happened: list[int]) -> np.ndarray | None:
        """These events at the end of the last step of z, in place; (n_w,) the inputs if they changed.

        Where one ends the run, the end of the step is seen.
        """
        scheme, own = self._scheme, self.own
        before, constants, observed = z[self._inputs].copy(), scheme.constants(own.c), scheme.at_end(z)
        shown = _ObservedState(observed, constants, event_values(scheme, observed, constants))
        scheme.add_to_rates_at_end(z, self._happen(z, scheme.reached(z), happened, shown))
        begin_events(scheme, z, constants, scheme.at_end(z))  # with the inputs as they are now
        if self.status is not None:
            scheme.show_end(z, own.plan.grid.dt_L, self._once)
        return None if np.array_equal(before, z[self._inputs]) else z[self._inputs].copy()

    def happen_at(self, z: np.ndarray, t: float, happened: list[int], values: np.ndarray) -> np.ndarray | None:
        """These events at a state z (n_z,) that is seen at t [s], in place; (n_w,) the inputs if they changed.

        values (n_e,): what passed zero.
        """
        before, constants = z[self._inputs].copy(), self._scheme.constants(self.own.c)
        push = self._happen(z, t, happened, _ObservedState(z, constants, values), regular=False)
        if push.any():
            self.own.restart(z, z[self._inputs].copy(), push)
        return None if np.array_equal(before, z[self._inputs]) else z[self._inputs].copy()

    def memory(self) -> dict[str, list[float]]:
        """Latest times of each event [s]: what tells chattering."""
        return {name: list(times) for name, times in self._recent.items()}

    def resume(self, memory: Mapping[str, Sequence[float]]) -> None:
        """From `memory`."""
        self._recent = {name: list(times) for name, times in memory.items()}

    def mark(self) -> _Mark:
        """What `go_back` goes back to."""
        return _Mark(self.memory(), len(self.reported), len(self._records or ()))

    def go_back(self, mark: _Mark) -> None:
        """To before a step that has ended nothing: what it told is not told."""
        self.status = None
        self.resume(mark.memory)
        del self.reported[mark.reported :]
        if self._records is not None:
            del self._records[mark.records :]

    def _once(self, z: np.ndarray) -> None:
        self.own.stepper.run(z, self.own.ready, 1)

    @property
    def _inputs(self) -> slice:
        return self._scheme.layout.slice("inputs") if self.own.model.signals.size else slice(0, 0)

    def _acts(self, z: np.ndarray, dt: float, t: float, happened: list[int]) -> Acted:
        """These events at t [s], in a state z that steps dt show, in place."""
        constants = self._scheme.constants(self.own.c, dt)
        push = self._happen(z, t, happened, _ObservedState(z, constants, event_values(self._scheme, z, constants)))
        return Acted(self.status is not None, push)

    def _happen(
        self, z: np.ndarray, t: float, happened: list[int], observed: _ObservedState, regular: bool = True
    ) -> np.ndarray:
        """These events at t [s]: they are told and judged, z gets the inputs that they set; (n_i,) added to the rates.

        observed: before they do anything. regular: do the equations of q_i have accelerations there? Near a singular
        position they have none, and powers on either side are not computed.
        """
        kept, before = None if self._records is None else observed._replace(z=observed.z.copy()), observed.z.copy()
        cool_down(self._scheme, z, happened, t)
        changes = self._tell_events(z, t, happened, observed)
        endless = next((name for name, value in changes.items() if not np.isfinite(value)), None)
        if endless is not None:
            cause = f"event {self.reported[-1].name} sets {endless} to {changes[endless]}"
            self.status = Status("not_finite", t, None, cause, "Make its action finite there.")
        elif changes:
            z[self._inputs] = self.own.model.signals.changed(z[self._inputs].copy(), t, changes)
        settled = None
        if self.status is None and self.own.model.element_modes.size:
            settled = self._settle(z, t, happened, observed)
        if self._records is not None and kept is not None:
            self._records.append(LocatedEvents(t, happened, kept, z[self._inputs].copy(), settled))
        push = self._velocity_jump(settled)
        if regular:
            self.own.note_change(t, before, observed.c, z[self._inputs], push)
        return push

    def _tell_events(self, z: np.ndarray, t: float, happened: list[int], observed: _ObservedState) -> dict[str, float]:
        """These events at t [s], but for what elements do: they are told and judged; the inputs that they set.

        z (n_z,): the state that goes on, where kinks are slept over.
        """
        values_now = observed.values
        rates = event_slopes(self._scheme, observed.z, observed.c) if (values_now == 0).any() else values_now
        changes: dict[str, float] = {}
        for k in happened:
            event = self._events[k]
            direction = "rising" if (values_now[k] or rates[k]) >= 0 else "falling"
            if k >= self._declared:
                self.reported.append(Event(t, "kink", f"{event.name}, {direction}", event.name, direction))
                self._rest(z, k, t)
                continue
            if event.direction != "either":
                direction = event.direction
            if event.sets:
                first = sum(len(one.sets) for one in self._events[:k])
                values = action_values(self._scheme, observed.z, observed.c)[first:]
                changes |= dict(zip(event.sets, values.tolist(), strict=False))
            if not event.mode:  # what it does is told when all is settled
                self.reported.append(Event(t, "event", _text(event, direction, changes), event.name, direction))
            self._judge(event, t)
        return changes

    def _tell_records(self, records: list[NativeRecord]) -> None:
        """What native code has found."""
        model, step, dt = self.own.model, -1, np.nan
        events, constants = model.mode_events, self.own.c
        given = impacts_given(model, self.own.c, [one for one in records if one.hits])
        places = self._inputs.start + model.element_modes
        for one in records:
            if one.step != step:  # what chatters does so within a step
                step = one.step
                for event in self._events[: self._declared]:
                    self._recent.pop(event.name, None)
            if one.dt_seen != dt:
                dt, constants = one.dt_seen, self._scheme.constants(self.own.c, one.dt_seen)
            observed = _ObservedState(one.z, constants, one.values)
            self._tell_events(one.z, one.t, one.happened, observed)
            if one.hits:
                elements = [(k, events[k]) for k in one.hits]
                each = [float(-own.side * one.impulse[k] * one.passing[own.row]) for k, own in elements]
                self._tell_hits(impacts_of(one), each, next(given), one.t, float(np.nextafter(one.t, -np.inf)))
            if len(places):
                self._tell_modes(one.t, one.z[places], one.inputs[model.element_modes])
            self.own.note_change(one.t, one.z, observed.c, one.inputs, one.push)

    def _velocity_jump(self, settled: Any) -> np.ndarray:
        """(n_i,) what is added to the rates."""
        return np.zeros(len(self.own.model.q_i)) if settled is None else np.asarray(settled.push)

    def _settle(self, z: np.ndarray, t: float, happened: list[int], observed: _ObservedState) -> Any:
        """What elements do behind these events at t [s], or None where that ends the run; their modes go into z."""
        scheme, model, modes = self._scheme, self.own.model, self.own.model.element_modes
        at = state_of(scheme, observed.z, observed.c)
        inputs, first = z[self._inputs].copy(), self._declared - len(modes)
        before, own = inputs[modes].copy(), np.isin(np.arange(first, self._declared), happened)
        rest_rate = np.zeros(len(modes))
        if (own & (before != 0)).any():
            rest_rate = np.where(
                own,
                EVENT_TIME_ROUNDING * np.abs(event_slopes(scheme, observed.z, observed.c))[first : self._declared],
                0.0,
            )
        c = np.concatenate([self.own.c[: len(self.own.c) - len(inputs)], inputs])
        from runtime.schemes.switching.settle import NoMode, settled

        found = settled(model, at, c, own & (before == 0), rest_rate, own & (before != 0))
        if isinstance(found, NoMode):
            self.status = Status("no_mode", t, None, found.cause, found.remedy)
            return None
        inputs[modes] = found.modes
        z[self._inputs] = inputs
        if found.impacts:
            # where an event ends a step of one length, what is seen there is after it
            seen = t if scheme.adaptive or not happened else float(np.nextafter(t, -np.inf))
            given = impulse_given(model, c, t, at, at["q_i_dot"] + found.push, found.q_d_dot)
            self._tell_hits(found.impacts, losses(model, at, c, found), given, t, seen)
        self._tell_modes(t, before, found.modes)
        return found

    def _tell_modes(self, t: float, before: np.ndarray, after: np.ndarray) -> None:
        """What holds, opens or slides from t [s] on, by modes (n_m,)."""
        first = self._declared - len(after)
        for k in (after != before).nonzero()[0]:
            name = self._events[first + k].name
            if text := _mode_text(self._events[first + k], float(before[k]), float(after[k])):
                self.reported.append(Event(t, "mode", f"{name} {text}", name))

    def _tell_hits(
        self, impacts: Sequence[Impact], each: Sequence[float], given: Impulse | None, t: float, before: float
    ) -> None:
        """Impacts on stops at t [s], the energy that each took, and what all did together, where that is known; before
        [s]: what is seen there is before them.
        """
        model, lost = self.own.model, ""
        if given is not None:
            earlier = self.own.impulses.get(before)
            gained = given.energy + (0.0 if earlier is None else earlier.energy)
            self.own.impulses[before] = Impulse(gained, given.jumps)
            lost = losses_text(sum(each), given.energy, self._driven)
        for impact, own in zip(impacts, each, strict=True):
            name = model.mode_events[impact.k].name
            text = f"{name} is hit at {-impact.before:.6g} and left at {impact.after:.6g}{lost}"
            one = Event(
                t,
                "impact",
                text,
                name,
                impulse=impact.impulse,
                before=impact.before,
                after=impact.after,
                energy_lost=own,
            )
            self.reported.append(one)
            if impact.rests is not None:
                text = f"{name}: its bounces are over, summed from t = {t:.9g} s on"
                self.reported.append(Event(t + impact.rests, "rest", text, name))

    def _rest(self, z: np.ndarray, k: int, t: float) -> None:
        """Kink k at t [s]: where it comes ever again, z does not look for it for ever longer."""
        name, dt, grid = self._events[k].name, self.own.plan.grid.dt_L, None
        if self.own.broken is not None:
            grid = self.own.broken.grid
            step = ceil((t - grid.t0) / dt - JUMP_AT_STEP)  # at whose end
        else:
            step = self._scheme.steps_made(z)
        sleeps, *steps = self._recent.get(name, [0.0])
        steps = [*steps, float(step)][-MOST_KINKS:]
        if len(steps) == MOST_KINKS and step - steps[0] < OF_STEPS:
            sleep(
                self._scheme, z, k, (t if grid is None else grid.time(step)) + (2.0**sleeps - (grid is not None)) * dt
            )
            if not sleeps:
                text = (
                    f"{name}, comes {MOST_KINKS} times in {step - steps[0] + 1:.0f} steps: from here on steps cross it"
                )
                self.reported.append(Event(t, "kink_crossed", text, name))
            sleeps, steps = sleeps + 1, []
        self._recent[name] = [sleeps, *steps]

    def _judge(self, event: EventRecord, t: float) -> None:
        if event.terminal:
            self.status = Status("event", t, None, f"event {event.name}", "It ends the run, as the scene says.")
            return
        most = MOST_IN_A_STEP if not event.side else MOST_BOUNCES
        recent = self._recent.setdefault(event.name, [])
        recent.append(t)
        del recent[:-most]
        window = self.own.plan.grid.dt_L * (CHATTER if self._scheme.adaptive else 1)
        if len(recent) == most and t - recent[0] <= window:
            within = f"{window:.3g} s" if self._scheme.adaptive else "one step"
            self.status = Status(
                "chattering",
                t,
                None,
                f"event {event.name} happens {most} times within {within}: its action undoes itself",
                "Give it a cool_down or a hysteresis (two events at two values), or let the force change smoothly.",
            )


def rest_until(scheme: Scheme, z: np.ndarray, quiet: Mapping[str, float]) -> None:
    """These events are not looked for until then [s], in z (n_z,): a run before this one has had them."""
    for k, event in enumerate(watched_events(scheme)):
        if event.name in quiet:
            sleep(scheme, z, k, quiet[event.name])


def state_of(scheme: Scheme, z: np.ndarray, c: np.ndarray) -> dict[str, np.ndarray]:
    """q_i, q_d, q_i_dot, q_d_dot, t that a state z shows with constants c as stages read them."""
    shown = scheme.observer(z=z[: scheme.layout.size], c=c)
    return {name: np.asarray(shown[name]).ravel() for name in ("q_i", "q_d", "q_i_dot", "q_d_dot", "t")}


def _mode_text(event: EventRecord, before: float, mode: float) -> str:
    """What an element does from here on; nothing where a stop stays open."""
    if event.side:
        return "closes" if mode == 0 else "opens" if before == 0 else ""
    return "sticks" if mode == 0 else "slides forwards" if mode > 0 else "slides backwards"


def _text(event: EventRecord, direction: str, changes: dict[str, float]) -> str:
    action = ", ".join(f"{name} = {changes[name]:.6g}" for name in event.sets)
    return f"event {event.name}, {direction}" + (f": {action}" if action else "") + (", ends" if event.terminal else "")


class ImpulseNotes:
    """Tells each impulse of a prescribed motion once, as an event; reads only what is new since its last look."""

    def __init__(self) -> None:
        self._known, self._read, self._count = set[float](), 0, 0

    def note(self, segment: SteppedModel, step: int, events: list[Event]) -> None:
        """Append an event for each impulse until the end of a step, unless an impact has told it."""
        if not segment.impulses:
            return
        for event in events[self._read :]:
            if event.kind == "velocity_jump":
                self._known.add(event.time)
                self._count += 1
            elif event.kind == "impact":
                self._known |= {event.time, float(np.nextafter(event.time, -np.inf))}
        self._read = len(events)
        new = list(takewhile(lambda at: at not in self._known, reversed(segment.impulses)))
        until = segment.plan.time(step) + AT_STEP_END * segment.plan.grid.dt_L
        for at in sorted(one for one in new if one <= until)[: max(0, MOST_REPORTED - self._count)]:
            events.append(Event(at, "velocity_jump", impulse_text(segment.model, segment.impulses[at])))
