"""Laws of the derived equations, on every built-in scene at random consistent states.

Condensed equals augmented (28)-(38), multipliers (37), M_hat symmetric positive definite, energy and power, Jacobians
against automatic differentiation of the composed function and against central differences.
"""

from __future__ import annotations

from collections.abc import Callable

import casadi as ca
import numpy as np
import pytest

from runtime.model import Model
from symgen.scenes import SCENES
from tests.support.model_values import (
    Array,
    State,
    augmented_solution,
    condensed_accelerations,
    evaluate,
    make_state,
    power_gap,
    random_states,
    reactions,
    relative_error,
)

Load = Callable[[str], Model]
STATES = 4


@pytest.mark.every_push(
    "flexible_slider_crank_torque",
    "flyball_governor",
    "spatial_chain",
    "chain",
    "n_four_bar",
    "pendulum",
    "flexible_four_bar",
)
@pytest.mark.parametrize("name", SCENES)
def test_condensed_equals_augmented(built_in: Load, name: str) -> None:
    model = built_in(name)
    for state in random_states(model, STATES):
        expected, lam = augmented_solution(model, state)
        q_ddot = condensed_accelerations(model, state)
        assert relative_error(q_ddot, expected) < 1e-10
        if model.constraints:
            size = max(float(np.abs(lam).max()), 1e-4 * float(np.abs(expected).max()))  # a free body has no reactions
            assert np.abs(reactions(model, state, q_ddot) - lam).max() < 1e-9 * size


@pytest.mark.parametrize("name", SCENES)
def test_accelerations_satisfy_the_constraints(built_in: Load, name: str) -> None:
    """C = 0, C_q q_dot = -C_t, C_q q_ddot = gamma, and C stays zero to second order for q_d_ddot of any q_i_ddot.

    (Euler parameters must keep their length on the way: the rotation matrix is one at unit length only.)
    """
    model = built_in(name)
    if not model.constraints:
        return
    for state in random_states(model, STATES, seed=2):
        result = evaluate(model, "constraints", **state.values())
        C_q = result["C_q"].reshape(len(model.constraints), -1)
        a = condensed_accelerations(model, state)
        assert np.max(np.abs(result["C"])) < 1e-13 * max(1.0, np.max(np.abs(state.q)))
        assert np.max(np.abs(C_q @ state.q_dot + result["C_t"])) < 1e-12 * max(1.0, np.max(np.abs(state.q_dot)))
        assert np.max(np.abs(C_q @ a - result["gamma"])) < 1e-11 * max(1.0, np.max(np.abs(a)))
        coasting = np.zeros(len(model.coordinates))
        if model.q_d:
            zero = np.zeros(len(model.q_i))
            coasting[model.dependent_columns] = evaluate(model, "accelerations", **state.values(), q_i_ddot=zero)[
                "q_d_ddot"
            ]
        h = 1e-4 / max(1.0, np.max(np.abs(state.q_dot)))
        along = [
            evaluate(
                model,
                "constraints",
                q=state.q + s * state.q_dot + s**2 / 2 * coasting,
                q_dot=state.q_dot,
                t=state.t + s,
            )["C"]
            for s in (-h, 0.0, h)
        ]
        second = (along[0] - 2 * along[1] + along[2]) / h**2  # C_q q_ddot - gamma
        assert np.max(np.abs(second)) < 1e-4 * max(1.0, np.max(np.abs(result["gamma"])))


@pytest.mark.parametrize("name", SCENES)
def test_mass_matrix_is_symmetric_positive_definite(built_in: Load, name: str) -> None:
    model = built_in(name)
    for state in random_states(model, STATES, seed=3):
        M = evaluate(model, "condensed", **state.values())["M_hat"].reshape(len(model.q_i), -1)
        assert relative_error(M, M.T) < 1e-13
        scale = np.sqrt(np.diag(M))
        assert np.min(np.linalg.eigvalsh(M / np.outer(scale, scale))) > 0


@pytest.mark.parametrize("name", SCENES)
def test_kinetic_energy_is_half_v_M_v(built_in: Load, name: str) -> None:
    """In all coordinates, and in q_i where no motion is prescribed."""
    model = built_in(name)
    n = len(model.coordinates)
    for state in random_states(model, STATES, seed=4):
        kinetic = float(evaluate(model, "energy", **state.values())["kinetic"][0])
        M = evaluate(model, "augmented", **state.values())["M"].reshape(n, n)
        assert kinetic == pytest.approx(0.5 * state.q_dot @ M @ state.q_dot, rel=1e-12)
        driven = model.constraints and np.any(evaluate(model, "constraints", **state.values())["C_t"])
        if not driven:
            M_hat = evaluate(model, "condensed", **state.values())["M_hat"].reshape(len(model.q_i), -1)
            assert kinetic == pytest.approx(0.5 * state.q_i_dot @ M_hat @ state.q_i_dot, rel=1e-12)


@pytest.mark.parametrize("name", SCENES)
def test_power_balance_along_the_vector_field(built_in: Load, name: str) -> None:
    """d(kinetic + elastic + potential)/dt = applied + driven - dissipated, driven = lam.C_t."""
    model = built_in(name)
    for state in random_states(model, STATES, seed=5):
        a = condensed_accelerations(model, state)
        lam = reactions(model, state, a) if model.constraints else np.zeros(0)
        assert power_gap(model, state, a, lam) < 1e-11


def composed(model: Model) -> ca.Function:
    """(q_i, q_i_dot, a, q_d guess, t) -> Q_hat, M_hat a through the closure and the velocities."""
    n = len(model.q_i)
    q_i, v, a = ca.SX.sym("q_i", n), ca.SX.sym("v", n), ca.SX.sym("a", n)
    guess, t = ca.SX.sym("guess", len(model.q_d)), ca.SX.sym("t")
    values = {"q_i": q_i, "q_i_dot": v, "t": t, "p": model.parameter_vector(), "q_d": guess}

    def call(name: str, output: str) -> ca.SX:
        function = model.function(name)
        return function.call({key: values[key] for key in function.name_in()})[output]

    if model.q_d:
        # at a closed position one Newton step has the exact derivative of q_d = f(q_i, t)
        values["q_d"] = call("closure", "q_d_next")
        values["q_d_dot"] = call("velocities", "q_d_dot")
    Q_hat, inertia = call("condensed", "Q_hat"), ca.mtimes(call("condensed", "M_hat"), a)
    outputs = [ca.jacobian(Q_hat, q_i), ca.jacobian(Q_hat, v), ca.jacobian(Q_hat - inertia, q_i)]
    return ca.Function("composed", [q_i, v, a, guess, t], outputs)


def body_rotation(theta: Array) -> Array:
    """exp(theta + d theta) = exp(theta) exp(body_rotation d theta), to first order."""
    size, (x, y, z) = float(np.linalg.norm(theta)), theta
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) - (1 - np.cos(size)) / size**2 * cross + (size - np.sin(size)) / size**3 * cross @ cross


@pytest.mark.every_push("flexible_slider_crank", "flyball_governor", "chain", "hub_beam", "four_bar", "heavy_top")
@pytest.mark.parametrize("name", SCENES)
def test_jacobians_equal_automatic_differentiation(built_in: Load, name: str) -> None:
    model = built_in(name)
    function = composed(model)
    a = np.random.default_rng(8).uniform(-1, 1, len(model.q_i))
    for state in random_states(model, 2, seed=6):
        expected = function(state.q_i, state.q_i_dot, a, state.q_d, state.t)
        condensed = evaluate(model, "condensed", **state.values())
        inertia = float(np.max(np.abs(condensed["M_hat"].reshape(len(a), -1) @ a)))
        # a derivative that vanishes is a sum of terms that cancel to their rounding
        rounding = 1e-15 * max(inertia, float(np.max(np.abs(condensed["Q_hat"]))))
        by_q, by_v, of_residual = (np.asarray(value) for value in expected)
        for turns in model.places.turns:  # emitted by rotations in the axes of the body, here by rotation vectors
            for reference in (by_q, of_residual):
                reference[:, turns] = reference[:, turns] @ np.linalg.inv(body_rotation(state.q_i[turns]))
        kernels = ("dQ_hat_dq_i", "dQ_hat_dq_i_dot", "residual_jacobian")
        emitted_by = {name: evaluate(model, name, **state.values(), q_i_ddot=a) for name in kernels}
        pairs = [(kernels[0], kernels[0], by_q), (kernels[1], kernels[1], by_v)]
        pairs += [(kernels[2], "J_q", of_residual), (kernels[2], "J_v", by_v)]
        for name, key, reference in pairs:
            emitted = emitted_by[name][key].reshape(reference.shape)
            assert np.max(np.abs(emitted - reference)) <= 1e-11 * np.max(np.abs(reference)) + rounding, key


def force_at(model: Model, state: State, q_i: Array, v: Array) -> Array:
    moved = make_state(model, q_i, v, state.t, guess=state.q)
    return evaluate(model, "condensed", **moved.values())["Q_hat"]


@pytest.mark.parametrize("name", ["four_bar", "flexible_slider_crank", "flexible_slider_crank_torque", "hub_beam"])
def test_jacobians_equal_central_differences(built_in: Load, name: str) -> None:
    """Plain differences with the loop closed anew at every point: nothing but the condensed kernel is trusted."""
    model = built_in(name)
    state = random_states(model, 1, seed=7)[0]
    for key in ("dQ_hat_dq_i", "dQ_hat_dq_i_dot"):
        emitted = evaluate(model, key, **state.values())[key].reshape(len(model.q_i), -1)
        for j, unit in enumerate(np.eye(len(model.q_i))):
            h = 1e-6
            step = (h * unit, 0 * unit) if key == "dQ_hat_dq_i" else (0 * unit, h * unit)
            ahead = force_at(model, state, state.q_i + step[0], state.q_i_dot + step[1])
            behind = force_at(model, state, state.q_i - step[0], state.q_i_dot - step[1])
            noise = 1e-15 * np.max(np.abs(ahead)) / h
            difference = (ahead - behind) / (2 * h)
            np.testing.assert_allclose(
                emitted[:, j], difference, rtol=1e-5, atol=1e-6 * np.max(np.abs(emitted[:, j])) + 100 * noise
            )


@pytest.mark.parametrize("name", ["double_pendulum", "hub_beam", "chain"])
def test_tree_elimination_gives_the_condensed_accelerations(built_in: Callable[[str], Model], name: str) -> None:
    """forward_dynamics never forms M_hat; its accelerations must be those of (38)."""
    model = built_in(name)
    for state in random_states(model, STATES):
        condensed = evaluate(model, "condensed", **state.values())
        n = len(model.q_i)
        expected = np.linalg.solve(condensed["M_hat"].reshape(n, n), condensed["Q_hat"].ravel())
        found = evaluate(model, "forward_dynamics", **state.values())["q_i_ddot"].ravel()
        np.testing.assert_allclose(found, expected, rtol=0, atol=1e-11 * np.abs(expected).max())


@pytest.mark.parametrize("name", ["flexible_slider_crank", "hub_beam", "two_oscillators"])
def test_blocks_of_the_partition(built_in: Callable[[str], Model], name: str) -> None:
    """(39): the emitted blocks are those of M_hat and Q_hat."""
    model = built_in(name)
    n = len(model.q_i)
    for state in random_states(model, STATES):
        condensed, blocks = evaluate(model, "condensed", **state.values()), evaluate(model, "blocks", **state.values())
        M_hat = condensed["M_hat"].reshape(n, n)
        for row in model.groups:
            np.testing.assert_allclose(
                blocks[f"Q_hat_{row.name}"].ravel(), condensed["Q_hat"].ravel()[row.positions], rtol=1e-12, atol=1e-12
            )
            for column in model.groups:
                block = blocks[f"M_hat_{row.name}{column.name}"].reshape(len(row.positions), len(column.positions))
                expected = M_hat[np.ix_(row.positions, column.positions)]
                np.testing.assert_allclose(block, expected, rtol=1e-12, atol=1e-14)


@pytest.mark.parametrize("name", ["flexible_slider_crank_torque", "hub_beam", "two_oscillators"])
def test_forces_of_the_augmented_form_add_up(built_in: Callable[[str], Model], name: str) -> None:
    """Q* = Q_F + Q_v - K q (28)."""
    model = built_in(name)
    n = len(model.coordinates)
    for state in random_states(model, STATES):
        found = evaluate(model, "augmented", **state.values())
        total = found["Q_F"].ravel() + found["Q_v"].ravel() - found["K"].reshape(n, n) @ state.values()["q"]
        np.testing.assert_allclose(found["Q_star"].ravel(), total, rtol=1e-12, atol=1e-9)
