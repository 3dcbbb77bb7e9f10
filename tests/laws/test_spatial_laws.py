"""Laws of spatial mechanisms: momentum, energy, turned worlds, orientation coordinates."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from runtime import reference_solution
from runtime.model import Model
from symgen.scene import Scene, SceneRecord
from tests.hand_derived.spatial import (
    spatial_scenes,
    twin_governor,
    twin_spatial_double_pendulum,
    twin_spatial_slider_crank,
)
from tests.hand_derived.spatial.twin_flexible_nodes import Nodes, scattered
from tests.support.joint_comb import rigid
from tests.support.model_values import (
    State,
    augmented_solution,
    evaluate,
    power_gap,
    random_states,
    reactions,
    relative_error,
)
from tests.support.spatial_motion import assembled, frames, momentum, momentum_rate

pytestmark = pytest.mark.long

Build = Callable[[SceneRecord, frozenset[str] | None], Model]
FULL = frozenset({"constraints", "augmented", "reactions", "energy"})
CONDENSED = frozenset({"condensed", "constraints", "closure", "velocities"})


def loaded(kind: str) -> SceneRecord:
    """A free flexible body with four others and a load of every kind between them, none from outside."""
    base, tip = spatial_scenes.flexible(scattered(8, 2, seed=1)), rigid(scattered(5, 0, seed=2))
    rng = np.random.default_rng(4)

    def marker(turning: bool = False) -> dict[str, Any]:
        bent = {"shape": 0.3 * rng.normal(size=(3, 2)), "rotation": rng.normal(size=(3, 2))} if turning else {}
        return {"position": rng.normal(size=3), "axis": rng.normal(size=3), **bent}

    builder = Scene("loaded", space="spatial")
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
    builder.bushing(
        "rubber",
        "base.m3",
        "three.m1",
        stiffness=[40, 50, 60],
        damping=[1, 2, 3],
        rotational_stiffness=[4, 5, 6],
        rotational_damping=[0.3, 0.2, 0.1],
    )
    builder.torque("motor", "two.m0", "2*sin(t)", reaction="base.m4")
    builder.prescribed_displacement("push", "base.m1", "two.m0", motion="0.2*sin(3*t)")
    return builder.build()


def nodes_of(scene: SceneRecord) -> dict[str, Nodes]:
    return {
        body.name: scattered(8, 2, seed=1) if body.name == "base" else scattered(5, 0, seed=2)
        for body in scene.moving_bodies
    }


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
    builder = Scene("drifting", space="spatial")
    builder.flexible(
        "base",
        **base,
        free=True,
        orientation="zyx",
        markers={
            "m0": {
                "position": [0.4, 0.1, 0.0],
                "axis": [1, 2, 0],
                "shape": 0.2 * np.ones((3, 2)),
                "rotation": [[0.5, 0.1], [0.0, 0.4], [0.2, 0.0]],
            }
        },
    )
    ends = {"m0": {"position": [0, 0.5, 0]}, "m1": {"position": [1, 0, 0]}}
    builder.rigid("one", **tip, orientation="zxy", markers=ends)
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


def in_a_turned_world(scene: SceneRecord) -> SceneRecord:
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
    return SceneRecord.from_dict(data)


@pytest.mark.parametrize(
    "scene",
    [
        spatial_scenes.governor(twin_governor.Params()),
        spatial_scenes.double_pendulum(twin_spatial_double_pendulum.Params()),
        spatial_scenes.slider_crank(twin_spatial_slider_crank.Params()),
    ],
    ids=["governor", "double pendulum", "slider-crank"],
)
def test_a_turned_world_changes_nothing(build: Build, scene: SceneRecord) -> None:
    """M_hat and Q_hat in the joints' coordinates, at the same values of them."""
    here, there = build(scene, CONDENSED), build(in_a_turned_world(scene), CONDENSED)
    assert here.q_i == there.q_i
    assert all(name.partition(".")[2] in ("angle", "travel") for name in here.q_i)
    for state, turned in zip(random_states(here, 3, rigid=0.2), random_states(there, 3, rigid=0.2), strict=True):
        for model, at in ((here, state), (there, turned)):
            assert np.max(np.abs(evaluate(model, "constraints", **at.values())["C"])) < 1e-12
        expected = evaluate(here, "condensed", **state.values())
        found = evaluate(there, "condensed", **turned.values())
        for name in ("M_hat", "Q_hat"):
            assert relative_error(found[name], expected[name]) < 1e-12, name
