"""Fits: exact data give the truth, noise gives what linear theory says, bad data are refused by name."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from runtime import ArgumentError, DifferentiableRun, Model, ModelError, NoResult, SymgenError, fit
from runtime.gradients.fit import fit_prepared
from symgen.scene import SceneRecord
from tests.gradients.test_gradients import sliding

Build = Callable[[SceneRecord], Model]
Load = Callable[[str], Model]
TRUTH = {"length": 1.3, "rod.theta": -1.1, "rod.theta_dot": 0.4}
GUESS = {"rod.theta": -0.8}
RUN = {"t_end": 1.0, "dt": 5e-3, "seen_every": 0.025, "scheme": "rk4"}


@pytest.fixture(scope="module")
def swing(built_in: Load) -> DifferentiableRun:
    return DifferentiableRun(built_in("pendulum"), ["tip_x", "tip_y"], list(TRUTH), **RUN)


def test_exact_data_give_the_truth(swing: DifferentiableRun, tmp_path: Path) -> None:
    """Length and start of a pendulum from the path of its tip."""
    path = swing.values(TRUTH)
    data = {"t": swing.t, "tip_x": path[:, 0], "tip_y": path[:, 1]}
    found = fit(swing.model, data, list(TRUTH), deviation=1e-3, bounds={"length": (0.5, 2.0)}, guess=GUESS, **RUN)
    np.testing.assert_allclose(found.x, list(TRUTH.values()), rtol=1e-7)
    assert found.converged and found.contains(TRUTH) and found["length"] == found.x[0]
    assert max(np.abs(rest).max() for rest in found.residuals.values()) < 1e-7
    assert len(found.picture(tmp_path / "fit.png").axes) == 4 and (tmp_path / "fit.png").stat().st_size > 1000
    assert "length = 1.3" in str(found) and "<table>" in found._repr_html_()


@pytest.mark.long
def test_noise_spreads_results_as_the_covariance_says(model_of: Build) -> None:
    """v = a t (1 - t / 2) + ...: a linear model, so the estimates of many measurements have the stated covariance."""
    model = model_of(sliding("a * (1 - t) + b * t + c * t", a=1.0, b=0.5, c=0.25))
    names, noise, sigma = ["a", "b"], np.random.default_rng(5), 0.02
    run = DifferentiableRun(model, ["mass.x_dot"], names)
    exact, slopes = run.values(run.x0)[:, 0], run.jacobian(run.x0).derivatives[:, 0]
    expected = sigma**2 * np.linalg.inv(slopes.T @ slopes)
    known = fit(model, {"mass.x_dot": exact}, names, deviation=sigma)
    np.testing.assert_allclose(known.covariance, expected, rtol=1e-8)
    found = [fit_prepared(run, {"mass.x_dot": exact + noise.normal(0, sigma, len(exact))}) for _ in range(40)]
    truth = dict(zip(names, run.x0, strict=True))
    assert 33 <= sum(one.contains(truth) for one in found) <= 40  # 38 expected, 1.4 standard deviation
    away = np.array([one.x - run.x0 for one in found])
    distance = np.einsum("ni,ij,nj->n", away, np.linalg.inv(expected), away).sum()
    assert 50 < distance < 115  # chi-squared of 80 degrees of freedom: 1 of 100 lies outside
    low, high = found[0].interval("a")
    assert low < found[0]["a"] < high and high - low == pytest.approx(4.0 * found[0].standard_errors[0], rel=0.01)


def test_what_was_not_measured_does_not_count(swing: DifferentiableRun) -> None:
    """Infinite deviation, whatever stands there."""
    path = swing.values(TRUTH)[:, 0]
    spread = np.where(np.arange(len(path)) % 3 == 0, np.inf, 1e-3)
    with_holes = np.where(np.isinf(spread), np.nan, path)
    found = fit(swing.model, {"tip_x": with_holes}, list(TRUTH), deviation={"tip_x": spread}, guess=GUESS, **RUN)
    np.testing.assert_allclose(found.x, list(TRUTH.values()), rtol=1e-6)


@pytest.mark.parametrize(
    "data, by, more, error, text",
    [
        ({"tip_z": 0}, ["length"], {}, ModelError, "'tip_z'.*no output of this name.*did you mean 'tip_y'"),
        ({"tip_x": 0}, ["lenght"], {}, ModelError, "did you mean 'length'"),
        ({"tip_x": np.zeros(40)}, ["length"], {}, ArgumentError, r"tip_x.*shape \(40,\).*each of the 41 saved times"),
        ({"tip_x": np.full(41, np.nan)}, ["length"], {}, ArgumentError, "tip_x: is nan at t = 0 s"),
        ({"tip_x": ["a"] * 41}, ["length"], {}, ArgumentError, "tip_x: are not numbers"),
        (
            {"t": np.linspace(0, 2, 41), "tip_x": 0},
            ["length"],
            {},
            ArgumentError,
            "differ from the saved times by up to 1",
        ),
        ({"tip_x": 0, "tip_y": 0}, ["length"], {}, ArgumentError, "deviation: is missing"),
        ({"tip_x": 0}, ["length"], {"deviation": -1.0}, ArgumentError, "deviation: must be positive"),
        ({"tip_x": 0}, ["length"], {"bounds": {"length": (2.0, 3.0)}}, ArgumentError, "bounds of length: are 2 and 3"),
        ({"tip_x": 0}, ["length"], {"bounds": {"length": float("nan")}}, ArgumentError, "bounds of length: are nan"),
        ({"tip_x": 0}, ["length"], {"bounds": {"length": (1.0, 2.0, 3.0)}}, ArgumentError, "give .lowest, highest"),
        ({"tip_x": 0}, ["length"], {"bounds": {"rod.mass": (2.0, 3.0)}}, ArgumentError, "bounds of rod.mass"),
        ({"tip_x": 0}, ["length"], {"guess": {"rod.mass": 2.0}}, ArgumentError, "guess of rod.mass"),
        ({"tip_x": 0}, ["length", "rod.mass"], {}, NoResult, "fit of rod.mass: the data do not determine it"),
    ],
)
def test_data_that_cannot_be_used(
    swing: DifferentiableRun, data: dict, by: list[str], more: dict, error: type[SymgenError], text: str
) -> None:
    """0 stands for the right path."""
    path = swing.values(swing.x0)
    filled = {name: path[:, 0] if isinstance(value, int) else value for name, value in data.items()}
    with pytest.raises(error, match=text):
        fit(swing.model, filled, by, **RUN, **more)
