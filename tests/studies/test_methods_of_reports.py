"""Which methods a report compares, with which ratios of steps, and how it draws them."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from runtime import SCHEMES, Model, simulate
from runtime.running.method_choice import Method
from runtime.running.problem import Problem
from runtime.studies.advice.methods import always_reported, candidates
from runtime.studies.advice.report import as_markdown, report
from runtime.studies.advice.spectrum import StepRatios, group_frequencies, moving_rates, step_ratios
from runtime.views.method_styles import method_styles
from runtime.views.plots import difference, work_precision
from symgen.scene import Scene
from symgen.scenes import SCENES

Load = Callable[[str], Model]


def oscillators(k_L: float = 1.0, w: float = 20.0) -> Problem:
    model = SCENES["two_oscillators"]().model()
    given = {"c": 0.5, "w": w, "k_L": k_L, "zeta": 0.0}
    return Problem.of(model, 20.0, given, {"x_L": 1.0, "x_S": 0.0})


@pytest.mark.parametrize("w", [3.0, 8.0, 20.0])
def test_ratios_are_those_of_the_frequencies(w: float) -> None:
    """M = [[1, c], [c, 1]], K = diag(k, w^2): x_L alone, x_S given, has k / (1 - c^2); both together by hand."""
    problem, c = oscillators(w=w), 0.5
    sum_, product = (1 + w**2) / (1 - c**2), w**2 / (1 - c**2)  # of the squares of both frequencies
    fastest = np.sqrt(sum_ / 2 + np.sqrt(sum_**2 / 4 - product))
    found = group_frequencies(problem, [[0], [1]])
    assert found == pytest.approx([np.sqrt(1 / (1 - c**2)), fastest], rel=1e-9)
    assert step_ratios(problem).groups == (min(20, int(fastest / np.sqrt(1 / (1 - c**2)))),)


def test_what_nothing_holds_needs_steps_by_how_it_moves() -> None:
    """x_L without a spring has no frequency of its own: what counts is RMS of its rate over RMS about its mean."""
    problem = oscillators(k_L=0.0)
    assert group_frequencies(problem, [[0], [1]])[0] == 0.0  # type: ignore[index]
    forced = Problem.of(problem.model, 20.0, {"c": 0.0, "w": 40.0, "k_L": 0.0}, {"x_L": 0.0, "x_S": 0.1})
    run = simulate(problem.model, scheme="rk4", dt=5e-3, t_end=20.0, error="off", seen_every=0.0)
    q, q_dot = np.zeros_like(run.q), np.zeros_like(run.q)
    place = problem.model.coordinates.index("x_L")
    q[:, place], q_dot[:, place] = np.sin(4 * np.pi * run.t), 4 * np.pi * np.cos(4 * np.pi * run.t)
    found = group_frequencies(forced, [[0], [1]], run.but(q=q, q_dot=q_dot))
    assert found == pytest.approx([4 * np.pi, 40.0], rel=1e-3)


def test_an_angle_needs_steps_by_its_rate() -> None:
    """A wheel that turns evenly by 30 rad/s: forces go with its angle, though nothing vibrates."""
    wheel = Scene("wheel").rigid("disc", mass=1.0, inertia=0.1).revolute("axle", "ground.origin", "disc.origin")
    model = wheel.rates({"disc.theta": 30.0}).simulation(scheme="rk4", dt=1e-2, t_end=10.0).model()
    run = model.simulate(seen_every=0.0, error="off")
    assert moving_rates(Problem.of(model), run) == pytest.approx([30.0])


def test_advice_tries_these_ratios(built_in: Load) -> None:
    model = built_in("flexible_slider_crank")
    ratios = step_ratios(Problem.of(model))
    assert ratios.groups == (4,)  # 22,606 rad/s over 5,106 of the bending that is stepped slowly
    labels = [one.label for one in candidates(model, ratios)]
    assert {"exponential m=1", "exponential m=2", "exponential m=4", "coupled m=2", "coupled m=4"} <= set(labels)
    assert [one.label for one in always_reported(model, ratios)] == ["printed m=4", "printed m=2", "single_rate"]
    one_group = built_in("double_pendulum")
    assert [one.scheme for one in always_reported(one_group, step_ratios(Problem.of(one_group)))] == [
        "printed",
        "single_rate",
    ]


@pytest.mark.long
@pytest.mark.parametrize("name", ["two_oscillators", "pendulum"])
def test_a_report_always_has_the_papers_method_and_single_rate(built_in: Load, name: str, tmp_path: Path) -> None:
    found = report(built_in(name), tmp_path, t_end=1.0)
    page = as_markdown(found)
    for scheme in ("printed", "single_rate"):
        own = [trial for one in found.candidates if one.method.scheme == scheme for trial in one.trials]
        assert any(np.isfinite(trial.error) for trial in own), scheme
        assert f"| {scheme}" in page


def drawn(methods: list[Method]) -> dict[str, tuple[str, str, str]]:
    figure = work_precision("t", [(one, np.array([[1.0, 1.0], [2.0, 0.1]])) for one in methods], 1e-3, "operations")
    lines = [line for line in figure.axes[0].lines if line.get_label() != "tolerance"]
    return {
        str(line.get_label()): (str(line.get_color()), str(line.get_marker()), str(line.get_fillstyle()))
        for line in lines
    }


@pytest.mark.parametrize("name", sorted(SCENES))
def test_each_method_has_a_colour_and_a_marker_of_its_own(built_in: Load, name: str) -> None:
    model = built_in(name)
    ratios = StepRatios((20,) * (len(model.groups) - 1), 8)
    methods = [*candidates(model, ratios), *always_reported(model, ratios), Method("dopri5")]
    found = drawn(methods)
    assert len(found) == len(methods)
    assert len({colour for colour, _, _ in found.values()}) == len(methods)
    assert len({(marker, fill) for _, marker, fill in found.values()}) == len(methods)


def test_the_colour_of_a_method_does_not_hang_on_what_stands_beside_it() -> None:
    methods = [Method(name) for name in SCHEMES]
    together = drawn(methods[::-1])
    assert all(drawn([one])[one.label] == together[one.label] for one in methods)
    some = [Method("exponential", (m,)) for m in (4, 1, 2)]
    assert method_styles(some) == method_styles(sorted(some, key=lambda one: one.label))


def test_a_method_that_is_lost_is_named_as_lost() -> None:
    lost = [(Method("printed", (4,)), np.array([[1.0, np.inf]])), (Method("rk4"), np.array([[1.0, 0.1]]))]
    figure = work_precision("t", lost, 1e-3, "operations")
    assert [one.get_label() for one in figure.axes[0].lines[:2]] == ["printed m=4 (lost)", "rk4"]


def test_runs_over_each_other_have_the_colours_of_their_methods(built_in: Load) -> None:
    model = built_in("pendulum")
    runs = [model.simulate(scheme=name, dt=1e-3, t_end=0.1, error="off") for name in ("rk4", "single_rate")]
    styles = drawn([Method("rk4"), Method("single_rate")])
    lines = difference(*runs).axes[0].lines
    assert [line.get_color() for line in lines] == [styles[name][0] for name in ("rk4", "single_rate")]
