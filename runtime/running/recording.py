"""Which record a run has: of whole states, or of columns."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from runtime.running.record import Record
from runtime.running.stepped_model import SteppedModel


def record_of(
    segment: SteppedModel, z: np.ndarray, stream: str | Path | None, keep_rows: bool, resumed: str = ""
) -> Record:
    """Of a run from z (flat) on: whole states in memory, or rows of columns. Raises OutputError or ModelError."""
    if not keep_rows:
        return Record([segment], segment.plan.seen_steps, segment.plan.steps)
    from runtime.running.columns import ColumnRecord

    return ColumnRecord(segment, z, stream, resumed)
