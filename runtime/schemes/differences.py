"""The central differences (40)-(43), on increments.

With d = q(t) - q(t - h) and d_next = q(t + h) - q(t) they read

    q_ddot(t) = (d_next - d) / h^2                                  (40), (42)
    q_dot(t) = (d_next + d) / (2 h) = d / h + h q_ddot(t) / 2        (41), (43)

Keeping d instead of q(t - h) is the same algorithm with less rounding. Every argument is a vector of coordinates
[m or rad] or their rates; h [s] is a vector too, the step of each coordinate, or one step for all.
"""

from __future__ import annotations

import casadi as ca


def velocity(half: ca.SX, q_ddot: ca.SX, h: ca.SX) -> ca.SX:
    """q_dot(t) of (41), (43), and of (5), (7), from `half` = d / h, the velocity at t - h / 2."""
    return half + h / 2 * q_ddot


def next_increment(d: ca.SX, q_ddot: ca.SX, h: ca.SX) -> ca.SX:
    """d_next = d + h^2 q_ddot(t): (40) and (42), as (4) and (6), solved for q(t + h)."""
    return d + h**2 * q_ddot


def replaced(vector: ca.SX, positions: list[int], values: ca.SX) -> ca.SX:
    """The vector with other values at some positions."""
    changed = ca.SX(vector)
    for position, k in enumerate(positions):
        changed[k] = values[position]
    return changed
