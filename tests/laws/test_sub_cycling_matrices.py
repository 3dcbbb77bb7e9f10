"""Amplification matrices of sub-stepping schemes on two oscillators: the twin's, neutral stability, growth laws."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from runtime.model import Model
from runtime.operating.mode_solver import State
from runtime.schemes.catalogue import scheme_kind
from runtime.studies.stability.chart import SHARE_OF_FREQUENCY, StabilityStudy
from runtime.studies.stability.spectra import ExactMotion, TangentStep
from tests.hand_derived.twin_oscillators import Params
from tests.hand_derived.twin_subcycling import (
    held_slow_matrix,
    modes,
    radius,
    rational_matrix,
    runge_kutta_matrix,
)
from tests.support.model_values import Array

Load = Callable[[str], Model]
REST = State(0.0, np.zeros(2), np.zeros(2), np.zeros(0))
UNDAMPED, DAMPED = Params(c=0.5, w=20.0, k_L=1.7, zeta=0.0), Params(c=-0.6, w=15.0, k_L=0.9, zeta=0.07)

# scheme, m, options, fields of its memory that act, the twin's matrix of (parameters, dt)
HELD, ONE_STEP = ("x", "v", "a", "x_last", "v_last"), ("x", "v")
CASES: dict[str, tuple[str, list[int] | None, dict[str, Any], tuple[str, ...], Callable[[Params, float], Array]]] = {
    **{f"coupled {m}": ("coupled", [m], {}, HELD, lambda p, dt, m=m: held_slow_matrix(p, dt, m)) for m in range(1, 51)},
    **{
        f"exponential {m}": ("exponential", [m], {}, ONE_STEP, lambda p, dt, m=m: rational_matrix(p, dt, m))
        for m in (1, 2, 5)
    },
    "rk4": ("rk4", None, {}, ONE_STEP, runge_kutta_matrix),
}


class Amplification:
    """Matrices of a case at parameters and a step, from rest."""

    def __init__(self, model: Model, case: str) -> None:
        name, m, options, fields, _ = CASES[case]
        self.model, self.scheme = model, scheme_kind(name).build(name, model, 1.0, m, options)
        self.tangent, self.start = TangentStep(self.scheme), self.scheme.start()
        layout, columns = self.scheme.layout, list(self.tangent.columns)
        positions = [k for name in fields for k in range(layout.slice(name).start, layout.slice(name).stop)]
        self.entries = [columns.index(k) for k in positions]

    def __call__(self, p: Params, dt: float) -> tuple[Array, Array]:
        """(whole matrix of a major step, its block of the fields that the twin has)."""
        c = self.model.constants(self.model.parameter_vector({"c": p.c, "w": p.w, "k_L": p.k_L, "zeta": p.zeta}))
        c = np.concatenate([c, np.array(self.scheme.grid.h) * dt])
        z = np.asarray(self.start(0.0, REST.q_i, REST.q_i_dot, REST.loop, c)).ravel()
        matrix = self.tangent(z, c)[1]
        return matrix, matrix[np.ix_(self.entries, self.entries)]


@pytest.mark.parametrize("case", CASES)
def test_amplification_matrices(built_in: Load, case: str) -> None:
    """Law: one major step acts on (x, v, ...) as the hand-derived matrix does, and has its spectral radius."""
    ours, (_, m, _, _, twin) = Amplification(built_in("two_oscillators"), case), CASES[case]
    for params in (UNDAMPED, DAMPED):
        for reach in (0.03, 0.7):
            dt = reach * (m[0] if m else 1) / params.w
            whole, block = ours(params, dt)
            wanted = twin(params, dt)
            scale = max(1.0, np.max(np.abs(wanted)))
            np.testing.assert_allclose(block, wanted, rtol=0, atol=1e-12 * scale)
            assert radius(whole) == pytest.approx(radius(wanted), rel=1e-12, abs=0)


@pytest.mark.parametrize("c", [0.1, 0.5, 0.9])
def test_coupled_is_neutral_without_slow_stiffness(c: float) -> None:
    """Law: k_L = 0 leaves nothing that is held in the equations: radius 1 up to w_c dt_S = 2 for every m."""
    params = Params(c=c, w=20.0, k_L=0.0)
    fastest = modes(params)[0][1]
    for m in range(1, 51):
        for reach in np.linspace(0.05, 1.95, 5):
            assert radius(held_slow_matrix(params, reach * m / fastest, m)) < 1 + 1e-9
        assert radius(held_slow_matrix(params, 2.02 * m / fastest, m)) > 1.01


def growth_of(params: Params, dt: float, m: int, mode: int) -> float:
    """Growth rate of a mode by the twin, told by where central difference would have its multiplier."""
    values = np.linalg.eigvals(held_slow_matrix(params, dt, m))
    frequency = modes(params)[0][mode]
    neutral = np.exp(1j * 2 * m * np.arcsin(frequency * dt / (2 * m)))
    return float(np.log(np.abs(values[np.argmin(np.abs(values - neutral))])) / dt)


@pytest.mark.parametrize("k_L", [1.0, 40.0])
@pytest.mark.parametrize("mode", [0, 1])
@pytest.mark.parametrize("m", [2, 3, 4, 10, 50])
def test_growth_by_slow_stiffness_is_third_order(m: int, mode: int, k_L: float) -> None:
    """Law: sigma = kappa w^2 dt^3 s [(1 + s)(1 + 2s) + (1 - s)(2s - 1) k_L / ((1 - c^2) w^2)] / 12, s = (1 + 1/m)/2.

    The secant lags by its third order, which the second term corrects for the jumps of the held force. For large m
    this is kappa w^2 dt^3 / 8. So without damping no step is stable, but growth is an order below the error.
    """
    params, s = Params(c=0.5, w=20.0, k_L=k_L), (1 + 1 / m) / 2
    frequencies, share = modes(params)
    w = frequencies[mode]
    dt = 0.02 / w
    shape = (1 + s) * (1 + 2 * s) + (1 - s) * (2 * s - 1) * k_L / ((1 - params.c**2) * w**2)
    law = share[mode] * w**2 * dt**3 * s * shape / 12
    assert growth_of(params, dt, m, mode) == pytest.approx(law, rel=2e-3)


def fast_growth_law(params: Params, dt: float, m: int) -> float:
    """First order in kappa: the held x_L acts on the fast mode with the phase that sub-steps of X = w dt give it."""
    frequencies, share = modes(params)
    h, s = dt / m, (1 + 1 / m) / 2
    step = 2 * np.arcsin(frequencies[1] * h / 2)  # phase of a sub-step of central difference
    X = m * step
    mean = np.sin(X / 2) / (m * np.sin(step / 2))  # of exp(i w t) over the sub-steps, about their middle
    lag = (1 + s) * np.sin(s * X) - s * np.sin((1 + s) * X)
    return float(share[1] * h / (2 * np.sin(step)) * mean * lag)


@pytest.mark.parametrize("c", [0.3, 0.8])
@pytest.mark.parametrize("m", [2, 4, 10, 50])
def test_fast_growth_by_slow_stiffness(m: int, c: float) -> None:
    """Law: kappa h / (2 sin wh) D(X) [(1 + s) sin sX - s sin (1 + s)X], 2 kappa sin^4(X/2) / (w X) for large m."""
    params = Params(c=c, w=20.0, k_L=1e-3)
    fastest, share = modes(params)[0][1], modes(params)[1][1]
    peak = 2 * share / (np.pi * fastest)
    for X in np.linspace(0.3, min(5.5 * np.pi, 1.8 * m), 12):
        law = fast_growth_law(params, X / fastest, m)
        assert growth_of(params, X / fastest, m, 1) == pytest.approx(law, rel=0.01, abs=2e-3 * peak)
        if m == 50:
            assert law == pytest.approx(2 * share * np.sin(X / 2) ** 4 / (fastest * X), rel=0.3, abs=0.06 * peak)


def test_windows_lie_at_odd_multiples_of_pi(built_in: Load) -> None:
    """Law: a stability study finds windows where the growth law says so, around w_c dt_L = pi and 3 pi, not 2 pi."""
    model, m = built_in("two_oscillators"), 10
    params = Params(c=0.9, w=20.0, k_L=0.42)
    c = model.constants(model.parameter_vector({"c": params.c, "w": params.w, "k_L": params.k_L, "zeta": 0.0}))
    fastest = modes(params)[0][1]
    study = StabilityStudy(model, "coupled", [m], {}, c, [REST], 2500.0, ExactMotion(model, c))
    found = np.array(study.curve(np.arange(0.2, 3.9, 0.2) * np.pi / fastest).windows) * fastest / np.pi
    grid = np.linspace(0.2, 3.8, 3601) * np.pi
    above = np.array([fast_growth_law(params, x / fastest, m) for x in grid]) > SHARE_OF_FREQUENCY * fastest
    law = (grid / np.pi)[np.flatnonzero(above[1:] != above[:-1])].reshape(2, 2)
    np.testing.assert_allclose(found, law, atol=0.005)
    for (low, high), n in zip(found, (1, 3), strict=True):
        assert low < n < high < n + 1 - 0.5
