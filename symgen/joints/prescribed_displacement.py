"""Prescribed displacement (rheonomic): the travel of b along the line of marker a follows f(t)."""

from functools import cache

from symgen.joints.joint_type import JointType, f
from symgen.joints.planar_template import along_slide, joint_type
from symgen.joints.spatial_template import d, dot, spatial_joint_type, z_a


@cache
def planar() -> JointType:
    """t_a . (r_b - r_a) - f(t) = 0."""
    return joint_type([("travel", along_slide() - f)])


@cache
def spatial() -> JointType:
    """z_a . (r_b - r_a) - f(t) = 0."""
    return spatial_joint_type([("travel", dot(z_a, d) - f)])
