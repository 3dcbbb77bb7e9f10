"""Planar joint: b moves in the xy-plane of marker a and turns about its normal (space)."""

from functools import cache

from symgen.joints.joint_type import JointType
from symgen.joints.spatial_template import d, dot, parallel, spatial_joint_type, z_a


@cache
def spatial() -> JointType:
    """z_a . (r_b - r_a) = 0 and z_b along z_a."""
    return spatial_joint_type([("normal", dot(z_a, d)), *parallel()])
