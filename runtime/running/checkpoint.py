"""Checkpoints: all that a run needs to go on exactly where it was, in one .npz file of plain arrays and a JSON text.

z is stored whole, with what the prepared program keeps behind the scheme's own part, so a resumed run makes the very
steps that an uninterrupted one makes.
"""

from __future__ import annotations

import hashlib
import json
import zipfile
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from runtime.contract.files import replacing
from runtime.contract.model import Model, ModelError
from runtime.schemes.options import SchemeError

FORMAT = "symgen checkpoint 1"


@dataclass(frozen=True)
class Checkpoint:
    """header: the run in JSON; z: the whole state; p: parameters; arrays: what the record keeps."""

    header: dict[str, Any]
    z: np.ndarray
    p: np.ndarray
    arrays: dict[str, np.ndarray] = field(default_factory=dict)

    def write(self, path: str | Path) -> None:
        """To a temporary name, then renamed: there is always a whole one. Raises OutputError."""
        text = json.dumps({"format": FORMAT, **self.header, "arrays": list(self.arrays)})
        with replacing(path) as temporary, open(temporary, "wb") as stream:
            np.savez(
                stream,
                allow_pickle=False,
                header=np.array(text),
                sha256=np.array(self._digest(text)),
                z=self.z,
                p=self.p,
                **{f"record_{name}": values for name, values in self.arrays.items()},
            )

    def _digest(self, text: str) -> str:
        """SHA-256 of the header's text and of all arrays: whoever edits a checkpoint shall not go on with it."""
        found = hashlib.sha256(text.encode())
        for name, values in (("z", self.z), ("p", self.p), *self.arrays.items()):
            found.update(f"{name} {values.dtype.str} {values.shape}".encode())
            found.update(np.ascontiguousarray(values).tobytes())
        return found.hexdigest()


def read_checkpoint(path: str | Path) -> Checkpoint:
    """Raises ModelError if the file is not a whole checkpoint."""
    try:
        with zipfile.ZipFile(path) as archive:
            damaged = archive.testzip()
            if damaged is not None:
                raise ModelError(f"checkpoint {path} is damaged ({damaged}); start again, or take an older copy")
        with np.load(path, allow_pickle=False) as data:
            text = str(data["header"])
            header = json.loads(text)
            if header["format"] != FORMAT:
                raise ModelError(f"{path} is a checkpoint in another format; run it with the version that wrote it")
            found = Checkpoint(
                header, data["z"], data["p"], {name: data[f"record_{name}"] for name in header["arrays"]}
            )
            if str(data["sha256"]) != found._digest(text):
                raise ModelError(
                    f"checkpoint {path} was edited since it was written; start again, or take an older copy"
                )
            return found
    except ModelError:
        raise
    except (
        OSError,
        ValueError,
        KeyError,
        TypeError,
        EOFError,
        AttributeError,
        NotImplementedError,
        RuntimeError,
        zipfile.BadZipFile,
    ) as error:
        reason = getattr(error, "strerror", None) or error
        raise ModelError(f"{path} is not a whole checkpoint ({reason}); start again, or take an older copy") from error


def check_model(checkpoint: Checkpoint, model: Model, path: str | Path) -> None:
    """Raises ModelError if the checkpoint belongs to another model."""
    header = checkpoint.header
    if header["digest"] != model.digest:
        same = " (the same scene, generated anew with other content)" if header["model"] == model.name else ""
        raise ModelError(
            f"checkpoint {path} belongs to model {header['model']} with manifest {header['digest'][:12]}, "
            f"not to {model.name} with {model.digest[:12]}{same}; give the model that it was made with"
        )


def check_settings(checkpoint: Checkpoint, wanted: Mapping[str, Any], path: str | Path) -> None:
    """Raises SchemeError if a setting that was said again is another one. None was not said."""
    for name, value in wanted.items():
        kept = checkpoint.header[name]
        if value is not None and json.loads(json.dumps(value)) != kept:
            raise SchemeError(
                f"checkpoint {path} was made with {name} = {kept!r}, not {value!r}; a run goes on with "
                "its own settings: leave this one out, or start a new run"
            )
