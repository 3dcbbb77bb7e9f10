"""Planar joint: b moves in the xy-plane of marker a and turns about its normal (space)."""

from __future__ import annotations

from typing import Literal

from symgen.joints.joint import PARALLEL, Joint, Slide, Turn, X, Y, Z


class PlanarJoint(Joint):
    """Moves in marker a's xy-plane and turns about its z-axis (spatial)."""

    type: Literal["planar"] = "planar"

    points = "in_plane"
    perpendicular = PARALLEL
    motions = (Slide(X, "x"), Slide(Y, "y"), Turn(Z, "angle"))
