"""A body of a tree of frames, as the scene's equations see it."""

from __future__ import annotations

import casadi as ca

from symgen.algebra.rows import Row
from symgen.algebra.scalar import ZERO
from symgen.bodies.spatial_body import SpatialBody


class ReducedBody:
    """A body's modal stiffness and damping; its inertia and weight are in the recursions."""

    def __init__(self, body: SpatialBody) -> None:
        self.stiffness_entries, self.damping_force = body.stiffness_entries, body.damping_force
        self.elastic_energy = body.elastic_energy

    def mass_entries(self) -> list[tuple[int, int, ca.SX]]:
        """None here."""
        return []

    def quadratic_velocity_force(self) -> Row:
        """None here."""
        return {}

    def gravity_force(self, gravity: list[ca.SX]) -> Row:
        """None here."""
        return {}

    def gravity_potential(self, gravity: list[ca.SX]) -> ca.SX:
        """None here."""
        return ZERO
