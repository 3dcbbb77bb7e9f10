"""Samples in a folder that grows: header.json and samples.bin, rows of little-endian doubles.

A row is all columns of a sample one after another; the header says how long each is. Rows are appended in blocks. What
a crash leaves is readable: the rows that are complete, and a header that does not yet say how the run ended.
"""

from __future__ import annotations

import json
import os
import secrets
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

try:
    import fcntl
except ImportError:  # Windows
    fcntl = None  # type: ignore[assignment]

from runtime.contract.errors import ModelError
from runtime.contract.files import WRITING, OutputError, write_text

FORMAT = "symgen stream 1"
HEADER, ROWS = "header.json", "samples.bin"
ROWS_A_BLOCK = 4096
LONGEST_ROW = 1_000_000  # numbers


class Table:
    """Rows of columns in memory."""

    def __init__(self, columns: Sequence[tuple[str, Sequence[int]]]) -> None:
        self.columns = [(name, tuple(shape)) for name, shape in columns]
        self._blocks: list[np.ndarray] = []
        self.rows = 0

    @property
    def width(self) -> int:
        """Numbers a row."""
        return sum(int(np.prod(shape, dtype=int)) for _, shape in self.columns)

    def append(self, block: np.ndarray) -> None:
        """Add rows (N, width)."""
        self._blocks.append(block)
        self.rows += len(block)

    def keep(self, rows: int) -> None:
        """Drop what follows the first rows."""
        whole = self.all_rows()[:rows].copy()
        self._blocks, self.rows = [whole], len(whole)

    def all_rows(self) -> np.ndarray:
        """(rows, width)."""
        return np.concatenate(self._blocks) if self._blocks else np.zeros((0, self.width))


class StreamFile(Table):
    """Rows of columns in a folder. Raises OutputError where it cannot be written.

    resumed: the `run` of the stream that is continued; ModelError is raised where the folder holds no such stream, and
    nothing in it is changed. run: what its header says of whose stream it is; nobody can guess it.
    """

    def __init__(self, folder: str | Path, columns: Sequence[tuple[str, Sequence[int]]], resumed: str = "") -> None:
        super().__init__(columns)
        self.folder, self.run = Path(folder), resumed or secrets.token_hex(16)
        if resumed:
            self._refuse_other_runs()
        try:
            if not resumed:
                self.folder.mkdir(parents=True, exist_ok=True)
                self._refuse_foreign()
            # a link is not followed: what it leads to is no part of the stream
            flags = os.O_RDWR | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0)
            self._file = open(os.open(self.folder / ROWS, flags | (0 if resumed else os.O_CREAT), 0o644), "r+b")
        except (OSError, ValueError) as error:
            reason = getattr(error, "strerror", None) or error
            raise OutputError(
                f"{self.folder} cannot take a stream of samples ({reason}); choose another place"
            ) from error
        self._lock()
        if not resumed:
            self._file.truncate(0)
        self.rows = os.fstat(self._file.fileno()).st_size // self._row_bytes

    def _refuse_other_runs(self) -> None:
        """Raises ModelError where the folder does not hold the stream of this run."""
        item, remedy = f"folder {self.folder}", "name the folder of the run: resume(..., stream=...)"
        try:
            header = read_header(self.folder)
        except ModelError as error:
            raise ModelError(item, f"it is not the stream of the run that is resumed ({error})", remedy) from error
        if header.get("run") != self.run:
            raise ModelError(item, "it holds the stream of another run than the one that is resumed", remedy)

    def _refuse_foreign(self) -> None:
        """A folder that holds files, and is not a stream of ours, is somebody's. Raises OutputError."""
        files = sorted(path.name for path in self.folder.iterdir() if not path.name.startswith(WRITING))
        started = files == [ROWS] and (self.folder / ROWS).stat().st_size == 0  # by another run, or one that was killed
        if started or not files:
            return
        try:
            read_header(self.folder)
        except ModelError as error:
            raise OutputError(
                f"{self.folder} holds {files[0]} and is not a stream of samples; choose a new or an empty folder"
            ) from error

    def _lock(self) -> None:
        """One run writes a stream at a time; the lock goes with the process. Raises OutputError."""
        if fcntl is None:
            return
        try:
            fcntl.flock(self._file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            self._file.close()
            raise OutputError(f"{self.folder} is being written by another run; choose another folder") from None
        except OSError:  # a file system without locks
            return

    @property
    def _row_bytes(self) -> int:
        return 8 * self.width

    def append(self, block: np.ndarray) -> None:
        """Add rows (N, width); they are handed to the system at once."""
        try:
            self._file.seek(self.rows * self._row_bytes)
            self._file.write(np.ascontiguousarray(block, dtype="<f8").tobytes())
            self._file.flush()
        except OSError as error:
            raise OutputError(f"{self.folder} cannot take more samples ({error.strerror}); free some space") from error
        self.rows += len(block)

    def keep(self, rows: int) -> None:
        """Drop what follows the first rows."""
        self._file.truncate(rows * self._row_bytes)
        self._file.flush()
        self.rows = rows

    def all_rows(self) -> np.ndarray:
        """(rows, width), read back."""
        return np.fromfile(self.folder / ROWS, dtype="<f8").reshape(-1, self.width)

    def write_header(self, header: Mapping[str, Any]) -> None:
        """Say what is in the rows, and later how the run ended."""
        columns = [[name, list(shape)] for name, shape in self.columns]
        write_text(self.folder / HEADER, json.dumps({"format": FORMAT, "run": self.run, "columns": columns, **header}))

    def close(self) -> None:
        """Nothing follows."""
        self._file.close()


def read_header(folder: str | Path) -> dict[str, Any]:
    """The header of a stream. Raises ModelError if there is none."""
    try:
        header = json.loads((Path(folder) / HEADER).read_text(encoding="utf-8"))
    except (OSError, ValueError, RecursionError) as error:
        raise ModelError(f"{folder} is not a stream of samples ({error})") from error
    if not isinstance(header, dict) or header.get("format") != FORMAT:
        raise ModelError(f"{folder} is a stream in another format; simulate again")
    if not _are_columns(header.get("columns")):
        raise ModelError(f"{folder} is a stream whose header is damaged; simulate again")
    return header


def _are_columns(columns: Any) -> bool:
    """[[name, [lengths]], ...] of a row that is not empty and not absurdly long."""
    if not isinstance(columns, list) or not all(isinstance(one, list) and len(one) == 2 for one in columns):
        return False
    lengths = [length for _, shape in columns for length in (shape if isinstance(shape, list) else [-1])]
    if not all(isinstance(one, int) and 0 <= one <= LONGEST_ROW for one in lengths):
        return False
    return 0 < Table(columns).width <= LONGEST_ROW


def read_blocks(folder: str | Path, rows: int = ROWS_A_BLOCK) -> Iterator[dict[str, np.ndarray]]:
    """Columns by name, "t" first, so many samples at a time: memory stays bounded. Raises ModelError."""
    columns = [(str(name), tuple(shape)) for name, shape in read_header(folder)["columns"]]
    width = Table(columns).width
    try:
        with open(Path(folder) / ROWS, "rb") as file:
            while len(data := file.read(8 * width * rows)) >= 8 * width:
                yield split(np.frombuffer(data[: len(data) // (8 * width) * 8 * width], dtype="<f8"), columns)
    except OSError as error:
        raise ModelError(f"{folder} has lost its samples ({error.strerror})") from error


def split(values: np.ndarray, columns: Sequence[tuple[str, Sequence[int]]]) -> dict[str, np.ndarray]:
    """Columns (N, *shape) by name from rows."""
    table = values.reshape(-1, Table(columns).width)
    found, first = {}, 0
    for name, shape in columns:
        size = int(np.prod(shape, dtype=int))
        found[name] = table[:, first : first + size].reshape(len(table), *shape)
        first += size
    return found
