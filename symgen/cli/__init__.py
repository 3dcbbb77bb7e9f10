"""The command line: `symgen COMMAND ...`. The only part that knows both the generator and the runtime.

Exit codes: 0 done; 1 the numbers failed (a run that did not reach its end, or `generate --check` that found stale
code); 2 wrong input; 3 a fault of symgen itself; 130 interrupted. With --json, standard output is exactly one JSON
object.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence

from runtime.contract.errors import NoResult, SymgenError
from symgen.cli.commands import parser
from symgen.cli.outcome import (
    FAILED,
    FAULT,
    INTERRUPTED,
    OK,
    WRONG_INPUT,
    detailed,
    report,
    report_error,
    report_fault,
)
from symgen.cli.progress import Progress


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one command and return its exit code.

    Errors of the project's family are messages, never a traceback; any other exception is a fault of symgen, which is
    shown where it broke.
    """
    given = list(sys.argv[1:] if arguments is None else arguments)
    as_json = "--json" in given
    command = next((word for word in given if not word.startswith("-")), "")
    try:
        parsed = parser().parse_args(given)
        Progress.silenced = parsed.quiet
        outcome = parsed.run(parsed)
        if as_json or not parsed.quiet:
            report(detailed(outcome) if parsed.verbose else outcome, command, as_json)
        return int(outcome.code)
    except KeyboardInterrupt:
        report_error(command, "interrupted", as_json, INTERRUPTED)
        return INTERRUPTED
    except BrokenPipeError:  # the reader of the output went away (| head): not an error
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return OK
    except NoResult as error:
        report_error(command, error, as_json, FAILED)
        return FAILED
    except SymgenError as error:
        report_error(command, error, as_json, WRONG_INPUT)
        return WRONG_INPUT
    except Exception as error:
        report_fault(command, error, as_json)
        return FAULT
