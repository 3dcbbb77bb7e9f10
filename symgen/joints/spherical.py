"""Spherical joint: two points coincide (space)."""

from __future__ import annotations

from typing import Literal

from symgen.joints.joint import Joint


class SphericalJoint(Joint):
    """A ball joint, free to turn about all axes: rows r_b - r_a (spatial)."""

    type: Literal["spherical"] = "spherical"

    points = "together"
    at_a = at_b = "force"
