"""What a command has to say, and how it is said: lines for a person, or one JSON object."""

from __future__ import annotations

import json
import math
import sys
import traceback
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any

from runtime.contract.errors import SymgenError

OK, FAILED, WRONG_INPUT, FAULT, INTERRUPTED = 0, 1, 2, 3, 130
REPORT_IT = (
    "this is a fault of symgen, not of your input; please report it with the lines above, the command and the scene "
    "(docs/guide/failures.md says what helps)"
)
LONGEST_MESSAGE = 2000  # characters: what was given may be as long as it likes, its echo may not


@dataclass(frozen=True)
class Outcome:
    """data for --json; lines for a person; exit code."""

    data: Mapping[str, Any]
    lines: list[str] = field(default_factory=list)
    code: int = OK


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
        print("\n".join(outcome.lines))
    sys.stdout.flush()


def report_error(command: str, error: Exception | str, as_json: bool, code: int) -> None:
    """Write an error: to standard error for a person, as the JSON object on standard output otherwise."""
    further = [str(entry) for entry in getattr(error, "also", ())]
    if as_json:
        details = {
            "kind": type(error).__name__ if isinstance(error, Exception) else error,
            "message": clipped(str(error)),
        }
        if isinstance(error, SymgenError) and error.problem:
            parts = {"item": error.item, "problem": error.problem, "remedy": error.remedy}
            details |= {key: clipped(text) for key, text in parts.items()}
        also = [clipped(text) for text in further]
        _write_json({"command": command, "exit_code": code, "error": {**details, "also": also}})
        return
    for text in (str(error), *further):
        print(f"symgen: {clipped(text)}", file=sys.stderr)


def clipped(text: str) -> str:
    """A message with its middle left out where it is longer than a person reads."""
    if len(text) <= LONGEST_MESSAGE:
        return text
    half = LONGEST_MESSAGE // 2
    return f"{text[:half]} ... ({len(text) - 2 * half} characters left out) ... {text[-half:]}"


def report_fault(command: str, error: Exception, as_json: bool) -> None:
    """An exception that nobody expected: where it broke on standard error, and how to report it."""
    traceback.print_exception(error)
    print(f"symgen: {REPORT_IT}", file=sys.stderr)
    if as_json:
        where = "".join(traceback.format_exception(error))
        details = {"kind": type(error).__name__, "message": str(error), "traceback": where, "remedy": REPORT_IT}
        _write_json({"command": command, "exit_code": FAULT, "error": details})


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
