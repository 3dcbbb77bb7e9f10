"""Starts whose loops close otherwise than one may have meant are told; balls turn nothing that need not turn."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from runtime import load_model, simulate
from runtime.model import Model
from symgen.generate import generate
from symgen.scene import Scene, SceneRecord

Build = Callable[[SceneRecord], Model]


def four_bar(crank: float) -> SceneRecord:
    """Links of 0.3, 1 and 1 m; only the crank's angle is given."""
    return (
        Scene("four_bar")
        .ground(markers={"far": {"position": (1.0, 0.5)}})
        .rigid("crank", mass=1.0, inertia=0.1, markers={"end": {"position": (0.3, 0.0)}})
        .rigid("coupler", mass=1.0, inertia=0.1, markers={"end": {"position": (1.0, 0.0)}})
        .rigid("rocker", mass=1.0, inertia=0.1, markers={"end": {"position": (1.0, 0.0)}})
        .revolute("A", "ground.origin", "crank.origin")
        .revolute("B", "crank.end", "coupler.origin")
        .revolute("C", "coupler.end", "rocker.end")
        .revolute("D", "ground.far", "rocker.origin")
        .initial({"crank.theta": crank})
        .simulation(t_end=0.01, dt=1e-3, scheme="rk4")
        .build()
    )


def told(model: Model, **settings: object) -> list[str]:
    """What a run says of its assembly."""
    return [event.text for event in simulate(model, **settings).events if event.kind == "assembled"]  # type: ignore[arg-type]


@pytest.mark.long
def test_far_moves_and_other_branches_are_told(model_of: Build, tmp_path: Path) -> None:
    """The rocker, not given, ends beyond a quarter turn; at 2.5 rad the other branch is about as near (by hand).

    Loops of 1 m about the diagonal from the crank's end to D: both rocker angles follow from it.
    """
    assert told(model_of(four_bar(0.0))) == []
    far = told(model_of(four_bar(1.0)))
    assert len(far) == 1 and "rocker.theta 0 -> -1.736" in far[0]
    loaded = load_model(generate(four_bar(2.5), tmp_path / "model"))
    both = told(loaded)
    end = 0.3 * np.array([np.cos(2.5), np.sin(2.5)])
    diagonal = end - np.array([1.0, 0.5])
    bearing, half = np.arctan2(diagonal[1], diagonal[0]), np.arccos(np.hypot(*diagonal) / 2)
    angles = sorted((bearing + side * half + np.pi) % (2 * np.pi) - np.pi for side in (1, -1))
    assert loaded.initial_q[loaded.coordinates.index("rocker.theta")] == pytest.approx(angles[0])
    assert f"rocker.theta = {angles[1]:.4g}, not {angles[0]:.4g}" in both[1]
    turned = told(model_of(four_bar(0.0)), initial={"crank.theta": 3.1})
    assert not turned or "rocker" in turned[0]


@pytest.mark.parametrize("second", ["spherical", "universal"])
def test_a_chain_is_placed_without_turning(model_of: Build, second: str) -> None:
    """A body on a ball goes to where the ball is, and keeps the direction it has: nothing asks it to turn."""
    scene = (
        Scene("chain", space="spatial")
        .rigid("a", mass=1.0, inertia=(0.1, 0.1, 0.1), markers={"end": {"position": (1.0, 0.0, 0.0)}})
        .rigid("b", mass=1.0, inertia=(0.1, 0.2, 0.3), markers={"near": {"position": (-0.5, 0.0, 0.0)}})
        .joint("revolute", "hinge", "ground.origin", "a.origin")
        .joint(second, "ball", "a.end", "b.near")
        .initial({"hinge.angle": 0.3})
        .build()
    )
    model = model_of(scene)
    at = dict(zip(model.coordinates, model.initial_q, strict=True))
    turn = 0.3 if second == "universal" else 0.0  # a universal joint keeps its own two angles at zero
    assert at["b.x"] == pytest.approx(np.cos(0.3) + 0.5 * np.cos(turn), abs=1e-12)
    assert at["b.y"] == pytest.approx(np.sin(0.3) + 0.5 * np.sin(turn), abs=1e-12)
    assert at["b.e0"] == pytest.approx(np.cos(turn / 2), abs=1e-12)


def contradicting() -> Scene:
    """A slider-crank of which crank and slide are given, which one freedom does not allow."""
    scene = Scene("sc").rigid("crank", mass=1.0, inertia=0.1, markers={"tip": {"position": [0.1, 0]}})
    scene.rigid("rod", mass=0.5, inertia=0.01, center_of_mass=(0.15, 0), markers={"tip": {"position": [0.3, 0]}})
    scene.rigid("sl", mass=0.3, inertia=1e-3).revolute("a", "ground.origin", "crank.origin")
    scene.revolute("b", "crank.tip", "rod.origin").revolute("c", "rod.tip", "sl.origin")
    return scene.prismatic("g", "ground.origin", "sl.origin").simulation(t_end=0.02, dt=1e-3, scheme="rk4")


def test_what_a_start_changes_is_an_event(model_of: Build) -> None:
    """Positions and rates that contradict each other are told, from what to what; what only lacks digits is not."""
    given = {"crank.theta": 1.0, "sl.x": 0.3, "crank.theta_dot": 1.0, "sl.x_dot": 5.0}
    scene = contradicting().initial({"crank.theta": 1.0, "sl.x": 0.3}).rates({"crank.theta": 1.0, "sl.x": 5.0})
    run = simulate(model_of(scene.build()))
    told = {event.name: event for event in run.events if event.kind == "start_changed"}
    assert told.keys() == given.keys() and all(event.time == 0 for event in told.values())
    for name, event in told.items():
        assert f"given as {given[name]:.9g} and begins at {run[name][0]:.9g}" in event.text
    x = 0.1 * np.cos(1.0) + np.sqrt(0.09 - (0.1 * np.sin(1.0)) ** 2)  # by hand
    fixed = {"value": 1.0, "fixed": True}
    found = simulate(model_of(contradicting().initial({"crank.theta": fixed, "sl.x": round(float(x), 4)}).build()))
    assert not [event for event in found.events if event.kind == "start_changed"]
    found = simulate(model_of(contradicting().initial({"crank.theta": fixed, "sl.x": 0.3}).build()))
    assert [event.name for event in found.events if event.kind == "start_changed"] == ["sl.x"]


def test_a_quasi_static_start_is_what_was_asked_for() -> None:
    """Deflections that nobody gave begin where the start lays them, without a word."""
    scene = Scene("arm").gravity(0, -9.81).revolute("hinge", "ground.origin", "arm.start")
    scene.beam(
        "arm", length=1.0, density=2700.0, area=4e-5, second_moment=1.3e-11, youngs_modulus=7e10, lateral={"modes": 2}
    )
    run = scene.model().simulate(t_end=0.01, scheme="rk4", dt=1e-4, start="quasi_static", error="off")
    assert abs(run["arm.q1"][0]) > 1e-3 and run.events == []
