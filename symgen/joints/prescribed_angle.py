"""Prescribed angle (rheonomic): the angle between two markers follows f(t)."""

from functools import cache

from symgen.joints.planar_template import JointType, f, joint_type, phi_a, phi_b


@cache
def template() -> JointType:
    """phi_b - phi_a - f(t) = 0."""
    return joint_type([("angle", phi_b - phi_a - f)])
