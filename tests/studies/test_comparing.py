"""Advice, `auto`, and the reference of benchmarks: what they measure, what they write, and what they refuse."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from benchmarks.scenes.arm import arm
from runtime import Model, ModelError, SchemeError, simulate
from runtime.results.motion_error import amplitudes
from runtime.running.method_choice import Method, affordable
from runtime.running.singular.crossing import MOST_CROSSING_EVALUATIONS, BranchLost, TightIntegrator
from runtime.running.step_refinement import StepRefinement
from runtime.studies.advice import methods
from runtime.studies.advice.advice_text import advice_data, advice_lines, advised_command
from runtime.studies.advice.advise import Advice, NoAdvice, advise
from runtime.studies.advice.methods import candidates, left_out
from runtime.studies.advice.reference import NoReference, Reference, independent_reference
from runtime.studies.advice.spectrum import StepRatios
from runtime.studies.advice.trial import seconds_of, trial_of
from symgen.generate import model_of as derived
from symgen.scene import SceneRecord

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
    refinement = StepRefinement(reference.problem, 1e-3)
    made = trial_of("rk4", refinement.level(refinement.plan(Method("rk4"), 160), None), reference)
    how = {"scheme": "rk4", "dt": T_END / 160, "seen_every": 0.0}
    run = simulate(reference.problem.model, t_end=T_END, parameters=PLAIN, initial=START, **how)
    truth = exact(run.t)[:, 0]
    wanted = np.sqrt(np.mean((run["x_L"] - truth) ** 2)) / exact(np.linspace(0, T_END, 2001))[:, 0].std()
    assert made.error == pytest.approx(wanted, rel=0.02)
    assert made.evaluations == 640 and made.steps == 160


def test_unstable_runs_are_failures(reference: Reference) -> None:
    refinement = StepRefinement(reference.problem, 1e-3)
    made = trial_of("single_rate", refinement.level(refinement.plan(Method("single_rate"), 20), None), reference)
    assert made.failure and not made.error < 1


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
    assert advice.best.operations == min(one.operations for one in advice.candidates) and advice.gain >= 1


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


def test_unknown_grades_are_named(oscillators: Model) -> None:
    for ask in (independent_reference, advise):
        with pytest.raises(ModelError, match="'nothing' cannot be graded"):
            ask(oscillators, graded=["nothing"])


def test_no_advice_says_what_was_tried(oscillators: Model, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("runtime.studies.advice.advise.candidates", lambda model, ratios: [Method("printed", (4,))])
    monkeypatch.setattr("runtime.running.step_refinement.MOST_OPERATIONS_OF_LEVELS", 1e3)
    with pytest.raises(NoAdvice, match=r"printed m=4"):
        advise(oscillators, t_end=1.0, parameters=PLAIN, initial=START, tolerance=1e-9)


def test_a_motion_without_reference_is_said_so(oscillators: Model) -> None:
    """A spring of negative stiffness: the motion leaves the range of floating point numbers."""
    given = {"t_end": T_END, "parameters": {**PLAIN, "k_L": -1e6}, "initial": START}
    with pytest.raises(NoReference, match="the reference stopped at"):
        independent_reference(oscillators, **given)
    with pytest.raises(NoAdvice):
        advise(oscillators, **given)


def test_dense_methods_are_left_out_for_large_models(built_in: Load, monkeypatch: pytest.MonkeyPatch) -> None:
    """Those that are not tried are named."""
    small, model = built_in("flexible_slider_crank_free"), derived(arm(20))
    ratios = StepRatios((10,), 4)
    labels = {one.label for one in candidates(small, ratios)}
    assert {"exponential m=1", "exponential m=2 order=5", "coupled m=5", "radau eps=1e-06"} <= labels
    assert {"exponential_rk4", "exponential m=1", "radau eps=1e-06"} <= {one.label for one in candidates(model, ratios)}
    assert "beside exponential, radau" in left_out(model)
    assert left_out(built_in("pendulum")) == ""
    monkeypatch.setattr(methods, "affordable", lambda model: False)
    assert "exponential, radau and other dense methods, 0.1 million operations a step" in left_out(model)
    assert "radau eps=1e-06" not in {one.label for one in candidates(model, ratios)}


def test_levels_of_advice_fall_as_the_order_says(oscillators: Model, tmp_path: Path) -> None:
    """On two oscillators without damping the last levels of rk4 are of order 4, of central difference of order 2."""
    found = advise(oscillators, t_end=T_END, parameters=PLAIN, initial=START, tolerance=1e-8)
    levels = {one.method.scheme: one.levels[-2:] for one in found.candidates}
    for scheme, order in (("rk4", 4), ("single_rate", 2)):
        (work, finer), (error, less) = np.log(levels[scheme].T)
        assert (error - less) / (finer - work) == pytest.approx(order, abs=0.2)
    found.picture(tmp_path / "advice.png")
    assert (tmp_path / "advice.png").stat().st_size > 10_000


def test_a_clock_that_misses_most_of_a_call_is_not_believed(
    reference: Reference, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Calls of 2 ms of which it sees 1 us in one, as clocks of CPU time may where others run: 2 ms."""
    refinement = StepRefinement(reference.problem, 1e-3)
    level, seen, asked = refinement.level(refinement.plan(Method("rk4"), 400), None), 0.0, 0

    def clock() -> float:
        nonlocal seen, asked
        asked += 1
        if asked % 2 == 0:  # behind a call
            seen += 1e-6 if asked == 8 else 2e-3
        return seen

    monkeypatch.setattr("runtime.studies.advice.trial.time.process_time", clock)
    assert seconds_of(level) == pytest.approx(2e-3)
    assert asked > 8


Build = Callable[[SceneRecord], Model]


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
    for _ in range(MOST_CROSSING_EVALUATIONS):
        integrator.slope(0.0, y)
    with pytest.raises(BranchLost, match="without end"):
        integrator.slope(0.0, y)
