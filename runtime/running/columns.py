"""What is kept of a run as rows of columns, in memory or in a stream: blocks of states are observed and forgotten.

Of the whole states the first and the last are kept.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from runtime.contract.errors import ModelError
from runtime.contract.files import OutputError
from runtime.contract.status import Status
from runtime.results import export
from runtime.results.stream import StreamFile, Table, split
from runtime.running.record import Record, by_segment
from runtime.running.stepped_model import SteppedModel
from runtime.solutions.observe import concatenated
from runtime.solutions.solution import Solution

BLOCK = 256  # samples that wait to be written
SERIES = tuple(key for key in export.ARRAYS if key not in ("parameters", "t"))


class ColumnRecord(Record):
    """Of a run of a segment from z (flat) on; stream: a folder, None for memory; resumed: the run of the stream.

    Raises OutputError or ModelError.
    """

    def __init__(self, segment: SteppedModel, z: np.ndarray, stream: str | Path | None, resumed: str) -> None:
        super().__init__([segment], segment.plan.seen_steps, segment.plan.steps)
        self.outputs, self.first = segment.plan.outputs, None
        observed = segment.observed([segment.state(z)])
        columns = [(name, values.shape[1:]) for name, values in columns_of(observed, self.outputs).items()]
        self._table = Table(columns) if stream is None else StreamFile(stream, columns, resumed)
        self._stream = self._table if isinstance(self._table, StreamFile) else None
        if self._stream is not None:
            self.folder, self.run = self._stream.folder, self._stream.run
        cause = "the run did not come to its end"
        running = Status("interrupted", segment.plan.t0, None, cause, "The samples streamed so far are kept.")
        self._write_header(replace(observed, status=running), segment.p)

    first: tuple[int, np.ndarray] | None

    @property
    def rows(self) -> int:  # type: ignore[override]
        """Samples in the table."""
        return self._table.rows

    def _write_header(self, solution: Solution, p: np.ndarray) -> None:
        if self._stream is not None:
            header = {**export.run_header(solution), "parameters": p.tolist(), "outputs": list(self.outputs)}
            self._stream.write_header(header)

    def add(self, segment: SteppedModel, rows: np.ndarray) -> None:
        """See Record."""
        super().add(segment, rows)
        if self.first is None and self.samples:
            self.first = (self.samples[0][0], self.samples[0][1][0])
        if sum(len(part) for _, part in self.samples) >= BLOCK:
            self.flush()

    def flush(self) -> None:
        """Write the rows of the samples that wait. Raises OutputError."""
        for segment, part in by_segment(self.samples):
            observed = concatenated([self.segments[segment].observed(part)], self.segments[0].model)
            self._table.append(rows_of(observed, self.outputs))
        self.samples = []

    def close(self) -> None:
        """A stream is whole as far as it was written, and others may write to its folder."""
        if self._stream is not None:
            self._stream.close()

    def drop_from(self, step: int) -> None:
        """See Record."""
        super().drop_from(step)
        if not self.samples:
            self._table.keep(min(self._table.rows, -(-step // self.every)))

    def arrays(self) -> dict[str, np.ndarray]:
        """See Record; table (rows, width). Rows in a stream stay there."""
        self.flush()
        owners, states = zip(*self._ends(None), strict=True) if self.first is not None else ((), ())
        found = {"sample_segments": np.array(owners, dtype=np.int64), "samples": np.concatenate([np.zeros(0), *states])}
        return found if self._stream is not None else found | {"table": self._table.all_rows()}

    def restore(self, arrays: dict[str, np.ndarray], rows: int, last_step: int) -> None:
        """See Record; a stream is cut to so many rows."""
        super().restore(arrays, rows, last_step)
        self.first, self.samples = ((self.samples[0][0], self.samples[0][1][0]) if self.samples else None), []
        if "table" in arrays:
            self._table.append(arrays["table"])
        if self._table.rows < rows:
            raise ModelError(
                f"the stream holds {self._table.rows} samples, the checkpoint was written after {rows}; "
                "give the stream that belongs to the checkpoint"
            )
        self._table.keep(rows)

    def solution(self, last: tuple[int, np.ndarray]) -> Solution:
        """Of the first and the last whole state, with the columns that were kept in memory."""
        self.samples = [(segment, z[None]) for segment, z in self._ends(last)]
        found, self.samples = super().solution(last), []
        if self._stream is not None:
            return found
        return replace(found, outputs=dict(split(self._table.all_rows(), self._table.columns)))

    def finished(self, solution: Solution) -> Solution:
        """See Record; a stream tells how the run ended."""
        try:
            self._write_header(solution, solution.parameters)
        except OutputError as error:  # the header that is there says that the run did not come to its end
            return solution.but(status=Status("output_failed", solution.status.time, None, str(error)))
        return solution

    def _ends(self, last: tuple[int, np.ndarray] | None) -> list[tuple[int, np.ndarray]]:
        """The first and the last state, once where they are of one step."""
        found = list(filter(None, (self.first, last)))
        return found[:1] if len(found) == 2 and found[0][1][1] == found[1][1][1] else found


def columns_of(solution: Solution, outputs: Sequence[str]) -> dict[str, np.ndarray]:
    """(N, ...) by name, "t" first: what a sample keeps, all there is if no outputs are named. Raises ModelError."""
    if not outputs:
        energies = {f"energy_{key}": values for key, values in solution.energy.items()}
        return {key: np.asarray(getattr(solution, key)) for key in ("t", *SERIES)} | energies
    known = output_values(solution)
    for name in outputs:
        if name not in known:
            raise ModelError(
                f"model {solution.model.name} has no output {name!r}; it has "
                f"{', '.join(list(known)[1:25])}{', ...' if len(known) > 25 else ''}"
            )
    return {name: known[name] for name in ("t", *outputs)}


def output_values(solution: Solution) -> dict[str, np.ndarray]:
    """All columns by the names that outputs are asked for: those of export.columns, energies and measures bare too."""
    table = export.columns(solution)
    table = {name: values for name, values in table.items() if not name.endswith(".friction_heat")}  # of all samples
    bare = {
        name.partition(".")[2]: values for name, values in table.items() if name.startswith(("energy.", "measure."))
    }
    return {**table, **{name: values for name, values in bare.items() if name not in table}}


def rows_of(solution: Solution, outputs: Sequence[str]) -> np.ndarray:
    """(N, width) of the columns of `columns_of`."""
    n, columns = len(solution.t), columns_of(solution, outputs).values()
    return np.concatenate([np.asarray(values, dtype=float).reshape(n, -1) for values in columns], axis=1)
