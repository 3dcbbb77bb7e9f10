"""A page of sections to read and print: one HTML file without scripts of its own, everything inside it.

Texts are escaped by `runtime/contract/cards.py:html`; figures are images, and a page with a moving view is a frame.
"""

from __future__ import annotations

import base64
import io
import platform
from collections.abc import Iterable, Sequence
from html import escape
from importlib.metadata import PackageNotFoundError, version
from math import isnan
from typing import TYPE_CHECKING

import numpy as np

from runtime.contract.cards import Html, html
from runtime.views.figure import WIDTH, prefixed
from runtime.views.viewer.page import View, text_of

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from runtime.results.key_figures import Peak

MOST_OF_LINES = 250_000  # bytes of a figure
DOTS = 110  # to an inch
LIBRARIES = ("symgen", "casadi", "numpy", "scipy", "llvmlite")
MOST_ROWS = 200  # of a table; further ones are counted


def document(title: str, about: str, sections: Iterable[tuple[str, Html]]) -> View:
    """The page: a heading, a line below it, sections by their titles; those without content are left out."""
    body = [
        html(Html("<section><h2>"), name, Html("</h2>"), part, Html("</section>")) for name, part in sections if part
    ]
    head = html(Html("<header><h1>"), title, Html("</h1><p>"), about, Html("</p></header>"))
    text = (
        '<!doctype html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f"<title>{escape(title)}</title>\n<style>{text_of('document.css')}</style>\n</head>\n<body>\n"
        + "\n".join([head, *body])
        + "\n</body>\n</html>\n"
    )
    return View(title, text)


def paragraph(*parts: str) -> Html:
    """A paragraph of parts."""
    return html(Html("<p>"), *parts, Html("</p>"))


def code(text: str) -> Html:
    """Lines to copy."""
    return html(Html("<pre>"), text, Html("</pre>"))


def folded(title: str, content: Html) -> Html:
    """What opens on a click, and is not printed."""
    return html(Html("<details><summary>"), title, Html("</summary>"), content, Html("</details>"))


def badge(text: str, good: bool) -> Html:
    """A word on green, or on orange."""
    return html(Html(f'<span class="{"good" if good else "bad"}">'), text, Html("</span>"))


def table(header: Sequence[str], rows: Sequence[Sequence[str]], numbers: Iterable[int] = ()) -> Html:
    """Rows of cells; numbers: columns that are set to the right. Nothing without rows."""
    if not rows:
        return Html()
    right = set(numbers)

    def row(cells: Sequence[str], tag: str) -> Html:
        parts = [
            html(Html(f"<{tag}{' class=n' if k in right else ''}>"), cell, Html(f"</{tag}>"))
            for k, cell in enumerate(cells)
        ]
        return html(Html("<tr>"), *parts, Html("</tr>"))

    head = html(Html("<thead>"), row(header, "th"), Html("</thead>")) if any(header) else Html()
    more = [Html(f"<tr><td>... {len(rows) - MOST_ROWS} more</td></tr>")] if len(rows) > MOST_ROWS else []
    body = [row(cells, "td") for cells in rows[:MOST_ROWS]]
    return html(Html("<table>"), head, Html("<tbody>"), *body, *more, Html("</tbody></table>"))


def picture(figure: Figure, caption: str) -> Html:
    """A figure as an image: of lines, which print sharp, or of points where lines take too much; without its title."""
    figure.suptitle("")  # the page has one
    kind, content = "svg+xml", io.BytesIO()
    figure.savefig(content, format="svg")
    if content.tell() > MOST_OF_LINES:
        kind, content = "png", io.BytesIO()
        figure.savefig(content, format="png", dpi=DOTS)
    data = base64.b64encode(content.getvalue()).decode("ascii")
    wide = min(100.0, 100 * figure.get_size_inches()[0] / WIDTH)
    return html(
        Html(
            f'<figure style="width:{wide:.0f}%"><img src="data:image/{kind};base64,{data}" alt="{escape(caption)}">'
            "<figcaption>"
        ),
        caption,
        Html("</figcaption></figure>"),
    )


def frame(view: View) -> Html:
    """A page inside the page."""
    inside = view.text.replace("&", "&amp;").replace('"', "&quot;")
    return Html(
        f'<iframe title="{escape(view.title)}" sandbox="allow-scripts allow-same-origin allow-downloads" '
        f'srcdoc="{inside}"></iframe>'
    )


def quantity(value: float, unit: str) -> str:
    """Four digits with a prefixed unit, angles in degrees: `12.35 mm`."""
    if not np.isfinite(value):
        return "-"
    factor, shown = prefixed(np.array([value]), unit)
    text = f"{factor * value + 0.0:.4g}"  # no -0
    return f"{text}°" if shown == "°" else text if shown == "1" else f"{text} {shown}"


def time_of(t: float) -> str:
    """Five digits, without the unit."""
    return "-" if isnan(t) else f"{t:.5g}"


def peak_table(peaks: Sequence[Peak], note: str) -> Html:
    """Peaks with their times, ranges and places, and a line below; nothing without peaks."""
    if not peaks:
        return Html()
    rows = [
        (
            one.quantity,
            quantity(one.value, one.unit),
            time_of(one.t),
            "-" if isnan(one.low) else f"{quantity(one.low, one.unit)} to {quantity(one.high, one.unit)}",
            quantity(one.end, one.unit),
            one.place,
        )
        for one in peaks
    ]
    header = ("quantity", "peak", "at t [s]", "range", "at the end", "place")
    columns = 6 if any(one.place for one in peaks) else 5
    return html(table(header[:columns], [row[:columns] for row in rows], (1, 2, 3, 4)), paragraph(note))


def made_with() -> Html:
    """Versions of what a run was made with."""
    versions = ", ".join(f"{name} {_version(name)}" for name in LIBRARIES)
    return paragraph(f"Made with {versions}, Python {platform.python_version()}, {platform.system()}.")


def _version(name: str) -> str:
    try:
        return version(name)
    except PackageNotFoundError:
        return "(not installed)"
