"""Laws of spatial mechanisms: momentum, energy, turned worlds, orientation coordinates, loads, geometry of joints."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
import spatial_scenes
import twin_free_flexible
import twin_governor
import twin_spatial_double_pendulum
import twin_spatial_slider_crank
from joint_comb import MORE, OTHERS, PLACING, SEQUENCES, comb, lumps, rigid
from model_values import Array, State, augmented_solution, evaluate, power_gap, random_states, reactions, relative_error
from scipy.spatial.transform import Rotation
from spatial_motion import Frame, assembled, frames, momentum, momentum_rate, place
from twin_flexible_nodes import Nodes, scattered

from runtime import load_model, reference_solution, simulate
from runtime.model import Model
from symgen.generate import generate
from symgen.scene import Scene, SceneBuilder

Build = Callable[[Scene, frozenset[str] | None], Model]
FULL = frozenset({"constraints", "augmented", "reactions", "energy"})
CONDENSED = frozenset({"condensed", "constraints", "closure", "velocities"})


@pytest.fixture(scope="module")
def build(tmp_path_factory: pytest.TempPathFactory) -> Build:
    """Model of a scene with the named kernels only."""
    return lambda scene, functions: load_model(generate(scene, tmp_path_factory.mktemp("scene"), functions))


def loaded(kind: str) -> Scene:
    """A free flexible body with four others and a load of every kind between them, none from outside, dampers included."""
    base, tip = spatial_scenes.flexible(scattered(8, 2, seed=1)), rigid(scattered(5, 0, seed=2))
    rng = np.random.default_rng(4)

    def marker(turning: bool = False) -> dict[str, Any]:
        bent = {"shape": 0.3 * rng.normal(size=(3, 2)), "rotation": rng.normal(size=(3, 2))} if turning else {}
        return {"position": rng.normal(size=3), "axis": rng.normal(size=3), **bent}

    builder = SceneBuilder("loaded", space="spatial")
    builder.flexible("base", **base, free=True, orientation=kind, markers={f"m{k}": marker(True) for k in range(6)})
    for name in ("one", "two", "three", "four"):
        builder.rigid(name, **tip, orientation=kind, markers={f"m{k}": marker() for k in range(2)})
    builder.revolute("hinge", "base.m0", "one.m0", damping=0.3)
    builder.joint("cylindrical", "slot", "base.m1", "two.m0", damping=0.2, travel_damping=0.7)
    builder.prismatic("slide", "two.m1", "three.m0", damping=0.4)
    builder.joint("spherical", "ball", "base.m2", "four.m0")
    builder.rotational_spring_damper("coil", "base.m0", "one.m0", stiffness=5.0, damping=0.1, free_angle=0.2)
    builder.rotational_spring_damper("twist", "base.m5", "four.m1", stiffness=2.0, damping=0.2)
    builder.spring_damper("spring", "one.m1", "four.m1", stiffness=30.0, damping=2.0, free_length=0.4)
    builder.bushing("rubber", "base.m3", "three.m1", stiffness=[40, 50, 60], damping=[1, 2, 3],
                    rotational_stiffness=[4, 5, 6], rotational_damping=[0.3, 0.2, 0.1])
    builder.torque("motor", "two.m0", "2*sin(t)", reaction="base.m4")
    builder.prescribed_displacement("push", "base.m1", "two.m0", motion="0.2*sin(3*t)")
    return builder.build()


def nodes_of(scene: Scene) -> dict[str, Nodes]:
    return {body.name: scattered(8, 2, seed=1) if body.name == "base" else scattered(5, 0, seed=2)
            for body in scene.moving_bodies}


def random_state(model: Model, seed: int, reach: float = 0.3, t: float = 0.4) -> State:
    rng, n = np.random.default_rng(seed), len(model.coordinates)
    return assembled(model, model.initial_q + reach * rng.uniform(-1, 1, n), rng.uniform(-1, 1, n), t)


@pytest.mark.parametrize("kind", ["euler_parameters", "zyx"])
def test_inner_loads_keep_momentum_and_power_balances(build: Build, kind: str) -> None:
    """Every load, damper and driven joint between two bodies; energy rate = applied + driven - dissipated."""
    scene = loaded(kind)
    model = build(scene, FULL)
    for seed in (1, 2):
        state = random_state(model, seed)
        q_ddot, lam = augmented_solution(model, state)
        assert relative_error(reactions(model, state, q_ddot), lam) < 1e-9
        moving = frames(scene, state.q, state.q_dot, q_ddot)
        rates = [momentum_rate(nodes, moving[name]) for name, nodes in nodes_of(scene).items()]
        for part in ("linear", "angular"):
            found = [getattr(rate, part) for rate in rates]
            assert np.max(np.abs(sum(found))) < 1e-11 * np.max(np.abs(found)), part
        assert power_gap(model, state, q_ddot, lam) < 1e-11
        power = evaluate(model, "energy", **state.values())
        assert power["power_dissipated"] > 0 and power["elastic"] > 0 and power["power_applied"] != 0


def test_momentum_and_energy_of_a_free_tree_in_motion(build: Build) -> None:
    """A flexible body with two others, springs and no damper, integrated: 1e-9 throughout."""
    base, tip = spatial_scenes.flexible(scattered(8, 2, seed=1)), rigid(scattered(5, 0, seed=2))
    base["D_ff"] = None
    builder = SceneBuilder("drifting", space="spatial")
    builder.flexible("base", **base, free=True, orientation="zyx",
                     markers={"m0": {"position": [0.4, 0.1, 0.0], "axis": [1, 2, 0], "shape": 0.2 * np.ones((3, 2)),
                                     "rotation": [[0.5, 0.1], [0.0, 0.4], [0.2, 0.0]]}})
    builder.rigid("one", **tip, orientation="zxy", markers={"m0": {"position": [0, 0.5, 0]}, "m1": {"position": [1, 0, 0]}})
    builder.joint("spherical", "ball", "base.m0", "one.m0")
    builder.spring_damper("spring", "base.origin", "one.m1", stiffness=20.0, free_length=0.5)
    builder.rates({"base.x": 0.3, "base.theta1": 0.8, "base.q1": 0.5, "one.theta3": -0.6})
    scene = builder.build()
    model = build(scene, None)
    solution = reference_solution(model, t_end=2.0, times=np.linspace(0, 2, 9), rtol=1e-10, atol=1e-12)
    assert solution.status.ok
    nodes = nodes_of(scene)
    total = []
    for q, q_dot in zip(solution.q, solution.q_dot, strict=True):
        moving = frames(scene, q, q_dot, 0 * q)
        total.append(np.sum([np.concatenate(momentum(nodes[name], moving[name])) for name in nodes], axis=0))
    total = np.array(total)
    assert np.max(np.abs(total - total[0])) < 1e-9 * np.max(np.abs(total[0]))
    assert np.max(np.abs(solution.total_energy - solution.total_energy[0])) < 1e-9 * np.max(solution.energy["kinetic"])
    assert np.ptp(solution.energy["elastic"]) > 0.1 * np.max(solution.energy["kinetic"])


TURN, SHIFT = Rotation.from_rotvec([0.7, -1.1, 0.4]).as_matrix(), np.array([3.0, -2.0, 5.0])


def in_a_turned_world(scene: Scene) -> Scene:
    """The ground's markers, gravity and forces along world axes turned and moved: the same mechanism elsewhere."""
    data = scene.to_dict()
    data["gravity"] = (TURN @ np.array(data["gravity"], dtype=float)).tolist()
    ground = next((body for body in data["bodies"] if body["type"] == "ground"), None)
    if ground is None:
        ground = {"type": "ground", "name": "ground", "markers": {}}
        data["bodies"].insert(0, ground)
    markers = {**ground.get("markers", {}), "start": {}}
    for name, marker in markers.items():
        z = np.array(marker.get("axis", (0, 0, 1)), dtype=float)
        x = np.array(marker.get("x_axis") or ((0, 0, 1) if abs(z[0]) == np.linalg.norm(z) else (1, 0, 0)), dtype=float)
        place = TURN @ np.array(marker.get("position", (0, 0, 0)), dtype=float) + SHIFT
        markers[name] = {"position": place.tolist(), "axis": (TURN @ z).tolist(), "x_axis": (TURN @ x).tolist()}
    ground["markers"] = markers
    for item in (*data.get("joints", []), *data.get("loads", [])):
        for key, value in item.items():
            item[key] = "ground.start" if value == "ground.origin" else value
        if item["type"] == "force":
            item["components"] = (TURN @ np.array(item["components"], dtype=float)).tolist()
    return Scene.from_dict(data)


@pytest.mark.parametrize("scene", [
    spatial_scenes.governor(twin_governor.Params()),
    spatial_scenes.double_pendulum(twin_spatial_double_pendulum.Params()),
    spatial_scenes.slider_crank(twin_spatial_slider_crank.Params()),
], ids=["governor", "double pendulum", "slider-crank"])
def test_a_turned_world_changes_nothing(build: Build, scene: Scene) -> None:
    """M_hat and Q_hat in the joints' coordinates, at the same values of them."""
    here, there = build(scene, CONDENSED), build(in_a_turned_world(scene), CONDENSED)
    assert here.q_i == there.q_i
    assert all(name.partition(".")[2] in ("angle", "travel") for name in here.q_i)
    for state, turned in zip(random_states(here, 3, rigid=0.2), random_states(there, 3, rigid=0.2), strict=True):
        for model, at in ((here, state), (there, turned)):
            assert np.max(np.abs(evaluate(model, "constraints", **at.values())["C"])) < 1e-12
        expected, found = (evaluate(model, "condensed", **at.values()) for model, at in ((here, state), (there, turned)))
        for name in ("M_hat", "Q_hat"):
            assert relative_error(found[name], expected[name]) < 1e-12, name


def test_all_sequences_of_angles_move_a_free_body_alike(build: Build) -> None:
    """Accelerations of a free flexible body under a force and gravity, against those with Euler parameters."""
    params = twin_free_flexible.Params()
    rng = np.random.default_rng(6)
    q_f, more = rng.normal(size=(3, 3)), rng.normal(size=(4, 3))
    moving = {"body": Frame(more[0], Rotation.from_rotvec([0.4, 0.5, -0.7]).as_matrix(), more[1], more[2], more[3], more[3],
                            q_f[0], q_f[1], q_f[2])}
    found = {}
    for kind in ("euler_parameters", *SEQUENCES):
        scene = spatial_scenes.free_flexible(params, kind)
        model = build(scene, FULL)
        state = place(scene, model, moving, 0.0)
        assert relative_error(frames(scene, state.q, state.q_dot, 0 * state.q)["body"].omega, more[2]) < 1e-12
        frame = frames(scene, state.q, state.q_dot, augmented_solution(model, state)[0])["body"]
        found[kind] = np.concatenate([frame.a, frame.alpha, frame.q_f_ddot])
    for kind in SEQUENCES:
        assert relative_error(found[kind], found["euler_parameters"]) < 1e-11, kind


def loads_from_outside() -> Scene:
    builder = SceneBuilder("pushed", space="spatial")
    builder.ground(markers={"a": {"position": [0.3, -0.2, 0.1], "axis": [1, 1, 0], "x_axis": [0, 0, 1]}})
    builder.rigid("body", **rigid(scattered(5, 0, seed=2)), orientation="xyz", free=True,
                  markers={"m": {"position": [0.2, 0.5, -0.3], "axis": [1, -1, 2], "x_axis": [1, 1, 0]}})
    return builder.force("world", "body.m", 1.0, -2.0, "3 + t").build()


A_GROUND = np.column_stack([[0, 0, 1], np.array([1, -1, 0]) / math.sqrt(2), np.array([1, 1, 0]) / math.sqrt(2)])
M_BODY = np.column_stack([np.array([1, 1, 0]) / math.sqrt(2), np.array([-1, 1, 1]) / math.sqrt(3),
                          np.array([1, -1, 2]) / math.sqrt(6)])
LOADS: dict[str, dict[str, Any]] = {
    "force": {"type": "force", "marker": "body.m", "components": [1.0, -2.0, "3 + t"]},
    "own force": {"type": "force", "marker": "body.m", "components": [1.0, -2.0, "3 + t"], "frame": "body"},
    "torque": {"type": "torque", "marker": "body.m", "value": "2 + t"},
    "spring": {"type": "spring_damper", "marker_a": "ground.a", "marker_b": "body.m", "stiffness": 7.0, "damping": 0.4,
               "free_length": 0.3},
    "bushing": {"type": "bushing", "marker_a": "ground.a", "marker_b": "body.m", "stiffness": [3, 4, 5],
                "damping": [0.1, 0.2, 0.3], "rotational_stiffness": [6, 7, 8], "rotational_damping": [0.4, 0.5, 0.6]},
}


@pytest.mark.parametrize("kind", LOADS)
def test_loads_push_as_they_say(build: Build, kind: str) -> None:
    """Force and moment on a free body against the load's definition; a bushing's rotation is small here (1e-7)."""
    data = loads_from_outside().to_dict()
    data["loads"] = [{"name": "load", **LOADS[kind]}]
    scene, t = Scene.from_dict(data), 0.4
    model = build(scene, FULL)
    rng, tiny = np.random.default_rng(1), 1e-7
    A = A_GROUND @ Rotation.from_rotvec(tiny * np.array([1.0, 2.0, -3.0])).as_matrix() @ M_BODY.T
    A = A if kind == "bushing" else Rotation.from_rotvec([0.3, 0.9, -0.5]).as_matrix()
    R, v, omega = rng.normal(size=3), rng.normal(size=3), tiny * rng.normal(size=3) if kind == "bushing" else rng.normal(size=3)
    state = place(scene, model, {"body": Frame(R, A, v, omega, v, v, *[np.zeros(0)] * 3)}, t)
    frame = frames(scene, state.q, state.q_dot, augmented_solution(model, state)[0])["body"]
    rate = momentum_rate(scattered(5, 0, seed=2), frame)
    arm = A @ np.array([0.2, 0.5, -0.3])
    d, d_dot = R + arm - np.array([0.3, -0.2, 0.1]), v + np.cross(omega, arm)
    length = np.linalg.norm(d)
    along = A_GROUND.T @ d, A_GROUND.T @ d_dot
    force = {"force": np.array([1.0, -2.0, 3 + t]), "own force": A @ M_BODY @ [1.0, -2.0, 3 + t], "torque": np.zeros(3),
             "spring": -(7.0 * (length - 0.3) + 0.4 * d @ d_dot / length) * d / length,
             "bushing": -A_GROUND @ (np.array([3, 4, 5]) * along[0] + np.array([0.1, 0.2, 0.3]) * along[1])}[kind]
    moment = {"torque": (2 + t) * A @ M_BODY[:, 2], "bushing": -A_GROUND @ (
        np.array([6, 7, 8]) * tiny * np.array([1.0, 2.0, -3.0]) + np.array([0.4, 0.5, 0.6]) * (A_GROUND.T @ omega))}
    assert relative_error(rate.linear, force) < 1e-11 if np.any(force) else np.max(np.abs(rate.linear)) < 1e-12
    turning = rate.angular - np.cross(R + arm, rate.linear)
    expected = moment.get(kind, np.zeros(3))
    assert np.max(np.abs(turning - expected)) < (1e-13 if kind == "bushing" else 1e-11)


def relative_pose(scene: Scene, moving: dict[str, Frame], kind: str) -> tuple[Array, Array]:
    """r_b - r_a in the axes of marker a, and the rotation from a to b; markers turn by exact rotations (1, psi / 2)."""
    ends = []
    for name, label in (("base", f"at_{kind}"), (kind, "at")):
        frame, marker = moving[name], scene.body(name).markers[label]
        z, x = np.array(marker.axis, dtype=float), np.array(marker.x_axis, dtype=float)
        z = z / np.linalg.norm(z)
        x = x - (x @ z) * z
        x = x / np.linalg.norm(x)
        axes, place = np.column_stack([x, np.cross(z, x), z]), np.array(marker.position, dtype=float)
        if frame.q_f.size:
            psi = np.array(marker.rotation, dtype=float) @ frame.q_f
            axes = Rotation.from_quat([*psi / 2, 1.0]).as_matrix() @ axes
            place = place + np.array(marker.shape, dtype=float) @ frame.q_f
        ends.append((frame.R + frame.A @ place, frame.A @ axes))
    (r_a, A_a), (r_b, A_b) = ends
    return A_a.T @ (r_b - r_a), A_a.T @ A_b


def test_joints_hold_what_they_say(build: Build) -> None:
    """Relative position and rotation of the two markers of every joint type, and its coordinates, at a large deformation."""
    def turn(axis: str, angle: float) -> Array:
        return Rotation.from_euler(axis, angle).as_matrix()

    for types in (PLACING, OTHERS):
        scene = comb(types, psi=2.0)
        model = build(scene, FULL)
        state = random_state(model, 3, reach=0.5, t=0.9)
        moving, at = frames(scene, state.q, state.q_dot, 0 * state.q), dict(zip(model.coordinates, state.q, strict=True))
        pose = {kind: relative_pose(scene, moving, kind) for kind in types}
        for kind, (d, A) in pose.items():
            assert np.max(np.abs(A.T @ A - np.eye(3))) < 1e-12
            own = {name.partition(".")[2]: value for name, value in at.items() if name.startswith(f"j_{kind}.")}
            angle, travel, zero = own.get("angle", 0.0), own.get("travel", 0.0), np.zeros(3)
            lead = MORE["screw"]["lead"]
            expected = {"revolute": (zero, turn("z", angle)), "prismatic": (np.array([0, 0, travel]), np.eye(3)),
                        "cylindrical": (np.array([0, 0, travel]), turn("z", angle)), "weld": (zero, np.eye(3)),
                        "screw": (np.array([0, 0, lead * angle / (2 * np.pi)]), turn("z", angle)),
                        "universal": (zero, turn("z", own.get("angle1", 0.0)) @ turn("x", own.get("angle2", 0.0))),
                        "planar": (np.array([own.get("x", 0.0), own.get("y", 0.0), 0]), turn("z", angle))}
            if kind in expected:
                assert np.max(np.abs(d - expected[kind][0])) < 1e-11 and np.max(np.abs(A - expected[kind][1])) < 1e-11, kind
        if types == OTHERS:
            t = state.t
            assert np.max(np.abs(pose["spherical"][0])) < 1e-11 and np.max(np.abs(pose["point_on_line"][0][:2])) < 1e-11
            assert abs(np.linalg.norm(pose["distance"][0]) - MORE["distance"]["length"]) < 1e-11
            assert abs(pose["prescribed_displacement"][0][2] - (0.3 + 0.2 * np.sin(2 * t))) < 1e-11
            A = pose["prescribed_angle"][1]
            gap = np.arctan2(A[1, 0], A[0, 0]) - (0.4 + 0.7 * t + np.sin(3 * t) / 5)
            assert abs(np.sin(gap)) < 1e-11


@pytest.mark.parametrize("kind", ["euler_parameters", "zyx"])
def test_prescribed_angle_over_many_turns(build: Build, kind: str) -> None:
    """Eight turns of a driven hinge, as the joint's own coordinate and as an equation between the bodies."""
    builder = SceneBuilder("driven", space="spatial").gravity(0, 0, -9.81)
    builder.rigid("arm", **rigid(scattered(5, 0, seed=2)), orientation=kind, markers={"tip": {"position": [1, 0, 0],
                                                                                          "axis": [0, 1, 0]}})
    builder.rigid("rod", **rigid(scattered(5, 0, seed=3)), orientation=kind, markers={"top": {"axis": [0, 1, 0]}})
    builder.revolute("hinge", "ground.origin", "arm.origin").revolute("swing", "arm.tip", "rod.top")
    builder.prescribed_angle("drive", "ground.origin", "arm.origin", motion="50*t")
    model = build(builder.build(), None)
    solution = simulate(model, t_end=1.0, dt=2e-4, scheme="single_rate", save_every=50, engine="interpreted")
    assert solution.status.ok
    angle = solution["hinge.angle" if kind == "euler_parameters" else "arm.theta1"]
    np.testing.assert_allclose(angle, 50 * solution.t, rtol=0, atol=1e-11)
    assert np.max(solution.constraint_error) < 1e-11
