"""Trials of a motion that comes near singular positions: they pass them, and exchange coordinates, as the run does."""

from __future__ import annotations

from dataclasses import replace
from itertools import groupby

import numpy as np

from runtime.contract.consistent_state import ConsistentState
from runtime.contract.coordinates import followed, whole
from runtime.results.sampling import evaluate
from runtime.running.accuracy import Accuracy
from runtime.running.checkpoint import CheckpointRule
from runtime.running.checks.finite import Finite
from runtime.running.checks.least_step import LeastStep
from runtime.running.monitor import Monitor
from runtime.running.record import Record
from runtime.running.run import Run
from runtime.running.segment import Segment
from runtime.running.tried_motion import OPERATIONS, SEEN, TrialRuns, TriedMotion
from runtime.schemes.adaptive.adaptive_steps import AdaptiveSteps


class _TooDear(Exception):
    """A trial would take more operations than are left of the budget."""


class PassingTrials(TrialRuns):
    """Makes trials as runs of the segment's own plan; segments: of all choices of q_i that trials have come to."""

    begins = (1e-2, 1e-3, 1e-4)  # coarser motions lose their way beside a singular position
    passes = True

    def __init__(
        self, segment: Segment, state: ConsistentState, engine: str, budget: float = OPERATIONS, least: int = 0
    ) -> None:
        plan, self.engine = segment.plan, engine
        monitor = Monitor(segment.model, plan.scheme, segment.c, force=True, p=segment.p)
        plan = replace(plan, save_every=max(1, plan.steps // SEEN), outputs=(), force=True)
        own = replace(segment, plan=plan, ready=segment.ready.copy(), monitor=monitor, given={})
        own.switches, self.segments = segment.switches, [own]
        z = own.start(state.q, state.q_dot)
        super().__init__(own.stepper, z, own.c, plan.t_end - plan.t0, own.switches, budget, least=least)

    def _made(
        self, z: np.ndarray, tolerance: float, keep: bool = False, longest: float = np.inf, most: float = np.inf
    ) -> TriedMotion | None:
        """The motion from z (flat), None where it is lost or takes too much."""
        own, first = self.segments[0], [0.0]
        for segment in self.segments:
            segment.given = {}
            checks = segment.monitor.checks  # coarse as the motion is, energy and growth tell nothing
            segment.monitor.checks = [check for check in checks if isinstance(check, Finite | LeastStep)]
            scheme = segment.plan.scheme
            assert isinstance(scheme, AdaptiveSteps)
            constants = scheme.constants(segment.c, segment.plan.grid.dt_L, tolerance)
            segment.ready[:] = segment.stepper.ready_for(constants)
        self.tries += 1
        accuracy = Accuracy(0)
        accuracy.count, accuracy.marks, accuracy.carried.ended = 0, [], True
        record = Record(self.segments, own.plan.save_every)

        def judge(t: float, t_end: float) -> None:
            first[0] = first[0] or float(run.z[run.segment.plan.scheme.layout.slice("h_next")][0])
            done = self._operations(run)
            self.expected = min(self.expected, done * (t_end - own.plan.t0) / (t - own.plan.t0))
            if done > min(self.budget - self.spent, most):
                raise _TooDear

        run = Run(
            own,
            z,
            record,
            CheckpointRule(),
            "none",
            judge,
            engine=self.engine,
            guard=own.new_guard(),
            accuracy=accuracy,
        )
        record.add(0, z)
        run.status = own.monitor.first(own.state(z))
        try:
            status = run.go()
        except _TooDear:
            return None
        if status.name == "interrupted":
            raise KeyboardInterrupt
        self.spent += (spent := self._operations(run))
        if status.name != "completed":
            return None
        return self._told(run, tolerance, first[0], spent)

    @staticmethod
    def _operations(run: Run) -> float:
        scheme = run.segment.plan.scheme
        assert isinstance(scheme, AdaptiveSteps)
        return scheme.operations_taken(run.z, run.segment.stepper.program)

    def _told(self, run: Run, tolerance: float, first: float, spent: float) -> TriedMotion | None:
        """What a run that has come to its end tells."""
        own, at = run.segment.plan.scheme, run.segment.plan.scheme.layout.slice
        assert isinstance(own, AdaptiveSteps)
        seen, sizes = [], []
        for number, part in groupby(run.record.samples, key=lambda sample: sample[0]):
            segment, states = self.segments[number], np.array([z for _, z in part])
            scheme = segment.plan.scheme
            found = evaluate(scheme.observer, {"z": states}, scheme.constants(segment.c))
            seen.append(whole(scheme.model, found["q_i"], found["q_d"]))
            sizes.append(self._sizes(states, scheme.layout))
        q, size = np.concatenate(seen), np.concatenate(sizes)
        low, high = run.z[at("q_low")], run.z[at("q_high")]
        if not self.scheme.charts.size:
            told = q[:, self.model.independent_columns]
            low, high = told.min(axis=0), told.max(axis=0)
        elif own is not self.scheme:  # ranges of turns are those of the last choice of q_i
            return None
        if not np.isfinite([*low, *high]).all():
            return None
        steady, steps = float(run.z[at("steady")][0]), int(run.z[at("accepted")][0])
        size = size[size > 0] if (size > 0).any() else np.ones(1)  # none where a passage has ended
        made = (low.copy(), high.copy(), steady or first, float(own.longest(run.z)), steps, spent, size)
        return TriedMotion(tolerance, steady, q[:, followed(self.model)[1]], *made, low.copy(), high.copy())
