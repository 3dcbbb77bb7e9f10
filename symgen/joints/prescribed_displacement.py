"""Prescribed displacement (rheonomic): the travel of b along the line of marker a follows f(t)."""

from functools import cache

from symgen.joints.planar_template import JointType, along_slide, f, joint_type


@cache
def template() -> JointType:
    """t_a . (r_b - r_a) - f(t) = 0."""
    return joint_type([("travel", along_slide() - f)])
