"""`symgen new`, `list`, `show`, `generate`: scenes, and the code that is derived from them."""

from __future__ import annotations

import argparse
import re
import shlex
from pathlib import Path
from typing import TYPE_CHECKING, Any

from symgen.cli.outcome import FAILED, Outcome, Progress
from symgen.cli.sources import Source, find_source
from symgen.cli.words import UsageError

if TYPE_CHECKING:
    from symgen.mechanism.scene import SceneRecord
    from symgen.pipeline import Derived

TEMPLATE = Path(__file__).with_name("template.toml")  # a small working mechanism, the other choices as comments


def new(arguments: argparse.Namespace) -> Outcome:
    """Write a commented scene file to start from."""
    from runtime.contract.files import write_text
    from symgen.mechanism.scene import SceneRecord
    from symgen.scene import SceneError

    name = arguments.name.replace("-", "_")
    path = Path(arguments.out) if arguments.out else Path(f"{name}.toml")
    text = TEMPLATE.read_text(encoding="utf-8").replace("@NAME@", name).replace("@FILE@", str(path))
    SceneRecord.from_toml_text(text)  # refuses a name that is not one
    if path.suffix != ".toml":
        raise SceneError(f"file '{path}'", "does not end in .toml", f"use --out {path}.toml")
    if path.exists() and not arguments.force:
        raise SceneError(f"file '{path}'", "already exists", "choose another --out, or replace it with --force")
    write_text(path, text)
    return Outcome(
        {"scene": name, "file": str(path)},
        [f"Wrote {path}. Next: symgen show {path}, then symgen simulate {path} --out results"],
    )


def listing(arguments: argparse.Namespace) -> Outcome:
    """List the built-in scenes."""
    from symgen.scenes import SCENES, summary

    entries = [{"name": name, "description": summary(name)} for name in SCENES]
    width = max(map(len, SCENES))
    return Outcome({"scenes": entries}, [f"{entry['name']:<{width}}  {entry['description']}" for entry in entries])


def show(arguments: argparse.Namespace) -> Outcome:
    """Show what a scene contains: bodies, joints, coordinates, groups."""
    scene = find_source(arguments.scene, arguments.made_with).scene
    if arguments.toml:
        return Outcome({"scene": scene.name, "toml": scene.to_toml()}, [scene.to_toml().rstrip()])
    from symgen.pipeline import derive

    data = {**_contents(scene), **_derived(derive(scene, frozenset()))}
    return Outcome(data, _shown(data))


def _contents(scene: SceneRecord) -> dict[str, Any]:
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


def _shown(data: dict[str, Any]) -> list[str]:
    joints = [f"{name} ({joint['type']}): {' - '.join(joint['between'])}" for name, joint in data["joints"].items()]
    parameters = [
        f"{name} = {entry['default']:g} {entry['unit']}  {entry['description']}".rstrip()
        for name, entry in data["parameters"].items()
    ]
    changes = [
        f"{name}: {change['given']:.9g} -> {change['used']:.9g}" for name, change in data["initial_changes"].items()
    ]
    count = f"{len(data['coordinates'])} coordinates, {len(data['independent'])} independent"
    blocks = {
        "Bodies": [f"{name} ({kind})" for name, kind in data["bodies"].items()],
        "Joints": joints,
        "Loads": [f"{name} ({kind})" for name, kind in data["loads"].items()],
        "Measures": [f"{name} ({kind})" for name, kind in data["measures"].items()],
        "Parameters": parameters,
        f"Degrees of freedom ({count}), groups slow to fast": [
            f"{name}: {', '.join(members)}" for name, members in data["groups"].items()
        ],
        "Solved by Newton (loop closure)": data["loop_unknowns"],
        "Redundant constraints, implied by the others": data["redundant"],
        "Beams whose shapes do not carry what is attached to them": data["shapes_missing"],
        "Initial values that had to change": changes,
    }
    lines = [f"{data['scene']}: {data['title']}" if data["title"] else data["scene"]]
    lines += [data["description"]] if data["description"] else []
    for title, entries in blocks.items():
        lines += ["", f"{title}:", *(f"  {entry}" for entry in entries)] if entries else []
    settings = ", ".join(f"{key} = {value}" for key, value in data["simulation"].items())
    return [*lines, "", f"Simulation: {settings}"]


def generate(arguments: argparse.Namespace) -> Outcome:
    """Derive a scene and write its code.

    Built-in scenes go to generated/SCENE of the checkout, others to ./SCENE, unless --out says otherwise.
    """
    from symgen.generate import check, generate

    functions, results = _functions(arguments.functions), []
    with Progress("symgen") as progress:
        for source in _sources(arguments):
            progress.note(f"{source.scene.name} ...")
            what = (source.scene, source.folder, functions, arguments.complete)
            done = {"diff": check(*what)} if arguments.check else {}
            folder = source.folder if arguments.check else generate(*what)
            results.append({"scene": source.scene.name, "folder": str(folder), **done})
    if not arguments.check:
        return Outcome({"generated": results}, [f"{entry['scene']} -> {entry['folder']}" for entry in results])
    stale = [entry["diff"].rstrip("\n") for entry in results if entry["diff"]]
    if not stale:
        return Outcome({"checked": results}, [f"{len(results)} of {len(results)} current"])
    mend = _mending(arguments)
    lines = [*stale, "", f"{len(stale)} of {len(results)} not current; mend with: {mend}"]
    return Outcome({"checked": results, "mend": mend}, lines, FAILED)


def _sources(arguments: argparse.Namespace) -> list[Source]:
    from symgen.scenes import SCENES

    if arguments.all == bool(arguments.scene) or (arguments.all and arguments.made_with):
        raise UsageError("give either one SCENE or --all (and --with only for one SCENE)")
    if not arguments.all:
        source = find_source(arguments.scene, arguments.made_with)
        return [Source(source.scene, Path(arguments.out)) if arguments.out else source]
    sources = [find_source(name) for name in SCENES]
    if not arguments.out:
        return sources
    return [Source(source.scene, Path(arguments.out) / source.scene.name) for source in sources]


def _functions(text: str | None) -> frozenset[str] | None:
    """The names given. Raises UsageError for one that no scene has."""
    if text is None:
        return None
    from symgen.kernels.specification import FUNCTIONS

    names = frozenset(part.strip() for part in text.split(",") if part.strip())
    unknown = sorted(name for name in names if name not in FUNCTIONS and not re.fullmatch(r"substep_\d+", name))
    if unknown or not names:
        raise UsageError(
            f"--functions: {', '.join(unknown) or 'nothing'} is not a function; "
            f"known: {', '.join(name for name in FUNCTIONS if name != 'substep')}, substep_2, ..."
        )
    return names


def _mending(arguments: argparse.Namespace) -> str:
    words = ["symgen", "generate", arguments.scene or "--all"]
    words += [f"--with={name}={value:g}" for name, value in arguments.made_with.items()]
    words += ["--complete"] if arguments.complete else []
    for option, value in (("--out", arguments.out), ("--functions", arguments.functions)):
        words += [option, value] if value else []
    return shlex.join(words)
