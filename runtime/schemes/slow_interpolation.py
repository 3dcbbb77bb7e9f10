"""Readings of how slow variables move inside their step (Eqs. 13, 59-63). Each is one named function.

Arguments: the slow variable's q, q_dot, q_ddot at the start of its step, the time s since then, the sub-step h, its
own step H and its value at the end of its step. Result: (q, q_dot) at s.
"""

from __future__ import annotations

from collections.abc import Callable

import casadi as ca

Interpolation = Callable[..., tuple[ca.SX, ca.SX]]


def end_point_sum(q: ca.SX, v: ca.SX, a: ca.SX, s: ca.SX, h: ca.SX, H: ca.SX, q_next: ca.SX) -> tuple[ca.SX, ca.SX]:
    """(60)-(61), (63) as printed: the velocity is summed at the end of each sub-step.

    At sub-step k this overshoots constant acceleration by k h^2 a / 2. q_L_dot(t + dt_L) is q_L_dot + dt_L q_L_ddot.
    """
    return q + s * v + (s * s + s * h) / 2 * a, v + s * a


def constant_acceleration(
    q: ca.SX, v: ca.SX, a: ca.SX, s: ca.SX, h: ca.SX, H: ca.SX, q_next: ca.SX
) -> tuple[ca.SX, ca.SX]:
    """Exact polynomial of (59): q + s v + s^2 a / 2."""
    return q + s * v + s * s / 2 * a, v + s * a


def chord_ahead(q: ca.SX, v: ca.SX, a: ca.SX, s: ca.SX, h: ca.SX, H: ca.SX, q_next: ca.SX) -> tuple[ca.SX, ca.SX]:
    """(13) as printed: linear in time, weighted j/m at time (j - 1) h, so one sub-step ahead."""
    weight = (s + h) / H
    return (1 - weight) * q + weight * q_next, (q_next - q) / H


def chord(q: ca.SX, v: ca.SX, a: ca.SX, s: ca.SX, h: ca.SX, H: ca.SX, q_next: ca.SX) -> tuple[ca.SX, ca.SX]:
    """(13) at the right time: linear between the two known values."""
    weight = s / H
    return (1 - weight) * q + weight * q_next, (q_next - q) / H


def held_at_the_middle(
    q: ca.SX, v: ca.SX, a: ca.SX, s: ca.SX, h: ca.SX, H: ca.SX, q_next: ca.SX
) -> tuple[ca.SX, ca.SX]:
    """At the middle of the slow step: what depends on slow variables only is then the same in all sub-steps."""
    return q + H / 2 * v + H * H / 8 * a, v + H / 2 * a


INTERPOLATIONS: dict[str, Interpolation] = {
    "end_point_sum": end_point_sum,
    "constant_acceleration": constant_acceleration,
    "chord_ahead": chord_ahead,
    "chord": chord,
    "held_at_the_middle": held_at_the_middle,
}
