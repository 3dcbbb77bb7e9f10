"""Opponents of the multirate schemes: order, stability, constraints, energy, agreement with the reference path."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from runtime import Solution, reference_solution, simulate
from runtime.baselines.scipy_methods import scipy_solution
from runtime.baselines.sundials import sundials_solution
from runtime.contract.model import Model
from runtime.engine.compiled import find_compiler
from runtime.engine.llvm_code import find_llvm
from runtime.schemes.baselines.generalized_alpha import GeneralizedAlpha
from runtime.schemes.baselines.radau import NODES, SHIFTS, A
from runtime.schemes.options import SchemeError
from symgen.scene import Scene

pytestmark = pytest.mark.long

Load = Callable[[str], Model]

# (scheme, scene) -> order, t_end [s], three steps halved from this one [s], cap on the error at the finest [m, rad]
ORDERS: dict[tuple[str, str], tuple[int, float, float, float]] = {
    ("radau", "double_pendulum"): (5, 2.0, 1e-2, 5e-11),
    ("radau", "flexible_slider_crank_free"): (5, 0.002, 1e-5, 8e-12),
    ("radau", "flexible_slider_crank_torque"): (5, 0.01, 1e-4, 3e-11),
    ("radau", "hub_beam"): (5, 0.8, 2e-2, 1e-10),
    ("generalized_alpha", "double_pendulum"): (2, 2.0, 1e-2, 4e-4),
    ("generalized_alpha", "flexible_slider_crank_free"): (2, 0.002, 1e-5, 1e-6),
    ("generalized_alpha", "hub_beam"): (2, 0.8, 1e-2, 2e-5),
    ("generalized_alpha", "two_oscillators"): (2, 1.0, 1e-2, 1e-3),  # no constraints
    ("generalized_alpha", "pendulum"): (2, 2.0, 1e-2, 2e-4),  # M is singular
    ("generalized_alpha", "flexible_slider_crank"): (2, 0.002, 1e-5, 1e-6),  # prescribed motion
    ("hht", "double_pendulum"): (2, 2.0, 1e-2, 4e-4),
    ("hht", "flexible_slider_crank_free"): (2, 0.002, 1e-5, 1e-6),
    ("hht", "hub_beam"): (2, 0.8, 1e-2, 2e-5),
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


@pytest.mark.parametrize("scheme", ["radau", "generalized_alpha", "hht"])
def test_implicit_opponents_are_stable_for_any_step(built_in: Load, scheme: str) -> None:
    """Far above the limit of an explicit scheme, energy does not grow and the crank turns as it should.

    Modes that no step resolves are off by a fifth of an amplitude and more, and the run says so.
    """
    model = built_in("flexible_slider_crank_free")
    limit = simulate(model, scheme="single_rate", t_end=1e-5, dt=1e-5).stats["step_limit_at_start"]
    dt = 8 * float(limit)
    solution = simulate(model, scheme=scheme, dt=dt, t_end=0.05)
    assert solution.status.name == "inaccurate" and solution.error.largest > 0.2
    energy = solution.total_energy
    assert np.max(energy) < energy[0] + 0.02 * np.max(solution.energy["kinetic"])
    exact = reference_solution(model, t_end=float(solution.t[-1]))
    assert abs(solution["crank.theta"][-1] - exact["crank.theta"][-1]) < 0.05


@pytest.mark.parametrize("name", ["four_bar", "flexible_slider_crank", "hub_beam", "chain"])
def test_generalized_alpha_holds_the_constraints(built_in: Load, name: str) -> None:
    model = built_in(name)
    solution = run(model, "generalized_alpha", float(model.simulation["dt"]), 200 * float(model.simulation["dt"]))
    assert np.max(solution.constraint_error) < 1e-9


def test_dissipation_is_an_option(built_in: Load) -> None:
    """Without constraints rho_inf = 1 keeps energy better than 0.5."""
    model = built_in("elastic_pendulum")
    lost = {}
    for rho in (1.0, 0.5):
        energy = run(
            model, "generalized_alpha", 5e-3, 10.0, options={"rho_inf": rho}, parameters={"spring.damping": 0.0}
        ).total_energy
        lost[rho] = np.max(np.abs(energy - energy[0]))
    assert lost[1.0] < 0.2 * lost[0.5], lost


def test_constraints_need_dissipation(built_in: Load) -> None:
    """Index 3: with rho_inf = 1 (alpha = 0) the multipliers alternate with growing amplitude, with less they do not."""
    model = built_in("double_pendulum")

    def alternation(scheme: str, **options: float) -> float:
        lam = simulate(model, scheme=scheme, dt=5e-3, t_end=5.0, seen_every=0.0, options=options).lam
        return float(np.max(np.abs(lam[-20:-2] - 2 * lam[-19:-1] + lam[-18:])))

    calm = alternation("generalized_alpha", rho_inf=0.9)
    assert alternation("generalized_alpha", rho_inf=1.0) > 30 * calm
    assert alternation("hht", alpha=0.0) > 30 * calm
    assert alternation("hht", alpha=0.05) < 2 * calm


def test_hht_and_generalized_alpha_meet(built_in: Load) -> None:
    """alpha_m = 0 is both rho_inf = 1/2 and alpha = 1/3."""
    model = built_in("double_pendulum")
    both = [
        run(model, scheme, 5e-3, 1.0, options=options).q
        for scheme, options in (("generalized_alpha", {"rho_inf": 0.5}), ("hht", {"alpha": 1 / 3}))
    ]
    np.testing.assert_allclose(both[0], both[1], rtol=0, atol=1e-12)


def test_options_of_opponents_are_checked(built_in: Load) -> None:
    model = built_in("double_pendulum")
    for scheme, options in (
        ("generalized_alpha", {"rho_inf": 1.1}),
        ("hht", {"alpha": 0.5}),
        ("hht", {"alpha": "a"}),
        ("radau", {"rho_inf": 0.5}),
        ("generalized_alpha", {"alpha": 0.1}),
    ):
        with pytest.raises(SchemeError):
            simulate(model, scheme=scheme, t_end=0.1, dt=0.01, options=options)
    solution = simulate(model, scheme="radau", t_end=1.0, dt=0.05, options={"max_iterations": 1})
    assert solution.status.name == "iteration_failed"


def test_generalized_alpha_is_that_of_its_spectral_radius(built_in: Load) -> None:
    """On one linear mode with an infinite step, the amplification matrix has the radius rho_inf."""
    for rho in (0.0, 0.5, 0.9):
        scheme = GeneralizedAlpha.__new__(GeneralizedAlpha)
        scheme.options = type("Given", (), {"rho_inf": rho})()
        k, far = scheme.weights(), 1e9  # far = (h w)^2
        # (q, h v, h^2 a) at both ends, with q'' = -w^2 q
        after = np.array([[1, 0, -k.beta], [0, 1, -k.gamma], [(1 - k.alpha_f) * far, 0, 1 - k.alpha_m]])
        before = np.array([[1, 1, 0.5 - k.beta], [0, 1, 1 - k.gamma], [-k.alpha_f * far, 0, -k.alpha_m]])
        radius = np.max(np.abs(np.linalg.eigvals(np.linalg.solve(after, before))))
        assert radius == pytest.approx(rho, abs=2e-3)


@pytest.mark.parametrize("scheme, c", [("generalized_alpha", 0.0844), ("hht", 0.0949)])
def test_order_two_is_seen_where_no_mode_is_out_of_phase(model_of: Callable[..., Model], scheme: str, c: float) -> None:
    """A mode lags by c (h w)^2 w t, c from the roots of the step's matrix to their second order: slopes fall from 2 as
    soon as that nears a radian, and the size of the error is that of the lag."""
    w, t_end, steps = 20.0, 10.0, np.array([0.02, 0.01, 0.005])
    scene = Scene("mode").structure(coordinates=["x"], mass=[[1.0]], stiffness=[[w * w]])
    model, errors = model_of(scene.initial({"x": 1.0}).build()), []
    for h in steps:
        found = simulate(model, scheme=scheme, dt=float(h), t_end=t_end)  # `inaccurate` at the longest
        x, v = found.q[-1, 0], found.q_dot[-1, 0]
        errors.append(abs(x - 1j * v / w - np.exp(1j * w * t_end)))
    lags = c * (steps * w) ** 2 * w * t_end
    np.testing.assert_allclose(errors, 2 * np.sin(lags / 2), rtol=0.04)
    assert np.diff(np.log2(errors[:2])) > -1.7 and np.diff(np.log2(errors[1:])) == pytest.approx(-2, abs=0.07)


TIMES = np.linspace(0.0, 1.0, 6)
ADAPTIVE: dict[str, tuple[Callable[..., Solution], str, dict[str, str]]] = {
    "cvodes bdf": (sundials_solution, "cvodes", {}),
    "cvodes adams": (sundials_solution, "cvodes", {"multistep": "adams"}),
    "idas": (sundials_solution, "idas", {}),
    "DOP853": (scipy_solution, "DOP853", {}),
    "Radau": (scipy_solution, "Radau", {}),
    "BDF": (scipy_solution, "BDF", {}),
    "LSODA": (scipy_solution, "LSODA", {}),
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
        scipy_solution(built_in("pendulum"), "Euler", t_end=1.0)
