"""Distance: a massless rod of fixed length between two points."""

from functools import cache

from symgen.joints.joint_type import JointType, f
from symgen.joints.planar_template import d, joint_type
from symgen.joints.spatial_template import d as spatial_d
from symgen.joints.spatial_template import dot, spatial_joint_type


@cache
def planar() -> JointType:
    """(d.d - f^2) / 2f = 0 with the length f, in metres."""
    return joint_type([("length", (d[0] ** 2 + d[1] ** 2 - f**2) / (2 * f))])


@cache
def spatial() -> JointType:
    """The same in space."""
    return spatial_joint_type([("length", (dot(spatial_d, spatial_d) - f**2) / (2 * f))])
