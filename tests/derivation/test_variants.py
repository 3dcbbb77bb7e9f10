"""Variants: the same scene with other independent coordinates, as a run asks for them."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path
from pkgutil import resolve_name
from typing import Any

import numpy as np
import pytest

from runtime import load_model, simulate
from runtime.model import Model
from symgen.generate import generate
from symgen.scene import Scene, SceneError, SceneRecord
from symgen.scenes import generated_folder
from symgen.scenes.linkages import n_four_bar
from symgen.variants import generate_variant
from tests.support.model_values import condensed_accelerations, join, make_state, relative_error

FOLDER = generated_folder("four_bar")
TEXT = (FOLDER / "scene.toml").read_text(encoding="utf-8")


def state_of(model: Model, angle: float) -> dict[str, float]:
    """All coordinates of a position of the model."""
    q = make_state(model, [angle], [0.0]).q
    return dict(zip(model.coordinates, map(float, q), strict=True))


def test_a_variant_moves_like_the_model_it_comes_from(tmp_path: Path) -> None:
    original = load_model(FOLDER)
    start = state_of(original, 1.3)
    folder = generate_variant(TEXT, ["rocker.theta"], [("all", ["rocker.theta"])], tmp_path / "rocker", start)
    variant = load_model(folder)
    assert variant.q_i == ["rocker.theta"] and variant.coordinates == original.coordinates
    np.testing.assert_array_equal(variant.initial_q, list(start.values()))
    for angle in (1.3, 1.1):
        here = make_state(original, [angle], [2.0])
        rocker = original.coordinates.index("rocker.theta")
        there = make_state(variant, [here.q[rocker]], [here.q_dot[rocker]], guess=here.q)
        np.testing.assert_allclose(there.q, here.q, rtol=0, atol=1e-12)
        np.testing.assert_allclose(there.q_dot, here.q_dot, rtol=0, atol=1e-11)
        assert relative_error(condensed_accelerations(variant, there), condensed_accelerations(original, here)) < 1e-9
    assert simulate(variant, scheme="single_rate", t_end=0.01, dt=1e-4, engine="interpreted").status.ok


def test_groups_and_functions_are_those_asked_for(tmp_path: Path) -> None:
    source = generated_folder("flexible_four_bar")
    original = load_model(source)
    rigid, elastic = ["rocker.theta"], [name for name in original.q_i if name in original.elastic]
    q = dict(zip(original.coordinates, map(float, original.initial_q), strict=True))
    text = (source / "scene.toml").read_text(encoding="utf-8")
    folder = generate_variant(
        text,
        [*rigid, *elastic],
        [("slow", rigid), ("fast", elastic)],
        tmp_path / "groups",
        q,
        functions=["condensed", "closure", "velocities"],
    )
    model = load_model(folder)
    assert model.q_i == [*rigid, *elastic]
    assert [(group.name, group.positions) for group in model.groups] == [
        ("slow", [0]),
        ("fast", list(range(1, 1 + len(elastic)))),
    ]
    assert set(model.builders) == {"constants", "condensed", "closure", "velocities"}


def test_a_scene_without_ratios_has_variants_with_groups(tmp_path: Path) -> None:
    """A scene that names no groups needs no ratios m; its variants have the groups that the run found."""
    source = generated_folder("flexible_four_bar")
    text = (source / "scene.toml").read_text(encoding="utf-8").replace('"single_rate"', '"rk4"')
    text = re.sub(r"^m = .*\n", "", text, flags=re.MULTILINE)
    q_i = load_model(source).q_i
    groups = [("slow", q_i[:1]), ("fast", q_i[1:])]
    folder = generate_variant(text, q_i, groups, tmp_path / "bare", functions=["condensed", "closure", "velocities"])
    assert [group.name for group in load_model(folder).groups] == ["slow", "fast"]


@pytest.mark.parametrize(
    "simulation",
    [
        {},
        {"t_end": 2.0},
        {"t_end": 5e-4, "seen_every": 1e-5},
        {"tolerance": 1e-4},
        {"scheme": "dopri5", "tolerance": 1e-4},
        {"scheme": "exponential", "dt": 1e-4, "m": [4]},
        {"scheme": "coupled", "dt": 1e-4, "m": [2]},
        {"start": "quasi_static"},
    ],
)
@pytest.mark.parametrize("groups", ["none", "two", "three"])
def test_a_variant_has_the_groups_of_the_run_however_the_scene_is_stepped(
    tmp_path: Path, simulation: dict[str, Any], groups: str
) -> None:
    """Groups of the run, in a scene that names none, as many or others; of its scheme the variant keeps nothing."""
    data = tomllib.loads((generated_folder("flexible_four_bar") / "scene.toml").read_text(encoding="utf-8"))
    q_i = load_model(generated_folder("flexible_four_bar")).q_i
    own = {"none": [], "two": [q_i[:1], q_i[1:]], "three": [q_i[:1], q_i[1:2], q_i[2:]]}[groups]
    data["partition"] = (
        {"groups": [{"name": f"g{k}", "coordinates": part} for k, part in enumerate(own)]} if own else {}
    )
    data["simulation"] = simulation | ({"m": [2] * (len(own) - 1)} if own and "m" in simulation else {})
    text = SceneRecord.from_dict(data).to_toml()
    wanted = [("slow", q_i[:1]), ("fast", q_i[1:])]
    folder = generate_variant(text, q_i, wanted, tmp_path / "v", functions=["condensed", "closure", "velocities"])
    found = load_model(folder)
    assert [(group.name, [q_i[k] for k in group.positions]) for group in found.groups] == wanted
    assert not {"m", "tolerance"} & set(found.simulation) or not found.simulation["m"]


def test_a_variant_beyond_a_singular_position(tmp_path: Path) -> None:
    """Two windows hanging down, where the scene does not start, with the middle upright independent."""
    original = load_model(generate(n_four_bar(2), tmp_path / "original", frozenset({"closure"})))
    down = np.zeros(len(original.coordinates))
    values = {
        "upright0": (0, 0, -1.4),
        "upright1": (1, 0, -1.4),
        "upright2": (2, 0, -1.4),
        "top1": (np.cos(1.4), -np.sin(1.4), 0),
        "top2": (1 + np.cos(1.4), -np.sin(1.4), 0),
    }
    for body, numbers in values.items():
        for part, number in zip(("x", "y", "theta"), numbers, strict=True):
            down[original.coordinates.index(f"{body}.{part}")] = number
    state = dict(zip(original.coordinates, map(float, down), strict=True))
    text = n_four_bar(2).to_toml()
    model = load_model(
        generate_variant(text, ["upright1.theta"], [("all", ["upright1.theta"])], tmp_path / "down", state)
    )
    found = make_state(model, [-1.4], [0.0])
    np.testing.assert_allclose(join(model, found.q_i, found.q_d), down, rtol=0, atol=1e-14)


def test_the_redundant_rows_are_those_handed_over(tmp_path: Path) -> None:
    """Either of two equal hinges can be left out; the variant leaves out the one it is told."""
    builder = Scene("double").ground(markers={"right": {"position": (2, 0)}})
    for name, length in (("crank", 1.0), ("coupler", 1.5), ("rocker", 1.2)):
        builder.rigid(name, mass=1.0, inertia=0.1, markers={"tip": {"position": (length, 0)}})
    builder.revolute("A", "ground.origin", "crank.origin").revolute("B", "crank.tip", "coupler.origin")
    builder.revolute("C", "coupler.tip", "rocker.tip").revolute("D", "ground.right", "rocker.origin")
    builder.revolute("E", "ground.right", "rocker.origin")
    builder.initial({"crank.theta": 1.2, "coupler.theta": 0.2, "rocker.theta": 1.5})
    original = load_model(generate(builder.build(), tmp_path / "original"))
    assert original.redundant == ["E.x", "E.y"]
    state = dict(zip(original.coordinates, map(float, original.initial_q), strict=True))
    variant = load_model(
        generate_variant(
            builder.build().to_toml(),
            ["rocker.theta"],
            [("all", ["rocker.theta"])],
            tmp_path / "variant",
            state,
            ["D.x", "D.y"],
        )
    )
    assert variant.redundant == ["D.x", "D.y"]
    here = make_state(original, [1.2], [0.7])
    rocker = original.coordinates.index("rocker.theta")
    there = make_state(variant, [here.q[rocker]], [here.q_dot[rocker]], guess=here.q)
    assert relative_error(condensed_accelerations(variant, there), condensed_accelerations(original, here)) < 1e-9


def test_bad_variants_are_refused(tmp_path: Path) -> None:
    state = state_of(load_model(FOLDER), 1.3)
    with pytest.raises(SceneError, match="no value for crank.x"):
        generate_variant(
            TEXT,
            ["rocker.theta"],
            [("all", ["rocker.theta"])],
            tmp_path / "a",
            {name: value for name, value in state.items() if name != "crank.x"},
        )
    with pytest.raises(SceneError, match="cannot be solved for the remaining"):
        generate_variant(
            TEXT, ["rocker.theta", "crank.theta"], [("all", ["rocker.theta", "crank.theta"])], tmp_path / "b", state
        )
    assert not any(tmp_path.iterdir())


def test_the_entry_point_is_this_function() -> None:
    project = tomllib.loads((Path(__file__).parents[2] / "pyproject.toml").read_text(encoding="utf-8"))
    assert resolve_name(project["project"]["entry-points"]["symgen.variants"]["default"]) is generate_variant
