"""Distributed: a force per length along a beam."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Annotated, Any, Literal

from symgen.joints.joint import Surroundings, beam_faults
from symgen.loads.load import Acting, Load, LoadEffect, Row, Vector
from symgen.schema.fields import Fault, Meaning, Name, Number, Quantity, Scope, about, components_fault


class Distributed(Load):
    """A force per length [N/m] on a beam, from the fraction `start` of its length to `end`.

    components: expressions of the place `s` [m] from the beam's start and of all that loads may use. frame: "world";
    "body", turning with the beam's frame; "section", turning with each section, as a pressure does.
    """

    type: Literal["distributed"] = "distributed"
    beam: Annotated[Name, about("name of the beam")]
    components: Annotated[tuple[Quantity, ...], Meaning("force per length", "N/m", scope=Scope.PLACE)]
    frame: Annotated[
        Literal["world", "body", "section"],
        about("axes of the components: the world's, the beam's frame, or those of each section, as a pressure has"),
    ] = "world"
    start: Annotated[Number, about("where it begins, as a fraction of the length [1]")] = 0.0
    end: Annotated[Number, about("where it ends, as a fraction of the length [1]")] = 1.0

    carries = "force"

    def effect(self, m: Acting) -> LoadEffect:
        """Q = int p . dr/dq ds. r is linear in the shapes: where p is a polynomial of s in axes that do not bend, each
        of its powers acts at a mean point of the beam; else Gauss points, to the rounding of the shapes."""
        s = m.symbol("s")
        density = m.value("components", s=s)
        powers = None if self.frame == "section" else m.coefficients(density, s)

        def parts(start: float) -> list[tuple[Any, Vector]]:
            return self._by_stations(m, density, s, start) if powers is None else self._by_powers(m, powers, start)

        def beyond(at: float) -> Vector:
            whole = [0 * p for p in density]
            for _, force in parts(max(self.start, at)) if at < self.end else ():
                whole = [total + part for total, part in zip(whole, force, strict=True)]
            return whole

        row: Row = {}
        power_in: Any = 0
        for at, force in parts(self.start):
            for column, value in m.generalised((at, force, ())).items():
                row[column] = row[column] + value if column in row else value
            power_in = power_in + m.dot(force, at.r_dot)
        degree = float("inf") if powers is None else float(len(powers) - 1)
        along = (self.start, self.end, degree)
        return LoadEffect(row, applied=power_in, action=m.action(beyond(self.start)), along=along, beyond=beyond)

    def _by_powers(self, m: Acting, powers: Sequence[Vector], start: float) -> list[tuple[Any, Vector]]:
        """(mean point, force in world axes) of each power of s, from `start` on."""
        found: list[tuple[Any, Vector]] = []
        frame = m.frame_of(self.beam)
        for power, coefficient in enumerate(powers):
            if all(p.is_zero() for p in coefficient):
                continue
            weight, at = m.part_of_beam(self.beam, power, start, self.end)
            given = [weight * p for p in coefficient]
            found.append((at, given if self.frame == "world" else m.along(frame, given)))
        return found

    def _by_stations(self, m: Acting, density: Vector, s: Any, start: float) -> list[tuple[Any, Vector]]:
        """(point, force in world axes) at Gauss points, from `start` on."""
        found: list[tuple[Any, Vector]] = []
        frame = m.frame_of(self.beam)
        for place, weight, at in m.stations(self.beam, start, self.end):
            given: Vector = [weight * p for p in m.at_value(density, s, place)]
            if self.frame != "world":
                given = m.along(at if self.frame == "section" else frame, given)
            found.append((at, given))
        return found

    @property
    def acts_at(self) -> list[str]:
        """The beam."""
        return [self.beam]

    def faults(self, scene: Surroundings) -> Iterator[Fault]:
        """No beam, no part of it, components."""
        yield from beam_faults("beam", self.beam, scene)
        yield from components_fault("components", self.components, scene)
        for key in ("start", "end"):
            if not 0 <= getattr(self, key) <= 1:
                yield Fault(key, f"{getattr(self, key):g} is outside the beam", "give a fraction of its length, 0 to 1")
        if self.end <= self.start:
            yield Fault("end", f"{self.end:g} is not beyond start = {self.start:g}", "give a larger fraction")
