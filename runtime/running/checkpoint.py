"""Checkpoints: all that a run needs to go on exactly where it was, in one .npz file of plain arrays and a JSON text.

z is stored whole, with what the prepared program keeps behind the scheme's own part, so a resumed run makes the very
steps that an uninterrupted one makes.
"""

from __future__ import annotations

import hashlib
import json
import time
import zipfile
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from runtime.contract.files import OutputError, replacing, try_writing
from runtime.contract.model import ModelError
from runtime.running.header import FORMAT, CheckpointHeader

BROKEN = (
    OSError,
    ValueError,
    KeyError,
    TypeError,
    EOFError,
    AttributeError,
    NotImplementedError,  # of zipfile, for a compression that it does not know
    RuntimeError,
    zipfile.BadZipFile,
)
REMEDY = "start again, or take an older copy"
CHECKPOINT_SECONDS = 60.0


@dataclass
class CheckpointRule:
    """Where checkpoints go, and after how many major steps; None: after CHECKPOINT_SECONDS."""

    path: Path | None = None
    every: int | None = None

    def is_due(self, step: int, written: float) -> bool:
        """After a major step; written [s]: when the last one was, by the clock of `time.monotonic`."""
        if self.path is None:
            return False
        return time.monotonic() - written > CHECKPOINT_SECONDS if self.every is None else step % self.every == 0


@dataclass(frozen=True)
class Checkpoint:
    """header: the run in words; z (flat): the whole state; p (n_p,): parameters; arrays: what the record keeps."""

    header: CheckpointHeader
    z: np.ndarray
    p: np.ndarray
    arrays: dict[str, np.ndarray] = field(default_factory=dict)

    def write(self, path: str | Path) -> None:
        """To a temporary name, then renamed: there is always a whole one. Raises OutputError."""
        text, names = self.header.to_json(), json.dumps(list(self.arrays))
        with replacing(path) as temporary, open(temporary, "wb") as stream:
            np.savez(
                stream,
                allow_pickle=False,
                header=np.array(text),
                names=np.array(names),
                sha256=np.array(_digest(text, self.z, self.p, self.arrays)),
                z=self.z,
                p=self.p,
                **{f"record_{name}": values for name, values in self.arrays.items()},
            )


def claim(path: str | Path) -> None:
    """See before a run that its checkpoints can be written. Raises OutputError, also for a file that is none."""
    try_writing(path)
    target = Path(path)
    if target.exists() and target.stat().st_size > 0 and not _looks_like_one(target):
        raise OutputError(f"{path} is there and is no checkpoint; choose another name")


def _looks_like_one(path: Path) -> bool:
    try:
        with zipfile.ZipFile(path) as archive:
            return {"header.npy", "sha256.npy", "z.npy"} <= set(archive.namelist())
    except (OSError, zipfile.BadZipFile):
        return False


def _digest(text: str, z: np.ndarray, p: np.ndarray, arrays: Mapping[str, np.ndarray]) -> str:
    """SHA-256 of the header's text and of all arrays: whoever edits a checkpoint shall not go on with it."""
    found = hashlib.sha256(text.encode())
    for name, values in (("z", z), ("p", p), *arrays.items()):
        found.update(f"{name} {values.dtype.str} {values.shape}".encode())
        found.update(np.ascontiguousarray(values).tobytes())
    return found.hexdigest()


def read_checkpoint(path: str | Path) -> Checkpoint:
    """Raises ModelError if the file is not a whole checkpoint of this format."""
    try:
        with zipfile.ZipFile(path) as archive:
            damaged = archive.testzip()
        if damaged is not None:
            raise ModelError(f"checkpoint {path}", f"it is damaged ({damaged})", REMEDY)
        with np.load(path, allow_pickle=False) as data:
            text = str(data["header"])
            if json.loads(text)["format"] != FORMAT:
                raise ModelError(
                    str(path), "it is a checkpoint in another format", "run it with the version that wrote it"
                )
            z, p = data["z"], data["p"]
            arrays = {name: data[f"record_{name}"] for name in json.loads(str(data["names"]))}
            if str(data["sha256"]) != _digest(text, z, p, arrays):
                raise ModelError(f"checkpoint {path}", "it was edited since it was written", REMEDY)
            return Checkpoint(CheckpointHeader.from_json(text), z, p, arrays)
    except ModelError:
        raise
    except BROKEN as error:
        reason = getattr(error, "strerror", None) or error
        raise ModelError(str(path), f"it is not a whole checkpoint ({reason})", REMEDY) from error
