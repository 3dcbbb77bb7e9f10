"""Right-hand sides that lead back to their jump from both sides: what is told of runs that slide along it."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from runtime import Model, simulate
from symgen.scene import Scene, SceneRecord

Build = Callable[[SceneRecord], Model]
MEETS = 1 / 7  # s: where x = 1.5 - 2 t and y = 1 + 1.5 t meet


def sliding() -> SceneRecord:
    """Two states that slide along x = y."""
    builder = Scene("sliding").rigid("b", mass=1.0, inertia=0.1).prismatic("rail", "ground.origin", "b.origin")
    builder.state("x", rate="where(x>y,-2,2)", initial=1.5).state("y", rate="where(y>x,-3,1.5)", initial=1.0)
    return builder.simulation(t_end=1.0, dt=1e-3, scheme="rk4").build()


def exact(t: np.ndarray) -> np.ndarray:
    """(N, 2) by Filippov: the rates (-2, 1.5) and (2, -3) are mixed such that x - y stays 0, 5 to 3.5."""
    x = np.where(t < MEETS, 1.5 - 2 * t, 1.5 - 2 * MEETS + (5 * -2 + 3.5 * 2) / 8.5 * (t - MEETS))
    return np.stack([x, np.where(t < MEETS, 1 + 1.5 * t, x)], axis=1)


@pytest.mark.every_push("settings1")
@pytest.mark.parametrize(
    "settings",
    [{}, {"dt": 1e-2}, {"scheme": "single_rate"}, {"scheme": "auto", "tolerance": 2e-2}],
)
def test_states_that_slide_are_judged_themselves(model_of: Build, settings: dict[str, Any]) -> None:
    """Their integrals are 30 times as good."""
    run = simulate(model_of(sliding()), **settings)
    law = exact(run.t)
    off = np.sqrt(np.mean((np.stack([run["x"], run["y"]], axis=1) - law) ** 2, axis=0)) / law.std(axis=0)
    assert off.max() / 3 < run.error.largest < 30 * off.max() and run.error.of in ("x", "y")
    named = [event for event in run.events if event.kind == "chattering"]
    assert {event.name for event in named} == {"x, kink 1", "y, kink 1"}
    assert all(event.time == pytest.approx(MEETS, abs=40 / float(run.stats["steps"])) for event in named), named
    assert "slides along it" in str(run.stats["remark"])


@pytest.mark.long
def test_a_tolerance_does_not_refine_what_chatters_for_ever(model_of: Build) -> None:
    run = simulate(model_of(sliding()), scheme="rk4", tolerance=1e-6)
    assert run.status.name == "completed" and run.error.largest > 1e-6 and run.stats["steps"] < 20_000
    assert "1e-06 was asked" in str(run.stats["remark"]) and "chatters" in str(run.stats["remark"])


def test_a_vibration_across_a_kink_does_not_chatter(model_of: Build) -> None:
    """x'' = -w^2 x, stiffer on one side, with 40 steps a period."""
    builder = Scene("bouncing").rigid("b", mass=1.0, inertia=0.1).prismatic("rail", "ground.origin", "b.origin")
    builder.measure("x", "x", of="b.origin").force("spring", "b.origin", "where(x > 0, -40 * x, -30 * x)", 0)
    scene = builder.initial({"b.x": 0.1}).simulation(t_end=40.0, dt=0.025, scheme="rk4").build()
    run = simulate(model_of(scene))
    assert run.stats["kinks"] > 40 and not any(event.kind == "chattering" for event in run.events)
