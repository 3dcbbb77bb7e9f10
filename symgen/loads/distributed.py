"""Distributed: a force per length along a beam."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, Any, Literal

from symgen.joints.joint import Surroundings, beam_faults
from symgen.loads.load import Acting, Load, LoadEffect, Row
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
        forces: list[tuple[Any, Any]] = []
        if powers is None:
            for place, weight, at in m.stations(self.beam, self.start, self.end):
                forces.append((at, [weight * p for p in m.at_value(density, s, place)]))
        else:
            for power, coefficient in enumerate(powers):
                if all(p.is_zero() for p in coefficient):
                    continue
                weight, at = m.part_of_beam(self.beam, power, self.start, self.end)
                forces.append((at, [weight * p for p in coefficient]))
        row: Row = {}
        whole, power_in = [0 * p for p in density], 0
        frame, degree = m.frame_of(self.beam), float("inf") if powers is None else float(len(powers) - 1)
        for at, given in forces:
            force = given
            if self.frame != "world":
                force = m.along(at if self.frame == "section" else frame, given)
            for column, value in m.generalised((at, force, ())).items():
                row[column] = row[column] + value if column in row else value
            whole = [total + part for total, part in zip(whole, force, strict=True)]
            power_in = power_in + m.dot(force, at.r_dot)
        return LoadEffect(row, applied=power_in, action=m.action(whole), along=(self.start, self.end, degree))

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
