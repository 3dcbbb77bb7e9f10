"""The notebooks run from top to bottom, show something, and are kept without outputs.

Their cells are plain Python, so they are run here one after another in one namespace, as a kernel would, and what the
last line of a cell gives is asked for its picture. Jupyter itself would bring some fifty packages and three processes.
"""

from __future__ import annotations

import ast
import json
import runpy
from pathlib import Path
from typing import Any

import pytest

pytestmark = pytest.mark.long

ROOT = Path(__file__).resolve().parents[2]
NOTEBOOKS = sorted((ROOT / "notebooks").glob("*.ipynb"))
FORMS = ("_repr_html_", "_repr_png_")


def cells(path: Path, kind: str) -> list[str]:
    return [
        "".join(cell["source"])
        for cell in json.loads(path.read_text(encoding="utf-8"))["cells"]
        if cell["cell_type"] == kind
    ]


def run_cells(path: Path, folder: Path) -> tuple[dict[str, Any], int]:
    """The namespace at the end, and how many cells showed a picture or a card."""
    known: dict[str, Any] = {}
    shown = 0
    for k, text in enumerate(cells(path, "code")):
        tree = ast.parse(text)
        last = tree.body[-1]
        if isinstance(last, ast.Expr):
            tree.body[-1] = ast.Assign([ast.Name("_", ast.Store())], last.value)
        script = folder / f"cell_{k}.py"
        script.write_text(ast.unparse(ast.fix_missing_locations(tree)), encoding="utf-8")
        known = runpy.run_path(str(script), init_globals={**known, "_": None})
        found = [getattr(known["_"], form, lambda: None)() for form in FORMS]
        shown += any(content is not None and len(content) > 100 for content in found)
    return known, shown


def test_there_are_four_without_outputs() -> None:
    assert [path.stem for path in NOTEBOOKS] == [
        "design_study",
        "first_mechanism",
        "judge_the_schemes",
        "periodic_motions",
    ]
    for path in NOTEBOOKS:
        for cell in json.loads(path.read_text(encoding="utf-8"))["cells"]:
            assert not cell.get("outputs") and cell.get("execution_count") is None
        assert cells(path, "markdown")[0].startswith("# ")


def test_first_mechanism(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A heavier arm bends more; scene, model, run, three pictures and the page show themselves."""
    monkeypatch.chdir(tmp_path)
    known, shown = run_cells(ROOT / "notebooks" / "first_mechanism.ipynb", tmp_path)
    light, heavy = (abs(known[name]["arm.q1"]).max() for name in ("run", "heavy"))
    assert known["run"].status.ok and heavy > 1.2 * light
    assert shown == 7


def test_judge_the_schemes(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The printed scheme comes out as first order and grows without damping."""
    monkeypatch.chdir(tmp_path)
    known, shown = run_cells(ROOT / "notebooks" / "judge_the_schemes.ipynb", tmp_path)
    orders = known["orders"]
    assert orders["printed"] == pytest.approx(1.0, abs=0.25) and orders["rk4"] == pytest.approx(4.0, abs=0.3)
    assert not known["run"].status.ok
    assert shown == 5


def test_design_study(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Stiffer bends less; E and the second moment count alike, for only their product enters."""
    monkeypatch.chdir(tmp_path)
    known, shown = run_cells(ROOT / "notebooks" / "design_study.ipynb", tmp_path)
    assert known["bent"] == sorted(known["bent"], reverse=True)
    assert known["largest"](known["wanted"]) == pytest.approx(1e-4, rel=1e-3)
    found, values = known["found"], known["values"]
    first, second = (found[name] * values[name] for name in ("rod.youngs_modulus", "rod.second_moment"))
    assert first == pytest.approx(second, rel=1e-9) and first < 0
    assert shown == 1


def test_periodic_motions(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Two folds about the resonance, then the flip of parametric resonance; a thicker rod bends less."""
    monkeypatch.chdir(tmp_path)
    known, shown = run_cells(ROOT / "notebooks" / "periodic_motions.ipynb", tmp_path)
    assert [special.kind for special in known["branch"].specials] == ["fold", "fold", "flip"]
    assert known["found"].stability == "stable" and known["last"].floquet.kind == "flip"
    assert known["slopes"]["height"] < 0
    assert shown == 5
