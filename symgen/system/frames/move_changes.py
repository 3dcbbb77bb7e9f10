"""How the motion of a frame, and the powers of a wrench on the move that leads there, change by the move's coordinates.

A coordinate displaces the frame after its move by a twist, tau and v in the axes of that frame. With D the rate as seen
from the ground, D x = x' + omega x x, D^2 x = x'' + 2 omega x x' + G x, the changes (u, beta, d) of that frame are

    by position    u = D tau,   beta = D^2 tau,    d = D^2 v - tau x a
    by rate        u = tau,     beta = 2 D tau,    d = 2 D v.
"""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca

from symgen.algebra.rows import Row
from symgen.algebra.scalar import ONE
from symgen.algebra.vectors import cross, scaled, times, zeros
from symgen.system.frames.motion import Motion, Twist
from symgen.system.frames.moves import Slide, Turn, unit
from symgen.system.frames.tangents import Change

TWO = ca.SX(2)


@dataclass(frozen=True)
class Spot:
    """A move with the motion before and after it, and the rates and accelerations of the coordinates by column."""

    before: Motion
    after: Motion
    rates: Row
    accelerations: Row


@dataclass(frozen=True)
class Part:
    """What the coordinates of some columns do, each its share: a twist of the frame after the move, and the changes."""

    shares: Row
    twist: Twist
    by_position: Change
    by_rate: Change


def turn_part(move: Turn, spot: Spot) -> list[Part]:
    """Of the angle, if there is one."""
    if move.column is None:
        return []
    z, omega = unit(move.axis, move.sign), spot.after.omega
    by_position = Change(cross(omega, z), times(spot.after.G, z), cross(spot.after.a, z))
    by_rate = Change(z, cross(scaled(TWO, omega), z), zeros())
    return [Part({move.column: ONE}, move.twists[move.column], by_position, by_rate)]


def slide_part(move: Slide, spot: Spot) -> list[Part]:
    """Of the travel, if there is one."""
    if move.column is None:
        return []
    e, none = unit(move.axis, move.factor), zeros()
    by_rate = Change(none, none, cross(scaled(TWO, spot.after.omega), e))
    by_position = Change(none, none, times(spot.after.G, e))
    return [Part({move.column: ONE}, move.twists[move.column], by_position, by_rate)]
