"""Universal joint: two points coincide, x_b stays perpendicular to z_a (space)."""

from functools import cache

from symgen.joints.joint_type import JointType
from symgen.joints.spatial_template import dot, placed, spatial_joint_type, x_b, z_a


@cache
def spatial() -> JointType:
    """r_b - r_a = 0 and x_b . z_a = 0."""
    return spatial_joint_type([*placed(), ("cross", dot(x_b, z_a))])
