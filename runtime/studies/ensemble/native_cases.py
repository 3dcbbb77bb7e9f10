"""Cases of an ensemble in which events happen: each goes through them by native code, from its start to its end.

Lanes step cases side by side and do not decide; a case that comes to an event is made by itself here, without a run
around it (StepsWithStops.through_events). Its states are then looked at and observed in lanes again, as rows of its
own. What is not made so (a motion that events end, loops near a singular position, trouble of any kind) is left to a
run by itself.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from runtime.engine.native import blocks_of
from runtime.schemes.stepper import Stepper, kept_stepper
from runtime.schemes.switching.native_events import KinkMemory, NativeEvents, native_events
from runtime.schemes.switching.steps_with_stops import StepsWithStops
from runtime.schemes.switching.times import has_switching_times, switching_times
from runtime.schemes.switching.watched import watched_events, watches
from runtime.studies.ensemble.account import judged
from runtime.studies.ensemble.reductions import reduced

if TYPE_CHECKING:
    from runtime.studies.ensemble.lane_runs import LaneRuns

ROWS_AT_ONCE = 4096  # states that are observed at a time


@dataclass(frozen=True)
class CaseStates:
    """Of some cases at step 0: z (cases, n_z), p, c and what steps read, a row of each."""

    z: np.ndarray
    p: np.ndarray
    c: np.ndarray
    ready: np.ndarray


class NativeCases:
    """Of the lanes of an ensemble."""

    def __init__(self, lanes: LaneRuns) -> None:
        self._lanes, self._spec = lanes, lanes.spec
        self._scheme, self._steps = lanes.spec.plan.scheme, lanes.spec.plan.steps

    @cached_property
    def possible(self) -> bool:
        """Are there events that native code decides on? Not with loops, whose singular positions a run passes."""
        return self.code is not None and not self._scheme.layout.sizes["det_low"]

    @cached_property
    def code(self) -> NativeEvents | None:
        """What decides, where native code does."""
        return native_events(self._stepper) if watches(self._scheme) else None

    @cached_property
    def _stepper(self) -> Stepper:
        return kept_stepper(self._scheme, "auto", wait=True)

    def states(self, blocks: np.ndarray, cases: int) -> CaseStates:
        """Of blocks of rows at step 0."""
        names = ("scheme", "p", "c", "ready")
        return CaseStates(*(self._lanes.values(blocks, cases, name) for name in names))

    def values(self, starts: CaseStates, case: int) -> np.ndarray | None:
        """(width,) of a case; None: it is to be run by itself."""
        spec = self._spec
        marks = [step for step in spec.marks if step]
        ends = np.arange(1, self._steps + 1) if spec.reduced else np.union1d(marks, [*spec.looks, self._steps])
        ends = ends[ends > 0].astype(np.int64)
        rows = self._rows(starts, case, ends)
        if rows is None:
            return None
        states = np.vstack([starts.z[case], rows])
        outputs, looks = self._observed(starts, case, states)
        at = np.isin(ends, [*spec.looks, self._steps])
        if (judged(looks[1:][at].T) >= 0).any():
            return None
        whole = [reduced(outputs[:, spec.outputs.index(name)], how) for name, how in spec.reduced]
        if not spec.marks:
            return np.array(whole)
        places = np.concatenate([[0], 1 + np.searchsorted(ends, marks)]).astype(int)
        return np.concatenate([whole, outputs[places].T.ravel()])

    def _rows(self, starts: CaseStates, case: int, ends: np.ndarray) -> np.ndarray | None:
        """(N, n_z) states after these steps; None where something is to be looked at closely."""
        plan, scheme, stepper = self._spec.plan, self._scheme, self._stepper
        c, model = starts.c[case], scheme.model
        switches = switching_times(model, c, plan.t0, plan.t_end) if has_switching_times(model) else []
        steps = StepsWithStops(stepper, plan.t0, plan.grid.dt_L, switches, c, plan.steps, plan.end)
        if not steps.native:
            return None
        kinks = len(watched_events(scheme)) - len(model.description.events)
        z = stepper.prepared.widened(starts.z[case])
        ready = stepper.ready(c, plan.grid.dt_L)
        found = steps.through_events(z, ready, c, ends, [KinkMemory(0.0, ())] * kinks, told=False)
        if found is None or (found.unresolved and self._spec.refinement is not None):
            return None
        rows = found.rows[:, : scheme.layout.size]
        failed = scheme.iteration_limit is not None and (rows[:, scheme.layout.slice("failures")] > 0).any()
        return None if failed or not np.isfinite(rows).all() else rows

    def _observed(self, starts: CaseStates, case: int, states: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """(outputs (N, outputs), what looks judge by (N, fields)) of states (N, n_z) of a case, as rows of lanes."""
        lanes, programs = self._lanes, self._lanes.programs
        outputs, looks = list[np.ndarray](), list[np.ndarray]()
        for first in range(0, len(states), ROWS_AT_ONCE):
            part = states[first : first + ROWS_AT_ONCE]
            blocks = blocks_of(-(-len(part) // programs.width), programs.row.size, programs.width)
            given = {"scheme": part, "h": np.array(self._spec.plan.grid.h)[None]}
            given |= {name: getattr(starts, name)[case][None] for name in ("p", "c", "ready")}
            for name, table in given.items():
                lanes.put(blocks, name, table)
            observe: list[tuple[Callable[..., None], str, list[np.ndarray]]] = [
                (programs.observe.run, "outputs", outputs),
                (programs.look.run, "look", looks),
            ]
            for run, name, found in observe:
                run(blocks, 0, 0, 1)
                found.append(lanes.values(blocks, len(part), name))
        return np.concatenate(outputs), np.concatenate(looks)
