"""Force: at a marker, in world axes or turning with the body."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, Literal

from symgen.joints.joint import Surroundings
from symgen.loads.load import Acting, Load, LoadEffect
from symgen.schema.fields import Fault, MarkerRef, Meaning, Quantity, Scope, about, components_fault


class Force(Load):
    """A force at a marker; components [N] along the world's axes or the body's."""

    type: Literal["force"] = "force"
    marker: Annotated[MarkerRef, about('marker where it acts, `"body.marker"`')]
    components: Annotated[tuple[Quantity, ...], Meaning("force, (x, y) or (x, y, z)", "N", scope=Scope.MEASURES)]
    frame: Annotated[Literal["world", "body"], about("axes of the components: the world's or the body's")] = "world"

    carries = "force"

    def effect(self, m: Acting) -> LoadEffect:
        """Q = F^T dr/dq, power F . r'."""
        at, given = m.marker(self.marker), m.value("components")
        force = m.along(at, given) if self.frame == "body" else given
        return LoadEffect(m.generalised((at, force, ())), applied=m.dot(force, at.r_dot), action=m.action(force))

    def faults(self, scene: Surroundings) -> Iterator[Fault]:
        """Components."""
        yield from components_fault("components", self.components, scene)
