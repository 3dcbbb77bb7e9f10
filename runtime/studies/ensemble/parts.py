"""A study on the disk: its question, its samples, its model, and the parts that are finished, each with its hash.

    study.json      the question and the SHA-256 of the samples
    samples.bin     (cases, parameters and initial values), little-endian doubles
    model/          a copy of the generated folder
    part-00012.bin  SHA-256 of what follows, then rows (cases of the part, 2 + width): status, time reached [s], values

A part is written whole or not at all; one that is damaged counts as missing.
"""

from __future__ import annotations

import hashlib
import json
import shutil
from dataclasses import replace
from pathlib import Path

import numpy as np

from runtime.contract.errors import ArgumentError
from runtime.contract.files import OutputError, replacing, write_text
from runtime.contract.model import Model
from runtime.studies.ensemble.question import FORMAT, Question

HEAD = 32


class StudyFolder:
    """A folder that a study is kept in. Raises OutputError if it cannot be written, ArgumentError if it is not ours."""

    def __init__(self, path: str | Path) -> None:
        self.path = Path(path)

    def begin(self, model: Model, question: Question, table: np.ndarray) -> Question:
        """Write what belongs to the study, or see that it is there. The question with the hash of its samples."""
        samples = np.ascontiguousarray(table, dtype="<f8").tobytes()
        asked = replace(question, samples=hashlib.sha256(samples).hexdigest())
        header = self.path / "study.json"
        if header.exists():
            if _question(header) != asked:
                raise ArgumentError(
                    f"folder {self.path}", "holds another study", "choose another folder, or ask what was asked there"
                )
            return asked
        if self.path.exists() and any(self.path.iterdir()):
            raise ArgumentError(f"folder {self.path}", "is not empty and holds no study", "choose another folder")
        self._copy_model(model)
        with replacing(self.path / "samples.bin") as temporary:
            temporary.write_bytes(samples)
        write_text(header, asked.as_text() + "\n")
        return asked

    def _copy_model(self, model: Model) -> None:
        if not model.folder:
            raise ArgumentError(
                f"model {model.name}", "was not loaded from a generated folder", "workers load it: use load_model"
            )
        try:
            shutil.copytree(model.folder, self.path / "model", ignore=shutil.ignore_patterns("__pycache__"))
        except (OSError, shutil.Error) as error:
            raise OutputError(f"{self.path} cannot take a copy of {model.folder}: {error}") from error

    def question(self, key: str) -> Question:
        """What is asked here. Raises ArgumentError if it is not the question with this hash."""
        found = _question(self.path / "study.json")
        if found.key != key:
            raise ArgumentError(f"folder {self.path}", "holds another study than was meant", "start the study again")
        return found

    def table(self, question: Question) -> np.ndarray:
        """The samples. Raises ArgumentError if they are damaged."""
        content = (self.path / "samples.bin").read_bytes()
        if hashlib.sha256(content).hexdigest() != question.samples:
            raise ArgumentError(f"{self.path / 'samples.bin'}", "is damaged", "start the study in another folder")
        return np.frombuffer(content, dtype="<f8").reshape(question.cases, -1).astype(float)

    def room(self, shape: tuple[int, int]) -> np.ndarray:
        """Room for all rows, in a file instead of memory."""
        try:
            return np.memmap(self.path / "values.bin", dtype="<f8", mode="w+", shape=shape)
        except OSError as error:
            raise OutputError(f"{self.path} has no room for the results ({error.strerror})") from error

    def _part(self, number: int) -> Path:
        return self.path / f"part-{number:05d}.bin"

    def write(self, number: int, rows: np.ndarray) -> None:
        """Keep a finished part."""
        content = np.ascontiguousarray(rows, dtype="<f8").tobytes()
        with replacing(self._part(number)) as temporary:
            temporary.write_bytes(hashlib.sha256(content).digest() + content)

    def read(self, number: int, cases: int) -> np.ndarray | None:
        """Rows of a part, None if it is not there or damaged."""
        try:
            content = self._part(number).read_bytes()
        except FileNotFoundError:
            return None
        if hashlib.sha256(content[HEAD:]).digest() != content[:HEAD]:
            return None
        return np.frombuffer(content[HEAD:], dtype="<f8").reshape(cases, -1)


def _question(header: Path) -> Question:
    try:
        plain = json.loads(header.read_text(encoding="utf-8"))
        if plain.pop("format") != FORMAT:
            raise KeyError("format")
        return Question(**plain)
    except (OSError, ValueError, KeyError, TypeError, AttributeError) as error:
        raise ArgumentError(f"{header}", f"is not the header of a study ({error})", "choose another folder") from error
