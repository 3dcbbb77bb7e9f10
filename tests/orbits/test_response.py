"""The response of a motion that repeats to small disturbances: Hill's matrix by hand, and runs that are disturbed."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from runtime import ArgumentError, Model, periodic
from symgen.scene import Scene, SceneRecord

Build = Callable[[SceneRecord], Model]
A, Q, C = 3.0, 0.8, 0.2


def pushed(name: str, force: str) -> SceneRecord:
    builder = Scene(name).input("u", 0.0, "N").rigid("mass", mass=1.0, inertia=1.0)
    builder.prismatic("rail", "ground.origin", "mass.origin").measure("x", "x", "mass.origin")
    builder.force("f", "mass.origin", f"u + {force}", 0.0)
    return builder.simulation(t_end=1.0, dt=1e-3, scheme="rk4").build()


def test_a_damped_mathieu_oscillator_answers_as_hills_matrix_says(model_of: Build) -> None:
    """(a - s^2 + i c s) X_m - q (X_{m-1} + X_{m+1}) = 1 for m = 0, else 0; s = w + 2 m, with 20 harmonics each way."""
    model = model_of(pushed("parametric", f"1 - {C}*x_dot - ({A} - 2*{Q}*cos(2*t))*x"))
    found = periodic(model, period=np.pi, steps=200, scheme="dop853")
    w = np.array([0.3, 1.1, 1.7, 2.9])
    answer = found.response("u", w, ["x"], harmonics=2)
    assert answer.harmonics.tolist() == [-2, -1, 0, 1, 2]
    m = np.arange(-20, 21)
    for k, one in enumerate(w):
        s = one + 2 * m
        matrix = np.diag(A - s**2 + 1j * C * s) - Q * (np.eye(41, k=1) + np.eye(41, k=-1))
        X = np.linalg.solve(matrix, (m == 0).astype(complex))
        for order in answer.harmonics:
            assert answer.of("x", order)[k] == pytest.approx(X[20 + order], abs=1e-7 * np.abs(X).max())


@pytest.mark.long
def test_a_duffing_oscillator_answers_as_a_disturbed_run(model_of: Build) -> None:
    """Of a run with the disturbance and one without, at the frequencies w + m 2 pi / T, over 100 periods."""
    model = model_of(pushed("bent", "0.8*cos(1.5*t) - 0.3*x_dot - x - x*x*x"))
    found, w, size = periodic(model, period=2 * np.pi / 1.5, steps=200, scheme="dop853"), 0.15, 1e-5
    answer = found.response("u", [w], ["x"], harmonics=2)
    runs = []
    for amplitude in (size, -size):
        run = found.simulate(160, inputs={"u": lambda t, a=amplitude: a * np.cos(w * t)}, seen_every=found.period / 40)
        runs.append(run)
    late = slice(60 * 40, 160 * 40)  # 100 periods: ten of the disturbance
    off, t = (runs[0]["x"] - runs[1]["x"])[late] / (2 * size), runs[0].t[late]
    for m in answer.harmonics:  # of cos, half of e^{i w t} and half of its conjugate
        wave = np.exp(-1j * (w + m * 1.5) * t)
        assert 2 * np.mean(off * wave) == pytest.approx(answer.of("x", m)[0], abs=1e-5 * np.abs(answer.values).max())


def test_wrong_questions_are_refused(model_of: Build) -> None:
    model = model_of(pushed("parametric", f"1 - {C}*x_dot - ({A} - 2*{Q}*cos(2*t))*x"))
    found = periodic(model, period=np.pi, steps=40, scheme="rk4")
    with pytest.raises(ArgumentError, match="not an input"):
        found.response("push", [1.0])
    with pytest.raises(ArgumentError, match="is not here"):
        found.response("u", [1.0]).of("mass.x", 7)
