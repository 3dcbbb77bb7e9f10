"""What errors of coordinates are measured by."""

from __future__ import annotations

import numpy as np

from runtime.contract.coordinates import followed
from runtime.contract.model import Model

SHARE = 1e-6  # of the largest amplitude of the same kind and unit: below this a coordinate does not move


def floored(model: Model, amplitudes: np.ndarray, share: float = SHARE) -> np.ndarray:
    """Amplitudes (N,) of what tells the motion (`followed`), none below a share of the largest of its kind and unit.

    1 where none of them moves.

    A mode that symmetry leaves at rounding is then measured by the modes that do move.
    """
    entries = {entry.name: (entry.kind, entry.unit) for entry in model.description.coordinates}
    kinds = [entries[name] for name in followed(model)[0]]
    least = np.array([share * max(a for a, k in zip(amplitudes, kinds, strict=True) if k == kind) for kind in kinds])
    found = np.maximum(amplitudes, least)
    return np.where(found > 0, found, 1.0)
