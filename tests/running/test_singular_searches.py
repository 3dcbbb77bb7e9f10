"""What the search for a singular passage costs, and that it ends."""

from __future__ import annotations

import signal
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from runtime import Model, simulate
from runtime.running.singular import crossing
from symgen.scene import Scene, SceneRecord

pytestmark = pytest.mark.long

Build = Callable[[SceneRecord], Model]


def equal_slider_crank() -> SceneRecord:
    """Crank and rod of one length: upright, the rod may go on beside the crank or turn with it."""
    scene = Scene("loop").gravity(0, -9.81)
    for name in ("crank", "rod"):
        scene.rigid(name, mass=1.0, inertia=0.02, center_of_mass=(0.25, 0), markers={"tip": {"position": (0.5, 0)}})
    scene.rigid("slider", mass=0.5, inertia=0.01)
    scene.revolute("A", "ground.origin", "crank.origin").revolute("B", "crank.tip", "rod.origin")
    scene.prismatic("slide", "ground.origin", "slider.origin").revolute("C", "rod.tip", "slider.origin")
    scene.initial({"crank.theta": 0.5, "rod.theta": -0.5}).rates({"crank.theta": 6.0})
    return scene.independent("crank.theta").simulation(t_end=5.0, dt=1e-3, scheme="single_rate").build()


def fast_rod() -> SceneRecord:
    """A crank of 150 rad/s with a slender, stiffened rod: M_hat loses its sign after 1.9 ms."""
    side, height = 0.006, 0.007
    builder = Scene("fast_rod").rigid("crank", mass=1.0, inertia=0.01, markers={"tip": {"position": (0.15, 0)}})
    builder.beam(
        "rod",
        length=0.3,
        density=7870.0,
        area=side * height,
        second_moment=side * height**3 / 12,
        youngs_modulus=2e11,
        lateral={"ends": "clamped-free", "modes": 6},
        stiffening=True,
    )
    builder.rigid("slider", mass=0.1, inertia=1e-5)
    builder.revolute("A", "ground.origin", "crank.origin").revolute("B", "crank.tip", "rod.start")
    builder.prismatic("slide", "ground.origin", "slider.origin").revolute("C", "rod.end", "slider.origin")
    return builder.initial({"crank.theta": 0.3}).rates({"crank.theta": 150.0}).build()


@pytest.mark.parametrize("scheme", ["single_rate", "dop853"])
def test_a_motion_that_cannot_be_followed_ends_by_name(model_of: Build, monkeypatch, scheme: str) -> None:
    """The search for a singular passage has a bound: where steps shrink for ever, other checks say why the run ends."""
    asked, honest = [0], crossing.TightIntegrator.slope

    def counted(self: Any, t: float, y: np.ndarray) -> np.ndarray:
        asked[0] += 1
        return honest(self, t, y)

    monkeypatch.setattr(crossing.TightIntegrator, "slope", counted)
    run = simulate(model_of(fast_rod()), scheme=scheme, dt=1e-5, t_end=0.01)
    assert run.status.name == "mass_not_positive" and 1.5e-3 < run.status.time < 2e-3
    assert asked[0] <= 2 * crossing.MOST_CROSSING_EVALUATIONS


@pytest.mark.usefixtures("ctrl_c")
def test_interrupt_is_heard_in_a_search(model_of: Build, monkeypatch: pytest.MonkeyPatch) -> None:
    """One Ctrl-C while the way to a singular position is followed: the run ends with its last good state."""
    honest = crossing.TightIntegrator.slope
    pressed: list[bool] = []

    def press(self: Any, t: float, y: np.ndarray) -> np.ndarray:
        if not pressed:
            pressed.append(True)
            signal.raise_signal(signal.SIGINT)
        return honest(self, t, y)

    monkeypatch.setattr(crossing.TightIntegrator, "slope", press)
    run = simulate(model_of(equal_slider_crank()), scheme="rk4", dt=1e-3)
    assert pressed and run.status.name == "interrupted"
    assert run.t[-1] == pytest.approx(run.status.time) and np.isfinite(run.q).all()


def test_cost_of_a_passage_does_not_grow_with_the_number_of_steps(model_of: Build, monkeypatch) -> None:
    """Evaluations of the tight integration over a singular position, for steps of 1e-3 and of 1e-4."""
    honest = crossing.TightIntegrator.slope
    counts: list[int] = []

    def counted(self: Any, t: float, y: np.ndarray) -> np.ndarray:
        counts[-1] += 1
        return honest(self, t, y)

    monkeypatch.setattr(crossing.TightIntegrator, "slope", counted)
    model = model_of(equal_slider_crank())
    for dt in (1e-3, 1e-4):
        counts.append(0)
        run = simulate(model, scheme="single_rate", dt=dt, t_end=0.6, seen_every=1e-2)
        assert run.status.ok and len(run.events) == 1
    assert counts[1] <= 1.5 * counts[0]
