"""A linear structure without bodies: M x'' + D x' + K x = F(t) (Eq. 3-14)."""

from __future__ import annotations

from typing import Annotated

from symgen.schema.fields import Matrix, Meaning, Name, Scope, StrictModel, Vector


class Structure(StrictModel):
    """Coordinates x (n names) and the matrices mass, damping, stiffness (n x n); force: n entries."""

    coordinates: tuple[Name, ...]
    mass: Annotated[Matrix, Meaning("mass matrix", "kg")]
    damping: Annotated[Matrix | None, Meaning("damping matrix", "N s/m")] = None
    stiffness: Annotated[Matrix, Meaning("stiffness matrix", "N/m")]
    force: Annotated[Vector | None, Meaning("force", "N", scope=Scope.TIME)] = None
