"""The tool that puts faults into the code: what it changes is one expression, and the file stays Python."""

from __future__ import annotations

import ast
from pathlib import Path

from tests.mutations.__main__ import ROOT, chosen
from tests.mutations.selection import selected
from tests.mutations.sites import sites

SOURCE = """\"\"\"1 < 2 in a docstring is no site.\"\"\"

LIMIT = 1e-3


def f(x: int, y: float = 2) -> bool:
    if not x and y <= LIMIT:
        raise ValueError(f"{x + 1} is wrong" if y > 2 else "")
    return -x * y > 0
"""


def test_sites_are_what_runs(tmp_path: Path) -> None:
    path = tmp_path / "file.py"
    path.write_text(SOURCE)
    shown = {site.shown(SOURCE) for site in sites(path)}
    assert shown == {
        "1e-3 -> 1.0",
        "2 -> 3",
        "not x and y <= LIMIT -> (not x or y <= LIMIT)",
        "not x -> x",
        "y <= LIMIT -> (y > LIMIT)",
        "-x * y > 0 -> (-x * y <= 0)",
        "-x * y -> (-x / y)",
        "-x -> x",
        "0 -> 1",
    }
    for site in sites(path):
        changed = site.applied(SOURCE)
        ast.parse(changed)
        assert sum(a != b for a, b in zip(changed.splitlines(), SOURCE.splitlines(), strict=True)) == 1


def test_every_file_has_tests_that_are_there() -> None:
    for site in chosen(50, 2, ""):
        for tests in selected(str(site.path.relative_to(ROOT))):
            assert (ROOT / tests).exists(), tests
