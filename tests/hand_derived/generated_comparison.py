"""Compare a generated model with a hand-derived twin at random states."""

from __future__ import annotations

from types import ModuleType
from typing import Any

import numpy as np

from runtime.model import Model
from tests.support.model_values import evaluate, make_state, relative_error

TOLERANCE = 1e-12  # of the largest entry


def compare(model: Model, twin: ModuleType, params: Any, scale: Any, rate_scale: Any, times: tuple[float, ...]) -> None:
    """M_hat, Q_hat, C_q, the three Jacobians, the closure and its rate at one random state per time."""
    assert model.coordinates == twin.coordinates(params)
    assert model.q_i == twin.independent(params)
    rng = np.random.default_rng(11)
    n = len(model.q_i)
    for t in times:
        q_i, q_i_dot = rng.uniform(-1, 1, n) * scale, rng.uniform(-1, 1, n) * rate_scale
        compare_at(model, twin, params, q_i, q_i_dot, t)


def compare_at(model: Model, twin: ModuleType, params: Any, q_i: Any, q_i_dot: Any, t: float) -> None:
    q = twin.q_full(params, q_i, t)
    state = make_state(model, q_i, q_i_dot, t, guess=q)
    np.testing.assert_allclose(state.q, q, rtol=0, atol=1e-13 * max(1.0, np.max(np.abs(q))), err_msg="closure")
    values = {**state.values(), "q": q, "q_d": q[model.dependent_columns]}
    _compare_rates(model, twin, params, q_i, q_i_dot, t, values["q_d_dot"])
    a = np.random.default_rng(3).uniform(-1, 1, len(q_i)) * np.max(np.abs(q_i_dot)) ** 2
    pairs = {
        "M_hat": (_get(model, "condensed", "M_hat", values), twin.M_hat(params, q_i, t)),
        "Q_hat": (_get(model, "condensed", "Q_hat", values), twin.Q_hat(params, q_i, q_i_dot, t)),
        "C_q": (_get(model, "constraints", "C_q", values), twin.C_q(params, q, t)),
        "dQ_hat_dq_i": (_get(model, "dQ_hat_dq_i", "dQ_hat_dq_i", values), twin.dQ_hat_dq_i(params, q_i, q_i_dot, t)),
        "dQ_hat_dq_i_dot": (
            _get(model, "dQ_hat_dq_i_dot", "dQ_hat_dq_i_dot", values),
            twin.dQ_hat_dq_i_dot(params, q_i, q_i_dot, t),
        ),
        "J_q": (
            _get(model, "residual_jacobian", "J_q", {**values, "q_i_ddot": a}),
            np.asarray(twin.dQ_hat_dq_i(params, q_i, q_i_dot, t)) - np.asarray(twin.dMa_dq_i(params, q_i, a, t)),
        ),
        "J_v": (
            _get(model, "residual_jacobian", "J_v", {**values, "q_i_ddot": a}),
            twin.dQ_hat_dq_i_dot(params, q_i, q_i_dot, t),
        ),
    }
    for name, (generated, derived) in pairs.items():
        derived = np.asarray(derived, dtype=float)
        if not derived.any():
            assert not generated.any(), name
        else:
            assert relative_error(generated.reshape(derived.shape), derived) < TOLERANCE, name


def _compare_rates(model: Model, twin: ModuleType, params: Any, q_i: Any, q_i_dot: Any, t: float, q_d_dot: Any) -> None:
    """q_d_dot against a complex step along (q_i_dot, 1) of the twin's own q_full."""
    h = 1e-40j
    expected = np.imag(twin.q_full(params, q_i + h * q_i_dot, t + h)) / 1e-40
    expected = expected[model.dependent_columns]
    np.testing.assert_allclose(q_d_dot, expected, rtol=0, atol=1e-12 * max(1.0, np.max(np.abs(expected))))


def _get(model: Model, name: str, output: str, values: dict[str, Any]) -> Any:
    """A kernel's output; a kernel without any entry is not emitted, and is zero."""
    return evaluate(model, name, **values)[output]
