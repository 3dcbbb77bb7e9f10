"""The tool that puts faults into the code: what it changes is one expression, and the file stays Python."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

from benchmarks.mutations import record
from benchmarks.mutations.__main__ import LEAST, all_sites, command_line
from benchmarks.mutations.record import OPEN, Record, drawn
from benchmarks.mutations.selection import CoverageMap, looking_at
from benchmarks.mutations.sites import ROOT, sites

SOURCE = """\"\"\"1 < 2 in a docstring is no site.\"\"\"

LIMIT = 1e-3


def f(x: int, y: float = 2) -> bool:
    if not x and y <= LIMIT:
        raise ValueError(f"{x + 1} is wrong" if y > 2 else "")
    return -x * y > 0
"""


def test_the_command_says_what_it_takes() -> None:
    assert "fails below 95%" in command_line().format_help()


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


@pytest.mark.long
def test_every_file_has_tests_that_are_there() -> None:
    for site in list(drawn(all_sites(), 2).values())[:50]:
        for tests in looking_at(str(site.path.relative_to(ROOT))):
            assert (ROOT / tests).exists(), tests


def test_tests_of_a_fault_are_those_that_execute_it() -> None:
    """Of a line; of a constant those that execute a line with its name, in any file; near ones and short ones first."""
    file, other = "runtime/running/monitor.py", "runtime/running/run.py"
    lines = (ROOT / file).read_text().splitlines()
    uses = 1 + next(k for k, line in enumerate(lines) if "GROWTH_LIMIT *" in line)
    tests = ["tests/laws/b", "tests/running/a", "tests/running/c", "tests/running/long"]
    found = CoverageMap(tests, [1.0, 3.0, 2.0, 50.0], {file: {uses: [0, 1, 2, 3]}, other: {1: [0]}})
    constant = next(site for site in sites(ROOT / file) if lines[site.line - 1].startswith("GROWTH_LIMIT"))
    line = next(site for site in sites(ROOT / file) if site.line == uses)
    for site in (constant, line):
        assert found.of(site, 10.0) == (["tests/running/c", "tests/running/a", "tests/laws/b"], 6.0)
    assert found.of(next(iter(sites(ROOT / other))), 10.0) == (["tests/laws/b"], 1.0)


def test_sites_stay_the_same_when_lines_move(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(record, "ROOT", tmp_path)
    here, moved = tmp_path / "a" / "file.py", tmp_path / "b" / "file.py"
    for path, text in ((here, SOURCE), (moved, "# a line more\n" + SOURCE)):
        path.parent.mkdir()
        path.write_text(text)
    orders = [[one[1:] for one in drawn(sites(path), 1)] for path in (here, moved)]
    assert sorted(orders[0]) == sorted(orders[1]) and len(set(orders[0])) == len(sites(here))
    assert list(drawn(sites(here), 1)) != list(drawn(sites(here), 2))


def test_the_record_has_a_reason_for_each_fault_that_is_let_go(tmp_path: Path) -> None:
    kept = Record.read(Path(record.__file__).with_name("record.json"))
    seen, told, same = kept.seen()
    assert seen + same <= len(kept.rows) == told + same and told >= 100 and seen >= LEAST * told
    assert all(by for verdict, by in kept.rows.values() if verdict not in ("timeout", *OPEN))
    copy = Record(tmp_path / "record.json", dict(kept.rows))
    copy.write()
    assert copy.path.read_text() == kept.path.read_text()
