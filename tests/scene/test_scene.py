"""Good scenes: the builder and TOML give equal scenes, and the helpers name what is there."""

from __future__ import annotations

import json
import pickle
import tomllib
from pathlib import Path

import numpy as np
import pytest
from pydantic import ValidationError

from symgen.joints.friction import Friction
from symgen.joints.limits import Limits
from symgen.scene import BeamMarker, InitialValue, ModalBody, RigidMarker, Scene, SceneError, SceneRecord

GOOD = sorted((Path(__file__).parents[1] / "bad_scenes" / "good").glob("*.toml"))


def flexible_slider_crank() -> SceneRecord:
    tip = {"tip": {"position": ("l1", 0)}}
    section = {"density": 7870, "area": 6.4e-5, "second_moment": 8e-3**4 / 12, "youngs_modulus": 2e11}
    return (
        Scene("slider_crank", title="Flexible slider-crank")
        .parameter("l1", 0.15, "m", "length of the crank")
        .parameter("l2", 0.3, "m", "length of the rod")
        .gravity(0, -9.81)
        .rigid("crank", mass=0.36, inertia=0.002727, center_of_mass=("l1/2", 0), markers=tip)
        .beam("rod", length="l2", **section, lateral={"ends": "pinned-pinned", "modes": 2}, stiffening=True)
        .rigid("slider", mass=0.075552, inertia=0)
        .revolute("hinge", "ground.origin", "crank.origin", damping=1e-4)
        .revolute("pin", "crank.tip", "rod.start")
        .revolute("wrist", "rod.end", "slider.origin")
        .prismatic("guide", "ground.origin", "slider.origin")
        .measure("angle", "angle", "crank.origin")
        .torque("motor", "crank.origin", "0.1 - 1e-3*angle_dot")
        .groups(slow=["crank.theta"], fast=["rod.q*"])
        .initial({"crank.theta": {"value": 0.1, "fixed": True}, "rod.q1": 1e-5})
        .rates({"crank.theta": 150})
        .simulation(t_end=0.1, dt=1e-4, m=[10], scheme="printed")
        .build()
    )


def test_builder_and_toml_give_equal_scenes() -> None:
    built = flexible_slider_crank()
    text = built.to_toml()
    read = SceneRecord.from_toml_text(text)
    assert read == built
    assert read.to_toml() == text


def test_starting_values_add_up() -> None:
    """A later call says more, or says it anew; what it does not name stays."""
    builder = Scene("two")
    for name in "ab":
        builder.rigid(name, mass=1.0, inertia=1.0, free=True)
    builder.initial({"a.x": 1.0, "b.x": 2.0}).rates({"a.x": 3.0}).initial({"b.x": 4.0, "b.y": 5.0}).rates({"b.x": 6.0})
    start = builder.build().initial
    assert {name: one.value for name, one in start.coordinates.items()} == {"a.x": 1.0, "b.x": 4.0, "b.y": 5.0}
    assert {name: one.value for name, one in start.rates.items()} == {"a.x": 3.0, "b.x": 6.0}


def test_a_rate_among_starting_coordinates_is_shown_its_place() -> None:
    """In Python and in a file."""
    scene = Scene("one").rigid("a", mass=1.0, inertia=1.0, free=True)
    with pytest.raises(SceneError) as refused:
        scene.initial({"a.x_dot": 1.0}).build()
    assert ".rates({'a.x': ...})" in refused.value.remedy and "[initial.rates] 'a.x' = ..." in refused.value.remedy


@pytest.mark.parametrize("path", GOOD, ids=lambda path: path.stem)
def test_round_trip_through_a_file(path: Path, tmp_path: Path) -> None:
    scene = SceneRecord.from_toml(path)
    copy = tmp_path / "copy.toml"
    copy.write_text(scene.to_toml(), encoding="utf-8")
    again = SceneRecord.from_toml(str(copy))
    assert again == scene
    assert again.to_toml() == scene.to_toml()
    assert SceneRecord.from_dict(scene.to_dict()) == scene


def test_text_and_floats_survive_the_round_trip() -> None:
    title, about = 'quotes " and \\ and \u00e9 \U0001f600', "two\n\tlines"
    builder = Scene("a", title=title, description=about).rigid("b", mass=0.1 + 0.2, inertia=5e-324, free=True)
    scene = builder.parameter("p", 1.7976931348623157e308).parameter("q", -1e22).build()
    assert SceneRecord.from_toml_text(scene.to_toml()) == scene


def test_a_file_with_a_byte_order_mark_is_read(tmp_path: Path) -> None:
    path = tmp_path / "scene.toml"
    path.write_bytes(b"\xef\xbb\xbf" + GOOD[0].read_bytes())
    assert SceneRecord.from_toml(path) == SceneRecord.from_toml(GOOD[0])


def test_coordinates_are_in_the_scenes_order() -> None:
    expected = ["crank.x", "crank.y", "crank.theta", "rod.x", "rod.y", "rod.theta", "rod.q1", "rod.q2"]
    assert flexible_slider_crank().coordinates() == [*expected, "slider.x", "slider.y", "slider.theta"]


def test_markers_and_bodies_are_found() -> None:
    scene = flexible_slider_crank()
    assert scene.marker("ground.origin") == (scene.ground, RigidMarker())
    assert scene.marker("crank.center") == (scene.body("crank"), RigidMarker(position=("l1/2", 0.0)))
    assert scene.marker("rod.end") == (scene.body("rod"), BeamMarker(at=1.0))
    assert scene.parameter_defaults() == {"l1": 0.15, "l2": 0.3}
    assert scene.expression("l1*t", "here", ("t",)).evaluate({"l1": 2.0, "t": 3.0}) == 6.0
    with pytest.raises(SceneError, match="did you mean 'crank'"):
        scene.body("crnk")
    with pytest.raises(SceneError, match="did you mean 'tip'"):
        scene.marker("crank.tp")


@pytest.mark.parametrize(
    ("entry", "message"),
    [
        (("revolute", {"marker_a": "ground.origin", "marker_b": "rod.origin", "limits": {"lowr": 0}}),
         r"joints\[0\] 'one'.limits.lowr: unknown key 'lowr'; did you mean 'lower'"),
        (("beam", {"length": 1.0, "lateral": {"mods": 2}}), "lateral.mods: .* did you mean 'modes'"),
        (("rigid", {"mass": 1.0, "markers": {"tip": {"positon": [1.0, 0.0]}}}), "markers.tip.positon: .* 'position'"),
    ],
)  # fmt: skip
def test_a_wrong_key_inside_an_entry_is_found_at_the_call(entry: tuple[str, dict], message: str) -> None:
    """So that the traceback ends at the line that has it."""
    method, fields = entry
    with pytest.raises(SceneError, match=message):
        getattr(Scene("arm"), method)("one", **fields)


def test_modal_integrals_left_out_are_zero() -> None:
    scene = (
        Scene("modal")
        .modal("arm", mass=1, inertia=1, M_ff=np.eye(2), K_ff=np.eye(2), markers={"tip": {"slope": [1, 2]}})
        .prescribed_angle("drive", "ground.origin", "arm.origin", "3*t")
        .build()
    )
    arm, tip = scene.marker("arm.tip")
    assert isinstance(arm, ModalBody)
    assert arm.phi_integral == arm.phi_cross_phi == ((0.0, 0.0), (0.0, 0.0))
    assert (arm.rho_dot_phi, arm.rho_cross_phi, arm.D_ff) == ((0.0, 0.0), (0.0, 0.0), None)
    assert (tip.shape_x, tip.slope) == ((0.0, 0.0), (1.0, 2.0))
    assert scene.marker("arm.origin")[1].shape_y == (0.0, 0.0)
    assert "phi_integral" not in scene.to_toml()


def test_initial_values_have_one_form() -> None:
    initial = flexible_slider_crank().initial
    assert initial.coordinates["crank.theta"] == InitialValue(value=0.1, fixed=True)
    assert initial.rates["crank.theta"] == InitialValue(value=150.0)


def test_a_scene_cannot_be_changed() -> None:
    scene = flexible_slider_crank()
    with pytest.raises(ValidationError):
        scene.name = "other"


def test_the_json_schema_describes_every_section() -> None:
    schema = json.loads(json.dumps(SceneRecord.json_schema()))
    assert set(SceneRecord.model_fields) == set(schema["properties"])
    assert schema["additionalProperties"] is False
    assert "[kg]" in schema["$defs"]["RigidBody"]["properties"]["mass"]["description"]


def test_the_builder_refuses_what_would_be_lost() -> None:
    with pytest.raises(SceneError, match="declared twice"):
        Scene("a").parameter("p", 1).parameter("p", 2)
    with pytest.raises(SceneError, match="has no order"):
        Scene("a").groups(slow={"x", "y"})
    with pytest.raises(SceneError, match="has no order"):
        SceneRecord(name="a", partition={"independent": {"x", "y"}})
    loop: list[object] = []
    loop.append(loop)
    with pytest.raises(SceneError, match="nested too deeply"):
        Scene("a").rigid("b", mass=loop)


def test_direct_construction_raises_scene_errors_that_pickle() -> None:
    with pytest.raises(SceneError) as caught:
        SceneRecord(name="a", bodies=[{"type": "rigid"}])
    copy = pickle.loads(pickle.dumps(caught.value))
    assert str(copy) == str(caught.value)
    assert [str(error) for error in copy.also] == [str(error) for error in caught.value.also]


def test_a_value_too_many_by_place_is_refused() -> None:
    """Loads and joints take what they need by place; the rest is named, and nothing is dropped."""
    with pytest.raises(SceneError, match="one value too many"):
        Scene("s").torque("twist", "arm.end", 30.0, 0.0, 0.0)
    with pytest.raises(SceneError, match="by position and by name"):
        Scene("s").torque("twist", "arm.end", 30.0, value=3.0)


def held() -> Scene:
    return Scene("held").rigid("arm", mass=1.0, inertia=0.1).revolute("hinge", "ground.origin", "arm.origin")


@pytest.mark.parametrize(
    ("scene", "words"),
    [
        (held().force("f", "arm.origin", "STEP(t)", 0), "unknown function 'STEP'; did you mean 'step'?"),
        (held().force("f", "arm.origin", "heaviside(t)", 0), "sqrt, step, table, tan, tanh, where"),
        (held().force("f", "arm.origin", "150 if t < 2 else 0", 0), "write where(t < 2, 150, 0)"),
        (held().revolute("pin", "ground.origin", "arm.origin", friction=40.0), "write friction = {coulomb = 40}"),
        (held().revolute("pin", "ground.origin", "arm.origin", limits=(-1, 1)), "write limits = {lower = -0.3, upper"),
        (Scene("a").rigid("arm", mass=1, inertia=1, markers={"tip": [0.5, 0]}), "write {position = [0.5, 0.0]}"),
        (held().measure("m", "coordinate", of="hinge.angle"), 'write measure(name, "angle", of="arm.origin"'),
        (held().initial({"hinge.angle": 1.0}), "the coordinates are arm.x, arm.y, arm.theta; to see it write measure"),
    ],
)
def test_refusals_say_what_to_write(scene: Scene, words: str) -> None:
    with pytest.raises(SceneError) as refused:
        scene.build()
    assert words in str(refused.value)


@pytest.mark.parametrize("example", [Friction.example, Limits.example])
def test_examples_of_records_are_taken(example: str) -> None:
    name, _, given = example.partition(" = ")
    fields = tomllib.loads(f"{name} = {given}")
    scene = (
        Scene("a").rigid("arm", mass=1, inertia=1).joint("prismatic", "rail", "ground.origin", "arm.origin", **fields)
    )
    assert getattr(scene.build().joints[0], name) is not None


def test_a_scene_is_written_as_a_file(tmp_path: Path) -> None:
    text = held().to_toml(tmp_path / "held.toml")
    assert (tmp_path / "held.toml").read_text(encoding="utf-8") == text
    assert Scene.from_toml(tmp_path / "held.toml").build() == held().build()
