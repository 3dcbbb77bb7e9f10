"""What came of each fault, in a file of the repository; sites are known by their text, not by where it stands."""

from __future__ import annotations

import hashlib
import json
from collections import Counter
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from benchmarks.mutations.sites import ROOT, Site

Key = tuple[str, str, str]  # file, line, fault with its column in the line
FIELDS = ("file", "line", "fault", "verdict", "by")
SEEN, OPEN = ("killed", "timeout"), ("survived", "not executed")
SAME = "same"  # nothing that can be told changes: `by` says why; given by hand


@cache
def _source(path: Path) -> str:
    return path.read_text(encoding="utf-8")


def key(site: Site) -> Key:
    """How a site is known."""
    line = _source(site.path).splitlines()[site.line - 1]
    column = len(line.encode("utf-8")[: site.first].decode("utf-8").lstrip())
    fault = f"{site.shown(_source(site.path))} at {column}"
    return str(site.path.relative_to(ROOT)), line.strip(), fault


def drawn(found: list[Site], seed: int) -> dict[Key, Site]:
    """Sites in an order that is drawn by their own text: a change of the code moves only the sites in it."""
    known: dict[Key, Site] = {}
    for site in found:
        known.setdefault(key(site), site)

    def rank(one: Key) -> str:
        return hashlib.sha256("\0".join((str(seed), *one)).encode("utf-8")).hexdigest()

    return {one: known[one] for one in sorted(known, key=rank)}


@dataclass
class Record:
    """Verdict, and the test or the reason, of each site."""

    path: Path
    rows: dict[Key, tuple[str, str]]

    @classmethod
    def read(cls, path: Path) -> Record:
        """From its file, if there is one."""
        rows = json.loads(path.read_text(encoding="utf-8")) if path.exists() else []
        return cls(path, {(row["file"], row["line"], row["fault"]): (row["verdict"], row["by"]) for row in rows})

    def add(self, one: Key, verdict: str, by: str) -> None:
        """And write the file."""
        self.rows[one] = (verdict, by)
        self.write()

    def write(self) -> None:
        """In the order of files and lines."""
        rows = [dict(zip(FIELDS, (*one, *found), strict=True)) for one, found in sorted(self.rows.items())]
        self.path.write_text(json.dumps(rows, indent=1) + "\n", encoding="utf-8")

    def seen(self) -> tuple[int, int, int]:
        """How many faults are seen, can be told, and change nothing."""
        count = Counter(verdict for verdict, _ in self.rows.values())
        return sum(count[verdict] for verdict in SEEN), len(self.rows) - count[SAME], count[SAME]

    def score(self) -> str:
        """In a line."""
        seen, told, same = self.seen()
        return f"{seen} of {told} faults that can be told are seen, {100 * seen / told:.1f} %; {same} change nothing"
