"""Cases in which a load or a prescribed motion jumps in time: stops are data of their lanes, each at its own times."""

from __future__ import annotations

import sys

import casadi as ca
import numpy as np

from runtime.contract.consistent_state import ConsistentState
from runtime.contract.model import Model
from runtime.contract.tape import read_tape
from runtime.running.plan import Plan
from runtime.running.time_functions import all_stops
from runtime.schemes.switching.breaks import Breaks
from runtime.schemes.switching.impulse import may_give_impulses
from runtime.schemes.switching.steps_with_stops import parts_of
from runtime.schemes.switching.stop_program import KNOWN
from runtime.schemes.switching.times import switching_times
from runtime.studies.ensemble.starts import Starts


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

    def _find(self, model: Model, starts: Starts) -> None:
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
                grid = Breaks(plan.t0, plan.grid.dt_L, switches, plan.steps)
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
        self.alone |= (np.array(counts) > KNOWN)[self._of] | (pulses & jumps)[self._of]

    def ahead(self, step: int) -> tuple[np.ndarray, np.ndarray, int]:
        """(parts (cases, fields, KNOWN) from a step on, how many (cases,), the step that they suffice until)."""
        tables, counts, until = [], [], sys.maxsize
        for parts, steps in zip(self._parts, self._steps, strict=True):
            first = int(np.searchsorted(steps, step))
            known = parts[:, first : first + KNOWN]
            counts.append(known.shape[1])
            tables.append(np.pad(known, ((0, 0), (0, KNOWN - known.shape[1]))))
        for k in np.unique(self._of[~self.alone]):
            first = int(np.searchsorted(self._steps[k], step))
            if first + KNOWN < len(self._steps[k]):
                until = min(until, int(self._steps[k][first + KNOWN]))
        return np.array(tables)[self._of], np.array(counts)[self._of], until


def _constants_of(model: Model) -> list[int]:
    """Entries of c that the conditions are made of."""
    if not model.has("switching"):
        return []
    tape = read_tape(model.kernel("switching"))
    inputs = (node for node in tape.nodes if node.op == ca.OP_INPUT)
    return sorted({node.b for node in inputs if tape.input_names[node.a] == "c"})
