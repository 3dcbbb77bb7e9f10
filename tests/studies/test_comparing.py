"""Comparisons, advice and `auto`: what they measure, what they write, and what they refuse."""

from __future__ import annotations

import csv
import json
import math
import re
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from runtime import Model, SchemeError, simulate
from runtime.contract.errors import ModelError
from runtime.results.motion_error import amplitudes
from runtime.running.ladder import Ladder, Method, affordable
from runtime.running.problem import Problem
from runtime.running.singular.crossing import MOST_EVALUATIONS, BranchLost, TightIntegrator
from runtime.studies.advice.advise import Advice, NoAdvice, advice_data, advice_lines, advise, advised_command
from runtime.studies.stability.chart import USUAL_RATIOS, stability_chart
from runtime.studies.work_precision import methods, trial
from runtime.studies.work_precision.comparison import Comparison, WorkCurve, energy_drift, order_of, work_precision
from runtime.studies.work_precision.comparison_files import comparison_data, write_comparison
from runtime.studies.work_precision.comparison_page import comparison_page
from runtime.studies.work_precision.methods import candidates, left_out, methods_named, usual_adaptive, usual_methods
from runtime.studies.work_precision.reference import NoReference, Reference, independent_reference
from runtime.studies.work_precision.suite import SuiteResult, write_suite
from runtime.studies.work_precision.trial import Trial, seconds_of, trial_of
from symgen.generate import model_of as derived
from symgen.scene import Scene, SceneRecord
from symgen.scenes.arm import arm

pytestmark = pytest.mark.long

Load = Callable[[str], Model]
T_END = 4.0
PLAIN = {"c": 0.5, "w": 20.0, "k_L": 1.0, "zeta": 0.0}
START = {"x_L": 1.0, "x_S": 0.0}


@pytest.fixture(scope="module")
def oscillators() -> Model:
    from runtime import load_model
    from symgen.scenes import generated_folder

    return load_model(generated_folder("two_oscillators"))


@pytest.fixture(scope="module")
def reference(oscillators: Model) -> Reference:
    return independent_reference(oscillators, t_end=T_END, parameters=PLAIN, initial=START, graded=["x_L"])


@pytest.fixture(scope="module")
def advice(oscillators: Model) -> Advice:
    return advise(oscillators, t_end=T_END, parameters=PLAIN, initial=START, graded=["x_L"])


@pytest.fixture(scope="module")
def comparison(oscillators: Model) -> Comparison:
    named = methods_named(oscillators, ["exponential:2", "rk4", "printed:4", "cvodes_bdf"])
    return work_precision(oscillators, named, longest=0.01, t_end=T_END, parameters=PLAIN, initial=START)


def exact(t: np.ndarray) -> np.ndarray:
    """x_L and x_S of M = [[1, c], [c, 1]], K = diag(k_L, w^2) from its eigenvectors, released from START."""
    M, K = np.array([[1, 0.5], [0.5, 1]]), np.diag([1.0, 400.0])
    values, vectors = np.linalg.eig(np.linalg.solve(M, K))
    share = np.linalg.solve(vectors, np.array([1.0, 0.0]))
    return np.asarray((vectors * share) @ np.cos(np.sqrt(values)[:, None] * t[None, :])).T


def test_the_reference_is_the_exact_motion(reference: Reference) -> None:
    times = np.linspace(0, T_END, 57)
    assert np.abs(reference.path(times) - exact(times)).max() < 1e-9
    assert reference.off < 1e-7


def test_errors_are_those_of_the_exact_motion(reference: Reference) -> None:
    """RMS over the motion relative to the amplitude about the mean, from an own formula."""
    ladder = Ladder(reference.problem, 1e-3)
    made = trial_of("rk4", ladder.rung(ladder.plan(Method("rk4"), 160)), reference)
    how = {"scheme": "rk4", "dt": T_END / 160, "seen_every": 0.0}
    run = simulate(reference.problem.model, t_end=T_END, parameters=PLAIN, initial=START, **how)
    truth = exact(run.t)[:, 0]
    wanted = np.sqrt(np.mean((run["x_L"] - truth) ** 2)) / exact(np.linspace(0, T_END, 2001))[:, 0].std()
    assert made.error == pytest.approx(wanted, rel=0.02)
    assert made.evaluations == 640 and made.steps == 160


def test_unstable_runs_are_failures(reference: Reference) -> None:
    ladder = Ladder(reference.problem, 1e-3)
    made = trial_of("single_rate", ladder.rung(ladder.plan(Method("single_rate"), 20)), reference)
    assert made.failure and not made.error < 1


def test_time_to_a_tolerance_is_interpolated() -> None:
    """Between (1 s, 1e-2) and (4 s, 1e-4): 1e-3 takes 2 s; a failure before it cannot be interpolated from."""

    def made(seconds: float, error: float, failure: str = "") -> Trial:
        return Trial("x", 1.0, 10, seconds, 100, error, failure=failure)

    curve = WorkCurve("x", None, [made(1.0, 1e-2), made(4.0, 1e-4)], np.nan, None)
    assert curve.seconds_to(1e-3) == pytest.approx(2.0)
    assert curve.seconds_to(1e-5) == np.inf
    failed = WorkCurve("x", None, [made(1.0, np.inf, "not finite"), made(4.0, 1e-4)], np.nan, None)
    assert failed.seconds_to(1e-3) == pytest.approx(4.0)


def test_a_run_as_advised_delivers(advice: Advice, oscillators: Model) -> None:
    """What is graded within the tolerance, the rest as a run needs it to be called accurate."""
    method = advice.method
    run = simulate(
        oscillators,
        scheme=method.scheme,
        m=list(method.m) if method.m else None,
        options=method.options,
        dt=advice.dt,
        seen_every=0.0,
        t_end=T_END,
        parameters=PLAIN,
        initial=START,
    )
    off = np.sqrt(np.mean((run.q - exact(run.t)) ** 2, axis=0)) / amplitudes(oscillators, exact(run.t))
    assert run.status.ok and off[0] < advice.tolerance
    assert advice.best.operations == min(one.operations for one in advice.climbed) and advice.gain >= 1
    assert advice.groups is not None
    assert advice.groups.slow == ["x_L"]
    assert advice.modes[1].highest == pytest.approx(20 / np.sqrt(0.75), rel=0.01)


def test_advice_in_words(advice: Advice) -> None:
    text = "\n".join(advice_lines(advice))
    assert advice.method.scheme in text and "x_L" in text
    assert advised_command(advice).startswith("symgen simulate two_oscillators --scheme ")
    assert f"--scheme auto --tolerance {advice.tolerance:g}" in text
    json.dumps(advice_data(advice), allow_nan=False)


def test_auto_keeps_a_tolerance(oscillators: Model) -> None:
    run = simulate(oscillators, t_end=T_END, parameters=PLAIN, initial=START, scheme="auto", tolerance=1e-4)
    assert run.status.ok and run.t[-1] == pytest.approx(T_END)
    error = np.sqrt(np.mean((run["x_L"] - exact(run.t)[:, 0]) ** 2)) / 0.5
    assert error < 1e-4
    assert "advice" not in run.stats


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"options": {"m": 2}}, "auto chooses m and"),
        ({"m": [2]}, "auto chooses"),
        ({"tolerance": 0.0}, "tolerance must"),
    ],
)
def test_auto_refuses_what_it_cannot_use(oscillators: Model, arguments: dict, message: str) -> None:
    with pytest.raises(SchemeError, match=message):
        simulate(oscillators, t_end=T_END, scheme="auto", **arguments)


def test_unknown_grades_and_methods_are_named(oscillators: Model) -> None:
    for ask in (independent_reference, advise):
        with pytest.raises(ModelError, match="'nothing' cannot be graded"):
            ask(oscillators, graded=["nothing"])
    with pytest.raises(SchemeError, match="no method 'leapfrog'"):
        methods_named(oscillators, ["leapfrog"])
    with pytest.raises(SchemeError, match="whole numbers"):
        methods_named(oscillators, ["coupled:many"])


def test_no_advice_says_what_was_tried(oscillators: Model, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("runtime.studies.advice.advise.candidates", lambda model: [Method("printed", (4,))])
    monkeypatch.setattr("runtime.running.ladder.MOST_OPERATIONS", 1e3)
    with pytest.raises(NoAdvice, match=r"printed m=4"):
        advise(oscillators, t_end=1.0, parameters=PLAIN, initial=START, tolerance=1e-9)


def test_a_motion_without_reference_is_said_so(oscillators: Model) -> None:
    """A spring of negative stiffness: the motion leaves the range of floating point numbers."""
    given = {"t_end": T_END, "parameters": {**PLAIN, "k_L": -1e6}, "initial": START}
    with pytest.raises(NoReference, match="the reference stopped at"):
        independent_reference(oscillators, **given)
    with pytest.raises(NoAdvice):
        advise(oscillators, **given)


def test_comparison_shows_order_failures_and_a_reason(comparison: Comparison) -> None:
    by_name = {curve.label: curve for curve in comparison.curves}
    assert by_name["rk4"].order == pytest.approx(4.0, abs=0.4)
    assert by_name["CVODES BDF"].seconds_to(1e-2) < np.inf
    assert by_name["exponential m=2"].energy is not None
    assert comparison.recommendation().startswith(comparison.ranked()[0].method.label)


def test_comparison_files_agree_with_each_other(comparison: Comparison, tmp_path: Path) -> None:
    files = write_comparison(comparison, tmp_path)
    data = json.loads(Path(files["comparison.json"]).read_text())
    assert data["recommendation"] == comparison.recommendation()
    with Path(files["comparison.csv"]).open() as lines:
        rows = list(csv.DictReader(lines))
    assert len(rows) == sum(len(curve.trials) for curve in comparison.curves)
    page = Path(files["comparison.html"]).read_text()
    assert not re.search(r'(src|href)="(?!data:)', page)  # opens without a network
    for curve in comparison.curves:
        assert curve.label in page
        assert curve.label in Path(files["comparison.md"]).read_text()


def test_suite_page_lists_every_case(comparison: Comparison, advice: Advice, tmp_path: Path) -> None:
    results = [SuiteResult("good", comparison, advice), SuiteResult("bad", None, None, "no reference")]
    files = write_suite(results, tmp_path)
    text = Path(files["suite.md"]).read_text()
    assert "| good |" in text and "| bad | no reference |" in text
    assert results[0].advised_over_best() > 0


def test_usual_methods_leave_dense_ones_out_for_large_models(built_in: Load, monkeypatch: pytest.MonkeyPatch) -> None:
    """In reports and in advice alike; those that are not tried are named with the command that tries them."""
    small, model = built_in("flexible_slider_crank_free"), derived(arm(20))
    labels = {one.label for one in usual_methods(small)}
    assert {"exponential m=1", "coupled m=4", "radau eps=1e-06"} <= labels and "IDAS" in usual_adaptive(small)
    assert methods_named(small, ["compiled"]) == usual_methods(small)
    dense = {"exponential_rk4", "exponential m=1", "radau eps=1e-06"}
    assert dense <= {one.label for one in usual_methods(model)} and {"CVODES BDF", "IDAS"} <= {*usual_adaptive(model)}
    assert dense <= {one.label for one in candidates(model)}
    assert "beside exponential, radau" in left_out(model) and "--methods" in left_out(model)
    assert left_out(built_in("pendulum")) == ""
    monkeypatch.setattr(methods, "affordable", lambda model: False)
    assert "exponential, radau and other dense methods, 0.1 million operations a step" in left_out(model)
    assert "radau eps=1e-06" not in {one.label for one in candidates(model)}
    assert "IDAS" not in usual_adaptive(model)


def test_a_clock_that_misses_most_of_a_call_is_not_believed(
    reference: Reference, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Calls of 2 ms of which it sees 1 us in one, as clocks of CPU time may where others run: 2 ms."""
    ladder = Ladder(reference.problem, 1e-3)
    rung, seen, asked = ladder.rung(ladder.plan(Method("rk4"), 400)), 0.0, 0

    def clock() -> float:
        nonlocal seen, asked
        asked += 1
        if asked % 2 == 0:  # behind a call
            seen += 1e-6 if asked == 8 else 2e-3
        return seen

    monkeypatch.setattr(trial.time, "process_time", clock)
    assert seconds_of(rung) == pytest.approx(2e-3)
    assert asked > 8


Build = Callable[[SceneRecord], Model]


def test_what_is_not_as_the_scene_has_it_stands_on_the_page_of_a_comparison(built_in: Load) -> None:
    problem = Problem.of(built_in("two_oscillators"), 1.0, {"M[0,0]": 2.5, "w": 30.0})
    reference = Reference(problem, lambda t: np.ones((len(t), 2)), ["x_L", "x_S"])
    found = Comparison(reference, 1e-3, [WorkCurve("rk4", Method("rk4"), [], 4.0, None)])
    page = comparison_page(found, comparison_data(found))
    assert "w = 30 rad/s" in page and "M[0,0] = 2.5 kg" in page and "M[1,1] =" not in page


def test_the_order_of_a_method_takes_a_decade_of_errors() -> None:
    """Errors 2 dt^2 down to a twelfth of the first: order 2. Down to a ninth: none."""
    for steps, order in (((0.1, 0.05, 0.1 / math.sqrt(12)), 2.0), ((0.1, 0.05, 0.1 / 3), np.nan)):
        errors = [(dt, 2 * dt * dt) for dt in steps] + [(1e-5, 1e-8)]
        trials = [Trial("x", dt, 10, 1.0, 10, error) for dt, error in errors]
        assert order_of(trials) == pytest.approx(order, nan_ok=True)


def test_what_rests_has_no_drift_of_energy(model_of: Build) -> None:
    builder = Scene("rest").rigid("m", mass=1.0, inertia=1.0, free=True).simulation(t_end=1.0, dt=0.1, scheme="printed")
    ladder = Ladder(Problem.of(model_of(builder.build())), 1e-3)
    assert energy_drift(ladder.rung(ladder.plan(Method("rk4"), 20))) is None


@pytest.mark.parametrize("n, dense", [(32, True), (33, False)])
def test_methods_with_dense_systems_are_tried_up_to_their_price(n: int, dense: bool) -> None:
    """12 n^3 operations: 393,216 for 32 coordinates, 431,244 for 33, where 400,000 are too many."""
    model: Any = SimpleNamespace(q_i=[f"x{k}" for k in range(n)])
    assert affordable(model) == dense


def test_a_question_may_take_so_many_evaluations_and_no_more(built_in: Load) -> None:
    model = built_in("slider_crank")
    p = model.parameter_vector()
    integrator = TightIntegrator(model, p, model.constants(p))
    y = integrator.pack(model.initial_q, model.initial_q_dot)
    for _ in range(MOST_EVALUATIONS):
        integrator.slope(0.0, y)
    with pytest.raises(BranchLost, match="without end"):
        integrator.slope(0.0, y)


def test_usual_ratios_of_three_groups_sub_cycle_the_last(model_of: Build) -> None:
    builder = Scene("three").structure(
        coordinates=["a", "b", "c"], mass=np.eye(3), stiffness=np.diag([1.0, 9.0, 100.0])
    )
    builder.groups(A=["a"], B=["b"], C=["c"]).initial({"a": 1.0}).simulation(
        t_end=0.2, dt=0.1, m=[1, 2], scheme="printed"
    )
    chart = stability_chart(model_of(builder.build()), "coupled", points=2, states=1, dt_range=(1e-3, 2e-3))
    assert [curve.m for curve in chart.curves] == [[1, ratio] for ratio in USUAL_RATIOS]
