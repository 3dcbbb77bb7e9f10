"""What a notebook shows of an object: small tables in HTML with their style inline, no script.

What is markup is a type, not a text that looks like it: a text is escaped wherever it enters, and only the functions
here (and those that draw SVG of numbers) make Html.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from html import escape

import numpy as np

GREEN, ORANGE, GREY = "#15803d", "#c2410c", "#6b7280"
CELL = "text-align:left;padding:1px 10px 1px 0;border:none;vertical-align:top"
MOST_ROWS_OF_CARD = 40  # rows of a table; further ones are counted
SPARK = (170, 22)  # pixels


class Html(str):
    """Markup. Joined to a text or formatted into one it is a text again, so nothing becomes markup by accident."""

    __slots__ = ()


def html(*parts: str) -> Html:
    """Parts one after another as markup: those that are Html as they are, every other text escaped."""
    return Html("".join(part if isinstance(part, Html) else escape(part) for part in parts))


def card(title: str, about: str, *parts: str) -> Html:
    """A box with a title, a line in grey, and further parts."""
    return Html(
        '<div style="border:1px solid #d1d5db;border-radius:6px;padding:8px 12px;margin:4px 0;max-width:62em;'
        f'font:13px/1.45 system-ui,sans-serif"><b style="font-size:14px">{escape(title)}</b> '
        f'<span style="color:{GREY}">{escape(about)}</span>{html(*parts)}</div>'
    )


def badge(text: str, good: bool) -> Html:
    """A word on green, or on orange."""
    colour = GREEN if good else ORANGE
    return Html(f'<span style="background:{colour};color:#fff;border-radius:4px;padding:0 7px">{escape(text)}</span>')


def line(*parts: str) -> Html:
    """A line of parts."""
    return Html(f'<div style="margin-top:3px">{html(*parts)}</div>')


def table(rows: Iterable[Sequence[str]], header: Sequence[str] = ()) -> Html:
    """Rows of cells."""
    listed = list(rows)
    head = "".join(f'<th style="{CELL};color:{GREY}">{html(cell)}</th>' for cell in header)
    body = "".join(
        "<tr>" + "".join(f'<td style="{CELL}">{html(cell)}</td>' for cell in row) + "</tr>"
        for row in listed[:MOST_ROWS_OF_CARD]
    )
    more = f"<tr><td>... {len(listed) - MOST_ROWS_OF_CARD} more</td></tr>" if len(listed) > MOST_ROWS_OF_CARD else ""
    style = "border-collapse:collapse;margin:4px 0;font:inherit"
    return Html(f'<table style="{style}">{f"<tr>{head}</tr>" if head else ""}{body}{more}</table>')


def fold(title: str, content: str) -> Html:
    """Something that opens on a click."""
    return Html(f'<details style="margin-top:4px"><summary>{escape(title)}</summary>{html(content)}</details>')


def sparkline(values: np.ndarray) -> Html:
    """A small curve (SVG) of values (N,) at equal distances."""
    width, height = SPARK
    finite = np.nan_to_num(np.asarray(values, dtype=float))
    low, span = float(finite.min()), float(np.ptp(finite)) or 1.0
    chosen = np.unique(np.linspace(0, len(finite) - 1, min(len(finite), width)).astype(int))
    x = np.linspace(1, width - 1, len(chosen))
    y = height - 2 - (height - 4) * (finite[chosen] - low) / span
    points = " ".join(f"{u:.1f},{v:.1f}" for u, v in zip(x, y, strict=True))
    return Html(
        f'<svg width="{width}" height="{height}"><polyline points="{points}" fill="none" stroke="#0072b2" '
        'stroke-width="1.3"/></svg>'
    )
