"""Branches of twice the period: Duffing's oscillator with two wells, against shooting by SciPy."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from runtime import Model, periodic_over
from runtime.orbits.branch import PeriodicBranch
from symgen.scene import Scene, SceneRecord
from tests.support.browser import used

pytestmark = pytest.mark.long

Build = Callable[[SceneRecord], Model]
DAMPING, OMEGA = 0.3, 1.2
PERIOD = 2 * np.pi / OMEGA

SLID = """
const slider = document.getElementById("point");
slider.value = LAST;
slider.dispatchEvent(new Event("input"));
const said = ["value", "motion"].map((id) => document.getElementById(id).textContent);
const dashed = document.querySelectorAll("#branch [stroke-dasharray]").length;
document.documentElement.dataset.probe = JSON.stringify([...said, dashed]);
"""


@pytest.fixture(scope="module")
def wells(model_of: Build) -> Model:
    """x'' + 0.3 x' - x + x^3 = gamma cos 1.2 t."""
    builder = Scene("two_wells").parameter("gamma", 0.2).rigid("mass", mass=1.0, inertia=1.0)
    builder.prismatic("rail", "ground.origin", "mass.origin").measure("x", "x", "mass.origin")
    builder.force("f", "mass.origin", f"x-x*x*x-{DAMPING}*x_dot+gamma*cos({OMEGA}*t)", 0.0)
    return model_of(builder.initial({"mass.x": 1.0}).simulation(t_end=10.0, dt=1e-2, scheme="rk4").build())


@pytest.fixture(scope="module")
def cascade(wells: Model) -> PeriodicBranch:
    return periodic_over(wells, "gamma", (0.2, 0.32), period=PERIOD, scheme="dop853", tolerance=1e-9, flips=1)


def by_scipy(gamma: float, state: np.ndarray, periods: int) -> tuple[np.ndarray, float]:
    """(the state that repeats after so many periods of the drive, its least multiplier), by Newton's method."""

    def motion(t: float, z: np.ndarray) -> np.ndarray:
        x, v = z[:2]
        slope = np.array([[0.0, 1.0], [1 - 3 * x * x, -DAMPING]]) @ z[2:].reshape(2, 2)
        return np.array([v, x - x**3 - DAMPING * v + gamma * np.cos(OMEGA * t), *slope.ravel()])

    for _ in range(20):
        start = np.concatenate([state, np.eye(2).ravel()])
        end = solve_ivp(motion, (0.0, periods * PERIOD), start, "DOP853", rtol=1e-12, atol=1e-13).y[:, -1]
        monodromy = end[2:].reshape(2, 2)
        step = np.linalg.solve(np.eye(2) - monodromy, end[:2] - state)
        state = state + step
        if np.abs(step).max() < 1e-11:
            break
    return state, float(np.linalg.eigvals(monodromy).real.min())


@pytest.mark.parametrize("doublings", [0, 1])
def test_flips_are_where_scipy_finds_them(cascade: PeriodicBranch, doublings: int) -> None:
    branch = cascade if doublings == 0 else cascade.branches[0]
    (flip,) = [one for one in branch.specials if one.kind == "flip"]

    def least(gamma: float) -> float:
        return by_scipy(gamma, flip.state, 1 + doublings)[1] + 1.0

    assert flip.value == pytest.approx(brentq(least, flip.value - 1e-4, flip.value + 1e-4, xtol=1e-12), abs=1e-8)


def test_the_branch_of_twice_the_period_leaves_at_the_flip(cascade: PeriodicBranch) -> None:
    (flip,) = [one for one in cascade.specials if one.kind == "flip"]
    (branch,) = cascade.branches
    assert branch.values[0] == flip.value and branch.periods == pytest.approx(2 * cascade.periods[0])
    assert cascade.stability[0] == "stable" and cascade.stability[-1] == "unstable"
    assert branch.stability[1] == "stable" and branch.stability[-1] == "unstable"
    for k in (2, len(branch.points) - 2):
        point = branch.points[k]
        assert point.x[0] == pytest.approx(by_scipy(point.value, point.x[0], 2)[0], abs=1e-8)
        assert np.abs(point.x[1] - point.x[0]).max() > 1e-3  # it does not repeat after one
    away = [np.abs(point.x[1] - point.x[0]).max() ** 2 / (point.value - flip.value) for point in branch.points[1:4]]
    assert away == pytest.approx([away[0]] * 3, rel=0.2)  # the parameter moves with the square of the distance
    assert branch.motion(3).period == pytest.approx(2 * PERIOD)


def test_branches_of_twice_the_period_go_on_from_their_folder(wells: Model, tmp_path: Path) -> None:
    how = {"period": PERIOD, "scheme": "dop853", "steps": 100, "flips": 1, "resume": tmp_path}
    seen: list[float] = []

    def stop(value: float, end: float) -> None:
        seen.append(value)
        if len(list(tmp_path.iterdir())) == 2 and len(seen) > 20:
            raise KeyboardInterrupt

    part = periodic_over(wells, "gamma", (0.2, 0.32), progress=stop, **how)
    assert part.stopped == "interrupted" and part.branches[0].stopped == "interrupted"
    count = len(part.branches[0].points)
    rest = periodic_over(wells, "gamma", (0.2, 0.32), **how)
    assert not rest.stopped and rest.values == pytest.approx(part.values, abs=0)
    assert rest.branches[0].values[:count] == pytest.approx(part.branches[0].values, abs=0)
    assert rest.branches[0].values[-1] == 0.32 and rest.branches[0].first.doublings == 1


def test_tables_and_pictures_hold_all_branches(cascade: PeriodicBranch, tmp_path: Path) -> None:
    cascade.write_csv(tmp_path / "branch.csv", ["mass.x"])
    rows = (tmp_path / "branch.csv").read_text().splitlines()
    assert len(rows) == 1 + len(cascade.points) + len(cascade.branches[0].points)
    assert rows[0].endswith(",doublings,error")
    assert rows[-1].split(",")[-2] == "1" and rows[1].split(",")[-2] == "0" and float(rows[1].split(",")[-1]) < 1e-9
    lines = cascade.picture("mass.x", tmp_path / "branch.png").axes[0].lines
    assert {"-", "--"} <= {line.get_linestyle() for line in lines}


def test_the_slider_of_the_page_chooses_the_motion(cascade: PeriodicBranch, tmp_path: Path) -> None:
    page = cascade.view(tmp_path / "branch.html", ["mass.x", "mass.x_dot"])
    assert (tmp_path / "branch.html").read_text() == page.text and len(page.text) < 400_000
    last = len(cascade.points) + len(cascade.branches[0].points) - 1
    found = used(page.text, tmp_path, SLID.replace("LAST", str(last)))
    assert "error" not in found and found["ready"] == "1" and found["motion"] == str(last)
    value, motion, dashed = found["probe"]
    assert value == "gamma [-] = 0.32" and "unstable" in motion and "1 doublings" in motion
    assert dashed == sum(branch.stability[:-1].count("unstable") for branch in cascade.all)
