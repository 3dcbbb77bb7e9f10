"""Spherical joint: two points coincide (space)."""

from functools import cache

from symgen.joints.joint_type import JointType
from symgen.joints.spatial_template import placed, spatial_joint_type


@cache
def spatial() -> JointType:
    """r_b - r_a = 0."""
    return spatial_joint_type(placed())
