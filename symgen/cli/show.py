"""`symgen show`: what a scene contains and what becomes of it."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING, Any

from symgen.cli.arguments import add_command, add_scene
from symgen.cli.outcome import Outcome

if TYPE_CHECKING:
    from symgen.pipeline import Derived
    from symgen.scene import Scene


def add(subparsers: Any) -> None:
    """Declare the subcommand."""
    command = add_command(subparsers, "show", run, "Show what a scene contains: bodies, joints, coordinates, groups.")
    add_scene(command)
    command.add_argument("--toml", action="store_true", help="write the scene as TOML instead")


def run(arguments: argparse.Namespace) -> Outcome:
    """Describe the scene; it is derived (not emitted) to find its degrees of freedom."""
    from symgen.cli.sources import find_source

    scene = find_source(arguments.scene, arguments.made_with).scene
    if arguments.toml:
        return Outcome({"scene": scene.name, "toml": scene.to_toml()}, [scene.to_toml().rstrip()])
    from symgen.pipeline import derive

    data = {**_contents(scene), **_derived(derive(scene, frozenset()))}
    return Outcome(data, _lines(data))


def _contents(scene: Scene) -> dict[str, Any]:
    return {
        "scene": scene.name,
        "title": scene.title,
        "description": scene.description,
        "bodies": {body.name: body.type for body in scene.bodies},
        "joints": {
            joint.name: {"type": joint.type, "between": [joint.marker_a, joint.marker_b]} for joint in scene.joints
        },
        "loads": {load.name: load.type for load in scene.loads},
        "measures": {measure.name: measure.type for measure in scene.measures},
        "parameters": {
            name: {"default": entry.default, "unit": entry.unit, "description": entry.description}
            for name, entry in scene.parameters.items()
        },
        "simulation": scene.simulation.model_dump(mode="json", exclude_none=True),
    }


def _derived(derived: Derived) -> dict[str, Any]:
    names, choice = derived.system.equations.names, derived.system.choice
    independent = [derived.system.reduced.names[column] for column in choice.independent]
    return {
        "coordinates": names,
        "independent": independent,
        "loop_unknowns": [names[column] for column in choice.loop_columns],
        "redundant": [derived.system.equations.constraints[row].label for row in derived.redundant],
        "groups": {group.name: [independent[k] for k in group.positions] for group in derived.groups},
        "shapes_missing": [str(one) for one in derived.system.equations.static_residuals],
        "initial_changes": {
            name: {"given": given, "used": used} for name, (given, used) in derived.initial.changed.items()
        },
    }


def _lines(data: dict[str, Any]) -> list[str]:
    lines = [f"{data['scene']}: {data['title']}" if data["title"] else data["scene"]]
    if data["description"]:
        lines.append(data["description"])
    lines += _block("Bodies", [f"{name} ({kind})" for name, kind in data["bodies"].items()])
    lines += _block(
        "Joints",
        [f"{name} ({joint['type']}): {' - '.join(joint['between'])}" for name, joint in data["joints"].items()],
    )
    lines += _block("Loads", [f"{name} ({kind})" for name, kind in data["loads"].items()])
    lines += _block("Measures", [f"{name} ({kind})" for name, kind in data["measures"].items()])
    lines += _block(
        "Parameters",
        [
            f"{name} = {entry['default']:g} {entry['unit']}  {entry['description']}".rstrip()
            for name, entry in data["parameters"].items()
        ],
    )
    count = f"{len(data['coordinates'])} coordinates, {len(data['independent'])} independent"
    groups = [f"{name}: {', '.join(members)}" for name, members in data["groups"].items()]
    lines += _block(f"Degrees of freedom ({count}), groups slow to fast", groups)
    lines += _block("Solved by Newton (loop closure)", data["loop_unknowns"])
    lines += _block("Redundant constraints, implied by the others", data["redundant"])
    lines += _block("Beams whose shapes do not carry what is attached to them", data["shapes_missing"])
    lines += _block(
        "Initial values that had to change",
        [f"{name}: {change['given']:.9g} -> {change['used']:.9g}" for name, change in data["initial_changes"].items()],
    )
    settings = ", ".join(f"{key} = {value}" for key, value in data["simulation"].items())
    return [*lines, "", f"Simulation: {settings}"]


def _block(title: str, entries: list[str]) -> list[str]:
    return ["", f"{title}:", *(f"  {entry}" for entry in entries)] if entries else []
