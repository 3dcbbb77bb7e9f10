"""All files of a model; model.md: what was modelled, for a person to read."""

from __future__ import annotations

import re

from runtime.contract.escapes import markdown, markdown_lines
from runtime.contract.records import Parameter
from symgen.emission.description import data_text, manifest_text
from symgen.emission.model_text import model_text
from symgen.pipeline import Derived
from symgen.scene import BeamBody, Joint, ModalBody, RigidBody, SpatialModalBody


def emit(derived: Derived) -> dict[str, str]:
    """All files of the model by name."""
    files = {
        "model.py": model_text(derived),
        "data.json": data_text(derived),
        "model.md": model_page(derived),
        "scene.toml": derived.scene.to_toml(),
    }
    return {**files, "manifest.json": manifest_text(derived, files)}


def model_page(derived: Derived) -> str:
    """Markdown page of a derived model."""
    scene = derived.scene
    parts = [
        f"# {markdown(scene.title or scene.name)}",
        markdown_lines(scene.description),
        _coordinates(derived),
        _bodies(derived),
        _joints(derived),
        _redundant(derived),
        _loads(derived),
        _left_out(derived),
        _functions(derived),
        _parameters(derived),
    ]
    return "\n\n".join(part for part in parts if part) + "\n"


def _coordinates(derived: Derived) -> str:
    eq, choice = derived.system.equations, derived.system.choice
    group_of = {k: group.name for group in derived.groups for k in group.positions}
    independent = {column: group_of[k] for k, column in enumerate(choice.independent)}
    loops = set(choice.loop_columns)

    def role(column: int) -> str:
        if column in independent:
            return f"independent, group {independent[column]}"
        return "dependent, loop unknown (Newton)" if column in loops else "dependent, closed form"

    lines = ["## Coordinates", "", "| coordinate | role |", "|---|---|"]
    lines += [f"| `{name}` | {role(column)} |" for column, name in enumerate(eq.names)]
    for rotation in derived.system.reduced.rotation_vectors:
        roles = [role(column) for column in rotation.columns]
        if len(set(roles)) == 1:
            velocities = f"their velocities are `{rotation.body}.omega_x`, ..."
            lines.append(f"| `{rotation.body}.turn_x`, `_y`, `_z` | {roles[0]}; {velocities} |")
            continue
        for axis, own in zip("xyz", roles, strict=True):
            lines.append(f"| `{rotation.body}.turn_{axis}` | {own}; its velocity is `{rotation.body}.omega_{axis}` |")
    return "\n".join(lines)


def _bodies(derived: Derived) -> str:
    bodies = [body for body in derived.scene.bodies if body.type != "ground"]
    if not bodies:
        n = len(derived.system.equations.names)
        return f"## Structure\n\nM x'' + D x' + K x = F(t) with {n} coordinates (Eqs. 3-14)."
    lines = [
        "## Bodies",
        "",
        "Every body: mass blocks and Q_v of Eq. (20) in the floating frame (R_o, theta, q_f).",
        "",
        "| body | kind | what it has |",
        "|---|---|---|",
    ]
    for body in bodies:
        if isinstance(body, RigidBody):
            mass, inertia = _quantity(body.mass), _quantity(body.inertia)
            lines.append(f"| {body.name} | rigid | mass {mass}, inertia {inertia} about the centre of mass |")
        elif isinstance(body, BeamBody):
            sets = [
                f"{kind.replace('_', ' ')} modes {mode.ends} x {mode.modes}"
                for kind in ("lateral", "lateral_z", "axial", "torsion")
                if (mode := getattr(body, kind))
            ]
            extra = "with geometric stiffening" if body.stiffening else "without geometric stiffening"
            lines.append(f"| {body.name} | beam, exact shapes | {', '.join(sets)}; {extra} |")
        elif isinstance(body, ModalBody | SpatialModalBody):
            lines.append(f"| {body.name} | given modal matrices | {len(body.M_ff)} modes |")
    return "\n".join(lines)


def _quantity(value: object) -> str:
    """A number or a list of them; with expressions in it as code, since their signs mean something to Markdown."""
    return str(value) if re.fullmatch(r"[-+0-9.e(), ]*", str(value)) else f"`{value}`"


def _joints(derived: Derived) -> str:
    if not derived.scene.joints:
        return ""
    lines = ["## Joints", "", "| joint | type | between | equations |", "|---|---|---|---|"]
    for joint in derived.scene.joints:
        motion = getattr(joint, "motion", None)
        equations = _joint_equations(derived, joint) + (f", f(t) = `{motion}`" if motion else "")
        lines.append(f"| {joint.name} | {joint.type} | {joint.marker_a} - {joint.marker_b} | {equations} |")
    for coupling in derived.scene.couplings:
        lines.append(f"| {coupling.name} | {coupling.type} | {', '.join(coupling.named)} | constant ratio |")
    return "\n".join(lines)


def _joint_equations(derived: Derived, joint: Joint) -> str:
    """What the joint's rows say; a joint that places a body says which and by what."""
    placement = derived.topology.placements.get(joint.name)
    if placement is not None:
        own = ", ".join(f"`{name}`" for name in placement.coordinates)
        return f"places {placement.child}" + (f" by {own}" if own else "")
    if derived.scene.space == "planar":
        return joint.equation
    rows = [row.text for row in derived.system.equations.constraints if row.joint == joint.name]
    return ", ".join(rows) + " = 0"


def _redundant(derived: Derived) -> str:
    """Rows that the others imply."""
    if not derived.redundant:
        return ""
    rows = derived.system.equations.constraints
    lines = [
        "## Redundant constraints",
        "",
        "The other rows imply these at every position. They are checked, but nothing is solved from them; "
        "reactions are those of least norm.",
        "",
    ]
    return "\n".join([*lines, *(f"- `{rows[row].label}` (joint {rows[row].joint})" for row in derived.redundant)])


def _loads(derived: Derived) -> str:
    if not derived.scene.loads:
        return ""
    lines = ["## Loads", ""]
    lines += [f"- {load.name}: {load.type.replace('_', ' ')}" for load in derived.scene.loads]
    return "\n".join(lines)


def _left_out(derived: Derived) -> str:
    """What the scene does not need and the code therefore does not contain."""
    scene, eq = derived.scene, derived.system.equations
    items = []
    if scene.structure is None:
        if scene.space == "planar":
            items.append("the third dimension: the scene is planar")
        if all(component == 0 for component in scene.gravity):
            items.append("gravity: its components are zero")
    if eq.dissipated.is_zero():
        items.append("damping: no body, joint or spring has any")
    if not derived.system.choice.loop_rows:
        items.append("Newton iterations: every dependent coordinate has a closed form")
    if all(constraint.C_t.is_zero() for constraint in eq.constraints):
        items.append("time in the constraints: no motion is prescribed")
    rigid = [body.name for body in scene.bodies if body.type == "rigid"]
    if rigid:
        items.append(f"shape integrals of rigid bodies: {', '.join(rigid)}")
    stiff = [body.name for body in scene.bodies if isinstance(body, BeamBody) and not body.stiffening]
    if stiff:
        items.append(f"geometric stiffening, not asked for: {', '.join(stiff)}")
    return "## Left out because the scene does not need it\n\n" + "\n".join(f"- {item}" for item in items)


def _functions(derived: Derived) -> str:
    lines = ["## Functions", "", "| function | operations | what it gives | Eq. |", "|---|---|---|---|"]
    for spec in derived.functions.values():
        equation = f"({spec.equation})" if spec.equation else ""
        lines.append(f"| `{spec.name}` | {spec.operations} | {spec.meaning} | {equation} |")
    if derived.left_out:
        lines += [
            "",
            f"Not in this folder: {', '.join(f'`{name}`' for name in derived.left_out)}. They are derived from "
            "scene.toml when a run or a picture asks for them, which needs symgen beside the runtime; "
            "`symgen generate --complete` with this folder writes them all.",
        ]
    return "\n".join(lines)


def _parameters(derived: Derived) -> str:
    shown = [entry for entry in derived.parameters if entry.kind != "data"]
    if not shown:
        return ""
    lines = ["## Parameters (run-time inputs)", "", "| name | unit | meaning | must be |", "|---|---|---|---|"]
    arrays: dict[str, list[Parameter]] = {}
    for entry in shown:
        arrays.setdefault(entry.array or entry.name, []).append(entry)
    for name, entries in arrays.items():
        first = entries[0]
        many = f", {len(entries)} entries `{first.name}` ..." if first.array else ""
        bound = "" if first.bound == "any" else first.bound
        lines.append(f"| `{name}` | {markdown(first.unit)} | {markdown(first.meaning)}{many} | {bound} |")
    return "\n".join(lines)
