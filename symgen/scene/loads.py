"""Loads: forces, torques and spring-dampers at markers."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from symgen.schema.fields import Bound, Coordinate, MarkerRef, Meaning, Name, Quantity, Scope, StrictModel

Stiffness = Annotated[Quantity, Meaning("stiffness", "N/m", Bound.NON_NEGATIVE)]
Damping = Annotated[Quantity, Meaning("damping", "N s/m", Bound.NON_NEGATIVE)]
RotationalStiffness = Annotated[Quantity, Meaning("stiffness", "N m/rad", Bound.NON_NEGATIVE)]
RotationalDamping = Annotated[Quantity, Meaning("damping", "N m s/rad", Bound.NON_NEGATIVE)]
FreeLength = Annotated[Quantity, Meaning("length without force", "m", Bound.NON_NEGATIVE)]
ForceComponents = Annotated[tuple[Quantity, ...], Meaning("force, (x, y) or (x, y, z)", "N", scope=Scope.MEASURES)]
Stiffnesses = Annotated[tuple[Quantity, ...], Meaning("stiffness along x, y, z", "N/m", Bound.NON_NEGATIVE)]
Dampings = Annotated[tuple[Quantity, ...], Meaning("damping along x, y, z", "N s/m", Bound.NON_NEGATIVE)]
TurningStiffnesses = Annotated[tuple[Quantity, ...], Meaning("stiffness about x, y, z", "N m/rad", Bound.NON_NEGATIVE)]
TurningDampings = Annotated[tuple[Quantity, ...], Meaning("damping about x, y, z", "N m s/rad", Bound.NON_NEGATIVE)]


class Force(StrictModel):
    """A force at a marker; components [N] along the world's axes or the body's."""

    type: Literal["force"] = "force"
    name: Name
    marker: MarkerRef
    components: ForceComponents
    frame: Literal["world", "body"] = "world"


class Torque(StrictModel):
    """A torque [N m] about a marker's z-axis, counter-clockwise; its opposite acts at ``reaction`` if given."""

    type: Literal["torque"] = "torque"
    name: Name
    marker: MarkerRef
    value: Annotated[Quantity, Meaning("torque", "N m", scope=Scope.MEASURES)]
    reaction: MarkerRef | None = None


class Effort(StrictModel):
    """What a motor puts on a joint's own coordinate: a torque [N m] on an angle, a force [N] on a travel.

    coordinate: "joint.angle" or "joint.travel", and in space "joint.angle1", "joint.angle2", "joint.x", "joint.y" where
    the joint has these. It acts on marker b along the coordinate, and its opposite on marker a.
    """

    type: Literal["effort"] = "effort"
    name: Name
    coordinate: Coordinate
    value: Annotated[Quantity, Meaning("torque or force", "N m or N", scope=Scope.MEASURES)]


class SpringDamper(StrictModel):
    """A spring and damper along the line between two markers."""

    type: Literal["spring_damper"] = "spring_damper"
    name: Name
    marker_a: MarkerRef
    marker_b: MarkerRef
    stiffness: Stiffness
    damping: Damping = 0.0
    free_length: FreeLength = 0.0


class RotationalSpringDamper(StrictModel):
    """A spring and damper on the angle phi_b - phi_a; in space on the angle about marker a's z-axis.

    In space the angle is that of the joint between the two markers, or else one between -pi and pi.
    """

    type: Literal["rotational_spring_damper"] = "rotational_spring_damper"
    name: Name
    marker_a: MarkerRef
    marker_b: MarkerRef
    stiffness: RotationalStiffness
    damping: RotationalDamping = 0.0
    free_angle: Annotated[Quantity, Meaning("angle without torque", "rad")] = 0.0


class Bushing(StrictModel):
    """Springs and dampers along and about marker a's axes on the displacement and small rotation of b (spatial).

    stiffness [N/m], damping [N s/m], rotational_stiffness [N m/rad], rotational_damping [N m s/rad]: three each.
    """

    type: Literal["bushing"] = "bushing"
    name: Name
    marker_a: MarkerRef
    marker_b: MarkerRef
    stiffness: Stiffnesses = (0.0, 0.0, 0.0)
    damping: Dampings = (0.0, 0.0, 0.0)
    rotational_stiffness: TurningStiffnesses = (0.0, 0.0, 0.0)
    rotational_damping: TurningDampings = (0.0, 0.0, 0.0)


Load = Annotated[Force | Torque | Effort | SpringDamper | RotationalSpringDamper | Bushing, Field(discriminator="type")]
