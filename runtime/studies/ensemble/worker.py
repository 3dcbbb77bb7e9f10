"""What a worker of an executor does: it gets a folder, a hash and the number of a part, and leaves the part there."""

from __future__ import annotations

from functools import lru_cache
from pathlib import Path

import numpy as np

from runtime.contract.loading import load_model
from runtime.studies.ensemble.parts import StudyFolder
from runtime.studies.ensemble.rows import Rows


def work_on(folder: str, key: str, number: int, threads: int = 1) -> int:
    """Run one part of the study with this hash, in so many threads. Its number; the rows are in the folder."""
    rows = _rows(folder, key)
    first, stop = rows.question.parts(rows.lanes.steps)[number]
    place = StudyFolder(folder)
    if place.read(number, stop - first) is not None:
        return number
    parts = [part for _, part in rows.in_threads([(first, stop)], threads, lambda: False)]
    place.write(number, np.concatenate(parts))
    return number


@lru_cache(maxsize=4)
def _rows(folder: str, key: str) -> Rows:
    """What a process needs for all parts of a study, made once."""
    place = StudyFolder(folder)
    question = place.question(key)
    model = load_model(Path(folder) / "model", question.digest)
    return Rows(model, question, place.table(question))
