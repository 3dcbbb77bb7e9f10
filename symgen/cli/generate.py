"""`symgen generate`: derive scenes and write their code, or check that the code there is current."""

from __future__ import annotations

import argparse
import re
import shlex
from pathlib import Path
from typing import TYPE_CHECKING, Any

from symgen.cli.arguments import UsageError, add_command, add_scene
from symgen.cli.outcome import FAILED, OK, Outcome
from symgen.cli.progress import Progress

if TYPE_CHECKING:
    from symgen.cli.sources import Source


def add(subparsers: Any) -> None:
    """Declare the subcommand."""
    command = add_command(
        subparsers,
        "generate",
        run,
        "Derive a scene and write its code.",
        "Built-in scenes go to generated/SCENE of the checkout, others to ./SCENE, unless --out says otherwise.",
    )
    add_scene(command, nargs="?")
    command.add_argument("--all", action="store_true", help="every built-in scene (with --out: DIR/SCENE)")
    command.add_argument("--out", metavar="DIR", help="folder to write to")
    command.add_argument(
        "--check",
        action="store_true",
        help="write nothing; exit 1 with a unified diff if the code there is not current",
    )
    command.add_argument(
        "--complete",
        action="store_true",
        help="all functions of a long tree too, also those that grow with the square of its length",
    )
    command.add_argument("--functions", metavar="A,B", help="only these functions (large models can go without some)")


def run(arguments: argparse.Namespace) -> Outcome:
    """Write or compare each scene."""
    functions = _functions(arguments.functions)
    sources = _sources(arguments)
    with Progress("symgen") as progress:
        results = []
        for source in sources:
            progress.note(f"{source.scene.name} ...")
            results.append((_check if arguments.check else _write)(source, functions, arguments.complete))
    if not arguments.check:
        return Outcome({"generated": results}, [f"{entry['scene']} -> {entry['folder']}" for entry in results])
    stale = [entry for entry in results if entry["diff"]]
    command = _mending(arguments)
    lines = [entry["diff"].rstrip("\n") for entry in stale]
    if stale:
        lines += ["", f"{len(stale)} of {len(results)} not current; mend with: {command}"]
    else:
        lines = [f"{len(results)} of {len(results)} current"]
    return Outcome({"checked": results, **({"mend": command} if stale else {})}, lines, FAILED if stale else OK)


def _sources(arguments: argparse.Namespace) -> list[Source]:
    from symgen.cli.sources import Source, builtin_scenes, find_source

    if arguments.all == bool(arguments.scene) or (arguments.all and arguments.made_with):
        raise UsageError("give either one SCENE or --all (and --with only for one SCENE)")
    if not arguments.all:
        source = find_source(arguments.scene, arguments.made_with)
        return [Source(source.scene, Path(arguments.out)) if arguments.out else source]
    sources = [find_source(name) for name in builtin_scenes()]
    return [
        Source(source.scene, Path(arguments.out) / source.scene.name) if arguments.out else source for source in sources
    ]


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


def _write(source: Source, functions: frozenset[str] | None, complete: bool) -> dict[str, str]:
    from symgen.generate import generate

    folder = generate(source.scene, source.folder, functions, source.builtin, complete)
    return {"scene": source.scene.name, "folder": str(folder)}


def _check(source: Source, functions: frozenset[str] | None, complete: bool) -> dict[str, str]:
    from symgen.generate import check

    diff = check(source.scene, source.folder, functions, source.builtin, complete)
    return {"scene": source.scene.name, "folder": str(source.folder), "diff": diff}


def _mending(arguments: argparse.Namespace) -> str:
    words = ["symgen", "generate", arguments.scene or "--all"]
    words += [f"--with={name}={value:g}" for name, value in arguments.made_with]
    words += ["--complete"] if arguments.complete else []
    for option, value in (("--out", arguments.out), ("--functions", arguments.functions)):
        words += [option, value] if value else []
    return shlex.join(words)
