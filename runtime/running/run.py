"""A run: a problem is set up, stepped to its end, to trouble or to Ctrl-C, and what is seen on the way is kept."""

from __future__ import annotations

import signal
import threading
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from types import FrameType
from typing import Self

import numpy as np

from runtime.contract.consistent_state import start_events
from runtime.contract.files import OutputError
from runtime.contract.status import Event, Status
from runtime.running.events import EventHandler, ImpulseNotes, rest_until
from runtime.running.inputs import EndlessInput, Schedule
from runtime.running.monitor import Failure
from runtime.running.problem import Plan, Problem, whole_number
from runtime.running.record import Marks, Record
from runtime.running.recording import record_of
from runtime.running.singular.singularity_monitor import SingularityMonitor
from runtime.running.stepped_model import SteppedModel
from runtime.running.time_functions import check_time_functions
from runtime.schemes.options import SchemeError
from runtime.solutions.solution import Solution

# ---- How long a native call lasts, so that progress and Ctrl-C stay responsive, and who hears Ctrl-C ------------

CALL_SECONDS = 0.25  # a call lasts about this long
OPERATIONS = 5_000_000  # of a first call
LONGEST_CALL = 1 << 20
FIRST_SAVED = 32  # of the first look: what goes wrong and heals within a chunk is not seen
FINER = 8  # times shorter: a chunk that is made again where there is trouble between two saved states
MOST_SAVED = 256  # states that are saved between two looks


@dataclass
class ChunkLength:
    """steps: most of a call; saves: the save at which it ends; slow_until: until then it ends at the next one; finer:
    or after so many steps, if any.

    Looks cost as much as some hundred steps of a small mechanism, so there are few of them while all is well.
    """

    steps: int
    saves: int = FIRST_SAVED
    slow_until: int = 0
    finer: int = 0

    @classmethod
    def of(cls, operations: int) -> ChunkLength:
        """Of steps that take so many operations."""
        return cls(max(1, 1 << (OPERATIONS // max(1, operations)).bit_length() - 1))

    def slow(self, step: int) -> bool:
        """Is each saved state looked at closely here?"""
        return step < self.slow_until

    def next_steps(self, step: int, seen_steps: int) -> int:
        """The length of the next call."""
        slow = self.slow(step)
        most = min(self.steps, (1 if slow else self.saves) * seen_steps - step % seen_steps)
        return min(most, self.finer) if slow and self.finer else most

    def took(self, seconds: float) -> None:
        """Double or halve: the interpreted engine builds one Function per batch length, so there should be few."""
        if seconds < CALL_SECONDS / 4:
            self.steps = min(self.steps * 2, LONGEST_CALL)
        elif seconds > CALL_SECONDS:
            self.steps = max(1, self.steps // 2)

    def went_well(self) -> None:
        """Nothing was found: look at twice as many saved states at once."""
        self.saves = min(2 * self.saves, MOST_SAVED)

    def went_wrong(self, until: int, finer: int = 0) -> None:
        """Steps until there are made again, one save at a time, or so many steps."""
        self.saves, self.slow_until, self.finer = 1, until, finer


class Interrupts:
    """Hears Ctrl-C inside a `with`. asked: was it pressed? A second press stops at once.

    Outside the main thread, and where the caller has a handler, nothing changes.
    """

    asked = False
    _ours = False

    def __enter__(self) -> Self:
        own = signal.getsignal(signal.SIGINT) is signal.default_int_handler
        self._ours = own and threading.current_thread() is threading.main_thread()
        if self._ours:
            signal.signal(signal.SIGINT, self._heard)
        return self

    def __exit__(self, *_: object) -> None:
        if self._ours:
            signal.signal(signal.SIGINT, signal.default_int_handler)

    def _heard(self, number: int, frame: FrameType | None) -> None:
        if self.asked:
            raise KeyboardInterrupt
        self.asked = True


# ---- A run ----------------------------------------------------------------------------------------------------------

Progress = Callable[[float, float], None]
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
            from runtime.running.checkpoint import claim

            claim(self.checkpoint)
        return self


@dataclass
class Run:
    """A run of a problem under way, and all of its state: z (flat) belongs to `segment`.

    initial_changes: what of the start was corrected. earlier: a state of the segment at least a step before z, if there
    is one. left: the step at which segments, by identity, were left last. set_up, seconds: that it took to come to the
    start, and that its steps took.
    """

    problem: Problem
    segment: SteppedModel
    z: np.ndarray
    record: Record
    further: Further
    initial_changes: str
    chunk_length: ChunkLength
    events: list[Event] = field(default_factory=list)
    status: Status | None = None
    singularity: SingularityMonitor = field(default_factory=SingularityMonitor)
    marks: Marks | None = None
    schedule: Schedule | None = None
    earlier: np.ndarray | None = None
    interrupts: Interrupts = field(default_factory=Interrupts)
    left: dict[int, int] = field(default_factory=dict)
    set_up: float = 0.0
    seconds: float = 0.0
    written: float = 0.0  # when a checkpoint was, by time.monotonic
    _event_handler: EventHandler | None = None
    _notes: ImpulseNotes = field(default_factory=ImpulseNotes)

    @property
    def plan(self) -> Plan:
        """Of the segment."""
        return self.segment.plan

    @property
    def step(self) -> int:
        """Major steps done."""
        return int(self.z[1])

    @property
    def event_handler(self) -> EventHandler:
        """Of the segment that is stepped."""
        if self._event_handler is None or self._event_handler.own is not self.segment:
            self._event_handler = EventHandler(self.segment)
        return self._event_handler

    def seen(self) -> Solution:
        """What was kept, with the state that it has come to."""
        return self.record.solution((self.record.segments.index(self.segment), self.segment.state(self.z)))

    def failed(self, check: str, *found: str, step: int | None = None) -> Status:
        """What it means that a check failed at a step, or here."""
        time_, monitor = self.plan.time(self.step if step is None else step), self.segment.monitor
        from runtime.running.diagnose import diagnose

        return diagnose(Failure(check, None, found), time_, monitor)

    def checked(self, closely: bool = False, samples: int = 1) -> Status | None:
        """What the checks find at z, which goes back to the last good state where they find anything."""
        closely = closely or self.chunk_length.slow(self.step - 1) or self.step == self.plan.steps
        return self.segment.monitor.after(self.segment.state(self.z), closely, samples)

    def near_singular(self) -> bool:
        """Was a determinant of a loop block small in the last steps?"""
        return self.singularity.near_singular(*self.segment.determinants(self.z))

    # ---- inputs and events -----------------------------------------------------------------------------------

    def take_inputs(self) -> None:
        """What is sampled at this step."""
        if self.schedule is None:
            return
        self.plan.scheme.land(self.z)
        own = self.plan.scheme.layout.slice("inputs")
        w = self.schedule.apply(self.step, self.plan.time(self.step), self.segment.state(self.z), self.z[own].copy())
        if w is not None:
            seen, c = self.segment.state(self.z).copy(), self.plan.scheme.constants(self.segment.c).copy()
            self.segment.note_change(self.plan.time(self.step), seen, c, w, np.zeros(len(self.segment.model.q_i)))
            self.segment.hold(self.z, w)
            self._hold(w)
            self.segment.look_anew(self.z)
            self.settle()

    def settle(self, told: bool = True) -> None:
        """Decide which elements stick from here on, if there are any."""
        if not self.segment.model.element_modes.size:
            return
        self._hold(self.event_handler.settle(self.z))
        if not told:
            self.segment.impulses.clear()  # the first sample shows what is after them
        self._tell(told)
        self.status = self.status or self.event_handler.status

    def to_event(self, at: int, before: np.ndarray, rows: np.ndarray) -> np.ndarray | None:
        """Step to the event that was flagged in step `at` of a chunk from `before`, whose states are rows (N, n_z).

        None where it has happened, else those up to the step before it; the next chunk is that step.
        """
        handler, first = self.event_handler, int(before[1]) + 1
        if self.plan.scheme.adaptive:
            return None if self._ends_at_event(rows) else np.vstack([rows[:-1], self.z])
        self.chunk_length.steps, self.z = 1, before.copy()
        if at > first:
            return self.segment.run_and_save(self.z, self.to_be_seen(at - first))
        self.segment.forget_determinants(self.z)
        w = handler.step(self.z)
        if not handler.told and handler.status is None:
            return self.z[None]
        self._event_has_happened(w)
        return None

    def _ends_at_event(self, rows: np.ndarray) -> bool:
        """Does the last step of a tolerance end at an event? Then what lies before it is seen first."""
        happened, scheme = self.event_handler.end_step(self.z), self.plan.scheme
        if not happened:
            return False
        self.chunk_length.steps = 1
        self.keep(rows[:-1])
        while self.step < self.plan.steps and self._next_seen() <= scheme.reached(self.z):
            if scheme.hit_min_step(self.z):  # the check of the least step tells
                break
            self.segment.run(self.z, 1)
            self.keep(self.z[None])
        if self.event_handler.lie_within(self.z):
            self._event_has_happened(self.event_handler.happen(self.z, happened))
        return True

    def _next_seen(self) -> float:
        """Time of the next state that is seen [s]."""
        return min(self.plan.scheme.next_seen(self.z, self.plan.grid.dt_L), self.plan.t_end)

    def _event_has_happened(self, w: np.ndarray | None) -> None:
        """w (n_w,): the inputs where they have changed."""
        self._tell()
        self._hold(w)
        self.earlier = None
        self.note_impulses()
        self.status = self.checked() or self.event_handler.status

    def note_impulses(self) -> None:
        """Tell those of prescribed motions until here."""
        self._notes.note(self.segment, self.step, self.events)

    def _tell(self, told: bool = True) -> None:
        self.events += [event for event in self.event_handler.told if told or event.kind != "mode"]
        self.event_handler.told.clear()

    def _hold(self, w: np.ndarray | None) -> None:
        """From now on all segments have these inputs (n_w,)."""
        if w is not None:
            for segment in self.record.segments:
                segment.take_inputs(w)

    # ---- what is seen and kept -------------------------------------------------------------------------------

    def next_chunk(self) -> int:
        """How many steps the next native call makes: up to the next thing that anybody wants to see."""
        done, every = self.step, self.further.checkpoint_every
        n = min(self.chunk_length.next_steps(done, self.plan.seen_steps), self.plan.steps - done)
        if self.marks is not None and self.chunk_length.slow(done):  # no state is kept on the way then
            n = min([n, *(mark - done for mark in self.marks.within(done, done + n))])
        if self.schedule is not None:
            n = min(n, self.schedule.until_next(done) or n)
        return n if every is None else min(n, every - done % every)

    def to_be_seen(self, n: int) -> list[int]:
        """Steps within the next n that are saved or at marks, and the last of these."""
        done, every = self.step, self.plan.seen_steps
        marks = [] if self.marks is None else self.marks.within(done, done + n)
        return sorted({*range(done + every - done % every, done + n, every), *marks, done + n})

    def keep(self, rows: np.ndarray) -> None:
        """Of the states (N, n_z) those that are to be saved, or are at marks."""
        if self.status is not None:
            return
        steps = rows[:, 1].astype(int)
        for kept in (self.record, self.marks):
            if kept is not None:
                kept.add(self.segment, rows[kept.due(steps)])

    def report(self) -> None:
        """A checkpoint where one is due, and progress."""
        if self.further.checkpoint is not None and self.status is None and self.step < self.plan.steps:
            every = self.further.checkpoint_every
            if self.step % every == 0 if every is not None else time.monotonic() - self.written > CHECKPOINT_SECONDS:
                self.write_checkpoint()
        if callable(self.further.progress):
            self.further.progress(self.plan.time(self.step), self.plan.t_end)

    def write_checkpoint(self) -> None:
        """Where one is wanted. Raises OutputError where a stream takes no more."""
        if self.further.checkpoint is None:
            return
        self.record.flush()
        try:
            from runtime.running.checkpoint import checkpoint_of

            checkpoint_of(self).write(self.further.checkpoint)
        except OutputError as error:  # what is in memory is worth more than its copy on the disk
            if not any(event.kind == "checkpoint_failed" for event in self.events):
                self.events.append(Event(self.plan.time(self.step), "checkpoint_failed", str(error)))
        self.written = time.monotonic()


def integrate(run: Run) -> Status:
    """Step to the end of the plan, to trouble or to Ctrl-C; the record ends with the last good state.

    One native call makes a chunk of steps, whose states to be seen are rows. A chunk that ends in trouble is made
    again, state by state and in the end step by step, so that the trouble is found where it begins. Whatever
    happens is decided by states alone.
    """
    began, run.written = time.perf_counter(), time.monotonic()
    with run.interrupts:
        try:
            while run.status is None and run.step < run.plan.steps and not run.interrupts.asked:
                run.take_inputs()
                clock, n = time.perf_counter(), run.next_chunk()
                before, known = run.z.copy(), run.segment.monitor.memory()
                seen = run.segment.run_and_save(run.z, run.to_be_seen(n))
                rows: np.ndarray | None = seen
                at, near_singular = run.segment.first_event(run.z), run.near_singular()
                if at is not None and not near_singular:  # a singular position comes first
                    rows, near_singular = run.to_event(at, before, seen), run.near_singular()
                    n = n if run.plan.scheme.adaptive else max(1, at - 1 - int(before[1]))
                status = None if rows is None or near_singular else run.checked(samples=len(rows))
                if rows is None:
                    run.keep(run.z[None])  # an event has happened: what it leads to is checked
                elif len(rows) > 1 and (near_singular or status is not None):
                    run.chunk_length.went_wrong(until=int(before[1]) + n)
                    run.segment.monitor.recall(known)
                    run.z = before
                elif status is not None and n > 1:  # where it begins does not depend on what is saved
                    run.chunk_length.went_wrong(until=int(before[1]) + n, finer=max(1, n // FINER))
                    run.segment.monitor.recall(known)
                    run.z = before
                elif near_singular:
                    from runtime.running.singular.passage import pass_by

                    pass_by(run, before, n)
                    run.keep(run.z[None])
                elif status is not None:
                    run.status = status
                else:
                    run.singularity.accept(*run.segment.determinants(run.z))
                    run.earlier = before
                    run.chunk_length.went_well()
                    run.keep(rows)
                    run.note_impulses()
                run.chunk_length.took(time.perf_counter() - clock)
                run.report()
        except KeyboardInterrupt:
            run.interrupts.asked = True
        except EndlessInput as error:
            run.status = error.status
        except OutputError as error:
            run.status = output_failed(run, error)
        if run.status is None and run.step < run.plan.steps:
            run.status = run.checked(closely=True)
            if run.status is None:
                run.status = run.failed("user")
                run.write_checkpoint()
    if run.status is not None:  # end with the last good state, which need not be one that was to be saved
        run.record.drop_from(run.step)
        run.record.add(run.segment, run.z[None])
    try:
        run.record.flush()
    except OutputError as error:
        run.status = output_failed(run, error)
    run.seconds += time.perf_counter() - began
    return run.status or Status("completed", run.plan.t_end)


def output_failed(run: Run, error: OutputError) -> Status:
    """The place for the samples takes no more: those that wait are lost, the state is not."""
    run.record.samples = []
    return run.failed("output", str(error))


ROUNDING = 1e-13  # m or rad: less is the dust of an assembly


def begun(
    problem: Problem,
    plan: Plan,
    marks: Marks | None,
    further: Further | None = None,
    quiet: bool = False,
    like: Run | None = None,
) -> Run:
    """The run of a plan at its checked start. quiet: of a companion or a rung, whose steps may miss what loads do.

    like: a run of the problem with other steps, by whose start it is known to be sound.

    Raises ModelError, OutputError or CompilerError.
    """
    started = time.perf_counter()
    state, further = problem.state, (further or Further()).checked()
    segment = SteppedModel.of_run(problem.model, plan, problem.p, problem.engine, state)
    events = start_events(state, plan.t0)
    if not quiet:
        events += check_time_functions(problem.model, segment.c, plan, state, segment.switches)
    z = segment.start(state.q, state.q_dot)
    rest_until(plan.scheme, z, problem.quiet)
    changes = ", ".join(f"{key}: {a:.9g} -> {b:.9g}" for key, (a, b) in state.changed.items() if _differ(a, b))
    record = record_of(segment, z, further.stream, keep_rows=further.bounded)
    chunk_length = ChunkLength.of(segment.stepper.operations)
    singularity = SingularityMonitor.of(len(segment.determinants(z)[0]))
    run = Run(
        problem,
        segment,
        z,
        record,
        further,
        changes or "none",
        chunk_length,
        events,
        singularity=singularity,
        marks=marks,
    )
    if marks is not None:
        marks.segments = record.segments
    run.settle(told=False)
    with record.closed_on_error():
        known = None if like is None else like.record.segments[0].monitor
        run.status = run.status or segment.monitor.first(segment.state(z), known)
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
        controller.read_from(run.segment.plan.scheme, run.segment.c)
    return schedule if schedule.samples or schedule.controllers else None


def _differ(given: float, used: float) -> bool:
    """Do two values differ in one of nine digits, and by more than rounding where one of them is zero?"""
    return f"{given:.9g}" != f"{used:.9g}" and abs(given - used) > ROUNDING
