"""`python -m benchmarks` knows every benchmark and every computed page, and leaves its results."""

from __future__ import annotations

import json
from importlib import import_module
from pathlib import Path

from benchmarks.__main__ import BENCHMARKS, PAGES, main

FOLDER = Path(__file__).resolve().parents[2] / "benchmarks"


def modules(shelf: str) -> list[str]:
    return [path.stem for path in (FOLDER / shelf).glob("*.py") if path.stem != "__init__"]


def test_the_command_runs_everything() -> None:
    cases = {name for name in modules("cases") if hasattr(import_module(f"benchmarks.cases.{name}"), "run")}
    assert set(BENCHMARKS) == cases
    assert set(PAGES) == set(modules("pages"))


def test_results_are_left_in_a_folder(tmp_path: Path) -> None:
    assert main(["--only", "operations", "--out", str(tmp_path)]) == 0
    (result,) = json.loads((tmp_path / "results.json").read_text(encoding="utf-8"))["results"]
    assert result["name"] == "operations" and all(line["value"] > 0 for line in result["lines"])
    assert result["title"] in (tmp_path / "results.md").read_text(encoding="utf-8")
