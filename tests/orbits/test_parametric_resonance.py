"""A flexible rod whose axial force pulsates with the crank: growth, its shape, and the motion of twice the period."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from runtime import ArgumentError, Model, periodic
from runtime.orbits.motion import PeriodicMotion
from runtime.orbits.shooting import NoPeriodicMotion
from symgen.scene import Scene, SceneRecord

pytestmark = pytest.mark.long

Build = Callable[[SceneRecord], Model]


def thin_rod() -> SceneRecord:
    """A slider-crank whose rod of 8 mm x 4 mm carries 0.4 kg; the crank turns steadily, above 112 rad/s too fast."""
    builder = Scene("thin_rod").parameter("omega", 120.0, "rad/s")
    builder.rigid("crank", mass=0.36, inertia=7e-4, center_of_mass=(0.075, 0), markers={"tip": {"position": (0.15, 0)}})
    builder.beam(
        "rod", length=0.3, density=7870.0, area=3.2e-5, second_moment=0.008 * 0.004**3 / 12, youngs_modulus=2e11,
        lateral={"ends": "pinned-pinned", "modes": 1}, damping_ratio=0.005, stiffening=True,
    )  # fmt: skip
    builder.rigid("slider", mass=0.4, inertia=1e-5)
    builder.revolute("A", "ground.origin", "crank.origin").revolute("B", "crank.tip", "rod.start")
    builder.revolute("C", "rod.end", "slider.origin").prismatic("slide", "ground.origin", "slider.origin")
    builder.prescribed_angle("drive", "ground.origin", "crank.origin", motion="omega * t")
    builder.initial({"crank.theta": 0.0, "rod.theta": 0.0}).rates({"crank.theta": 120.0})
    return builder.simulation(t_end=0.1, dt=4e-5).build()


@pytest.fixture(scope="module")
def rod(model_of: Build) -> Model:
    return model_of(thin_rod())


@pytest.fixture(scope="module")
def growing(rod: Model) -> PeriodicMotion:
    return periodic(rod, speed="omega", tolerance=1e-7)


def test_runs_grow_as_the_floquet_exponent_says(growing: PeriodicMotion) -> None:
    assert growing.floquet.kind == "flip"
    count, state = 30, dict(growing.state)
    state["rod.q1_dot"] += 1e-7
    runs = [growing.simulate(count, initial=start, samples=count) for start in (state, growing.state)]
    off = np.abs(runs[0]["rod.q1"] - runs[1]["rod.q1"])
    late = np.arange(12, count)  # what dies out is gone
    growth = np.polyfit(late * growing.period, np.log(off[late]), 1)[0]
    assert growth == pytest.approx(growing.floquet.exponents[0].real, rel=1e-2)


def test_a_floquet_mode_is_what_a_disturbed_run_shows(growing: PeriodicMotion) -> None:
    size, every = 1e-7, max(1, growing.steps // 60)
    vector = growing.floquet.vectors[:, 0].real
    disturbed = {name: value + size * part for (name, value), part in zip(growing.state.items(), vector, strict=True)}
    runs = [
        growing.simulate(1, initial=start, seen_every=every * growing.period / growing.steps)
        for start in (disturbed, growing.state)
    ]
    shape = (runs[0].q - runs[1].q) / size * np.exp(-growing.floquet.exponents[0].real * runs[0].t)[:, None]
    mode = growing.mode(0, periods=2, amplitude=1.0)
    first = slice(0, len(shape) - 1)
    assert mode.q[first] - runs[1].q[first] == pytest.approx(shape[first], abs=3e-5 * np.abs(shape).max())
    second = mode.q[len(shape) - 1 : -1] - runs[1].q[first]
    second[:, growing.model.coordinates.index("crank.theta")] -= 2 * np.pi
    assert second == pytest.approx(-shape[first], abs=3e-5 * np.abs(shape).max())  # of a flip: it changes sides
    shown = growing.mode(0)
    assert "multiplier -1.15" in shown.scheme
    for wrong in ({"k": 7}, {"periods": 0}):
        with pytest.raises(ArgumentError):
            growing.mode(**wrong)


def test_a_rod_that_buckles_is_told(rod: Model) -> None:
    with pytest.raises(NoPeriodicMotion, match="thin_rod.*does not come to its end"):
        periodic(rod, speed="omega", parameters={"omega": 150.0})
