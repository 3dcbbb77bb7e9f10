"""What is kept of a run: the scheme's own vectors z, which are turned into a Solution at the end, and those at
comparison times, by which two ways to make one motion are compared.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from itertools import groupby
from pathlib import Path

import numpy as np

from runtime.contract.coordinates import followed, whole
from runtime.contract.model import EmittedModel
from runtime.engine.rows import evaluate
from runtime.running.stepped_model import SteppedModel
from runtime.solutions.observe import concatenated
from runtime.solutions.solution import Solution


class Record:
    """Samples of a run; its segments are appended to `segments` as it goes on, and samples name theirs by its place.

    last: the step that ends the run. rows: samples that are kept otherwise (see columns.py), in a folder, if any are,
    of a run that has this name.
    """

    rows = 0
    folder: Path | None = None
    run = ""

    def __init__(self, segments: list[SteppedModel], seen_steps: int, last: int = 0) -> None:
        self.segments, self.every, self.last = segments, seen_steps, last
        self.samples: list[tuple[int, np.ndarray]] = []  # (segment, states (N, n_z)): all, or those that wait
        self.last_step = -1

    def due(self, steps: np.ndarray) -> np.ndarray:
        """(N,) which of these steps (N,) are to be kept."""
        return np.asarray((steps % self.every == 0) | (steps == self.last))

    def add(self, segment: SteppedModel, rows: np.ndarray) -> None:
        """Keep states (N, n_z) of a segment (copies of the scheme's part), unless their steps are kept already."""
        steps = rows[:, 1]  # a step of a tolerance that is ended at an event shows the sample before it once more
        new = (steps > self.last_step) & (np.diff(steps, prepend=-1.0) > 0)
        if new.any():
            self.last_step = int(rows[-1, 1])
            self.samples.append((self.segments.index(segment), rows[new, : segment.plan.scheme.layout.size]))

    def flush(self) -> None:
        """Write what waits."""

    def forget_waiting(self) -> None:
        """Lose what was not written."""
        self.samples = []

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

    def steps(self) -> list[int]:
        """At which states are kept."""
        return [int(step) for _, rows in self.samples for step in rows[:, 1]]

    def compared_motion(self, model: EmittedModel, steps: Sequence[int] | np.ndarray | None = None) -> np.ndarray:
        """(2, N, n_told) what tells the motion of a model at these steps, rising (None: all), and its rates."""
        parts = by_segment(self.samples)
        if steps is not None:
            parts = [(k, rows[among(rows[:, 1], np.asarray(steps))]) for k, rows in parts]
        found = [compared_motion_of(self.segments[k], rows, model) for k, rows in parts if len(rows)]
        return np.concatenate(found, axis=1) if found else np.zeros((2, 0, len(followed(model)[0])))

    def states(self) -> list[tuple[SteppedModel, np.ndarray]]:
        """Consecutive states (N, n_z) that were kept, and the segment that they belong to."""
        return [(self.segments[k], rows) for k, rows in by_segment(self.samples)]

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


def among(values: np.ndarray, known: np.ndarray) -> np.ndarray:
    """(N,) which of the values (N,) are among the known ones, which rise; np.isin takes ten times as long for few."""
    if not len(known):
        return np.zeros(len(values), dtype=bool)
    return np.asarray(known[np.minimum(np.searchsorted(known, values), len(known) - 1)] == values)


class ComparisonTimes(Record):
    """States of a run at the steps at which it is compared with another, `at`, and at `early` ones of its first part.

    Both rise and begin behind the start.
    """

    def __init__(self, at: Sequence[int] | np.ndarray, early: Sequence[int] | np.ndarray = ()) -> None:
        super().__init__([], 1)
        self.at, self.early = np.array(at, dtype=int), np.array(early, dtype=int)
        self._all = np.union1d(self.at, self.early)
        self._compared = np.zeros((2, 0, 0))

    def due(self, steps: np.ndarray) -> np.ndarray:
        """See Record."""
        return among(steps, self._all)

    def compared_motion(self, model: EmittedModel, steps: Sequence[int] | np.ndarray | None = None) -> np.ndarray:
        """See Record; evaluated once."""
        known = np.array(self.steps(), dtype=int)
        if self._compared.shape[1] != len(known) or not len(known):
            self._compared = super().compared_motion(model)
        return self._compared if steps is None else self._compared.compress(among(known, np.asarray(steps)), axis=1)

    def within(self, first: int, last: int) -> list[int]:
        """Steps between two that are at a comparison time, these left out."""
        low, high = np.searchsorted(self._all, [first + 1, last])
        return [int(step) for step in self._all[low:high]]


def compared_motion_of(segment: SteppedModel, states: np.ndarray, model: EmittedModel) -> np.ndarray:
    """(2, N, n_told) what tells the motion of a model, and its rates, of states (N, n_z) of a segment with any q_i."""
    scheme, own = segment.plan.scheme, segment.model
    observed = evaluate(scheme.observer, {"z": states}, scheme.constants(segment.c))
    motion = whole(
        own, np.stack([observed["q_i"], observed["q_i_dot"]]), np.stack([observed["q_d"], observed["q_d_dot"]])
    )
    return np.ascontiguousarray(motion[..., followed(model)[1]])  # sums of rows round alike, whoever makes them
