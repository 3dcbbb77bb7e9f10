"""The error of a model beside that of its steps: what knobs tell of beams with known limits, where they are blind."""

from __future__ import annotations

from dataclasses import replace
from importlib.metadata import EntryPoints
from typing import Any

import numpy as np
import pytest

from runtime import ArgumentError, Model, ModelError, NoResult
from runtime.studies import convergence as study
from symgen.refinement.knobs import refinements
from symgen.scene import Scene, SceneRecord

EI, LENGTH = 25.2, 1.0
STEEL = {"density": 7870.0, "area": 4.2e-5, "second_moment": 1.26e-10, "youngs_modulus": 2e11}
WEIGHT, SMALL = 20.0, 1e-4  # N/m; by the small one nothing turns


def cantilever(modes: int = 1, **more: Any) -> Scene:
    """Clamped at its start, under a load along it."""
    lateral = {"ends": "clamped-free", "modes": modes}
    return (
        Scene("shelf")
        .beam("arm", length=LENGTH, **{**STEEL, "lateral": lateral, **more})
        .weld("wall", "ground.origin", "arm.start")
        .distributed("books", "arm", [0.0, -WEIGHT])
        .measure("tip", "y", of="arm.end")
        .measure("slope", "angle", of="arm.end")
    )


def pieces(count: int, load: float = 20.0, lateral: int = 2) -> Scene:
    """A cantilever of welded pieces under a force at its end; stiffening off."""
    scene, last = Scene("column"), "ground.origin"
    for k in range(count):
        scene.beam(f"piece{k}", length=LENGTH / count, **STEEL, lateral={"modes": lateral})
        scene.weld(f"weld{k}", last, f"piece{k}.start")
        last = f"piece{k}.end"
    return scene.force("load", last, 0.0, -load).measure("x", "x", of=last).measure("y", "y", of=last)


def swing(**more: Any) -> Scene:
    """A beam on a hinge that falls."""
    return (
        Scene("swing")
        .gravity(0.0, -9.81)
        .beam("arm", length=LENGTH, **STEEL, lateral={"modes": 2}, stiffening=True, **more)
        .revolute("hinge", "ground.origin", "arm.start")
        .measure("tip", "y", of="arm.end")
        .initial({"arm.theta": 0.1})
    )


def test_few_shapes_of_a_cantilever() -> None:
    """w L^4 / 8 EI at the tip and w L^3 / 6 EI of slope; by one shape they are 1 and 5 % off."""
    found = cantilever().model().convergence(of="equilibrium", knobs=["modes"])
    for name, exact in (("tip", -WEIGHT / (8 * EI)), ("slope", -WEIGHT / (6 * EI))):
        true = abs(found[name].value - exact)
        assert true > 1e-3 * abs(exact)
        assert true / 3 < found[name].error < 3 * true
        assert found[name].knob == "arm.modes" and found[name].unit == {"tip": "m", "slope": "rad"}[name]
        assert found[name].relative == pytest.approx(found[name].error / abs(found[name].value))
    (turned,) = found.turned
    assert (turned.knob, turned.now, turned.to) == ("arm.modes", "1", ("3",)) and turned.cost > 0


@pytest.mark.long
def test_half_the_pieces_tell_large_deflections() -> None:
    """Eight pieces of an elastica, P L^2 / EI = 1: w = 0.30172 L, u = 0.05643 L (Mattiasson 1981); order two."""
    found = pieces(8, load=EI).model().convergence(of="equilibrium", knobs=["pieces"], levels=2)
    for name, exact in (("x", 1 - 0.0564332), ("y", -0.3017208)):
        true = abs(found[name].value - exact)
        assert true / 1.5 < found[name].error < 1.5 * true
    assert all(change.order == pytest.approx(2.0, abs=0.4) for change in found.changes)


def test_what_a_knob_does_not_see_is_said() -> None:
    """Stiffening does nothing to a beam that bends and is not pulled; shear and stretching are named."""
    found = cantilever().model().convergence(["tip"], of="equilibrium")
    says = {change.knob: change.says for change in found.changes}
    assert says == {"arm.modes": "error", "arm.pieces": "error", "arm.stiffening": "nothing"}
    assert "Euler-Bernoulli" in found.blind["arm.shear"] and found.left == ("arm.axial",)
    text = str(found)
    for words in (
        "arm.stiffening off -> on",
        "tip says nothing",
        "cannot be turned: arm.shear",
        "not turned: arm.axial (name them",
    ):
        assert words in text


def test_where_no_knob_says_anything_nothing_is_told() -> None:
    """A rigid pendulum: no error of the model is told, and not that it is zero."""
    scene = Scene("pendulum").gravity(0, -9.81).rigid("rod", mass=1.0, inertia=0.1, center_of_mass=(0.5, 0.0))
    scene.revolute("hinge", "ground.origin", "rod.origin").measure("tip", "y", of="rod.center")
    found = scene.model().convergence(t_end=0.2)
    assert np.isnan(found["tip"].error) and np.isnan(found["tip"].relative) and not found.turned
    assert "nothing was turned" in str(found) and "not told" in str(found)
    assert found.to_dict()["errors"]["tip"]["error"] is None


@pytest.mark.long
def test_a_motion_by_readings() -> None:
    """Each reading is an output; what a beam that is cut has as an angle is not compared."""
    found = swing().model().convergence({"tip": ["motion", "end"], "arm.theta": "end"}, t_end=0.3)
    assert list(found.errors) == ["tip", "tip end", "arm.theta end"]
    assert 0 < found["tip"].stepping < 1e-5 and found["tip end"].error < 1e-2
    assert {change.says for change in found.changes if change.output == "arm.theta end"} >= {"not compared"}
    with pytest.raises(ModelError, match="it has tip, tip end"):
        found["tipp"]


def test_damping_of_each_shape_keeps_a_beam_whole() -> None:
    found = cantilever(damping_ratio=0.02).model().convergence(["tip"], of="equilibrium")
    assert "damping_frequency" in found.blind["arm.pieces"]
    kept = cantilever(damping_ratio=0.02, damping_frequency=30.0).model().convergence(["tip"], of="equilibrium")
    assert "arm.pieces" not in kept.blind


@pytest.mark.long
def test_a_beam_that_is_cut_is_the_same_beam() -> None:
    """Markers, and a load between 0.2 and 0.8 of the length, are where they were: deflections by beam theory."""
    places = (0.3, 0.5, 0.7)
    scene = (
        Scene("shelf")
        .weld("wall", "ground.origin", "arm.start")
        .distributed("w", "arm", [0.0, -SMALL], start=0.2, end=0.8)
    )
    markers = {f"m{k}": {"at": at} for k, at in enumerate(places)}
    scene.beam("arm", length=LENGTH, **STEEL, lateral={"ends": "clamped-free", "modes": 6}, markers=markers)
    for k in range(3):
        scene.measure(f"x{k}", "x", of=f"arm.m{k}").measure(f"y{k}", "y", of=f"arm.m{k}")
    (knob,) = [one for one in refinements(scene.build().to_toml(), 2) if one["kind"] == "pieces"]
    assert [level["to"] for level in knob["levels"]] == ["2", "4"]
    s = np.linspace(0.2, 0.8, 601)
    for level in knob["levels"]:
        found = SceneRecord.from_toml_text(level["scene"]).model().convergence(of="equilibrium", knobs=[])
        for k, x in enumerate(places):  # by the influence of a force at s on the deflection at x
            a, b = np.minimum(s, x), np.maximum(s, x)
            exact = -SMALL * np.trapezoid(a**2 * (3 * b - a) / (6 * EI), s)
            assert found[f"x{k}"].value == pytest.approx(x, abs=1e-9)
            assert found[f"y{k}"].value == pytest.approx(exact, rel=1e-3)


def test_pieces_that_are_merged_are_the_same_beam() -> None:
    """Four pieces under a load on the third: the tip of two pieces, by w (b^4 - a^4) / 24 EI and what follows."""
    scene = pieces(4, load=0.0, lateral=4).distributed("w", "piece2", [0.0, -SMALL])
    (knob,) = [one for one in refinements(scene.build().to_toml(), 2) if one["kind"] == "pieces"]
    s = np.linspace(0.5, 0.75, 501)
    exact = -SMALL * np.trapezoid(s**2 * (3 - s) / (6 * EI), s)
    for level in knob["levels"]:
        found = SceneRecord.from_toml_text(level["scene"]).model().convergence(["y"], of="equilibrium", knobs=[])
        assert found["y"].value == pytest.approx(exact, rel=1e-3)


@pytest.mark.long
def test_elastic_coordinates_follow_their_shapes() -> None:
    """Of more bending shapes the first stretching one has another number; the start that names it follows."""
    scene = swing(axial={"modes": 1}).initial({"arm.q3": 1e-6})
    found = scene.model().convergence(["tip"], t_end=0.01, knobs=["modes"], initial={"arm.q3": 2e-6})
    assert [change.says for change in found.changes] != ["not compared"]
    texts = [
        level["scene"]
        for one in refinements(scene.build().to_toml())
        if one["kind"] == "modes"
        for level in one["levels"]
    ]
    assert '"arm.q5" = 1e-06' in texts[0] and "arm.q3" not in texts[0]


def test_models_of_other_meshes_are_given() -> None:
    """Lumped meshes: given and turned alike, a third of the difference to half the elements."""

    def lumped(elements: int) -> Scene:
        beam = {**STEEL, "lateral": {"ends": "clamped-free", "modes": 1}, "mesh": "lumped", "elements": elements}
        return Scene("mesh").beam("arm", length=1.0, **beam).weld("wall", "ground.origin", "arm.start")

    def first(model: Model) -> dict[str, float]:
        return {"first": float(model.modes(model.equilibrium()).frequencies[0])}

    exact = 1.8751040687**2 * np.sqrt(2e11 * 1.26e-10 / (7870.0 * 4.2e-5))  # rad/s
    base = lumped(8).model()
    given = base.convergence(first, knobs=[], coarser={"arm.mesh": lumped(4).model()})
    turned = base.convergence(first, knobs=["elements"])
    assert given["first"].error == pytest.approx(turned["first"].error, rel=1e-9)
    true = abs(given["first"].value - exact)
    assert 0.8 * true < turned["first"].error < 1.25 * true


def test_a_model_without_its_scene_is_refused_by_name() -> None:
    model = replace(cantilever().model(), scene_toml="")
    with pytest.raises(ModelError, match="shelf: comes without its scene.*coarser"):
        model.convergence(of="equilibrium")


def test_without_a_generator_it_says_so(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(study, "entry_points", lambda **_: EntryPoints())
    with pytest.raises(ModelError, match="shelf: no generator.*install symgen"):
        cantilever().model().convergence(of="equilibrium")


@pytest.mark.parametrize(
    ("asked", "words"),
    [
        ({"outputs": ["tipp"]}, "no output of this name.*tip"),
        ({"outputs": ["arm.q1"]}, "amplitude of one shape"),
        ({"outputs": []}, "none"),
        ({"outputs": {"tip": "largest"}}, "no reading 'largest'.*peak"),
        ({"outputs": "tip"}, "give a list of names"),
        ({"of": "rest"}, "'motion' or 'equilibrium'"),
        ({"knobs": ["mode"]}, "not a knob of this scene.*arm.modes"),
        ({"levels": 3}, "give 1 or 2"),
        ({"samples": 1}, "from 2 on"),
        ({"of": "equilibrium", "t_end": 1.0}, "applies to motions only"),
        ({"coarser": {"arm.mesh": 3}}, "give models"),
        ({"outputs": lambda model: {"x": "y"}}, "finite numbers by name"),
    ],
)
def test_what_cannot_be_asked_is_said(asked: dict[str, Any], words: str) -> None:
    with pytest.raises((ArgumentError, ModelError), match=words):
        cantilever().model().convergence(**asked)


def test_a_model_whose_run_fails_has_no_error() -> None:
    scene = swing().force("pull", "arm.end", "1 / (0.1 - t)", 0.0)
    with pytest.raises(NoResult, match="the run of swing ended with"):
        scene.model().convergence(["tip"], t_end=0.5, tolerance=1e-3)


def long_swing(count: int, **more: Any) -> Scene:
    """A beam on a hinge by pieces that falls; without stiffening, so that few pieces are far off."""
    scene, last = Scene("swing").gravity(0.0, -9.81), "ground.origin"
    for k in range(count):
        scene.beam(f"piece{k}", length=LENGTH / count, **STEEL, lateral={"modes": 1}, **more)
        scene.joint("weld" if k else "revolute", f"joint{k}", last, f"piece{k}.start")
        last = f"piece{k}.end"
    scene.measure("tip", "y", of=last).measure("angle", "angle", of=last)
    return scene.initial({f"piece{k}.theta": 0.1 for k in range(count)})


@pytest.mark.long
def test_beside_a_run_that_is_given_it_tells_what_new_runs_tell() -> None:
    """Its samples, which no other run has, are where models are compared; half the pieces are the only knob."""
    model = long_swing(2).model()
    run = model.simulate(t_end=0.5, scheme="exponential_adams", dt=0.5 / 777, parameters={})
    beside = model.convergence(run=run, knobs=["half"])
    alone = model.convergence(t_end=0.5, knobs=["pieces"])
    assert [one.knob for one in beside.turned] == ["piece0.pieces"] and beside.turned[0].to == ("1",)
    for name in ("tip", "angle"):
        assert beside[name].error == pytest.approx(alone[name].error, rel=0.05)
    assert "piece0.modes" in beside.left


def test_a_single_beam_has_no_half() -> None:
    model = swing().model()
    found = model.convergence(run=model.simulate(t_end=0.05), knobs=["half"])
    assert not found.turned and np.isnan(found["tip"].error)
    assert "arm.modes" in found.left and "arm.modes, arm.pieces, arm.axial can be" in str(found)


def test_without_measures_of_a_run_coordinates_that_move() -> None:
    scene = Scene("pendulum").gravity(0, -9.81).rigid("rod", mass=1.0, inertia=0.1, center_of_mass=(0.5, 0.0))
    scene.revolute("hinge", "ground.origin", "rod.origin")
    model = scene.model()
    found = model.convergence(run=model.simulate(t_end=0.1))
    assert list(found.errors) == ["rod.theta"] and "no beams and no flexible bodies" in str(found)


def test_cut_beams_of_a_start_that_contradicts_itself_are_not_compared() -> None:
    """Two beams of 1 m between pins 1.2 m apart, given at angles that do not meet: where they close is no matter
    of the model, and cut ones may close elsewhere."""
    scene = Scene("roof").ground(markers={"far": {"position": (1.2, 0.0)}})
    for name in ("left", "right"):
        scene.beam(name, length=LENGTH, **STEEL, lateral={"modes": 1})
    scene.revolute("A", "ground.origin", "left.start").revolute("B", "left.end", "right.start")
    scene.revolute("C", "right.end", "ground.far").gravity(0.0, -9.81)
    scene.measure("ridge", "y", of="left.end").initial({"left.theta": 0.5, "right.theta": -0.5})
    scene.independent("left.q1", "right.q1")
    model = scene.model()
    run = model.simulate(t_end=0.02)
    assert any(event.kind == "start_changed" for event in run.events)
    found = model.convergence(run=run, knobs=["left.pieces"])
    assert [(one.says, one.why.split(",")[0]) for one in found.changes] == [
        ("not compared", "the start contradicts itself")
    ]


@pytest.mark.parametrize(
    ("asked", "problem"),
    [
        ({"t_end": 1.0}, "t_end.*is that of the run"),
        ({"of": "equilibrium"}, "run.*is a motion"),
        ({"outputs": lambda model: {"x": 1.0}}, "run.*is a motion"),
    ],
)
def test_what_does_not_go_with_a_run(asked: dict[str, Any], problem: str) -> None:
    model = swing().model()
    run = model.simulate(t_end=0.02)
    with pytest.raises(ArgumentError, match=problem):
        model.convergence(run=run, **asked)
    with pytest.raises(ArgumentError, match="of another model"):
        cantilever().model().convergence(run=run)


def test_runs_that_cannot_be_compared_with_are_refused() -> None:
    model = swing().model()
    with pytest.raises(NoResult, match="error of the steps of swing is not known.*switched off"):
        model.convergence(run=model.simulate(t_end=0.002, scheme="rk4", dt=1e-5, error="off"))
    driven = swing().input("push", 0.0, "N").force("hand", "arm.end", "push", 0.0).model()
    run = driven.simulate(t_end=0.02, inputs={"push": lambda t: 0.1 * t})
    with pytest.raises(NoResult, match="followed inputs that it does not hold, push"):
        driven.convergence(run=run)
    given = driven.convergence(run=run, inputs={"push": lambda t: 0.1 * t}, knobs=["modes"])
    assert [one.says for one in given.changes if one.says == "not compared"] == []
