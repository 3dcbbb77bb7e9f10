"""A run: a problem is set up, stepped to its end, to trouble or to Ctrl-C, and what is seen on the way is kept."""

from __future__ import annotations

import time
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from runtime.contract.consistent_state import start_events
from runtime.contract.files import OutputError
from runtime.contract.status import Event, Status
from runtime.running.chunk_length import SHORTER_CHUNK, ChunkLength
from runtime.running.events import EventHandler, ImpulseNotes, rest_until
from runtime.running.inputs import EndlessInput, Schedule
from runtime.running.interrupts import Interrupts
from runtime.running.monitor import Failure, Monitor
from runtime.running.problem import Plan, Problem
from runtime.running.record import ComparisonTimes, Record
from runtime.running.recording import record_of
from runtime.running.run_options import RunOptions
from runtime.running.singular.singularity_monitor import SingularityMonitor
from runtime.running.step_driver import StepDriver, StepsToEvent
from runtime.running.stepped_model import MOST_HALVINGS, MOST_IN_A_ROW, SteppedModel
from runtime.running.time_functions import check_time_functions
from runtime.schemes.options import SchemeError
from runtime.solutions.solution import Solution

if TYPE_CHECKING:
    from runtime.running.singular.singular_crossing import Continuation

CHECKPOINT_SECONDS = 60.0
ASSEMBLY_ROUNDING = 1e-13  # m or rad: less is the dust of an assembly


class Chunk(NamedTuple):
    """Steps that one native call makes, from the state `before`; memory: of the monitor there."""

    steps: int
    before: np.ndarray
    memory: dict[str, list[float]]

    @property
    def end(self) -> int:
        """The step at which it ends."""
        return int(self.before[1]) + self.steps


@dataclass
class Run:
    """A run of a problem under way, and all of its state: z (flat) belongs to `segment`.

    initial_changes: what of the start was corrected. earlier: a state of the segment at least a step before z, if
    there is one. left: the step at which segments, by identity, were left last. started: when it was begun to be
    set up, by time.perf_counter; set_up, seconds: that it took to come to the start, and that its steps took.
    """

    problem: Problem
    segment: SteppedModel
    z: np.ndarray
    record: Record
    run_options: RunOptions
    initial_changes: str
    chunk_length: ChunkLength
    events: list[Event] = field(default_factory=list)
    status: Status | None = None
    singularity: SingularityMonitor = field(default_factory=SingularityMonitor)
    comparison_times: ComparisonTimes | None = None
    schedule: Schedule | None = None
    earlier: np.ndarray | None = None
    interrupts: Interrupts = field(default_factory=Interrupts)
    left: dict[int, int] = field(default_factory=dict)
    started: float = field(default_factory=time.perf_counter)
    set_up: float = 0.0
    seconds: float = 0.0
    written: float = 0.0  # when a checkpoint was, by time.monotonic
    _driver: StepDriver | None = None
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
    def driver(self) -> StepDriver:
        """Of the segment that is stepped."""
        if self._driver is None or self._driver.own is not self.segment:
            self._driver = StepDriver(self.segment)
        return self._driver

    @property
    def event_handler(self) -> EventHandler:
        """Of the segment that is stepped."""
        return self.driver.event_handler

    def sampled_solution(self) -> Solution:
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

    # ---- from chunk to chunk ---------------------------------------------------------------------------------

    def start(self, schedule: Schedule, like: Monitor | None = None) -> None:
        """Settle what sticks at the first state, look at it, and keep it. like: who has looked at the same start."""
        self.settle(reported=False)
        with self.record.closed_on_error():
            self.status = self.status or self.segment.monitor.first(self.segment.state(self.z), like)
            self.record.add(self.segment, self.z[None])
            self.follow(schedule)

    def follow(self, schedule: Schedule) -> None:
        """Take inputs from a schedule. Raises SchemeError for a checkpoint that cannot keep a controller's memory."""
        for controller in schedule.controllers:
            if controller.memory is None and self.run_options.checkpoint is not None:
                raise SchemeError(
                    "checkpoint",
                    f"what the controller of {controller.name!r} remembers cannot be kept",
                    "give its numbers as Sampled(..., memory=[...]), memory=() if it has none, or leave the checkpoint "
                    "out",
                )
            controller.read_from(self.segment.plan.scheme, self.segment.c)
        self.schedule = schedule if schedule.samples or schedule.controllers else None

    def integrate(self) -> Status:
        """Step to the end of the plan, to trouble or to Ctrl-C; the record ends with the last good state."""
        began, self.written = time.perf_counter(), time.monotonic()
        self.set_up = self.set_up or began - self.started
        with self.interrupts:
            try:
                while self.status is None and self.step < self.plan.steps and not self.interrupts.asked:
                    self.take_inputs()
                    self._advance()
                    self.report()
            except KeyboardInterrupt:
                pass  # a second Ctrl-C: what is there is kept
            except EndlessInput as error:
                self.status = error.status
            except OutputError as error:
                self._lose_samples(error)
            if self.status is None and self.step < self.plan.steps:
                self._stop_here()
        self._end()
        self.seconds += time.perf_counter() - began
        return self.status or Status("completed", self.plan.t_end)

    def _advance(self) -> None:
        """Make a chunk of steps in one native call, and accept it or act on what is found at its end.

        A chunk that ends in trouble is made again, state by state and in the end step by step, so that the trouble is
        found where it begins. Whatever happens is decided by states alone.
        """
        clock = time.perf_counter()
        chunk = Chunk(self.next_chunk(), self.z.copy(), self.segment.monitor.memory())
        if self.event_handler.native and self._passes_through_events(chunk):
            self.chunk_length.took(time.perf_counter() - clock)
            return
        self.segment.forget_determinants(self.z)
        made = self.driver.to_event(self.z, self.steps_to_sample(chunk.steps), self.near_singular)
        rows: np.ndarray | None = made.rows
        if made.event is not None:
            rows = self._at_event(made)
            if not self.plan.scheme.adaptive:
                chunk = chunk._replace(steps=max(1, made.event - 1 - int(chunk.before[1])))
        near_singular, unconverged = self.near_singular(), not self.driver.converged(self.z)
        status = None if rows is None or near_singular else self.checked(samples=len(rows))
        if rows is None:
            self.keep(self.z[None])  # an event has happened: what it leads to is checked
        elif len(rows) > 1 and (near_singular or status is not None):
            self._make_again(chunk)
        elif status is not None and chunk.steps > 1:  # where it begins does not depend on what is saved
            self._make_again(chunk, finer=max(1, chunk.steps // SHORTER_CHUNK))
        elif near_singular:
            self._pass_by(chunk)
        elif status is not None and unconverged and self.driver.divide(chunk.before):
            self._make_again(chunk)
        elif status is not None:
            self.status = self._in_parts(status)
        else:
            self._accept(chunk, rows)
        self.chunk_length.took(time.perf_counter() - clock)

    def _passes_through_events(self, chunk: Chunk) -> bool:
        """Make the chunk with the events in it by one native call, or prepare to make finer ones where anything is
        found in it. False: it is one step, which is to be looked at closely.
        """
        self.segment.forget_determinants(self.z)
        passage = self.event_handler.through_events(self.z, self.steps_to_sample(chunk.steps))
        if passage is not None:
            self.z = passage.z.copy()
            if not self.near_singular() and self.checked(samples=len(passage.rows)) is None:
                self.z = chunk.before.copy()
                inputs = self.event_handler.accept(self.z, passage)
                self._report()
                self._hold(inputs)
                self._accept(chunk, passage.rows)
                if passage.records:
                    self.earlier = None
                return True
        self.z = chunk.before.copy()
        self.segment.monitor.recall(chunk.memory)
        if chunk.steps == 1:
            return False
        self._make_again(chunk, finer=max(1, chunk.steps // SHORTER_CHUNK))
        return True

    def _accept(self, chunk: Chunk, rows: np.ndarray) -> None:
        """Nothing was found in its states (N, n_z)."""
        self.singularity.accept(*self.segment.determinants(self.z))
        self.earlier = chunk.before
        self.chunk_length.went_well()
        self.keep(rows)
        self.note_impulses()

    def _make_again(self, chunk: Chunk, finer: int = 0) -> None:
        """Go back to before the chunk; its steps are made again one save at a time, or so many steps."""
        self.chunk_length.went_wrong(until=chunk.end, finer=finer)
        self.segment.monitor.recall(chunk.memory)
        self.z = chunk.before

    def _pass_by(self, chunk: Chunk) -> None:
        """A determinant of a loop block is small within the chunk: decide how the run goes on, and go on."""
        from runtime.running.singular.singular_crossing import continuation

        self.z = chunk.before.copy()  # what Ctrl-C during the search leaves
        found = continuation(self, chunk.before, chunk.steps)
        if found.monitored:
            self._go_on(found)
        else:
            self._step_unmonitored(found.z)
        self.status = self.status or self.checked()
        self.note_impulses()
        self.keep(self.z[None])

    def _go_on(self, found: Continuation) -> None:
        """Take over another segment, the states on the way, and what is told of them."""
        handler, event = self.event_handler, found.event
        if event is not None and (event.kind != "no_variant" or not any(event.text == one.text for one in self.events)):
            handler.reported.append(event)  # said once
        self.events += sorted(handler.reported, key=lambda event: event.time)
        handler.reported.clear()
        if found.drop_from is not None:
            self.record.drop_from(found.drop_from)
            if self.comparison_times is not None:
                self.comparison_times.drop_from(found.drop_from)
        for sample in found.samples:
            self.keep(sample[None])
        self.status = found.status
        if found.segment is not self.segment:
            self.left[id(self.segment)] = int(found.z[1])
            self.segment = found.segment
            self.singularity = SingularityMonitor.of(len(found.segment.determinants(found.z)[0]))
            if found.segment not in self.record.segments:
                self.record.segments.append(found.segment)
        self.z, self.earlier = found.z, found.earlier

    def _step_unmonitored(self, z: np.ndarray) -> None:
        """Step where nothing better was found: if the other checks find nothing wrong, the branch is lost."""
        self.z, self.earlier = z.copy(), None
        self.segment.run(self.z, 1)
        self.status = self.checked(closely=True)
        if self.status is None:
            self.z = z
            self.status = self.failed("branch")

    def _stop_here(self) -> None:
        """Ctrl-C was pressed: end with a state that is good, and a checkpoint."""
        self.status = self.checked(closely=True)
        if self.status is None:
            self.status = self.failed("user")
            self.write_checkpoint()

    def _end(self) -> None:
        """Write what waits; where it ended early, the last good state is kept, too."""
        if self.status is not None:
            self.record.drop_from(self.step)
            self.record.add(self.segment, self.z[None])
        try:
            self.record.flush()
        except OutputError as error:
            self._lose_samples(error)

    def _lose_samples(self, error: OutputError) -> None:
        """The place for the samples takes no more: those that wait are lost, the state is not."""
        self.record.forget_waiting()
        self.status = self.failed("output", str(error))

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

    def settle(self, reported: bool = True) -> None:
        """Decide which elements stick from here on, if there are any."""
        if not self.segment.model.element_modes.size:
            return
        self._hold(self.event_handler.settle(self.z))
        if not reported:
            self.segment.impulses.clear()  # the first sample shows what is after them
        self._report(reported)
        self.status = self.status or self.event_handler.status

    def _at_event(self, made: StepsToEvent) -> np.ndarray | None:
        """Where an event was flagged: None where it has happened, else the states (N, n_z) up to the step before it;
        the next chunk is the step with it.
        """
        if self.plan.scheme.adaptive:
            return None if self._ends_at_event(made.rows) else np.vstack([made.rows[:-1], self.z])
        self.chunk_length.steps = 1
        if len(made.rows):
            return made.rows
        w = self.driver.through_event(self.z)
        if not self.event_handler.reported and self.event_handler.status is None:
            return self.z[None]
        self._event_has_happened(w)
        return None

    def _in_parts(self, status: Status | None) -> Status | None:
        """The same; of a step that does not converge, with what its parts, or those of steps before it, have shown."""
        divisions = self.segment.divisions
        if status is None or status.name != "iteration_failed":
            return status
        if divisions.in_a_row > MOST_IN_A_ROW:
            return replace(status, cause=f"{status.cause}; {MOST_IN_A_ROW} steps before it did in shorter parts only")
        if divisions.halvings < MOST_HALVINGS:
            return status
        return replace(status, cause=f"{status.cause}, nor in parts of {self.plan.grid.dt_L / 2**MOST_HALVINGS:.3g} s")

    def _ends_at_event(self, rows: np.ndarray) -> bool:
        """Does the last step of a tolerance end at an event? Then what lies before it is seen first."""
        happened, scheme = self.event_handler.end_step(self.z), self.plan.scheme
        if not happened:
            return False
        self.chunk_length.steps = 1
        self.keep(rows[:-1])
        while self.step < self.plan.steps and self._next_sample() <= scheme.reached(self.z):
            if scheme.hit_min_step(self.z):  # the check of the least step tells
                break
            self.segment.run(self.z, 1)
            self.keep(self.z[None])
        if self.event_handler.lie_within(self.z):
            self._event_has_happened(self.event_handler.happen(self.z, happened))
        return True

    def _next_sample(self) -> float:
        """Time of the next state that is seen [s]."""
        return min(self.plan.scheme.next_sample(self.z, self.plan.grid.dt_L), self.plan.t_end)

    def _event_has_happened(self, w: np.ndarray | None) -> None:
        """w (n_w,): the inputs where they have changed."""
        self._report()
        self._hold(w)
        self.earlier = None
        self.note_impulses()
        own = self.event_handler.status
        failed = own is not None and not own.ok  # it knows the time
        self.status = own if failed else self._in_parts(self.checked()) or own

    def note_impulses(self) -> None:
        """Tell those of prescribed motions until here."""
        self._notes.note(self.segment, self.step, self.events)

    def _report(self, reported: bool = True) -> None:
        self.events += [event for event in self.event_handler.reported if reported or event.kind != "mode"]
        self.event_handler.reported.clear()

    def _hold(self, w: np.ndarray | None) -> None:
        """From now on all segments have these inputs (n_w,)."""
        if w is not None:
            for segment in self.record.segments:
                segment.take_inputs(w)

    # ---- what is seen and kept -------------------------------------------------------------------------------

    def next_chunk(self) -> int:
        """How many steps the next native call makes: up to the next thing that anybody wants to see."""
        done, every = self.step, self.run_options.checkpoint_every
        n = min(self.chunk_length.next_steps(done, self.plan.seen_steps), self.plan.steps - done)
        if self.comparison_times is not None and self.chunk_length.slow(done):  # no state is kept on the way then
            n = min([n, *(mark - done for mark in self.comparison_times.within(done, done + n))])
        if self.schedule is not None:
            n = min(n, self.schedule.until_next(done) or n)
        return n if every is None else min(n, every - done % every)

    def steps_to_sample(self, n: int) -> list[int]:
        """Steps within the next n that are saved or at comparison times, and the last of these."""
        done, every = self.step, self.plan.seen_steps
        comparison_times = [] if self.comparison_times is None else self.comparison_times.within(done, done + n)
        return sorted({*range(done + every - done % every, done + n, every), *comparison_times, done + n})

    def keep(self, rows: np.ndarray) -> None:
        """Of the states (N, n_z) those that are to be saved, or are at comparison times."""
        if self.status is not None:
            return
        steps = rows[:, 1].astype(int)
        for kept in (self.record, self.comparison_times):
            if kept is not None:
                kept.add(self.segment, rows[kept.due(steps)])

    def report(self) -> None:
        """A checkpoint where one is due, and progress."""
        if self.run_options.checkpoint is not None and self.status is None and self.step < self.plan.steps:
            every = self.run_options.checkpoint_every
            if self.step % every == 0 if every is not None else time.monotonic() - self.written > CHECKPOINT_SECONDS:
                self.write_checkpoint()
        if callable(self.run_options.progress):
            self.run_options.progress(self.plan.time(self.step), self.plan.t_end)

    def write_checkpoint(self) -> None:
        """Where one is wanted. Raises OutputError where a stream takes no more."""
        if self.run_options.checkpoint is None:
            return
        self.record.flush()
        try:
            from runtime.running.checkpoint import checkpoint_of

            checkpoint_of(self).write(self.run_options.checkpoint)
        except OutputError as error:  # what is in memory is worth more than its copy on the disk
            if not any(event.kind == "checkpoint_failed" for event in self.events):
                self.events.append(Event(self.plan.time(self.step), "checkpoint_failed", str(error)))
        self.written = time.monotonic()


def start_run(
    problem: Problem,
    plan: Plan,
    comparison_times: ComparisonTimes | None,
    run_options: RunOptions | None = None,
    quiet: bool = False,
    like: Run | None = None,
) -> Run:
    """The run of a plan at its checked start. quiet: of a companion or a level, whose steps may miss what loads do.

    like: a run of the problem with other steps, by whose start it is known to be sound.

    Raises ModelError, OutputError or CompilerError.
    """
    started = time.perf_counter()
    state, run_options = problem.state, (run_options or RunOptions()).checked()
    segment = SteppedModel.of_run(problem.model, plan, problem.p, problem.engine, state)
    events = start_events(state, plan.t0)
    if not quiet:
        events += check_time_functions(problem.model, segment.c, plan, state, segment.switches)
    z = segment.start(state.q, state.q_dot)
    rest_until(plan.scheme, z, problem.quiet)
    changes = ", ".join(f"{key}: {a:.9g} -> {b:.9g}" for key, (a, b) in state.changed.items() if _differ(a, b))
    record = record_of(segment, z, run_options.stream, keep_rows=run_options.bounded)
    chunk_length = ChunkLength.of(segment.stepper.operations)
    singularity = SingularityMonitor.of(len(segment.determinants(z)[0]))
    run = Run(
        problem,
        segment,
        z,
        record,
        run_options,
        changes or "none",
        chunk_length,
        events,
        singularity=singularity,
        comparison_times=comparison_times,
        started=started,
    )
    if comparison_times is not None:
        comparison_times.segments = record.segments
    run.start(problem.schedule(plan.grid.dt_L), None if like is None else like.record.segments[0].monitor)
    return run


def _differ(given: float, used: float) -> bool:
    """Do two values differ in one of nine digits, and by more than rounding where one of them is zero?"""
    return f"{given:.9g}" != f"{used:.9g}" and abs(given - used) > ASSEMBLY_ROUNDING
