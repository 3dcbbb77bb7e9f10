"""Friction of a joint's one free direction: the law while it slides, and the bound while it sticks (stiction)."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, Any, ClassVar

from symgen.schema.fields import Bound, Fault, Meaning, Quantity, Scope, StrictModel

FORCE = "N or N m"


class Friction(StrictModel):
    """F(v) = coulomb + stribeck exp(-v / stribeck_velocity) + viscous v against a sliding at v [m/s or rad/s].

    At rest the joint holds up to `breakaway`, coulomb unless given. stribeck: breakaway - coulomb unless given.
    By the joint's own force R [N] instead: mu R of a slide, mu R radius of a hinge, and at rest `mu_static`, mu unless
    given, in place of mu; what falls is the coefficient.
    Limits and coefficients may change with time, inputs, states, measures and what events set, as those of clutches and
    brakes do; one that becomes negative, or holds less than what slides, ends a run (`no_mode`).
    """

    references = (
        "B. Armstrong-Helouvry, P. Dupont, C. Canudas de Wit, A survey of models, analysis tools and compensation "
        "methods for the control of machines with friction, Automatica 30 (1994) 1083-1138.",
    )
    example: ClassVar[str] = "friction = {coulomb = 40}"

    coulomb: Annotated[
        Quantity | None, Meaning("friction of fast sliding", FORCE, Bound.NON_NEGATIVE, Scope.MEASURES)
    ] = None
    breakaway: Annotated[
        Quantity | None, Meaning("friction that holds at most", FORCE, Bound.NON_NEGATIVE, Scope.MEASURES)
    ] = None
    stribeck_velocity: Annotated[
        Quantity | None, Meaning("velocity over which friction falls", "m/s or rad/s", Bound.POSITIVE)
    ] = None
    stribeck: Annotated[
        Quantity | None, Meaning("friction of slow sliding beyond coulomb", FORCE, Bound.NON_NEGATIVE, Scope.MEASURES)
    ] = None
    viscous: Annotated[
        Quantity, Meaning("friction per velocity", "N s/m or N m s/rad", Bound.NON_NEGATIVE, Scope.MEASURES)
    ] = 0.0
    mu: Annotated[
        Quantity | None,
        Meaning("friction of fast sliding for the joint's force", "1", Bound.NON_NEGATIVE, Scope.MEASURES),
    ] = None
    mu_static: Annotated[
        Quantity | None, Meaning("friction that holds at most for it", "1", Bound.NON_NEGATIVE, Scope.MEASURES)
    ] = None
    radius: Annotated[Quantity | None, Meaning("radius of the bearing", "m", Bound.POSITIVE)] = None

    def faults(self, scene: Any) -> Iterator[Fault]:
        """What holds less than what slides, and what falls over no velocity. Of numbers; the rest is bounded."""
        if (self.coulomb is None) == (self.mu is None):
            both = "has coulomb and mu" if self.mu is not None else "does not say how much"
            yield Fault("friction", both, "give coulomb, or mu for friction by the joint's own force")
            return
        slides, holds = ("mu", "mu_static") if self.coulomb is None else ("coulomb", "breakaway")
        foreign = ("breakaway", "stribeck") if self.coulomb is None else ("mu_static", "radius")
        for key in foreign:
            if getattr(self, key) is not None:
                yield Fault(f"friction.{key}", f"does not go with {slides}", f"leave it out, or {slides}")
        yield from self._size_faults(slides, holds)

    def _size_faults(self, slides: str, holds: str) -> Iterator[Fault]:
        least, most = getattr(self, slides), getattr(self, holds)
        falls = self.stribeck != 0 and (self.stribeck is not None or (most is not None and most != least))
        if falls and self.stribeck_velocity is None:
            yield Fault("friction", f"falls from {holds} to {slides} over no velocity", "give a stribeck_velocity")
        if self.stribeck not in (None, 0) and most is None:
            remedy = "give a breakaway of at least coulomb and stribeck together"
            yield Fault("friction.stribeck", "is beyond what holds, which is coulomb", remedy)
        if not falls and self.stribeck_velocity is not None:
            remedy = f"give a {holds} above {slides}" if self.stribeck is None else "leave it out, or stribeck"
            yield Fault("friction.stribeck_velocity", "has no effect", remedy)
        if not falls and least == 0 and not most:
            yield Fault("friction", "is zero", f"give a {slides} above zero, or damping where it is only viscous")
        numbers = [one for one in (most, least, self.stribeck or 0.0) if isinstance(one, float | int)]
        if len(numbers) == 3 and numbers[0] < numbers[1] + numbers[2]:
            together = slides if self.stribeck is None else "coulomb and stribeck together"
            yield Fault(
                f"friction.{holds}", f"{numbers[0]:g} is below {together}: the joint would slide at once",
                "give a larger one",
            )  # fmt: skip

    def lever_faults(self, turns: bool) -> Iterator[Fault]:
        """Of a joint that turns, or slides: without a radius, or with one."""
        if self.mu is not None and turns and self.radius is None:
            yield Fault(
                "friction.radius", "is missing: a hinge rubs on its bearing", "give the radius of the bearing [m]"
            )
        if self.mu is not None and not turns and self.radius is not None:
            yield Fault("friction.radius", "applies to hinges only", "leave it out of a joint that slides")
