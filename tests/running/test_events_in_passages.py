"""Events near a singular position, where a run is integrated tightly and no steps are made."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from runtime import Model, simulate
from runtime.running.singular import over
from runtime.running.singular.crossing import BranchLost
from symgen.scene import SceneRecord
from symgen.scenes.linkages import n_four_bar

pytestmark = pytest.mark.long

Build = Callable[[SceneRecord], Model]


def watched() -> SceneRecord:
    """Four bars whose torque is set by an event before the singular position and one behind it."""
    data = n_four_bar(2).model_dump()
    data["name"] = "n_four_bar_events"
    data["inputs"] = {"torque": {"default": 0.0, "unit": "N m"}}
    data["loads"] = [{"type": "torque", "name": "motor", "marker": "upright0.origin", "value": "torque"}]
    data["measures"] = [{"type": "coordinate", "name": "angle", "of": "upright0.theta"}]
    data["events"] = {
        "before": {"when": "angle - 0.02", "action": {"torque": "push"}},
        "at": {"when": "angle"},
        "behind": {"when": "angle + 0.02", "action": {"torque": "40"}},
        "ending": {"when": "angle + last", "terminal": True},
    }
    data["parameters"] = {"last": {"default": 0.03, "unit": "rad"}, "push": {"default": 20.0, "unit": "N m"}}
    return SceneRecord.model_validate(data)


@pytest.mark.parametrize(
    "scheme, tolerance, cap", [("rk4", None, 2e-10), ("single_rate", None, 2e-6), ("dopri5", 1e-9, 2e-10)]
)
def test_events_within_a_passage_are_told_and_act(
    model_of: Build, scheme: str, tolerance: float | None, cap: float
) -> None:
    """Before, at and behind the position; by hand 3 y'' = 3.5 g sin y - torque, with the angle pi/2 - y.

    Before it the torque sets in, behind it it is doubled; one behind it may end the run, at its time.
    """
    model = model_of(watched())

    def angle(t: float, y: list[float], torque: float) -> list[float]:
        return [y[1], -(3.5 * 9.81 * math.cos(y[0]) - torque) / 3]

    t, y, times = 0.0, np.array([math.pi / 2, -1.0]), []
    for torque, passing in ((0, 0.02), (20, 0.0), (20, -0.02), (40, -0.03), (40, -0.5)):

        def reached(t: float, y: np.ndarray, torque: float, passing: float = passing) -> float:
            return float(y[0] - passing)

        reached.terminal = True  # type: ignore[attr-defined]
        found = solve_ivp(angle, (t, 9), y, args=(torque,), events=reached, method="DOP853", rtol=1e-12, atol=1e-13)
        t, y = found.t[-1], found.y[:, -1]
        times.append(t)
    settings: dict[str, Any] = {"scheme": scheme, "tolerance": tolerance, "t_end": 1.0, "seen_every": 1e-3}
    for last in (0.03, 0.5):
        run = simulate(model, **settings, parameters={"last": last})
        told = [(event.kind, event.name) for event in run.events]
        exact = [*times[:3], times[3 if last == 0.03 else 4]]
        happened = [event for event in run.events if event.kind == "event"]
        assert [event.name for event in happened] == ["before", "at", "behind", "ending"], told
        assert [event.time for event in happened] == pytest.approx(exact, rel=0, abs=cap)
        assert [event.time for event in run.events] == sorted(event.time for event in run.events)
        assert run.status.name == "event" and run.t[-1] == run.events[-1].time
        assert len(run.t) == 2 + int(exact[-1] / 1e-3) and np.ptp(run.energy_balance()) < 1e-4
        assert run["torque"][-1] == 40 and run["upright0.theta"][-1] == pytest.approx(-last, abs=1e-8)


def test_forces_that_turn_a_motion_back_before_the_position(model_of: Build, monkeypatch: pytest.MonkeyPatch) -> None:
    """4000 N m stop the uprights 0.01 rad before it: it is not passed. Where it cannot be passed, that is said."""
    model, push = model_of(watched()), 4000.0
    settings: dict[str, Any] = {"scheme": "rk4", "dt": 1e-3, "t_end": 0.75, "seen_every": 0.0}
    run = simulate(model, **settings, parameters={"push": push})
    assert run.status.ok and [event.name for event in run.events] == ["before", "before"]  # and back
    before = run.events[0].time
    rate = -math.sqrt(1 + 2 * 3.5 * 9.81 / 3 * (1 - math.sin(0.02)))  # by the energy

    def angle(t: float, y: list[float]) -> list[float]:
        return [y[1], -(3.5 * 9.81 * math.cos(y[0]) - push) / 3]

    times = run.t[run.t > before]
    exact = solve_ivp(angle, (before, 0.76), [0.02, rate], method="DOP853", rtol=1e-12, atol=1e-13, t_eval=times).y[0]
    assert exact.min() > 0 and run["upright0.theta"][run.t > before] == pytest.approx(exact, abs=1e-6)

    def refuse(*_: Any) -> None:
        raise BranchLost("made up")

    honest = over.Over._gone_on

    def refused(*known: Any) -> Any:
        monkeypatch.setattr(over, "cross", refuse)
        return honest(*known)

    monkeypatch.setattr(over.Over, "_gone_on", refused)
    lost = simulate(model, **settings)
    assert lost.status.name == "branch_lost" and "made up" in lost.status.cause
