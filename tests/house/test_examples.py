"""Every script in examples/ runs, stays short, and says what it should."""

from __future__ import annotations

import json
import re
import runpy
import sys
from pathlib import Path

import numpy as np
import pytest

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
ARGUMENTS = {"optimise_torque": ["20"], "parameter_study": ["0.05"]}  # shorter than by default
LONGEST = 60  # lines


def output(name: str, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> str:
    """What the script prints, run in an empty folder."""
    script = EXAMPLES / f"{name}.py"
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(sys, "argv", [str(script), *ARGUMENTS.get(name, [])])
    runpy.run_path(str(script), run_name="__main__")
    assert not list(tmp_path.iterdir()), "an example leaves files only where it is told to"
    return capsys.readouterr().out


def numbers(text: str) -> list[float]:
    return [float(number) for number in re.findall(r"-?\d+(?:\.\d+)?(?:e[+-]?\d+)?", text)]


def test_every_example_is_here() -> None:
    tested = {
        "build_slider_crank",
        "compare_schemes",
        "from_toml",
        "linear_structure",
        "optimise_torque",
        "parameter_study",
        "mesh_connecting_rod",
        "build_spatial_arm",
    }
    assert {path.stem for path in EXAMPLES.glob("*.py")} == tested


@pytest.mark.parametrize("path", sorted(EXAMPLES.glob("*.py")), ids=lambda path: path.stem)
def test_examples_are_short(path: Path) -> None:
    assert len(path.read_text(encoding="utf-8").splitlines()) < LONGEST


def test_build_slider_crank(capsys, monkeypatch, tmp_path) -> None:
    text = output("build_slider_crank", capsys, monkeypatch, tmp_path)
    assert text.startswith("completed at t = 0.2 s")
    assert numbers(text)[-1] < 0.05  # J, of an energy of about 20 J


def test_the_slider_crank_takes_25_lines_to_build() -> None:
    source = (EXAMPLES / "build_slider_crank.py").read_text(encoding="utf-8")
    body = source.split("    return (\n")[1].split("\n    )\n")[0]
    assert len(body.splitlines()) <= 25


def test_compare_schemes(capsys, monkeypatch, tmp_path) -> None:
    """Single-rate is second order; the printed scheme first order and worse, its growth follows the law; coupled
    sub-steps are second order and better, linearised ones exact to rounding."""
    lines = output("compare_schemes", capsys, monkeypatch, tmp_path).splitlines()
    single, *printed = (numbers(line.partition("m=")[2][1:] or line) for line in lines[1:5])
    assert single[-1] == pytest.approx(2.0, abs=0.05)
    for row in printed:
        assert row[-1] == pytest.approx(1.0, abs=0.1)
        assert row[0] > single[0]
    coupled, decoupled, linearised, exponential = (numbers(line.partition("m=")[2][1:]) for line in lines[5:9])
    for row in (coupled, decoupled):
        assert row[-1] == pytest.approx(2.0, abs=0.05)
        assert row[0] < 0.1 * single[0]
    assert max(linearised[:3] + exponential[:3]) < 1e-9
    measured, law = numbers(lines[-2])
    assert measured == pytest.approx(law, rel=0.05)


def test_parameter_study(capsys, monkeypatch, tmp_path) -> None:
    """A stiffer rod bends less."""
    rows = [numbers(line) for line in output("parameter_study", capsys, monkeypatch, tmp_path).splitlines()[2:]]
    deflections = [row[1] for row in rows]
    assert len(rows) == 5 and deflections == sorted(deflections, reverse=True)


def test_linear_structure(capsys, monkeypatch, tmp_path) -> None:
    rows = output("linear_structure", capsys, monkeypatch, tmp_path).splitlines()[1:]
    assert all(row.endswith("completed") for row in rows)
    errors = [float(row.split()[2]) for row in rows]
    ratios = [errors[k] / errors[k + 1] for k in (0, 2, 4)]
    assert ratios == pytest.approx([2.0, 4.0, 4.0], rel=0.1)  # (13) as printed costs an order


def test_from_toml(capsys, monkeypatch, tmp_path) -> None:
    text = output("from_toml", capsys, monkeypatch, tmp_path)
    assert text.count("height") == 5
    assert "did you mean 'mass'?" in text


def test_optimise_torque(capsys, monkeypatch, tmp_path) -> None:
    """Rest to rest: the optimal torque is odd about half time, and IPOPT is content."""
    text = output("optimise_torque", capsys, monkeypatch, tmp_path)
    assert "Solve_Succeeded" in text
    torques = [float(line.split()[-3]) for line in text.splitlines() if line.startswith("t = ")]
    assert torques[0] > 0.1
    assert torques == pytest.approx([-torque for torque in reversed(torques)], abs=1e-4)


def test_build_spatial_arm(capsys, monkeypatch, tmp_path) -> None:
    text = output("build_spatial_arm", capsys, monkeypatch, tmp_path)
    assert text.startswith("completed at t = 1 s")
    (balance,) = (numbers(line)[-1] for line in text.splitlines() if "balance" in line)
    assert balance < 1e-3  # J; the load is lifted by 0.1 m


def test_mesh_connecting_rod(capsys, monkeypatch, tmp_path, tmp_path_factory) -> None:
    """The data of the built-in scene is what the mesh gives, relative to each array's largest entry."""
    path = tmp_path_factory.mktemp("rod") / "rod.json"
    monkeypatch.setitem(ARGUMENTS, "mesh_connecting_rod", ["--out", str(path)])
    text = output("mesh_connecting_rod", capsys, monkeypatch, tmp_path)
    assert "5205 degrees of freedom" in text
    meshed = json.loads(path.read_text(encoding="utf-8"))
    kept = json.loads((EXAMPLES.parent / "symgen" / "scenes" / "connecting_rod.json").read_text(encoding="utf-8"))
    assert meshed.keys() == kept.keys()
    for key in meshed.keys() - {"markers"}:
        found, expected = np.asarray(meshed[key]), np.asarray(kept[key])
        assert np.abs(found - expected).max() <= 1e-8 * np.abs(expected).max()
