"""What a coordinate or a constraint row measures, by its name: metres, radians, or parts of a unit quaternion."""

from __future__ import annotations

import numpy as np

from runtime.contract.model import Model

# last parts of the labels of rows that are distances; the others are angles, or products and parts of unit vectors
LENGTH_ROWS = frozenset(("x", "y", "z", "normal", "across_x", "across_y", "travel", "length"))
UNIT_ROWS = frozenset(("angle", "parallel_x", "parallel_y", "twist", "cross", "norm", "e0", "e1", "e2", "e3"))
SMALLEST_ARM = 1e-9  # m: less is the rounding dust of an arm that is zero


def unit(coordinate: str, derivative: int = 0) -> str:
    """SI unit of a coordinate (angles: `theta`, `angle`; Euler parameters: e0 ... e3) or its derivatives."""
    last = coordinate.rpartition(".")[2]
    base = "rad" if last.startswith(("theta", "angle")) else "1" if last in ("e0", "e1", "e2", "e3") else "m"
    return base + ("", "/s", "/s^2")[derivative]


def turns(coordinate: str) -> bool:
    """Is a coordinate an angle or an Euler parameter?"""
    return unit(coordinate) != "m"


def length_rows(model: Model) -> np.ndarray:
    """(n_c,) which constraint rows are distances [m]."""
    return np.array([label.rpartition(".")[2] in LENGTH_ROWS for label in model.constraints], dtype=bool)


def mechanism_length(model: Model, C_q: np.ndarray) -> float:
    """The largest lever arm in C_q [m], 1 if there is none."""
    turning = np.array([turns(name) for name in model.coordinates], dtype=bool)
    arms = np.abs(np.asarray(C_q)[np.ix_(length_rows(model), turning)])
    longest = float(arms.max(initial=0.0))
    return longest if longest > SMALLEST_ARM else 1.0
