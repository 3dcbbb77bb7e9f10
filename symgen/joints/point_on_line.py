"""Point on line: b stays on the line of marker a and may turn."""

from functools import cache

from symgen.joints.planar_template import JointType, cross_slide, joint_type


@cache
def template() -> JointType:
    """n_a . (r_b - r_a) = 0."""
    return joint_type([("normal", cross_slide())])
