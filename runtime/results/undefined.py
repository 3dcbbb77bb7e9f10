"""Measures without a value at a sample: nobody reads NaN of a run that completed without being told."""

from __future__ import annotations

import numpy as np

from runtime.contract.status import Event
from runtime.results.samples import Samples


def undefined_measures(solution: Samples) -> list[Event]:
    """An event for the measures and rates that have no finite value at a sample of a motion that has, at the first."""
    if not solution.model.measures:
        return []
    known = np.isfinite(solution.q).all(axis=1) & np.isfinite(solution.q_dot).all(axis=1)
    bad = known[:, None] & ~np.isfinite(solution.measures)
    names = [name for name, column in zip(solution.model.measures, bad.T, strict=True) if column.any()]
    if not names:
        return []
    rows = np.flatnonzero(bad.any(axis=1))
    text = (
        f"{', '.join(names)}: no finite value at {len(rows)} of {len(solution.t)} samples, where what is measured has "
        "none (an angle between directions that vanish, a rate at a corner); the motion is not touched"
    )
    return [Event(float(solution.t[rows[0]]), "measure_undefined", text)]
