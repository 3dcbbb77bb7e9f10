"""Results as JSON and as a Markdown page."""

from __future__ import annotations

from dataclasses import asdict
from math import isnan
from typing import Any

from benchmarks.result import Line, Result

INTRODUCTION = """# Benchmarks

Written by `python -m benchmarks --publish`; every number is of one run on the machine below.

Times are CPU times. Contenders of a comparison take turns within the run; the time is the minimum of many bursts and
a ratio is the ratio of the minima, beside it the quartiles of the round-by-round ratios or the range over processes. A
goal is an upper limit.
"""


def as_json(machine: dict[str, str], results: list[Result]) -> dict[str, Any]:
    """Everything that was measured."""
    return {"machine": machine, "results": [
        {"name": result.name, "title": result.title,
         "lines": [{**asdict(line), "met": line.met} for line in result.lines], "details": result.details}
        for result in results]}


def as_markdown(machine: dict[str, str], results: list[Result]) -> str:
    """The page docs/benchmarks.md."""
    parts = [INTRODUCTION, "\n".join(f"- {key}: {value}" for key, value in machine.items()) + "\n"]
    for result in results:
        rows = ["| | value | goal | | |", "|---|---:|---:|---|---|", *map(_row, result.lines)]
        remark = f"{result.remark}\n\n" if result.remark else ""
        parts.append(f"## {result.title}\n\n`python -m benchmarks --only {result.name}`\n\n{remark}" + "\n".join(rows)
                     + "\n")
    return "\n".join(parts)


def _row(line: Line) -> str:
    goal = "" if line.goal is None else f"<= {_number(line.goal)}"
    value = "-" if isnan(line.value) else f"{_number(line.value)} {line.unit}"
    verdict = {None: "", True: "met", False: "**not met**"}[line.met]
    return f"| {line.name} | {value} | {goal} | {verdict} | {line.note} |"


def _number(value: float) -> str:
    return f"{value:.0f}" if value == int(value) or value >= 1000 else f"{value:.3g}"
