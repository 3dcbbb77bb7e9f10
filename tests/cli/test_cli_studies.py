"""`symgen stability`, `periodic`, `converge` and `advise` as a user calls them."""

from __future__ import annotations

import csv
import json
from pathlib import Path

import numpy as np
import pytest

from symgen import Scene
from symgen.cli import main

pytestmark = pytest.mark.long

MOTION = ["two_oscillators", "--t-end", "3"]


def said(capsys: pytest.CaptureFixture[str], *words: str) -> tuple[int, str, str]:
    code = main(list(words))
    captured = capsys.readouterr()
    return code, captured.out, captured.err


def test_stability_leaves_its_chart(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    """Central difference on L1: the limit is 2 / w of the fastest coupled mode, for every m."""
    code, out, _ = said(
        capsys,
        "stability",
        *MOTION,
        "--scheme",
        "coupled",
        "--m",
        "2",
        "--m",
        "5",
        "--states",
        "1",
        "--points",
        "6",
        "--set",
        "k_L=0",
        "--set",
        "zeta=0",
        "--out",
        str(tmp_path),
        "--json",
    )
    assert code == 0
    limits = json.loads(out)["limits"]
    assert [row["m"] for row in limits] == [[2], [5]]
    with (tmp_path / "stability.csv").open() as lines:
        rows = list(csv.DictReader(lines))
    assert len(rows) == 12
    assert all(float(row["spectral_radius"]) > 0 for row in rows)
    assert (tmp_path / "stability.png").stat().st_size > 1000
    fine = [row["dt_S_limit"] for row in limits]
    assert fine[0] == pytest.approx(fine[1], rel=0.01)


CRANK = ["periodic", "flexible_slider_crank", "--speed", "omega", "--tolerance", "1e-3"]


def test_periodic_leaves_a_motion_or_a_branch(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    code, out, _ = said(capsys, *CRANK, "--set", "omega=140", "--out", str(tmp_path), "--json")
    found = json.loads(out)
    assert code == 0 and found["period"] == pytest.approx(2 * np.pi / 140) and 0 < found["error"] < 1e-3
    assert (tmp_path / "motion.csv").stat().st_size > 1000
    code, out, _ = said(
        capsys,
        *CRANK,
        "--over",
        "omega=140:141",
        "--flips",
        "1",
        "--output",
        "rod.q1",
        "--out",
        str(tmp_path),
        "--json",
    )
    found = json.loads(out)
    assert code == 0 and found["values"][0] == 140 and found["values"][-1] == 141 and found["stopped"] == ""
    with (tmp_path / "branch.csv").open() as lines:
        rows = list(csv.DictReader(lines))
    assert len(rows) == len(found["values"]) and all(float(row["rod.q1"]) > 0 for row in rows)
    assert (tmp_path / "branch.png").stat().st_size > 1000 and "rod.q1" in (tmp_path / "branch.html").read_text()
    for option in (["--flips", "1"], ["--resume", str(tmp_path)]):
        code, _, err = said(capsys, *CRANK, *option)
        assert code == 2 and f"{option[0]} needs --over" in err


def test_periodic_goes_on_after_ctrl_c(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    words = [*CRANK, "--over", "omega=140:141", "--resume", str(tmp_path), "--json"]

    def interrupt(self: object, value: float, last: float) -> None:
        if value > 140:
            raise KeyboardInterrupt

    with monkeypatch.context() as patch:
        patch.setattr("symgen.cli.outcome.Progress.__call__", interrupt)
        code, out, _ = said(capsys, *words)
    kept = json.loads(out)
    assert code == 130 and kept["stopped"] == "interrupted" and 140 < kept["values"][-1] < 141
    code, out, _ = said(capsys, *words)
    found = json.loads(out)
    assert code == 0 and found["values"][: len(kept["values"])] == kept["values"] and found["values"][-1] == 141
    assert max(found["errors"]) < 1e-3


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["--dt-from", "1e-3"], "belong together"),
        (["--dt-from", "1", "--dt-to", "0.1"], "below --dt-to"),
        (["--points", "1"], "--points must be"),
        (["--scheme", "nothing"], "no scheme 'nothing'"),
        (["--scheme", "coupled", "--m", "2,2"], "m must hold one number"),
        (["--option", "guess=x", "--scheme", "rk4"], "rk4 has no option"),
    ],
)
def test_stability_refuses(capsys: pytest.CaptureFixture[str], words: list[str], message: str) -> None:
    code, _, err = said(capsys, "stability", *MOTION, *words)
    assert code == 2
    assert message in err


def test_advise_ends_with_a_command(capsys: pytest.CaptureFixture[str]) -> None:
    code, out, _ = said(capsys, "advise", *MOTION, "--tolerance", "1e-2", "--graded", "x_L")
    assert code == 0
    words = out.strip().splitlines()[-1].partition("run it with: symgen ")[2].split()
    assert words[0] == "simulate"
    assert main([*words, "--t-end", "3"]) == 0


def test_advice_on_a_turning_body(capsys: pytest.CaptureFixture[str]) -> None:
    """The reference path tells Euler parameters; frequencies are looked at in turns and angular velocities."""
    code, out, _ = said(capsys, "advise", "tumbling_body", "--t-end", "0.2", "--tolerance", "1e-2")
    assert code == 0
    assert "run it with: symgen simulate tumbling_body" in out


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["--tolerance", "2"], "tolerance must be between 0 and 0.1"),
        (["--graded", "x_Q"], "'x_Q' cannot be graded"),
        (["--graded", ","], "at least one name"),
    ],
)
def test_advise_refuses(capsys: pytest.CaptureFixture[str], words: list[str], message: str) -> None:
    code, _, err = said(capsys, "advise", *MOTION, *words)
    assert code == 2
    assert message in err


def test_a_motion_without_result_is_a_numerical_failure(capsys: pytest.CaptureFixture[str]) -> None:
    code, _, err = said(capsys, "advise", *MOTION, "--set", "k_L=-1e6", "--initial", "x_L=1")
    assert code == 1
    assert "loosen the tolerance" in err


def test_advice_leaves_a_picture(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    code, out, _ = said(capsys, "advise", *MOTION, "--tolerance", "1e-2", "--out", str(tmp_path / "advice.png"))
    assert code == 0 and "advice.png" in out
    assert (tmp_path / "advice.png").read_bytes().startswith(b"\x89PNG")


def test_report_leaves_true_errors_and_times(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    """The advised step errs by less than the tolerance, by a reference that has no part in the advice."""
    code, out, _ = said(capsys, "report", *MOTION, "--tolerance", "1e-2", "--out", str(tmp_path), "--json")
    assert code == 0
    assert (tmp_path / "error_time.png").read_bytes().startswith(b"\x89PNG")
    advice = json.loads(out)["advice"]
    with (tmp_path / "methods.csv").open() as lines:
        rows = list(csv.DictReader(lines))
    best = next(one["method"] for one in advice["candidates"] if one["operations"] == advice["operations"])
    made = [row for row in rows if row["method"] == best and float(row["dt [s]"]) <= 1.01 * advice["dt"]]
    assert made and all(float(row["error"]) < 1e-2 and float(row["seconds [s]"]) > 0 for row in made)
    assert f"| {best} |" in (tmp_path / "methods.md").read_text()


SHELF = """
name = "shelf"
joints = [{type = "weld", name = "wall", marker_a = "ground.origin", marker_b = "arm.start"}]
loads = [{type = "distributed", name = "books", beam = "arm", components = [0.0, -20.0]}]
measures = [{type = "y", name = "tip", of = "arm.end"}]

[[bodies]]
type = "beam"
name = "arm"
length = 1.0
density = 7870.0
area = 4.2e-5
second_moment = 1.26e-10
youngs_modulus = 2e11
lateral = {ends = "clamped-free", modes = MODES}
"""


def test_converge_tells_the_error_of_the_model(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    """One shape of a cantilever: w L^4 / 8 EI is told within a factor 3, in all forms; also by a given model."""
    few, more, table = tmp_path / "few.toml", tmp_path / "more.toml", tmp_path / "table.csv"
    few.write_text(SHELF.replace("MODES", "1"))
    more.write_text(SHELF.replace("MODES", "3"))
    words = ["converge", str(few), "--equilibrium", "--knobs", "modes", "--out", str(table)]
    code, out, _ = said(capsys, *words, "--json")
    found = json.loads(out)["convergence"]["errors"]["tip"]
    true = abs(found["value"] + 20.0 / (8 * 25.2))
    assert code == 0 and true / 3 < found["error"] < 3 * true
    with table.open() as lines:
        (row,) = csv.DictReader(lines)
    assert row["knob"] == "arm.modes" and row["says"] == "error" and float(row["error"]) == found["error"]
    code, out, _ = said(capsys, *words, "--finer", f"arm.hand={more}")
    assert code == 0 and "arm.modes 1 -> 3" in out and "arm.hand" in out and "cannot be turned: arm.shear" in out
    code, out, _ = said(capsys, "converge", str(few), "--t-end", "0.02", "--outputs", "tip", "--reduce", "peak,end")
    assert code == 0 and "tip peak" in out and "tip end" in out
    for wrong, message in ((["--reduce", "end"], "--outputs"), (["--knobs", "mode"], "arm.modes")):
        code, _, err = said(capsys, "converge", str(few), *wrong)
        assert code == 2 and message in err


def test_simulate_leaves_the_error_of_the_model(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    """Of two welded pieces half of them tell it: in the summary, in report.json and on the page; `off` says so."""
    scene = Scene("swing").gravity(0.0, -9.81)
    for k, last in enumerate(("ground.origin", "piece0.end")):
        scene.beam(f"piece{k}", length=0.5, density=7870.0, area=4.2e-5, second_moment=1.26e-10, youngs_modulus=2e11,
                   lateral={"modes": 1})  # fmt: skip
        scene.joint("weld" if k else "revolute", f"joint{k}", last, f"piece{k}.start")
    scene.measure("tip", "y", of="piece1.end").to_toml(tmp_path / "swing.toml")
    words = ["simulate", str(tmp_path / "swing.toml"), "--t-end", "0.2", "--out", str(tmp_path / "out")]
    code, out, _ = said(capsys, *words)
    assert code == 0 and "turned piece0.pieces 2 -> 1" in out and "not turned: piece0.modes" in out
    told = json.loads((tmp_path / "out" / "report.json").read_text())["modelling_error"]["errors"]["tip"]
    assert told["error"] > 0 and told["knob"] == "piece0.pieces"
    assert "turned piece0.pieces" in (tmp_path / "out" / "page.html").read_text(encoding="utf-8")
    code, out, _ = said(capsys, *words, "--convergence", "off")
    assert code == 0 and "error of the model not estimated: it was switched off" in out
