"""Orientations with angular velocities of their own: equations by hand, orders of all schemes, every orientation alike.

References are derived here from Euler's equations in quaternions and angular velocities, without the project's code.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import casadi as ca
import numpy as np
import pytest
from scipy.integrate import solve_ivp

from runtime import DifferentiableRun, Solution, equilibrium, linearise, resume, simulate
from runtime.contract.coordinates import independent
from runtime.contract.tape import as_function
from runtime.model import Model
from runtime.operating.mode_solver import state_at
from runtime.schemes.catalogue import scheme_kind
from runtime.studies.stability.spectra import StepSpectrum
from symgen.pipeline import derive
from symgen.scene import Scene, SceneError, SceneRecord
from symgen.scenes.spatial import heavy_top, spatial_chain, tumbling_body
from tests.support.model_values import (
    Array,
    augmented_solution,
    condensed_accelerations,
    evaluate,
    make_state,
    reactions,
    relative_error,
)

pytestmark = pytest.mark.long

Build = Callable[..., Model]
OMEGA = ("omega_x", "omega_y", "omega_z")
COUNTED = {ca.OP_INPUT, ca.OP_OUTPUT, ca.OP_CONST}


def product(a: Array, b: Array) -> Array:
    """Of quaternions, scalar first."""
    return np.concatenate([[a[0] * b[0] - a[1:] @ b[1:]], a[0] * b[1:] + b[0] * a[1:] + np.cross(a[1:], b[1:])])


def rotation(e: Array) -> Array:
    """Rotation matrix of a unit quaternion."""
    return np.array([product(product(e, np.r_[0, unit]), e * [1, -1, -1, -1])[1:] for unit in np.eye(3)]).T


def euler(J: Array, e: Array, omega: Array, t_end: float, moment: Callable[[Array], Array] = lambda e: 0.0) -> Array:
    """(e, omega) at t_end of J omega' = moment(e) - omega x J omega, e' = e o omega / 2."""

    def slope(t: float, y: Array) -> Array:
        w = y[4:]
        return np.r_[product(y[:4], np.r_[0, w]) / 2, (moment(y[:4]) - np.cross(w, J * w)) / J]

    return solve_ivp(slope, (0, t_end), np.r_[e, omega], method="DOP853", rtol=1e-13, atol=1e-13).y[:, -1]


def parameters(solution: Solution, body: str) -> Array:
    """Euler parameters of a body at the end."""
    return np.array([solution[f"{body}.e{k}"][-1] for k in range(4)])


def operations(scene: SceneRecord, name: str = "condensed") -> int:
    """Instructions of a function but inputs, outputs and constants."""
    function = as_function(name, derive(scene, frozenset({name})).tapes[name])
    return sum(function.instruction_id(k) not in COUNTED for k in range(function.n_instructions()))


@pytest.mark.parametrize(
    "scheme, steps, error",
    [("rk4", [0.01], 1e-9), ("single_rate", [0.02, 0.01], 2.5e-5), ("exponential", [1e-3], 1e-11)],
)
def test_tumbling_body(built_in: Build, scheme: str, steps: list[float], error: float) -> None:
    """20 s of turning over, at the scene's step; central difference with slope 2; rounding of 20,000 linear systems."""
    wanted = euler(np.array([1.0, 2.0, 3.0]), np.array([1.0, 0, 0, 0]), np.array([0.01, 1, 0.01]), 20.0)
    errors = []
    for dt in steps:
        solution = simulate(built_in("tumbling_body"), scheme=scheme, dt=dt, t_end=20.0, samples=1)
        e = parameters(solution, "body")
        errors.append(np.abs(rotation(e) - rotation(wanted[:4])).max())
        assert not solution.events and abs(e @ e - 1) < 1e-14
        assert np.abs([solution[f"body.{axis}"][-1] for axis in OMEGA] - wanted[4:]).max() < 2 * error
    assert errors[-1] < error
    assert len(errors) == 1 or np.log2(errors[0] / errors[1]) == pytest.approx(2, abs=0.05)


def test_prices() -> None:
    """M_hat and Q_hat: a free body's six products of Euler's equations; chains without what a joint cannot pass."""
    assert operations(tumbling_body()) == 6
    assert operations(heavy_top()) == 17
    assert operations(spatial_chain(3, orientation="euler_parameters")) <= 302
    assert operations(spatial_chain(10, orientation="euler_parameters")) <= 1877


def test_heavy_top_by_hand(built_in: Build) -> None:
    """J_o omega' = r x m A^T g - omega x J_o omega about the foot, at any orientation."""
    model, rng = built_in("heavy_top"), np.random.default_rng(4)
    m, r, g = 15.0, np.array([0.0, 1.0, 0.0]), np.array([0, 0, -9.81])
    J = np.diag([0.234375, 0.46875, 0.234375]) + m * (r @ r * np.eye(3) - np.outer(r, r))
    for _ in range(5):
        theta, omega = rng.normal(size=3), 9 * rng.normal(size=3)
        state = make_state(model, theta, omega)
        e = state.q[[model.coordinates.index(f"top.e{k}") for k in range(4)]]
        size = np.linalg.norm(theta)
        assert relative_error(e, np.r_[np.cos(size / 2), np.sin(size / 2) * theta / size]) < 1e-14
        out = evaluate(model, "condensed", **state.values())
        assert relative_error(out["M_hat"].reshape(3, 3), J) < 1e-14
        wanted = np.cross(r, m * rotation(e).T @ g) - np.cross(omega, J @ omega)
        assert relative_error(out["Q_hat"], wanted) < 1e-13
        found = evaluate(model, "residual_jacobian", **state.values(), q_i_ddot=np.zeros(3))
        tilde = np.cross(np.eye(3), rotation(e).T @ g)  # rows k: e_k x A^T g
        assert relative_error(found["J_q"].reshape(3, 3), np.cross(r, m * -tilde).T) < 1e-12
        by_omega = [-np.cross(unit, J @ omega) - np.cross(omega, J @ unit) for unit in np.eye(3)]
        assert relative_error(found["J_v"].reshape(3, 3), np.array(by_omega).T) < 1e-12


def spinner() -> SceneRecord:
    """A hub that spins freely, a flexible arm on its hinge, a pendulum that hangs from the arm's tip by a ball."""
    builder = Scene("spinner", space="spatial").gravity(0, 0, -3.0)
    builder.rigid("hub", mass=2.0, inertia=[0.2, 0.3, 0.4], free=True, markers={"rim": {"position": [0.3, 0, 0]}})
    builder.beam(
        "arm", length=0.6, density=2700.0, area=1e-4, second_moment=4e-10, second_moment_z=6e-10, youngs_modulus=7e8,
        lateral={"ends": "clamped-free", "modes": 1}, lateral_z={"ends": "clamped-free", "modes": 1},
    )  # fmt: skip
    builder.rigid(
        "bob", mass=0.4, inertia=[0.01, 0.02, 0.015], center_of_mass=[0, 0, -0.2], products=[0.001, 0, 0], markers={}
    )
    builder.revolute("hinge", "hub.rim", "arm.start").joint("spherical", "ball", "arm.end", "bob.origin")
    builder.rates({"hub.omega_x": 1.0, "hub.omega_y": -0.7, "hub.omega_z": 2.0, "bob.omega_z": 4.0, "bob.omega_x": 1.0})
    return builder.simulation(t_end=0.5, dt=0.01, scheme="rk4").build()


SCHEMES: list[tuple[str, dict[str, Any], float, float, float]] = [  # scheme, settings, step, order, error at most
    ("rk4", {}, 8e-3, 4, 1e-6),
    ("single_rate", {}, 4e-3, 2, 2.5e-5),
    ("printed", {"m": [1], "options": {"common_update": "direct"}}, 4e-3, 2, 2.5e-5),
    ("coupled", {"m": [4]}, 8e-3, 2, 5e-5),
    ("exponential", {"m": [4]}, 1e-2, 4, 2e-8),
]


def test_orders_on_a_spinning_flexible_body(model_of: Build) -> None:
    """Free hub, flexible arm, pendulum on a ball: slope and size of the error of every kind of scheme."""
    model = model_of(spinner())

    def end(scheme: str, dt: float, **settings: Any) -> Array:
        solution = simulate(model, scheme=scheme, dt=dt, t_end=0.16, samples=1, **settings)
        assert solution.status.whole
        return np.asarray(solution.q[-1])

    wanted = end("dop853", 2e-3)
    for scheme, settings, dt, order, error in SCHEMES:
        errors = [np.abs(end(scheme, h, **settings) - wanted).max() for h in (dt, dt / 2)]
        assert errors[0] < error, (scheme, errors)
        assert np.log2(errors[0] / errors[1]) == pytest.approx(order, abs=0.25), (scheme, errors)
    for scheme in ("dopri5", "exponential_rk4"):
        assert np.abs(end(scheme, 0.08, options={"tolerance": 1e-6}) - wanted).max() < 1e-8, scheme


def test_accelerations_are_those_in_all_coordinates(model_of: Build) -> None:
    """(38) with angular velocities equals (28) with Euler parameters, and reactions satisfy the equations."""
    model, rng = model_of(spinner()), np.random.default_rng(3)
    start = independent(model, model.initial_q, model.initial_q_dot)[0]
    for _ in range(3):
        reach = np.where([name in model.elastic for name in model.q_i], 0.01, 1.5)
        state = make_state(model, start + reach * rng.uniform(-1, 1, len(start)), rng.uniform(-3, 3, len(start)))
        found = condensed_accelerations(model, state)
        wanted, _ = augmented_solution(model, state)
        assert relative_error(found, wanted) < 1e-9
        lam = reactions(model, state, found)
        out = evaluate(model, "augmented", **state.values())
        n = len(found)
        left = out["M"].reshape(n, n) @ found + out["C_q"].reshape(-1, n).T @ lam - out["Q_star"]
        assert np.abs(left).max() < 1e-9 * np.abs(out["Q_star"]).max()


def test_linear_systems_turn_with_their_bodies(built_in: Build) -> None:
    """Spin about the middle axis grows with sqrt((J3 - J2)(J2 - J1) / (J1 J3)); a level top comes to hang."""
    system = linearise(built_in("tumbling_body"), {"body.omega_x": 0.0, "body.omega_y": 1.3, "body.omega_z": 0.0})
    assert system.names[3:] == ["body.turn_x", "body.turn_y", "body.turn_z"] and system.steady
    assert system.modal.every_eigenvalue.real.max() == pytest.approx(1.3 / np.sqrt(3), rel=1e-12)
    found = equilibrium(built_in("heavy_top"), rates={})
    J = 0.234375 + 15
    assert found["top.z"] == pytest.approx(-1, abs=1e-12) and found.stable
    assert np.abs(found.eigenvalues).max() == pytest.approx(np.sqrt(15 * 9.81 / J), rel=1e-10)


def test_steps_grow_as_the_motion_does(built_in: Build) -> None:
    """On the way over about the middle axis, whatever the scheme keeps: spectra of steps in axes of the body."""
    model = built_in("tumbling_body")
    motion = simulate(model, scheme="rk4", dt=0.01, t_end=1.0)
    state, c = state_at(motion, len(motion.t) // 2), model.constants(model.parameter_vector())
    for scheme in ("rk4", "single_rate", "exponential_adams"):
        steps = StepSpectrum(model, scheme_kind(scheme).build(scheme, model, 0.01, None, {}), c)
        assert np.log(steps(state, 0.01).radius) / 0.01 == pytest.approx(1 / np.sqrt(3), rel=1e-3)
        assert np.abs(steps(state, 0.01).growth).max() < 1e-4


def test_gradient_and_resumed_run(model_of: Build, tmp_path: Path) -> None:
    """Slopes of a run by a mass and a spin are its differences; a resumed run is bitwise the whole one."""
    model, settings = model_of(spinner()), {"scheme": "rk4", "dt": 0.01, "t_end": 0.1}
    run = DifferentiableRun(model, ["bob.e1"], ["bob.mass", "hinge.angle_dot"], **settings)
    found = run.jacobian(run.x0)
    for name, kind in (("bob.mass", "parameters"), ("hinge.angle_dot", "initial")):
        middle = 0.4 if kind == "parameters" else float(model.initial_q_dot[model.coordinates.index("hinge.angle")])
        ends = [simulate(model, **settings, **{kind: {name: middle + sign * 1e-5}})["bob.e1"][-1] for sign in (1, -1)]
        assert found["bob.e1", name][-1] == pytest.approx((ends[0] - ends[1]) / 2e-5, rel=1e-5)

    def stop(t: float, t_end: float) -> None:
        if t >= 0.05:
            raise KeyboardInterrupt

    whole = simulate(model, **settings)
    simulate(model, **settings, checkpoint=tmp_path / "run.npz", checkpoint_every=3, progress=stop)
    assert np.array_equal(resume(model, tmp_path / "run.npz").q, whole.q)


def test_an_orientation_stays_in_one_group() -> None:
    """Its turns move as a whole."""
    data = tumbling_body().to_dict()
    groups = (["body.x", "body.y", "body.z", "body.turn_x"], ["body.turn_y", "body.turn_z"])
    data["partition"] = {"groups": [{"name": f"g{k}", "coordinates": names} for k, names in enumerate(groups)]}
    data["simulation"]["m"] = [2]
    with pytest.raises(SceneError, match="turns of body"):
        derive(SceneRecord.from_dict(data))
