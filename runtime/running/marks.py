"""States of a run at marks: times at which two ways to make one motion are compared."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from runtime.contract.coordinates import followed, whole
from runtime.contract.model import Model
from runtime.engine.rows import evaluate
from runtime.running.segment import Segment


@dataclass
class Marks:
    """States of a run at marks: every so many steps, and every `early` ones until the first of them (0: none)."""

    every: int
    early: int = 0
    states: dict[int, tuple[Segment, np.ndarray]] = field(default_factory=dict)

    def until_next(self, step: int) -> int:
        """Steps from this one to the next mark."""
        left = self.every - step % self.every
        return min(left, self.early - step % self.early) if self.early and step < self.every else left

    def look(self, segment: Segment, rows: np.ndarray) -> None:
        """Keep those of the states (N, n_z) that are at a mark."""
        size = segment.plan.scheme.layout.size
        for row in rows:
            step = segment.step_of(row)
            if step and self.until_next(step - 1) == 1:
                self.states[step] = (segment, row[:size].copy())

    def drop_from(self, step: int) -> None:
        """Forget the states of this step and of later ones."""
        self.states = {at: one for at, one in self.states.items() if at < step}

    def arrays(self, segments: Sequence[Segment]) -> dict[str, np.ndarray]:
        """What a checkpoint keeps of it: steps, places of the segments, and states one after another."""
        found = sorted(self.states.items())
        return {
            "mark_steps": np.array([step for step, _ in found], dtype=np.int64),
            "mark_segments": np.array([segments.index(segment) for _, (segment, _) in found], dtype=np.int64),
            "mark_states": np.concatenate([np.zeros(0), *(z for _, (_, z) in found)]),
        }

    def restore(self, arrays: Mapping[str, np.ndarray], segments: Sequence[Segment]) -> None:
        """From `arrays`."""
        first = 0
        for step, k in zip(arrays["mark_steps"], arrays["mark_segments"], strict=True):
            segment = segments[int(k)]
            last = first + segment.plan.scheme.layout.size
            self.states[int(step)] = (segment, arrays["mark_states"][first:last])
            first = last

    def told(self, steps: Sequence[int], model: Model) -> np.ndarray:
        """(N, n_told) what tells the motion of a model at these steps, whatever q_i they were stepped with."""
        rows: dict[int, np.ndarray] = {}
        for segment in {id(self.states[step][0]): self.states[step][0] for step in steps}.values():
            own = [step for step in steps if self.states[step][0] is segment]
            rows |= dict(
                zip(own, told_by(segment, np.array([self.states[step][1] for step in own]), model), strict=True)
            )
        return np.array([rows[step] for step in steps])


def told_by(segment: Segment, states: np.ndarray, model: Model) -> np.ndarray:
    """(N, n_told) what tells the motion of a model, of states (N, n_z) of a segment, which may have other q_i."""
    scheme = segment.plan.scheme
    seen = evaluate(scheme.observer, {"z": states}, scheme.constants(segment.c))
    q = whole(segment.model, seen["q_i"], seen["q_d"])
    return q[:, followed(model)[1]]
