"""Kernels in all coordinates q (20)-(28), (37): constraints, augmented form, reactions, energies, measures, poses."""

from __future__ import annotations

from collections.abc import Sequence

import casadi as ca

from symgen.algebra.rows import Row, to_matrix
from symgen.algebra.scalar import ZERO, div, mul, sub
from symgen.condensed.condensation import Condensed
from symgen.condensed.loops import solve_transposed
from symgen.kernels.kernel import Kernel
from symgen.system.equations import Equations, matrix_times


def constraints(system: Condensed) -> Kernel:
    """C, C_q, C_t, nu = -C_t and gamma in all coordinates (Eqs. 21-27)."""
    eq = system.equations
    outputs = {
        "C": ca.vertcat(*(row.C for row in eq.constraints)),
        "C_q": eq.C_q,
        "C_t": ca.vertcat(*(row.C_t for row in eq.constraints)),
        "nu": ca.vertcat(*(-row.C_t for row in eq.constraints)),
        "gamma": ca.vertcat(*(row.gamma for row in eq.constraints)),
    }
    return Kernel(eq.state, outputs)


def augmented(system: Condensed) -> Kernel:
    """M, K, Q_v, Q_F, Q* = Q_F + Q_v - K q, C_q and the constraints' right-hand side of Eq. (28), all coordinates."""
    eq = system.equations
    outputs = {
        "M": to_matrix(eq.M, range(len(eq.q))),
        "K": to_matrix(eq.K, range(len(eq.q))),
        "Q_v": ca.vertcat(*eq.Q_v),
        "Q_F": ca.vertcat(*eq.Q_F),
        "Q_star": ca.vertcat(*eq.Q_star),
    }
    if eq.constraints:
        outputs["C_q"] = eq.C_q
        outputs["gamma"] = ca.vertcat(*(row.gamma for row in eq.constraints))
    return Kernel(eq.state, outputs)


def reactions(system: Condensed, held: ca.SX | None = None) -> Kernel:
    """Lagrange multipliers lam (Eq. 37), and joint forces (reaction forces).

    lam follow from the rows of the dependent coordinates, solved along the structure.

    lam_R: multipliers of redundant rows, which no equation determines; those of the other rows follow from them.
    joint_forces (3 or 6 x joints): world force [N] and moment [N m] of each joint on its body b, at marker b.
    held (n_e,): forces on elements, as symbols; None: those that hold what sticks.
    """
    eq, choice = system.equations, system.choice
    q_ddot = ca.SX.sym("q_ddot", len(eq.names))
    inertia = matrix_times(eq.M, {c: q_ddot[c] for c in range(len(eq.names))})
    force = {c: eq.Q_star[c] - inertia.get(c, ca.SX(0)) for c in range(len(eq.names))}
    lam_R = ca.SX.sym("lam_R", len(choice.redundant))
    given = {row: lam_R[k] for k, row in enumerate(choice.redundant)}
    for row, value in given.items():
        for column, factor in eq.constraints[row].C_q.items():
            force[column] = force[column] - factor * value
    if eq.elements:
        from symgen.condensed.locks import add_held_forces

        add_held_forces(system, force, held)
    lam = _loop_reactions(system, force) if choice.loop_rows else {}
    norms = {row.label: k for k, row in enumerate(eq.constraints)}
    norm_rows = {rotation.body: norms[f"{rotation.body}.norm"] for rotation in system.reduced.rotation_vectors}
    acting: dict[int, list[int]] = {}  # rows with known multipliers, by column
    for row in lam:
        for column in eq.constraints[row].C_q:
            acting.setdefault(column, []).append(row)
    turned = {row for row in range(len(eq.constraints), len(system.reduced.constraints))}
    for row, column in reversed(choice.structural):
        if row in turned:
            continue
        rest = force[column]
        for other in acting.get(column, ()):
            rest = sub(rest, mul(eq.constraints[other].C_q[column], lam[other]))
        lam[row] = div(rest, eq.constraints[row].C_q[column])
        for touched in eq.constraints[row].C_q:
            acting.setdefault(touched, []).append(row)
    for (
        rotation
    ) in system.reduced.rotation_vectors:  # what is left of the force on e is along e, the row of its unit length
        left = [
            force[c]
            - sum((row.C_q[c] * lam[k] for k, row in enumerate(eq.constraints) if k in lam and c in row.C_q), ca.SX(0))
            for c in rotation.parameters
        ]
        lam[norm_rows[rotation.body]] = ca.dot(ca.vertcat(*left), ca.vertcat(*rotation.e))
    inputs = {"q": ca.vertcat(*eq.q), "q_dot": ca.vertcat(*eq.q_dot), "q_ddot": q_ddot}
    inputs |= {"lam_R": lam_R, **eq.signals} if given else eq.signals
    lam |= given
    values = [lam[row] for row in range(len(eq.constraints))]
    return Kernel(inputs, {"lam": ca.vertcat(*values), "joint_forces": _joint_forces(eq, values)})


def _joint_forces(eq: Equations, lam: list[ca.SX]) -> ca.SX:
    """Of each joint on its body b, by columns."""
    size = max((len(row.on_b) for row in eq.constraints), default=3)
    forces = {joint: [ZERO] * size for joint in eq.joints}
    for row, value in zip(eq.constraints, lam, strict=True):
        for axis, factor in enumerate(row.on_b if row.joint else ()):
            forces[row.joint][axis] = sub(forces[row.joint][axis], mul(factor, value))
    return ca.horzcat(*(ca.vertcat(*force) for force in forces.values())) if forces else ca.SX(size, 0)


def _loop_reactions(system: Condensed, force: Row) -> dict[int, ca.SX]:
    """U^T lam_loop = the force on the loop unknowns after all structural coordinates are substituted."""
    choice = system.choice
    structural = [s for s in system.substitutions if s.column not in choice.loop_columns]
    work = dict(force)
    for substitution in reversed(structural):
        value = work.pop(substitution.column)
        for column, factor in substitution.e.items():
            work[column] = work.get(column, ca.SX(0)) + factor * value
    return solve_transposed(system.loops.blocks, system.loops.entries(), work)


def energy(system: Condensed) -> Kernel:
    """Energies [J] and powers [W]: kinetic, elastic, potential, dissipated (>= 0), applied by loads."""
    eq = system.equations
    return Kernel(
        eq.state,
        {
            "kinetic": eq.kinetic(),
            "elastic": eq.elastic,
            "potential": eq.potential,
            "power_dissipated": eq.dissipated,
            "power_applied": eq.applied,
        },
    )


def load_forces(system: Condensed, bodies: Sequence[str]) -> Kernel:
    """Generalised force of each load on the coordinates of each body's frame [N, N m], zeros where one has fewer.

    Of both its ends, and of the friction of joints, on flexible bodies: what their stresses and section forces are made
    of. `load_actions` has one end of a load, in world axes, for who draws or reads it: neither follows from the other.
    Behind them, where a load is linear along a beam, the world force [N] of the second half of its part of the beam,
    which says how it is shared out.
    """
    eq = system.equations
    frames = {body: eq.frame_columns(body) for body in bodies}
    rows = max((len(columns) for columns in frames.values()), default=0)
    linear = any(along[2:] == [1.0] for along in eq.load_spans.values())
    columns = [
        ca.vertcat(
            *(eq.load_forces[name].get(column, ca.SX(0)) for column in own),
            ca.SX(rows - len(own), 1),
            *(_second_half(eq, name) if linear else ()),
        )
        for body, own in frames.items()
        for name in eq.loads_on(body)
    ]
    return Kernel(eq.state, {"load_forces": ca.densify(ca.horzcat(*columns)) if columns else ca.SX(rows, 0)})


def _second_half(eq: Equations, name: str) -> Sequence[ca.SX]:
    """World force of a load that is linear along a beam, beyond the middle of its part of the beam; zeros of others."""
    along = eq.load_spans.get(name, [])
    if along[2:] != [1.0]:
        return [ca.SX(0)] * len(eq.gravity)
    return eq.loads_beyond[name]((along[0] + along[1]) / 2)


def measures(system: Condensed) -> Kernel:
    """The scene's measures and their rates, in scene order, but for `acceleration_measures`."""
    eq = system.equations
    values = list(eq.measures.values())
    return Kernel(eq.state, {"measures": ca.vertcat(*values) if values else ca.SX(0, 1)})


def acceleration_measures(system: Condensed) -> Kernel:
    """The scene's measures that follow from accelerations and joint forces; lam_R as of `reactions`."""
    eq = system.equations
    forces = reactions(system)
    values = ca.vertcat(*eq.accelerated.values())
    (values,) = ca.substitute([values], [ca.vertcat(*eq.lam)], [forces.outputs["lam"]]) if eq.lam else (values,)
    (values,) = ca.substitute([values], [ca.vertcat(*eq.q_ddot)], [forces.inputs["q_ddot"]])
    return Kernel(forces.inputs, {"acceleration_measures": values})


def load_actions(system: Condensed) -> Kernel:
    """(3 or 6 x loads): world force [N] and moment [N m] of each load on its marker or marker b."""
    eq = system.equations
    columns = [ca.vertcat(*action) for action in eq.load_actions.values()]
    return Kernel(eq.state, {"load_actions": ca.horzcat(*columns) if columns else ca.SX(0, 0)})


def switching(system: Condensed) -> Kernel:
    """What changes sign where a load, a state's rate or a prescribed motion jumps or kinks in time."""
    eq = system.equations
    return Kernel(dict(eq.signals), {"switching": ca.vertcat(*(value for _, value in eq.switching))})


def events(system: Condensed) -> Kernel:
    """What passes zero when an event happens and, behind them, where a load kinks; what inputs become by actions."""
    eq = system.equations
    actions = [value for _, action in eq.events.values() for value in action.values()]
    passing = [when for when, _ in eq.events.values()] + [value for _, value in eq.kinks.values()]
    outputs = {"events": ca.vertcat(*passing)}
    return Kernel(eq.state, {**outputs, "actions": ca.vertcat(*actions)} if actions else outputs)


def poses(equations: Equations) -> Kernel:
    """(12 x bodies): origin r [m], then the columns of A, of each body that moves; a planar one in the xy-plane."""
    columns = [
        ca.vertcat(*r, *(A[i][j] for j in range(3) for i in range(3))) for r, A in equations.picture.poses.values()
    ]
    return Kernel({"q": ca.vertcat(*equations.q)}, {"poses": ca.horzcat(*columns) if columns else ca.SX(12, 0)})


def geometry(equations: Equations, p: ca.SX) -> Kernel:
    """The points of the manifest's `drawing` in turn, in body axes, as functions of the parameters.

    positions (3 x points) [m]; axes (9 x points): columns of the marker's rotation; shapes, turns (3 x modes of each
    point's body): displacement and rotation by each mode; H: nf x nf of each point that has it [1/m]; sections
    (2 x beams): height and width [m]; rigidities (2 x beams): E I [N m^2].
    """
    points, sections = equations.picture.points, equations.picture.sections.values()

    def columns(rows: int, vectors: list[list[ca.SX]]) -> ca.SX:
        return ca.horzcat(*(ca.vertcat(*vector) for vector in vectors)) if vectors else ca.SX(rows, 0)

    outputs = {
        "positions": columns(3, [point.position for point in points]),
        "axes": columns(9, [[point.axes[i][j] for j in range(3) for i in range(3)] for point in points]),
        "shapes": columns(3, [shape for point in points for shape in point.shapes]),
        "turns": columns(3, [turn for point in points for turn in point.turns]),
        "H": columns(1, [[value] for point in points for row in point.H for value in row]),
        "sections": columns(2, [list(section) for section in sections]),
        "rigidities": columns(2, list(equations.picture.rigidities.values())),
    }
    return Kernel({"p": p}, {name: value for name, value in outputs.items() if value.numel()})
