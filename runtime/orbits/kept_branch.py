"""A branch in a file: its points and what passes between them, so that a continuation goes on after the last of them.

Only places are kept, (value, period, states, tangent); what is known of them is computed anew. The file is written
behind every point, under another name first.
"""

from __future__ import annotations

import zipfile
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from runtime.contract.errors import ArgumentError
from runtime.contract.files import replacing
from runtime.orbits.branch import Point, Special


@dataclass(frozen=True)
class Place:
    """Of a point, or of a special one by its kind ("": none)."""

    kind: str
    value: float
    period: float
    x: np.ndarray
    tangent: np.ndarray
    begins: bool


class KeptBranch:
    """In `path`, of a question that is a text: what tells one branch from another."""

    def __init__(self, path: Path, question: str) -> None:
        self._path, self._question = path, question

    def places(self) -> tuple[list[Place], bool]:
        """(what is kept, is the branch complete?). Raises ArgumentError for another branch's file, or a broken one."""
        if not self._path.exists():
            return [], False
        try:
            with np.load(self._path, allow_pickle=False) as kept:
                question, complete = str(kept["question"]), bool(kept["complete"])
                columns = [kept[name] for name in ("kind", "value", "period", "x", "tangent", "begins")]
        except (OSError, ValueError, KeyError, zipfile.BadZipFile) as error:
            problem = f"{self._path} cannot be read: {error}"
            raise ArgumentError("resume", problem, "name another folder, or remove the file") from None
        if question != self._question:
            problem = f"{self._path} holds the branch of another model, range, period or scheme"
            raise ArgumentError("resume", problem, "ask as it was asked, or name another folder")
        rows = zip(*columns, strict=True)
        return [Place(str(a), float(b), float(c), x, tangent, bool(d)) for a, b, c, x, tangent, d in rows], complete

    def keep(self, points: Sequence[Point], specials: Sequence[Special], complete: bool) -> None:
        """Write them. Raises OutputError."""
        kinds = [*("" for _ in points), *(one.kind for one in specials)]
        all_ = [*points, *(one.point for one in specials)]
        with replacing(self._path) as temporary, temporary.open("wb") as file:
            np.savez(
                file, question=np.array(self._question), complete=np.array(complete), kind=np.array(kinds),
                value=np.array([one.value for one in all_]), period=np.array([one.period for one in all_]),
                x=np.array([one.x for one in all_]), tangent=np.array([one.tangent for one in all_]),
                begins=np.array([one.begins for one in all_]),
            )  # fmt: skip
