"""What each function is: equation, meaning, stage, arguments and outputs with shape and unit from the table of names.

The emitted docstrings, the manifest and the table in the page on generated code are made from these records.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from runtime.contract.records import FunctionSpec, Group, Signal
from runtime.contract.tape import Tape
from symgen.notation.symbols import BY_NAME

STATE = "q_i q_d q_i_dot q_d_dot"
WITH_REDUNDANT_ROWS = "; lam_R: multipliers of the redundant rows, which the others go with"


def _signal(name: str) -> Signal:
    symbol = BY_NAME[name]
    return Signal(name, symbol.shape, symbol.unit, symbol.meaning)


def _spec(name: str, equation: str, meaning: str, stage: str, inputs: str, outputs: str) -> FunctionSpec:
    given, found = ([_signal(key) for key in text.split()] for text in (inputs, outputs))
    return FunctionSpec(name, equation, meaning, stage, given, found)


_BLOCKS = replace(
    _spec(
        "blocks", "39", "Blocks of M_hat and Q_hat by the groups of the partition", "condensed", f"{STATE} t u c", ""
    ),
    outputs=[
        Signal("M_hat_LS", "n_L x n_S", "SI", "block of M_hat: rows of one group, columns of another"),
        Signal("Q_hat_L", "n_L", "N, N m", "part of Q_hat of a group"),
    ],
)
FUNCTIONS: dict[str, FunctionSpec] = {
    spec.name: spec
    for spec in (
        _spec("constants", "", "Everything that depends on the parameters p only", "constants", "p", "c"),
        _spec("bounded", "", "Expressions whose sign must not change with the parameters", "constants", "p", "bounded"),
        _spec(
            "closure",
            "31",
            "One Newton step on the loop unknowns, then q_d; C_loop before the step",
            "closure",
            "q_i q_d t u chart c",
            "q_d_next C_loop det_loop",
        ),
        _spec(
            "velocities", "36", "Rates of the dependent coordinates", "velocities", "q_i q_d q_i_dot t u c", "q_d_dot"
        ),
        _spec("condensed", "38", "Condensed mass matrix and force", "condensed", f"{STATE} t u c", "M_hat Q_hat"),
        _BLOCKS,
        _spec(
            "forward_dynamics",
            "38",
            "Accelerations of a tree by topology-ordered elimination, without M_hat",
            "condensed",
            f"{STATE} t u c",
            "q_i_ddot",
        ),
        _spec(
            "deflections",
            "",
            "Stiff deflections s = B^T q_i, and the stiffness and damping between them",
            "closure",
            "c",
            "B K_s D_s",
        ),
        _spec(
            "deflection_response",
            "38",
            "Accelerations of a large tree, and M_hat^-1 B, by one elimination along it",
            "condensed",
            f"{STATE} t u c",
            "q_i_ddot X",
        ),
        _spec(
            "shifted_solution",
            "38",
            "x of (M_hat + B (kappa K_s + delta D_s) B^T) x = B push on a large tree; shift: kappa, delta",
            "accelerations",
            "q_i q_d shift push t u c",
            "x_re x_im",
        ),
        _spec(
            "constraints",
            "21-27",
            "Constraints and their derivatives in all coordinates",
            "condensed",
            "q q_dot t u c",
            "C C_q C_t nu gamma",
        ),
        _spec(
            "augmented",
            "28",
            "Parts of the augmented form; Q_star = Q_F + Q_v - K q",
            "condensed",
            "q q_dot t u c",
            "M K Q_v Q_F Q_star C_q gamma",
        ),
        _spec(
            "dQ_hat_dq_i",
            "",
            "Total derivative of Q_hat by q_i, through q_d = f(q_i, t)",
            "condensed",
            f"{STATE} t u c",
            "dQ_hat_dq_i",
        ),
        _spec(
            "dQ_hat_dq_i_dot",
            "",
            "Total derivative of Q_hat by q_i_dot, through q_d_dot",
            "condensed",
            f"{STATE} t u c",
            "dQ_hat_dq_i_dot",
        ),
        _spec(
            "residual_jacobian",
            "",
            "Total derivatives of Q_hat - M_hat q_i_ddot by q_i and by q_i_dot at fixed q_i_ddot",
            "accelerations",
            f"{STATE} q_i_ddot t u c",
            "J_q J_v",
        ),
        _spec(
            "substep",
            "64",
            "Sub-step: M_hat of the active groups and their right-hand side with slower accelerations given",
            "accelerations",
            f"{STATE} q_L_ddot t u c",
            "M_hat_SS rhs_S",
        ),
        _spec(
            "accelerations",
            "35",
            "Accelerations of the dependent coordinates",
            "accelerations",
            f"{STATE} q_i_ddot t u c",
            "q_d_ddot",
        ),
        _spec(
            "reactions",
            "37",
            "Multipliers, and what the joints do to their bodies b",
            "reactions",
            "q q_dot q_ddot lam_R t u c",
            "lam joint_forces",
        ),
        _spec(
            "energy",
            "",
            "Energies and powers",
            "report",
            "q q_dot t u c",
            "kinetic elastic potential power_dissipated power_applied",
        ),
        _spec("measures", "", "The scene's measures and their rates", "report", "q q_dot t u c", "measures"),
        _spec(
            "acceleration_measures",
            "",
            "The scene's measures that follow from accelerations and joint forces",
            "reactions",
            "q q_dot q_ddot lam_R t u c",
            "acceleration_measures",
        ),
        _spec(
            "load_forces",
            "",
            "Generalised force of each load on the coordinates of each flexible body's frame",
            "report",
            "q q_dot t u c",
            "load_forces",
        ),
        _spec("load_actions", "", "What the loads do at their markers", "report", "q q_dot t u c", "load_actions"),
        _spec(
            "events",
            "",
            "Events happen where these pass zero, and loads kink; what inputs become by actions",
            "report",
            "q q_dot t u c",
            "events actions",
        ),
        _spec(
            "switching",
            "",
            "Where in time loads and prescribed motions jump or kink: where one of these changes its sign",
            "closure",
            "t u c",
            "switching",
        ),
        _spec(
            "elements",
            "",
            "Directions that may stick, v_rel = G q_i', v_rel' = G q_i'' + G_bias, and M_hat, Q_hat with none stuck",
            "condensed",
            f"{STATE} t u c",
            "M_hat Q_hat G G_bias v_rel holds slides gap restitution Q_hat_R holds_R F_0 F_a F_R F_f shares margin",
        ),
        _spec(
            "element_forces",
            "",
            "Forces on directions that may stick, their rates, and how far each is from the end of its mode",
            "accelerations",
            f"{STATE} q_i_ddot t u c",
            "f_rel v_rel mode_left",
        ),
        _spec("poses", "", "Origin and rotation matrix of each body, for pictures", "condensed", "q c", "poses"),
        _spec(
            "geometry",
            "",
            "Points of the bodies as functions of the parameters, for pictures",
            "constants",
            "p",
            "positions axes shapes turns H sections rigidities",
        ),
    )
}


def substep_name(level: int) -> str:
    """Name of the sub-step function of the groups from `level` (counted from 1) on."""
    return f"substep_{level}"


def specification(name: str, tape: Tape, groups: Sequence[Group], redundant: bool) -> FunctionSpec:
    """The record of an emitted function: with the arguments and outputs that it has, their sizes and operations."""
    substeps = [substep_name(level) for level in range(2, len(groups) + 1)]
    spec = FUNCTIONS["substep" if name in substeps else name]
    # loads that jump by the motion are in functions of every stage
    known = {signal.name: signal for signal in (_signal("side"), *spec.inputs, *spec.outputs)}
    if name == "blocks":
        known |= dict(zip(tape.output_names, block_signals(groups), strict=True))
    inputs = [
        replace(known[argument], size=[size, 1])
        for argument, size in zip(tape.input_names, tape.input_sizes, strict=True)
    ]
    outputs = [
        replace(known[output], size=list(shape))
        for output, shape in zip(tape.output_names, tape.output_shapes, strict=True)
    ]
    more = WITH_REDUNDANT_ROWS if redundant and "lam_R" in tape.input_names else ""
    return replace(
        spec, name=name, meaning=spec.meaning + more, inputs=inputs, outputs=outputs, operations=tape.operations
    )


def block_signals(groups: Sequence[Group]) -> list[Signal]:
    """Blocks of M_hat row by row, then those of Q_hat, by the names of the groups; long names get an underscore."""
    between = "" if all(len(group.name) == 1 for group in groups) else "_"
    found = [
        Signal(
            f"M_hat_{row.name}{between}{column.name}",
            f"n_{row.name} x n_{column.name}",
            "SI",
            f"block of M_hat, rows of {row.name}, columns of {column.name}",
        )
        for row in groups
        for column in groups
    ]
    return found + [
        Signal(f"Q_hat_{group.name}", f"n_{group.name}", "N, N m", f"part of Q_hat of {group.name}") for group in groups
    ]


def table() -> str:
    """The functions as a Markdown table (the page on generated code holds it; a test compares)."""
    lines = ["| function | stage | takes (what it uses of) | gives | Eq. |", "|---|---|---|---|---|"]
    for spec in FUNCTIONS.values():
        name = "`substep_2`, ..." if spec.name == "substep" else f"`{spec.name}`"
        gives = ", ".join(f"{signal.name} ({signal.shape})" for signal in spec.outputs)
        takes = ", ".join(signal.name for signal in spec.inputs)
        equation = f"({spec.equation})" if spec.equation else ""
        lines.append(f"| {name} | {spec.stage} | {takes} | {gives}: {spec.meaning} | {equation} |")
    return "\n".join(lines)
