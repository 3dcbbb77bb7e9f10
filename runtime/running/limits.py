"""How far a run was taken: deflection over length, slope, missing shapes, buckling, Euler angles that are singular."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from runtime.results.missing import missing_sections, missing_shapes, missing_stresses, singular_angles
from runtime.results.solution import Solution
from runtime.running.buckling import ADVICE, buckling
from runtime.running.monitor import flexible_bodies

AT_ONCE = 1024  # samples


def with_limits(solution: Solution) -> Solution:
    """The solution with what was found in its statistics, in its events, and in its status beyond a buckling load."""
    shares, missing = missing_shapes(solution)
    left_out, unstressed = missing_stresses(solution)
    not_held, unloaded = missing_sections(solution)
    pushed, beyond = buckling(solution)
    events, status = (
        [*solution.events, *missing, *unstressed, *unloaded, *beyond, *singular_angles(solution)],
        solution.status,
    )
    counted = {"events": len(events)} if events else {}
    if beyond and status.ok:
        status = replace(status, cause=beyond[0].text, advice=ADVICE)
    stats = {**solution.stats, **limits(solution), **pushed, **shares, **left_out, **not_held, **counted}
    return solution.but(status=status, stats=stats, events=events)


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
