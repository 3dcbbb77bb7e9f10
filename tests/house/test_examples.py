"""Every script in examples/ runs, draws its picture, and says figures that only right physics gives."""

from __future__ import annotations

import json
import re
import runpy
from pathlib import Path

import numpy as np
import pytest

from runtime.contract.records import unpacked
from tests.support.printed_numbers import line, numbers

pytestmark = pytest.mark.long

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
LAST_LINES = ['if __name__ == "__main__":', "    main(*map(Path, sys.argv[1:]))"]


def test_every_example_is_tested_and_in_the_gallery() -> None:
    tests = "".join(path.read_text(encoding="utf-8") for path in Path(__file__).parent.glob("test_*examples.py"))
    docs = EXAMPLES.parent / "docs"
    gallery = (docs / "gallery.md").read_text(encoding="utf-8")
    assert gallery == runpy.run_path(str(docs / "make_gallery.py"))["page"](), "run: python docs/make_gallery.py NAME"
    names = {path.stem for path in EXAMPLES.glob("*.py")}
    assert set(re.findall(r'said\("(\w+)"', tests)) == names
    assert set(re.findall(r"\(\.\./examples/(\w+)\.py\)", gallery)) == names
    assert len(names) >= 15


@pytest.mark.parametrize("path", sorted(EXAMPLES.glob("*.py")), ids=lambda path: path.stem)
def test_examples_end_alike(path: Path) -> None:
    assert path.read_text(encoding="utf-8").splitlines()[-2:] == LAST_LINES


def test_build_slider_crank(said) -> None:
    text = said("build_slider_crank")
    assert text.startswith("completed at t = 0.2 s")
    assert numbers(text)[-1] < 0.05  # J, of an energy of about 20 J


def test_speed_loop(said) -> None:
    """The loop has the frequency and damping that it was designed for; both controllers follow their closed forms."""
    text = said("speed_loop")
    assert line(text, "loop") == pytest.approx([5, 0.6, 5, 0.6], abs=1e-8)
    assert line(text, "inside off the closed form by")[0] < 1e-9
    assert line(text, "outside off the difference equation by")[0] < 1e-12


def test_compare_schemes(said) -> None:
    """Single-rate is second order; the printed scheme first order and worse, its growth follows the law; coupled
    sub-steps are second order and better, exponential ones exact to rounding."""
    lines = said("compare_schemes").splitlines()
    single, *printed = (numbers(line.partition("m=")[2][1:] or line) for line in lines[1:5])
    assert single[-1] == pytest.approx(2.0, abs=0.05)
    for row in printed:
        assert row[-1] == pytest.approx(1.0, abs=0.1) and row[0] > single[0]
    coupled, exponential = (numbers(line.partition("m=")[2][1:]) for line in lines[5:7])
    assert coupled[-1] == pytest.approx(2.0, abs=0.05) and coupled[0] < 0.1 * single[0]
    assert max(exponential[:3]) < 1e-9
    measured, law = numbers(lines[-2])
    assert measured == pytest.approx(law, rel=0.05)


def test_parameter_study(said) -> None:
    """A stiffer rod bends less."""
    rows = [numbers(line) for line in said("parameter_study").splitlines()[2:]]
    deflections = [row[1] for row in rows]
    assert len(rows) == 5 and deflections == sorted(deflections, reverse=True)


def test_linear_structure(said) -> None:
    rows = said("linear_structure").splitlines()[1:]
    assert all(row.endswith("completed") for row in rows)
    errors = [float(row.split()[2]) for row in rows]
    ratios = [errors[k] / errors[k + 1] for k in (0, 2, 4)]
    assert ratios == pytest.approx([2.0, 4.0, 4.0], rel=0.1)  # (13) as printed costs an order


def test_from_toml(said) -> None:
    text = said("from_toml")
    assert text.count("height") == 5 and "did you mean 'mass'?" in text


def test_optimise_torque(said) -> None:
    """Rest to rest: the optimal torque is odd about half time, and IPOPT is content."""
    text = said("optimise_torque")
    assert "Solve_Succeeded" in text
    torques = [float(line.split()[-3]) for line in text.splitlines() if line.startswith("t = ")]
    assert torques[0] > 0.1 and torques == pytest.approx([-torque for torque in reversed(torques)], abs=1e-4)


def test_identify_hub_beam(said) -> None:
    """Of each unknown the interval is narrow, and holds the truth or nearly so; the noise is found too."""
    text = said("identify_hub_beam")
    rows = [numbers(row.partition("from")[2]) for row in text.splitlines() if "95 % from" in row]
    assert len(rows) == 3
    for low, high, truth in rows:
        assert low - (high - low) < truth < high + (high - low) and high - low < 0.2 * truth
    found, given = line(text, "noise")
    assert found == pytest.approx(given, rel=0.2)


def test_design_rod(said) -> None:
    """A rod of the same mass that is thick in the middle bends a fifth less."""
    text = said("design_rod")
    assert text.startswith("Optimization terminated successfully")
    heel, middle, toe, peak = line(text, "best")
    assert heel + middle + toe == pytest.approx(24.0, abs=0.016) and middle > max(heel, toe)
    assert peak < 0.85 * line(text, "uniform")[-1]


def test_build_spatial_arm(said) -> None:
    text = said("build_spatial_arm")
    assert text.startswith("completed at t = 1 s")
    assert line(text, "energy balance within")[0] < 1e-3  # J; the load is lifted by 0.1 m


def test_mesh_connecting_rod(said, tmp_path) -> None:
    """The data of the built-in scene is what the mesh gives, relative to each array's largest entry."""
    path = tmp_path / "rod.json"
    assert "5205 degrees of freedom" in said("mesh_connecting_rod", out=path)
    meshed = json.loads(path.read_text(encoding="utf-8"))
    kept = json.loads((EXAMPLES.parent / "symgen" / "scenes" / "connecting_rod.json").read_text(encoding="utf-8"))
    assert meshed.keys() == kept.keys()
    for key in ("vertices", "triangles", "shapes", "stresses"):
        kind = "<i4" if key == "triangles" else "<f4"
        found, expected = (unpacked(data["surface"][key], kind) for data in (meshed, kept))
        assert np.abs(found - expected).max() <= 1e-5 * np.abs(expected).max()
    for key in meshed.keys() - {"markers", "surface"}:
        both = (list(one[key][0].values())[1:] if key == "struts" else one[key] for one in (meshed, kept))
        found, expected = map(np.asarray, both)
        assert np.abs(found - expected).max() <= 1e-8 * np.abs(expected).max()


def test_five_bar_robot(said) -> None:
    """The tool is where two circles meet; the motors' power is the change of the energy."""
    text = said("five_bar_robot")
    assert line(text, "tool off the closed form by")[0] < 1e-14
    assert line(text, "power off the change of energy by")[0] < 1e-3  # of a spline through the samples


def test_quick_return(said) -> None:
    text = said("quick_return")
    error, largest = line(text, "torque off the closed form by")
    assert error < 1e-11 and largest > 5.0
    ratio, closed_form = line(text, "time ratio")
    assert ratio == pytest.approx(closed_form, abs=2 * 1.7 / 150)  # a sample more or less on the way back


def test_end_stops(said) -> None:
    assert line(text := said("end_stops"), "touches") == [8, 8] and text.startswith("event at")
    assert np.diff(line(text, "time of a swing"))[0] == pytest.approx(0.0, abs=1e-5)


def test_stacked_balls(said) -> None:
    assert (text := said("stacked_balls")).startswith("completed")
    assert np.diff(line(text, "thrown to"))[0] == pytest.approx(0.0, abs=2e-4)  # between two samples
    assert np.diff(line(text, "the block sticks at"))[0] == pytest.approx(0.0, abs=1e-8)
    assert line(text, "fastest in the end")[0] < 1e-9


def test_bouncing_ball(said) -> None:
    text = said("bouncing_ball")
    height, closed_form = line(text, "first bounce")
    assert text.startswith("completed") and height == pytest.approx(closed_form, rel=1e-2)
    speed, by_momentum = line(text, "rolls in the end")
    assert speed == pytest.approx(by_momentum, abs=2e-5)


def test_crane(said) -> None:
    """What is left of the swing: 4 a / g after half a period of pushing, nothing after a whole one."""
    abrupt, shaped = (numbers(row) for row in said("crane").splitlines()[1:3])
    assert abrupt[0] == pytest.approx(abrupt[1], rel=5e-3)
    assert shaped[0] < 1e-2
