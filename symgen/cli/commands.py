"""The whole command line. Nothing heavy is imported here: `symgen --help` answers at once."""

from __future__ import annotations

import argparse
from importlib.metadata import PackageNotFoundError, version

from symgen.cli import (
    advise,
    animate,
    cache,
    campbell,
    compare,
    completion,
    demo,
    equilibrium,
    generate,
    listing,
    modes,
    new,
    plot,
    reporting,
    response,
    resume,
    show,
    simulate,
    stability,
    sweep,
    view,
)
from symgen.cli.arguments import Parser

COMMANDS = (
    new,
    listing,
    show,
    generate,
    simulate,
    resume,
    sweep,
    view,
    plot,
    compare,
    animate,
    equilibrium,
    modes,
    campbell,
    response,
    stability,
    advise,
    reporting,
    demo,
    completion,
    cache,
)


def parser() -> argparse.ArgumentParser:
    """The whole command line; each subcommand's module adds itself."""
    root = Parser(
        prog="symgen",
        description="Symbolic code generation and multirate time stepping for flexible multibody dynamics.",
        epilog="Exit codes: 0 done, 1 numerical failure or stale generated code, 2 wrong input, 3 a fault of symgen "
        "itself, 130 interrupted.",
    )
    root.add_argument("--version", action="version", version=f"symgen {_version()}")
    subparsers = root.add_subparsers(dest="command", required=True, metavar="COMMAND")
    for module in COMMANDS:
        module.add(subparsers)
    root.set_defaults(root=root)
    return root


def _version() -> str:
    try:
        return version("symgen")
    except PackageNotFoundError:
        return "(not installed)"
