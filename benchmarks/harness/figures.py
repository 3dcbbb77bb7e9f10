"""Figures in pages, between markers that name what writes them; what is around them is written by hand.

<!-- figures: others -->
...
<!-- end -->

A marker is the name of a benchmark, or that and a part of it: `others.programs`.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from math import isfinite
from pathlib import Path

DOCS = Path(__file__).resolve().parents[2] / "docs"
BLOCK = re.compile(r"(?ms)^<!-- figures: (\S+) -->\n(.*?)^<!-- end -->$")


def marked(docs: Path | None = None) -> dict[str, Path]:
    """The pages by the names of their markers. Raises ValueError for a name that stands twice or has no end."""
    found: dict[str, Path] = {}
    for page in sorted((docs or DOCS).rglob("*.md")):
        text = page.read_text(encoding="utf-8")
        names = [name for name, _ in BLOCK.findall(text)]
        if len(names) != text.count("<!-- figures:") or len(names) != text.count("<!-- end -->"):
            raise ValueError(f"{page}: a marker of figures has no end of its own")
        for name in names:
            if name in found:
                raise ValueError(f"{page}: figures of {name} stand in {found[name]}, too")
            found[name] = page
    return found


def figures(name: str, docs: Path | None = None) -> str:
    """What stands between the markers of this name."""
    text = marked(docs)[name].read_text(encoding="utf-8")
    return next(found for label, found in BLOCK.findall(text) if label == name)


def publish(written: Mapping[str, str], docs: Path | None = None) -> list[Path]:
    """Put texts between their markers; the pages that were changed. Raises KeyError for a name without markers."""
    pages = marked(docs)
    for name, content in written.items():
        block = f"<!-- figures: {name} -->\n{content.strip()}\n<!-- end -->"
        text = pages[name].read_text(encoding="utf-8")
        for found in BLOCK.finditer(text):
            if found[1] == name:
                text = text.replace(found[0], block)
        pages[name].write_text(text, encoding="utf-8")
    return sorted({pages[name] for name in written})


def table(head: Sequence[str], rows: Iterable[Sequence[str]], right: int = 0) -> str:
    """A table in Markdown; right: how many of the last columns hold numbers."""
    rule = ["---"] * (len(head) - right) + ["---:"] * right
    return "\n".join(f"| {' | '.join(cells)} |" for cells in (head, rule, *rows)) + "\n"


def method(label: str) -> str:
    """The label of a method, its scheme as code."""
    scheme, _, rest = label.partition(" ")
    return f"`{scheme}` {rest}".strip()


def short(value: float) -> str:
    """Two digits, a dash where there is no number."""
    if not isfinite(value):
        return "-"
    return f"{value:.0f}" if abs(value) >= 10 else f"{value:.2g}"


def milliseconds(seconds: float) -> str:
    """Three digits."""
    return f"{seconds * 1e3:.3g}"
