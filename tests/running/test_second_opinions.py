"""A run that its estimate condemns is compared with a finer one: forces faster than the steps, and lost motions."""

from __future__ import annotations

import signal
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from runtime import Model, simulate
from runtime.running import outcome
from runtime.running.calibration import Calibration
from symgen.scene import Scene, SceneBuilder

Build = Callable[[Scene], Model]
SETTINGS = {
    "single_rate": {"dt": 0.01},
    "exponential": {"dt": 0.05},
    "rk4": {"dt": 0.05},
    "dopri5": {"tolerance": 1e-2},
    "exponential_rk4": {"tolerance": 1e-2},
}


def shaken() -> Scene:
    """theta'' = 0.2 cos t + 20 sin(f t)^8 about a pin: a fast force whose mean moves the rod."""
    builder = SceneBuilder("shaken").rigid("rod", mass=1.0, inertia=0.1).parameter("f", 10.0)
    builder.revolute("pin", "ground.origin", "rod.origin")
    builder.torque("drive", "rod.origin", "0.02*cos(t) + 2*sin(f*t)**8")
    return builder.simulation(t_end=5.0, dt=0.05, scheme="rk4").build()


def let_go(torque: str, t_end: float) -> Scene:
    """theta'' = torque from theta = 1 at rest."""
    builder = SceneBuilder("let_go").rigid("rod", mass=1.0, inertia=1.0)
    builder.revolute("pin", "ground.origin", "rod.origin").measure_coordinate("a", "rod.theta")
    builder.torque("drive", "rod.origin", torque).initial({"rod.theta": 1.0})
    return builder.simulation(t_end=t_end, dt=t_end / 200, scheme="dopri5").build()


@pytest.mark.parametrize(("scheme", "tolerance"), [("exponential", 1e-2), ("exponential", 1e-3)])
def test_work_that_long_steps_know_badly_ends_no_run(model_of: Build, scheme: str, tolerance: float) -> None:
    """theta'' = -3 theta' - 40 theta, by hand: it was `diverged` at 0.7 s by the work of the first steps."""
    run = simulate(model_of(let_go("-3*a_dot - 40*a", 10.0)), scheme=scheme, tolerance=tolerance)
    w = np.sqrt(40 - 1.5**2)
    exact = np.exp(-1.5 * run.t) * (np.cos(w * run.t) + 1.5 / w * np.sin(w * run.t))
    off = np.sqrt(np.mean((run["rod.theta"] - exact) ** 2)) / exact.std()
    assert run.status.name == "completed" and off < 2 * tolerance


def test_a_tolerance_that_was_not_kept_is_said(model_of: Build, monkeypatch: pytest.MonkeyPatch) -> None:
    """A run with ten times the error that its trials have told, of cos(sqrt(40) t); one that keeps it says nothing."""
    model, told = model_of(let_go("-40*a", 2.0)), Calibration.told
    settings: dict[str, Any] = {"scheme": "dopri5", "tolerance": 1e-3}
    kept = simulate(model, **settings)
    assert "error_over_tolerance" not in kept.stats and "remark" not in kept.stats
    monkeypatch.setattr("runtime.running.trials.AIM", 8.0)
    monkeypatch.setattr(Calibration, "told", lambda known: {**told(known), "expected_error": 6e-4})
    run = simulate(model, **settings)
    off = float(np.abs(run["rod.theta"] - np.cos(np.sqrt(40) * run.t)).max())
    assert run.stats["error_over_tolerance"] == pytest.approx(off / 1e-3, rel=0.5) and off > 3e-3
    assert "0.001 was asked" in str(run.stats["remark"])


def turned(f: float, t: np.ndarray) -> np.ndarray:
    """sin^8 = 35/128 - 7/16 cos 2x + 7/32 cos 4x - 1/16 cos 6x + 1/128 cos 8x, integrated twice from rest."""
    found = 0.2 * (1 - np.cos(t)) + 20 * 35 / 256 * t**2
    for k, share in ((2, -7 / 16), (4, 7 / 32), (6, -1 / 16), (8, 1 / 128)):
        found += 20 * share * (1 - np.cos(k * f * t)) / (k * f) ** 2
    return found


@pytest.mark.parametrize(
    ("scheme", "f", "right"),
    [
        ("single_rate", 10.0, True),  # windows say 0.13, 2, 0.5 and 2 of the amplitude of the first four
        ("single_rate", 100.0, True),
        ("dopri5", 100.0, True),
        ("exponential_rk4", 100.0, True),
        ("rk4", 10 * np.pi, False),  # every step sees the force at its zeros and peaks only
        ("exponential", 10 * np.pi, False),
        ("single_rate", 200 * np.pi, False),  # the same force at all ends of steps, of finer ones too
    ],
)
def test_forces_faster_than_the_steps(model_of: Build, scheme: str, f: float, right: bool) -> None:
    run = simulate(model_of(shaken()), scheme=scheme, parameters={"f": f}, **SETTINGS[scheme])  # type: ignore[arg-type]
    exact = turned(f, run.t)
    off, amplitude = float(np.abs(run["rod.theta"] - exact).max()), float(np.ptp(exact) / 2)
    true = off / amplitude
    assert run.status.name == ("completed" if right else "inaccurate") and (true < 0.02 if right else true > 0.1)
    said = float(run.stats["estimated_error.rod.theta"])
    assert off / 10 < said < max(10 * off, 0.01 * amplitude) and ("remark" in run.stats) == (not right)


def test_ctrl_c_in_the_second_opinion_leaves_the_run(model_of: Build, monkeypatch: pytest.MonkeyPatch) -> None:
    """It stays what its estimate made of it; a finer motion would tell that it is right, see above."""

    def pressed(*_: object) -> None:
        signal.raise_signal(signal.SIGINT)

    monkeypatch.setattr(outcome, "measured_errors", pressed)
    try:
        run = simulate(model_of(shaken()), scheme="single_rate", dt=0.01)
    except KeyboardInterrupt:  # else it would end all tests
        pytest.fail("the finished run is lost")
    assert run.status.name == "inaccurate" and run.t[-1] == pytest.approx(5.0) and len(run.t) == 501


def test_errors_are_measured_by_all_of_the_motion(model_of: Build, tmp_path: Path) -> None:
    """An oscillation whose period is that of the windows: its range is not that of one phase, whatever is kept."""
    builder = SceneBuilder("in_phase").rigid("rod", mass=1.0, inertia=0.1)
    builder.revolute("pin", "ground.origin", "rod.origin")
    builder.rotational_spring_damper("spring", "ground.origin", "rod.origin", stiffness=0.4)
    model = model_of(builder.initial({"rod.theta": 0.1}).simulation(t_end=10 * np.pi, dt=np.pi / 100).build())
    settings = {"scheme": "single_rate", "t_end": 10 * np.pi, "dt": np.pi / 100}
    whole = simulate(model, **settings)  # type: ignore[arg-type]
    assert np.abs(whole["rod.theta"] - 0.1 * np.cos(2 * whole.t)).max() < 0.002 and whole.status.ok
    for few, within in (
        ({"outputs": ["rod.theta"]}, 0.0),
        ({"stream": tmp_path / "rows"}, 0.0),
        ({"save_every": 100}, 0.2),
    ):
        run, said = simulate(model, **settings, **few), whole.stats["estimated_error"]  # type: ignore[arg-type]
        assert run.status.ok and run.stats["estimated_error"] == pytest.approx(said, rel=within, abs=0.0)
