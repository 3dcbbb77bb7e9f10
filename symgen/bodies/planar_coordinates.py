"""The coordinates of one planar body."""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca

from symgen.algebra.scalar import ZERO


@dataclass(frozen=True)
class BodyCoordinates:
    """A body's share of q and q_dot as SX scalars, and its columns in q. Ground has none."""

    columns: list[int]
    R_o: list[ca.SX]
    theta: ca.SX
    q_f: list[ca.SX]
    R_o_dot: list[ca.SX]
    theta_dot: ca.SX
    q_f_dot: list[ca.SX]

    @staticmethod
    def ground() -> BodyCoordinates:
        """Coordinates of the ground: constant zero, no columns."""
        return BodyCoordinates([], [ZERO, ZERO], ZERO, [], [ZERO, ZERO], ZERO, [])
