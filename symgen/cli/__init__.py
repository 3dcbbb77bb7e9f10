"""The command line: `symgen COMMAND ...`. The only part that knows both the generator and the runtime.

`table` says what commands and options there are, `words` how they are read, `outcome` how an answer is written and with
which exit code; the other modules hold the functions of the commands.
"""

from __future__ import annotations

import gc
import os
import sys
from collections.abc import Sequence
from io import TextIOWrapper

from symgen.cli.outcome import OK, Progress, detailed, exit_code_of, report, report_error
from symgen.cli.table import COMMANDS, parser


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one command and return its exit code.

    Errors of the project's family are messages, never a traceback; any other exception is a fault of symgen, which is
    shown where it broke. With --json, standard output is exactly one JSON object.
    """
    gc.set_threshold(100_000)  # imports make no garbage: searches for it take a tenth of a short run
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, TextIOWrapper):  # a console that lacks a sign of a title shows its escape
            stream.reconfigure(errors="backslashreplace")
    given = list(sys.argv[1:] if arguments is None else arguments)
    as_json = "--json" in given
    command = next((word for word in given if not word.startswith("-")), "")
    try:
        parsed = parser().parse_args(given)
        Progress.silenced = parsed.quiet
        outcome = COMMANDS[parsed.command][0](parsed)
        if as_json or not parsed.quiet:
            report(detailed(outcome) if parsed.verbose else outcome, command, as_json)
        return outcome.code
    except BrokenPipeError:  # the reader of the output went away (| head): not an error
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return OK
    except (Exception, KeyboardInterrupt) as error:
        code = exit_code_of(error)
        report_error(command, error, as_json, code)
        return code
