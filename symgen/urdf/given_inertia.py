"""What a robot's bodies may be: none without inertia where M would be singular, none that no mass distribution has.

A link without mass is taken where M is regular: the cross of a gimbal has none, and what it carries has.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from symgen.schema.errors import SceneError
from symgen.urdf.robot import Assumed, Groups, Inertia, Robot
from symgen.urdf.tree_kinematics import RobotTree

MOMENT_ROUNDING = 1e-9  # of the largest moment: what rounding of a file may exceed the rule by
WITHOUT = (
    'give it an inertial, or fix its joint; default_inertia="meshes" takes it from its shapes, and kinematics=True '
    "reads positions alone"
)


def inertia_faults(
    robot: Robot, groups: Groups, inertias: Mapping[str, Inertia], free: bool, complete: bool, file: str
) -> list[SceneError]:
    """What keeps these bodies, by group, from being a mechanism.

    free: the root moves, too; complete: all bodies but the ground are among them, so that M is known.
    """
    beyond = _carried(groups, inertias)
    bare = [group for group in inertias if not beyond[group] and not robot_fault(robot, groups, group)]
    found = []
    for group in bare:
        members = groups.members[group]
        of_all = f" with {', '.join(members[1:4])} fixed to it" if len(members) > 1 else ""
        carries = " and carries none" if any(groups.seats[one.parent].group == group for one in groups.joints) else ""
        found.append(SceneError(f"{file}: link '{group}'", f"moves and has no mass{of_all}{carries}", WITHOUT))
    for group in inertias:
        if problem := impossible(inertias[group]):
            members = groups.members[group]
            of_all = f", with {', '.join(members[1:4])} fixed to it" if len(members) > 1 else ""
            remedy = 'mend its inertia, or take it by inertia="as_given"'
            found.append(SceneError(f"{file}: link '{group}'", f"{problem}{of_all}", remedy))
    if found or robot.faults or not complete or all(_regular(one) for one in inertias.values()):
        return found
    if loose := RobotTree(robot, groups, free).undetermined(inertias):
        whose = "its acceleration" if len(loose) == 1 else "their accelerations"
        remedy = 'give the links between them an inertial; inertia="as_given" takes them for loops to be closed'
        found.append(SceneError(f"{file}: {', '.join(loose[:6])}", f"no inertia determines {whose}", remedy))
    return found


def robot_fault(robot: Robot, groups: Groups, group: str) -> bool:
    """Has a link of the group an inertia that could not be read?"""
    return any(robot.links[link].inertia is None for link in groups.members[group])


def _carried(groups: Groups, inertias: Mapping[str, Inertia]) -> dict[str, bool]:
    """Has the group, or one that hangs on it, an inertia? One that is not in `inertias` has, as a flexible body."""
    found = {group: True for group in groups.members}
    found |= {group: bool(one.mass or one.tensor.any()) for group, one in inertias.items()}
    for joint in reversed(groups.joints):  # children first
        found[groups.seats[joint.parent].group] |= found[joint.child]
    return found


def _regular(inertia: Inertia) -> bool:
    return inertia.mass > 0 and float(np.linalg.eigvalsh(inertia.tensor)[0]) > 0


def impossible(inertia: Inertia) -> str:
    """Why no body has these moments, with the amount; "" where one can: none is negative or above the two others."""
    principal = np.linalg.eigvalsh(inertia.tensor)
    slack, shown = MOMENT_ROUNDING * abs(principal).max(), ", ".join(f"{value:.4g}" for value in principal)
    if principal[0] < -slack:
        return f"no body has its moments of inertia {shown}: {principal[0]:.4g} kg m^2 is negative"
    if (over := principal[2] - principal[0] - principal[1]) > slack:
        share = over / (principal[0] + principal[1]) if principal[0] + principal[1] > 0 else np.inf
        return (
            f"no body has its moments of inertia {shown}: the largest exceeds the sum of the others by {over:.4g} "
            f"kg m^2 ({100 * share:.3g} %)"
        )
    return ""


def taken_as_given(inertias: Mapping[str, Inertia], groups: Groups) -> list[Assumed]:
    """Bodies that no mass distribution has, with the amount."""
    return [
        Assumed(_links(groups.members[group]), f"{problem}; taken as given")
        for group, one in inertias.items()
        if (problem := impossible(one))
    ]


def _links(members: Sequence[str]) -> str:
    with_ = f" with {', '.join(members[1:4])} fixed to it" if len(members) > 1 else ""
    return f"link '{members[0]}'{with_}"
