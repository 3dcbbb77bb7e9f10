"""Opponents of the multirate schemes: order, stability, constraints, energy, agreement with the reference path."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from benchmarks.contenders.sundials import sundials_solution
from runtime import SchemeError, Solution, reference_solution, simulate
from runtime.engine.c_source import find_compiler
from runtime.engine.llvm_code import find_llvm
from runtime.model import Model
from runtime.schemes.radau import NODES, SHIFTS, A

pytestmark = pytest.mark.long

Load = Callable[[str], Model]

# (scheme, scene) -> order, t_end [s], three steps halved from this one [s], cap on the error at the finest [m, rad]
ORDERS: dict[tuple[str, str], tuple[int, float, float, float]] = {
    ("radau", "double_pendulum"): (5, 2.0, 1e-2, 5e-11),
    ("radau", "flexible_slider_crank_free"): (5, 0.002, 1e-5, 8e-12),
    ("radau", "flexible_slider_crank_torque"): (5, 0.01, 1e-4, 3e-11),
    ("radau", "hub_beam"): (5, 0.8, 2e-2, 1e-10),
}


def run(model: Model, scheme: str, dt: float, t_end: float, **given: Any) -> Solution:
    solution = simulate(model, t_end=t_end, dt=dt, scheme=scheme, samples=5, **given)
    assert solution.status.ok, solution.status
    return solution


@pytest.mark.parametrize("scheme, name", ORDERS)
def test_order_of_opponents(built_in: Load, scheme: str, name: str) -> None:
    order, t_end, dt, cap = ORDERS[scheme, name]
    model = built_in(name)
    exact = reference_solution(model, t_end=t_end, times=np.linspace(0, t_end, 6), rtol=1e-12, atol=1e-14).q
    errors = [np.max(np.abs(run(model, scheme, dt / k, t_end).q - exact)) for k in (1, 2, 4)]
    slope = np.polyfit(np.log([1.0, 0.5, 0.25]), np.log(errors), 1)[0]
    assert slope == pytest.approx(order, abs=0.3 if order == 5 else 0.1), errors
    assert errors[-1] < cap, errors


def test_radau_tableau() -> None:
    """The simplifying conditions B(5) and C(3), and the eigenvalues printed by Hairer and Wanner."""
    for k in range(1, 6):
        assert A[-1] @ NODES ** (k - 1) == pytest.approx(1 / k, rel=1e-14)
    for k in range(1, 4):
        np.testing.assert_allclose(A @ NODES ** (k - 1), NODES**k / k, rtol=1e-13)
    assert SHIFTS[0] == pytest.approx(3.6378342527444957)
    assert abs(SHIFTS[1].imag) == pytest.approx(3.0504301992474105)


def test_radau_is_stable_for_any_step(built_in: Load) -> None:
    """Far above the limit of an explicit scheme, energy does not grow and the crank turns as it should.

    Modes that no step resolves are off by a fifth of an amplitude and more, and the run says so.
    """
    model = built_in("flexible_slider_crank_free")
    limit = simulate(model, scheme="single_rate", t_end=1e-5, dt=1e-5).stats["step_limit_at_start"]
    dt = 8 * float(limit)
    solution = simulate(model, scheme="radau", dt=dt, t_end=0.05)
    assert solution.status.name == "inaccurate" and solution.error.largest > 0.2
    energy = solution.total_energy
    assert np.max(energy) < energy[0] + 0.02 * np.max(solution.energy["kinetic"])
    exact = reference_solution(model, t_end=float(solution.t[-1]))
    assert abs(solution["crank.theta"][-1] - exact["crank.theta"][-1]) < 0.05


def test_options_of_opponents_are_checked(built_in: Load) -> None:
    model = built_in("double_pendulum")
    for scheme, options in (("radau", {"rho_inf": 0.5}),):
        with pytest.raises(SchemeError):
            simulate(model, scheme=scheme, t_end=0.1, dt=0.01, options=options)
    solution = simulate(model, scheme="radau", t_end=1.0, dt=0.05, options={"max_iterations": 1})
    assert solution.status.name == "iteration_failed"


TIMES = np.linspace(0.0, 1.0, 6)
ADAPTIVE: dict[str, tuple[Callable[..., Solution], str, dict[str, str]]] = {
    "cvodes bdf": (sundials_solution, "cvodes", {}),
    "cvodes adams": (sundials_solution, "cvodes", {"multistep": "adams"}),
    "idas": (sundials_solution, "idas", {}),
    "Radau": (reference_solution, "Radau", {}),
    "BDF": (reference_solution, "BDF", {}),
    "LSODA": (reference_solution, "LSODA", {}),
}


@pytest.mark.parametrize("which", ADAPTIVE)
@pytest.mark.parametrize("name, t_end", [("double_pendulum", 1.0), ("four_bar", 0.5)])
def test_adaptive_opponents_agree_with_the_reference(built_in: Load, which: str, name: str, t_end: float) -> None:
    solve, method, more = ADAPTIVE[which]
    model = built_in(name)
    exact = reference_solution(model, t_end=t_end, times=t_end * TIMES)
    found = solve(model, method, t_end=t_end, times=t_end * TIMES, rtol=1e-9, atol=1e-11, **more)
    assert found.status.ok, found.status
    assert np.max(np.abs(found.q - exact.q)) < 1e-6
    assert np.max(np.abs(found.q_dot - exact.q_dot)) < 1e-5
    assert np.max(found.constraint_error) < 1e-10
    assert int(found.stats["evaluations"]) > 0 and float(found.stats["wall_seconds"]) > 0


@pytest.mark.parametrize("method", ["cvodes", "idas"])
def test_sundials_is_compiled(built_in: Load, method: str) -> None:
    model, given = built_in("flexible_slider_crank"), {"t_end": 0.002, "rtol": 1e-9, "atol": 1e-12}
    compiled = sundials_solution(model, method, **given)
    interpreted = sundials_solution(model, method, compiled=False, **given)
    assert compiled.stats["engine"] == ("compiled" if find_compiler() and not find_llvm() else "interpreted")
    assert interpreted.stats["engine"] == "interpreted"
    np.testing.assert_allclose(compiled.q, interpreted.q, rtol=0, atol=1e-9)


def test_idas_begins_with_the_rates_of_the_start(built_in: Load) -> None:
    """Searching for them, IDACalcIC gave up here, and the first steps from zero rates were refused."""
    model, start = built_in("near_singular_slider_crank"), {"start": "quasi_static"}
    solution = sundials_solution(model, "idas", t_end=1e-3, rtol=1e-6, atol=2e-11, **start)
    assert solution.status.ok, solution.status
    exact = reference_solution(model, t_end=1e-3, **start)
    assert np.max(np.abs(solution.q[-1] - exact.q[-1])) < 1e-7


@pytest.mark.parametrize("method", ["cvodes", "idas"])
def test_sundials_keeps_to_an_order(built_in: Load, method: str) -> None:
    """Order 2 at most takes many more steps than order 5 where the tolerance is tight."""
    given = {"t_end": 1.0, "rtol": 1e-8, "atol": 1e-10}
    free = sundials_solution(built_in("double_pendulum"), method, **given, highest_order=5)
    low = sundials_solution(built_in("double_pendulum"), method, **given, highest_order=2)
    assert int(low.stats["steps"]) > 5 * int(free.stats["steps"])
    np.testing.assert_allclose(low.q[-1], free.q[-1], rtol=0, atol=1e-4)


def test_unknown_methods_are_named(built_in: Load) -> None:
    with pytest.raises(ValueError, match="cvodes, idas"):
        sundials_solution(built_in("pendulum"), "arkode", t_end=1.0)
    with pytest.raises(ValueError, match="DOP853"):
        reference_solution(built_in("pendulum"), "Euler", t_end=1.0)
