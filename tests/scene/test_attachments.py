"""Which shapes a beam gets: what its ends carry decides, unless the scene names them."""

from __future__ import annotations

import pytest

from symgen.scene import BeamBody, Scene, SceneError, SceneRecord, with_ends

STEEL = {"length": 1.0, "density": 7850.0, "area": 1e-4, "second_moment": 1e-9, "youngs_modulus": 2.1e11}
TURNED = {"y": {"at": 0.0, "axis": (0.0, 1.0, 0.0)}, "tip_x": {"at": 1.0, "x_axis": (1.0, 0.0, 0.0)}}


def planar(*attach: str, **beam: object) -> Scene:
    """A beam b with what is named attached to it: "revolute start", "weld end", ..."""
    builder = Scene("one").ground(markers={"far": {"position": (1.0, 0.0)}})
    builder.beam("b", **{**STEEL, "lateral": {"modes": 2}, "axial": {"modes": 1}, "free": True, **beam})
    for k, text in enumerate(attach):
        kind, _, at = text.partition(" ")
        if kind == "force":
            builder.force(f"l{k}", f"b.{at}", 1.0, 0.0)
        elif kind == "torque":
            builder.torque(f"l{k}", f"b.{at}", "sin(t)")
        elif kind == "spring":
            builder.spring_damper(f"l{k}", "ground.far", f"b.{at}", stiffness=1.0)
        elif kind == "damped":
            builder.revolute(f"j{k}", "ground.origin", f"b.{at}", damping=0.1)
        else:
            other = "ground.far" if at == "end" else "ground.origin"
            builder.joint(kind, f"j{k}", other, f"b.{at}")
    return builder


def ends(scene: SceneRecord) -> tuple[str | None, ...]:
    (beam,) = (body for body in with_ends(scene).bodies if isinstance(body, BeamBody))
    return tuple(modes.ends for modes in (beam.lateral, beam.lateral_z, beam.axial) if modes)


@pytest.mark.parametrize(
    ("attach", "lateral", "axial"),
    [
        ((), "free-free", "free-free"),
        (("weld start",), "clamped-free", "fixed-free"),
        (("weld end",), "free-clamped", "free-fixed"),
        (("revolute start",), "pinned-free", "fixed-free"),
        (("spring end",), "free-pinned", "free-fixed"),
        (("revolute start", "point_on_line end"), "pinned-pinned", "fixed-loaded"),
        (("weld start", "force end"), "welded-pinned", "fixed-loaded"),
        (("weld start", "torque end"), "welded-welded", "fixed-free"),
        (("revolute start", "weld end"), "pinned-welded", "fixed-loaded"),
        (("damped start",), "clamped-free", "fixed-free"),
        (("revolute start", "prescribed_angle start"), "clamped-free", "fixed-free"),
    ],
)
def test_ends_by_what_is_attached(attach: tuple[str, ...], lateral: str, axial: str) -> None:
    builder = planar(*(one for one in attach if not one.startswith("prescribed")))
    if any(one.startswith("prescribed") for one in attach):
        builder.prescribed_angle("drive", "ground.origin", "b.start", motion="t")
    scene = builder.build()
    assert ends(scene) == (lateral, axial)
    assert "ends" not in scene.to_toml()  # what the scene leaves open stays open


def test_a_scene_may_say_otherwise() -> None:
    named = {"lateral": {"ends": "clamped-free", "modes": 1}, "axial": {"ends": "fixed-free", "modes": 1}}
    assert ends(planar("weld start", "weld end", **named).build()) == ("clamped-free", "fixed-free")


@pytest.mark.parametrize(
    ("joint", "at_start", "expected"),
    [
        ("revolute", "start", ("pinned-free", "clamped-free")),  # about z: no moment in the xy-plane only
        ("revolute", "y", ("clamped-free", "pinned-free")),
        ("spherical", "start", ("pinned-free", "pinned-free")),
        ("weld", "start", ("clamped-free", "clamped-free")),
    ],
)
def test_a_hinge_in_space_carries_moments_across_its_axis(joint: str, at_start: str, expected: tuple[str, str]) -> None:
    builder = Scene("one", space="spatial")
    planes = {"second_moment_z": 1e-9, "lateral": {"modes": 2}, "lateral_z": {"modes": 2}}
    builder.ground(markers={"y": {"axis": (0.0, 1.0, 0.0)}})
    builder.beam("b", **STEEL, **planes, markers=TURNED)
    builder.joint(joint, "j", "ground.y" if at_start == "y" else "ground.origin", f"b.{at_start}")
    assert ends(builder.build()) == expected


def test_universal_joint_frees_the_axis_of_its_own_fork() -> None:
    """Marker b turns about its x-axis, here across the beam along z: no moment in the xy-plane."""
    builder = Scene("one", space="spatial")
    builder.beam(
        "b", **STEEL, second_moment_z=1e-9, lateral={"modes": 1}, lateral_z={"modes": 1},
        markers={"fork": {"at": 0.0, "axis": (0.0, 1.0, 0.0), "x_axis": (0.0, 0.0, 1.0)}},
    )  # fmt: skip
    builder.joint("universal", "j", "ground.origin", "b.fork")
    assert ends(builder.build()) == ("pinned-free", "clamped-free")


@pytest.mark.parametrize(
    ("fields", "problem"),
    [
        ({"lateral": {"modes": 1}}, r"'b'.lateral.modes.*both ends carry moments, which takes 2 shapes, not 1"),
        ({"elements": 10}, r"'b'.elements: belongs to a mesh; give mesh = .lumped., or leave it out"),
    ],
)
def test_sets_that_cannot_be(fields: dict[str, object], problem: str) -> None:
    with pytest.raises(SceneError, match=problem):
        planar("weld start", "weld end", **fields).build()
