"""Revolute joint: two points coincide."""

from functools import cache

from symgen.joints.planar_template import JointType, d, joint_type


@cache
def template() -> JointType:
    """r_b - r_a = 0."""
    return joint_type([("x", d[0]), ("y", d[1])])
