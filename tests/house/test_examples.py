"""Every script in examples/ runs, stays short, draws its picture, and says figures that only right physics gives."""

from __future__ import annotations

import json
import re
import runpy
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

from runtime.contract.packing import unpacked
from tests.support.printed_numbers import line, numbers

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
SMALLER: dict[str, dict[str, Any]] = {"optimise_torque": {"intervals": 20}, "parameter_study": {"t_end": 0.05}}
LONGEST = 70  # lines
LAST_LINES = ['if __name__ == "__main__":', "    main(*map(Path, sys.argv[1:]))"]


@pytest.fixture
def said(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Any:
    """What an example prints as it draws its picture; it leaves nothing else in the folder where it runs."""

    def run(name: str, **settings: Any) -> str:
        (tmp_path / "empty").mkdir()
        monkeypatch.chdir(tmp_path / "empty")
        picture = tmp_path / f"{name}.png"
        runpy.run_path(str(EXAMPLES / f"{name}.py"), run_name=name)["main"](
            picture, **SMALLER.get(name, {}), **settings
        )
        assert not list(Path.cwd().iterdir()), "an example leaves files only where it is told to"
        with Image.open(picture) as image:
            assert image.width > 600 and len(set(image.convert("L").resize((60, 40)).tobytes())) > 10
        return capsys.readouterr().out

    return run


def test_every_example_is_tested_and_in_the_gallery() -> None:
    tests = Path(__file__).read_text(encoding="utf-8")
    docs = EXAMPLES.parent / "docs"
    gallery = (docs / "gallery.md").read_text(encoding="utf-8")
    assert gallery == runpy.run_path(str(docs / "make_gallery.py"))["page"](), "run: python docs/make_gallery.py NAME"
    names = {path.stem for path in EXAMPLES.glob("*.py")}
    assert set(re.findall(r'said\("(\w+)"', tests)) == names
    assert set(re.findall(r"\(\.\./examples/(\w+)\.py\)", gallery)) == names
    assert len(names) >= 15


@pytest.mark.parametrize("path", sorted(EXAMPLES.glob("*.py")), ids=lambda path: path.stem)
def test_examples_are_short_and_alike(path: Path) -> None:
    lines = path.read_text(encoding="utf-8").splitlines()
    assert len(lines) <= LONGEST and lines[-2:] == LAST_LINES


def test_build_slider_crank(said) -> None:
    text = said("build_slider_crank")
    assert text.startswith("completed at t = 0.2 s")
    assert numbers(text)[-1] < 0.05  # J, of an energy of about 20 J


def test_the_slider_crank_takes_25_lines_to_build() -> None:
    source = (EXAMPLES / "build_slider_crank.py").read_text(encoding="utf-8")
    body = source.split("    return (\n")[1].split("\n    )\n")[0]
    assert len(body.splitlines()) <= 25


def test_speed_loop(said) -> None:
    """The loop has the frequency and damping that it was designed for; both controllers follow their closed forms."""
    text = said("speed_loop")
    assert line(text, "loop") == pytest.approx([5, 0.6, 5, 0.6], abs=1e-8)
    assert line(text, "inside off the closed form by")[0] < 1e-9
    assert line(text, "outside off the difference equation by")[0] < 1e-12


def test_compare_schemes(said) -> None:
    """Single-rate is second order; the printed scheme first order and worse, its growth follows the law; coupled
    sub-steps are second order and better, linearised ones exact to rounding."""
    lines = said("compare_schemes").splitlines()
    single, *printed = (numbers(line.partition("m=")[2][1:] or line) for line in lines[1:5])
    assert single[-1] == pytest.approx(2.0, abs=0.05)
    for row in printed:
        assert row[-1] == pytest.approx(1.0, abs=0.1) and row[0] > single[0]
    coupled, decoupled, linearised, exponential = (numbers(line.partition("m=")[2][1:]) for line in lines[5:9])
    for row in (coupled, decoupled):
        assert row[-1] == pytest.approx(2.0, abs=0.05)
        assert row[0] < 0.1 * single[0]
    assert max(linearised[:3] + exponential[:3]) < 1e-9
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


def test_crane(said) -> None:
    """What is left of the swing: 4 a / g after half a period of pushing, nothing after a whole one."""
    abrupt, shaped = (numbers(row) for row in said("crane").splitlines()[1:3])
    assert abrupt[0] == pytest.approx(abrupt[1], rel=5e-3)
    assert shaped[0] < 1e-2


def test_double_wishbone(said) -> None:
    text = said("double_wishbone")
    force, weight = line(text, "tyre at rest")
    assert force == pytest.approx(weight, rel=5e-4)
    assert numbers(text.splitlines()[0])[-1] < 0.05  # J, of some 400 J


def test_spinning_satellite(said) -> None:
    """The momentum decides what is left: the least energy, and an axis along the momentum, 12 degrees off at first."""
    text = said("spinning_satellite")
    first, last = line(text, "angle to the angular momentum")
    assert first > 11.9 and last < 1.5
    at_first, at_last, least = line(text, "energy")
    assert least < at_last < least + 0.05 * (at_first - least)


def test_rotor_blades(said) -> None:
    rows = [numbers(row) for row in said("rotor_blades").splitlines()[1:5]]
    for _, found, published in rows:
        assert found == pytest.approx(published, rel=5e-4)


def test_tumbling_body(said) -> None:
    text = said("tumbling_body")
    found, elliptic = line(text, "turns over every")
    assert found == pytest.approx(elliptic, rel=5e-4)
    assert max(line(text, "momentum changes by")) < 1e-5


def test_gyroscope(said) -> None:
    text = said("gyroscope")
    found, closed_form = line(text, "goes round at")
    assert found == pytest.approx(closed_form, rel=1e-6)
    even, free = line(text, "nods by")
    assert even < 1e-5 and free > 30.0
    found, closed_form = line(text, "lowest tilt")
    assert found == pytest.approx(closed_form, abs=1e-2)


def test_spin_up(said) -> None:
    """The figures of case F3 in docs/evidence/cases.md."""
    text = said("spin_up")
    assert line(text, "largest lag") == pytest.approx([-0.57438, 3.64e-3], rel=3e-3)
    assert "without stiffening: deflection_too_large" in text


def test_four_bar_crossing(said) -> None:
    text = said("four_bar_crossing")
    assert "10 singular positions passed" in text
    found, integral = line(text, "one turn takes")
    assert found == pytest.approx(integral, rel=1e-4)


def test_hanging_chain(said) -> None:
    """Links of an eighth of a metre stay within 3 mm of the catenary, and the chain is as its mirror image."""
    text = said("hanging_chain")
    assert "stable: True" in text
    assert line(text, "joints off the catenary by")[0] < 3e-3
    assert line(text, "left and right alike to")[0] < 1e-9


def test_cart_pole(said) -> None:
    text = said("cart_pole")
    found, closed_form = line(text, "unstable root")
    assert found == pytest.approx(closed_form, rel=1e-6)
    assert max(map(abs, line(text, "after 5 s: cart at"))) < 1e-2


def test_finite_element_bar(said) -> None:
    """The bar rings as its mesh says, and a clamped end that holds the width makes it 0.8 % stiffer than a beam."""
    _, measured, mesh, beam = numbers(said("finite_element_bar").splitlines()[1])
    assert measured == pytest.approx(mesh, rel=1e-3)
    assert mesh == pytest.approx(beam, rel=0.012) and mesh > beam


def test_partitioned_bar(said) -> None:
    """First order against an exact treatment of the fine part; one step for all would be four times too long."""
    text = said("partitioned_bar")
    assert line(text, "printed: off d'Alembert's solution by")[0] < 0.03
    assert line(text, "linearised: off d'Alembert's solution by")[0] < 0.006
    assert "for all: step_too_long" in text


def test_floating_frame(said) -> None:
    text = said("floating_frame")
    *found, one, two, three = line(text, "coupling M_LS")
    assert found == pytest.approx([one, two, three], rel=2e-3)
    *masses, exact = line(text, "modal masses M_SS")
    assert masses == pytest.approx([exact] * 3, rel=2e-3)


def test_monte_carlo(said) -> None:
    """Every case comes to its end; speed decides, and the linear fit leaves no more than a few percent unexplained."""
    text = said("monte_carlo")
    assert text.startswith("2000 of 2000 cases")
    middle, _, low, high = line(text, "peak deflection")
    assert 0 < low < middle < high < 1.2 * middle
    speed, *others = (numbers(row.partition(":")[2])[0] for row in text.splitlines()[2:])
    assert speed > 90 and 95 < speed + sum(others) < 101


@pytest.mark.skipif(find_spec("distributed") is None, reason="needs the extra dask: pip install 'symgen[dask]'")
def test_ensemble_on_dask(said) -> None:
    """A cluster of two processes gives the bits of one."""
    assert said("ensemble_on_dask").splitlines() == ["2 workers, 6000 cases", "equal bit for bit: True"]
