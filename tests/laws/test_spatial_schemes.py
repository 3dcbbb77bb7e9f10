"""Sub-cycling schemes and the stability study on flexible bodies in space: the laws of planar mechanisms hold there."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from runtime import simulate
from runtime.model import Model
from runtime.studies.stability import chart as limits
from runtime.studies.stability.chart import StabilityStudy, states_along
from runtime.studies.stability.spectra import ExactMotion
from symgen.scene import Scene, SceneRecord
from tests.support.modes import modes_of
from tests.support.prepared_runs import PreparedRuns

pytestmark = pytest.mark.long

Build = Callable[[SceneRecord], Model]
ENGINE = "compiled"
START = "quasi_static"


def skew_pendulum() -> SceneRecord:
    """A beam that bends in two planes, on a hinge that is oblique to it and to gravity; bent at the start."""
    builder = Scene("skew_pendulum", space="spatial").gravity(0.0, 0.0, -9.81)
    builder.ground(markers={"hinge": {"axis": [0.3, 1.0, 0.2]}})
    builder.beam(
        "beam",
        length=1.0,
        density=2700.0,
        area=4e-4,
        second_moment=3e-9,
        second_moment_z=9e-9,
        youngs_modulus=7e10,
        lateral={"ends": "clamped-free", "modes": 1},
        lateral_z={"ends": "clamped-free", "modes": 1},
        stiffening=True,
        markers={"hinge": {"at": 0.0, "axis": [0.2, 1.0, 0.6]}},
    )
    builder.joint("revolute", "hinge", "ground.hinge", "beam.hinge")
    builder.initial({"beam.q1": 0.01, "beam.q2": -0.02}).rates({"hinge.angle": 3.0})
    return builder.simulation(t_end=1.0, dt=1e-3, m=[4], scheme="coupled").build()


@pytest.fixture(scope="module")
def model(model_of: Build) -> Model:
    found = model_of(skew_pendulum())
    groups = [[found.q_i[k] for k in group.positions] for group in found.groups]
    assert groups == [["hinge.angle"], ["beam.q1", "beam.q2"]]
    return found


# scheme, m, t_end, coarsest step, cap on the error at the finest of three steps: 1.5 times the measured one (below
# 1e-10 it is that of the reference)
ORDERS = [("coupled", [4], 0.2, 1e-3, 6e-5, 2.0), ("exponential", [4], 0.4, 8e-4, 5.5e-10, 4.0)]


@pytest.mark.parametrize("scheme, m, t_end, dt, cap, order", ORDERS)
def test_order(model: Model, scheme: str, m: list[int], t_end: float, dt: float, cap: float, order: float) -> None:
    """Law: at fixed m the error at t_end falls with dt^2 (coupled) and dt^4 (exponential, rational sub-steps)."""
    runs, steps = PreparedRuns(model, scheme, m), np.array([dt, dt / 2, dt / 4])
    exact = PreparedRuns(model, "dop853").end(t_end, 1e-4)
    errors = [float(np.max(np.abs(runs.end(t_end, step) - exact))) for step in steps]
    assert errors[-1] < cap, errors
    assert float(np.polyfit(np.log(steps), np.log(errors), 1)[0]) == pytest.approx(order, abs=0.1), errors


def test_one_sub_step_is_single_rate(model: Model) -> None:
    """Law: with m = 1 nothing is held, and the step is central difference with a predicted velocity, to rounding."""
    given: dict[str, Any] = {"t_end": 0.5, "dt": 1e-3, "seen_every": 0.01, "engine": ENGINE}
    one, two = (simulate(model, scheme="coupled", m=[m], **given) for m in (1, 2))
    single = simulate(model, scheme="single_rate", options={"common_velocity": "predictor"}, **given)
    assert one.status.whole and single.status.whole
    assert np.max(np.abs(one.q[-1] - one.q[0])) > 1e-3
    np.testing.assert_allclose(one.q, single.q, rtol=0, atol=1e-11 * np.max(np.abs(single.q)))
    assert np.max(np.abs(two.q - single.q)) > 1e-9 * np.max(np.abs(single.q))


@pytest.mark.parametrize("scheme, m, reach", [("single_rate", None, 1.0), ("coupled", [4], 4.0), ("rk4", None, 2**0.5)])
def test_predicted_limits_are_real(
    model: Model, monkeypatch: pytest.MonkeyPatch, scheme: str, m: list[int] | None, reach: float
) -> None:
    """Law: 2 % below the predicted limit a run stays in bounds, 2 % above it blows up. From elastic equilibrium:

    the fastest mode is distorted fivefold at 0.98 of the limit, and from the bent start that is out of bounds.
    """
    t_end, c = 2.0, model.constants(model.parameter_vector())
    monkeypatch.setattr(limits, "CHART_BISECTIONS", 4)  # of 8 %: to 0.25 %
    states, exact = states_along(model, t_end=t_end, count=6, start=START), ExactMotion(model, c)
    edge = 2 * reach / max(modes_of(exact.modes, state).frequencies[-1] for state in states)
    limit = (
        StabilityStudy(model, scheme, m, {}, c, states, t_end, exact)
        .curve(np.geomspace(0.96 * edge, 1.04 * edge, 2))
        .limit
    )
    assert limit is not None and 0.96 * edge < limit < 1.04 * edge
    fine = simulate(model, t_end=t_end, dt=1e-4, scheme="single_rate", seen_every=5e-3, engine=ENGINE, start=START)
    largest = np.abs(fine.q_i).max(axis=0)

    def in_bounds(dt: float) -> bool:
        run = simulate(model, t_end=t_end, dt=dt, m=m, scheme=scheme, force=True, engine=ENGINE, start=START)
        return run.status.whole and bool((np.abs(run.q_i).max(axis=0) < 10 * largest).all())

    assert in_bounds(0.98 * limit)
    assert not in_bounds(1.02 * limit)
