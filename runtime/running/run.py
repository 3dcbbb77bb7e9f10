"""The loop of a run: many major steps a native call; checks, samples, checkpoints and progress in between."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from runtime.contract.status import Event, Status
from runtime.results.stream import StreamFile
from runtime.running.checkpoint import Checkpoint
from runtime.running.interrupts import Interrupts, heard_interrupts
from runtime.running.leg import Leg
from runtime.running.record import Record
from runtime.running.singular.guard import FLOOR, Guard
from runtime.running.singular.passage import Passage, locate

CALL_SECONDS = 0.25  # a native call lasts about this long, so that progress and Ctrl-C stay responsive
CHECKPOINT_SECONDS = 60.0
LONGEST_BATCH = 1 << 20
Progress = Callable[[float, float], None]


@dataclass
class CheckpointRule:
    """Where checkpoints go, and after how many major steps; None: after CHECKPOINT_SECONDS."""

    path: Path | None = None
    every: int | None = None


@dataclass
class Run:
    """A run under way: z belongs to the last leg. header: what a checkpoint says besides."""

    leg: Leg
    z: np.ndarray
    record: Record
    rule: CheckpointRule
    header: dict[str, Any]
    progress: Progress | None = None
    events: list[Event] = field(default_factory=list)
    status: Status | None = None
    engine: str = "auto"
    guard: Guard = field(default_factory=Guard)
    earlier: np.ndarray | None = None  # a state of this leg at least a step before z, if there is one

    @property
    def step(self) -> int:
        """Major steps done."""
        return self.leg.step_of(self.z)

    def go(self) -> Status:
        """Step until the end, trouble, or Ctrl-C. The record ends with the last good state."""
        self._written = time.monotonic()
        with heard_interrupts() as interrupts:
            try:
                self._loop(interrupts)
            except KeyboardInterrupt:
                interrupts.asked = True
            interrupted = self.status is None and self.step < self.leg.plan.steps
            if interrupted:
                self.status = self.leg.watch.after(self._state, last=True)
            if self.status is None and interrupted:
                self.status = Status(
                    "interrupted",
                    self.leg.plan.time(self.step),
                    None,
                    "stopped by the user",
                    "What was computed is kept.",
                )
                self._keep()
                self._write_checkpoint()
        if self.status is not None:  # end with the last good state, which need not be one that was to be saved
            self.record.drop_from(self.step)
            self.record.add(self._leg_number, self.z)
        self.record.flush()
        return self.status or Status("completed", self.leg.plan.t_end)

    @property
    def _leg_number(self) -> int:
        return self.record.legs.index(self.leg)

    @property
    def _state(self) -> np.ndarray:
        return self.leg.stepper.state(self.z)

    def _loop(self, interrupts: Interrupts) -> None:
        per_call = 1
        while self.status is None and self.step < self.leg.plan.steps and not interrupts.asked:
            n = self._batch(per_call)
            began = time.perf_counter()
            self._advance(n)
            per_call = _next_batch(per_call, time.perf_counter() - began)
            self._keep()
            if self._checkpoint_is_due():
                self._write_checkpoint()
            if self.progress is not None:
                self.progress(self.leg.plan.time(self.step), self.leg.plan.t_end)

    def _advance(self, n: int) -> None:
        before = self.z.copy()
        self.leg.run(self.z, n)
        determinants = self.leg.determinants(self.z)
        if self.guard.alarm(*determinants):
            self._pass(before, n)
        else:
            self.guard.accept(*determinants)
            self.earlier = before
        self.status = self.status or self._checked()

    def _checked(self, closely: bool = False) -> Status | None:
        return self.leg.watch.after(self._state, last=closely or self.step == self.leg.plan.steps)

    def _pass(self, before: np.ndarray, n: int) -> None:
        """The determinant of a loop block is small on the way from `before`: decide there how to go on."""
        z, previous, alarm = locate(self.leg, self.guard, self.earlier, before, n)
        if not alarm:
            self.z, self.earlier = z, before
            return
        if self.guard.threshold < FLOOR:
            self._step_unguarded(z)
            return
        passage = Passage(self.leg, self.guard, self.record.legs, self.engine)
        found = passage.go_on(z if previous is None else previous)
        if found.event is not None and (
            found.event.kind != "no_variant" or not any(event.text == found.event.text for event in self.events)
        ):  # said once
            self.events.append(found.event)
        self.status = found.status
        if found.drop_from is None and found.status is None:  # look again later
            self.z, self.earlier = z, previous
            return
        if found.drop_from is not None:
            self.record.drop_from(found.drop_from)
        for sample in found.samples:
            self._keep(sample)
        if found.leg is not self.leg:
            self.leg, self.guard = found.leg, found.leg.new_guard()
            if found.leg not in self.record.legs:
                self.record.legs.append(found.leg)
        self.z, self.earlier = found.z, None

    def _step_unguarded(self, z: np.ndarray) -> None:
        """A step that nothing better was found for: if the other checks find nothing wrong, the branch is lost."""
        self.z, self.earlier = z, None
        good, time_ = z.copy(), self.leg.plan.time(self.leg.step_of(z))
        self.leg.run(self.z, 1)
        self.status = self._checked(closely=True)
        if self.status is None:
            self.z = good
            self.status = Status(
                "branch_lost",
                time_,
                None,
                "the loop closure is singular within the next step",
                "Reduce the step, start elsewhere, or change a length a little.",
            )

    def _batch(self, per_call: int) -> int:
        plan, done = self.leg.plan, self.step
        n = min(plan.save_every - done % plan.save_every, plan.steps - done, per_call)
        return n if self.rule.every is None else min(n, self.rule.every - done % self.rule.every)

    def _keep(self, z: np.ndarray | None = None) -> None:
        plan, kept = self.leg.plan, self.z if z is None else z
        step = self.leg.step_of(kept)
        if self.status is None and (step % plan.save_every == 0 or step == plan.steps):
            self.record.add(self._leg_number, kept)

    # ---- checkpoints ----------------------------------------------------------------------------------------

    def _checkpoint_is_due(self) -> bool:
        if self.rule.path is None or self.status is not None or self.step == self.leg.plan.steps:
            return False
        if self.rule.every is not None:
            return self.step % self.rule.every == 0
        return time.monotonic() - self._written > CHECKPOINT_SECONDS

    def _write_checkpoint(self) -> None:
        if self.rule.path is None:
            return
        arrays = self.record.arrays()
        table = self.record.table
        header = {
            **self.header,
            "watch": self.leg.watch.memory(),
            "last_step": self.record.last_step,
            "rows": 0 if table is None else table.rows,
            "step": self.step,
            "stream": str(table.folder) if isinstance(table, StreamFile) else None,
            "events": [[event.time, event.kind, event.text] for event in self.events],
            "legs": [list(leg.model.q_i) for leg in self.record.legs],
            "leg": self._leg_number,
            "guard": self.guard.memory(),
            "place": self.leg.observed([self._state]).q[0].tolist(),
        }
        if self.earlier is not None:
            arrays["earlier"] = self.earlier
        Checkpoint(header, self.z, self.leg.p, arrays).write(self.rule.path)
        self._written = time.monotonic()


def _next_batch(per_call: int, elapsed: float) -> int:
    """Double or halve: the interpreted engine builds one Function per batch length, so there should be few."""
    if elapsed < CALL_SECONDS / 4:
        return min(per_call * 2, LONGEST_BATCH)
    return max(1, per_call // 2) if elapsed > CALL_SECONDS else per_call
