"""Numbers that are wrong or end in the middle of a run: refused by name, or a status that says whose they are."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
import pytest

from runtime import ArgumentError, Model, ModelError, Sampled, SchemeError, simulate
from symgen.scene import SceneRecord

Build = Callable[[SceneRecord], Model]
KINDS: list[dict[str, Any]] = [
    {"scheme": "dopri5", "tolerance": 1e-4, "seen_every": 0.02},
    {"scheme": "rk4", "dt": 0.01},
]


def rod(events: dict[str, Any], torque: str = "u") -> SceneRecord:
    return SceneRecord.model_validate(
        {
            "name": "rod",
            "gravity": [0, -9.81],
            "bodies": [
                {"type": "rigid", "name": "rod", "mass": 1.0, "inertia": 0.1, "center_of_mass": [0.5, 0.0]},
            ],
            "joints": [{"type": "revolute", "name": "pin", "marker_a": "ground.origin", "marker_b": "rod.origin"}],
            "loads": [{"type": "torque", "name": "drive", "marker": "rod.origin", "value": torque}],
            "inputs": {"u": {"default": 0.0}},
            "measures": [{"type": "coordinate", "name": "angle", "of": "rod.theta"}],
            "events": events,
            "simulation": {"t_end": 2.0, "dt": 0.01, "scheme": "rk4"},
        }
    )


@pytest.fixture(autouse=True)
def no_warning() -> Iterator[None]:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        yield


@pytest.mark.every_push("steps")
@pytest.mark.parametrize("kind", KINDS, ids=["tolerance", "steps"])
def test_whose_numbers_are_not_finite_is_said(model_of: Build, kind: dict[str, Any]) -> None:
    """At t = 1 s a load, from -0.4 rad on a condition, and by an action: with what was computed until then."""
    load = model_of(rod({}, "sqrt(1 - t) + u"))
    late = simulate(load, **kind)
    assert late.status.name == "not_finite" and "load 'drive', value: sqrt(1 - t)" in late.status.cause
    assert late.t[-1] == pytest.approx(1.0, abs=0.021) and [one.kind for one in late.events] == ["load_not_finite"]
    assert simulate(load, **kind, t_end=0.9).status.ok
    condition = simulate(model_of(rod({"low": {"when": "sqrt(angle + 0.4) - 0.1"}})), **kind)
    assert condition.status.name == "not_finite" and "event 'low', when: sqrt(angle + 0.4)" in condition.status.cause
    assert -0.4 < condition["rod.theta"][-1] < -0.3
    action = simulate(model_of(rod({"low": {"when": "angle + 0.4", "action": {"u": "log(angle)"}}})), **kind)
    assert action.status.name == "not_finite" and "event 'low', action, u: log(angle)" in action.status.cause
    assert action["rod.theta"][-1] == pytest.approx(-0.4, abs=1e-6)


@pytest.mark.every_push("steps")
@pytest.mark.parametrize("kind", KINDS, ids=["tolerance", "steps"])
def test_what_controllers_and_settings_may_not_be(model_of: Build, kind: dict[str, Any]) -> None:
    model = model_of(rod({"over": {"when": "t - 2"}, "half": {"when": "1 - t"}}))
    late = Sampled(lambda t, y: np.inf if t > 0.95 else 0.0, 0.1)
    run = simulate(model, **kind, inputs={"u": late})
    assert run.status.name == "not_finite" and "controller of input 'u' gave inf" in run.status.cause
    assert run.t[-1] == pytest.approx(1.0) and len(run.t) > 40
    for given, text in ((lambda t, y: None, "gave None"), (lambda t, y: np.ones(2), "gave array")):
        with pytest.raises(ArgumentError, match=text):
            simulate(model, **kind, inputs={"u": Sampled(given, 0.1)})
    with pytest.raises(ModelError, match="nan s apart"):
        simulate(model, **kind, inputs={"u": Sampled(lambda t, y: 0.0, np.nan)})
    with pytest.raises(SchemeError, match="cannot be distinguished"):
        simulate(model, **kind, t0=1e16, t_end=1e16 + 4)
    with pytest.raises(
        SchemeError, match="dt must be a positive number|dt: cannot be given with a tolerance, which chooses the step"
    ):
        simulate(model, **{**kind, "dt": -1.0})
    with pytest.raises(SchemeError, match="below what rounding leaves"):
        simulate(model, scheme="dopri5", tolerance=1e-16)
    events = [(one.name, one.direction, round(one.time, 9)) for one in simulate(model, **kind, t_end=2.0).events]
    assert events == [("half", "falling", 1.0), ("over", "rising", 2.0)]  # at zero to the last bit, and at the end
