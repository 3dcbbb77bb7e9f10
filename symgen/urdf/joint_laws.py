"""What a file says of a joint, as the fields that a scene has for it: damping, friction, stops, the motor's limit."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from symgen.urdf.robot import TURNS_OR_SLIDES, Dropped, RobotJoint

PLASTIC = {"restitution": 0.0, "beyond": "moved"}  # rigid stops; a start beyond one begins at it


@dataclass(frozen=True)
class JointLaws:
    """What of a file acts in the scene; what does not is dropped by name. limits: False, or the law of the stops."""

    damping: bool = True
    friction: bool = True
    limits: bool | Mapping[str, Any] = True
    effort: bool = True

    def fields(self, joint: RobotJoint, dropped: list[Dropped]) -> dict[str, Any]:
        """Fields of the scene's joint."""
        found: dict[str, Any] = {}
        if joint.damping and self.damping:
            found["damping"] = joint.damping
        elif joint.damping:
            dropped.append(Dropped("damping", joint.name, f"{joint.damping:g}"))
        if joint.friction and self.friction:
            found["friction"] = {"coulomb": joint.friction}
        elif joint.friction:
            dropped.append(Dropped("friction", joint.name, f"{joint.friction:g}"))
        found |= self._stops(joint, dropped)
        if joint.mimic is not None and joint.limit.effort is not None:
            dropped.append(Dropped("effort limit", joint.name, f"{joint.limit.effort:g}, of a joint that mimics"))
        if joint.limit.velocity is not None:
            dropped.append(Dropped("velocity limit", joint.name, f"{joint.limit.velocity:g}"))
        return found

    def _stops(self, joint: RobotJoint, dropped: list[Dropped]) -> dict[str, Any]:
        ends = joint.limit.ends
        if not ends:
            return {}
        if self.limits is not False and joint.mimic is None:
            return {"limits": {**ends, **(PLASTIC if self.limits is True else self.limits)}}
        why = "" if self.limits is False else ", of a joint that mimics"
        shown = ", ".join(f"{key} {value:g}" for key, value in ends.items())
        dropped.append(Dropped("limit", joint.name, shown + why))
        return {}

    def effort_of(self, joint: RobotJoint, tau: str, dropped: list[Dropped]) -> str:
        """What a motor gives for its input."""
        most = joint.limit.effort
        if most is None or joint.type not in TURNS_OR_SLIDES:
            return tau
        if not self.effort:
            dropped.append(Dropped("effort limit", joint.name, f"{most:g}"))
            return tau
        return f"min(max({tau}, {-most!r}), {most!r})"
