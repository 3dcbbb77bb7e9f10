"""Sub-stepping schemes: one sub-step is single-rate, orders by slope and cap, nested groups, rounding of two routes."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import pytest

from runtime import simulate
from runtime.model import Model
from symgen.scene import SceneRecord
from symgen.scenes import SCENES
from tests.support.model_values import Array
from tests.support.prepared_runs import PreparedRuns

pytestmark = pytest.mark.long

Load = Callable[[str], Model]
Build = Callable[[SceneRecord], Model]


@dataclass(frozen=True)
class Case:
    """t_end, coarsest step, and caps on the error at the finest of three steps, about 1.5 times the measured one.

    wide: t_end and step of the schemes that need no short step (rational sub-steps), where they differ.
    """

    t_end: float
    dt: float
    caps: dict[str, float]
    wide: dict[str, tuple[float, float]] = field(default_factory=dict)
    start: str | None = None


CASES = {
    "flexible_slider_crank": Case(
        0.004,
        8e-6,
        {"coupled": 3.5e-10, "exponential": 7e-13},
        {"exponential": (0.004, 2e-4)},
    ),
    "hub_beam": Case(  # undamped, a load that depends on time, gyroscopic forces
        0.8,
        8e-3,
        {
            "coupled": 1.9e-7,
            "exponential": 5.5e-11,
        },
        {"exponential": (0.8, 1.6e-2)},  # at half the step the finest error is that of the reference
    ),
    "flexible_slider_crank_free": Case(
        0.004,
        8e-6,
        {
            "coupled": 1e-8,
            "exponential": 3e-10,
        },
        {"exponential": (0.008, 1e-4)},
        start="quasi_static",
    ),
    "flexible_slider_crank_torque": Case(  # modal damping, gravity
        0.02,
        1e-4,
        {"coupled": 1.2e-7, "exponential": 1.42e-10},
        {"exponential": (0.02, 8e-4)},  # with smaller ones rounding (4e-13 in 400 steps) counts in the finest error
    ),
    "spin_up_beam": Case(  # prescribed, centrifugal stiffening, no second group
        2.0, 1e-2, {"exponential": 4.2e-10}, {"exponential": (4.0, 0.2)}
    ),
    "double_pendulum": Case(  # centrifugal forces
        1.0,
        4e-3,
        {
            "exponential": 1.3e-10,
        },
    ),
    "overdamped_joint": Case(  # a damper 30 times the critical one: rational sub-steps take 100 times the step
        0.01,
        4e-5,
        {
            "coupled": 1.5e-10,
            "exponential": 1.7e-10,
        },
        {"exponential": (0.2, 1e-2)},
    ),
}
ORDERS = [(scene, scheme) for scene, case in CASES.items() for scheme in case.caps]


REFERENCES: dict[tuple[str, float], Array] = {}


def reference(model: Model, t_end: float, start: str | None) -> Array:
    """q_i at t_end by steps of order 8, a tenth of the coarsest explicit ones; once."""
    key = (model.name, t_end)
    if key not in REFERENCES:
        REFERENCES[key] = PreparedRuns(model, "dop853", start=start).end(t_end, CASES[model.name].dt / 10)
    return REFERENCES[key]


def slope_of(steps: list[float], errors: list[float]) -> float:
    """Of log error against log step."""
    return float(np.polyfit(np.log(steps), np.log(errors), 1)[0])


@pytest.mark.parametrize("scene, scheme", ORDERS)
def test_order(built_in: Load, scene: str, scheme: str) -> None:
    """Law: at fixed m the error at t_end falls with dt^2, of exponential steps with rational sub-steps with dt^4."""
    case, model = CASES[scene], built_in(scene)
    t_end, dt = case.wide.get(scheme, (case.t_end, case.dt))
    runs, steps = PreparedRuns(model, scheme, [4], {}, case.start), [dt, dt / 2, dt / 4]
    exact = reference(model, t_end, case.start)
    errors = [float(np.max(np.abs(runs.end(t_end, step) - exact))) for step in steps]
    slope = slope_of(steps, errors)
    assert errors[-1] < case.caps[scheme], errors
    if scheme != "exponential":
        assert slope == pytest.approx(2.0, abs=0.1), errors
    elif scene == "flexible_slider_crank_free":  # the term of fifth order leads: slopes from 4.3 to 5.1
        assert 3.7 < slope < 5.3, errors
    else:
        assert slope == pytest.approx(4.0, abs=0.3), errors


@pytest.mark.parametrize(
    "name, t_end, dt, start",
    [
        ("flexible_slider_crank_free", 0.01, 1e-5, "quasi_static"),
        ("flexible_slider_crank_free", 0.01, 1e-5, "given"),
        ("hub_beam", 1.0, 5e-3, "given"),
        ("two_oscillators", 2.0, 1e-2, "given"),
    ],
)
def test_one_sub_step_is_single_rate(built_in: Load, name: str, t_end: float, dt: float, start: str) -> None:
    """Law: with m = 1 nothing is held, and the step is central difference with a predicted velocity, to rounding."""
    model = built_in(name)
    given: dict[str, Any] = {"t_end": t_end, "dt": dt, "start": start, "seen_every": 10 * dt, "engine": "interpreted"}
    one = simulate(model, scheme="coupled", m=[1], **given)
    single = simulate(model, scheme="single_rate", options={"common_velocity": "predictor"}, **given)
    assert {one.status.name, single.status.name} == {"completed"}
    assert np.max(np.abs(one.q[-1] - one.q[0])) > 1e-3
    np.testing.assert_allclose(one.q, single.q, rtol=0, atol=1e-11 * np.max(np.abs(single.q)))
    two = simulate(model, scheme="coupled", m=[2], **given)
    assert np.max(np.abs(two.q - single.q)) > 1e-9 * np.max(np.abs(single.q))


@pytest.mark.parametrize("m", [[2, 2], [1, 3], [4, 1], [3, 2]])
def test_three_groups_are_second_order(model_of: Build, m: list[int]) -> None:
    """Law: nested held groups keep the order, with crank, lateral and axial modes as groups of their own."""
    data = SCENES["flexible_slider_crank_free"]().model_dump()
    data["partition"]["groups"] = [
        {"name": "crank", "coordinates": ["crank.theta"]},
        {"name": "lateral", "coordinates": ["rod.q1", "rod.q2"]},
        {"name": "axial", "coordinates": ["rod.q3", "rod.q4"]},
    ]
    data["simulation"]["m"] = [1, 1]
    model, t_end, steps = model_of(SceneRecord.from_dict(data)), 0.004, [1e-5, 5e-6, 2.5e-6]
    exact = PreparedRuns(model, "dop853", start="quasi_static").end(t_end, 1e-6)
    runs = PreparedRuns(model, "coupled", m, start="quasi_static")
    errors = [float(np.max(np.abs(runs.end(t_end, step) - exact))) for step in steps]
    assert slope_of(steps, errors) == pytest.approx(2.0, abs=0.1), errors
    assert errors[-1] < 1.5e-8, errors
