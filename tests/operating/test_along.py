"""Frequencies along a motion against closed forms."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from runtime import ArgumentError, plots, simulate
from runtime.model import Model
from runtime.operating.frequencies_along import frequencies_along

Load = Callable[[str], Model]


def test_a_pendulum_on_its_way(built_in: Load) -> None:
    """theta'' = -(g / L) cos theta, theta from the horizontal: lambda^2 = (g / L) sin theta, which grows above it."""
    run = simulate(built_in("pendulum"), scheme="rk4", dt=1e-3, t_end=1.2, initial={"rod.theta": 0.8}, seen_every=0.01)
    found = frequencies_along(run, samples=20)
    square = 9.81 * np.sin(np.interp(found.t, run.t, run["rod.theta"]))
    np.testing.assert_allclose(found.frequencies[:, 0], np.sqrt(np.abs(square)), rtol=1e-9)
    assert np.array_equal(found.damping_ratios[:, 0] < 0, square > 0) and square.min() < 0 < square.max()


def test_modes_of_a_linear_system_stay_what_they_are(built_in: Load) -> None:
    """M = [[1, c], [c, 1]], K = diag(k_L, w^2): w^2 of the modes from the characteristic polynomial."""
    c, k_L, w = 0.4, 2.0, 15.0
    given = {"c": c, "k_L": k_L, "w": w, "zeta": 0.0}
    run = simulate(built_in("two_oscillators"), scheme="rk4", dt=1e-3, t_end=0.1, parameters=given)
    squares = np.sort(np.roots([1 - c**2, -(k_L + w**2), k_L * w**2]))
    found = frequencies_along(run, samples=5)
    np.testing.assert_allclose(np.sort(found.frequencies, axis=1) ** 2, np.tile(squares, (5, 1)), rtol=1e-9, atol=1e-12)


def test_the_picture(built_in: Load, tmp_path: Path) -> None:
    run = simulate(built_in("flexible_slider_crank_free"), t_end=2e-3, seen_every=5e-4)
    figure = plots.frequencies(run, tmp_path / "f.png", samples=3)
    (ax,) = figure.axes
    assert [text.get_text() for text in ax.get_legend().get_texts()] == [
        "crank.theta",
        *(f"rod.q{k}" for k in (1, 2, 4, 3)),
    ]
    assert (tmp_path / "f.png").stat().st_size > 10_000
    with pytest.raises(ArgumentError, match="samples"):
        plots.frequencies(run, samples=1)
