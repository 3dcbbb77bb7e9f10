"""Revolute joint: two points coincide; in space the z-axes too, a hinge."""

from functools import cache

from symgen.joints.joint_type import JointType
from symgen.joints.planar_template import d, joint_type
from symgen.joints.spatial_template import parallel, placed, spatial_joint_type


@cache
def planar() -> JointType:
    """r_b - r_a = 0."""
    return joint_type([("x", d[0]), ("y", d[1])])


@cache
def spatial() -> JointType:
    """r_b - r_a = 0 and z_b along z_a."""
    return spatial_joint_type([*placed(), *parallel()])
