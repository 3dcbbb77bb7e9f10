"""Point on line: b stays on the line of marker a and may turn."""

from functools import cache

from symgen.joints.joint_type import JointType
from symgen.joints.planar_template import cross_slide, joint_type
from symgen.joints.spatial_template import on_axis, spatial_joint_type


@cache
def planar() -> JointType:
    """n_a . (r_b - r_a) = 0."""
    return joint_type([("normal", cross_slide())])


@cache
def spatial() -> JointType:
    """Point b on the z-axis of marker a."""
    return spatial_joint_type(on_axis())
