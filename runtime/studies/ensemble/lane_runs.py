"""Runs in lanes of one ensemble: compiled once, then any cases, from any number of threads."""

from __future__ import annotations

import sys
from collections.abc import Callable
from dataclasses import dataclass, field
from math import ceil

import casadi as ca
import numpy as np

from runtime.contract.consistent_state import ConsistentState
from runtime.contract.model import EmittedModel
from runtime.contract.tape import read_tape
from runtime.engine.native import blocks_of
from runtime.running.events import state_of
from runtime.running.problem import Plan
from runtime.running.time_functions import all_stops
from runtime.schemes.switching.impulse import may_give_impulses
from runtime.schemes.switching.steps_with_stops import parts_of
from runtime.schemes.switching.stop_program import KNOWN_PARTS
from runtime.schemes.switching.times import Breaks, switching_times
from runtime.studies.ensemble.account import ALONE, FOUND, NAME, cause_of, judged
from runtime.studies.ensemble.ensemble_spec import EnsembleSpec
from runtime.studies.ensemble.lane_programs import LanePrograms, programs_of
from runtime.studies.ensemble.native_cases import NativeCases
from runtime.studies.ensemble.reductions import finished
from runtime.studies.ensemble.starts import Starts

LEAST_LANE_JOB = 256  # cases that a thread runs at a time, at least
JOB_SECONDS = 0.01  # of native code in a job: what Python does for one takes about 0.3 ms, and holds up other threads
LANE_JOB_BYTES = 1 << 23  # of rows and values
GPU_JOB_BYTES = 1 << 28  # of a job whose steps a GPU makes
JOBS_A_WORKER = 16  # where cases are few: no thread waits long for the last one, and Ctrl-C is heard
SECONDS_PER_OPERATION = 2.5e-11  # of a step of one lane
GPU_CASES = 100  # that a GPU steps in the time of one lane, at least
SECONDS_OF_CALL = 0.2  # s, so that Ctrl-C and progress are heard


TOLD = ("values", "status", "time", "errors", "steps", "steps_of_all_levels")  # of a case


@dataclass(frozen=True)
class LaneResults:
    """Of some cases: values (cases, width), how they ended, times reached [s]; alone: to be run by themselves.

    Of cases with a tolerance also errors (cases, 1 + outputs or reduced values), of the motion relative to its
    amplitudes and of each value in its unit, the steps of the level that answers and those of all levels (cases,).
    """

    values: np.ndarray
    status: np.ndarray
    time: np.ndarray
    alone: np.ndarray
    errors: np.ndarray = field(default_factory=lambda: np.zeros((0, 0)))
    steps: np.ndarray = field(default_factory=lambda: np.zeros(0, dtype=int))
    steps_of_all_levels: np.ndarray = field(default_factory=lambda: np.zeros(0, dtype=int))

    @property
    def kept(self) -> dict[str, np.ndarray]:
        """What is told of the cases, by name."""
        return {name: getattr(self, name) for name in TOLD}

    @staticmethod
    def none_yet(spec: EnsembleSpec, cases: int) -> LaneResults:
        """Of cases that were not run."""
        values, time = np.full((cases, spec.reported), np.nan), np.full(cases, spec.plan.t0)
        status, alone = np.full(cases, "interrupted", dtype=NAME), np.zeros(cases, dtype=bool)
        if spec.refinement is None:
            return LaneResults(values, status, time, alone)
        errors = np.full((cases, 1 + len(spec.reduced or spec.asked)), np.nan)
        steps, of_all_levels = np.zeros(cases, dtype=int), np.zeros(cases, dtype=int)
        return LaneResults(values, status, time, alone, errors, steps, of_all_levels)

    def put(self, first: int, part: LaneResults) -> None:
        """Results of the cases from `first` on."""
        for name, whole in self.kept.items():
            if len(whole):
                piece = getattr(part, name)
                whole[first : first + len(piece)] = piece


class LaneRuns:
    """Runs in lanes; width: how many go side by side (None: as this machine has it)."""

    def __init__(self, spec: EnsembleSpec, width: int | None = None) -> None:
        self.spec, self.steps = spec, spec.plan.steps
        self.programs = programs_of(spec) if width is None else LanePrograms(spec, width)
        self._native = NativeCases(self)
        self._z, self._c = self.programs.rows_of("lane").start, self.programs.rows_of("ready").start

    def job(self, cases: int, workers: int) -> int:
        """Cases of a job of a study: what one of so many threads runs at a time."""
        programs = self.programs
        if self.spec.device == "gpu":
            return max(LEAST_LANE_JOB, min(cases, GPU_JOB_BYTES // (8 * (programs.row.size + self.spec.width))))
        by_time = JOB_SECONDS / (SECONDS_PER_OPERATION * programs.operations * self.steps)
        by_room = LANE_JOB_BYTES / (8 * (programs.row.size + self.spec.width))
        wanted = ceil(min(by_time, by_room, cases / (JOBS_A_WORKER * workers)))
        return max(LEAST_LANE_JOB, -(-wanted // programs.width) * programs.width)

    def run(self, starts: Starts, stopped: Callable[[], bool] = lambda: False) -> LaneResults | None:
        """All runs of these cases; None if `stopped` said so on the way."""
        program = self.programs.stops
        stops, known = LaneStops(self.spec.plan, starts, () if program is None else program.part), 0
        blocks, cases = self.started(starts, stops.clocks), len(starts.close)
        alone = starts.close & ~(self.values(blocks, cases, "fits")[:, 0] > 0)
        if "settled" in self.programs.row.sizes:
            alone |= starts.settle & ~(self.values(blocks, cases, "settled")[:, 0] > 0)
        alone |= stops.alone | self._decided(blocks, cases)
        begun = self._native.states(blocks, cases) if self._native.possible else None
        monitor = _LaneMonitor(self._looked(blocks, cases))
        samples, done = self._first_samples(blocks, cases), 0
        for step, looking, sampled in self._stations():
            while done < step:
                if stopped():
                    return None
                n = min(step - done, self._longest(len(blocks)))
                if program is not None:
                    known = self._give(blocks, stops, done) if done == known else known
                    n = min(n, known - done)
                self.advance(blocks, n)
                done += n
            if sampled >= 0:
                samples[:, :, sampled] = self._observed(blocks, cases)
            if looking:
                monitor.look(self._looked(blocks, cases), step)
        found = self._found(blocks, samples, monitor, alone, starts.impossible)
        if begun is None:
            return found
        for case in np.flatnonzero(found.alone & ~alone).tolist():
            if stopped():
                return None
            values = self._native.values(begun, case)
            if values is not None:
                found.values[case], found.status[case], found.alone[case] = values, "completed", False
                found.time[case] = self.spec.plan.times(np.array([self.steps]))[0]
        return found

    def put(self, blocks: np.ndarray, name: str, values: np.ndarray, first: int = 0) -> None:
        """Values (cases, ...) into a field; lanes left over repeat the last case, and a single one is that of all."""
        width = self.programs.width
        place, rows = self.programs.rows_of(name).start + first, np.arange(len(blocks) * width)
        table = values[np.minimum(rows, len(values) - 1)].reshape(len(blocks), width, -1)
        blocks[:, place : place + table.shape[2], :] = table.transpose(0, 2, 1)

    def _give(self, blocks: np.ndarray, stops: LaneStops, step: int) -> int:
        """The next parts that each lane knows; the step until which they suffice."""
        parts, counts, until = stops.ahead(step)
        for k, name in enumerate(stops.part):
            self.put(blocks, f"stop_{name}", parts[:, k])
        self.put(blocks, "stop_waiting", counts.astype(float))
        return until

    def started(self, starts: Starts, clocks: np.ndarray | None = None) -> np.ndarray:
        """Blocks of rows at step 0, case after case; clocks (cases,): at which steps begin [s]."""
        programs, cases = self.programs, len(starts.close)
        blocks = blocks_of(-(-cases // programs.width), programs.row.size, programs.width)

        blocks[:, programs.row.slice("p"), :] = starts.p[:, None]
        blocks[:, programs.row.slice("t"), :] = self.spec.plan.t0
        blocks[:, programs.row.slice("h"), :] = np.array(self.spec.plan.grid.h)[:, None]
        for position, values in starts.varied.items():
            self.put(blocks, "p", values, position)
        self.put(blocks, "clock", np.full(cases, self.spec.plan.t0) if clocks is None else clocks)
        given = {name: getattr(starts, name) for name in ("q_i", "q_i_dot", "q_d", "close", "settle", "q", "q_dot")}
        for name, table in {**given, "asked": starts.close}.items():
            if name in programs.row.sizes:
                self.put(blocks, name, table)
        programs.begin.run(blocks, 0, 0, 1)
        return blocks

    def _decided(self, blocks: np.ndarray, cases: int) -> np.ndarray:
        """(cases,) those whose start is not one of lanes; what is held in the others is among their parameters now."""
        from runtime.schemes.switching.settle import NoMode, settled

        model, scheme, alone = self.programs.model, self.spec.plan.scheme, np.zeros(cases, dtype=bool)
        modes, none = model.element_modes, np.zeros(len(model.element_modes))
        if not len(modes):
            return alone
        states, constants = self.values(blocks, cases, "scheme"), self.values(blocks, cases, "c")
        first = len(model.parameters) - model.signals.size
        decided = self.values(blocks, cases, "p")[:, first + modes]
        native = self._native.code
        for k, (z, c) in enumerate(zip(states, constants, strict=True)):
            if native is not None:
                known = native.decided(z, scheme.constants(c), c, c[len(c) - model.signals.size :])
                if known is not None and known[1] and not (scheme.multistep and (known[0][modes] != decided[k]).any()):
                    decided[k] = known[0][modes]
                    continue
            found = settled(model, state_of(scheme, z, scheme.constants(c)), c, none, none)
            if (
                isinstance(found, NoMode)
                or found.push.any()
                or (scheme.multistep and (found.modes != decided[k]).any())
            ):
                alone[k] = True
            else:
                decided[k] = found.modes
        for position, values in zip(modes, decided.T, strict=True):
            self.put(blocks, "p", values[:, None], first + int(position))
        self.programs.begin.run(blocks, 0, 0, 1)
        return alone

    def advance(self, blocks: np.ndarray, steps: int) -> None:
        """Make major steps."""
        self.programs.steps.run(blocks, self._z, self._c, steps)

    def values(self, blocks: np.ndarray, cases: int, name: str) -> np.ndarray:
        """A field of all rows (cases, size), a copy."""
        part = blocks[:, self.programs.rows_of(name), :].transpose(0, 2, 1)
        return part.reshape(-1, part.shape[2])[:cases].copy()

    def _observed(self, blocks: np.ndarray, cases: int) -> np.ndarray:
        self.programs.observe.run(blocks, 0, 0, 1)
        return self.values(blocks, cases, "outputs")

    def _looked(self, blocks: np.ndarray, cases: int) -> np.ndarray:
        self.programs.look.run(blocks, 0, 0, 1)
        return self.values(blocks, cases, "look").T

    def _stations(self) -> list[tuple[int, bool, int]]:
        """(step, is it a look?, number of the sample, -1 for none), in order."""
        looks = set(self.spec.looks)
        samples = {step: k for k, step in enumerate(self.spec.marks) if step}
        return [(step, step in looks, samples.get(step, -1)) for step in sorted(looks | samples.keys())]

    def _longest(self, blocks: int) -> int:
        """Steps of a native call."""
        side_by_side = GPU_CASES if self.spec.device == "gpu" else 1
        seconds = SECONDS_PER_OPERATION * self.programs.operations * self.programs.width * blocks / side_by_side
        return max(1, int(SECONDS_OF_CALL / seconds))

    def _first_samples(self, blocks: np.ndarray, cases: int) -> np.ndarray:
        """Room for samples (cases, outputs, times), the first of them there; none where values are reduced."""
        if not self.spec.marks:
            return np.zeros((cases, 0, 0))
        samples = np.empty((cases, len(self.spec.outputs), len(self.spec.marks)))
        samples[:, :, 0] = self.values(blocks, cases, "outputs")
        return samples

    def _found(
        self, blocks: np.ndarray, samples: np.ndarray, monitor: _LaneMonitor, alone: np.ndarray, impossible: np.ndarray
    ) -> LaneResults:
        """Status and values; what is not known is NaN."""
        cases = len(alone)
        status = cause_of(self.values(blocks, cases, "causes")[:, 0])
        reached = self.values(blocks, cases, "reached")[:, 0].astype(int)
        seen = (monitor.wrong >= 0) & (status == "completed")
        status[seen], reached[seen] = np.array(FOUND)[monitor.wrong[seen]], monitor.good[seen]
        status[impossible], reached[impossible] = "not_assembled", 0
        alone = (alone | (status == ALONE)) & ~impossible
        failed, time = status != "completed", self.spec.plan.times(reached)
        kept = np.zeros((cases, 0))
        if self.spec.reduced:
            kept = self._reduced(blocks, cases)
            kept[failed] = np.nan
        if not self.spec.marks:
            return LaneResults(kept, status, time, alone)
        late = np.array(self.spec.marks)[None, :] > reached[:, None]
        samples[np.broadcast_to((late & failed[:, None])[:, None, :], samples.shape)] = np.nan
        samples[impossible] = np.nan
        return LaneResults(np.hstack([kept, samples.reshape(cases, -1)]), status, time, alone)

    def _reduced(self, blocks: np.ndarray, cases: int) -> np.ndarray:
        """(cases, values): sums as means, and values at the end as a run by itself shows them."""
        kept, end = self.values(blocks, cases, "reduced"), self._observed(blocks, cases)
        for k, (output, reduction) in enumerate(self.spec.reduced):
            if reduction == "end":
                kept[:, k] = end[:, self.spec.outputs.index(output)]
            elif reduction in ("mean", "rms"):
                kept[:, k] = finished(reduction, kept[:, k], self.steps + 1)
        return kept


class _LaneMonitor:
    """What looks have found of each lane: wrong, a position in FOUND or -1; good, the step of the last good look."""

    def __init__(self, start: np.ndarray) -> None:
        self.wrong = judged(start)
        self.good = np.zeros(start.shape[1], dtype=int)

    def look(self, now: np.ndarray, step: int) -> None:
        """Values of FIELDS (4, n) after so many steps."""
        self.wrong = np.where(self.wrong < 0, judged(now), self.wrong)
        self.good[self.wrong < 0] = step


# Cases in which a load or a prescribed motion jumps in time: stops are data of their lanes, each at its own times.


class LaneStops:
    """Of some cases. alone (cases,): those that lanes do not bring to their end: within short pulses.

    clocks (cases,): at which steps begin [s]. part: names of the fields of a part; none where nothing may jump.
    """

    def __init__(self, plan: Plan, starts: Starts, part: tuple[str, ...]) -> None:
        model, cases = plan.scheme.model, len(starts.close)
        self._plan, self.part = plan, part
        self.alone = np.zeros(cases, dtype=bool)
        self.clocks = np.full(cases, plan.t0)
        self._parts, self._of = [np.zeros((len(part), 0))], np.zeros(cases, dtype=int)
        if part:
            self._find(model, starts)
        self._steps = [parts[0].astype(int) if part else np.zeros(0, dtype=int) for parts in self._parts]

    def _find(self, model: EmittedModel, starts: Starts) -> None:
        plan, used, known = self._plan, _constants_of(model), dict[bytes, int]()
        own = model.constants(starts.p)
        state = ConsistentState(model.initial_q, model.initial_q_dot, {})
        found = all_stops(model, own, plan.t0, plan.t_end, state, plan.grid.h[-1])
        pulses = any(not one.owners for one in found)
        clocks = [plan.t0]
        for case in range(len(self.alone)):
            p = starts.p.copy()
            for position, values in starts.varied.items():
                p[position] = values[case]
            c = model.constants(p)
            key = c[used].tobytes()
            if key not in known:
                known[key] = len(self._parts)
                switches = switching_times(model, c, plan.t0, plan.t_end)
                grid = Breaks(plan.t0, plan.grid.dt_L, switches, plan.steps, plan.end)
                jolts = np.array([one.time for one in may_give_impulses(model, c, switches)])
                steps = np.array([step for step in grid.broken if step < plan.steps], dtype=int)
                parts = np.zeros((len(self.part), 0))
                if len(steps):
                    parts = parts_of(grid, steps, plan.grid.m, jolts)
                    parts = np.vstack([parts, np.zeros((len(self.part) - len(parts), parts.shape[1]))])
                self._parts.append(parts)
                clocks.append(grid.clock(0))
            self._of[case], self.clocks[case] = known[key], clocks[known[key]]
        counts = [int(np.unique(parts[0], return_counts=True)[1].max(initial=0)) for parts in self._parts]
        jumps = np.array([parts.shape[1] > 0 for parts in self._parts])
        self.alone |= (np.array(counts) > KNOWN_PARTS)[self._of] | (pulses & jumps)[self._of]

    def ahead(self, step: int) -> tuple[np.ndarray, np.ndarray, int]:
        """(parts (cases, fields, KNOWN_PARTS) from a step on, how many (cases,), the step that they suffice until)."""
        tables, counts, until = [], [], sys.maxsize
        for parts, steps in zip(self._parts, self._steps, strict=True):
            first = int(np.searchsorted(steps, step))
            known = parts[:, first : first + KNOWN_PARTS]
            counts.append(known.shape[1])
            tables.append(np.pad(known, ((0, 0), (0, KNOWN_PARTS - known.shape[1]))))
        for k in np.unique(self._of[~self.alone]):
            first = int(np.searchsorted(self._steps[k], step))
            if first + KNOWN_PARTS < len(self._steps[k]):
                until = min(until, int(self._steps[k][first + KNOWN_PARTS]))
        return np.array(tables)[self._of], np.array(counts)[self._of], until


def _constants_of(model: EmittedModel) -> list[int]:
    """Entries of c that the conditions are made of."""
    if not model.has("switching"):
        return []
    tape = read_tape(model.kernel("switching"))
    inputs = (node for node in tape.nodes if node.op == ca.OP_INPUT)
    return sorted({node.b for node in inputs if tape.input_names[node.a] == "c"})
