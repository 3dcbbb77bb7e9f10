"""Laws of every joint type in space, on markers that turn with the deformation of a flexible body.

C_q and gamma are the derivatives of C along any motion; joint forces satisfy Newton's and Euler's equations;
Joints that place bodies or are equations, and the order of a joint's markers, change neither motion nor forces.
"""

from __future__ import annotations

from collections.abc import Callable

import casadi as ca
import numpy as np
import pytest

from runtime.model import Model
from symgen.generate import model_of
from symgen.scene import SceneRecord
from tests.support.joint_comb import (
    GRAVITY,
    ONE_WAY,
    OTHERS,
    PLACING,
    Variant,
    comb,
    exchanged_coordinates,
    lumps,
    no_placements,
)
from tests.support.model_values import Array, State, evaluate, make_state, relative_error
from tests.support.spatial_motion import Frame, assembled, frames, momentum_rate, place, solve

pytestmark = pytest.mark.long

Build = Callable[[tuple[str, ...], Variant], tuple[SceneRecord, Model]]
WITHOUT_SCREW = tuple(kind for kind in PLACING if kind != "screw")
T = 0.37


@pytest.fixture(scope="module")
def build() -> Build:
    """Scene and model of a comb, its functions derived when they are asked for, once."""
    made: dict[tuple[tuple[str, ...], Variant], tuple[SceneRecord, Model]] = {}

    def get(types: tuple[str, ...], variant: Variant) -> tuple[SceneRecord, Model]:
        if (types, variant) not in made:
            scene = comb(types, variant)
            with no_placements(not variant.placing):
                made[types, variant] = scene, model_of(scene)
        return made[types, variant]

    return get


def states(model: Model, count: int) -> list[State]:
    """Assembled states around the start."""
    rng, n = np.random.default_rng(7), len(model.coordinates)
    return [
        assembled(model, model.initial_q + rng.uniform(-0.4, 0.4, n), rng.uniform(-2, 2, n), T) for _ in range(count)
    ]


def path(scene: SceneRecord, model: Model) -> tuple[Array, Array, Array]:
    """Any q, q_dot and q_ddot: the bodies need not be assembled, but Euler parameters have unit length throughout."""
    rng, n = np.random.default_rng(5), len(model.coordinates)
    q, v, a = rng.normal(size=n), rng.normal(size=n), rng.normal(size=n)
    for body in scene.moving_bodies:
        first = model.coordinates.index(f"{body.name}.e0")
        at = slice(first, first + 4)
        q[at] /= np.linalg.norm(q[at])
        v[at] -= (v[at] @ q[at]) * q[at]
        a[at] -= (a[at] @ q[at] + v[at] @ v[at]) * q[at]
    return q, v, a


@pytest.mark.parametrize(
    "variant",
    [
        Variant(),
        Variant(exchanged=True),
        Variant(base_last=True),
        Variant(placing=False),
    ],
    ids=["parameters", "exchanged", "base last", "equations"],
)
@pytest.mark.parametrize("types", [PLACING, OTHERS], ids=["placing", "others"])
def test_rows_are_derivatives_of_C(build: Build, types: tuple[str, ...], variant: Variant) -> None:
    """C_q q_dot + C_t is the rate of C, and C_q q_ddot - gamma its second rate, far from any assembled position."""
    kinds = types if variant.placing else tuple(kind for kind in types if kind != "screw")
    scene, model = build(kinds, variant)
    q, v, a = path(scene, model)
    kernel, s, t = model.kernel("constraints"), ca.SX.sym("s"), 0.8
    c = model.constants(model.parameter_vector())
    values = {"q": q + s * v + s**2 / 2 * a, "q_dot": v + s * a, "t": t + s, "c": c}
    C = kernel.call({name: values[name] for name in kernel.name_in()})["C"]
    C_dot = ca.jacobian(C, s)
    along = ca.Function("along", [s], [C, C_dot, ca.jacobian(C_dot, s)])
    value, rate, second = (np.asarray(part).ravel() for part in along(0.0))
    out = evaluate(model, "constraints", q=q, q_dot=v, t=t)
    C_q = out["C_q"].reshape(-1, len(q))
    assert {label.partition(".")[0] for label in model.constraints} >= {f"j_{kind}" for kind in kinds}
    np.testing.assert_allclose(out["C"], value, rtol=0, atol=1e-13)
    np.testing.assert_allclose(C_q @ v + out["C_t"], rate, rtol=0, atol=1e-12 * np.abs(rate).max())
    np.testing.assert_allclose(C_q @ a - out["gamma"], second, rtol=0, atol=1e-12 * np.abs(second).max())


@pytest.mark.parametrize("types", [PLACING, OTHERS], ids=["placing", "others"])
def test_forces_satisfy_newton_and_euler(build: Build, types: tuple[str, ...]) -> None:
    """Each body's rate of momentum is its weight plus the joint's force and moment; the whole keeps to its weight."""
    scene, model = build(types, Variant())
    nodes = lumps(types)
    for state in states(model, 2):
        moving, _, forces = solve(scene, model, state)
        rates = {name: momentum_rate(nodes[name], moving[name]) for name in nodes}
        points = marker_points(scene, model, state)
        largest = max(np.abs(force).max() for force in forces.values())
        for kind in types:
            body, (force, moment) = rates[kind], np.split(forces[f"j_{kind}"], 2)
            weight = body.mass * np.array(GRAVITY)
            np.testing.assert_allclose(body.linear, weight + force, atol=1e-10 * largest, err_msg=kind)
            total = np.cross(body.centre, weight) + np.cross(points[kind], force) + moment
            np.testing.assert_allclose(body.angular, total, atol=1e-10 * largest, err_msg=kind)
        weights = {name: rate.mass * np.array(GRAVITY) for name, rate in rates.items()}
        whole = sum(rate.linear for rate in rates.values())
        np.testing.assert_allclose(whole, sum(weights.values()), atol=1e-10 * largest)
        expected = sum(np.cross(rate.centre, weights[name]) for name, rate in rates.items())
        np.testing.assert_allclose(sum(rate.angular for rate in rates.values()), expected, atol=1e-10 * largest)


def marker_points(scene: SceneRecord, model: Model, state: State) -> dict[str, Array]:
    """World position of the marker on each body that hangs on the base."""
    found = {}
    for name, frame in frames(scene, state.q, state.q_dot, 0 * state.q).items():
        if name != "base":
            marker = scene.body(name).markers["at"]
            arm = np.array(marker.position, dtype=float)
            if frame.q_f.size:
                arm = arm + np.array(marker.shape, dtype=float) @ frame.q_f
            found[name] = frame.R + frame.A @ arm
    return found


def same_motion(first: dict[str, Frame], second: dict[str, Frame], tolerance: float) -> None:
    largest = max(np.abs(np.concatenate([f.a, f.alpha, f.q_f_ddot])).max() for f in first.values())
    for name, frame in first.items():
        for part in ("R", "A", "v", "omega", "a", "alpha", "q_f", "q_f_dot", "q_f_ddot"):
            found, expected = getattr(second[name], part), getattr(frame, part)
            scale = largest if part in ("a", "alpha", "q_f_ddot") else 10.0
            assert np.max(np.abs(found - expected), initial=0.0) < tolerance * scale, (name, part)


@pytest.mark.parametrize("types", [WITHOUT_SCREW, OTHERS], ids=["placing", "others"])
def test_joints_as_equations_give_the_same_motion_and_forces(build: Build, types: tuple[str, ...]) -> None:
    """Joints that place bodies by coordinates of their own, against the same joints as equations between bodies."""
    scene, model = build(types, Variant())
    other_scene, other = build(types, Variant(placing=False))
    assert not any(name.startswith("j_") for name in other.coordinates)
    for state in states(model, 2):
        moving, _, forces = solve(scene, model, state)
        twin = place(other_scene, other, moving, T)
        assert np.max(np.abs(evaluate(other, "constraints", **twin.values())["C"])) < 1e-12
        other_moving, _, other_forces = solve(other_scene, other, twin)
        same_motion(moving, other_moving, 1e-10)
        for name, force in forces.items():
            assert relative_error(other_forces[name], force) < 1e-9, name


@pytest.mark.parametrize("types", [PLACING, OTHERS], ids=["placing", "others"])
def test_exchanged_markers_give_the_same_motion_and_opposite_forces(build: Build, types: tuple[str, ...]) -> None:
    """Coordinates change their sign, the force its body: it acts at the other marker then."""
    scene, model = build(types, Variant())
    other_scene, other = build(types, Variant(exchanged=True))
    for state in states(model, 2):
        moving, _, forces = solve(scene, model, state)
        named = [dict(zip(model.coordinates, values, strict=True)) for values in (state.q, state.q_dot)]
        twin = make_state(other, *exchanged_coordinates(other, *named), T, guess=state.q)
        other_moving, _, other_forces = solve(other_scene, other, twin)
        same_motion(moving, other_moving, 1e-10)
        points = marker_points(scene, model, state)
        for kind in types:
            force, moment = np.split(forces[f"j_{kind}"], 2)
            given = other_forces[f"j_{kind}"]
            if kind not in ONE_WAY:  # it acts on the base, at the base's marker: move it to this one
                near = marker_on_base(scene, moving["base"], kind)
                given = -given - np.concatenate([np.zeros(3), np.cross(near - points[kind], given[:3])])
            assert relative_error(given, np.concatenate([force, moment])) < 1e-9, kind


def marker_on_base(scene: SceneRecord, base: Frame, kind: str) -> Array:
    marker = scene.body("base").markers[f"at_{kind}"]
    return base.R + base.A @ (np.array(marker.position) + np.array(marker.shape) @ base.q_f)


def test_order_of_bodies_does_not_matter(build: Build) -> None:
    """The base placed by a joint of a body that is given before it."""
    scene, model = build(PLACING, Variant(base_last=True))
    nodes = lumps(PLACING)
    for state in states(model, 2):
        moving, _, forces = solve(scene, model, state)
        rate = sum(momentum_rate(nodes[name], moving[name]).linear for name in nodes)
        weight = sum(lump.masses.sum() for lump in nodes.values()) * np.array(GRAVITY)
        np.testing.assert_allclose(rate, weight, atol=1e-10 * max(np.abs(f).max() for f in forces.values()))
