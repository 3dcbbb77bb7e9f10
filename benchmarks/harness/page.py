"""Results as JSON and as a Markdown page."""

from __future__ import annotations

from dataclasses import asdict
from math import isnan
from typing import Any

from benchmarks.harness.result import Line, Result

INTRODUCTION = """# Benchmarks

Written by `python -m benchmarks --publish`; every number is of one run on the machine below.

Times are CPU times. Contenders of a comparison take turns within the run; the time is the lower quartile of many bursts
and a ratio is the ratio of these, beside it the quartiles of the round-by-round ratios or the range over processes. A
goal is an upper limit.
"""


def as_json(machine: dict[str, str], results: list[Result]) -> dict[str, Any]:
    """Everything that was measured."""
    return {
        "machine": machine,
        "results": [
            {
                "name": result.name,
                "title": result.title,
                "lines": [{**asdict(line), "met": line.met} for line in result.lines],
                "details": result.details,
            }
            for result in results
        ],
    }


def as_markdown(machine: dict[str, str], results: list[Result]) -> str:
    """The page docs/evidence/benchmarks.md."""
    parts = [INTRODUCTION, "\n".join(f"- {key}: {value}" for key, value in machine.items()) + "\n"]
    return "\n".join([*parts, *(_section(result) for result in results)])


def with_sections(page: str, machine: dict[str, str], results: list[Result]) -> str:
    """A page with the sections of `results` replaced, or added at the end; they say where they were run."""
    head, *parts = page.split("\n## ")
    sections = {part.split("\n", 1)[0]: f"## {part}" for part in parts}
    alone = f"This section was run on its own, on {machine['processor']}."
    for result in results:
        sections[result.title] = _section(result, alone)
    return "\n".join([head, *(section.rstrip("\n") + "\n" for section in sections.values())])


def _section(result: Result, place: str = "") -> str:
    rows = ["| | value | goal | | |", "|---|---:|---:|---|---|", *map(_row, result.lines)]
    remarks = "".join(f"{text}\n\n" for text in (place, result.remark) if text)
    return f"## {result.title}\n\n`python -m benchmarks --only {result.name}`\n\n{remarks}" + "\n".join(rows) + "\n"


def _row(line: Line) -> str:
    goal = "" if line.goal is None else f"<= {_number(line.goal)}"
    value = "-" if isnan(line.value) else f"{_number(line.value)} {line.unit}"
    verdict = {None: "", True: "met", False: "**not met**"}[line.met]
    return f"| {line.name} | {value} | {goal} | {verdict} | {line.note} |"


def _number(value: float) -> str:
    return f"{value:.0f}" if value == int(value) or value >= 1000 else f"{value:.3g}"
