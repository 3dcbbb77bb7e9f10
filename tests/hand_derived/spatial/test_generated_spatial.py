"""Generated spatial mechanisms equal their hand-derived twins by value, at arbitrary states."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from types import ModuleType
from typing import Any

import numpy as np
import pytest

from runtime.contract.coordinates import independent, independent_part, whole
from runtime.contract.model import Model
from symgen.scene import Scene
from tests.hand_derived.spatial import spatial_scenes as scenes
from tests.hand_derived.spatial import (
    twin_free_body,
    twin_free_flexible,
    twin_governor,
    twin_heavy_top,
    twin_spatial_double_pendulum,
    twin_spatial_hub_beam,
    twin_spatial_slider_crank,
)
from tests.hand_derived.spatial.twin_spatial import parameters_A, parameters_ddot, parameters_dot
from tests.support.model_values import State, evaluate, make_state, relative_error

TOLERANCE = 1e-12
Build = Callable[[Scene], Model]

free_zyx, free_zxz = (twin_free_body.Params(sequence=sequence) for sequence in ("zyx", "zxz"))
flexible_zyx = twin_free_flexible.Params(sequence="zyx")
sprung = replace(twin_spatial_double_pendulum.Params(), k1=3.0, k2=1.2)
CASES: dict[str, tuple[ModuleType, Any, Scene, Any]] = {
    "free_zyx": (twin_free_body, free_zyx, scenes.free_body(free_zyx), 1.0),
    "free_zxz": (twin_free_body, free_zxz, scenes.free_body(free_zxz), 1.0),
    "heavy_top": (twin_heavy_top, twin_heavy_top.Params(), scenes.heavy_top(twin_heavy_top.Params()), 1.0),
    "double_pendulum": (twin_spatial_double_pendulum, sprung, scenes.double_pendulum(sprung), 2.0),
    "governor": (twin_governor, twin_governor.Params(), scenes.governor(twin_governor.Params()), 0.4),
    "hub_beam": (
        twin_spatial_hub_beam,
        twin_spatial_hub_beam.Params(),
        scenes.hub_beam(twin_spatial_hub_beam.Params()),
        0.5,
    ),
    "free_flexible": (twin_free_flexible, flexible_zyx, scenes.free_flexible(flexible_zyx, "zyx"), 0.7),
    "slider_crank": (
        twin_spatial_slider_crank,
        twin_spatial_slider_crank.Params(),
        scenes.slider_crank(twin_spatial_slider_crank.Params()),
        0.6,
    ),
}


def order(model: Model, twin: ModuleType, params: Any) -> list[int]:
    """Positions of the twin's coordinates in q_i: the framework lists joints' coordinates last."""
    if twin is twin_spatial_hub_beam:
        return [model.q_i.index("axle.angle"), *(model.q_i.index(f"beam.q{k + 1}") for k in range(len(model.q_i) - 1))]
    return list(range(len(model.q_i)))


def states(model: Model, scale: float, count: int = 4) -> list[State]:
    rng = np.random.default_rng(5)
    start = independent_part(model, model.initial_q)
    n = len(model.q_i)
    return [make_state(model, start + scale * rng.uniform(-1, 1, n), rng.uniform(-3, 3, n)) for _ in range(count)]


@pytest.mark.parametrize("name", CASES)
def test_m_hat_and_q_hat(name: str, model_of: Build) -> None:
    twin, params, scene, scale = CASES[name]
    model = model_of(scene)
    for state in states(model, scale):
        out, at = evaluate(model, "condensed", **state.values()), order(model, twin, params)
        q_i, q_i_dot, n = state.q_i[at], state.q_i_dot[at], len(at)
        assert relative_error(out["M_hat"].reshape(n, n)[np.ix_(at, at)], twin.M_hat(params, q_i, 0.0)) < TOLERANCE
        assert relative_error(out["Q_hat"][at], twin.Q_hat(params, q_i, q_i_dot, 0.0)) < TOLERANCE


@pytest.mark.parametrize("name", CASES)
def test_jacobians(name: str, model_of: Build) -> None:
    """Total derivatives of Q_hat against complex steps of the twin."""
    twin, params, scene, scale = CASES[name]
    model, h = model_of(scene), 1e-40
    for state in states(model, scale, 2):
        n, at = len(state.q_i), order(model, twin, params)
        q_i, q_i_dot = state.q_i[at], state.q_i_dot[at]
        for kernel, position in (("dQ_hat_dq_i", True), ("dQ_hat_dq_i_dot", False)):
            columns = []
            for k in range(n):
                step = 1j * h * np.eye(n)[k]
                arguments = (q_i + step, q_i_dot) if position else (q_i, q_i_dot + step)
                columns.append(np.imag(twin.Q_hat(params, *arguments, 0.0)) / h)
            found = evaluate(model, kernel, **state.values())[kernel].reshape(n, n)[np.ix_(at, at)]
            assert relative_error(found, np.array(columns).T) < 1e-11, kernel


def test_any_orientation_gives_the_same_accelerations(model_of: Build) -> None:
    """A free flexible body with Euler parameters against the twin in velocities of body axes."""
    params = twin_free_flexible.Params()
    model = model_of(scenes.free_flexible(params, "euler_parameters"))
    rng = np.random.default_rng(2)
    for _ in range(4):
        e = rng.normal(size=4)
        e /= np.linalg.norm(e)
        e = e if e[0] > 0 else -e
        omega, q_f, q_f_dot = rng.normal(size=3), rng.normal(size=3), rng.normal(size=3)
        q = np.concatenate([rng.normal(size=3), e, q_f])
        q_dot = np.concatenate([rng.normal(size=3), parameters_dot(e, omega), q_f_dot])
        q_i, q_i_dot = independent(model, q, q_dot)
        assert relative_error(q_i_dot[model.places.turns[0]], omega) < 1e-14
        state = make_state(model, q_i, q_i_dot, guess=q)
        out = evaluate(model, "condensed", **state.values())
        a = np.linalg.solve(out["M_hat"].reshape(len(q_i), -1), out["Q_hat"])
        a_d = evaluate(model, "accelerations", **state.values(), q_i_ddot=a)["q_d_ddot"]
        R_ddot, omega_dot, q_f_ddot = twin_free_flexible.accelerations(params, parameters_A(e), omega, q_f, q_f_dot)
        expected = np.concatenate([R_ddot, parameters_ddot(e, omega, omega_dot), q_f_ddot])
        assert relative_error(whole(model, a, a_d), expected) < 1e-11
        assert relative_error(a[model.places.turns[0]], omega_dot) < 1e-11


def test_reactions(model_of: Build) -> None:
    """Force and whole moment of both joints of the double pendulum, and the force in the heavy top's pivot."""
    twin, params = twin_spatial_double_pendulum, sprung
    model = model_of(CASES["double_pendulum"][2])
    for state in states(model, 2.0):
        wrenches = joint_forces(model, state)
        for k, (force, moment) in enumerate(twin.reactions(params, state.q_i, state.q_i_dot, 0.0)):
            assert relative_error(wrenches[k], np.concatenate([force, moment])) < 1e-11
    top, twin_params = model_of(CASES["heavy_top"][2]), twin_heavy_top.Params()
    for state in states(top, 1.0):
        expected = twin_heavy_top.reaction(twin_params, state.q_i, state.q_i_dot, 0.0)
        assert relative_error(joint_forces(top, state)[0, :3], expected) < 1e-11


def joint_forces(model: Model, state: State) -> Any:
    out = evaluate(model, "condensed", **state.values())
    n = len(state.q_i)
    a = np.linalg.solve(out["M_hat"].reshape(n, n), out["Q_hat"])
    a_d = evaluate(model, "accelerations", **state.values(), q_i_ddot=a)["q_d_ddot"]
    q_ddot = whole(model, a, a_d)
    return evaluate(model, "reactions", **state.values(), q_ddot=q_ddot)["joint_forces"].T.reshape(-1, 6)
