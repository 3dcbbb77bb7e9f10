"""Results as JSON and as a Markdown page."""

from __future__ import annotations

from dataclasses import asdict, replace
from math import isnan
from typing import Any

from benchmarks.harness.result import Line, Result

TABLES = frozenset({"others", "hard_steps", "arms", "tolerance", "scaling"})  # have tables on the page of speed
TOLD_THERE = (
    "What is measured, and by case: [speed](speed.md). Here are goals of all cases and those that a case misses."
)
MOST_OTHERS = 6  # lines without a goal in a section
INTRODUCTION = """# Benchmarks

Written by `python -m benchmarks --publish`; every number is of one run on the machine below.

Times are CPU times. Contenders of a comparison take turns within the run; the time is the lower quartile of many bursts
and a ratio is the ratio of these, beside it the quartiles of the round-by-round ratios or the range over processes. A
goal is an upper limit. Of the lines without a goal a section shows the first; `--only` prints them all.
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
    alone = f", run on its own on {machine['processor']}"
    for result in results:
        sections[result.title] = _section(result, alone)
    return "\n".join([head, *(section.rstrip("\n") + "\n" for section in sections.values())])


def _section(result: Result, place: str = "") -> str:
    lines = _shown(_gathered(result.lines))
    if result.name in TABLES:
        lines = [line for line in lines if line.met is False or line.goal is not None and ": " not in line.name]
    rows = ["| | value | goal | | |", "|---|---:|---:|---|---|", *map(_row, lines)] if lines else []
    told = f"`python -m benchmarks --only {result.name}`{place}. "
    told += TOLD_THERE if result.name in TABLES else result.remark
    return "\n".join([f"## {result.title}", told, *([""] if rows else []), *rows, ""]).replace(" \n", "\n")


def _shown(lines: list[Line]) -> list[Line]:
    """Lines with a goal, and the first few of the others; `--only` prints all of them."""
    others = [line for line in lines if line.goal is None]
    return [line for line in lines if line.goal is not None or line in others[:MOST_OTHERS]]


def _gathered(lines: list[Line]) -> list[Line]:
    """Lines of one case (`case: what`) without a goal stand in the remark of the one before them."""
    found: list[Line] = []
    for line in lines:
        case, colon, what = line.name.partition(": ")
        if colon and line.goal is None and found and found[-1].name.partition(": ")[0] == case:
            told = f"{what} {_value(line)}" + (f" ({line.note})" if line.note else "")
            found[-1] = replace(found[-1], note="; ".join(text for text in (found[-1].note, told) if text))
        else:
            found.append(line)
    return found


def _value(line: Line) -> str:
    return "-" if isnan(line.value) else f"{_number(line.value)} {line.unit}".rstrip()


def _row(line: Line) -> str:
    goal = "" if line.goal is None else f"<= {_number(line.goal)}"
    verdict = {None: "", True: "met", False: "**not met**"}[line.met]
    return f"| {line.name} | {_value(line)} | {goal} | {verdict} | {line.note} |"


def _number(value: float) -> str:
    return f"{value:.0f}" if value == int(value) or value >= 1000 else f"{value:.3g}"
