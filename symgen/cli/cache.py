"""`symgen cache`: what is kept of compiled programs."""

from __future__ import annotations

import argparse
from typing import Any

from symgen.cli.arguments import add_command
from symgen.cli.outcome import Outcome


def add(subparsers: Any) -> None:
    """Declare the subcommand."""
    command = add_command(
        subparsers,
        "cache",
        run,
        "Show what is kept of compiled programs, or remove it.",
        "Nothing is lost by removing it: a program is compiled again when it is needed.",
    )
    command.add_argument("--clear", action="store_true", help="remove all of it")


def run(arguments: argparse.Namespace) -> Outcome:
    """Folder, number and size; with --clear, how many were removed."""
    from runtime.engine.object_cache import MOST_BYTES, ObjectCache

    cache = ObjectCache()
    refused = cache.refused()
    entries = cache.entries()
    size = sum(size for _, size, _ in entries)
    facts: dict[str, Any] = {"folder": str(cache.folder), "programs": len(entries), "bytes": size, "most": MOST_BYTES}
    lines = [f"{cache.folder}: {len(entries)} compiled programs, {size / 1e6:.3g} of {MOST_BYTES / 1e6:.0f} MB"]
    if refused:
        facts["refused"] = refused
        lines.append(f"not used: {refused}")
    elif arguments.clear:
        facts["removed"] = cache.clear()
        lines.append(f"{facts['removed']} removed")
    return Outcome(facts, lines)
