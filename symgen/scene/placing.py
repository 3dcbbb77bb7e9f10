"""Which joints of a spatial scene place a body by coordinates of their own.

Along a spanning tree from the ground, a joint that fixes an orientation up to its own angles gives them as coordinates:
body b then follows in closed form from body a and the joint, over any number of turns and without a singular angle.
Joints that close loops stay equations between the bodies; a joint that is none without its coordinates, a screw, comes
before those that could.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass
from typing import Protocol

from runtime.contract.records import UNITS, Coordinate
from symgen.joints import Joint


class Named(Protocol):
    """A body, as far as placing is concerned."""

    @property
    def name(self) -> str:
        """Of the body."""


@dataclass(frozen=True)
class Placement:
    """Joint `joint` places body `child` relative to body `parent` by coordinates of its own, `records`.

    forward: the child is the body of marker b.
    """

    joint: str
    parent: str
    child: str
    forward: bool
    records: tuple[Coordinate, ...]

    @property
    def coordinates(self) -> list[str]:
        """Names of the joint's coordinates."""
        return [entry.name for entry in self.records]


def placements_of(bodies: Sequence[Named], joints: Sequence[Joint], coupled: Collection[str] = ()) -> list[Placement]:
    """The placing joints, in scene order; those coupled by their coordinates are taken first.

    What placing joints do not reach from the ground is oriented by itself.
    """
    found: dict[str, Placement] = {}
    reached, queue = {"ground"}, ["ground"]
    roots = [body.name for body in bodies]

    def place(parent: str, needed: bool) -> None:
        """Reach the bodies on the joints of one, at once those beyond joints that must place a body."""
        for joint, child, forward in _placing_from(joints, parent):
            if child not in reached and (not needed or not joint.closes_loops() or joint.name in coupled):
                reached.add(child)
                queue.append(child)
                found[joint.name] = Placement(joint.name, parent, child, forward, _coordinates(joint))
                place(child, needed=True)

    place("ground", needed=True)
    while queue or roots:
        if not queue:
            root = _next_root(joints, roots, reached)
            roots.remove(root)
            if root not in reached:
                reached.add(root)
                queue.append(root)
                place(root, needed=True)
            continue
        place(queue.pop(0), needed=False)
    return [found[joint.name] for joint in joints if joint.name in found]


def _coordinates(joint: Joint) -> tuple[Coordinate, ...]:
    return tuple(
        Coordinate(f"{joint.name}.{motion.name}", joint.name, motion.kind, UNITS[motion.kind])
        for motion in joint.motions or ()
    )


def _next_root(joints: Sequence[Joint], roots: list[str], reached: set[str]) -> str:
    """A body joined to what has been reached, if there is one."""
    for joint in joints:
        ends = (joint.marker_a.partition(".")[0], joint.marker_b.partition(".")[0])
        for near, far in (ends, ends[::-1]):
            if near in reached and far in roots and far not in reached:
                return far
    return roots[0]


def _placing_from(joints: Sequence[Joint], body: str) -> Iterator[tuple[Joint, str, bool]]:
    """Placing joints of a body with the body at their other end."""
    for joint in joints:
        ends = (joint.marker_a.partition(".")[0], joint.marker_b.partition(".")[0])
        if joint.motions is not None and body in ends:
            yield joint, ends[1] if ends[0] == body else ends[0], ends[0] == body
