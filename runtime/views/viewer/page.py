"""One HTML file from the page's parts, the libraries and the run's numbers."""

from __future__ import annotations

import html
import json
import re
import sys
import tempfile
import webbrowser
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from importlib.resources import files
from pathlib import Path
from typing import TYPE_CHECKING, Any

from runtime.contract.arguments import PLACE, RUN, require
from runtime.contract.files import OutputError, write_text
from runtime.views.viewer.record import MOST_FRAMES, view_record

if TYPE_CHECKING:
    from runtime.solutions.solution import Solution

SCRIPTS = ("numbers", "data", "motion", "stage", "bodies", "symbols", "curves", "controls")
HEIGHT = 560  # pixels of the frame in a notebook


@dataclass(frozen=True, repr=False)
class View:
    """A page of a run; a notebook shows it in a frame of the notebook's own origin.

    A frame of an origin of its own is another process of the browser, which exported notebooks show blank at times.
    """

    title: str
    text: str

    def __repr__(self) -> str:
        return f"<View of {self.title}, {len(self.text) / 1e6:.2f} MB>"

    def _repr_html_(self) -> str:
        return (
            f'<iframe sandbox="allow-scripts allow-same-origin allow-downloads" width="100%" height="{HEIGHT}" '
            f'frameborder="0" srcdoc="{html.escape(self.text)}"></iframe>'
        )

    def save(self, path: str | Path) -> None:
        """Write the page. Raises OutputError (place not writable, a name that does not end in .html)."""
        if Path(path).suffix.lower() not in (".html", ".htm"):
            raise OutputError(f"{path}: the name of a page must end in .html")
        write_text(path, self.text)

    def open(self) -> None:
        """Show the page in the browser, from a temporary file."""
        with tempfile.NamedTemporaryFile("w", suffix=".html", delete=False, encoding="utf-8") as file:
            file.write(self.text)
        webbrowser.open(Path(file.name).as_uri())


def view(solution: Solution, beside: Solution | None = None, frames: int = MOST_FRAMES, alone: bool = True) -> View:
    """The page of a run, with a second one pale. Raises ModelError if the model has nothing to draw.

    alone: with title and curves, which a page around it has by itself.
    """
    record = view_record(solution, beside, frames, with_curves=alone)
    return page("page.html", record, text_of("page.css") + ("" if alone else "header { display: none; }"), SCRIPTS)


def page(frame: str, record: Mapping[str, Any], styles: str, scripts: Sequence[str]) -> View:
    """A page of its frame, its numbers, and what draws them."""
    parts = {
        "title": html.escape(str(record["title"])),
        "styles": text_of("bundles/uplot.min.css") + styles,
        "three": text_of("bundles/three.min.js"),
        "uplot": text_of("bundles/uplot.min.js"),
        "data": json.dumps(record, separators=(",", ":"), allow_nan=False).replace("<", "\\u003c"),
        "script": "\n".join(text_of(f"script/{name}.js") for name in scripts),
    }
    pieces = re.split("@@([a-z]+)@@", text_of(frame))
    return View(str(record["title"]), "".join(parts[piece] if k % 2 else piece for k, piece in enumerate(pieces)))


def show(solution: Solution, path: str | Path | None = None, beside: Solution | None = None) -> View:
    """Show the moving mechanism as one page.

    Parameters
    ----------
    solution : Solution
        N samples.
    path : str or Path, optional
        An .html file; if left out the page is shown in the notebook, or opened.
    beside : Solution, optional
        A second run, shown pale in the same page.

    Returns
    -------
    View
        The page.

    Raises
    ------
    ModelError
        Where there is nothing to draw.
    OutputError
        For a place that cannot be written.
    """
    require(PLACE, or_none=True, path=path)
    require(RUN, or_none=True, beside=beside)
    return shown(view(solution, beside), path)


def shown(made: View, path: str | Path | None) -> View:
    """Written where a path is given; without one a notebook shows it, and elsewhere the browser opens it."""
    if path is not None:
        made.save(path)
    elif "ipykernel" not in sys.modules:
        made.open()
    return made


@cache
def text_of(name: str) -> str:
    """A part of pages, by its place in this folder."""
    return files("runtime.views.viewer").joinpath(name).read_text(encoding="utf-8")
