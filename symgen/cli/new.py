"""`symgen new`: a commented scene file to start from."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any

from symgen.cli.arguments import add_command
from symgen.cli.outcome import Outcome


def add(subparsers: Any) -> None:
    """Declare the subcommand."""
    command = add_command(subparsers, "new", run, "Write a commented scene file to start from.")
    command.add_argument("name", metavar="NAME", help="name of the scene")
    command.add_argument("--out", metavar="FILE", help="the file to write (default: NAME.toml)")
    command.add_argument("--force", action="store_true", help="replace a file that is already there")


def run(arguments: argparse.Namespace) -> Outcome:
    """Write the file, unless there is one."""
    from runtime.contract.files import write_text
    from symgen.cli.template import scene_text
    from symgen.scene import Scene, SceneError

    name = arguments.name.replace("-", "_")
    path = Path(arguments.out) if arguments.out else Path(f"{name}.toml")
    text = scene_text(name, str(path))
    Scene.from_toml_text(text)  # refuses a name that is not one
    if path.suffix != ".toml":
        raise SceneError(f"file '{path}'", "does not end in .toml", f"use --out {path}.toml")
    if path.exists() and not arguments.force:
        raise SceneError(f"file '{path}'", "is there already", "choose another --out, or replace it with --force")
    write_text(path, text)
    return Outcome(
        {"scene": name, "file": str(path)},
        [f"Wrote {path}. Next: symgen show {path}, then symgen simulate {path} --out results"],
    )
