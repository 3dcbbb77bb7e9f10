"""Friction of a joint's one free direction: the law while it slides, and the bound while it sticks."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, Any

from symgen.schema.fields import Bound, Fault, Meaning, Quantity, StrictModel

FORCE = "N or N m"


class Friction(StrictModel):
    """F(v) = coulomb + stribeck exp(-v / stribeck_velocity) + viscous v against a sliding at v [m/s or rad/s].

    At rest the joint holds up to `breakaway`, coulomb unless given. stribeck: breakaway - coulomb unless given.
    """

    coulomb: Annotated[Quantity, Meaning("friction of fast sliding", FORCE, Bound.NON_NEGATIVE)]
    breakaway: Annotated[Quantity | None, Meaning("friction that holds at most", FORCE, Bound.POSITIVE)] = None
    stribeck_velocity: Annotated[
        Quantity | None, Meaning("velocity over which friction falls", "m/s or rad/s", Bound.POSITIVE)
    ] = None
    stribeck: Annotated[
        Quantity | None, Meaning("friction of slow sliding beyond coulomb", FORCE, Bound.NON_NEGATIVE)
    ] = None
    viscous: Annotated[Quantity, Meaning("friction per velocity", "N s/m or N m s/rad", Bound.NON_NEGATIVE)] = 0.0

    def faults(self, scene: Any) -> Iterator[Fault]:
        """What holds less than what slides, and what falls over no velocity. Of numbers; the rest is bounded."""
        falls = self.stribeck is not None or (self.breakaway is not None and self.breakaway != self.coulomb)
        if falls and self.stribeck_velocity is None:
            yield Fault("friction", "falls from breakaway to coulomb over no velocity", "give a stribeck_velocity")
        if not falls and self.stribeck_velocity is not None:
            yield Fault("friction.stribeck_velocity", "has nothing to act on", "give a breakaway above coulomb")
        if not falls and self.coulomb == 0:
            yield Fault("friction", "holds nothing", "give a coulomb above zero, or damping where it is only viscous")
        numbers = [one for one in (self.breakaway, self.coulomb, self.stribeck or 0.0) if isinstance(one, float | int)]
        if len(numbers) == 3 and numbers[0] < numbers[1] + numbers[2]:
            slides = "coulomb" if self.stribeck is None else "coulomb and stribeck together"
            yield Fault(
                "friction.breakaway", f"{numbers[0]:g} is below {slides}: what holds would slide at once",
                "give a breakaway at least as large",
            )  # fmt: skip
