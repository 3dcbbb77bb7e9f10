"""Links that fixed joints hold together are one rigid body, in the frame of the link that comes first."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass

import numpy as np

from symgen.urdf.robot import Inertia, Pose, Robot, RobotJoint


@dataclass(frozen=True)
class Seat:
    """Where a link is: in the group of which link, and at which pose in its frame."""

    group: str
    pose: Pose


@dataclass(frozen=True)
class Groups:
    """members: links of each group, its first link first; seats of all links; joints between groups, parents first."""

    members: Mapping[str, list[str]]
    seats: Mapping[str, Seat]
    joints: list[RobotJoint]


def groups_of(robot: Robot, alone: Collection[str]) -> Groups:
    """The groups of a robot; links in `alone` are groups of their own."""
    children: dict[str, list[RobotJoint]] = {}
    for joint in robot.joints:
        children.setdefault(joint.parent, []).append(joint)
    seats, members = {robot.root: Seat(robot.root, Pose())}, {robot.root: [robot.root]}
    between, waiting = [], [robot.root]
    for link in waiting:  # it grows
        for joint in children.get(link, []):
            waiting.append(joint.child)
            if joint.type == "fixed" and not {joint.parent, joint.child} & set(alone):
                seat = seats[link]
                seats[joint.child] = Seat(seat.group, seat.pose.then(joint.pose))
                members[seat.group].append(joint.child)
            else:
                between.append(joint)
                seats[joint.child], members[joint.child] = Seat(joint.child, Pose()), [joint.child]
    return Groups(members, seats, between)


def inertia_of(robot: Robot, groups: Groups, group: str) -> Inertia:
    """Of all links of a group together, by Steiner's theorem."""
    parts = [robot.links[link].inertia.seen(groups.seats[link].pose) for link in groups.members[group]]
    if len(parts) == 1:
        return parts[0]
    mass = sum(part.mass for part in parts)
    center = sum((part.mass * part.center for part in parts), np.zeros(3)) / (mass or 1.0)
    tensor = np.zeros((3, 3))
    for part in parts:
        d = part.center - center
        tensor += part.tensor + part.mass * (d @ d * np.eye(3) - np.outer(d, d))
    return Inertia(mass, center, tensor)
