"""Scenes that read well but cannot be derived, generated or run: each names the item, the problem and the remedy."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from runtime import ArgumentError, InitialStateError, ModelError, SchemeError, SymgenError, load_model, simulate
from runtime.model import Model
from symgen.generate import generate
from symgen.pipeline import derive
from symgen.scene import Scene, SceneError


def four_bar(**extra: Any) -> Scene:
    builder = Scene("linkage").ground(markers={"right": {"position": (0.3, 0)}})
    for name, length in (("crank", 0.1), ("coupler", 0.3), ("rocker", 0.25)):
        builder.rigid(name, mass=1.0, inertia=0.01, markers={"tip": {"position": (length, 0)}})
    builder.revolute("A", "ground.origin", "crank.origin").revolute("B", "crank.tip", "coupler.origin")
    builder.revolute("C", "coupler.tip", "rocker.tip").revolute("D", "ground.right", "rocker.origin")
    return builder.initial({"crank.theta": 1.0, "coupler.theta": 0.4, "rocker.theta": 1.6})


def pendulum() -> Scene:
    builder = Scene("swing").gravity(0, -9.81).rigid("rod", mass=1.0, inertia=0.1, center_of_mass=(0.5, 0))
    return builder.revolute("hinge", "ground.origin", "rod.origin")


def parallelogram(middle: float = 1.0, tilt: float = 0.0) -> Scene:
    """A parallelogram with a third bar in between, flat at tilt 0 (a singular position)."""
    builder = Scene("bars").ground(markers={"m": {"position": (1, 0)}, "r": {"position": (2, 0)}})
    for name, length in (("left", 1.0), ("middle", middle), ("right", 1.0)):
        builder.rigid(name, mass=1.0, inertia=0.1, markers={"tip": {"position": (length, 0)}})
    builder.rigid(
        "top",
        mass=1.0,
        inertia=0.1,
        markers={"a": {"position": (0, 0)}, "b": {"position": (1, 0)}, "c": {"position": (2, 0)}},
    )
    for name, ground, mark in (("left", "origin", "a"), ("middle", "m", "b"), ("right", "r", "c")):
        builder.revolute(f"{name}_low", f"ground.{ground}", f"{name}.origin")
        builder.revolute(f"{name}_up", f"{name}.tip", f"top.{mark}")
    return builder.initial({f"{name}.theta": tilt for name in ("left", "middle", "right")})


def bar_too_long() -> Scene:
    return parallelogram(1.001, 0.3)


def flat_four_bar() -> Scene:
    """All bars of a parallelogram in one line: it may go on as a parallelogram or as an anti-parallelogram."""
    builder = Scene("flat").ground(markers={"right": {"position": (2, 0)}})
    for name, length in (("crank", 1.0), ("coupler", 2.0), ("rocker", 1.0)):
        builder.rigid(name, mass=1.0, inertia=0.1, markers={"tip": {"position": (length, 0)}})
    builder.revolute("A", "ground.origin", "crank.origin").revolute("B", "crank.tip", "coupler.origin")
    return builder.revolute("C", "coupler.tip", "rocker.tip").revolute("D", "ground.right", "rocker.origin")


def ring_of_welds_apart() -> Scene:
    """Three bodies welded in a ring that does not close by 0.01 rad."""
    builder = pendulum().rigid("b", mass=1.0, inertia=0.1, markers={"turned": {"position": (0, 0), "angle": 0.01}})
    builder.rigid("c", mass=1.0, inertia=0.1)
    builder.weld("one", "rod.origin", "b.origin").weld("two", "b.origin", "c.origin")
    return builder.weld("three", "c.origin", "b.turned")


def motions_that_part() -> Scene:
    """Two motions of one angle, equal at t = 0 only."""
    builder = pendulum().rigid("arm", mass=1.0, inertia=0.1).revolute("elbow", "rod.origin", "arm.origin")
    builder.prescribed_angle("drive", "ground.origin", "rod.origin", motion="t**2")
    return builder.prescribed_angle("other", "ground.origin", "rod.origin", motion="2 * t**2")


def too_short() -> Scene:
    """A loop whose bars cannot reach each other."""
    builder = Scene("short").ground(markers={"far": {"position": (5, 0)}})
    for name in ("one", "two"):
        builder.rigid(name, mass=1.0, inertia=0.1, markers={"tip": {"position": (1, 0)}})
    return (
        builder.revolute("A", "ground.origin", "one.origin")
        .revolute("B", "one.tip", "two.origin")
        .point_on_line("slot", "ground.far", "two.tip")
        .revolute("C", "two.tip", "ground.far")
    )


def fixed_apart() -> Scene:
    return pendulum().initial({"rod.x": {"value": 0.5, "fixed": True}})


def fixed_rates_apart() -> Scene:
    return pendulum().rates({"rod.x": {"value": 1.0, "fixed": True}})


def dependent_chosen() -> Scene:
    return pendulum().independent("rod.x")


def too_few_chosen() -> Scene:
    return (
        Scene("two")
        .rigid("a", mass=1.0, inertia=0.1)
        .rigid("b", mass=1.0, inertia=0.1)
        .revolute("p", "ground.origin", "a.origin")
        .revolute("q", "a.origin", "b.origin")
        .independent("a.theta")
    )


def uncovered_group() -> Scene:
    return (
        Scene("two")
        .rigid("a", mass=1.0, inertia=0.1)
        .rigid("b", mass=1.0, inertia=0.1)
        .revolute("p", "ground.origin", "a.origin")
        .revolute("q", "a.origin", "b.origin")
        .groups(L=["a.theta"])
        .simulation(t_end=1.0, dt=0.1, scheme="printed")
    )


def dependent_group() -> Scene:
    return pendulum().groups(L=["rod.theta"], S=["rod.x"]).simulation(t_end=1.0, dt=0.1, m=[2], scheme="printed")


def ratios_without_groups() -> Scene:
    return pendulum().simulation(t_end=1.0, dt=0.1, m=[2, 3], scheme="printed")


def point_that_may_turn() -> Scene:
    return Scene("point").rigid("p", mass=1.0, inertia=0.0, free=True)


def no_inertia_in_a_loop() -> Scene:
    return four_bar().rigid("disc", mass=1.0, inertia=0.0).revolute("E", "crank.tip", "disc.origin")


BAD: list[tuple[Callable[[], Scene], str, str]] = [
    (parallelogram, "joints", "the initial position is singular"),
    (flat_four_bar, "joints", "the initial position is singular"),
    (bar_too_long, "initial", "left_low, left_up, middle_low, middle_up, right_low, right_up cannot all be satisfied"),
    (ring_of_welds_apart, "initial", "three, two cannot all be satisfied"),
    (motions_that_part, "joints", "contradict them later"),
    (too_short, "initial", "cannot all be satisfied"),
    (fixed_apart, "initial", "rod.x"),
    (fixed_rates_apart, "initial", "velocity level"),
    (dependent_chosen, "partition.independent", "hinge"),
    (too_few_chosen, "partition.independent", "b.theta must be independent too"),
    (uncovered_group, "partition.groups", "b.theta"),
    (dependent_group, "partition.groups", "no independent coordinate"),
    (point_that_may_turn, "p.theta", "no inertia"),
    (no_inertia_in_a_loop, "disc.theta", "no inertia"),
    (ratios_without_groups, "simulation.m", "2 step ratios for 1 groups"),
]


@pytest.mark.parametrize(("scene", "item", "phrase"), BAD, ids=[scene.__name__ for scene, _, _ in BAD])
def test_bad_derivation_is_refused_by_name(scene: Callable[[], Scene], item: str, phrase: str) -> None:
    with pytest.raises(SceneError) as caught:
        derive(scene().build())
    assert caught.value.item == item
    assert phrase in str(caught.value)
    assert caught.value.remedy


def test_output_folder_that_is_a_file(tmp_path: Path) -> None:
    (tmp_path / "taken").write_text("mine")
    with pytest.raises(SceneError, match="cannot be written"):
        generate(pendulum().build(), tmp_path / "taken")
    assert (tmp_path / "taken").read_text() == "mine"


@pytest.mark.parametrize("place", ["taken/below", "n" * 300])
def test_output_folder_that_nobody_can_make(tmp_path: Path, place: str) -> None:
    """Below a file, or with a name too long for a folder: refused for every user, root included."""
    (tmp_path / "taken").write_text("mine")
    with pytest.raises(SceneError, match="cannot be written"):
        generate(pendulum().build(), tmp_path / place)
    assert [path.name for path in tmp_path.iterdir()] == ["taken"]


@pytest.fixture(scope="module")
def swing(tmp_path_factory: pytest.TempPathFactory) -> Model:
    return load_model(generate(pendulum().build(), tmp_path_factory.mktemp("swing")))


@pytest.mark.parametrize(
    ("arguments", "error", "phrase"),
    [
        ({"scheme": "rk4", "dt": 0.0}, SchemeError, "dt must be a positive number"),
        ({"scheme": "rk4", "dt": -1e-3}, SchemeError, "dt must be a positive number"),
        ({"scheme": "rk4", "dt": float("nan")}, ArgumentError, "dt: cannot be nan; give a finite number"),
        ({"dt": 1e-3}, SchemeError, "cannot be given with a tolerance, which chooses the step"),
        ({"t_end": 0.0}, SchemeError, "t_end must be a time after"),
        ({"t_end": float("inf")}, ArgumentError, "t_end: cannot be inf; give a finite number"),
        ({"seen_every": -1.0}, SchemeError, "seen_every"),
        ({"samples": 1.5}, ArgumentError, "samples: cannot be 1.5"),
        ({"scheme": "runge"}, SchemeError, "no scheme 'runge'"),
        ({"scheme": "printed", "m": [2]}, SchemeError, "it has no ratio; leave m out"),
        ({"scheme": "single_rate", "m": [2]}, SchemeError, "leave m"),
        ({"m": [2]}, SchemeError, "auto chooses m and options itself"),
        ({"options": {"eps": (1e-6,)}}, SchemeError, "auto chooses m and options itself"),
        ({"engine": "fast"}, ValueError, "engine must be"),
        ({"parameters": {"rod.weight": 1.0}}, ModelError, "no parameter 'rod.weight'"),
        ({"parameters": {"rod.mass": float("nan")}}, ModelError, "must be a finite number"),
        ({"parameters": {"rod.mass": "x"}}, ModelError, "must be a finite number"),
        ({"parameters": {"rod.mass": -1.0}}, ModelError, "at least zero"),
        ({"parameters": {"rod.inertia": -1.0}}, ModelError, "at least zero"),
        ({"scheme": "printed", "m": 3}, ArgumentError, "m: cannot be 3; give a list"),
        ({"t0": float("nan")}, ArgumentError, "t0: cannot be nan"),
        ({"t0": "a"}, ArgumentError, "t0: cannot be 'a'"),
        ({"scheme": "rk4", "t_end": 1e300, "dt": 1e-300}, SchemeError, "raise dt"),
        ({"scheme": "printed", "options": {"eps": "a"}}, SchemeError, "eps"),
        ({"initial": {"rod.phi": 1.0}}, InitialStateError, "no coordinate 'rod.phi'"),
        ({"initial": {"rod.theta": float("inf")}}, InitialStateError, "must be a finite number"),
        ({"initial": {"rod.x": 1.0}}, InitialStateError, "cannot all be satisfied"),
        ({"scheme": "printed", "options": {"eps": (0.0,)}}, SchemeError, "eps"),
        ({"scheme": "printed", "options": {"guess": "magic"}}, SchemeError, "guess must be one of"),
        ({"scheme": "printed", "options": {"tolerance": 1.0}}, SchemeError, "no option 'tolerance'"),
    ],
)
def test_bad_arguments_of_a_run(swing: Model, arguments: dict[str, Any], error: type[Exception], phrase: str) -> None:
    with pytest.raises(error, match=phrase.replace("(", r"\(")):
        simulate(swing, **arguments)


@pytest.mark.parametrize("ratio", [0, -1, 2.5, True, 10**9])
def test_ratios_must_be_whole_numbers(ratio: Any, tmp_path: Path) -> None:
    scene = Scene("pair").structure(
        coordinates=["a", "b"], mass=[[1.0, 0.5], [0.5, 1.0]], stiffness=[[1.0, 0.0], [0.0, 100.0]]
    )
    scene.groups(L=["a"], S=["b"]).simulation(t_end=1.0, dt=0.01, m=[2], scheme="printed")
    model = load_model(generate(scene.build(), tmp_path / "pair"))
    with pytest.raises((SchemeError, ArgumentError), match="whole numbers"):
        simulate(model, scheme="printed", m=[ratio])


def test_step_too_long_ends_with_status_time_coordinate_and_advice(tmp_path: Path) -> None:
    stiff = Scene("stiff").structure(coordinates=["x"], mass=[[1.0]], stiffness=[[1e4]]).initial({"x": 1.0})
    stiff.simulation(t_end=10.0, dt=0.05, scheme="single_rate")
    solution = simulate(load_model(generate(stiff.build(), tmp_path / "stiff")))
    assert solution.status.name == "step_too_long"
    assert solution.status.time == solution.t[-1] == 0.0
    assert "0.02 s" in solution.status.advice  # the limit 2 / 100
    forced = simulate(load_model(tmp_path / "stiff"), force=True)
    assert forced.status.name == "diverged"
    assert forced.status.coordinate == "x"
    assert forced.status.time == forced.t[-1] < 10.0
    assert "0.02 s" in forced.status.advice
    assert np.all(np.isfinite(forced.q))


def test_growing_sub_cycling_ends_with_its_cause(tmp_path: Path) -> None:
    pair = Scene("pair").structure(
        coordinates=["a", "b"], mass=[[1.0, 0.5], [0.5, 1.0]], stiffness=[[1.0, 0.0], [0.0, 400.0]]
    )
    pair.groups(L=["a"], S=["b"]).initial({"a": 1.0, "b": 0.1}).simulation(
        t_end=200.0, dt=0.01, m=[4], scheme="printed"
    )
    solution = simulate(load_model(generate(pair.build(), tmp_path / "pair")), scheme="printed")
    assert solution.status.name == "diverged"
    assert "sub-cycling itself is unstable" in solution.status.advice


def test_a_motion_without_a_rate_at_the_start_is_named() -> None:
    builder = pendulum().prescribed_angle("drive", "ground.origin", "rod.origin", "0.1*sqrt(t)")
    with pytest.raises(SymgenError) as caught:
        derive(builder.build())
    assert caught.value.item == "joints.drive.motion"
    assert "no finite rate at t = 0" in caught.value.problem
    assert "t**2" in caught.value.remedy
