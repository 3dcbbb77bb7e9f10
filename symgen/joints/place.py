"""The position of a body that a joint places: r_b - r_a is the joint's travel along the axes of marker a."""

from functools import cache

from symgen.joints.joint_type import JointType
from symgen.joints.spatial_template import placed, spatial_joint_type


@cache
def spatial() -> JointType:
    """r_b - r_a - travel = 0, linear in R_o of both bodies."""
    return spatial_joint_type(placed())
