"""Forces that push and never pull: of a depth d, zero where nothing is pressed, with what the force kinks at.

Penalty forces of contacts and elastic stops, of the penetration depth d:

Hunt and Crossley    k d^n max(0, 1 + D d')
play                 k d + c d', no less than 0 and no more than 2 k d
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import casadi as ca

from symgen.algebra.rows import Row
from symgen.loads.load import LoadEffect


@dataclass(frozen=True)
class Push:
    """force [N or N m] against the depth whose rate is `rate`; stored [J]; lost [W]; kinks: where it has them."""

    force: ca.SX
    rate: ca.SX
    stored: ca.SX
    lost: ca.SX
    kinks: Sequence[ca.SX]


def hunt_crossley(depth: ca.SX, rate: ca.SX, stiffness: ca.SX, damping: ca.SX, exponent: float) -> Push:
    """Of d and d'."""
    pressed = ca.fmax(depth, 0)
    spring = stiffness * (pressed if exponent == 1 else pressed**exponent)
    stored = stiffness * pressed ** (exponent + 1) / (exponent + 1)
    if damping.is_zero():
        return Push(spring, rate, stored, ca.SX(0), [depth])
    left = 1 + damping * rate
    force = spring * ca.fmax(left, 0)
    return Push(force, rate, stored, (force - spring) * rate, [depth, ca.if_else(depth > 0, left, 1)])


def beyond_play(depth: ca.SX, rate: ca.SX, stiffness: ca.SX, damping: ca.SX) -> Push:
    """Of d and d'."""
    pressed = ca.fmax(depth, 0)
    spring, damper = stiffness * pressed, damping * rate
    force = ca.if_else(depth > 0, ca.fmin(ca.fmax(spring + damper, 0), 2 * spring), 0)
    kinks = [depth, *(ca.if_else(depth > 0, spring + side * damper, 1) for side in (1, -1) if not damping.is_zero())]
    return Push(force, rate, stiffness * pressed**2 / 2, (force - spring) * rate, kinks)


def against(row: Row, sides: Sequence[tuple[int, Push]]) -> LoadEffect:
    """What pushes do on a direction u with u' = row . q': each against a depth that grows with u (1) or against it."""
    force = -sum((side * push.force for side, push in sides), ca.SX(0))
    return LoadEffect(
        {column: force * value for column, value in row.items()},
        potential=sum((push.stored for _, push in sides), ca.SX(0)),
        dissipated=sum((push.lost for _, push in sides), ca.SX(0)),
    )
