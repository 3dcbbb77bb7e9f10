"""Prismatic (translational) joint: b slides on the line of marker a without turning."""

from functools import cache

from symgen.joints.joint_type import JointType
from symgen.joints.planar_template import cross_slide, joint_type, phi_a, phi_b
from symgen.joints.spatial_template import aligned, on_axis, spatial_joint_type


@cache
def planar() -> JointType:
    """n_a . (r_b - r_a) = 0 and phi_b - phi_a = 0."""
    return joint_type([("normal", cross_slide()), ("angle", phi_b - phi_a)])


@cache
def spatial() -> JointType:
    """b slides on the z-axis of marker a, axes along axes."""
    return spatial_joint_type([*on_axis(), *aligned()])
