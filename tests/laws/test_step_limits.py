"""Step limits known before a run: reaches of schemes, damped modes, refusal of steps above, models without modes."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from runtime import simulate
from runtime.model import Model
from runtime.operating.mode_solver import ModeSolver
from runtime.schemes.runge_kutta import ClassicalRungeKutta, DormandPrince8, ExplicitRungeKutta
from runtime.schemes.step_limit import central_difference_limit, limit_between_the_axes

Load = Callable[[str], Model]
CLOSE = 0.03  # of a limit
EXPLICIT: list[tuple[str, dict[str, Any], list[int] | None]] = [
    ("rk4", {}, None),
    ("dop853", {}, None),
    ("single_rate", {"common_velocity": "predictor"}, None),
    ("coupled", {}, [1]),
    ("coupled", {}, [4]),
]


def amplification(method: type[ExplicitRungeKutta], z: np.ndarray) -> np.ndarray:
    """|R(z)| of a tableau."""
    A, b, _ = method.tableau()
    n = len(b)
    A = np.asarray(A, dtype=float)[:n, :n]
    return np.abs([1 + x * (b @ np.linalg.solve(np.eye(n) - x * A, np.ones(n))) for x in z])


@pytest.mark.parametrize("method", [ClassicalRungeKutta, DormandPrince8])
@pytest.mark.parametrize("direction", [1j, -1.0])
def test_reaches_are_those_of_the_tableau(method: type[ExplicitRungeKutta], direction: complex) -> None:
    reach = method.reach if direction == 1j else method.decay_reach
    assert reach is not None
    size = np.linspace(0.0, 1.2 * reach, 1201)
    outside = amplification(method, size * direction) > 1 + 1e-6
    assert size[outside.argmax()] == pytest.approx(reach, abs=2e-3 * reach)


def multipliers(h: float, stiffness: float, damping: float) -> float:
    """Spectral radius of central difference with predicted velocity, on (q, q_dot(t - h/2), q_ddot(t - h))."""
    q, v = np.array([1.0, 0.0, 0.0]), np.array([0.0, 1.0, 0.0])
    a = -stiffness * q - damping * (v + h / 2 * np.array([0.0, 0.0, 1.0]))
    return float(np.abs(np.linalg.eigvals([q + h * (v + h * a), v + h * a, a])).max())


@pytest.mark.parametrize("ratio", [0.0, 0.1, 0.5, 0.99, 1.5, 30.0])
def test_predicted_velocities_are_stable_up_to_the_limit(ratio: float) -> None:
    """A damped oscillator of 3 rad/s; where damping vanishes the limit is 2 / w, where it rules 1 / decay."""
    stiffness, damping = 9.0, 2 * ratio * 3.0
    limit = central_difference_limit(np.array([[-stiffness]]), np.array([[-damping]]), predicted=True)
    assert limit is not None
    assert multipliers(limit.h * (1 - 1e-6), stiffness, damping) < 1 + 1e-9
    assert multipliers(limit.h * 1.01, stiffness, damping) > 1.0
    assert limit.by_decay is (ratio > 0.6)
    implicit = central_difference_limit(np.array([[-stiffness]]), np.array([[-damping]]), predicted=False)
    assert implicit is not None and implicit.h == pytest.approx(2 / 3)
    if ratio == 30.0:
        assert limit.h * damping == pytest.approx(1.0, rel=1e-3)


def test_nothing_moves_nothing_limits() -> None:
    still = np.zeros((1, 1))
    assert limit_between_the_axes(still, still, 2.8, 2.8) is None
    assert central_difference_limit(still, still, predicted=True) is None
    assert central_difference_limit(np.eye(1), still, predicted=False) is None  # a falling direction


@pytest.mark.parametrize(("scheme", "options", "m"), EXPLICIT)
def test_a_damper_limits_the_step(built_in: Load, scheme: str, options: dict[str, Any], m: list[int] | None) -> None:
    """Refused above the limit; forced, it grows there; just below it runs."""
    model, per_step = built_in("overdamped_joint"), m[0] if m else 1

    def run(h: float, t_end: float = 0.1, force: bool = False) -> Any:
        return simulate(model, scheme=scheme, options=options, m=m, dt=h * per_step, t_end=t_end, force=force)

    limit = run(1e-7, t_end=1e-6).stats["step_limit_at_start"]
    refused = run(limit * (1 + CLOSE))
    assert refused.status.name == "step_too_long"
    assert "decay rate is 2.237e+04 1/s" in refused.status.advice
    assert not run(limit * (1 + CLOSE), t_end=0.4, force=True).status.ok
    assert run(limit * (1 - CLOSE)).status.ok


def test_newton_velocities_do_not_feel_the_damper(built_in: Load) -> None:
    solution = simulate(built_in("overdamped_joint"), scheme="single_rate", dt=1e-3, t_end=0.1)
    assert solution.status.ok
    assert solution.stats["step_limit_at_start"] == pytest.approx(2 / 289.7, rel=1e-3)


@pytest.mark.parametrize("scheme", ["radau", "exponential"])
def test_implicit_schemes_have_no_limit(built_in: Load, scheme: str) -> None:
    assert "step_limit_at_start" not in simulate(built_in("overdamped_joint"), scheme=scheme, dt=1e-3, t_end=0.01).stats


def test_model_without_jacobians_runs_without_a_limit(built_in: Load) -> None:
    full = built_in("two_oscillators")
    kept = {name: build for name, build in full.builders.items() if name != "residual_jacobian"}
    model = replace(full, builders=kept, _kernels={}, _derived={})
    assert ModeSolver.possible(full) and not ModeSolver.possible(model)
    solution = simulate(model, scheme="rk4", dt=1e-3, t_end=0.1)
    assert solution.status.ok and "step_limit_at_start" not in solution.stats
    failed = simulate(model, scheme="rk4", dt=2.0, t_end=2000.0)
    assert failed.status.name in ("diverged", "not_finite") and "Reduce the step, such as dt=" in failed.status.advice


@pytest.mark.long
@pytest.mark.parametrize("dt, most", [(1e-4, 1e-6), (1e-3, 5e-5)])
def test_printed_sweep_meets_a_strong_damper_in_shorter_parts(built_in: Load, dt: float, most: float) -> None:
    """It takes forces at the last iterate's velocity: no fixed point is reached for h d > 2 (d = 2.2e4 1/s here)."""
    model = built_in("overdamped_joint")
    run = simulate(model, scheme="printed", m=[1], dt=dt, t_end=0.3, force=True)
    exact = simulate(model, scheme="exponential", dt=1e-4, t_end=0.3, error="off")
    assert run.status.ok and run.stats["divided_steps"] > 50
    assert np.abs(run.q[-1] - exact.q[-1]).max() < most


def test_printed_sweep_fails_on_a_damper_too_strong_for_any_part_by_name(built_in: Load) -> None:
    """h d = 2.2e7: of 1024 parts none converges."""
    settings = {"scheme": "printed", "m": [1], "dt": 1e-3, "t_end": 0.3, "force": True}
    damper = {"spring.damping": 1.3e6}
    run = simulate(built_in("overdamped_joint"), **settings, parameters=damper)
    assert run.status.name == "iteration_failed" and "nor in parts of 9.77e-07 s" in run.status.cause
    assert "common_update = direct" in run.status.advice


def test_printed_sweep_arrives_where_its_damper_lets_it(built_in: Load) -> None:
    """With h d = 1.1 the sweep has a fixed point, and the motion is that of the exponential scheme."""
    model = built_in("overdamped_joint")
    solution = simulate(model, scheme="printed", m=[2], dt=1e-4, t_end=0.3, force=True)
    exact = simulate(model, scheme="exponential", dt=1e-4, t_end=0.3)
    assert solution.status.ok
    for name in model.q_i:
        assert abs(solution[name][-1] - exact[name][-1]) < 2e-5


def test_the_limit_of_a_slow_mechanism() -> None:
    """Frequency 0.1 rad/s without dampers: 20 s, and it is the frequency that sets it."""
    for predicted in (False, True):
        limit = central_difference_limit(np.array([[-0.01]]), np.zeros((1, 1)), predicted=predicted)
        assert limit is not None and limit.h == pytest.approx(20.0, rel=1e-12)
        assert limit.rate == pytest.approx(0.1) and not limit.by_decay
