"""What a command has to say, and how it is said: lines for a person, or one JSON object; its exit code."""

from __future__ import annotations

import json
import math
import sys
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any, TextIO

from runtime.contract.errors import NoResult, SymgenError, clipped, printable
from runtime.contract.meter import Meter

OK, FAILED, WRONG_INPUT, FAULT, INTERRUPTED = 0, 1, 2, 3, 130
EXIT_CODES = {
    OK: "done",
    FAILED: "numerical failure or stale generated code",
    WRONG_INPUT: "wrong input",
    FAULT: "a fault of symgen itself",
    INTERRUPTED: "interrupted",
}
CODES = ((KeyboardInterrupt, INTERRUPTED), (NoResult, FAILED), (SymgenError, WRONG_INPUT), (Exception, FAULT))
REPORT_IT = (
    "this is a fault of symgen, not of your input; please report it with the lines above, the command and the scene "
    "(docs/guide/errors.md says what helps)"
)


@dataclass(frozen=True)
class Outcome:
    """data for --json; lines for a person; exit code."""

    data: Mapping[str, Any]
    lines: list[str] = field(default_factory=list)
    code: int = OK


class Progress(Meter):
    """The progress line of a command, silent with --quiet."""

    silenced = False

    def __init__(self, label: str, stream: TextIO | None = None, counted: str = "") -> None:
        super().__init__(label, stream, counted)
        self._active = self._active and not Progress.silenced


def exit_code_of(error: BaseException) -> int:
    """The exit code of a command that ended in this exception."""
    return next(code for kind, code in CODES if isinstance(error, kind))


def left(files: Mapping[str, str] | Iterable[str]) -> list[str]:
    """A line for each file that a command left."""
    return [f"left {path}" for path in (files.values() if isinstance(files, Mapping) else files)]


def detailed(outcome: Outcome) -> Outcome:
    """The outcome with the statistics of its run as further lines."""
    found = outcome.data.get("report", {}).get("statistics", {})
    lines = [f"  {name.replace('_', ' ')}: {value}" for name, value in found.items()]
    return replace(outcome, lines=[*outcome.lines, *lines])


def report(outcome: Outcome, command: str, as_json: bool) -> None:
    """Write the outcome to standard output."""
    if as_json:
        _write_json({"command": command, "exit_code": outcome.code, **outcome.data})
    elif outcome.lines:
        print(printable("\n".join(outcome.lines)))
    sys.stdout.flush()


def report_error(command: str, error: BaseException, as_json: bool, code: int) -> None:
    """Write an error: to standard error for a person, as the JSON object on standard output otherwise.

    One that nobody expected is shown where it broke, with how to report it.
    """
    kind, message = type(error).__name__, str(error)
    if code == INTERRUPTED:
        kind = message = "interrupted"
    details: dict[str, Any] = {"kind": kind, "message": clipped(message)}
    further = [clipped(str(entry)) for entry in getattr(error, "also", ())]
    if code == FAULT:
        import traceback

        traceback.print_exception(error)
        details |= {"traceback": "".join(traceback.format_exception(error)), "remedy": REPORT_IT}
        print(f"symgen: {REPORT_IT}", file=sys.stderr)
    else:
        if isinstance(error, SymgenError) and error.problem:
            parts = {"item": error.item, "problem": error.problem, "remedy": error.remedy}
            details |= {key: clipped(text) for key, text in parts.items()}
        details["also"] = further
        for text in () if as_json else (details["message"], *further):
            print(f"symgen: {text}", file=sys.stderr)
    if as_json:
        _write_json({"command": command, "exit_code": code, "error": details})


def _write_json(data: Mapping[str, Any]) -> None:
    print(json.dumps(_strict(data), indent=2, ensure_ascii=False, allow_nan=False))


def _strict(value: Any) -> Any:
    """null for NaN and infinity, text for paths."""
    if isinstance(value, float):
        return value if math.isfinite(value) else None
    if isinstance(value, Mapping):
        return {str(key): _strict(part) for key, part in value.items()}
    if isinstance(value, list | tuple):
        return [_strict(part) for part in value]
    return value if value is None or isinstance(value, str | int) else str(value)
