"""How far the flexible bodies of a run were taken: deflection over length, and slope."""

from __future__ import annotations

import numpy as np

from runtime.results.solution import Solution
from runtime.running.checks.deflection import flexible_bodies

AT_ONCE = 1024  # samples


def limits(solution: Solution) -> dict[str, float]:
    """`deflection.body`, largest over its length, and `slope.body` [rad], largest turn, of the saved samples.

    Both are of the body's drawn points against its axes; a run stops beyond the limits of the status
    `deflection_too_large`.
    """
    found = {}
    for name, columns, length, shapes, turns in flexible_bodies(solution.model, solution.parameters):
        q = solution.q[:, columns]
        found[f"deflection.{name}"] = _largest(shapes, q) / length
        found[f"slope.{name}"] = _largest(turns, q)
    return found


def _largest(columns: np.ndarray, q: np.ndarray) -> float:
    """Largest length of columns (points, 3, nf) q over the samples q (N, nf)."""
    blocks = (q[first : first + AT_ONCE] for first in range(0, len(q), AT_ONCE))
    sizes = [float(np.square(columns @ block.T).sum(axis=1).max(initial=0.0)) for block in blocks]
    return float(np.sqrt(max(sizes, default=0.0)))
