"""The recursions along a tree of frames with the rates and the weight of a system."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import casadi as ca

from symgen.algebra.rows import Row, add_scaled
from symgen.algebra.scalar import ONE, ZERO, add, neg
from symgen.algebra.vectors import Vector
from symgen.system.equations import Equations
from symgen.system.frames.aba import free_joint_accelerations
from symgen.system.frames.carried_frames import CarriedFrames
from symgen.system.frames.fields import Direction
from symgen.system.frames.loop_derivatives import LoopForce, LoopRates, tied_changes
from symgen.system.frames.rnea import floating_forces, inverse_dynamics, lone_hinges, own_wrenches
from symgen.system.frames.rnea_derivatives import force_changes
from symgen.system.frames.tree import GROUND, FrameTree


@dataclass(frozen=True)
class TreeForces:
    """Of a tree of frames that moves by the coordinates of some equations."""

    tree: FrameTree
    equations: Equations

    @property
    def _base(self) -> Vector:
        return [neg(component) for component in self.equations.gravity]

    @property
    def _rates(self) -> Row:
        return dict(enumerate(self.equations.q_dot))

    def inertia_forces(self, accelerations: Row) -> Row:
        """M x'' - Q_v and the weight, by column."""
        force = inverse_dynamics(self.tree, self._base, self._rates, accelerations)
        add_scaled(force, ONE, floating_forces(self.tree, self.equations.M, self._base, accelerations))
        for column in self.equations.states.values():
            if column in accelerations:
                force[column] = accelerations[column]
        return force

    def force_changes(self, accelerations: Row) -> tuple[list[Row], list[Row]]:
        """Derivatives of `inertia_forces` by q and by q_dot."""
        return force_changes(self.tree, len(self.equations.q), self._base, self._rates, accelerations)

    def tied_changes(
        self,
        loops: Mapping[str, LoopRates],
        accelerations: Row,
        multipliers: Mapping[str, Sequence[ca.SX]],
        directions: Sequence[Direction],
    ) -> tuple[ca.SX, ca.SX] | None:
        """Derivatives of `inertia_forces` + C_q^T lambda of spherical loops along directions."""
        if not loops or any(way.base != GROUND for loop in loops.values() for way in (loop.a, loop.b)):
            return None
        ties = [LoopForce(loop.a, loop.b, list(multipliers[joint])) for joint, loop in loops.items()]
        moving = self._rates, accelerations
        return tied_changes(self.tree, len(self.equations.q), self._base, moving, ties, directions)

    def free_joints(self, force: Row, free: frozenset[int], imposed: Row | None = None) -> Row:
        """Accelerations by a force, and with `imposed` ones by rates and weight too.

        These are solved for as differences from a motion in which no hinge turns its body faster: less wrenches.
        """
        if imposed is None:
            return free_joint_accelerations(self.tree, force, free)
        hinges = lone_hinges(self.tree) & free
        wrenches, modes, chosen = own_wrenches(self.tree, self._base, self._rates, imposed, hinges)
        left = dict(force)
        add_scaled(left, neg(ONE), modes)
        found = free_joint_accelerations(self.tree, left, free, wrenches)
        return {column: add(value, chosen.get(column, ZERO)) for column, value in found.items()}

    def carried(self, columns: frozenset[int]) -> CarriedFrames:
        """The frames that these columns move, and all beyond them; for trees without balls."""
        return CarriedFrames(self.tree, columns, self._base, self._rates)
