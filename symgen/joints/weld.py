"""Weld: two markers coincide in position and angle."""

from functools import cache

from symgen.joints.joint_type import JointType
from symgen.joints.planar_template import d, joint_type, phi_a, phi_b
from symgen.joints.spatial_template import aligned, placed, spatial_joint_type


@cache
def planar() -> JointType:
    """r_b - r_a = 0 and phi_b - phi_a = 0."""
    return joint_type([("x", d[0]), ("y", d[1]), ("angle", phi_b - phi_a)])


@cache
def spatial() -> JointType:
    """r_b - r_a = 0, axes along axes."""
    return spatial_joint_type([*placed(), *aligned()])
