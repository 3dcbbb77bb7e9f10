"""Many comparisons side by side: which method won where, by how much, and whether advice would have found it."""

from __future__ import annotations

import html
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from runtime.contract.files import write_text
from runtime.results.export import as_json
from runtime.studies.advice.advise import Advice
from runtime.studies.work_precision.comparison import Comparison
from runtime.studies.work_precision.comparison_files import STYLE

HEADER = [
    "case",
    "best method",
    "time [ms]",
    "best with one step",
    "time [ms]",
    "gain of sub-steps",
    "advised",
    "advised over best",
]


@dataclass(frozen=True)
class SuiteResult:
    """One case: its comparison, the advice for it (None: it found none), and what went wrong instead."""

    name: str
    comparison: Comparison | None
    advice: Advice | None
    failure: str = ""

    def advised_over_best(self) -> float:
        """Time of the advised method and step over that of the best one found; NaN where there is none."""
        if self.comparison is None or self.advice is None:
            return np.nan
        best = self.comparison.ranked()[0].seconds_to(self.comparison.tolerance)
        return float(self.advice.seconds / best) if best > 0 else np.nan

    def row(self) -> list[str]:
        """Texts in the order of HEADER."""
        if self.comparison is None:
            return [self.name, self.failure, *["-"] * (len(HEADER) - 2)]
        tolerance, ranked = self.comparison.tolerance, self.comparison.ranked()
        single = next((curve for curve in ranked if not curve.multirate), None)
        return [
            self.name,
            ranked[0].label,
            _milliseconds(ranked[0].seconds_to(tolerance)),
            single.label if single else "-",
            _milliseconds(single.seconds_to(tolerance)) if single else "-",
            _ratio(self.comparison.gain()),
            self.advice.method.label if self.advice else "none",
            _ratio(self.advised_over_best()),
        ]


def _milliseconds(seconds: float) -> str:
    return f"{seconds * 1e3:.3g}" if np.isfinite(seconds) else "-"


def _ratio(value: float) -> str:
    return f"{value:.2f}" if np.isfinite(value) else "-"


def suite_markdown(results: Sequence[SuiteResult]) -> str:
    """The table of all cases."""
    rows = [HEADER, ["---"] * len(HEADER), *(result.row() for result in results)]
    table = "\n".join(f"| {' | '.join(cell.replace('|', '/') for cell in row)} |" for row in rows)
    return (
        "# Hard suite: time to a tolerance\n\nTimes are CPU, compiled, one thread, one run to the tolerance. "
        "`gain of sub-steps` is the time of the best method with one step for all coordinates over that of the "
        "best one with sub-steps; below 1 sub-steps do not pay. Each case has a folder of its own.\n\n" + table + "\n"
    )


def write_suite(results: Sequence[SuiteResult], folder: str | Path) -> dict[str, str]:
    """suite.md, suite.json and suite.html in `folder`; {what: path}. Raises OutputError."""
    place = Path(folder)
    data: dict[str, Any] = {"cases": [dict(zip(_keys(), result.row(), strict=True)) for result in results]}
    write_text(place / "suite.md", suite_markdown(results))
    write_text(place / "suite.json", as_json(data))
    head = "".join(f"<th>{html.escape(cell)}</th>" for cell in HEADER)
    body = ""
    for result in results:
        cells = [html.escape(cell) for cell in result.row()]
        link = f'<a href="{cells[0]}/comparison.html">{cells[0]}</a>' if result.comparison else cells[0]
        body += "<tr>" + "".join(f"<td>{cell}</td>" for cell in [link, *cells[1:]]) + "</tr>"
    page = (
        '<!doctype html><html lang="en"><head><meta charset="utf-8"><title>Hard suite</title>'
        f"<style>{STYLE}</style></head><body><h1>Hard suite</h1>"
        f"<table><tr>{head}</tr>{body}</table></body></html>\n"
    )
    write_text(place / "suite.html", page)
    return {name: str(place / name) for name in ("suite.md", "suite.json", "suite.html")}


def _keys() -> list[str]:
    return ["case", "best", "best_ms", "single", "single_ms", "gain", "advised", "advised_over_best"]
