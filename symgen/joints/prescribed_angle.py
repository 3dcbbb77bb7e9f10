"""Prescribed angle (rheonomic): the angle between two markers follows f(t)."""

from functools import cache

import sympy as sp

from symgen.joints.joint_type import JointType, f
from symgen.joints.planar_template import joint_type, phi_a, phi_b
from symgen.joints.spatial_template import dot, spatial_joint_type, x_a, x_b, y_a


@cache
def planar() -> JointType:
    """phi_b - phi_a - f(t) = 0."""
    return joint_type([("angle", phi_b - phi_a - f)])


@cache
def spatial() -> JointType:
    """sin(angle - f) = 0 for the angle of x_b in the xy-plane of marker a."""
    return spatial_joint_type([("angle", dot(x_b, y_a) * sp.cos(f) - dot(x_b, x_a) * sp.sin(f))])
