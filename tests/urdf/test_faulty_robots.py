"""Robots whose files lack something or contradict themselves: massless links, impossible moments, assumptions."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from symgen.scene import SceneError
from symgen.urdf import RobotBuilder, RobotWarning, read
from tests.urdf.robots import joint, link, robot

G = 9.81


def reading(folder: Path, text: str, **options: Any) -> RobotBuilder:
    path = folder / "robot.urdf"
    path.write_text(text, encoding="utf-8")
    return read(path, **options)


def gimbal(second: str = "0 1 0", cross: str = '<link name="cross"/>') -> str:
    """A massless cross between a hinge about x and a second one, whose link has 1 kg at 0.2 m."""
    return robot('<link name="base"/>', cross, link("body", 1.0, at="0 0 0.2", moments="0.02 0.02 0.01"),
                 joint("j1", "revolute", "base", "cross", axis="1 0 0"),
                 joint("j2", "revolute", "cross", "body", axis=second))  # fmt: skip


def test_a_massless_link_inside_a_chain(tmp_path: Path) -> None:
    """Angles x, then y, of a body with moments A, A, C and its centre at l on z: its angular velocity in its axes is
    (x' cos y, y', x' sin y), so M = diag((A + m l^2) cos^2 y + C sin^2 y, A + m l^2)."""
    model = reading(tmp_path, gimbal()).model()
    x, y = 0.3, 0.4
    A, C = 0.02 + 1.0 * 0.2**2, 0.01
    expected = np.diag([A * math.cos(y) ** 2 + C * math.sin(y) ** 2, A])
    assert model.mass_matrix([x, y]) == pytest.approx(expected, rel=1e-12, abs=1e-15)
    slope = [-math.sin(x) * math.cos(y), -math.cos(x) * math.sin(y)]  # of the height l cos x cos y
    assert model.gravity([x, y]) == pytest.approx(G * 0.2 * np.array(slope), rel=1e-12)


def test_massless_links_whose_motion_nothing_determines_are_refused_by_name(tmp_path: Path) -> None:
    """At the end of a chain, and between hinges about one axis, also about one that is no axis of a frame."""
    ends = gimbal().replace("</robot>", '<link name="tip"/>' + joint("j3", "revolute", "body", "tip") + "</robot>")
    with pytest.raises(SceneError, match=r"link 'tip': moves and has no mass.*kinematics=True"):
        reading(tmp_path, ends)
    for axis in ("1 0 0", "-2 0 0"):
        with pytest.raises(SceneError, match=r"joint 'j1', joint 'j2': no inertia determines their accelerations"):
            reading(tmp_path, gimbal(axis))
    tilted = gimbal("1 2 3").replace('axis xyz="1 0 0"', 'axis xyz="1 2 3"')
    with pytest.raises(SceneError, match=r"joint 'j1', joint 'j2': no inertia determines their accelerations"):
        reading(tmp_path, tilted)
    point = '<link name="cross"><inertial><mass value="1"/><inertia ixx="0" iyy="0" izz="0"/></inertial></link>'
    with pytest.raises(SceneError, match=r"joint 'j1', joint 'j2'"):
        reading(tmp_path, gimbal("1 0 0", point))


def test_all_faults_of_a_file_come_in_one_message(tmp_path: Path) -> None:
    text = robot('<link name="base"/>', '<link name="a"/>', link("b", moments="1 1 3"), link("c", -1.0), link("d"),
                 *(joint(f"j{one}", "revolute", "base", one) for one in "abcd"))  # fmt: skip
    with pytest.raises(SceneError) as raised:
        reading(tmp_path, text)
    message = str(raised.value)
    assert message.startswith("robot.urdf: has 3 faults:") and len(raised.value.also) == 3
    for part in ("link 'c': has the mass -1", "link 'a': moves and has no mass", "link 'b': no body has its moments"):
        assert part in message
    broken = text.replace("<joint", '<joint type="ball" name="x"/><joint', 1)
    with pytest.raises(SceneError, match=r"has 2 faults:\n.*joint 'x': is of the type 'ball'.*\n.*link 'c'"):
        reading(tmp_path, broken)


def test_moments_that_break_the_triangle_rule_are_taken_as_given_with_the_amount(tmp_path: Path) -> None:
    """1, 1, 3 kg m^2: 3 is 1 above 1 + 1. M about z is what the file says."""
    text = robot('<link name="base"/>', link("rod", moments="1 1 3"), joint("j", "revolute", "base", "rod"))
    with pytest.raises(SceneError, match=r'exceeds the sum of the others by 1 kg m\^2 \(50 %\).*inertia="as_given"'):
        reading(tmp_path, text)
    with pytest.warns(RobotWarning, match=r"link 'rod': .* by 1 kg m\^2 \(50 %\); taken as given"):
        builder = reading(tmp_path, text, inertia="as_given")
    assert [one.item for one in builder.assumed] == ["link 'rod'"]
    assert builder.build().moving_bodies[0].inertia == (1.0, 1.0, 3.0)


HALF = '<link name="rod"><inertial>{}</inertial>{}</link>'
TENSOR = '<inertia ixx="0.1" iyy="0.2" izz="0.15" ixy="0" ixz="0" iyz="0"/>'
ASSUMED = {
    "no tensor": (HALF.format('<origin xyz="0.5 0 0"/><mass value="2"/>', ""), "no moments of inertia", 2 * 0.5**2),
    "moments that are rounding": (
        HALF.format('<origin xyz="0.5 0 0"/><mass value="2"/><inertia ixx="0" iyy="4.1e-18" izz="-1.7e-17" ixy="0" '
                    'ixz="0" iyz="0"/>', ""), "no moments of inertia: 1.7e-17", 2 * 0.5**2,
    ),
    "no mass": (HALF.format(TENSOR, ""), "the mass 0", 0.15),
    "no products": (
        HALF.format('<mass value="2"/><inertia ixx="0.1" iyy="0.2" izz="0.15" iyz="0"/>', ""), "ixy, ixz = 0", 0.15
    ),
    "two inertials": (
        HALF.format('<mass value="2"/>' + TENSOR, '<inertial><mass value="9"/>' + TENSOR + "</inertial>"),
        "the first of its 2 inertials", 0.15,
    ),
}  # fmt: skip


@pytest.mark.parametrize("case", ASSUMED)
def test_what_an_inertial_lacks_is_assumed_with_a_warning(tmp_path: Path, case: str) -> None:
    """The moment about z through the hinge is that of what the file says."""
    rod, says, about_z = ASSUMED[case]
    with pytest.warns(RobotWarning, match=f"link 'rod': {says}"):
        builder = reading(tmp_path, robot('<link name="base"/>', rod, joint("j", "revolute", "base", "rod")))
    (body,) = builder.build().moving_bodies
    assert body.inertia[2] + body.mass * body.center_of_mass[0] ** 2 == pytest.approx(about_z)


def test_white_space_before_the_declaration_and_a_mimic_of_nothing(tmp_path: Path) -> None:
    more = '<mimic joint="left" multiplier="0" offset="0.3"/>'
    text = robot('<link name="palm"/>', link("a"), link("b"), joint("left", "revolute", "palm", "a"),
                 joint("right", "revolute", "a", "b", more=more))  # fmt: skip
    with pytest.warns(RobotWarning) as warned:
        builder = reading(tmp_path, "\n" + text)
    assert "white space before its XML declaration" in str(warned[0].message)
    assert "joint 'right': fixed at 0.3: it mimics by the multiplier 0" in str(warned[0].message)
    (body,) = builder.build().moving_bodies
    assert body.mass == 2.0
    turned = np.array([[math.cos(0.3), -math.sin(0.3)], [math.sin(0.3), math.cos(0.3)]])
    expected = np.diag([0.1, 0.2]) + turned @ np.diag([0.1, 0.2]) @ turned.T
    assert body.inertia[:2] == pytest.approx(np.diag(expected)) and body.products[0] == pytest.approx(expected[0, 1])


def shell() -> str:
    """Two links without inertia: a hinge about z, and a slide along x of the turned link at (0.5, 0, 0.1)."""
    return robot('<link name="base"/>', '<link name="arm"/>', '<link name="slide"/>', '<link name="tool"/>',
                 joint("turn", "revolute", "base", "arm", more='<limit lower="-1" upper="2"/>'),
                 joint("push", "prismatic", "arm", "slide", at="0.5 0 0.1", axis="1 0 0"),
                 joint("flange", "fixed", "slide", "tool", at="0.2 0 0", rpy=f"0 0 {math.pi / 2}"))  # fmt: skip


def test_kinematics_of_a_file_without_inertia(tmp_path: Path) -> None:
    """The tool at (0.7 + s) along the arm turned by phi: p = (r cos phi, r sin phi, 0.1)."""
    with pytest.raises(SceneError, match=r"has 2 faults(.|\n)*kinematics=True"):
        reading(tmp_path, shell())
    found = reading(tmp_path, shell(), kinematics=True).kinematics()
    phi, s = 0.4, 0.25
    r, along, across = (
        0.7 + s,
        np.array([math.cos(phi), math.sin(phi), 0]),
        np.array([-math.sin(phi), math.cos(phi), 0]),
    )
    assert found.coordinates == ["turn", "push"] and found.limits == {"turn": (-1, 2), "push": (-math.inf, math.inf)}
    R, p = found.pose("tool", [phi, s])
    assert p == pytest.approx(r * along + [0, 0, 0.1]) and R[:, 0] == pytest.approx(across)
    J = found.jacobian("tool", [phi, s])
    assert J[:3].T == pytest.approx(np.array([r * across, along])) and J[3:].T == pytest.approx(
        np.array([[0, 0, 1], [0, 0, 0]])
    )
    point = [0.0, 0.3, 0.0]  # along -x of the arm
    assert found.position("tool", [phi, s], point) == pytest.approx((r - 0.3) * along + [0, 0, 0.1])
    assert found.jacobian("tool", [phi, s], point)[:3, 0] == pytest.approx((r - 0.3) * across)
    with pytest.raises(SceneError, match="link 'tol': does not exist; did you mean 'tool'"):
        found.pose("tol", [phi, s])
    with pytest.raises(SceneError, match="q: is not 2 finite numbers; for turn, push"):
        found.pose("tool", [phi])


def test_joints_of_a_kinematic_scene_follow_their_inputs(tmp_path: Path) -> None:
    builder = reading(tmp_path, shell(), kinematics=True)
    assert builder.drives == {"turn": "q_turn", "push": "q_push"} and builder.efforts == {"turn": [], "push": []}
    run = (
        builder.measure("x", "x", of=builder.frames["tool"])
        .model()
        .simulate(t_end=1.0, inputs={"q_turn": lambda t: 0.5 * t, "q_push": lambda t: 0.1 * t})
    )
    assert run.status.ok and run["x"] == pytest.approx((0.7 + 0.1 * run.t) * np.cos(0.5 * run.t), abs=1e-9)
    for options in ({"base": "free"}, {"flexible": {"arm": "x.toml"}}):
        with pytest.raises(SceneError, match="kinematics: does not go with"):
            reading(tmp_path, shell(), kinematics=True, **options)


def test_kinematics_of_a_mimic(tmp_path: Path) -> None:
    """b follows a by 2 a + 0.1: the end of two bars of 1 m, the second one turned by 3 a + 0.1."""
    text = robot('<link name="base"/>', link("l1"), link("l2"), '<link name="end"/>',
                 joint("a", "revolute", "base", "l1"),
                 joint("b", "revolute", "l1", "l2", at="1 0 0", more='<mimic joint="a" multiplier="2" offset="0.1"/>'),
                 joint("c", "fixed", "l2", "end", at="1 0 0"))  # fmt: skip
    found, a = reading(tmp_path, text).kinematics(), 0.3
    b = 3 * a + 0.1
    assert found.coordinates == ["a"]
    assert found.position("end", [a]) == pytest.approx([math.cos(a) + math.cos(b), math.sin(a) + math.sin(b), 0])
    expected = [-math.sin(a) - 3 * math.sin(b), math.cos(a) + 3 * math.cos(b), 0, 0, 0, 3]
    assert found.jacobian("end", [a]).ravel() == pytest.approx(expected)


SHAPES = {
    "box": ('<box size="0.1 0.2 0.3"/>', 0.006, np.array([0.13, 0.10, 0.05]) / 12),
    "sphere": ('<sphere radius="0.1"/>', 4 / 3 * math.pi * 1e-3, np.full(3, 0.4 * 0.01)),
    "cylinder": (
        '<cylinder radius="0.1" length="0.3"/>', math.pi * 0.003, np.array([0.12 / 12, 0.12 / 12, 0.005])
    ),
}  # fmt: skip


@pytest.mark.parametrize("case", SHAPES)
def test_inertia_of_shapes(tmp_path: Path, case: str) -> None:
    """Moments over the mass: (b^2 + c^2) / 12, 2 r^2 / 5, (3 r^2 + h^2) / 12 and r^2 / 2."""
    shape, volume, over_mass = SHAPES[case]
    solid = f'<visual><origin xyz="0 0 0.4"/><geometry>{shape}</geometry></visual>'
    text = robot('<link name="base"/>', f'<link name="rod">{solid}</link>', joint("j", "revolute", "base", "rod"))
    with pytest.warns(RobotWarning, match=r"link 'rod': .* kg of 1 visual shapes at 2700 kg/m\^3"):
        builder = reading(tmp_path, text, default_inertia="meshes", density=2700.0)
    (body,) = builder.build().moving_bodies
    assert body.mass == pytest.approx(2700 * volume) and body.center_of_mass == pytest.approx([0, 0, 0.4])
    assert body.inertia == pytest.approx(2700 * volume * over_mass)
    for options in ({"default_inertia": "meshes"}, {"density": 1.0}, {"default_inertia": "meshes", "density": -1.0}):
        with pytest.raises(SceneError, match="density"):
            reading(tmp_path, text, **options)


def test_inertia_of_a_mesh(tmp_path: Path) -> None:
    """A box of triangles, in mm by its scale; with a face away its convex hull is the same box."""
    trimesh = pytest.importorskip("trimesh")
    solid = '<collision><geometry><mesh filename="box.stl" scale="0.001 0.001 0.001"/></geometry></collision>'
    text = robot('<link name="base"/>', f'<link name="rod">{solid}</link>', joint("j", "revolute", "base", "rod"))
    box = trimesh.creation.box(extents=[100, 200, 300])
    for open_, says in ((False, "shapes at 1000 kg/m.3$"), (True, "1 of them by the convex hull")):
        if open_:
            box.update_faces(np.arange(12) > 0)
        box.export(tmp_path / "box.stl")
        with pytest.warns(RobotWarning, match=says):
            builder = reading(tmp_path, text, default_inertia="meshes", density=1000.0)
        (body,) = builder.build().moving_bodies
        assert body.mass == pytest.approx(6.0) and body.inertia == pytest.approx(6.0 / 12 * np.array([0.13, 0.1, 0.05]))


def test_limits_and_efforts_act(tmp_path: Path) -> None:
    """A rotor of 0.15 kg m^2 under an input of 5 N m, of which the motor gives 3, turns to its end at 0.5 and stays."""
    limit = '<limit lower="-1" upper="0.5" effort="3" velocity="9"/>'
    text = robot('<link name="base"/>', link("rotor"), joint("axle", "revolute", "base", "rotor", more=limit))
    model = reading(tmp_path, text).model()
    assert model.forward_dynamics([0.0], [0.1], parameters={"tau_axle": 5.0}) == pytest.approx(3.0 / 0.15)
    run = model.simulate(t_end=0.4, dt=0.01, scheme="rk4", inputs={"tau_axle": 5.0})
    arrives = math.sqrt(2 * 0.5 / (3.0 / 0.15))
    (impact,) = [one for one in run.events if one.kind == "impact"]
    assert impact.time == pytest.approx(arrives, abs=1e-9) and run["axle.angle"][-1] == pytest.approx(
        0.5, abs=1e-11
    )  # 1e-12 s at 4.5 rad/s
    soft = reading(tmp_path, text, limits={"stiffness": 1e4}, effort=False).model()
    assert soft.forward_dynamics([0.51], [0.0], parameters={"tau_axle": 5.0}) == pytest.approx((5.0 - 100.0) / 0.15)
    beyond = text.replace('lower="-1"', 'lower="0.2"')
    assert reading(tmp_path, beyond).model().simulate(t_end=0.01)["axle.angle"][0] == pytest.approx(0.2)
    crossed = reading(tmp_path, text.replace('lower="-1"', 'lower="1"'))
    assert "limit of axle: lower 1, upper 0.5: lower is not below upper" in [str(one) for one in crossed.dropped]


def test_a_joint_that_was_read_is_changed(tmp_path: Path) -> None:
    limit = '<limit lower="-1" upper="0.5"/><dynamics friction="0.2"/>'
    text = robot('<link name="base"/>', link("rotor"), joint("an axle", "revolute", "base", "rotor", more=limit))
    builder = reading(tmp_path, text).change_joint("an axle", limits=None, friction=None, damping=np.float64(0.3))
    (own,) = builder.build().joints
    assert own.limits is None and own.friction is None and own.damping == 0.3
    with pytest.raises(SceneError, match="joint 'axle': does not exist; did you mean 'an axle'"):
        builder.change_joint("axle", damping=1.0)


def test_against_pinocchio(tmp_path: Path) -> None:
    """Massless links inside, moments that cannot be: M, gravity and Jacobians."""
    pinocchio = pytest.importorskip("pinocchio")
    limit = '<limit effort="1" velocity="1"/>'
    text = robot('<link name="base"/>', '<link name="cross"/>',
                 link("arm", 2.0, "0.1 0.2 0.3", "0.1 -0.4 0.8", "1 1 3"),
                 '<link name="fork"/>', link("hand", 1.0, "0 0.1 0.2", "0.3 0.2 0.1"),
                 joint("j1", "revolute", "base", "cross", "0 0 1", "0.1 0.2 0.3", "1 0 0", limit),
                 joint("j2", "revolute", "cross", "arm", "0.1 0 0", "0 0.2 0", "0 1 1", limit),
                 joint("j3", "prismatic", "arm", "fork", "0 0.3 0.1", "0.4 0 0.1", "0 0 1", limit),
                 joint("j4", "continuous", "fork", "hand", "0.1 0 0.2", "0 0 0.5", "1 1 0"))  # fmt: skip
    with pytest.warns(RobotWarning):
        builder = reading(tmp_path, text, inertia="as_given", effort=False)
    model, found = builder.model(), builder.kinematics()
    theirs = pinocchio.buildModelFromUrdf(str(tmp_path / "robot.urdf"))
    data, q = theirs.createData(), np.array([0.3, -0.4, 0.2, 0.7])
    full = np.array([*q[:3], math.cos(q[3]), math.sin(q[3])])
    M = pinocchio.crba(theirs, data, full)
    M = np.triu(M) + np.triu(M, 1).T
    assert model.mass_matrix(q) == pytest.approx(M, rel=1e-12, abs=1e-14)
    weight = pinocchio.computeGeneralizedGravity(theirs, data, full)
    assert model.gravity(q) == pytest.approx(weight, rel=1e-12, abs=1e-13)
    pinocchio.computeJointJacobians(theirs, data, full)
    pinocchio.updateFramePlacements(theirs, data)
    frame = theirs.getFrameId("hand")
    expected = pinocchio.getFrameJacobian(theirs, data, frame, pinocchio.ReferenceFrame.LOCAL_WORLD_ALIGNED)
    assert found.jacobian("hand", q) == pytest.approx(expected, abs=1e-14)
    assert found.position("hand", q) == pytest.approx(data.oMf[frame].translation, abs=1e-14)
    assert model.jacobian("hand.origin", q) == pytest.approx(expected, abs=1e-13)
