"""Cylindrical joint: b turns about and slides along the z-axis of marker a (space)."""

from functools import cache

from symgen.joints.joint_type import JointType
from symgen.joints.spatial_template import on_axis, parallel, spatial_joint_type


@cache
def spatial() -> JointType:
    """Point b on the z-axis of marker a, z_b along z_a."""
    return spatial_joint_type([*on_axis(), *parallel()])
