"""The equations of a spatial mechanism in the coordinates of its tree alone: no row and column for placed bodies.

The columns are those of all coordinates, of which the origins and Euler parameters of placed bodies stay empty. M and
the inertia forces come from the recursions along the frames; joints that close loops, loads and measures are stated by
markers whose motion is given by the tree's coordinates. Rows of placing joints stay as they are: they give the placed
coordinates.
"""

from __future__ import annotations

from dataclasses import replace
from functools import partial

import casadi as ca

from symgen.algebra.parameters import ParameterTable
from symgen.algebra.scalar import ONE, ZERO, neg
from symgen.scene import Scene
from symgen.system.equations import Equations
from symgen.system.frames.aba import floats
from symgen.system.frames.crba import mass_rows
from symgen.system.frames.rnea_derivatives import has_force_changes
from symgen.system.mechanism import Mechanism
from symgen.system.orientations import Orientations, Turning, turn_coordinates
from symgen.system.topology import Topology
from symgen.system.tree_forces import TreeForces
from symgen.system.tree_space import TreeSpace


def reduced_equations(
    scene: Scene, table: ParameterTable, whole: Equations, topology: Topology, orientations: Orientations
) -> Equations:
    """The equations of a spatial scene in the coordinates of its tree; whole: in all coordinates.

    Columns of rotation vectors, whose velocities are angular velocities, follow those of all coordinates.
    """
    turns = [entry for body in orientations.bodies for entry in turn_coordinates(body)]
    n = len(whole.q)
    size = n + len(turns)
    q = [*whole.q, *(ca.SX.sym(entry.name) for entry in turns)]
    q_dot = [*whole.q_dot, *(ca.SX.sym(entry.name.replace("turn_", "omega_")) for entry in turns)]
    held = {ball.child for ball in orientations.balls.values()}
    blank = replace(
        whole,
        coordinates=[*whole.coordinates, *turns],
        q=q,
        q_dot=q_dot,
        turnings=[_turning(whole, body, n + 3 * k, q_dot) for k, body in enumerate(orientations.bodies)],
        M=[{} for _ in range(size)],
        K=[{} for _ in range(size)],
        Q_v=[ZERO] * size,
        Q_F=[ZERO] * size,
        constraints=[],
        elastic=ca.SX(0),
        potential=ca.SX(0),
        dissipated=ca.SX(0),
        applied=ca.SX(0),
        measures={},
        body_columns={},
        measure_units={},
        load_forces={},
        load_actions={},
        springs={},
        events={},
        switching=[],
        placed_columns=frozenset(
            column
            for column, coordinate in enumerate(whole.coordinates)
            if (
                (coordinate.owner in topology.placed and not coordinate.elastic)
                or (coordinate.owner in held and coordinate.kind == "position")
            )
            and column not in whole.joint_columns
        ),
    )
    space = TreeSpace(scene, table, blank, topology, whole, orientations)
    equations = Mechanism(scene, table, space, blank, topology).equations
    _tell(whole, equations, ca.vertcat(*q_dot[n:]))
    for turning in equations.turnings:
        equations.body_columns[turning.body] += turning.columns
        equations.constraints += turning.rows([q[column] for column in turning.columns])
    equations.M = mass_rows(space.tree, len(equations.q))
    for column in equations.states.values():  # of controllers, which no body knows of
        equations.M[column] = {column: ONE}
    forces = TreeForces(space.tree, equations)
    equations.inertia_forces = forces.inertia_forces
    if has_force_changes(space.tree):
        equations.force_changes, equations.tied_changes = (
            forces.force_changes,
            partial(forces.tied_changes, space.loop_rates),
        )
        equations.curvatures, equations.loop_rates = space.curvatures, space.loop_rates
    if not floats(space.tree):
        equations.free_joints = forces.free_joints
        if not equations.turnings and not equations.states:
            equations.carried = forces.carried
    for column, value in equations.inertia_forces({}).items():
        equations.Q_v[column] = neg(value)
    equations.felt_columns = _felt(equations, topology, orientations)
    return equations


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
    """Actions of loads and events by the coordinates of the tree, which are shorter, where no angular velocity is."""
    for name, action in reduced.load_actions.items():
        if not ca.depends_on(ca.vertcat(*action), omega):
            whole.load_actions[name] = action
    for name, event in reduced.events.items():
        if not ca.depends_on(ca.vertcat(event[0], *event[1].values()), omega):
            whole.events[name] = event


def _turning(whole: Equations, body: str, first: int, q_dot: list[ca.SX]) -> Turning:
    """The columns and symbols of a body whose first turn has the column `first`."""
    columns = list(range(first, first + 3))
    parameters = [whole.names.index(f"{body}.e{k}") for k in range(4)]
    chart = [ca.SX.sym(f"{body}.chart_{k}") for k in range(4)]
    return Turning(body, columns, parameters, [whole.q[k] for k in parameters], [q_dot[k] for k in columns], chart)
