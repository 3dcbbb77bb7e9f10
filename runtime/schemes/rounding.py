"""What an iteration can reach in double precision."""

from __future__ import annotations

import casadi as ca

ROUNDING = 4e-16  # relative, of the sums of a step


def unseen_acceleration(position: ca.SX, velocity: ca.SX, h: ca.SX) -> ca.SX:
    """The acceleration [m/s^2 or rad/s^2] that rounding of positions and velocities (vectors) hides in a step h [s]."""
    return ROUNDING * (ca.norm_inf(position) / h + ca.norm_inf(velocity)) / h
