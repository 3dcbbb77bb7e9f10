"""The loop of a run: many major steps a native call; checks, samples, checkpoints and progress in between."""

from __future__ import annotations

import signal
import threading
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from types import FrameType

import numpy as np

from runtime.contract.coordinates import followed, whole
from runtime.contract.doors import opened
from runtime.contract.files import OutputError
from runtime.contract.model import Model
from runtime.contract.status import Event, Status
from runtime.engine.rows import evaluate
from runtime.results.solution import Solution
from runtime.running.events import EventActions, note_impulses
from runtime.running.inputs import EndlessInput, Schedule
from runtime.running.plan import Plan, whole_number
from runtime.running.problem import Problem
from runtime.running.record import Record, record_of
from runtime.running.singular.guard import FLOOR, Guard, lost_unguarded
from runtime.running.stepped_model import SteppedModel
from runtime.running.time_functions import check_time_functions
from runtime.schemes.options import SchemeError

Progress = Callable[[float, float], None]


CALL_SECONDS = 0.25  # a call lasts about this long, so that progress and Ctrl-C stay responsive
LONGEST_CALL = 1 << 20
MOST_SAVED = 256  # states that are saved between two looks
CHECKPOINT_SECONDS = 60.0


@dataclass(frozen=True)
class Further:
    """How a run goes, and what is kept of it; see `simulate`."""

    progress: Progress | bool | None = None
    force: bool = False
    outputs: Sequence[str] | None = None
    stream: str | Path | None = None
    checkpoint: str | Path | None = None
    checkpoint_every: int | None = None

    @property
    def bounded(self) -> bool:
        """Do whole states not stay in memory?"""
        return self.outputs is not None or self.stream is not None

    def checked(self) -> Further:
        """The same: checkpoints can be written. Raises SchemeError or OutputError."""
        every = self.checkpoint_every
        if every is not None and not (whole_number(every) or 0) >= 1:
            raise SchemeError(
                "checkpoint_every",
                f"must be a whole number of major steps of at least 1, not {every!r}",
                "leave it out for a checkpoint every minute",
            )
        if every is not None and self.checkpoint is None:
            raise SchemeError("checkpoint_every", "needs a file", "give checkpoint = ...")
        if self.checkpoint is not None:
            opened("runtime.running.checkpoint:claim")(self.checkpoint)
        return self


@dataclass
class Pace:
    """steps: most of a call; saves: the save at which it ends; slow_until: until then it ends at the next one.

    Looks cost as much as some hundred steps of a small mechanism, so there are fewer of them while all is well.
    """

    steps: int = 64
    saves: int = 32
    slow_until: int = 0

    def slow(self, step: int) -> bool:
        """Is each saved state looked at closely here?"""
        return step < self.slow_until

    def next_steps(self, step: int, seen_steps: int) -> int:
        """The length of the next call."""
        saves = 1 if self.slow(step) else self.saves
        return min(self.steps, saves * seen_steps - step % seen_steps)

    def took(self, seconds: float) -> None:
        """Double or halve: the interpreted engine builds one Function per batch length, so there should be few."""
        if seconds < CALL_SECONDS / 4:
            self.steps = min(self.steps * 2, LONGEST_CALL)
        elif seconds > CALL_SECONDS:
            self.steps = max(1, self.steps // 2)

    def went_well(self) -> None:
        """Nothing was found: look at twice as many saved states at once."""
        self.saves = min(2 * self.saves, MOST_SAVED)

    def went_wrong(self, until: int) -> None:
        """Steps until there are made again, one save at a time."""
        self.saves, self.slow_until = 1, until


class Interrupts:
    """asked: was Ctrl-C pressed? A second press stops at once."""

    asked = False

    def _heard(self, number: int, frame: FrameType | None) -> None:
        if self.asked:
            raise KeyboardInterrupt
        self.asked = True


@contextmanager
def heard_interrupts() -> Iterator[Interrupts]:
    """Hear Ctrl-C while inside. Outside the main thread, and where the caller has a handler, nothing changes."""
    heard = Interrupts()
    ours = (
        threading.current_thread() is threading.main_thread()
        and signal.getsignal(signal.SIGINT) is signal.default_int_handler
    )
    if ours:
        signal.signal(signal.SIGINT, heard._heard)
    try:
        yield heard
    finally:
        if ours:
            signal.signal(signal.SIGINT, signal.default_int_handler)


@dataclass
class Run:
    """A run of a problem under way: z (flat) belongs to `segment`. initial_changes: what of the start was corrected."""

    problem: Problem
    segment: SteppedModel
    z: np.ndarray
    record: Record
    further: Further
    initial_changes: str
    events: list[Event] = field(default_factory=list)
    status: Status | None = None
    guard: Guard = field(default_factory=Guard)
    marks: Marks | None = None
    schedule: Schedule | None = None
    pace: Pace = field(default_factory=Pace)
    set_up: float = 0.0  # seconds that it took to come to the start
    seconds: float = 0.0  # that its steps took
    _happened: EventActions | None = None
    _left: dict[int, int] = field(default_factory=dict)  # the step at which segments, by identity, were left last
    earlier: np.ndarray | None = None  # a state of this segment at least a step before z, if there is one

    @property
    def step(self) -> int:
        """Major steps done."""
        return self.segment.step_of(self.z)

    def go(self) -> Status:
        """Step until the end, trouble, or Ctrl-C. The record ends with the last good state."""
        began = time.perf_counter()
        try:
            return self._gone()
        finally:
            self.seconds += time.perf_counter() - began

    def _gone(self) -> Status:
        self._written = time.monotonic()
        with heard_interrupts() as interrupts:
            self._interrupts = interrupts
            try:
                self._loop(interrupts)
            except KeyboardInterrupt:
                interrupts.asked = True
            except (OutputError, EndlessInput) as error:
                self.status = error.status if isinstance(error, EndlessInput) else self._output_failed(error)
            interrupted = self.status is None and self.step < self.segment.plan.steps
            if interrupted:
                self.status = self.segment.monitor.after(self._state, last=True)
            if self.status is None and interrupted:
                at = self.segment.plan.time(self.step)
                self.status = Status("interrupted", at, None, "stopped by the user", "What was computed is kept.")
                self._keep()
                self._write_checkpoint()
        if self.status is not None:  # end with the last good state, which need not be one that was to be saved
            self.record.drop_from(self.step)
            self.record.add(self.segment, self.z[None])
        try:
            self.record.flush()
        except OutputError as error:
            self.status = self._output_failed(error)
        return self.status or Status("completed", self.segment.plan.t_end)

    def _output_failed(self, error: OutputError) -> Status:
        """The place for the samples takes no more: those that wait are lost, the state is not."""
        self.record.samples = []
        time_ = self.segment.plan.time(self.step)
        return Status("output_failed", time_, None, str(error), "Go on from the last checkpoint, or stream elsewhere.")

    def seen(self) -> Solution:
        """What was kept, with the state that it has come to."""
        return self.record.solution((self.record.segments.index(self.segment), self._state))

    @property
    def _state(self) -> np.ndarray:
        return self.segment.state(self.z)

    def _loop(self, interrupts: Interrupts) -> None:
        while self.status is None and self.step < self.segment.plan.steps and not interrupts.asked:
            self._take_inputs()
            n = self._batch()
            began = time.perf_counter()
            self._advance(n)
            self.pace.took(time.perf_counter() - began)
            self._keep()
            plan, progress = self.segment.plan, self.further.progress
            if self.status is None and self.step < plan.steps and self._checkpoint_is_due():
                self._write_checkpoint()
            if callable(progress):
                progress(plan.time(self.step), plan.t_end)

    def _take_inputs(self) -> None:
        """What is sampled at this step."""
        if self.schedule is None:
            return
        plan, layout = self.segment.plan, self.segment.plan.scheme.layout
        plan.scheme.land(self.z)
        own = layout.slice("inputs")
        w = self.schedule.apply(self.step, plan.time(self.step), self._state, self.z[own].copy())
        if w is not None:
            self.segment.hold(self.z, w)
            for segment in self.record.segments:
                segment.take_inputs(w)
            self.segment.look_anew(self.z)
            self.settle()

    def settle(self, told: bool = True) -> None:
        """Decide which elements stick from here on."""
        w, happened = self.happenings.settle(self.z), self.happenings
        if w is not None:
            for segment in self.record.segments:
                segment.take_inputs(w)
        self.events += happened.told if told else []
        happened.told.clear()
        self.status = self.status or happened.status

    def _advance(self, n: int) -> None:
        """Make n steps, or fewer. Where they are more than one save long and end in trouble, they are undone.

        Short ones follow then, so that the trouble is found where it begins.
        """
        before, known = self.z.copy(), self.segment.monitor.memory()
        saved = self.segment.run_and_save(self.z, self._kept(n))
        at = self.segment.first_event(self.z)
        determinants = self.segment.determinants(self.z)
        alarm = self.guard.alarm(*determinants)
        scheme = self.segment.plan.scheme
        if at is not None and not alarm:  # else the alarm comes first: what it is about is sought below
            if scheme.adaptive:
                if self._ends_at_event(saved):
                    return
            else:
                self.pace.steps, self.z = 1, before.copy()
                first = self.segment.step_of(before) + 1
                if at == first and self._steps_with_events(before):
                    return
                n = max(1, at - first)  # the step in which it happens comes next
                saved = self.segment.run_and_save(self.z, self._kept(n)) if at > first else saved[:0]
            determinants = self.segment.determinants(self.z)
            alarm = self.guard.alarm(*determinants)
        status = None if alarm else self._checked(samples=len(saved) + 1)
        if len(saved) and (alarm or status is not None):
            self.pace.went_wrong(until=self.segment.step_of(before) + n)
            self.segment.monitor.recall(known)
            self.z = before
            return
        if alarm:
            self._pass(before, n)
            status = self.status or self._checked()
        else:
            self.guard.accept(*determinants)
            self.earlier = before
            self.pace.went_well()
        self._keep(saved)
        note_impulses(self.segment, self.step, self.events)
        self.status = status

    def _steps_with_events(self, before: np.ndarray) -> bool:
        """Make the next step, in which events may happen: does one?"""
        self.segment.forget_determinants(self.z)
        w = self.happenings.step(self.z)
        if not self.happenings.told:
            return False
        self._take_event(w)
        return True

    def _ends_at_event(self, saved: np.ndarray) -> bool:
        """Does the last step end at an event? Then what lies before it is seen first."""
        happened, plan = self.happenings.end_step(self.z), self.segment.plan
        scheme = plan.scheme
        if not happened:
            return False
        self.pace.steps = 1
        self._keep(saved)
        while self.step < plan.steps and scheme.next_seen(self.z, plan.grid.dt_L) <= scheme.reached(self.z):
            if scheme.is_stuck(self.z):  # the check of the least step tells
                break
            self.segment.run(self.z, 1)
            self._keep()
        if self.happenings.lie_within(self.z):
            self._take_event(self.happenings.happen(self.z, happened))
        return True

    @property
    def happenings(self) -> EventActions:
        """Of the segment that is stepped."""
        if self._happened is None or self._happened.own is not self.segment:
            self._happened = EventActions(self.segment)
        return self._happened

    def _take_event(self, w: np.ndarray | None) -> None:
        """What has happened: w (n_w,), the inputs where they have changed."""
        happened = self.happenings
        self.events += happened.told
        happened.told.clear()
        if w is not None:
            for segment in self.record.segments:
                segment.take_inputs(w)
        self.earlier = None
        note_impulses(self.segment, self.step, self.events)
        self.status = self._checked() or happened.status

    def _checked(self, closely: bool = False, samples: int = 1) -> Status | None:
        closely = closely or self.pace.slow(self.step - 1) or self.step == self.segment.plan.steps
        return self.segment.monitor.after(self._state, closely, samples)

    def _pass(self, before: np.ndarray, n: int) -> None:
        """The determinant of a loop block is small on the way from `before`: decide there how to go on."""
        self.z = before.copy()  # what Ctrl-C during the search leaves
        locate = opened("runtime.running.singular.passage:locate")
        z, previous, alarm = locate(self.segment, self.guard, self.earlier, before, n)
        if not alarm:
            self.z, self.earlier = z, before
            return
        if self.guard.threshold < FLOOR:
            self._step_unguarded(z)
            return
        asked, happened = lambda: self._interrupts.asked, self.happenings
        passage = opened("runtime.running.singular.passage:Passage")
        way = passage(self.segment, self.guard, self.record.segments, self.problem.engine, asked, happened)
        found = way.go_on(z if previous is None else previous)
        if self._left.get(id(found.segment)) == found.segment.step_of(found.z):  # exchanges would go in a circle
            self._step_unguarded(z if previous is None else previous)
            return
        if found.event is not None and (
            found.event.kind != "no_variant" or not any(event.text == found.event.text for event in self.events)
        ):  # said once
            happened.told.append(found.event)
        self.events += sorted(happened.told, key=lambda event: event.time)
        happened.told.clear()
        if found.drop_from is None and found.status is None:  # look again later
            self.z, self.earlier = z, previous
            return
        if found.drop_from is not None:
            self.record.drop_from(found.drop_from)
            if self.marks is not None:
                self.marks.drop_from(found.drop_from)
        for sample in found.samples:
            self._keep(sample[None])
        self.status = found.status
        if found.segment is not self.segment:
            self._left[id(self.segment)] = found.segment.step_of(found.z)
            self.segment, self.guard = found.segment, found.segment.new_guard()
            if found.segment not in self.record.segments:
                self.record.segments.append(found.segment)
        self.z, self.earlier = found.z, None

    def _step_unguarded(self, z: np.ndarray) -> None:
        """A step that nothing better was found for: if the other checks find nothing wrong, the branch is lost."""
        self.z, self.earlier = z, None
        good, time_ = z.copy(), self.segment.plan.time(self.segment.step_of(z))
        self.segment.run(self.z, 1)
        self.status = self._checked(closely=True)
        if self.status is None:
            self.z = good
            self.status = lost_unguarded(time_)

    def _batch(self) -> int:
        plan, done = self.segment.plan, self.step
        n = min(self.pace.next_steps(done, plan.seen_steps), plan.steps - done)
        if self.marks is not None and self.pace.slow(done):  # no state is kept on the way then
            n = min([n, *(mark - done for mark in self.marks.within(done, done + n))])
        if self.schedule is not None:
            n = min(n, self.schedule.until_next(done) or n)
        every = self.further.checkpoint_every
        return n if every is None else min(n, every - done % every)

    def _kept(self, n: int) -> list[int]:
        """Steps within the next n that are saved or at marks, and the last of these."""
        done, every = self.step, self.segment.plan.seen_steps
        marks = [] if self.marks is None else self.marks.within(done, done + n)
        return sorted({*range(done + every - done % every, done + n, every), *marks, done + n})

    def _keep(self, rows: np.ndarray | None = None) -> None:
        """Of the states (N, n_z), or of z, those that are to be saved, or are at marks."""
        if self.status is not None:
            return
        plan, kept = self.segment.plan, self.z[None] if rows is None else rows
        steps = kept[:, 1].astype(int)
        due = (steps % plan.seen_steps == 0) | (steps == plan.steps)
        if due.any():
            self.record.add(self.segment, kept[due])
        if self.marks is not None:
            self.marks.look(self.segment, kept)

    # ---- checkpoints ----------------------------------------------------------------------------------------

    def _checkpoint_is_due(self) -> bool:
        every = self.further.checkpoint_every
        if self.further.checkpoint is None or every is not None:
            return every is not None and self.step % every == 0
        return time.monotonic() - self._written > CHECKPOINT_SECONDS

    def _write_checkpoint(self) -> None:
        if self.further.checkpoint is None:
            return
        self.record.flush()  # a stream that takes no more ends the run
        try:
            opened("runtime.running.checkpoint:checkpoint_of")(self).write(self.further.checkpoint)
        except OutputError as error:  # what is in memory is worth more than its copy on the disk
            if not any(event.kind == "checkpoint_failed" for event in self.events):
                self.events.append(Event(self.segment.plan.time(self.step), "checkpoint_failed", str(error)))
        self._written = time.monotonic()


# A run at its start: prepared, compiled, checked, and ready to go.

ROUNDING = 1e-13  # m or rad: less is the dust of an assembly


def begun(
    problem: Problem, plan: Plan, marks: Marks | None, further: Further | None = None, quiet: bool = False
) -> Run:
    """The run of a plan at its checked start. quiet: of a companion or a rung, whose steps may miss what loads do.

    Raises ModelError, OutputError or CompilerError.
    """
    started = time.perf_counter()
    state, further = problem.state, (further or Further()).checked()
    segment = SteppedModel.of_run(problem.model, plan, problem.p, problem.engine, state)
    events = [Event(plan.t0, kind, text) for kind, text in state.told]
    if not quiet:
        events += check_time_functions(problem.model, segment.c, plan, state, segment.switches)
    z = segment.start(state.q, state.q_dot)
    changes = ", ".join(f"{key}: {a:.9g} -> {b:.9g}" for key, (a, b) in state.changed.items() if _differ(a, b))
    record = record_of(segment, z, further.stream, keep_rows=further.bounded)
    run = Run(
        problem,
        segment,
        z,
        record,
        further,
        changes or "none",
        events,
        guard=segment.new_guard(),
        marks=marks,
    )
    run.settle(told=False)
    with record.closed_on_error():
        run.status = run.status or segment.monitor.first(segment.state(z))
        record.add(segment, z[None])
        run.schedule = with_reads(problem.schedule(plan.grid.dt_L), run)
    run.set_up = time.perf_counter() - started
    return run


def with_reads(schedule: Schedule, run: Run) -> Schedule | None:
    """The schedule for a run, None if it changes nothing. Raises SchemeError for a checkpoint with an unkept memory."""
    for controller in schedule.controllers:
        if controller.memory is None and run.further.checkpoint is not None:
            raise SchemeError(
                "checkpoint",
                f"what the controller of {controller.name!r} remembers cannot be kept",
                "give its numbers as Sampled(..., memory=[...]), memory=() if it has none, or leave the checkpoint out",
            )
        controller.read_from(run.segment.model, run.segment.plan.scheme, run.segment.c)
    return schedule if schedule.samples or schedule.controllers else None


def _differ(given: float, used: float) -> bool:
    """Do two values differ in one of nine digits, and by more than rounding where one of them is zero?"""
    return f"{given:.9g}" != f"{used:.9g}" and abs(given - used) > ROUNDING


# States of a run at marks: times at which two ways to make one motion are compared.


@dataclass
class Marks:
    """States of a run at marks: every so many steps, and every `early` ones until the first of them (0: none)."""

    every: int
    early: int = 0
    states: dict[int, tuple[SteppedModel, np.ndarray]] = field(default_factory=dict)

    def within(self, first: int, last: int) -> list[int]:
        """Steps between two that are at a mark, these left out."""
        early = range(first + self.early - first % self.early, min(last, self.every), self.early) if self.early else ()
        return [*early, *range(first + self.every - first % self.every, last, self.every)]

    def look(self, segment: SteppedModel, rows: np.ndarray) -> None:
        """Keep those of the states (N, n_z) that are at a mark."""
        size = segment.plan.scheme.layout.size
        for row in rows:
            step = segment.step_of(row)
            if step and self.within(step - 1, step + 1):
                self.states[step] = (segment, row[:size].copy())

    def drop_from(self, step: int) -> None:
        """Forget the states of this step and of later ones."""
        self.states = {at: one for at, one in self.states.items() if at < step}

    def arrays(self, segments: Sequence[SteppedModel]) -> dict[str, np.ndarray]:
        """What a checkpoint keeps of it: steps, places of the segments, and states one after another."""
        found = sorted(self.states.items())
        return {
            "mark_steps": np.array([step for step, _ in found], dtype=np.int64),
            "mark_segments": np.array([segments.index(segment) for _, (segment, _) in found], dtype=np.int64),
            "mark_states": np.concatenate([np.zeros(0), *(z for _, (_, z) in found)]),
        }

    def restore(self, arrays: Mapping[str, np.ndarray], segments: Sequence[SteppedModel]) -> None:
        """From `arrays`."""
        first = 0
        for step, k in zip(arrays["mark_steps"], arrays["mark_segments"], strict=True):
            segment = segments[int(k)]
            last = first + segment.plan.scheme.layout.size
            self.states[int(step)] = (segment, arrays["mark_states"][first:last])
            first = last

    def told(self, steps: Sequence[int], model: Model, rates: bool = False) -> np.ndarray:
        """(N, n_told) what tells the motion of a model at these steps, whatever q_i they were stepped with.

        rates: the rates of that instead.
        """
        rows: dict[int, np.ndarray] = {}
        for segment in {id(self.states[step][0]): self.states[step][0] for step in steps}.values():
            own = [step for step in steps if self.states[step][0] is segment]
            rows |= dict(
                zip(own, told_by(segment, np.array([self.states[step][1] for step in own]), model, rates), strict=True)
            )
        return np.array([rows[step] for step in steps])


def told_by(segment: SteppedModel, states: np.ndarray, model: Model, rates: bool = False) -> np.ndarray:
    """(N, n_told) what tells the motion of a model, of states (N, n_z) of a segment, which may have other q_i.

    rates: the rates of that instead.
    """
    scheme = segment.plan.scheme
    seen = evaluate(scheme.observer, {"z": states}, scheme.constants(segment.c))
    names = ("q_i_dot", "q_d_dot") if rates else ("q_i", "q_d")
    return whole(segment.model, *(seen[name] for name in names))[:, followed(model)[1]]
