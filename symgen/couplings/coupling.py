"""What a coupling type is: its fields in a scene, and the coordinates of joints in its row with their coefficients.

The row is x_1 + a_2 x_2 + ... = constant: C_q is constant, gamma is zero, and x_1 follows in closed form. Coordinates
of joints are relative to the body that carries the joint, so that carriers which turn need nothing more.
"""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal

from symgen.joints.backlash import Backlash
from symgen.joints.joint import Surroundings
from symgen.loads.effort import coordinate_faults
from symgen.schema.fields import Fault, Name, StrictModel, about

Read = Callable[[str], Any]  # SX of a quantity of the coupling by its field


class Coupling(StrictModel):
    """A coupling. Its file sets `type`, its own fields and what follows.

    backlash: with play the row is no constraint but where a force acts, of coordinate a's kind.
    coordinates: the fields that name coordinates, the one that follows first; `kinds` what each must be; not_zero: the
    fields that multiply. from_start: is the constant of the row that of the values given at the start?
    """

    name: Name
    backlash: Annotated[
        Backlash | None, about("play between the two sides: no force within the gap, a spring and damper beyond")
    ] = None
    if TYPE_CHECKING:
        type: Any  # of each file: its name in scenes

    coordinates: ClassVar[tuple[str, ...]] = ("coordinate_a", "coordinate_b")
    kinds: ClassVar[dict[str, Literal["angle", "position"]]] = {}
    not_zero: ClassVar[tuple[str, ...]] = ()
    from_start: ClassVar[bool] = True

    @abstractmethod
    def coefficients(self, of: Read) -> list[Any]:
        """Of the coordinates after the first, whose own is one."""

    def constant(self, of: Read) -> Any:
        """Of the row, where the start does not give it."""
        return 0

    @property
    def named(self) -> list[str]:
        """The coordinates, the one that follows first."""
        return [getattr(self, key) for key in self.coordinates]

    def faults(self, scene: Surroundings) -> Iterator[Fault]:
        """Names of no coordinate, of one twice, of one of the wrong kind, of an angle that is none; zeros."""
        if self.name in {joint.name for joint in scene.joints}:
            yield Fault("", "has the name of a joint", "rename one of them: forces are identified by these names")
        for key in self.not_zero:
            if getattr(self, key) == 0:
                yield Fault(key, "is zero, so that nothing would be coupled", "give a number that is not zero")
        for key in self.coordinates:
            name = getattr(self, key)
            found = list(coordinate_faults(key, name, scene))
            yield from found or self._kind(key, name, scene)
        if len(set(self.named)) < len(self.named):
            yield Fault("", "names the same coordinate twice", "name coordinates of different joints")

    def _kind(self, key: str, name: str, scene: Surroundings) -> Iterator[Fault]:
        joint, motion = scene.joint_of(name)
        wanted = self.kinds.get(key, motion.kind)
        if motion.kind != wanted:
            what = "an angle" if wanted == "angle" else "a travel"
            yield Fault(key, f"'{name}' is not {what}", f"name {what} of a joint")
        elif scene.space == "spatial" and motion.kind == "angle" and joint.name not in scene.placing():
            yield Fault(
                key, f"the joint '{joint.name}' closes a loop and has no angle of its own",
                "put the joint nearer to the ground, or another joint of the loop where this one is",
            )  # fmt: skip
