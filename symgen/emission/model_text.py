"""model.py: every kernel as a function that builds its CasADi Function. Imports casadi only."""

from __future__ import annotations

import keyword
import re
from collections.abc import Mapping

from runtime.contract.tape import Tape
from symgen.emission.expression_text import TapeText
from symgen.pipeline import Derived

MEANING = {
    "constants": "c: everything that depends on the parameters p only",
    "condensed": "M_hat and Q_hat (Eq. 38)",
    "blocks": "Blocks of M_hat and Q_hat by the groups of the partition (Eq. 39)",
    "forward_dynamics": "q_i_ddot of a tree by topology-ordered elimination, without M_hat",
    "closure": "One Newton step on the loop unknowns, then q_d (Eq. 31); C_loop before it, det_loop of its blocks",
    "velocities": "q_d_dot (Eq. 36)",
    "accelerations": "q_d_ddot (Eq. 35)",
    "constraints": "C, C_q, C_t, nu and gamma in all coordinates (Eqs. 21-27)",
    "augmented": "M, K, Q_v, Q_F, Q* = Q_F + Q_v - K q, C_q and gamma (with Baumgarte terms) of Eq. (28)",
    "reactions": "Multipliers lam (Eq. 37); world force and moment of each joint on its body b, at marker b",
    "energy": "Energies in J and powers in W",
    "measures": "The scene's measures and their rates",
    "poses": "Origin and rotation matrix of each body, for pictures",
    "geometry": "Points of the bodies as functions of the parameters, for pictures",
    "dQ_hat_dq_i": "Total derivative of Q_hat by q_i, through q_d = f(q_i, t)",
    "dQ_hat_dq_i_dot": "Total derivative of Q_hat by q_i_dot, through q_d_dot",
    "dMa_dq_i": "Total derivative of M_hat q_i_ddot by q_i at fixed q_i_ddot",
}


def meaning(name: str, redundant: bool = False) -> str:
    """One line on what an emitted function computes; redundant: does the model have redundant rows?"""
    if name.startswith("substep_"):
        return "Sub-step: M_hat of the active groups and their right-hand side with slower accelerations given (Eq. 64)"
    return MEANING[name] + (WITH_REDUNDANT_ROWS if redundant and name == "reactions" else "")


WITH_REDUNDANT_ROWS = "; lam_R: multipliers of the redundant rows, which the others go with"
RESERVED = re.compile(
    r"^(w\d+|c\d*|p\d*|t|ca|lam_R\d*|q\w*|M\w*|C\w*|Q\w*|inputs|outputs|poses|positions|axes|shapes|turns|H|sections)$"
)


def local_names(names: list[str]) -> list[str]:
    """Distinct Python identifiers for coordinate names, clear of the names the emitted functions use."""
    chosen: list[str] = []
    for name in names:
        text = re.sub(r"\W+", "_", name).strip("_")
        if RESERVED.match(text) or keyword.iskeyword(text) or text[:1].isdigit():
            text = f"x_{text}"
        while text in chosen:
            text += "_"
        chosen.append(text)
    return chosen


def model_text(derived: Derived) -> tuple[str, dict[str, int]]:
    """(text of model.py, operations of each function)."""
    labels = _labels(derived)
    operations = {name: tape.operations for name, tape in derived.tapes.items()}
    parts = [_header(derived)]
    redundant = bool(derived.redundant)
    parts += [_function_text(name, tape, labels, meaning(name, redundant)) for name, tape in derived.tapes.items()]
    listing = "\n".join(f'    "{name}": {name},' for name in derived.tapes)
    parts.append(f"FUNCTIONS = {{\n{listing}\n}}\n")
    return "\n\n".join(parts), operations


def _header(derived: Derived) -> str:
    scene = derived.scene
    title = scene.title or scene.name
    return (
        f'"""{title}: equations of motion, emitted by symgen from the scene `{scene.name}`.\n\n'
        "Do not edit: change the scene and run `symgen generate`. model.md says what was modelled.\n"
        f'"""\n\nimport casadi as ca\n'
    )


def _labels(derived: Derived) -> dict[str, list[str]]:
    """Local names of the entries of every possible input."""
    eq, choice = derived.system.equations, derived.system.choice
    names = local_names(eq.names)
    q_i, q_d = [names[c] for c in choice.independent], [names[c] for c in derived.dependent]
    labels = {"q": names, "q_i": q_i, "q_d": q_d, "t": ["t"]}
    for source in ("q", "q_i", "q_d"):
        labels[f"{source}_dot"] = [f"{name}_dot" for name in labels[source]]
        labels[f"{source}_ddot"] = [f"{name}_ddot" for name in labels[source]]
    labels["lam_R"] = [f"lam_R{k}" for k in range(len(derived.redundant))]
    slow = [k for group in derived.groups[:-1] for k in group.positions]
    labels["q_L_ddot"] = [f"{q_i[k]}_ddot" for k in slow]
    labels["p"] = local_names([entry.name for entry in derived.parameters])
    labels["c"] = [f"c{k}" for k in range(len(derived.tapes["constants"].outputs[0]))]
    return labels


def _function_text(name: str, tape: Tape, labels: Mapping[str, list[str]], purpose: str) -> str:
    text = TapeText(tape, labels)
    lines = [f"def {name}() -> ca.Function:", f'    """{purpose}. {tape.operations} operations."""']
    for argument, size in zip(tape.input_names, tape.input_sizes, strict=True):
        lines.append(f'    {argument} = ca.SX.sym("{argument}", {size})')
    for argument in tape.input_names:
        lines += _unpack(argument, sorted(text.inputs_used[argument]), labels[argument])
    lines += [f"    {statement}" for statement in text.statements]
    for position, (output, shape) in enumerate(zip(tape.output_names, tape.output_shapes, strict=True)):
        lines += _output(output, shape, text.output(position))
    arguments = ", ".join(tape.input_names)
    quoted_in = ", ".join(f'"{argument}"' for argument in tape.input_names)
    quoted_out = ", ".join(f'"{output}"' for output in tape.output_names)
    lines.append(f"    inputs, outputs = [{arguments}], [{', '.join(tape.output_names)}]")
    lines.append(f'    return ca.Function("{name}", inputs, outputs, [{quoted_in}], [{quoted_out}])')
    return "\n".join(lines) + "\n"


def _unpack(argument: str, entries: list[int], labels: list[str]) -> list[str]:
    if argument == "t":
        return []
    return [f"    {labels[entry]} = {argument}[{entry}]" for entry in entries]


def _output(name: str, shape: tuple[int, int], entries: list[str]) -> list[str]:
    """The output as a dense column, reshaped column by column where it is a matrix."""
    lines = [f"    {name} = ca.vertcat("]
    lines += [f"        {entry}," for entry in entries]
    lines.append("    )")
    if shape[1] != 1:
        lines.append(f"    {name} = ca.reshape({name}, {shape[0]}, {shape[1]})")
    lines.append(f"    {name} = ca.densify({name})")
    return lines
