"""Robots from URDF: equations by hand, what is dropped and refused, hostile files."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from runtime import simulate
from symgen.cli import main
from symgen.generate import model_of
from symgen.scene import SceneError, SceneRecord
from symgen.urdf import RobotBuilder, read
from tests.urdf.robots import PENDULUM, joint, link, robot

pytestmark = pytest.mark.long

G = 9.81


def reading(folder: Path, text: str | bytes, **options: object) -> RobotBuilder:
    path = folder / "robot.urdf"
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    return read(path, **options)  # type: ignore[arg-type]


def test_a_pendulum_by_hand(tmp_path: Path) -> None:
    """(I_yy + m l^2) a = -m g l sin q - d v - friction + tau, about y, of any length."""
    model = model_of(reading(tmp_path, PENDULUM).build())
    q, v, tau = 0.7, 1.3, 2.0
    J = 0.35 + 2.0 * 0.4**2
    expected = (-2.0 * G * 0.4 * math.sin(q) - 0.7 * v - 0.1 + tau) / J
    assert model.q_i == ["pivot.angle"]
    assert model.forward_dynamics([q], [v], parameters={"tau_pivot": tau}) == pytest.approx(expected, rel=1e-13)
    assert model.forward_dynamics([q], [v], [tau]) == pytest.approx(expected, rel=1e-13)


def test_names_frames_and_what_is_dropped(tmp_path: Path) -> None:
    builder = reading(tmp_path, PENDULUM)
    assert [str(one) for one in builder.dropped] == ["velocity limit of pivot: 2"]
    assert builder.limits == {"pivot": (-1.0, None, 3.0, 2.0)}
    bare = reading(tmp_path, PENDULUM, damping=False, friction=False, limits=False, effort=False)
    assert [str(one) for one in bare.dropped] == [
        "damping of pivot: 0.7", "friction of pivot: 0.1", "limit of pivot: lower -1", "velocity limit of pivot: 2",
        "effort limit of pivot: 3",
    ]  # fmt: skip
    assert builder.frames == {"world": "ground.origin", "rod": "rod.origin"}
    assert builder.coordinates == {"pivot": ["pivot.angle"]} and builder.efforts == {"pivot": ["tau_pivot"]}
    assert builder.build().name == "test_robot"


def test_slides_by_hand(tmp_path: Path) -> None:
    """A slide along x of a frame turned by rpy = (0, -90 deg, 0) goes up: (m) a = tau - m g; a second one along y."""
    text = robot('<link name="base"/>', link("lift", 3.0), link("cart", 2.0),
                 joint("up", "prismatic", "base", "lift", rpy=f"0 {-math.pi / 2} 0", axis="1 0 0"),
                 joint("side", "prismatic", "lift", "cart", axis="0 1 0"))  # fmt: skip
    model = model_of(reading(tmp_path, text).build())
    a = model.forward_dynamics([0.3, 0.4], [0.1, 0.2], parameters={"tau_up": 60.0, "tau_side": 5.0})
    assert a == pytest.approx([60.0 / 5.0 - G, 2.5], rel=1e-12)


def test_fixed_links_are_one_body_and_massless_ones_frames(tmp_path: Path) -> None:
    """Two spheres at +-(0, 0.3, 0) of the hub, turned with rpy: m = 3, centre at y = 0.1, Steiner about it."""
    text = robot('<link name="base"/>', link("hub", 2.0, at="0 0.3 0", rpy="0 0 0.4", moments="0.1 0.1 0.1"),
                 link("lump", 1.0, at="0 -0.1 0", rpy="1 2 3", moments="0.2 0.2 0.2"), '<link name="tool"/>',
                 joint("axle", "continuous", "base", "hub"),
                 joint("weld", "fixed", "hub", "lump", at="-0.2 0 0", rpy=f"0 0 {math.pi / 2}"),
                 joint("flange", "fixed", "lump", "tool", at="0 0 0.5"))  # fmt: skip
    builder = reading(tmp_path, text)
    (body,) = builder.build().moving_bodies
    # the lump's centre: (-0.2, 0) + turned by 90 degrees (0, -0.1) = (-0.1, 0)
    centre = (np.array([0.0, 0.3]) * 2 + np.array([-0.1, 0.0])) / 3
    assert body.mass == 3.0 and body.center_of_mass == pytest.approx([*centre, 0.0], abs=1e-15)
    apart = np.array([0.1, 0.3])
    assert body.inertia[2] == pytest.approx(0.1 + 0.2 + 2.0 / 3.0 * apart @ apart)
    assert builder.frames["tool"] == "hub.tool"
    assert body.markers["tool"].position == pytest.approx([-0.2, 0.0, 0.5])
    J = body.inertia[2] + 3.0 * centre @ centre
    model = model_of(builder.build())
    assert model.mass_matrix([0.2]) == pytest.approx(J)
    tip = np.array([0.5 * 0 - 0.2, 0.0])
    turned = np.array([-math.sin(0.2) * tip[0], math.cos(0.2) * tip[0], 0, 0, 0, 1])
    assert model.jacobian("hub.tool", [0.2]).ravel() == pytest.approx(turned)


def test_a_free_base_falls(tmp_path: Path) -> None:
    builder = reading(tmp_path, robot(link("trunk", 2.0, at="0.1 0 0")), base="free")
    solution = simulate(model_of(builder.build()), t_end=0.2, dt=1e-2, scheme="rk4")
    assert solution["trunk.z"][-1] == pytest.approx(-G * 0.02, rel=1e-12)


def test_a_floating_joint_of_the_root(tmp_path: Path) -> None:
    text = robot('<link name="world"/>', link("drone"), joint("free", "floating", "world", "drone", at="1 2 3",
                 rpy="0.3 -0.2 2.9"))  # fmt: skip
    model = model_of(reading(tmp_path, text).build())
    start = dict(zip(model.coordinates, model.initial_q, strict=True))
    assert [start[f"drone.{axis}"] for axis in "xyz"] == pytest.approx([1, 2, 3])
    e = np.array([start[f"drone.e{k}"] for k in range(4)])
    half = [np.array([math.cos(a / 2), math.sin(a / 2)]) for a in (0.3, -0.2, 2.9)]
    (cx, sx), (cy, sy), (cz, sz) = half
    expected = [cz * cy * cx + sz * sy * sx, cz * cy * sx - sz * sy * cx, cz * sy * cx + sz * cy * sx,
                sz * cy * cx - cz * sy * sx]  # fmt: skip
    assert e * math.copysign(1, e[0] * expected[0]) == pytest.approx(expected, rel=1e-12)


def test_a_planar_joint_by_hand(tmp_path: Path) -> None:
    """A disc on a vertical plane: it falls in it, and turns by the torque on its angle."""
    text = robot('<link name="wall"/>', link("disc", 2.0, moments="0.1 0.1 0.15"),
                 joint("glide", "planar", "wall", "disc", rpy=f"{math.pi / 2} 0 0"))  # fmt: skip
    builder = reading(tmp_path, text)
    model = model_of(builder.build())
    assert model.q_i == ["glide.x", "glide.y", "glide.angle"] == builder.coordinates["glide"]
    a = model.forward_dynamics([0.1, 0.2, 0.3], [0, 0, 0], parameters={"tau_glide_angle": 0.3, "tau_glide_x": 1.0})
    assert a == pytest.approx([0.5, -G, 2.0], abs=1e-12)


def test_a_mimic_follows(tmp_path: Path) -> None:
    """right = 2 left + 0.1: (I + 4 I) left'' = tau; of itself, of nothing: refused by name."""
    more = '<mimic joint="left" multiplier="2" offset="0.1"/>'
    text = robot('<link name="palm"/>', link("a"), link("b"), joint("left", "revolute", "palm", "a"),
                 joint("right", "revolute", "palm", "b", more=more))  # fmt: skip
    builder = reading(tmp_path, text)
    assert builder.dropped == [] and builder.efforts == {"left": ["tau_left"], "right": []}
    model = model_of(builder.build())
    assert model.q_i == ["left.angle"]
    run = simulate(model, t_end=1.0, dt=0.01, scheme="rk4", parameters={"tau_left": 0.3})
    assert run["left.angle"] == pytest.approx(0.5 * 0.3 / (5 * 0.15) * run.t**2, abs=1e-12)
    assert run["right.angle"] == pytest.approx(2 * run["left.angle"] + 0.1, abs=1e-14)
    for other in ("right", "nobody"):
        with pytest.raises(SceneError, match=f"mimics '{other}', which is no other joint"):
            reading(tmp_path, text.replace('mimic joint="left"', f'mimic joint="{other}"'))
    welded = text.replace('<joint name="right" type="revolute"', '<joint name="right" type="fixed"')
    assert [(one.what, one.name) for one in reading(tmp_path, welded).dropped] == [("mimic", "right")]  # nothing moves


def test_shapes_and_meshes(tmp_path: Path) -> None:
    """Boxes, cylinders, balls in the body's axes; a mesh of a package by its scale; what cannot be drawn is listed."""
    mesh = tmp_path / "my_robot" / "meshes" / "tip.stl"
    mesh.parent.mkdir(parents=True)
    corners = ("0 0 0", "1 0 0", "0 1 0", "0 0 1")
    faces = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]
    facet = "facet normal 0 0 0\nouter loop\n{}endloop\nendfacet\n"
    text = "".join(facet.format("".join(f"vertex {corners[k]}\n" for k in face)) for face in faces)
    mesh.write_text(f"solid tip\n{text}endsolid tip\n", encoding="utf-8")
    visual = '<visual><origin xyz="0 0 0.5"/><geometry>{}</geometry></visual>'
    shapes = ['<box size="1 2 3"/>', '<cylinder radius="0.1" length="2"/>', '<sphere radius="0.2"/>',
              '<mesh filename="package://my_robot/meshes/tip.stl" scale="2 2 2"/>', '<capsule radius="1"/>',
              '<mesh filename="package://elsewhere/a.stl"/>']  # fmt: skip
    arm = link("arm").replace("</link>", "".join(visual.format(shape) for shape in shapes) + "</link>")
    folder = tmp_path / "my_robot" / "urdf"
    folder.mkdir()
    (tmp_path / "my_robot" / "package.xml").write_text("<package/>")
    builder = reading(folder, robot('<link name="base"/>', arm, joint("j", "revolute", "base", "arm")))
    (body,) = builder.build().moving_bodies
    assert [shape.type for shape in body.shape] == ["box", "cylinder", "sphere", "mesh"]
    assert all(shape.position == (0.0, 0.0, 0.5) for shape in body.shape)
    assert np.max(body.shape[3].vertices) == 2.0
    assert [one.detail for one in builder.dropped] == [
        "a capsule is not drawn",
        "package://elsewhere/a.stl is neither in the folder of the URDF nor in its package "
        "(packages=[...] names further folders)",
    ]


def test_meshes_of_other_folders_are_read_where_these_are_named(tmp_path: Path) -> None:
    """Not by ../, file://, package:// or a link; the folder of the URDF and its package need no naming."""
    trimesh = pytest.importorskip("trimesh")
    robots, package, outside = (tmp_path / name for name in ("alone", "arm_description", "outside"))
    for place in (robots, robots / "meshes", package / "urdf", package / "meshes", outside):
        place.mkdir(parents=True, exist_ok=True)
    (package / "package.xml").write_text("<package/>")
    for place in (robots / "meshes", package / "meshes", outside):
        trimesh.creation.box().export(place / "box.stl")
    for place in (robots, package / "urdf"):
        (place / "link.stl").symlink_to(outside / "box.stl")
        (place / "circle.stl").symlink_to(place / "circle.stl")

    def drawn(folder: Path, name: str, **how: Any) -> bool:
        visual = f'<visual><geometry><mesh filename="{name}"/></geometry></visual></link>'
        text = robot('<link name="base"/>', link("a").replace("</link>", visual), joint("j", "revolute", "base", "a"))
        (folder / "robot.urdf").write_text(text, encoding="utf-8")
        builder = read(folder / "robot.urdf", **how)
        return "vertices" in builder.to_toml()

    assert drawn(robots, "meshes/box.stl") and drawn(robots, f"file://{robots}/meshes/box.stl")
    assert drawn(robots, "package://alone/meshes/box.stl")
    for name in ("../meshes/box.stl", "package://arm_description/meshes/box.stl", f"file://{package}/meshes/box.stl"):
        assert drawn(package / "urdf", name) and not drawn(robots, name.replace("../", "../arm_description/"))
    away = ("../outside/box.stl", f"file://{outside}/box.stl", "package://outside/box.stl", "package://x/../../outside/box.stl",
            "link.stl", "circle.stl", str(outside / "box.stl"))  # fmt: skip
    for name in away:
        assert not drawn(robots, name)
        assert drawn(robots, name, packages=[outside]) is (name != "circle.stl")


def test_a_loop_is_closed_by_a_further_joint(tmp_path: Path) -> None:
    """A parallelogram of three links: its coupler turns by nothing, and the two cranks as one."""
    bars = [link(name, 1.0, at="0 0 -0.5") for name in ("left", "right")]
    text = robot('<link name="base"/>', *bars, link("coupler", 1.0, at="1 0 0"),
                 joint("a", "revolute", "base", "left", axis="0 1 0"),
                 joint("b", "revolute", "base", "right", at="2 0 0", axis="0 1 0"),
                 joint("c", "revolute", "left", "coupler", at="0 0 -1", axis="0 1 0"),
                 '<link name="pin"/>', joint("d", "fixed", "coupler", "pin", at="2 0 0"),
                 '<link name="foot"/>', joint("e", "fixed", "right", "foot", at="0 0 -1"))  # fmt: skip
    builder = reading(tmp_path, text)
    model = model_of(builder.spherical("close", builder.frames["pin"], builder.frames["foot"]).build())
    assert model.q_i == ["a.angle"]
    q, J = 0.3, 2 * (0.2 + 0.25) + 1.0
    slope = (2 * 0.5 + 1.0) * G * math.sin(q)
    assert model.mass_matrix([q])[0, 0] == pytest.approx(J, rel=1e-10)
    assert model.gravity([q]) == pytest.approx(slope, rel=1e-10)


BEAM = """
[frame]
rpy = [0.0, 1.5707963267948966, 0.0]

[[bodies]]
type = "beam"
name = "any"
length = 1.2
density = 2700.0
area = 1e-4
second_moment = 1e-9
second_moment_z = 2e-9
youngs_modulus = 7e10
lateral = { modes = 2 }
lateral_z = { modes = 2 }
"""


@pytest.mark.parametrize("at", ["0.01 0 -1.2", "0 0.01 -1.2", "0 0 -1.21", "0 0 0.01"])
def test_what_is_joined_off_the_line_of_a_beam_is_refused(tmp_path: Path, at: str) -> None:
    """To one side, to the other, beyond its end, before its start: by 10 mm each, and the middle is on it."""
    beam = tmp_path / "beam.toml"
    beam.write_text(BEAM, encoding="utf-8")

    def read(place: str) -> None:
        text = robot('<link name="base"/>', link("rod", 0.324, at="0 0 -0.6"), link("lump", 0.5),
                     joint("pivot", "revolute", "base", "rod", axis="0 1 0"),
                     joint("flange", "fixed", "rod", "lump", at=place))  # fmt: skip
        reading(tmp_path, text, flexible={"rod": beam})

    read("0 0 -0.6")
    with pytest.raises(SceneError, match=r"joint 'flange' is at .* off its line of 1.2 m"):
        read(at)


def test_a_link_as_a_beam(tmp_path: Path) -> None:
    """A rod along -z of its link, with a lump welded to its end, hangs as the rigid rod does, and bends."""
    beam = tmp_path / "beam.toml"
    beam.write_text(BEAM, encoding="utf-8")
    text = robot('<link name="base"/>', link("rod", 0.324, at="0 0 -0.6"), link("lump", 0.5),
                 joint("pivot", "revolute", "base", "rod", axis="0 1 0"),
                 joint("flange", "fixed", "rod", "lump", at="0 0 -1.2"))  # fmt: skip
    builder = reading(tmp_path, text, flexible={"rod": beam})
    assert [str(one) for one in builder.dropped] == ["inertial of rod: a flexible body is in its place"]
    scene = builder.build()
    assert [body.type for body in scene.moving_bodies] == ["beam", "rigid"]
    model = model_of(SceneRecord.from_toml_text(scene.to_toml()))
    assert set(model.q_i) == {"pivot.angle", *(f"rod.q{k}" for k in range(1, 5))}
    rod, m = 2700.0 * 1e-4 * 1.2, 0.5
    J = rod * 1.2**2 / 3 + 2700.0 * 2e-9 * 1.2 + m * 1.2**2 + 0.2  # with the sections' own
    q = np.zeros(5)
    q[model.q_i.index("pivot.angle")] = 0.4
    place = model.q_i.index("pivot.angle")
    assert model.mass_matrix(q)[place, place] == pytest.approx(J, rel=1e-9)
    assert model.gravity(q)[place] == pytest.approx((rod * 0.6 + m * 1.2) * G * math.sin(0.4), rel=1e-9)
    stand = reading(tmp_path, robot(link("rod"), link("lump"), joint("flange", "fixed", "rod", "lump", at="0 0 -1.2")),
                    flexible={"rod": beam})  # fmt: skip
    assert model_of(stand.build()).q_i == [f"rod.q{k}" for k in range(1, 5)]
    beam.write_text(BEAM.replace("1.2\n", "1.1\n"), encoding="utf-8")
    with pytest.raises(SceneError, match=r"joint 'flange' is at .* off its line of 1.1 m"):
        reading(tmp_path, text, flexible={"rod": beam})


def test_a_beam_may_be_shorter_than_a_metre(tmp_path: Path) -> None:
    """About its hinge rho A l^3 / 3, with the sections' own rho I l, and the lump on its end; l = 0.6 m."""
    beam = tmp_path / "beam.toml"
    beam.write_text(BEAM.replace("length = 1.2", "length = 0.6"), encoding="utf-8")
    text = robot('<link name="base"/>', link("rod", 0.162, at="0 0 -0.3"), link("lump", 0.5),
                 joint("pivot", "revolute", "base", "rod", axis="0 1 0"),
                 joint("flange", "fixed", "rod", "lump", at="0 0 -0.6"))  # fmt: skip
    model = model_of(reading(tmp_path, text, flexible={"rod": beam}).build())
    place = model.q_i.index("pivot.angle")
    J = 0.27 * 0.6**3 / 3 + 2700.0 * 2e-9 * 0.6 + 0.5 * 0.6**2 + 0.2
    assert model.mass_matrix(np.zeros(5))[place, place] == pytest.approx(J, rel=1e-9)


MODAL = """
[[bodies]]
type = "flexible"
name = "any"
mass = 2.0
first_moment = [1.0, 0.0, 0.0]
inertia_moments = [[0.7, 0.0, 0.0], [0.0, 0.01, 0.0], [0.0, 0.0, 0.01]]
M_ff = [[0.5]]
K_ff = [[800.0]]
markers.tip = { position = [1.0, 0.0, 0.0], shape = [[0.0], [0.0], [1.0]] }
"""


def test_a_link_as_a_finite_element_body(tmp_path: Path) -> None:
    """A ball of 0.3 kg on its tip, on a hinge about y: the moment (int x dm + m L) g cos q, and the force m g cos q on
    the mode, which moves the tip by 1 along z; K q_f beside them."""
    path = tmp_path / "modal.toml"
    path.write_text(MODAL, encoding="utf-8")
    text = robot('<link name="base"/>', link("boom", 2.0, at="0.5 0 0"), link("ball", 0.3),
                 joint("pivot", "revolute", "base", "boom", axis="0 -1 0"),
                 joint("flange", "fixed", "boom", "ball", at="1 0 0"))  # fmt: skip
    model = model_of(reading(tmp_path, text, flexible={"boom": path}).build())
    assert set(model.q_i) == {"pivot.angle", "boom.q1"}
    q = np.array([0.4 if name == "pivot.angle" else 0.001 for name in model.q_i])
    found = dict(zip(model.q_i, model.gravity(q), strict=True))
    arm = 1.0 + 0.3 * 1.0
    assert found["pivot.angle"] == pytest.approx(G * (arm * math.cos(0.4) - 0.3 * 0.001 * math.sin(0.4)), rel=1e-12)
    assert found["boom.q1"] == pytest.approx(800.0 * 0.001 + 0.3 * G * math.cos(0.4), rel=1e-12)
    with pytest.raises(SceneError, match=r"no marker at \(1.1, 0, 0\), where joint 'flange' is; the nearest .*'tip'"):
        reading(tmp_path, text.replace('1 0 0" rpy', '1.1 0 0" rpy'), flexible={"boom": path})
    path.write_text(MODAL.replace('"flexible"', '"rigid"'), encoding="utf-8")
    with pytest.raises(SceneError, match="does not hold one beam or flexible body"):
        reading(tmp_path, text, flexible={"boom": path})


BAD = {
    "no link": (robot(), "has no links"),
    "no joint": (robot(link("a")), "nothing moves on a fixed base"),
    "no inertial": (robot('<link name="a"/><link name="b"/>', joint("j", "revolute", "a", "b")),
                    "link 'b'.*moves and has no mass"),
    "impossible": (robot('<link name="a"/>', link("b", moments="1 1 3"), joint("j", "revolute", "a", "b")),
                   "no body has its moments of inertia 1, 1, 3"),
    "impossible and small": (
        robot('<link name="a"/>', link("b", 1e-4, moments="1e-9 1e-9 3e-9"), joint("j", "revolute", "a", "b")),
        "no body has its moments of inertia 1e-09, 1e-09, 3e-09"),
    "negative mass": (robot(link("a", -1.0)), "link 'a'.*has the mass -1"),
    "no number": (robot(link("a", at="0 0 ${x}")), "xyz of its origin is '0 0 .*xacro"),
    "two numbers": (robot(link("a", at="0 0")), "give 3 finite numbers"),
    "infinite": (robot(link("a", at="0 0 inf")), "give 3 finite numbers"),
    "type": (robot(link("a"), link("b"), joint("j", "ball", "a", "b")), "joint 'j'.*is of the type 'ball'"),
    "parent": (robot(link("a"), link("b"), joint("j", "revolute", "c", "b")), "joint 'j'.*there is no link 'c'"),
    "two parents": (robot(link("a"), link("b"), joint("j", "revolute", "a", "b"), joint("k", "fixed", "a", "b")),
                    "joint 'k'.*already the child of joint 'j'"),
    "circle": (robot(link("a"), link("b"), link("c"), joint("j", "revolute", "b", "c"), joint("k", "fixed", "c", "b")),
               "link 'b'.*is its own descendant"),
    "two roots": (robot(link("a"), link("b")), "links a, b are no joint's child"),
    "twice": (robot(link("a"), link("a")), "link 'a'.*appears twice"),
    "no axis": (robot(link("a"), link("b"), joint("j", "revolute", "a", "b", axis="0 0 0")), "has no direction"),
    "floating in the tree": (
        robot('<link name="w"/>', link("a"), link("b"), joint("j", "revolute", "w", "a"),
              joint("k", "floating", "a", "b")), "joint 'k'.*floats, but is not attached to a fixed root"),
    "sdf": ("<sdf/>", "has the root element 'sdf'"),
}  # fmt: skip


@pytest.mark.parametrize("case", BAD)
def test_bad_robots_are_refused_by_name(tmp_path: Path, case: str) -> None:
    text, problem = BAD[case]
    with pytest.raises(SceneError, match=problem):
        reading(tmp_path, text)


LAUGHS = "".join(f'<!ENTITY l{k} "{f"&l{k - 1};" * 10}">' for k in range(1, 12))
HOSTILE = {
    "billion laughs": f'<!DOCTYPE r [<!ENTITY l0 "ha">{LAUGHS}]><robot name="&l11;"/>',
    "external entity": '<!DOCTYPE r [<!ENTITY x SYSTEM "file:///etc/passwd">]><robot name="&x;"/>',
    "document type": '<!DOCTYPE robot SYSTEM "http://example.org/robot.dtd"><robot/>',
    "deep": "<robot>" + "<link>" * 100_000 + "</link>" * 100_000 + "</robot>",
    "undeclared entity": "<robot>&x;</robot>",
    "no XML": "\0\1\2",
    "not closed": "<robot>",
    "bytes": b"\xff\xfe\xfd",
}


@pytest.mark.parametrize("case", HOSTILE)
def test_hostile_files_are_refused(tmp_path: Path, case: str) -> None:
    with pytest.raises(SceneError, match="document type|deep|is not XML"):
        reading(tmp_path, HOSTILE[case])


def test_the_command_writes_a_scene_and_lists_what_is_not_in_it(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path, out = tmp_path / "robot.urdf", tmp_path / "robot.toml"
    path.write_text(PENDULUM, encoding="utf-8")
    assert main(["import", str(path), "--out", str(out)]) == 0
    said = capsys.readouterr().out
    assert "velocity limit: pivot" in said and "Assumed" not in said
    assert SceneRecord.from_toml(out) == read(path).build()
    assert main(["import", str(path), "--out", str(out), "--force", "--no-friction", "--no-limits"]) == 0
    said = capsys.readouterr().out
    assert "limit: pivot" in said and "friction: pivot" in said
    assert SceneRecord.from_toml(out) == read(path, friction=False, limits=False).build()
    assert main(["import", str(path), "--out", str(out)]) == 2
    assert main(["import", str(path), "--out", str(out), "--force", "--base", "free"]) == 2  # the root has no mass
    assert "link 'world'" in capsys.readouterr().err
