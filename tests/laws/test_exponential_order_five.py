"""Exponential steps of order 5: slope and cap, few steps where nothing stiff has to be seen, one stage or several."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from runtime import SchemeError
from runtime.model import Model
from runtime.schemes import exponential
from runtime.schemes.catalogue import scheme_kind
from tests.support.order_case import OrderCase
from tests.support.prepared_runs import PreparedRuns

pytestmark = pytest.mark.long

Load = Callable[[str], Model]
FIVE = {"order": 5}


CASES = {
    "hub_beam": OrderCase(0.8, 8e-2, 1.4e-10),  # a load that depends on time, gyroscopic forces
    "flexible_slider_crank_torque": OrderCase(0.02, 1e-3, 6e-11),  # a loop, modal damping, gravity
    "flexible_slider_crank_free": OrderCase(0.008, 2e-4, 1.7e-11, "quasi_static"),
    "double_pendulum": OrderCase(1.0, 2e-2, 3e-9),
    "overdamped_joint": OrderCase(0.4, 4e-2, 6e-11),
}


@pytest.mark.parametrize("name", CASES)
def test_order_five(built_in: Load, name: str) -> None:
    """Law: the error at t_end falls with dt^5; with dt^6 where that of the two sub-steps leads."""
    case, model = CASES[name], built_in(name)
    exact = PreparedRuns(model, "dop853", start=case.start).end(case.t_end, case.dt / 160)
    runs, steps = PreparedRuns(model, "exponential", [2], FIVE, case.start), [case.dt, case.dt / 2, case.dt / 4]
    errors = [float(np.max(np.abs(runs.end(case.t_end, step) - exact))) for step in steps]
    slope = float(np.polyfit(np.log(steps), np.log(errors), 1)[0])
    assert errors[-1] < case.cap, (slope, errors)
    assert 4.7 < slope < 6.1, errors


def test_few_steps_where_nothing_stiff_has_to_be_seen(built_in: Load) -> None:
    """The arm with stiff gears, w h = 80: 50 steps. Order 4 is off by 0.07, order 5 without its echo by 0.015."""
    model = built_in("flexible_joint_arm")
    exact = PreparedRuns(model, "dop853").end(2.0, 2e-4)
    found = PreparedRuns(model, "exponential", [1], FIVE).end(2.0, 0.04)
    assert np.abs(found - exact).max() < 8e-4


@pytest.mark.parametrize("order, m", [(4, 1), (4, 2), (5, 1), (5, 2)])
def test_one_stage_is_the_stages_in_a_row(built_in: Load, monkeypatch: pytest.MonkeyPatch, order: int, m: int) -> None:
    """A step in one stage and the same step in its stages: to rounding."""
    model = built_in("flexible_slider_crank_free")

    def end() -> np.ndarray:
        return PreparedRuns(model, "exponential", [m], {"order": order}, engine="interpreted").end(2e-3, 2e-4)

    at_once = end()
    monkeypatch.setattr(exponential, "LONG_TREE", 0)
    np.testing.assert_allclose(end(), at_once, rtol=0, atol=1e-13 * np.abs(at_once).max())


@pytest.mark.parametrize("m, options", [([4], {}), (None, {"tolerance": 1e-4})])
def test_what_order_five_cannot_do_is_refused(built_in: Load, m: list[int] | None, options: dict[str, object]) -> None:
    kind, model = scheme_kind("exponential"), built_in("double_pendulum")
    with pytest.raises(SchemeError, match="order"):
        kind.build("exponential", model, 1e-2, m, {**FIVE, **options})
    with pytest.raises(SchemeError, match="order must be a whole number from 4 to 5, not 6"):
        kind.build("exponential", model, 1e-2, None, {"order": 6})
    assert kind.build("exponential", model, 1e-2, None, FIVE).grid.m == [2]
