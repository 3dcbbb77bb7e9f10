"""What is kept of a run: the scheme's own vectors z, which are turned into a Solution at the end, and those at marks,
by which two ways to make one motion are compared.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from itertools import groupby
from pathlib import Path

import numpy as np

from runtime.contract.coordinates import followed, whole
from runtime.contract.doors import opened
from runtime.contract.model import Model
from runtime.engine.rows import evaluate
from runtime.results.observe import concatenated
from runtime.results.solution import Solution
from runtime.running.stepped_model import SteppedModel


class Record:
    """Samples of a run; its segments are appended to `segments` as it goes on, and samples name theirs by its place.

    rows: samples that are kept otherwise (see columns.py), in a folder, if there are any.
    """

    rows = 0
    folder: Path | None = None

    def __init__(self, segments: list[SteppedModel], seen_steps: int) -> None:
        self.segments, self.every = segments, seen_steps
        self.samples: list[tuple[int, np.ndarray]] = []  # (segment, states (N, n_z)): all, or those that wait
        self.last_step = -1

    def add(self, segment: SteppedModel, rows: np.ndarray) -> None:
        """Keep states (N, n_z) of a segment (copies of the scheme's part), unless their steps are kept already."""
        steps = rows[:, 1].astype(int)
        new = steps > self.last_step
        if new.any():
            self.last_step = int(steps[-1])
            kept = rows[new, : segment.plan.scheme.layout.size].copy()
            self.samples.append((self.segments.index(segment), kept))

    def flush(self) -> None:
        """Write what waits."""

    def close(self) -> None:
        """Nothing follows."""

    @contextmanager
    def closed_on_error(self) -> Iterator[None]:
        """Whatever breaks inside closes the record."""
        try:
            yield
        except BaseException:
            self.close()
            raise

    def drop_from(self, step: int) -> None:
        """Forget the samples of this step and of later ones."""
        kept = [(segment, rows[rows[:, 1].astype(int) < step]) for segment, rows in self.samples]
        self.samples = [(segment, rows) for segment, rows in kept if len(rows)]
        self.last_step = min(self.last_step, step - 1)

    def arrays(self) -> dict[str, np.ndarray]:
        """What a checkpoint keeps: `samples`, states one after another, flat; `sample_segments` (N,), whose each is."""
        owners = np.array([segment for segment, rows in self.samples for _ in rows], dtype=np.int64)
        states = np.concatenate([np.zeros(0), *(rows.ravel() for _, rows in self.samples)])
        return {"sample_segments": owners, "samples": states}

    def restore(self, arrays: dict[str, np.ndarray], rows: int, last_step: int) -> None:
        """Continue from `arrays`; rows: that there were. Raises ModelError if there are fewer."""
        sizes = [segment.plan.scheme.layout.size for segment in self.segments]
        owners = [int(k) for k in arrays["sample_segments"]]
        ends = np.cumsum([sizes[k] for k in owners], dtype=np.int64)
        states = arrays["samples"]
        self.samples = [(k, states[None, end - sizes[k] : end]) for k, end in zip(owners, ends, strict=True)]
        self.last_step = last_step

    def solution(self, last: tuple[int, np.ndarray]) -> Solution:
        """Of all whole states that were kept, `last` the last one."""
        found = [self.segments[segment].observed(part) for segment, part in by_segment(self.samples)]
        return concatenated(found, self.segments[0].model)

    def finished(self, solution: Solution) -> Solution:
        """The solution, which is told where samples are kept."""
        return solution


def by_segment(samples: Sequence[tuple[int, np.ndarray]]) -> list[tuple[int, np.ndarray]]:
    """Consecutive states (N, n_z) of one segment together."""
    parts = groupby(samples, key=lambda sample: sample[0])
    return [(segment, np.concatenate([rows for _, rows in part])) for segment, part in parts]


def record_of(
    segment: SteppedModel, z: np.ndarray, stream: str | Path | None, keep_rows: bool, resumed: bool = False
) -> Record:
    """Of a run from z (flat) on: whole states in memory, or rows of columns. Raises OutputError or ModelError."""
    if not keep_rows:
        return Record([segment], segment.plan.seen_steps)
    found: Record = opened("runtime.running.columns:ColumnRecord")(segment, z, stream, resumed)
    return found


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
        size, steps = segment.plan.scheme.layout.size, rows[:, 1].astype(int)
        at = (steps > 0) & (steps % self.every == 0)
        if self.early:
            at |= (steps > 0) & (steps < self.every) & (steps % self.early == 0)
        for k in np.flatnonzero(at):
            self.states[int(steps[k])] = (segment, rows[k, :size].copy())

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

    def told(self, steps: Sequence[int], model: Model) -> np.ndarray:
        """(2, N, n_told) what tells the motion of a model at these steps, and its rates, whatever q_i was stepped."""
        first = self.states[steps[0]][0]
        if all(self.states[step][0] is first for step in steps):
            return told_by(first, np.array([self.states[step][1] for step in steps]), model)
        return np.concatenate([self.told([step], model) for step in steps], axis=1)


def told_by(segment: SteppedModel, states: np.ndarray, model: Model) -> np.ndarray:
    """(2, N, n_told) what tells the motion of a model, and its rates, of states (N, n_z) of a segment with any q_i."""
    scheme, own = segment.plan.scheme, segment.model
    seen = evaluate(scheme.observer, {"z": states}, scheme.constants(segment.c))
    motion = whole(own, np.stack([seen["q_i"], seen["q_i_dot"]]), np.stack([seen["q_d"], seen["q_d_dot"]]))
    return np.ascontiguousarray(motion[..., followed(model)[1]])  # sums of rows round alike, whoever makes them
