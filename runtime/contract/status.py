"""How a simulation ended: a named status with time, coordinate, likely cause and advice; and the small tables, in
HTML with their style inline and no script, by which a notebook shows that and other objects.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from html import escape
from typing import Literal

import numpy as np

# What a notebook shows of an object: small tables in HTML with their style inline, no script.

GREEN, ORANGE, GREY = "#15803d", "#c2410c", "#6b7280"
CELL = "text-align:left;padding:1px 10px 1px 0;border:none;vertical-align:top"
MOST = 40  # rows of a table; further ones are counted
SPARK = (170, 22)  # pixels


def card(title: str, about: str, *parts: str) -> str:
    """A box with a title, a line in grey, and parts that are HTML already."""
    return (
        '<div style="border:1px solid #d1d5db;border-radius:6px;padding:8px 12px;margin:4px 0;max-width:62em;'
        f'font:13px/1.45 system-ui,sans-serif"><b style="font-size:14px">{escape(title)}</b> '
        f'<span style="color:{GREY}">{escape(about)}</span>{"".join(parts)}</div>'
    )


def badge(text: str, good: bool) -> str:
    """A word on green, or on orange."""
    colour = GREEN if good else ORANGE
    return f'<span style="background:{colour};color:#fff;border-radius:4px;padding:0 7px">{escape(text)}</span>'


def line(html: str) -> str:
    """A line of HTML."""
    return f'<div style="margin-top:3px">{html}</div>'


def table(rows: Iterable[Sequence[str]], header: Sequence[str] = ()) -> str:
    """Rows of texts; what is HTML already begins with "<"."""
    listed = list(rows)
    head = "".join(f'<th style="{CELL};color:{GREY}">{escape(cell)}</th>' for cell in header)
    body = "".join(
        "<tr>"
        + "".join(f'<td style="{CELL}">{cell if cell[:1] == "<" else escape(cell)}</td>' for cell in row)
        + "</tr>"
        for row in listed[:MOST]
    )
    more = f"<tr><td>... {len(listed) - MOST} more</td></tr>" if len(listed) > MOST else ""
    style = "border-collapse:collapse;margin:4px 0;font:inherit"
    return f'<table style="{style}">{f"<tr>{head}</tr>" if head else ""}{body}{more}</table>'


def fold(title: str, html: str) -> str:
    """Something that opens on a click."""
    return f'<details style="margin-top:4px"><summary>{escape(title)}</summary>{html}</details>'


def sparkline(values: np.ndarray) -> str:
    """A small curve (SVG) of values (N,) at equal distances."""
    width, height = SPARK
    finite = np.nan_to_num(np.asarray(values, dtype=float))
    low, span = float(finite.min()), float(np.ptp(finite)) or 1.0
    chosen = np.unique(np.linspace(0, len(finite) - 1, min(len(finite), width)).astype(int))
    x = np.linspace(1, width - 1, len(chosen))
    y = height - 2 - (height - 4) * (finite[chosen] - low) / span
    points = " ".join(f"{u:.1f},{v:.1f}" for u, v in zip(x, y, strict=True))
    return (
        f'<svg width="{width}" height="{height}"><polyline points="{points}" fill="none" stroke="#0072b2" '
        'stroke-width="1.3"/></svg>'
    )


# How a simulation ended: a named status with time, coordinate, likely cause and advice.

StatusName = Literal[
    "completed",
    "inaccurate",
    "interrupted",
    "step_too_long",
    "step_too_short",
    "not_finite",
    "diverged",
    "constraints_lost",
    "mass_not_positive",
    "iteration_failed",
    "partition_lost",
    "branch_lost",
    "deflection_too_large",
    "off_the_beam",
    "integrator_refused",
    "output_failed",
    "not_assembled",
    "event",
    "chattering",
    "no_mode",
]
EventKind = Literal[
    "assembled",
    "not_settled",
    "repartition",
    "singular_position",
    "no_variant",
    "checkpoint_failed",
    "load_missed",
    "load_not_finite",
    "shapes_missing",
    "stresses_missing",
    "sections_missing",
    "velocity_jump",
    "beyond_buckling",
    "angles_singular",
    "kink_crossed",
    "kink",
    "event",
    "mode",
    "impact",
    "rest",
]


@dataclass(frozen=True)
class Event:
    """Something that happened during a run, at a time [s], told in plain words; of events of the scene with their name
    and direction (rising or falling). Kinks of loads, at which steps end without a word, are in no solution.
    impulse: what a stop gave in an impact, away from it [N s or N m s].
    """

    time: float
    kind: EventKind
    text: str
    name: str = ""
    direction: str = ""
    impulse: float = 0.0

    def __str__(self) -> str:
        return f"t = {self.time:.9g} s: {self.text}"


@dataclass(frozen=True)
class Status:
    """name; time of the last good state [s]; coordinate that failed (if any); cause and advice in plain words."""

    name: StatusName
    time: float
    coordinate: str | None = None
    cause: str = ""
    advice: str = ""

    @property
    def ok(self) -> bool:
        """Did the run reach its end, or a terminal event, and is its error small as far as it was estimated?"""
        return self.name in ("completed", "event")

    @property
    def whole(self) -> bool:
        """Was all of the motion computed, accurately or not?"""
        return self.ok or self.name == "inaccurate"

    @property
    def ending(self) -> str:
        """For titles: nothing where all is well, else what happened and when."""
        if self.ok:
            return ""
        return "INACCURATE" if self.whole else f"STOPPED: {self.name} at {self.time:.4g} s"

    def _repr_html_(self) -> str:
        where = f", coordinate {escape(self.coordinate)}" if self.coordinate else ""
        cause = f"<br>{escape(self.cause)}" if self.cause else ""
        advice = f"<br>Try: {escape(self.advice)}" if self.advice else ""
        return f"{badge(self.name, self.ok)} at t = {self.time:.9g} s{where}{cause}{advice}"

    def __str__(self) -> str:
        where = f", coordinate {self.coordinate}" if self.coordinate else ""
        tail = f": {self.cause}. {self.advice}" if self.cause else ""
        return f"{self.name} at t = {self.time:.9g} s{where}{tail}"
