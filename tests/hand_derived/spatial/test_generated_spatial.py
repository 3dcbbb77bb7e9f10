"""Generated spatial mechanisms equal their hand-derived twins by value, at arbitrary states."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from types import ModuleType
from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from runtime.contract.coordinates import independent, independent_part, whole
from runtime.model import Model
from symgen.scene import SceneRecord
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
from tests.hand_derived.spatial.twin_spatial import (
    euler_G,
    euler_G_dot,
    parameters_A,
    parameters_ddot,
    parameters_dot,
)
from tests.support.model_values import State, evaluate, make_state, relative_error

pytestmark = pytest.mark.long

TOLERANCE = 1e-12
Build = Callable[[SceneRecord], Model]

free_zyx, free_zxz = (twin_free_body.Params(sequence=sequence) for sequence in ("zyx", "zxz"))
flexible_zyx = twin_free_flexible.Params(sequence="zyx")
sprung = replace(twin_spatial_double_pendulum.Params(), k1=3.0, k2=1.2)
CASES: dict[str, tuple[ModuleType, Any, SceneRecord, Any]] = {
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


ORIENTED = {twin_free_body: 3, twin_heavy_top: 0, twin_free_flexible: 3}  # the first of three Euler angles in q_i


def order(model: Model, twin: ModuleType, params: Any) -> list[int]:
    """Positions of the twin's coordinates in q_i: the framework lists joints' coordinates last, after them turns."""
    if twin is twin_spatial_hub_beam:
        return [model.q_i.index("axle.angle"), *(model.q_i.index(f"beam.q{k + 1}") for k in range(len(model.q_i) - 1))]
    if twin in ORIENTED:
        names = [name.partition(".")[2] for name in model.q_i]
        turns = {f"theta{k + 1}": f"turn_{axis}" for k, axis in enumerate("xyz")}
        return [names.index(turns.get(name, name)) for name in twin.coordinates(params)]
    return list(range(len(model.q_i)))


def states(model: Model, scale: float, count: int = 4) -> list[State]:
    rng = np.random.default_rng(5)
    start = independent_part(model, model.initial_q)
    n = len(model.q_i)
    return [make_state(model, start + scale * rng.uniform(-1, 1, n), rng.uniform(-3, 3, n)) for _ in range(count)]


class ByVelocities:
    """A twin in angular velocities: (M, Q) of M w' = Q by (q, w), where turns are rotation vectors.

    A twin in Euler angles has w = T q' with T = diag(1, G): M = T^-T M_hat T^-1, Q = T^-T Q_hat + M T' q'.
    """

    def __init__(self, twin: ModuleType, params: Any) -> None:
        self.twin, self.params, self.first = twin, params, ORIENTED.get(twin)

    def angles(self, turn: Any) -> Any:
        """Of a real rotation vector."""
        return Rotation.from_rotvec(turn).as_euler(self.params.sequence.upper())

    def __call__(self, q: Any, w: Any) -> tuple[Any, Any]:
        """At the twin's coordinates, angles among them, and velocities."""
        if self.first is None:
            return self.twin.M_hat(self.params, q, 0.0), self.twin.Q_hat(self.params, q, w, 0.0)
        own, kind = slice(self.first, self.first + 3), self.params.sequence
        G, q_dot, bias = euler_G(kind, q[own]), w + 0 * q, 0 * (q + w)
        q_dot[own] = np.linalg.solve(G, w[own])
        bias[own] = euler_G_dot(kind, q[own], q_dot[own]) @ q_dot[own]
        back = np.eye(len(q)) + 0 * q[0]
        back[own, own] = np.linalg.inv(G)
        M = back.T @ self.twin.M_hat(self.params, q, 0.0) @ back
        return M, back.T @ self.twin.Q_hat(self.params, q, q_dot, 0.0) + M @ bias

    def start(self, q_i: Any) -> Any:
        """The twin's coordinates for the framework's, in the twin's order."""
        q = q_i.copy()
        if self.first is not None:
            q[self.first : self.first + 3] = self.angles(q_i[self.first : self.first + 3])
        return q

    def step(self, q: Any, k: int) -> Any:
        """The change of the twin's coordinates for a unit of coordinate k; turns are rotations in body axes."""
        unit = np.eye(len(q))[k]
        if self.first is not None:
            own = slice(self.first, self.first + 3)
            unit[own] = np.linalg.solve(euler_G(self.params.sequence, q[own]), unit[own])
        return unit


@pytest.mark.parametrize("name", CASES)
def test_m_hat_and_q_hat(name: str, model_of: Build) -> None:
    twin, params, scene, scale = CASES[name]
    model, by_hand = model_of(scene), ByVelocities(twin, params)
    for state in states(model, scale):
        out, at = evaluate(model, "condensed", **state.values()), order(model, twin, params)
        n = len(at)
        M, Q = by_hand(by_hand.start(state.q_i[at]), state.q_i_dot[at])
        assert relative_error(out["M_hat"].reshape(n, n)[np.ix_(at, at)], M) < TOLERANCE
        assert relative_error(out["Q_hat"][at], Q) < TOLERANCE


@pytest.mark.parametrize("name", CASES)
def test_jacobians(name: str, model_of: Build) -> None:
    """Total derivatives of Q_hat against complex steps of the twin; along rotations in body axes for turns."""
    twin, params, scene, scale = CASES[name]
    model, h, by_hand = model_of(scene), 1e-40, ByVelocities(twin, params)
    for state in states(model, scale, 2):
        n, at = len(state.q_i), order(model, twin, params)
        q, w = by_hand.start(state.q_i[at]), state.q_i_dot[at]
        for kernel, position in (("dQ_hat_dq_i", True), ("dQ_hat_dq_i_dot", False)):
            columns = []
            for k in range(n):
                step = 1j * h * (by_hand.step(q, k) if position else np.eye(n)[k])
                columns.append(np.imag(by_hand(*((q + step, w) if position else (q, w + step)))[1]) / h)
            found = evaluate(model, kernel, **state.values())[kernel].reshape(n, n)[np.ix_(at, at)]
            assert relative_error(found, np.array(columns).T) < 1e-11, kernel


def test_a_free_body_off_its_centre_by_newton_and_euler(model_of: Build) -> None:
    """M_hat couples the origin's motion and the turning: Newton's and Euler's lines about the origin, written down."""
    model = model_of(CASES["free_zyx"][2])
    for state in states(model, 2.0):
        out = evaluate(model, "condensed", **state.values())
        A = Rotation.from_rotvec(state.q_i[3:]).as_matrix()
        M, Q = twin_free_body.by_velocities(free_zyx, A, state.q_i_dot[3:])
        assert relative_error(out["M_hat"].reshape(6, 6), M) < TOLERANCE
        assert relative_error(out["Q_hat"], Q) < TOLERANCE


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
        theta = ByVelocities(twin_heavy_top, twin_params).start(state.q_i)
        theta_dot = np.linalg.solve(euler_G(twin_params.sequence, theta), state.q_i_dot)
        expected = twin_heavy_top.reaction(twin_params, theta, theta_dot, 0.0)
        assert relative_error(joint_forces(top, state)[0, :3], expected) < 1e-11


def joint_forces(model: Model, state: State) -> Any:
    out = evaluate(model, "condensed", **state.values())
    n = len(state.q_i)
    a = np.linalg.solve(out["M_hat"].reshape(n, n), out["Q_hat"])
    a_d = evaluate(model, "accelerations", **state.values(), q_i_ddot=a)["q_d_ddot"]
    q_ddot = whole(model, a, a_d)
    return evaluate(model, "reactions", **state.values(), q_ddot=q_ddot)["joint_forces"].T.reshape(-1, 6)
