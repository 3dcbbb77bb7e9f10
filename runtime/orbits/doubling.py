"""Where a multiplier passes -1, a motion of twice the period branches off: its start and its direction.

With the monodromy's eigenvector M v = -v, a disturbance v comes back as -v after a period T and as v after 2 T. So the
motion of the period T, taken twice, is a point of the branch of motions of 2 T, and (v, -v) is a direction along which
the branch leaves it; the parameter moves with the square of the distance.
Source: Seydel, Practical Bifurcation and Stability Analysis, ch. 7.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from runtime.orbits.branch import Point
from runtime.orbits.motion import PeriodicMotion


def doubled(first: PeriodicMotion, over: str, at: Point) -> tuple[PeriodicMotion, Point]:
    """(the motion at a flip, taken twice; the point that its branch begins with).

    first: of the branch that has the flip. The point's tangent holds (v, -v) of the parts (2 K n,), not yet scaled.
    """
    turn, period = at.conditions.turn, 2 * at.period
    x = np.concatenate([at.x, at.x + turn])
    v = _disturbance(at)
    conditions = replace(at.conditions, turn=2 * turn)
    point = replace(at, period=period, x=x, conditions=conditions, tangent=np.concatenate([v, -v]).ravel(), begins=True)
    motion = replace(
        first,
        period=period,
        x=x[0],
        turns={name: 2 * k for name, k in first.turns.items()},
        steps=2 * first.steps,
        parts=2 * first.parts,
        parameters={**first.parameters, over: at.value},
        speed=None if first.speed is None else (first.speed[0], 2 * first.speed[1]),
        doublings=first.doublings + 1,
    )
    return motion, point


def half_apart(point: Point) -> np.ndarray:
    """(n,) how far a motion of twice a period is from having that period: between its halves, in parts of sizes."""
    half = len(point.x) // 2
    return np.asarray((point.x[half] - point.x[0] - point.conditions.turn / 2) / point.conditions.scale)


def _disturbance(at: Point) -> np.ndarray:
    """(K, n) of the parts, along the multiplier nearest to -1."""
    multipliers, vectors = np.linalg.eig(at.shot.monodromy)
    found = [vectors[:, int(np.abs(multipliers + 1.0).argmin())].real]
    for slope in at.shot.slopes[:-1]:
        found.append(slope @ found[-1])
    return np.array(found)
