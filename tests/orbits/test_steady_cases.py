"""Many steady states, and parameters from a measured one: against closed forms, and against motions one by one."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
import pytest

from runtime import ArgumentError, Model, NoResult
from runtime.studies.steady_states import SteadyRun
from symgen.scene import Scene, SceneRecord

Build = Callable[[SceneRecord], Model]
HOW: dict[str, Any] = {"speed": "w", "steps": 200}


def oscillator(cubic: bool = False) -> SceneRecord:
    """1 kg on a spring k and a damper c, under F cos(w t); with a cubic spring as well."""
    scene = Scene("duffing" if cubic else "oscillator").parameter("w", 6.0, "rad/s").parameter("F", 3.0)
    scene.parameter("k", 50.0).parameter("c", 0.8).rigid("b", mass=1.0, inertia=1.0)
    scene.prismatic("rail", "ground.origin", "b.origin").spring_damper(
        "s", "ground.origin", "b.origin", "k", damping="c"
    )
    scene.measure("x", "x", of="b.origin").effort("f", "rail.travel", "F * cos(w * t)" + " - 400 * x**3" * cubic)
    return scene.simulation(t_end=1.0, dt=1e-3, scheme="rk4").build()


def amplitude(k: Any, c: float = 0.8) -> Any:
    """Complex, of 1 kg at 6 rad/s under 3 N."""
    return 3 / (k - 36 + 1j * c * 6)


def of(found: Any, name: str) -> np.ndarray:
    return np.asarray(found[name] if isinstance(found, Mapping) and not hasattr(found, "dims") else found[name].values)


def test_amplitudes_of_an_oscillator(model_of: Build) -> None:
    """F / |k - m w^2 + i c w| of each case, whatever their order, and nothing of the transient."""
    k = np.array([40.0, 60.0, 45.0])
    found = model_of(oscillator()).periodic_cases({"k": k}, {"b.x": ["peak", "rms", "mean"]}, **HOW)
    np.testing.assert_allclose(of(found, "b.x_peak"), np.abs(amplitude(k)), rtol=3e-4)  # by samples, not at the crest
    np.testing.assert_allclose(of(found, "b.x_rms"), np.abs(amplitude(k)) / np.sqrt(2), rtol=1e-6)
    assert np.abs(of(found, "b.x_mean")).max() < 1e-8
    assert set(of(found, "status")) == {"completed"} and set(of(found, "stability")) == {"stable"}
    np.testing.assert_allclose(of(found, "multiplier"), np.exp(-0.4 * 2 * np.pi / 6), rtol=1e-6)
    assert of(found, "error").max() < 1e-6


@pytest.mark.long
def test_each_case_is_the_motion_by_itself(model_of: Build) -> None:
    """A cubic spring: its steady states, found from one another, are those that are found alone."""
    model, F = model_of(oscillator(cubic=True)), np.array([1.0, 2.0])
    found = model.periodic_cases({"F": F, "c": 1.5}, {"b.x": "rms"}, **HOW)
    for value, rms in zip(F, of(found, "b.x_rms"), strict=True):
        run = model.periodic(parameters={"F": float(value), "c": 1.5}, **HOW).simulate(1, seen_every=0.0)
        assert rms == pytest.approx(np.sqrt(np.mean(run["b.x"][:-1] ** 2)), rel=1e-7)


@pytest.mark.long
def test_a_case_without_a_motion_says_so(model_of: Build) -> None:
    """At resonance without damping nothing repeats, only the steps do; the other case does not suffer."""
    found = model_of(oscillator()).periodic_cases({"k": [36.0, 50.0], "c": [0.0, 0.8]}, {"b.x": "rms"}, **HOW)
    first, second = of(found, "status")
    assert first in ("no_motion", "inaccurate") and second == "completed"
    assert of(found, "b.x_rms")[1] == pytest.approx(np.abs(amplitude(50.0)) / np.sqrt(2), rel=1e-6)


@pytest.mark.long
def test_stiffness_and_damping_from_a_steady_state(model_of: Build) -> None:
    """From the closed form at 40 angles of the drive, and with noise within what is said; slopes by hand."""
    model, t = model_of(oscillator()), 2 * np.pi / 6 * np.arange(40) / 40
    data = (amplitude(50.0) * np.exp(6j * t)).real
    exact = model.fit_periodic({"b.x": data}, ["k", "c"], guess={"k": 42.0, "c": 1.5}, deviation=1e-3, **HOW)
    np.testing.assert_allclose(exact.x, [50.0, 0.8], rtol=1e-6)
    noisy = data + np.random.default_rng(2).normal(0.0, 1e-3, 40)
    found = model.fit_periodic({"b.x": noisy}, ["k", "c"], guess={"k": 42.0, "c": 1.5}, deviation=1e-3, **HOW)
    assert found.contains({"k": 50.0, "c": 0.8}, 0.99) and 0 < found.standard_errors[0] < 0.1
    run = SteadyRun(model, ("b.x",), ("k", "c"), {}, 40, dict(HOW))
    by_hand = [-(amplitude(50.0) ** 2) / 3, -6j * amplitude(50.0) ** 2 / 3]
    slopes = run.jacobian(run.x0).derivatives[:, 0]
    for k, slope in enumerate(by_hand):
        np.testing.assert_allclose(slopes[:, k], (slope * np.exp(6j * t)).real, atol=2e-6 * np.abs(slope))


def test_what_cannot_be_asked(model_of: Build) -> None:
    model = model_of(oscillator())
    with pytest.raises(ArgumentError, match="there is no reduction 'end'; choose from max, min, peak"):
        model.periodic_cases({"k": [40.0, 50.0]}, {"b.x": "end"}, **HOW)
    with pytest.raises(ArgumentError, match="start: is that of each case"):
        model.periodic_cases({"k": [40.0, 50.0]}, {"b.x": "rms"}, start={}, **HOW)
    with pytest.raises(ArgumentError, match="would change the period"):
        model.fit_periodic({"b.x": np.zeros(40)}, ["w"], **HOW)
    with pytest.raises(ArgumentError, match="steps: are 200, with 30 samples; give a multiple"):
        model.fit_periodic({"b.x": np.zeros(30)}, ["k"], **HOW)
    with pytest.raises(NoResult, match="the data do not determine"):
        model.fit_periodic({"b.x": np.zeros(40)}, ["k", "b.inertia"], deviation=1.0, **HOW)
