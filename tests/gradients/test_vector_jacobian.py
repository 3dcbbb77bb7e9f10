"""Vector-Jacobian products of runs: the Jacobian from the left, both ways, as often as asked for; what is refused."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from runtime import ArgumentError, DifferentiableRun, Model, NoResult
from runtime.gradients import passes
from symgen.scene import Scene, SceneRecord

Build = Callable[[SceneRecord], Model]


def thrown() -> SceneRecord:
    """A mass on a line under a constant force: x = x0 + v0 t + push t^2 / 2."""
    return (
        Scene("thrown")
        .parameter("push", 0.5)
        .rigid("mass", mass=1.0, inertia=1.0)
        .prismatic("line", "ground.origin", "mass.origin")
        .force("push", "mass.origin", "push", 0.0)
        .simulation(t_end=1.0, dt=0.01, scheme="rk4")
        .build()
    )


@pytest.fixture(scope="module")
def run(model_of: Build) -> DifferentiableRun:
    return DifferentiableRun(
        model_of(thrown()),
        ["mass.x", "mass.x_dot"],
        ["push", "mass.x", "mass.x_dot"],
        initial={"mass.x": 0.1, "mass.x_dot": 2.0},
        seen_every=0.25,
    )


@pytest.mark.parametrize("mode", ["forward", "reverse", "auto"])
@pytest.mark.parametrize("whole", [True, False], ids=["whole", "in parts"])
def test_products_follow_the_closed_form(
    run: DifferentiableRun, mode: str, whole: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    """x moves by t^2 / 2, 1 and t, its rate by t, 0 and 1; recorded whole, and by segments that are run again."""
    if not whole:
        monkeypatch.setattr(passes, "TAPE_NUMBERS", 1)
        run = run.over(0.0, 1.0)
    t, one = run.t, np.ones_like(run.t)
    jacobian = np.array([[t**2 / 2, one, t], [t, 0 * t, one]]).transpose(2, 0, 1)
    kept = run.record(run.x0, mode)
    np.testing.assert_allclose(kept.values, run.values(run.x0), rtol=1e-14)
    for seed in (0, 1, 0):  # again, too: going back takes nothing away
        bars = np.random.default_rng(seed).normal(size=(len(t), 2))
        expected = np.einsum("ny,nyk->k", bars, jacobian)
        np.testing.assert_allclose(kept.pull_back(bars), expected, rtol=0, atol=1e-12)
        np.testing.assert_allclose(run.pull_back(run.x0, bars, mode), expected, rtol=0, atol=1e-12)


@pytest.mark.parametrize("whole", [True, False], ids=["whole", "in parts"])
def test_records_keep_their_run(built_in: Callable[[str], Model], whole: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    """Two at a time, each taken back twice: what comes is the Jacobian from the left. The motion is not linear."""
    if not whole:
        monkeypatch.setattr(passes, "TAPE_NUMBERS", 1)
    model = built_in("double_pendulum")
    run = DifferentiableRun(model, ["lower.theta"], ["upper.theta"], t_end=0.5, dt=2e-3, scheme="rk4", seen_every=0.1)
    points = [run.x0, run.x0 + 0.3]
    records = [run.record(x, "reverse") for x in points]
    for seed in (0, 1):
        bars = np.random.default_rng(seed).normal(size=(len(run.t), 1))
        for record, x in zip(records, points, strict=True):
            expected = np.einsum("ny,nyk->k", bars, run.jacobian(x).derivatives)
            np.testing.assert_allclose(record.pull_back(bars), expected, rtol=1e-11)


@pytest.mark.parametrize(
    "bars, message",
    [
        (np.zeros((5, 1)), r"has shape \(5, 1\); give \(5, 2\): 5 saved times, outputs mass.x, mass.x_dot"),
        (np.full((5, 2), np.nan), "is nan for mass.x at t = 0 s"),
        ("all", "is not an array of numbers"),
    ],
)
def test_cotangents_that_cannot_be_used_are_named(run: DifferentiableRun, bars: Any, message: str) -> None:
    with pytest.raises(ArgumentError, match=f"cotangents: {message}"):
        run.pull_back(run.x0, bars)


def test_other_wrong_arguments(run: DifferentiableRun) -> None:
    with pytest.raises(ArgumentError, match="mode: is 'back'"):
        run.record(run.x0, "back")
    with pytest.raises(ArgumentError, match="x: the value of push is inf"):
        run.pull_back([np.inf, 0.0, 0.0], np.zeros((5, 2)))
    with pytest.raises(NoResult, match="derivative by push, mass.x, mass.x_dot"):
        run.pull_back(run.x0, np.full((5, 2), 1e308), "reverse")
