"""Lengths and angles in one measure: which rows are distances, and the size of a mechanism."""

from __future__ import annotations

import numpy as np

from runtime.contract.model import Model

SMALLEST_ARM = 1e-9  # m: less is the rounding dust of an arm that is zero


def length_rows(model: Model) -> np.ndarray:
    """(n_c,) which constraint rows are distances [m]."""
    return np.array([row.unit == "m" for row in model.description.constraints], dtype=bool)


def turning_columns(model: Model) -> np.ndarray:
    """(n,) which coordinates are angles or Euler parameters."""
    return np.array([coordinate.turns for coordinate in model.description.coordinates], dtype=bool)


def mechanism_length(model: Model, C_q: np.ndarray) -> float:
    """The largest lever arm in C_q (n_c x n) [m], 1 if there is none."""
    arms = np.abs(np.asarray(C_q)[np.ix_(length_rows(model), turning_columns(model))])
    longest = float(arms.max(initial=0.0))
    return longest if longest > SMALLEST_ARM else 1.0
