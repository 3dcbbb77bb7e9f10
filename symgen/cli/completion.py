"""`symgen completion`: a script that completes commands and options in bash or zsh."""

from __future__ import annotations

import argparse
from typing import Any

from symgen.cli.arguments import UsageError, add_command
from symgen.cli.outcome import Outcome

SHELLS = ("bash", "zsh")


def add(subparsers: Any) -> None:
    """Declare the subcommand."""
    command = add_command(
        subparsers,
        "completion",
        run,
        "Write a script that completes commands and options.",
        'For bash: eval "$(symgen completion bash)"; for zsh the same with zsh. Needs the extra `completion`.',
    )
    command.add_argument("shell", choices=SHELLS)


def run(arguments: argparse.Namespace) -> Outcome:
    """The script on standard output."""
    try:
        import shtab
    except ImportError as error:
        raise UsageError("shtab is not installed; install it with: pip install 'symgen[completion]'") from error
    script = shtab.complete(arguments.root, arguments.shell)
    return Outcome({"shell": arguments.shell, "script": script}, [script])
