"""Motions are compared at times that no vibration is in phase with; amplitudes are those of the whole motion."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from runtime import Model, simulate
from runtime.running.comparison_times import comparison_steps, refined, shared
from runtime.running.step_refinement import shown_order
from symgen.scene import Scene, SceneRecord

Build = Callable[[SceneRecord], Model]
PERIOD = 2 * np.pi
WITHIN = 3.0


def oscillators(**of: tuple[float, float]) -> SceneRecord:
    """Masses of 1 kg on rails, x'' = -w^2 x from (w [rad/s], x0 [m]) at rest, so that x = x0 cos(w t)."""
    builder = Scene("oscillators")
    for name, (w, start) in of.items():
        builder.rigid(name, mass=1.0, inertia=1.0).prismatic(f"rail_{name}", "ground.origin", f"{name}.origin")
        builder.measure(f"x_{name}", "x", of=f"{name}.origin")
        builder.force(f"spring_{name}", f"{name}.origin", f"-{w!r}**2 * x_{name}", 0).initial({f"{name}.x": start})
    return builder.build()


ONE = {"a": (PERIOD, 1.0)}
TWO = {"a": (PERIOD, 1.0), "b": (0.83, 20.0)}
RUNS: list[tuple[dict[str, tuple[float, float]], float, dict[str, Any]]] = [
    *((ONE, t_end, {"scheme": "rk4", "dt": 0.05}) for t_end in (50.0, 100.0, 97.3)),
    *((ONE, t_end, {"scheme": "single_rate", "dt": 0.01}) for t_end in (100.0, 250.0)),
    (ONE, 100.0, {"tolerance": 1e-3}),
    (ONE, 100.0, {"tolerance": 1e-3, "samples": 100}),
    (ONE, 64.0, {"scheme": "rk4", "tolerance": 1e-6}),
    *((TWO, t_end, {"tolerance": 1e-6}) for t_end in (50.0, 100.0)),
    *((TWO, 100.0, one) for one in ({"scheme": "rk4", "dt": 0.05}, {"scheme": "single_rate", "dt": 0.01})),
]


@pytest.mark.parametrize(("of", "t_end", "settings"), RUNS)
def test_a_vibration_that_is_in_phase_with_the_span(
    model_of: Build, of: dict[str, tuple[float, float]], t_end: float, settings: dict[str, Any]
) -> None:
    """Its period divides the motion evenly; against the cosine."""
    run = simulate(model_of(oscillators(**of)), t_end=t_end, **settings)
    off = 0.0
    for name, (w, start) in of.items():  # over all phases: as of energy, for samples may be in one phase themselves
        late = (run[f"{name}.x"] - start * np.cos(w * run.t)), run[f"{name}.x_dot"] / w + start * np.sin(w * run.t)
        off = max(off, float(np.sqrt(np.mean(np.square(late).sum(axis=0))) / start))
    told = run.error.largest
    assert off / WITHIN < told < off * WITHIN, (told, off)
    assert (run.status.name == "completed") == (off < 0.1)
    if "tolerance" in settings:
        assert off < settings["tolerance"]


def test_a_span_of_whole_periods_takes_no_more_steps_than_another(model_of: Build) -> None:
    """100 periods took 20 times the steps of 97.3 where their rates, seen at rest only, were condemned."""
    model = model_of(oscillators(**ONE))
    steps = [int(simulate(model, t_end=t_end, tolerance=1e-3).stats["steps"]) for t_end in (97.3, 100.0, 200.0)]
    assert steps[1] < 1.5 * steps[0] and steps[2] < 6 * steps[0]


@pytest.mark.parametrize("every", [1, 7])
def test_no_frequency_keeps_step_with_the_times(every: int) -> None:
    """An error t sin(2 pi f t) has over (0, 1) the mean square 1/6 - 1/(8 pi^2 f^2) for whole numbers 2 f."""
    steps = 100_003
    t = comparison_steps(steps, every) / steps
    for f in np.arange(1, 4000) / 2:
        seen, true = np.mean((t * np.sin(2 * np.pi * f * t)) ** 2), 1 / 6 - 1 / (8 * np.pi**2 * f**2)
        assert 0.6**2 < seen / true < 1.3**2, f


@pytest.mark.parametrize("growth", [1.05, 1.3, 2.5])
def test_refined_motions_share_times_a_few_steps_apart(growth: float) -> None:
    units = 1
    for _ in range(20):
        following = refined(units, growth * units)
        assert following > units and following >= growth * units and following % shared(units) == 0
        assert following <= max(1.35 * growth * units, units + 2)
        apart = units // shared(units)
        assert apart < 10 and (units < 5 or apart >= 5)
        units = following


@pytest.mark.parametrize("order", [1.0, 2.0, 4.0, 5.0])
@pytest.mark.parametrize(("first", "second"), [(2.5, 2.5), (2.5, 1.5), (2.5, 1.19), (1.19, 2.5), (1.1, 1.1)])
def test_the_order_of_three_motions(order: float, first: float, second: float) -> None:
    """Of sequences with errors h^p exactly, whatever the ratios of their steps."""
    errors = np.array([1.0, first**-order, (first * second) ** -order])
    earlier, later = -np.diff(errors)
    assert shown_order(earlier, later, first, second, 12.0) == pytest.approx(order, rel=1e-6)
    assert shown_order(earlier, later, first, second, order / 2) == order / 2


def test_motions_that_come_no_nearer_show_no_order() -> None:
    """Of p = 0 the ratio of differences is log(first) / log(second): what is below it shows none."""
    assert shown_order(0.9 * np.log(2.0) / np.log(1.5), 1.0, 2.0, 1.5, 4.0) == 0.0
    assert shown_order(1.0, 0.0, 2.0, 1.5, 4.0) == 4.0


@pytest.mark.parametrize(("contact", "friction", "dt"), [(1e5, 0.0, 2e-3), (1e3, 1.0, 5e-3), (1e3, 1.0, 2e-3)])
def test_what_lets_go_within_the_first_exponential_step_is_told(
    model_of: Build, contact: float, friction: float, dt: float
) -> None:
    """Two rods: the second one starts on an elastic stop, or the first one begins to slide; against steps of 20 us.

    Longer steps passed it by as those of the run do, and told 2e-4 of 1e-2.
    """
    builder = Scene("release").gravity(0, -9.81)
    for name, mass, inertia, centre, tip in (("a", 1.0, 0.05, 0.3, 0.6), ("c", 0.6, 0.03, 0.25, 0.5)):
        markers = {"tip": {"position": (tip, 0)}}
        builder.rigid(name, mass=mass, inertia=inertia, center_of_mass=(centre, 0), markers=markers)
        builder.measure(f"r{name}", "coordinate", f"{name}.theta")
    builder.revolute("h", "ground.origin", "a.origin", damping=0.01).revolute("g", "a.tip", "c.origin", damping=0.01)
    builder.torque("friction", "a.origin", f"-{friction}*tanh(ra_dot/0.002)")
    builder.torque("contact", "c.origin", f"{contact}*max(0, -1.2 - rc)")
    builder.initial({"a.theta": -0.9, "c.theta": -1.25}).rates({"a.theta": 0.01, "c.theta": -2.0})
    model = model_of(builder.build())
    fine = simulate(model, scheme="rk4", dt=2e-5, t_end=1.0, samples=100, error="off")
    run = simulate(model, scheme="exponential", dt=dt, t_end=1.0, samples=100)
    names = ("a.theta", "c.theta")
    off = max(float(np.sqrt(np.mean((run[name] - fine[name]) ** 2)) / np.std(fine[name])) for name in names)
    assert run.status.name == "completed" and off / WITHIN < run.error.largest < off * WITHIN
