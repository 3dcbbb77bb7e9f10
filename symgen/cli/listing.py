"""`symgen list`: the built-in scenes."""

from __future__ import annotations

import argparse
import inspect
from typing import Any

from symgen.cli.arguments import add_command
from symgen.cli.outcome import Outcome


def add(subparsers: Any) -> None:
    """Declare the subcommand."""
    add_command(subparsers, "list", run, "List the built-in scenes.")


def run(arguments: argparse.Namespace) -> Outcome:
    """Name and first docstring line of each."""
    from symgen.cli.sources import builtin_scenes

    entries = [
        {"name": name, "description": (inspect.getdoc(make) or "").partition("\n")[0]}
        for name, make in builtin_scenes().items()
    ]
    width = max((len(entry["name"]) for entry in entries), default=0)
    return Outcome({"scenes": entries}, [f"{entry['name']:<{width}}  {entry['description']}" for entry in entries])
