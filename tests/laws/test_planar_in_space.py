"""A planar scene posed in space moves as the planar one, with the same forces; spinning beams stiffen alike."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from scipy.linalg import eigh

from runtime.model import Model
from symgen.pipeline import derive
from symgen.scene import Scene, SceneRecord
from symgen.scenes.linkages import four_bar, slider_crank
from symgen.scenes.pendulums import chain, double_pendulum, pendulum
from tests.support.model_values import (
    Array,
    State,
    condensed_accelerations,
    evaluate,
    joint_forces,
    random_states,
    relative_error,
)
from tests.support.planar_in_space import posed, posed_state
from tests.support.spatial_motion import frames

pytestmark = pytest.mark.long

Build = Callable[[SceneRecord, frozenset[str]], Model]
KERNELS = frozenset({"condensed", "constraints", "closure", "velocities", "accelerations", "reactions"})


def beam_pendulum() -> SceneRecord:
    """A rigid arm, a flexible beam on a hinge with a spring and a damper, a slider with a spring; stiffening kept.

    The section is so small that its rotary inertia, which a planar beam leaves out, is below rounding. Nothing is fixed
    to the rotation of the beam's end, which counts as an angle in the plane and as a rotation (1, psi / 2) in space.
    """
    builder = Scene("beam_pendulum").gravity(0, -9.81)
    builder.ground(markers={"rail": {"position": (0.1, 0.2), "angle": 0.6}})
    builder.rigid("cart", mass=2.0, inertia=0.3, center_of_mass=(0.1, 0.05), markers={"pin": {"position": (0.2, 0.1)}})
    builder.beam(
        "beam",
        length=1.0,
        density=8000.0,
        area=1e-3,
        second_moment=1e-20,
        youngs_modulus=1e22,
        lateral={"ends": "clamped-free", "modes": 2},
        stiffening=True,
        damping_ratio=0.01,
    )
    builder.rigid("tip", mass=0.5, inertia=0.02, center_of_mass=(0.05, 0.0))
    builder.prismatic("slide", "ground.rail", "cart.origin", damping=0.5)
    builder.revolute("hinge", "cart.pin", "beam.start", damping=0.2).revolute("end", "beam.end", "tip.origin")
    builder.rotational_spring_damper("coil", "cart.pin", "beam.start", stiffness=3.0, damping=0.1, free_angle=0.1)
    builder.spring_damper("spring", "ground.rail", "tip.center", stiffness=20.0, damping=1.0, free_length=0.5)
    builder.torque("motor", "tip.origin", "sin(t)", reaction="cart.origin").force("push", "beam.end", 1.0, "2*t")
    return builder.initial({"beam.theta": -0.5}).build()


@pytest.mark.parametrize(
    "scene", [beam_pendulum(), slider_crank(), four_bar(), chain(3)], ids=["beam", "slider-crank", "four-bar", "chain"]
)
def test_planar_scene_in_space(build: Build, scene: SceneRecord) -> None:
    """Accelerations and joint forces; the loops of the linkages have redundant rows across the plane."""
    planar = build(scene, KERNELS)
    in_space = posed(scene, planar)
    spatial = build(in_space, KERNELS)
    for state in random_states(planar, 3, rigid=0.3):
        a, twin = condensed_accelerations(planar, state), posed_state(scene, planar, in_space, spatial, state)
        out = evaluate(spatial, "constraints", **twin.values())
        assert np.max(np.abs(out["C"])) < 1e-12
        assert np.max(np.abs(out["C_q"].reshape(-1, len(twin.q)) @ twin.q_dot + out["C_t"])) < 1e-11
        q_ddot = condensed_accelerations(spatial, twin)
        moving, named = frames(in_space, twin.q, twin.q_dot, q_ddot), dict(zip(planar.coordinates, a, strict=True))
        largest = np.max(np.abs(a))
        for name, frame in moving.items():
            flat = [named[f"{name}.{axis}"] for axis in ("x", "y")]
            elastic = [named[f"{name}.q{k + 1}"] for k in range(frame.q_f.size)]
            expected = np.array([*flat, 0, 0, 0, named[f"{name}.theta"], *elastic])
            found = np.concatenate([frame.a, frame.alpha, frame.q_f_ddot])
            assert np.max(np.abs(found - expected)) < 1e-10 * largest, name
        forces, expected_forces = joint_forces(spatial, twin, q_ddot), joint_forces(planar, state, a)
        scale = max(np.abs(force).max() for force in expected_forces.values())
        for name, force in expected_forces.items():
            in_plane = forces[name][[0, 1, 5]]
            assert np.max(np.abs(in_plane - force)) < 1e-9 * scale, name


def test_the_plane_is_cheaper(build: Build) -> None:
    """M_hat and Q_hat of planar scenes have no more operations than those of their twins in space: why the plane
    has equations of its own (docs/inside/decisions/README.md)."""
    for scene in (pendulum(), double_pendulum(), chain(4), slider_crank()):
        planar = build(scene, frozenset({"condensed", "constraints"}))
        twin = derive(posed(scene, planar), frozenset({"condensed"}))
        assert planar.operations["condensed"] <= twin.functions["condensed"].operations, scene.name


def spinning(axis: str, space: str, speed: float, stiffening: bool = True) -> SceneRecord:
    """A beam along x that turns about z or y at a constant speed."""
    builder = Scene("spinning", space=space)
    section: dict[str, Any] = {
        "length": 10.0,
        "density": 1200.0,
        "area": 1e-3,
        "second_moment": 5e-7,
        "youngs_modulus": 2.8e10,
        "lateral": {"ends": "clamped-free", "modes": 3},
        "stiffening": stiffening,
    }
    marker = {"start": "start"}
    if space == "spatial":
        section |= {"second_moment_z": 5e-7, "lateral_z": {"ends": "clamped-free", "modes": 3}}
        turned = {"axis": (0, 1, 0) if axis == "y" else (0, 0, 1)}
        builder.ground(markers={"hub": turned})
        section["markers"] = {"root": {"at": 0.0, **turned}}
        marker = {"start": "root"}
    else:
        builder.ground(markers={"hub": {}})
    builder.beam("beam", **section).revolute("pivot", "ground.hub", f"beam.{marker['start']}")
    return builder.prescribed_angle("spin", "ground.hub", f"beam.{marker['start']}", motion=f"{speed}*t").build()


def squared_frequencies(model: Model, wanted: tuple[str, ...]) -> Array:
    """Of the modes named, from M_hat and -dQ_hat/dq_i at rest in the spinning frame."""
    n = len(model.q_i)
    zero = np.zeros(n)
    state = State(
        zero,
        model.initial_q[model.dependent_columns],
        zero,
        model.initial_q_dot[model.dependent_columns],
        model.initial_q,
        model.initial_q_dot,
        0.0,
    )
    M = evaluate(model, "condensed", **state.values())["M_hat"].reshape(n, n)
    K = -evaluate(model, "dQ_hat_dq_i", **state.values())["dQ_hat_dq_i"].reshape(n, n)
    at = [model.q_i.index(f"beam.{name}") for name in wanted]
    return np.asarray(eigh(K[np.ix_(at, at)], M[np.ix_(at, at)], eigvals_only=True))


SPIN_KERNELS = frozenset({"condensed", "closure", "velocities", "dQ_hat_dq_i"})
LATERAL, ACROSS = ("q1", "q2", "q3"), ("q4", "q5", "q6")


@pytest.mark.parametrize("speed", [2.0, 6.0])
def test_spinning_beam_stiffens_in_space_as_in_the_plane(build: Build, speed: float) -> None:
    """K + w^2 (G - M) in the plane of rotation, K + w^2 G across it; also with the axis along y."""
    planar = squared_frequencies(build(spinning("z", "planar", speed), SPIN_KERNELS), LATERAL)
    about_z, about_y = (build(spinning(axis, "spatial", speed), SPIN_KERNELS) for axis in "zy")
    assert relative_error(squared_frequencies(about_z, LATERAL), planar) < 1e-9
    assert relative_error(squared_frequencies(about_z, ACROSS), planar + speed**2) < 1e-9
    assert relative_error(squared_frequencies(about_y, ACROSS), planar) < 1e-9
    assert relative_error(squared_frequencies(about_y, LATERAL), planar + speed**2) < 1e-9
    soft = squared_frequencies(build(spinning("z", "spatial", speed, stiffening=False), SPIN_KERNELS), LATERAL)
    assert soft[0] < planar[0] - 0.9 * speed**2  # w^2 G is about 1.2 w^2 for the first mode
    assert math.isclose(soft[0] + speed**2, 3.5160**2 * 1.4e4 / (1.2 * 10**4), rel_tol=2e-3)
