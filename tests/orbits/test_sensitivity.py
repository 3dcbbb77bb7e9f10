"""What the peak stress of a machine that repeats depends on, against differences, and how many runs a motion takes."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from runtime import DifferentiableRun, Model, periodic
from runtime.gradients import Largest
from runtime.orbits import motion as orbit
from symgen.scene import Scene, SceneRecord

Build = Callable[[SceneRecord], Model]
Load = Callable[[str], Model]
OMEGA, HEIGHT, MOST_RUNS = 300 * 2 * np.pi / 60, 0.004, 12  # rad/s, m


def stressed_four_bar() -> SceneRecord:
    """A crank at 300 rpm drives a flexible steel coupler of 12 mm x height, whose stress is measured in its middle."""
    builder = Scene("stressed_four_bar").parameter("omega", OMEGA, "rad/s").parameter("height", HEIGHT, "m")
    builder.ground(markers={"right": {"position": (0.30, 0)}}).gravity(0, -9.81)
    builder.rigid("crank", mass=0.8, inertia=4e-3, markers={"tip": {"position": (0.10, 0)}})
    builder.beam(
        "coupler", length=0.30, density=7850.0, area="0.012*height", second_moment="0.001*height*height*height",
        youngs_modulus=2.1e11, section_modulus="0.002*height*height", damping_ratio=0.02,
        lateral={"ends": "pinned-pinned", "modes": 2}, markers={"middle": {"at": 0.5}},
    )  # fmt: skip
    builder.rigid("rocker", mass=0.1, inertia=6e-4, center_of_mass=(0.12, 0), markers={"end": {"position": (0.25, 0)}})
    builder.revolute("A", "ground.origin", "crank.origin").revolute("B", "crank.tip", "coupler.start")
    builder.revolute("C", "coupler.end", "rocker.end").revolute("D", "ground.right", "rocker.origin")
    builder.prescribed_angle("drive", "ground.origin", "crank.origin", motion="omega * t")
    builder.measure("stress", "stress", of="coupler.middle")
    return builder.initial({"coupler.theta": 0.9, "rocker.theta": 1.9}).simulation(t_end=0.2, dt=1e-4).build()


@pytest.mark.long
def test_peak_stress_by_thickness_is_that_of_motions_beside_it(model_of: Build) -> None:
    model, how = model_of(stressed_four_bar()), {"speed": "omega", "steps": 400}
    found, of, values = periodic(model, **how), Largest("stress"), {}
    slope = found.gradient(of, ["height"])
    for sign in (1, -1):
        beside = periodic(model, **how, parameters={"height": HEIGHT * (1 + sign * 1e-4)}, start=found)
        assert np.abs(beside.x - found.x).max() > 1e-9  # solved anew: the motion itself moves with the thickness
        run = beside.simulate(1, seen_every=0.0)
        values[sign] = of.weighed(run.t, run["stress"][:, None])[0]
    assert slope["height"] == pytest.approx((values[1] - values[-1]) / (2e-4 * HEIGHT), rel=1e-6)
    assert slope.value == pytest.approx((values[1] + values[-1]) / 2, rel=1e-6)


def test_a_motion_takes_few_runs_of_a_period(built_in: Load, monkeypatch: pytest.MonkeyPatch) -> None:
    """Counted in seconds that are simulated, with derivatives or without, over the seconds of a period."""
    simulated: list[float] = []

    def counted(own: Callable[..., Any]) -> Callable[..., Any]:
        def run(self: DifferentiableRun, *given: Any, **named: Any) -> Any:
            simulated.append(self.plan.t_end - self.plan.t0)
            return own(self, *given, **named)

        return run

    def simulate(model: Model, **how: Any) -> Any:
        simulated.append(how["t_end"] - how["t0"])
        return simulate_itself(model, **how)

    simulate_itself = orbit.simulate
    for name in ("values", "jacobian"):
        monkeypatch.setattr(DifferentiableRun, name, counted(getattr(DifferentiableRun, name)))
    monkeypatch.setattr(orbit, "simulate", simulate)
    found = periodic(built_in("flexible_slider_crank"), speed="omega")
    assert found.error.largest <= 1e-6
    assert 3 <= sum(simulated) / found.period <= MOST_RUNS
