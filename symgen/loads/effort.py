"""Effort: what a motor puts on a joint's own coordinate."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, Literal

from symgen.joints.joint import Reaction, Surroundings, Turn
from symgen.loads.load import Acting, Load, LoadEffect, on
from symgen.schema.errors import did_you_mean
from symgen.schema.fields import Coordinate, Fault, Meaning, Quantity, Scope, about


class Effort(Load):
    """A motor on a joint's own coordinate: a torque [N m] on an angle, a force [N] on a travel.

    coordinate: "joint.angle" or "joint.travel", and in space "joint.angle1", "joint.angle2", "joint.x", "joint.y" where
    the joint has these. It acts on marker b along the coordinate, and its opposite on marker a.
    """

    type: Literal["effort"] = "effort"
    coordinate: Annotated[
        Coordinate, about('coordinate of a joint that it drives, `"joint.angle"` or `"joint.travel"`')
    ]
    value: Annotated[Quantity, Meaning("torque or force", "N m or N", scope=Scope.MEASURES)]

    directed = "acts on marker b along the coordinate"

    def effect(self, m: Acting) -> LoadEffect:
        """Q = value on the coordinate, power value times its rate."""
        scalar, value = m.coordinate(self.coordinate), m.value("value")
        return on(scalar, m, value, applied=value * scalar.rate)

    @property
    def acts_at(self) -> list[str]:
        """The coordinate."""
        return [self.coordinate]

    def record(self, scene: Surroundings) -> tuple[str, dict[str, str]]:
        """The torque or the force that it is, on marker b of its joint."""
        joint, motion = scene.joint_of(self.coordinate)
        ends = {"marker": joint.marker_b, "reaction": joint.marker_a}
        return "torque" if isinstance(motion, Turn) else "force", ends

    def reaction_kind(self, scene: Surroundings) -> Reaction:
        """A moment on an angle, a force on a travel."""
        return "moment" if isinstance(scene.joint_of(self.coordinate)[1], Turn) else "force"

    def faults(self, scene: Surroundings) -> Iterator[Fault]:
        """A coordinate that no joint has."""
        yield from coordinate_faults("coordinate", self.coordinate, scene)

    def drives(self, coordinate: str) -> bool:
        """The one that it names."""
        return coordinate == self.coordinate


def coordinate_faults(key: str, coordinate: str, scene: Surroundings) -> Iterator[Fault]:
    """Of a name of a joint's coordinate."""
    joints = {joint.name: joint for joint in scene.joints}
    name, _, part = coordinate.partition(".")
    joint = joints.get(name)
    if joint is None:
        yield Fault(key, f"there is no joint '{name}'", did_you_mean(name, joints))
        return
    placed = name in scene.placing()
    known = [motion.name for motion in joint.motions or () if placed or joint.relative()]
    if part not in known:
        has = did_you_mean(part, known) if known else "put a force or a torque on a marker instead"
        yield Fault(key, f"the {joint.type} joint '{name}' has no coordinate '{part}' here", has)
