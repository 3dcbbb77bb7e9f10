"""What is kept of a run: whole states, or only columns of them, in memory or in a stream.

Whole states in memory are the scheme's own vectors z; they are turned into a Solution at the end. In the other cases
blocks of them are observed on the way and forgotten; of the whole states the first and the last are kept.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace
from itertools import groupby
from pathlib import Path
from typing import Any

import numpy as np

from runtime.contract.errors import ModelError
from runtime.contract.status import Status
from runtime.results import export
from runtime.results.observe import concatenated
from runtime.results.solution import Solution
from runtime.results.stream import StreamFile, Table, split
from runtime.running.stepped_model import SteppedModel

Columns = list[tuple[str, tuple[int, ...]]]
BLOCK = 256  # samples that wait to be written
SERIES = tuple(key for key in export.ARRAYS if key not in ("parameters", "t"))


class Record:
    """Samples of a run; its segments are appended to `segments` as it goes on, and samples name theirs by its place.

    table: where rows of columns go; None keeps whole states. outputs: names of the columns, () for all there are.
    """

    def __init__(
        self, segments: list[SteppedModel], save_every: int, table: Table | None = None, outputs: Sequence[str] = ()
    ) -> None:
        self.segments, self.every, self.table, self.outputs = segments, save_every, table, tuple(outputs)
        self.samples: list[tuple[int, np.ndarray]] = []  # (segment, states (N, n_z)): all, or those that wait
        self.first: tuple[int, np.ndarray] | None = None
        self.last_step = -1

    def add(self, segment: int, rows: np.ndarray) -> None:
        """Keep states (N, n_z) (copies of the scheme's part), unless their steps are kept already."""
        steps = rows[:, 1].astype(int)
        new = steps > self.last_step
        if not new.any():
            return
        self.last_step = int(steps[-1])
        kept = rows[new, : self.segments[segment].plan.scheme.layout.size].copy()
        self.first = self.first or (segment, kept[0])
        self.samples.append((segment, kept))
        if self.table is not None and sum(len(part) for _, part in self.samples) >= BLOCK:
            self.flush()

    def flush(self) -> None:
        """Write the rows of the samples that wait."""
        if self.table is None:
            return
        for segment, part in _by_segment(self.samples):
            seen = concatenated([self.segments[segment].observed(part)], self.segments[0].model)
            self.table.append(rows_of(seen, self.outputs))
        self.samples = []

    def close(self) -> None:
        """Nothing follows: a stream is whole as far as it was written, and others may write to its folder."""
        if isinstance(self.table, StreamFile):
            self.table.close()

    @contextmanager
    def closed_on_error(self) -> Iterator[None]:
        """Whatever breaks inside closes the stream."""
        try:
            yield
        except BaseException:
            self.close()
            raise

    def drop_from(self, step: int) -> None:
        """Forget the samples of this step and of later ones."""
        kept = [(segment, rows[rows[:, 1].astype(int) < step]) for segment, rows in self.samples]
        kept = [(segment, rows) for segment, rows in kept if len(rows)]
        if self.table is not None and not kept:
            self.table.keep(min(self.table.rows, -(-step // self.every)))
        self.samples = kept
        self.last_step = min(self.last_step, step - 1)

    def arrays(self) -> dict[str, np.ndarray]:
        """What a checkpoint keeps of it: rows in a stream stay there.

        samples: states one after another, flat; sample_segments (N,): whose each is; table (rows, width).
        """
        self.flush()
        found: dict[str, np.ndarray] = {}
        if self.table is not None and not isinstance(self.table, StreamFile):
            found["table"] = self.table.all_rows()
        kept = self.samples if self.table is None else self._ends()[:1]
        found["sample_segments"] = np.array([segment for segment, rows in kept for _ in rows], dtype=np.int64)
        found["samples"] = np.concatenate([np.zeros(0), *(rows.ravel() for _, rows in kept)])
        return found

    def restore(self, arrays: dict[str, np.ndarray], rows: int, last_step: int) -> None:
        """Continue from `arrays`; a stream is cut to so many rows. Raises ModelError if it has fewer."""
        sizes = [segment.plan.scheme.layout.size for segment in self.segments]
        owners = [int(k) for k in arrays["sample_segments"]]
        ends = np.cumsum([sizes[k] for k in owners], dtype=np.int64)
        states = np.split(arrays["samples"], ends[:-1]) if owners else []
        kept = [(owner, z[None]) for owner, z in zip(owners, states, strict=True)]
        self.first, self.last_step = ((kept[0][0], kept[0][1][0]) if kept else None), last_step
        if self.table is None:
            self.samples = kept
            return
        if "table" in arrays:
            self.table.append(arrays["table"])
        if self.table.rows < rows:
            raise ModelError(
                f"the stream holds {self.table.rows} samples, the checkpoint was written after {rows}; "
                "give the stream that belongs to the checkpoint"
            )
        self.table.keep(rows)

    def solution(self, last: tuple[int, np.ndarray]) -> Solution:
        """Of all whole states that were kept, `last` the last one."""
        kept = self.samples if self.table is None else self._ends(last)
        found = concatenated(
            [self.segments[segment].observed(part) for segment, part in _by_segment(kept)], self.segments[0].model
        )
        if self.table is not None and not isinstance(self.table, StreamFile):
            columns = split(self.table.all_rows(), self.table.columns)
            found = replace(found, outputs={name: values for name, values in columns.items()})
        return found

    def _ends(self, last: tuple[int, np.ndarray] | None = None) -> list[tuple[int, np.ndarray]]:
        """The first and the last state, once where they are of one step."""
        found = [(segment, z[None]) for segment, z in filter(None, (self.first, last))]
        return found[:1] if len(found) == 2 and found[0][1][0, 1] == found[1][1][0, 1] else found


def _by_segment(samples: Sequence[tuple[int, np.ndarray]]) -> list[tuple[int, np.ndarray]]:
    """Consecutive states (N, n_z) of one segment together."""
    parts = groupby(samples, key=lambda sample: sample[0])
    return [(segment, np.concatenate([rows for _, rows in part])) for segment, part in parts]


def columns_of(solution: Solution, outputs: Sequence[str]) -> Columns:
    """Names and shapes of the columns of a sample; of all there are if no outputs are named. Raises ModelError."""
    if not outputs:
        series = {key: np.asarray(getattr(solution, key)) for key in SERIES}
        energies = {f"energy_{key}": values for key, values in solution.energy.items()}
        return [("t", ()), *((name, values.shape[1:]) for name, values in {**series, **energies}.items())]
    known = output_values(solution)
    for name in outputs:
        if name not in known:
            raise ModelError(
                f"model {solution.model.name} has no output {name!r}; it has "
                f"{', '.join(list(known)[1:25])}{', ...' if len(known) > 25 else ''}"
            )
    return [("t", ()), *((name, ()) for name in outputs if name != "t")]


def output_values(solution: Solution) -> dict[str, np.ndarray]:
    """All columns by the names that outputs are asked for: those of export.table, energies and measures bare too."""
    table = export.table(solution)
    bare = {
        name.partition(".")[2]: values for name, values in table.items() if name.startswith(("energy.", "measure."))
    }
    return {**table, **{name: values for name, values in bare.items() if name not in table}}


def rows_of(solution: Solution, outputs: Sequence[str]) -> np.ndarray:
    """(N, width) of the columns of `columns_of`."""
    values: dict[str, Any] = (
        output_values(solution)
        if outputs
        else {
            "t": solution.t,
            **{key: getattr(solution, key) for key in SERIES},
            **{f"energy_{key}": series for key, series in solution.energy.items()},
        }
    )
    n = len(solution.t)
    return np.concatenate(
        [np.asarray(values[name], dtype=float).reshape(n, -1) for name, _ in columns_of(solution, outputs)], axis=1
    )


def record_of(
    segment: SteppedModel, z: np.ndarray, stream: str | Path | None, keep_rows: bool, resumed: bool = False
) -> Record:
    """Of a run from z (flat) on: whole states in memory, columns in memory, or a stream.

    Raises OutputError or ModelError.
    """
    table: Table | None = None
    outputs = segment.plan.outputs
    if keep_rows:
        seen = segment.observed([segment.stepper.state(z)])
        columns = columns_of(seen, outputs)
        table = Table(columns) if stream is None else StreamFile(stream, columns, resumed)
        if isinstance(table, StreamFile):
            cause = "the run did not come to its end"
            running = Status("interrupted", segment.plan.t0, None, cause, "What was streamed is there.")
            header = export.run_header(replace(seen, status=running))
            table.write_header({**header, "parameters": segment.p.tolist(), "outputs": list(outputs)})
    return Record([segment], segment.plan.save_every, table, outputs)
