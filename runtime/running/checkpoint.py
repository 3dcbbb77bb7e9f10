"""Checkpoints: all that a run needs to go on exactly where it was, in one .npz file of plain arrays and a JSON text.

z is stored whole, with what the prepared program keeps behind the scheme's own part, so a resumed run makes the very
steps that an uninterrupted one makes.
"""

from __future__ import annotations

import hashlib
import json
import zipfile
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from runtime.contract.errors import ModelError
from runtime.contract.files import OutputError, replacing, try_writing
from runtime.contract.model import EmittedModel

if TYPE_CHECKING:
    from runtime.running.run import Run

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


FORMAT = "symgen checkpoint 10"


@dataclass(frozen=True)
class Checkpoint:
    """header: what `checkpoint_of` says of the run; z (flat): the whole state; p (n_p,): parameters; arrays: what the
    record keeps.
    """

    header: dict[str, Any]
    z: np.ndarray
    p: np.ndarray
    arrays: dict[str, np.ndarray] = field(default_factory=dict)

    def write(self, path: str | Path) -> None:
        """To a temporary name, then renamed: there is always a whole one. Raises OutputError."""
        text, names = json.dumps({"format": FORMAT, **self.header}), json.dumps(list(self.arrays))
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

    def check_model(self, model: EmittedModel, path: str | Path) -> None:
        """Raises ModelError if the checkpoint belongs to another model."""
        name, digest = self.header["model"], self.header["digest"]
        if digest != model.digest:
            same = " (the same scene, generated anew with other content)" if name == model.name else ""
            raise ModelError(
                f"checkpoint {path}",
                f"it belongs to model {name} with manifest {digest[:12]}, not to {model.name} with "
                f"{model.digest[:12]}{same}",
                "give the model that it was made with",
            )
        if self.header["driven_by"] != model.driven_by:
            raise ModelError(
                f"checkpoint {path}", "its run was driven by other inputs", "give the inputs that it was made with"
            )


def claim(path: str | Path) -> None:
    """See before a run that its checkpoints can be written. Raises OutputError, also for a file that is none."""
    try_writing(path)
    target = Path(path)
    if target.exists() and target.stat().st_size > 0 and not _looks_like_one(target):
        raise OutputError(f"{path} is there and is not a checkpoint; choose another name")


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
            header = json.loads(text)
            if header.pop("format") != FORMAT:
                raise ModelError(
                    str(path), "it is a checkpoint in another format", "run it with the version that wrote it"
                )
            z, p = data["z"], data["p"]
            arrays = {name: data[f"record_{name}"] for name in json.loads(str(data["names"]))}
            if str(data["sha256"]) != _digest(text, z, p, arrays):
                raise ModelError(f"checkpoint {path}", "it was edited since it was written", REMEDY)
            return Checkpoint(header, z, p, arrays)
    except ModelError:
        raise
    except BROKEN as error:
        reason = getattr(error, "strerror", None) or error
        raise ModelError(str(path), f"it is not a whole checkpoint ({reason})", REMEDY) from error


def checkpoint_of(run: Run) -> Checkpoint:
    """All that a run needs to go on from where it is.

    How far: steps done, rows streamed, what was kept. segments: q_i of each so far, in the order of the record;
    segment: the one under way. position: all coordinates there, which tell a generator of variants where it is.
    monitor, guard: what checks compare with. schedule: what drives it remembers. impulses: of the segments, which may
    be told later: time, energy, jumps of the rates. happened: latest times of each event [s].
    """
    segment, z, record, state = run.segment, run.z, run.record, run.problem.state
    model, arrays = record.segments[0].model, record.arrays()
    if run.comparison_times is not None:
        arrays |= {f"mark_{name}": values for name, values in run.comparison_times.arrays().items()}
    if run.earlier is not None:
        arrays["earlier"] = run.earlier
    arrays |= {"start_p": run.problem.p, "start_q": state.q, "start_q_dot": state.q_dot}
    impulses = [(at, one) for each in record.segments for at, one in sorted(each.impulses.items())]
    header = {
        "model": model.name,
        "digest": model.digest,
        "driven_by": model.driven_by,
        "scene_toml": model.scene_toml,
        "plan": record.segments[0].plan.numbers,
        "initial_changes": run.initial_changes,
        "step": run.step,
        "last_step": record.last_step,
        "rows": record.rows,
        "stream": None if record.folder is None else str(record.folder),
        "stream_run": record.run,
        "events": [asdict(event) for event in run.events],
        "segments": [list(segment.model.q_i) for segment in record.segments],
        "segment": record.segments.index(segment),
        "position": segment.observed([segment.state(z)]).q[0].tolist(),
        "monitor": segment.monitor.memory(),
        "guard": run.singularity.memory(),
        "schedule": {} if run.schedule is None else run.schedule.memory(),
        "impulses": [[at, one.energy, *one.jumps.tolist()] for at, one in impulses],
        "happened": run.event_handler.memory(),
    }
    return Checkpoint(header, z, segment.p, arrays)
