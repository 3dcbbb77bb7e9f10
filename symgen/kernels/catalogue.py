"""The functions a model offers, as SX kernels in independent and dependent coordinates (Eqs. 20-39).

Argument order everywhere: q_i, q_d, q_i_dot, q_d_dot, [extra], t, then p (c once hoisted). Hoisting drops what a
kernel does not use. q_i follows the partition, q_d the scene's coordinate order.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from functools import partial

import casadi as ca

from runtime.contract.records import Group
from symgen.algebra.rows import Row
from symgen.algebra.scalar import ZERO, dot
from symgen.condensed.condensation import Condensed
from symgen.condensed.forward_dynamics import is_tree, tree_accelerations
from symgen.condensed.loops import solve_forward
from symgen.kernels.all_coordinates import (
    acceleration_measures,
    augmented,
    constraints,
    energy,
    events,
    load_actions,
    load_forces,
    measures,
    poses,
    reactions,
    switching,
)
from symgen.kernels.kernel import Arguments, Kernel, arguments_of, blocks, dynamics
from symgen.kernels.specification import substep_name
from symgen.system.constraint import DerivationError
from symgen.system.equations import NoInertia
from symgen.system.topology import Topology

TREES_ONLY = {
    "forward_dynamics",
    "blocks",
    "shifted_solution",
}  # may be asked for of any scene, and be left out
FULLY_DRIVEN = (
    "closure", "velocities", "accelerations", "constraints", "reactions", "energy", "measures", "poses", "load_forces",
    "load_actions", "switching", "acceleration_measures",
)  # fmt: skip


JACOBIANS = ("dQ_hat_dq_i", "dQ_hat_dq_i_dot", "residual_jacobian")


def known_kernels(system: Condensed, builders: Collection[str], wanted: frozenset[str] | None) -> frozenset[str]:
    """The kernels that are wanted (all where None). Raises DerivationError for one that no scene like it has."""
    unknown = sorted((wanted or frozenset()) - frozenset(builders) - TREES_ONLY - _absent(system))
    if unknown:
        raise DerivationError("functions", f"the scene has no {', '.join(unknown)}", f"it has {', '.join(builders)}")
    return frozenset(builders) if wanted is None else wanted


def kernel_builders(
    system: Condensed, topology: Topology, named_groups: list[Group]
) -> dict[str, Callable[[], Kernel]]:
    """What builds each kernel of a system with its groups, slow to fast, by name; it may raise NoInertia."""
    arguments = arguments_of(system)
    groups = [group.positions for group in named_groups]
    builders: dict[str, Callable[[], Kernel]] = {
        "condensed": lambda: _condensed(system, arguments),
        "closure": lambda: _closure(system, arguments),
        "velocities": lambda: _velocities(system, arguments),
        "accelerations": lambda: _accelerations(system, arguments),
        "constraints": partial(constraints, system),
        "augmented": partial(augmented, system),
        "reactions": partial(reactions, system),
        "energy": partial(energy, system),
        "measures": partial(measures, system),
        "acceleration_measures": partial(acceleration_measures, system),
        "load_actions": partial(load_actions, system),
        "poses": lambda: poses(system.equations),
        "load_forces": partial(load_forces, system, [*system.equations.beams, *system.equations.flexible]),
    }
    if system.equations.events or system.equations.kinks:
        builders["events"] = partial(events, system)
    if system.equations.switching:
        builders["switching"] = partial(switching, system)
    builders |= {name: partial(_jacobian, name, system, arguments) for name in JACOBIANS}
    tree, deflections = is_tree(system, topology), system.deflections
    if deflections is not None:
        from symgen.kernels.deflection_kernels import deflection_kernels

        builders |= deflection_kernels(system, topology, arguments, deflections, tree)
    if tree:
        builders["forward_dynamics"] = lambda: dynamics(system, arguments, tree_accelerations(system, topology, {}))
    if len(groups) > 1:
        builders["blocks"] = lambda: blocks(arguments, system.M_hat(), system.generalised_force({}), named_groups)
    for level in range(1, len(groups)):
        builders[substep_name(level + 1)] = partial(_substep, system, arguments, groups, level)
    if system.reduced.elements:
        from symgen.kernels.element_kernels import with_elements

        builders = with_elements(builders, system, topology, arguments, named_groups)
    if not system.choice.independent:  # every coordinate is driven: there are no equations of motion to emit
        builders = {name: build for name, build in builders.items() if name in FULLY_DRIVEN}
    absent = _absent(system)
    return {name: build for name, build in builders.items() if name not in absent}


def _absent(system: Condensed) -> frozenset[str]:
    """Kernels that would give nothing."""
    eq = system.equations
    gives = {
        "closure": system.choice.dependent,
        "velocities": system.choice.dependent,
        "accelerations": system.choice.dependent,
        "constraints": eq.constraints,
        "reactions": eq.constraints,
        "measures": eq.measures,
        "acceleration_measures": eq.accelerated,
        "load_actions": eq.load_actions,
        "poses": eq.picture.poses,
        "load_forces": [name for body in (*eq.beams, *eq.flexible) for name in eq.loads_on(body)],
    }
    return frozenset(name for name, parts in gives.items() if not parts)


def _column(arguments: Arguments, values: Mapping[int, ca.SX]) -> ca.SX:
    entries = [values.get(c, ca.SX(0)) for c in arguments.dependent]
    return ca.densify(ca.vertcat(*entries)) if entries else ca.SX(0, 1)


def _independent(system: Condensed, vector: ca.SX) -> dict[int, ca.SX]:
    return {column: vector[k] for k, column in enumerate(system.choice.independent)}


def _condensed(system: Condensed, a: Arguments) -> Kernel:
    """M_hat and Q_hat (Eq. 38)."""
    inputs = a.select("q_i", "q_d", "q_i_dot", "q_d_dot")
    M_hat = system.M_hat()
    for k, column in enumerate(system.choice.independent):
        if M_hat[k, k].is_zero():
            raise NoInertia(column)
    return Kernel(inputs, {"M_hat": M_hat, "Q_hat": system.generalised_force({})})


def _jacobian(name: str, system: Condensed, a: Arguments) -> Kernel:
    """One of `JACOBIANS`."""
    from symgen.kernels.jacobians import jacobian_kernels

    return jacobian_kernels(system, a)[name]()


def _substep(system: Condensed, a: Arguments, groups: list[list[int]], level: int) -> Kernel:
    """M_hat of the groups from `level` on, and their right-hand side with slower accelerations given (Eq. 64)."""
    slow = [k for group in groups[:level] for k in group]
    fast = [k for group in groups[level:] for k in group]
    q_L_ddot = ca.SX.sym("q_L_ddot", len(slow))
    given = {system.choice.independent[k]: q_L_ddot[position] for position, k in enumerate(slow)}
    inputs = a.select("q_i", "q_d", "q_i_dot", "q_d_dot", q_L_ddot=q_L_ddot)
    M_hat, force = system.M_hat(), system.generalised_force(given)
    return Kernel(inputs, {"M_hat_SS": M_hat[fast, fast], "rhs_S": force[fast]})


def _closure(system: Condensed, a: Arguments) -> Kernel:
    """One Newton step on the loop unknowns, then q_d in closed form (Eq. 31).

    C_loop: the loop rows before the step; det_loop: the determinant of each block that the step solves.
    """
    eq, choice = system.reduced, system.choice
    guess = _structural_positions(system, {c: eq.q[c] for c in (*choice.independent, *choice.loop_columns)})
    closed_form = _column(a, guess)
    outputs = {"q_d_next": closed_form}
    if choice.loop_rows:
        old, new = _replacement(system, guess)
        entries = [(row, column) for row in choice.loop_rows for column in system.loops.rows[row].entries]
        values = [system.loops.rows[row].entries[column] for row, column in entries]
        residual = ca.vertcat(*(eq.constraints[row].C for row in choice.loop_rows))
        flat = ca.substitute([residual, *values], [old], [new])
        C = [flat[0][k] + 0 for k in range(len(choice.loop_rows))]
        U: dict[int, Row] = {row: {} for row in choice.loop_rows}
        for (row, column), value in zip(entries, flat[1:], strict=True):
            U[row][column] = value + 0
        U = {row: _by_rotation_vectors(system, found) for row, found in U.items()}
        (step,), determinants = solve_forward(system.loops.blocks, U, [dict(zip(choice.loop_rows, C, strict=True))])
        x_loop = [eq.q[c] - step[c] for c in choice.loop_columns]
        loops = ca.vertcat(*(eq.q[c] for c in choice.loop_columns))
        outputs = {
            "q_d_next": ca.substitute(closed_form, loops, ca.vertcat(*x_loop)),
            "C_loop": ca.vertcat(*C),
            "det_loop": ca.vertcat(*determinants),
        }
    return Kernel(a.select("q_i", "q_d"), outputs)


def _by_rotation_vectors(system: Condensed, row: Row) -> Row:
    """A loop row of C_q by the loop unknowns alone, where they are turns by theta: along omega times T(theta)."""
    loops = system.choice.loop_columns
    found = {column: value for column, value in row.items() if column in loops}
    for rotation in system.reduced.rotation_vectors:
        own = [(k, column) for k, column in enumerate(rotation.columns) if column in loops]
        along = [row.get(column, ZERO) for column in rotation.columns]
        if own and not all(value.is_zero() for value in along):
            T = rotation.T([system.reduced.q[column] for column in rotation.columns])
            found |= {column: dot(along, [T[i][k] for i in range(3)]) for k, column in own}
    return found


def _structural_positions(system: Condensed, known: dict[int, ca.SX]) -> dict[int, ca.SX]:
    """Closed forms of the structural coordinates: each row is solved for its pivot, in order of evaluation."""
    eq = system.reduced
    values = dict(known)
    for row, column in system.choice.structural:
        constraint = eq.constraints[row]
        involved = [c for c in constraint.C_q if c != column]
        old = ca.vertcat(eq.q[column], *(eq.q[c] for c in involved))
        new = ca.vertcat(0, *(values[c] for c in involved))
        rest = ca.substitute(constraint.C, old, new)
        values[column] = -rest / constraint.C_q[column]
    return values


def _replacement(system: Condensed, values: dict[int, ca.SX]) -> tuple[ca.SX, ca.SX]:
    columns = [column for _, column in system.choice.structural]
    if not columns:
        return ca.SX.sym("none", 0), ca.SX(0, 1)
    return (ca.vertcat(*(system.reduced.q[c] for c in columns)), ca.vertcat(*(values[c] for c in columns)))


def _velocities(system: Condensed, a: Arguments) -> Kernel:
    """q_d_dot (Eq. 36)."""
    values = system.dependent_velocities(_independent(system, a.q_i_dot))
    return Kernel(a.select("q_i", "q_d", "q_i_dot"), {"q_d_dot": _column(a, values)})


def _accelerations(system: Condensed, a: Arguments) -> Kernel:
    """q_d_ddot (Eq. 35)."""
    values = system.accelerations(_independent(system, a.q_i_ddot))
    inputs = a.select("q_i", "q_d", "q_i_dot", "q_d_dot", q_i_ddot=a.q_i_ddot)
    return Kernel(inputs, {"q_d_ddot": _column(a, values)})
