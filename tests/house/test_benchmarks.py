"""`python -m benchmarks` knows every benchmark and computed page, leaves results, and writes tables into pages."""

from __future__ import annotations

import json
import sys
from importlib import import_module
from pathlib import Path

import numpy as np
import pytest

from benchmarks import __main__ as program
from benchmarks.__main__ import BENCHMARKS, FIGURES, PAGES, main
from benchmarks.contenders.long_chains import FAMILIES, OURS, installed
from benchmarks.harness import figures
from benchmarks.harness.growth import growth
from benchmarks.harness.result import Line, Result, Skipped
from benchmarks.harness.smallest import smallest
from benchmarks.pages import hard_twins

pytestmark = pytest.mark.long

FOLDER = Path(__file__).resolve().parents[2] / "benchmarks"


def modules(shelf: str) -> list[str]:
    return [path.stem for path in (FOLDER / shelf).glob("*.py") if path.stem != "__init__"]


def test_the_command_runs_everything() -> None:
    cases = {name for name in modules("cases") if hasattr(import_module(f"benchmarks.cases.{name}"), "run")}
    assert set(BENCHMARKS) == cases
    assert set(PAGES) == set(modules("pages"))


@pytest.mark.parametrize("name", BENCHMARKS)
def test_every_benchmark_runs(name: str) -> None:
    """Each part of it once, with the smallest work; not without the compiler or program that it is measured with."""
    run = BENCHMARKS[name]
    try:
        with smallest(sys.modules[run.__module__]):
            result = run()
    except Skipped as reason:
        pytest.skip(f"{name}: {reason}")
    assert result.name == name and result.lines
    assert all(np.isfinite(line.value) for line in result.lines if line.unit), result.lines


def test_figures_of_the_smallest_work_are_not_kept(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """So that nobody publishes them."""
    assert main(["--only", "operations", "--smallest", "--out", str(tmp_path)]) == 0
    assert "chain, 10 rigid links" in capsys.readouterr().out and not list(tmp_path.iterdir())
    with pytest.raises(SystemExit):
        main(["--only", "operations", "--smallest", "--publish"])


def test_results_are_left_in_a_folder(tmp_path: Path) -> None:
    assert main(["--only", "operations", "--out", str(tmp_path)]) == 0
    (result,) = json.loads((tmp_path / "results.json").read_text(encoding="utf-8"))["results"]
    assert result["name"] == "operations" and all(line["value"] > 0 for line in result["lines"])
    assert result["title"] in (tmp_path / "results.md").read_text(encoding="utf-8")


def test_markers_in_pages_are_those_that_benchmarks_write() -> None:
    """Each names the benchmark that writes it, and all that one writes has a place."""
    written = {marker for tables in FIGURES.values() for marker in tables}
    assert set(figures.marked()) == written | {"hard_twins", "hard_twins.points"}
    for name, tables in FIGURES.items():
        assert name in BENCHMARKS and {marker.partition(".")[0] for marker in tables} == {name}


def marked_page(folder: Path, *markers: str) -> Path:
    page = folder / "page.md"
    blocks = [f"<!-- figures: {marker} -->\nold\n<!-- end -->\n" for marker in markers]
    page.write_text("before\n\n" + "\nbetween\n\n".join(blocks) + "\nafter\n", encoding="utf-8")
    return page


def test_figures_go_between_their_markers(tmp_path: Path) -> None:
    page = marked_page(tmp_path, "one", "one.more")
    figures.publish({"one": "new\n"}, tmp_path)
    figures.publish({"one": "newer \\1\n"}, tmp_path)
    first, second = page.read_text(encoding="utf-8").split("\nbetween\n")
    assert first == "before\n\n<!-- figures: one -->\nnewer \\1\n<!-- end -->\n"
    assert second == "\n<!-- figures: one.more -->\nold\n<!-- end -->\n\nafter\n"
    with pytest.raises(KeyError):
        figures.publish({"two": "new"}, tmp_path)
    page.write_text(page.read_text(encoding="utf-8") + "<!-- figures: two -->\n", encoding="utf-8")
    with pytest.raises(ValueError, match="no end of its own"):
        figures.marked(tmp_path)


def cell(delivered: float, price: float) -> dict[str, float]:
    return {"delivered": delivered, "price": price, "said": False}


MEASURED = {
    "tolerance": Result(
        "tolerance",
        "A",
        [],
        {"one": {"cells": [cell(0.5, 0.9), cell(4, 1.3)]}, "two": {"cells": [cell(1, float("nan"))]}},
    ),
    "arms": Result(
        "arms", "B", [], {"10 links, E x 100, exponential_rk4": {"steps": 22, "operations": 6235, "seconds": 4.2e-5}}
    ),
    "hard_steps": Result(
        "hard_steps",
        "C",
        [],
        {
            "arm": {"exponential_rk4": (30, 2e-5, 1e-3), "exponential_adams": (51, 1e-5, 1e-3)},
            "chain": {"dop853": (9, 1e-3, 1e-3)},
        },
    ),
    "scaling": Result(
        "scaling",
        "E",
        [],
        {
            "chain in a plane": {
                "this project": {str(n): {"first": 0.5 + 0 * n, "mb": 80.0, "step": 1e-7 * n} for n in (10, 100)},
                "other": {str(n): {"first": 1e-3 * n, "mb": 80.0, "step": 1e-8 * n**2} for n in (10, 100)},
            },
            "chain in space": {"this project": {"3": {"first": 1.0, "mb": 90.0, "step": 1e-6}}},
        },
    ),
    "others": Result(
        "others",
        "D",
        [Line("x", 1.0, "s")],
        {
            "suite": {
                "arm": {
                    "label": "exponential m=2",
                    "steps": 12,
                    "ms_a_second": 0.0123,
                    "cvodes": (62.4, 2.04),
                    "idas": (float("nan"), float("nan")),
                }
            },
            "exudyn": {
                "case": "arm_20",
                "label": "exponential_rk4",
                "steps": 67,
                "seconds": 1.8e-4,
                "kinds": {"cable": [("slow", float("nan"), "not met"), ("two", 459.0, "800 steps")]},
            },
            "rigid": {"10": {"steps": 80, "seconds": 2.7e-4, "theirs": {"aba": (1.21, "80 steps")}}},
        },
    ),
}
ROWS = {
    "tolerance": [
        "| delivered within what was asked | 66.7 % |",
        "| operations of all levels over those of the best single run, median | 1.1 |",
    ],
    "arms": ["| 10 | - | 22 steps of 6,235: 0.042 ms | - | - |"],
    "hard_steps": ["| arm | 1.00: 51 | 2.00: 30 | `exponential_adams`, 51 steps: 0.01 ms |"],
    "scaling": [
        "| to first step, s | this project | 0.5 | 0.5 | 0.00 |",
        "| a step, us | this project | 1 | 10 | 1.00 |",
        "| a step, us | other | 1 | 100 | 2.00 |",
    ],
    "scaling.space": ["| memory, MB | this project | 90 | - |"],
    "hard_steps.times": ["| chain | - | - | - | - | - | - | 1 | - |"],
    "others": ["| arm | `exponential` m=2, 12 | 0.0123 | 62 (2) | - |"],
    "others.programs": [
        "| `arm_20` to 1e-3 | `exponential_rk4`, 67 steps: 0.18 ms | two | 459 (800 steps) |",
        "| 10 rigid links, 1 s to 1e-6 | `dop853`, 80 steps: 0.27 ms | aba | 1.21 (80 steps) |",
    ],
}


def test_an_interrupted_run_keeps_and_publishes_what_it_has(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """All tables, written as soon as they are measured and once more from what was kept; the last one is broken
    off.
    """
    markers = [marker for tables in FIGURES.values() for marker in tables]
    page, evidence = marked_page(tmp_path, *markers), tmp_path / "evidence.md"
    evidence.write_text("# Benchmarks\n\n## Other\n\nstays\n", encoding="utf-8")
    monkeypatch.setattr(figures, "DOCS", tmp_path)
    monkeypatch.setattr(program, "PAGE", evidence)

    def broken() -> Result:
        raise KeyboardInterrupt

    for name, found in MEASURED.items():
        monkeypatch.setitem(BENCHMARKS, name, lambda found=found: found)
    monkeypatch.setitem(BENCHMARKS, "iftomm", broken)
    asked = [word for name in (*MEASURED, "iftomm") for word in ("--only", name)]
    with pytest.raises(KeyboardInterrupt):
        main([*asked, "--out", str(tmp_path / "out"), "--publish"])
    seen = page.read_text(encoding="utf-8")
    for marker in markers:
        text = figures.figures(marker)
        assert all(row in text.splitlines() for row in ROWS[marker]), (marker, text)
        assert f"Written by `python -m benchmarks --only {marker.partition('.')[0]} --publish`" in text
    assert "## Other\n\nstays" in evidence.read_text(encoding="utf-8") and "## D" in evidence.read_text(
        encoding="utf-8"
    )
    assert len(json.loads((tmp_path / "out" / "results.json").read_text(encoding="utf-8"))["results"]) == len(MEASURED)
    assert (tmp_path / "images" / "scaling.png").stat().st_size > 10_000
    marked_page(tmp_path, *markers)
    assert main([*asked, "--out", str(tmp_path / "out"), "--publish", "--kept"]) == 0
    assert page.read_text(encoding="utf-8") == seen


def test_rows_of_twins_replace_those_of_their_cases(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    page = tmp_path / "page.md"
    rows = "| f1_smooth | 1 | a |\n| chain | 2 | b |"
    page.write_text(
        f"<!-- figures: hard_twins -->\n| case | x | y |\n|---|---|---|\n{rows}\n<!-- end -->\n", encoding="utf-8"
    )
    monkeypatch.setattr(figures, "DOCS", tmp_path)
    monkeypatch.setattr(hard_twins, "compared", lambda case, by_points: (3e-9, case.name, 1.0))
    assert hard_twins.main(["--coordinates", "--only", "chain", "--only", "f1_rigid", "--publish"]) == 0
    assert figures.figures("hard_twins").splitlines()[2:] == [
        "| f1_smooth | 1 | a |", "| f1_rigid | 3e-09 | f1_rigid |", "| chain | 3e-09 | chain |"
    ]  # fmt: skip


def test_growth_finds_exponents_and_where_they_change() -> None:
    sizes = np.array([3, 10, 30, 100, 300, 1000.0])
    rough = np.array([1.02, 0.98, 1.01, 0.99, 1.0, 1.01])
    assert growth(sizes, 2.0 * sizes**1.3 * rough).at is None
    assert growth(sizes, 2.0 * sizes**1.3).exponents == pytest.approx((1.3,), abs=1e-9)
    broken = growth(sizes, np.where(sizes < 100, sizes, sizes**2 / 100))
    assert broken.at == 100 and broken.exponents == pytest.approx((1.0, 2.0), abs=1e-9)
    assert str(broken) == "1.00, from 100 on 2.00"


def test_programs_step_the_same_chain() -> None:
    """The same method: but for rounding, the same motion; Exudyn's own method to its order."""
    found = {}
    for name in installed("chain in a plane"):
        run = FAMILIES["chain in a plane"][name][1](4)
        run.advance(1999)
        found[name] = run.angles()
    assert np.ptp(found[OURS]) > 0.1  # it swings and bends
    for name, angles in found.items():
        assert np.abs(angles - found[OURS]).max() < (1e-4 if name == "Exudyn" else 1e-11), name
