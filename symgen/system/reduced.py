"""The equations of a spatial mechanism in the coordinates of its tree alone: no row and column for placed bodies.

The columns are those of all coordinates, of which the origins and Euler parameters of placed bodies stay empty. M and
the inertia forces come from the recursions along the frames; joints that close loops, loads and measures are stated by
markers whose motion is given by the tree's coordinates. Rows of placing joints stay as they are: they give the placed
coordinates.

The recursions along a tree of frames with the rates and the weight of a system.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial

import casadi as ca

from runtime.contract.records import Coordinate
from symgen.algebra.rows import Row, add_scaled
from symgen.algebra.scalar import ONE, ZERO, add, neg
from symgen.algebra.vectors import Vector
from symgen.bodies.spatial_body import SpatialMarker
from symgen.system.equations import Direction, Equations, Rotor
from symgen.system.frames.aba import floats, free_joint_accelerations
from symgen.system.frames.crba import mass_rows
from symgen.system.frames.loop_derivatives import LoopForce, LoopRates, loop_changes
from symgen.system.frames.rnea import floating_forces, inverse_dynamics, lone_hinges, own_wrenches
from symgen.system.frames.rnea_derivatives import force_changes, has_force_changes
from symgen.system.frames.tree import GROUND, FrameTree
from symgen.system.mechanism import Mechanism, with_rotors, with_states
from symgen.system.orientations import Orientations, Turning, turn_coordinates
from symgen.system.spatial import SpatialSpace
from symgen.system.topology import Topology
from symgen.system.tree_space import TreeSpace


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

    def loop_changes(
        self,
        loops: Mapping[str, LoopRates],
        accelerations: Row,
        multipliers: Mapping[str, Sequence[ca.SX]],
        directions: Sequence[Direction],
    ) -> tuple[ca.SX, ca.SX] | None:
        """Derivatives of `inertia_forces` + C_q^T lambda of spherical loops along directions."""
        if not loops or any(way.base != GROUND for loop in loops.values() for way in (loop.a, loop.b)):
            return None
        found = [LoopForce(loop.a, loop.b, list(multipliers[joint])) for joint, loop in loops.items()]
        moving = self._rates, accelerations
        return loop_changes(self.tree, len(self.equations.q), self._base, moving, found, directions)

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


def reduced_equations(built: Mechanism[SpatialMarker], space: SpatialSpace, orientations: Orientations) -> Equations:
    """The equations of a spatial mechanism that was built in all coordinates, in those of its tree.

    Columns of rotation vectors, whose velocities are angular velocities, follow those of all coordinates.
    """
    whole, topology = built.equations, built.topology
    turns = [entry for body in orientations.bodies for entry in turn_coordinates(body)]
    n = len(whole.q)
    size = n + len(turns)
    q = [*whole.q, *(ca.SX.sym(entry.name) for entry in turns)]
    q_dot = [*whole.q_dot, *(ca.SX.sym(entry.name.replace("turn_", "omega_")) for entry in turns)]
    blank = Equations(
        [*whole.coordinates, *turns],
        q,
        q_dot,
        whole.t,
        [{} for _ in q],
        [ZERO] * size,
        [],
        u=whole.u,
        inputs=whole.inputs,
        beams=whole.beams,
        flexible=whole.flexible,
        turnings=[_turning(whole, body, n + 3 * k, q_dot) for k, body in enumerate(orientations.bodies)],
        placed_columns=_placed(whole, topology, orientations),
    )
    tree_space = TreeSpace(space, blank, whole, orientations)
    equations = Mechanism(built.scene, built.table, tree_space, blank, topology).equations
    _tell(whole, equations, ca.vertcat(*q_dot[n:]))
    for turning in equations.turnings:
        equations.body_columns[turning.body] += turning.columns
        equations.constraints += turning.rows([q[column] for column in turning.columns])
    tree = tree_space.tree
    equations.masses = lambda: with_states(mass_rows(tree, size), equations)
    forces = TreeForces(tree, replace(equations) if equations.rotors else equations)
    equations.inertia_forces = forces.inertia_forces
    if equations.rotors:
        equations.masses = lambda: with_rotors(with_states(mass_rows(tree, size), equations), equations)
        equations.inertia_forces = partial(_inertia_with_rotors, forces, equations.rotors)
    elif has_force_changes(tree):
        equations.force_changes, equations.loop_changes = (
            forces.force_changes,
            partial(forces.loop_changes, tree_space.loop_rates),
        )
        equations.curvatures, equations.loop_rates = tree_space.curvatures, tree_space.loop_rates
    if not floats(tree) and not equations.rotors:
        equations.free_joints = forces.free_joints
    inertia_forces = equations.inertia_forces
    equations.velocity_forces = lambda: _negated(inertia_forces({}), size)
    equations.felt_columns = _felt(equations, topology, orientations)
    return equations


def _placed(whole: Equations, topology: Topology, orientations: Orientations) -> frozenset[int]:
    """Coordinates of the frames of bodies that joints place, and origins of those that spherical joints hold."""
    on_balls = {ball.child for ball in orientations.balls.values()}

    def placed(entry: Coordinate) -> bool:
        own = entry.owner in topology.placed and not entry.elastic
        return own or (entry.owner in on_balls and entry.kind == "position")

    return frozenset(k for k, entry in enumerate(whole.coordinates) if placed(entry)) - whole.joint_columns


def _negated(row: Row, n: int) -> list[ca.SX]:
    return [neg(row[column]) if column in row else ZERO for column in range(n)]


def _inertia_with_rotors(forces: TreeForces, rotors: list[Rotor], accelerations: Row) -> Row:
    """Inertia forces of the bodies and of the rotors of motors, which no recursion along the frames knows of."""
    found = forces.inertia_forces(accelerations)
    for rotor in rotors:
        add_scaled(found, ONE, rotor.force(accelerations))
    return found


def _felt(equations: Equations, topology: Topology, orientations: Orientations) -> frozenset[int]:
    """Coordinates of the frames of placed bodies that forces depend on, and those of the bodies before these."""
    forces = ca.vertcat(*equations.Q_F)
    known = {symbol.element_hash() for symbol in ca.symvar(forces)}
    parents = {one.child: one.parent for one in topology.placements.values()}
    parents |= {ball.child: ball.parent for ball in orientations.balls.values()}
    felt: set[int] = set()
    for body, columns in equations.body_columns.items():
        own: str | None = body
        if any(known & {equations.q[c].element_hash(), equations.q_dot[c].element_hash()} for c in columns):
            while own is not None:
                felt |= equations.placed_columns.intersection(equations.body_columns.get(own, ()))
                own = parents.get(own)
    return frozenset(felt)


def _tell(whole: Equations, reduced: Equations, omega: ca.SX) -> None:
    """Actions of loads, events and kinks by the shorter coordinates of the tree, where no angular velocity is."""
    for name, action in reduced.load_actions.items():
        if not ca.depends_on(ca.vertcat(*action), omega):
            whole.load_actions[name] = action
    for name, event in reduced.events.items():
        if not ca.depends_on(ca.vertcat(event[0], *event[1].values()), omega):
            whole.events[name] = event
    for name, kink in reduced.kinks.items() if [*reduced.kinks] == [*whole.kinks] else ():
        if not ca.depends_on(kink[1], omega):
            whole.kinks[name] = kink


def _turning(whole: Equations, body: str, first: int, q_dot: list[ca.SX]) -> Turning:
    """The columns and symbols of a body whose first turn has the column `first`."""
    columns = list(range(first, first + 3))
    parameters = [whole.names.index(f"{body}.e{k}") for k in range(4)]
    chart = [ca.SX.sym(f"{body}.chart_{k}") for k in range(4)]
    return Turning(body, columns, parameters, [whole.q[k] for k in parameters], [q_dot[k] for k in columns], chart)
