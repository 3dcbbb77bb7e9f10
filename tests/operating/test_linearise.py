"""Linear systems against central differences of the equations, and modes against exact figures."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import pytest

from runtime import ModelError, equilibrium, linearise, mode_motion
from runtime.model import Model
from symgen.scene import Scene, SceneRecord
from symgen.scenes.beams import hub_beam
from tests.support.model_values import condensed_accelerations, evaluate, make_state

Build = Callable[[SceneRecord], Model]
Load = Callable[[str], Model]


def differences(model: Model, at: dict[str, float]) -> tuple[np.ndarray, np.ndarray]:
    """Central differences of the accelerations by (q_i, q_i_dot), loops closed anew at every point; and the state."""
    columns, n = model.independent_columns, len(model.q_i)
    system = linearise(model, at)
    z = np.concatenate([system.state.q_i, system.state.q_i_dot])

    def accelerations(z: np.ndarray) -> np.ndarray:
        state = make_state(model, z[:n], z[n:], guess=system.q)
        return np.asarray(condensed_accelerations(model, state)[columns])

    A = np.zeros((n, 2 * n))
    for k in range(2 * n):
        h = 2e-5 * (1.0 if k >= n or model.q_i[k] not in model.elastic else 1e-3)
        step = np.eye(2 * n)[k] * h
        A[:, k] = (
            8 * (accelerations(z + step) - accelerations(z - step))
            - (accelerations(z + 2 * step) - accelerations(z - 2 * step))
        ) / (12 * h)
    return A, system.A_state[n:]


@pytest.mark.every_push("flexible_four_bar-at2", "four_bar-at1", "slider_crank-at0")
@pytest.mark.parametrize(
    "name, at",
    [
        ("slider_crank", {"crank.theta": 0.7, "crank.theta_dot": 5.0}),
        ("four_bar", {"crank.theta": 1.1, "crank.theta_dot": 3.0}),
        ("flexible_four_bar", {"crank.theta": 1.1, "crank.theta_dot": 3.0}),
        ("flexible_slider_crank_free", {"crank.theta": 0.7, "crank.theta_dot": 150.0}),
        ("double_pendulum", {"upper.theta": 0.3, "lower.theta": -0.4, "upper.theta_dot": 2.0}),
        ("hub_beam", {"hub.theta_dot": 6.0, "beam.q1": 0.05}),
        ("bricard", {"hinge0.angle": 0.3, "hinge0.angle_dot": 1.0}),
    ],
)
def test_it_is_what_central_differences_give(built_in: Load, name: str, at: dict[str, float]) -> None:
    """Law: dq_i_ddot/d(q_i, q_i_dot), through the loops, is -M^-1 (K, D) with the accelerations' own terms in K."""
    wanted, found = differences(built_in(name), at)
    assert np.abs(wanted - found).max() < 1e-7 * np.abs(wanted).max()


def oscillator(damping: float = 0.6) -> SceneRecord:
    """1.5 kg on a spring of 40 N/m along x, with a force F and gravity pulling along it."""
    return (
        Scene("oscillator")
        .parameter("F", 0.0, "N", "force")
        .rigid("mass", mass=1.5, inertia=1.0)
        .prismatic("guide", "ground.origin", "mass.origin", damping=damping)
        .measure("out", "x", of="mass.origin")
        .force("spring", "mass.origin", "F - 40 * out", 0.0)
        .build()
    )


def test_frequency_response(model_of: Build) -> None:
    """Hand: H = 1 / (k - m w^2 + i c w) from the load parameter and from the force on the coordinate."""
    model = model_of(oscillator())
    system = linearise(model, inputs=["F", "mass.x"], outputs=["out", "mass.x_dot"])
    w = np.array([0.5, math.sqrt(40 / 1.5), 12.0])
    exact = 1 / (40 - 1.5 * w**2 + 0.6j * w)
    H = system.frequency_response(w)
    for column in (0, 1):
        np.testing.assert_allclose(H[:, 0, column], exact, rtol=1e-12)
        np.testing.assert_allclose(H[:, 1, column], 1j * w * exact, rtol=1e-12)
    assert (
        system.units["F"] == "N"
        and system.units["out"] == "m"
        and system.units["mass.x"] == "m"
        and system.units["force on mass.x"] == "N"
    )


def test_state_space_forms(model_of: Build) -> None:
    """SciPy's response of the first-order form is the hand-derived one."""
    system = linearise(model_of(oscillator()), inputs=["F"], outputs=["out"])
    w = np.array([0.7, 5.0, 9.0])
    exact = 1 / (40 - 1.5 * w**2 + 0.6j * w)
    form = system.to_scipy()
    found = [(form.C @ np.linalg.solve(1j * x * np.eye(2) - form.A, form.B) + form.D)[0, 0] for x in w]
    np.testing.assert_allclose(found, exact, rtol=1e-12)


def test_python_control_has_the_names_and_the_response(model_of: Build) -> None:
    """Its response by names is the hand-derived one."""
    control = pytest.importorskip("control")
    system = linearise(model_of(oscillator()), inputs=["F"], outputs=["out", "mass.x_dot"])
    form = system.to_control()
    assert form.state_labels == ["mass_x", "mass_x_dot"] and form.input_labels == ["F"] and form.isctime()
    assert form.output_labels == ["out", "mass_x_dot"]
    w = np.array([0.7, 5.0, 9.0])
    exact = 1 / (40 - 1.5 * w**2 + 0.6j * w)
    outputs = [f"{form.name}.{name}" for name in ("mass_x_dot", "out")]
    both = control.interconnect([form], inplist=[f"{form.name}.F"], outlist=outputs)
    np.testing.assert_allclose(both(1j * w)[:, 0], [1j * w * exact, exact], rtol=1e-12)


def test_outputs_and_inputs_through_loops(built_in: Load) -> None:
    """Law: C are central differences of the slider's place; its force acts by virtual work, B = C^T."""
    model, at, h = built_in("slider_crank"), {"crank.theta": 0.7}, 1e-5
    system = linearise(model, at, inputs=["slider.x"], outputs=["slider.x"])
    places = [
        make_state(model, system.state.q_i + step, np.zeros(1), guess=system.q).q[model.coordinates.index("slider.x")]
        for step in (h, -h)
    ]
    assert system.C[0, 0] == pytest.approx((places[0] - places[1]) / (2 * h), rel=1e-8)
    assert system.B[0, 0] == pytest.approx(system.C[0, 0], rel=1e-13)


def test_parameters_of_loads_as_inputs(built_in: Load) -> None:
    """Law: B is the central difference of M_hat times the accelerations by the parameter, its lengths included."""
    model = built_in("four_bar")
    at = {"crank.theta": 1.1}
    name = next(entry.name for entry in model.parameters if entry.name.startswith("gravity"))
    value = model.parameter_vector()[[entry.name for entry in model.parameters].index(name)]
    system = linearise(model, at, inputs=[name])
    forces = []
    for step in (1e-4, -1e-4):
        p = model.parameter_vector({name: value + step})
        state = make_state(model, system.state.q_i, system.state.q_i_dot, guess=system.q)
        forces.append(evaluate(model, "condensed", p, **state.values())["Q_hat"])
    np.testing.assert_allclose(system.B[:, 0], (forces[0] - forces[1]) / 2e-4, rtol=1e-8)


@pytest.mark.long
def test_a_small_basis_is_told(model_of: Build) -> None:
    """Two modes at 12 times the unit speed are off by more than a per cent, and the system says so; twelve do not."""
    few, many = (model_of(hub_beam(modes=count)) for count in (2, 10))
    speed = {"hub.omega": 12.0}
    told = linearise(few, equilibrium(few, rates=speed)).remarks()
    assert any("take more modes" in remark for remark in told)
    assert not any("take more modes" in r for r in linearise(many, equilibrium(many, rates=speed)).remarks())


def test_a_mode_as_a_motion(built_in: Load) -> None:
    """One period: begun at the extreme, half a period later at the opposite; q'' = -w^2 (q - q_0) throughout."""
    model = built_in("hub_beam")
    system = linearise(model)
    motion = mode_motion(system, 1, frames=8)
    np.testing.assert_allclose(motion.q[4] - system.q, -(motion.q[0] - system.q), atol=1e-12)
    np.testing.assert_allclose(motion.q[8], motion.q[0], atol=1e-12)
    np.testing.assert_allclose(motion.q_ddot, -(system.frequencies[1] ** 2) * (motion.q - system.q), atol=1e-9)
    assert motion.t[-1] == pytest.approx(2 * math.pi / system.frequencies[1])
    shown = [np.abs(motion["hub.theta"]).max() / 0.2, np.abs(motion["beam.q1"]).max() / 0.1]
    assert max(shown) == pytest.approx(1.0)  # rad; a tenth of 1 m, the rows of a hub at the origin having no arm
    with pytest.raises(ModelError, match="there is no mode 9"):
        mode_motion(system, 8)


@pytest.mark.parametrize(
    "request_, message",
    [
        ({"inputs": ["hub.phi"]}, "no input 'hub.phi'"),
        ({"outputs": ["tip"]}, "no output 'tip'"),
        ({"locked": ["beam.q9"]}, "no coordinate 'beam.q9'"),
    ],
)
def test_wrong_requests(built_in: Load, request_: dict, message: str) -> None:
    with pytest.raises(ModelError, match=message):
        linearise(built_in("hub_beam"), **request_)


def test_parameters_go_with_the_place(built_in: Load) -> None:
    model = built_in("hub_beam")
    with pytest.raises(ModelError, match="give them there"):
        linearise(model, equilibrium(model), parameters={"torque": 1.0})
