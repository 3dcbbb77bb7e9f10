"""Prismatic (translational) joint: b slides on the line of marker a without turning."""

from functools import cache

from symgen.joints.planar_template import JointType, cross_slide, joint_type, phi_a, phi_b


@cache
def template() -> JointType:
    """n_a . (r_b - r_a) = 0 and phi_b - phi_a = 0."""
    return joint_type([("normal", cross_slide()), ("angle", phi_b - phi_a)])
