"""Faults put into the runtime at random that nothing else saw: one law or hand figure each."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from runtime import Model, ModelError, simulate
from runtime.contract.coordinates import mechanism_length
from runtime.contract.files import write_text
from runtime.operating.given_state import given_state
from runtime.operating.linearise import linearise
from runtime.running.ladder import Ladder, Method, affordable
from runtime.running.problem import Problem
from runtime.running.singular.crossing import MOST_EVALUATIONS, BranchLost, TightIntegrator
from runtime.schemes.baselines.radau import lagrange
from runtime.studies.stability.chart import USUAL_RATIOS, stability_chart
from runtime.studies.work_precision.comparison import Comparison, WorkCurve, energy_drift, order_of
from runtime.studies.work_precision.comparison_files import comparison_data
from runtime.studies.work_precision.comparison_page import comparison_page
from runtime.studies.work_precision.reference import Reference
from runtime.studies.work_precision.trial import Trial
from symgen.scene import Scene, SceneRecord

Build = Callable[[SceneRecord], Model]
Load = Callable[[str], Model]


def test_a_rate_of_what_depends_takes_the_place_of_the_rates_of_the_scene(model_of: Build) -> None:
    """Bars of 1 m at 0.3 and 0.8 rad: x' = -sin(0.3) w of the hinge gives w; the other rate is left open: none."""
    builder = Scene("two")
    for name in ("upper", "lower"):
        builder.rigid(name, mass=1.0, inertia=0.1, markers={"tip": {"position": (1.0, 0.0)}})
    builder.revolute("a", "ground.origin", "upper.origin").revolute("b", "upper.tip", "lower.origin")
    builder.initial({"upper.theta": 0.3, "lower.theta": 0.8}).rates({"upper.theta": 1.0, "lower.theta": 2.0})
    model = model_of(builder.simulation(t_end=0.1, dt=0.01, scheme="printed").build())
    p = model.parameter_vector()
    found = given_state(model, p, model.constants(p), 0.0, {"lower.x_dot": -0.5})
    rate = dict(zip(model.coordinates, found.q_dot, strict=True))
    assert rate["lower.x"] == pytest.approx(-0.5, abs=1e-14)
    assert rate["upper.theta"] == pytest.approx(0.5 / math.sin(0.3)) and abs(rate["lower.theta"]) < 1e-14


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


def test_stages_are_continued_by_their_polynomial() -> None:
    """Four nodes take cubics over exactly, at nodes and beyond."""
    nodes, at = np.array([0.0, 0.2, 0.7, 1.0]), np.array([0.2, 1.3, 1.9])
    assert lagrange(nodes, at) @ (1 - nodes**2 + 2 * nodes**3) == pytest.approx(1 - at**2 + 2 * at**3)


def test_files_are_read_by_all_and_written_by_their_owner(tmp_path: Path) -> None:
    write_text(tmp_path / "a.txt", "a")
    assert (tmp_path / "a.txt").stat().st_mode & 0o777 == 0o644


def test_usual_ratios_of_three_groups_sub_cycle_the_last(model_of: Build) -> None:
    builder = Scene("three").structure(
        coordinates=["a", "b", "c"], mass=np.eye(3), stiffness=np.diag([1.0, 9.0, 100.0])
    )
    builder.groups(A=["a"], B=["b"], C=["c"]).initial({"a": 1.0}).simulation(
        t_end=0.2, dt=0.1, m=[1, 2], scheme="printed"
    )
    chart = stability_chart(model_of(builder.build()), "coupled", points=2, states=1, dt_range=(1e-3, 2e-3))
    assert [curve.m for curve in chart.curves] == [[1, ratio] for ratio in USUAL_RATIOS]


@pytest.mark.parametrize("steps, balanced", [(1, False), (2, True)])
def test_the_card_of_a_solution_has_a_balance_from_three_samples_on(built_in: Load, steps: int, balanced: bool) -> None:
    run = simulate(built_in("pendulum"), scheme="rk4", dt=1e-3, t_end=steps * 1e-3, save_every=1, engine="interpreted")
    assert ("energy balance" in run._repr_html_()) == balanced


def test_a_small_jump_of_a_slow_motion_is_a_jump(model_of: Build) -> None:
    """Of some 1e-5 rad/s, where no velocity is larger, and no condition says when."""
    builder = Scene("slow").rigid("a", mass=1.0, inertia=0.1).rigid("b", mass=1.0, inertia=0.1)
    builder.revolute("h", "ground.origin", "a.origin").revolute("k", "a.origin", "b.origin")
    builder.prescribed_angle("drive", "ground.origin", "a.origin", motion="1e-5 * sqrt((t - 0.503)**2)")
    model = model_of(builder.simulation(t_end=1.0, dt=0.05, scheme="printed").build())
    with pytest.raises(ModelError, match="velocity jumps"):
        simulate(model, scheme="rk4", engine="interpreted")


def test_rates_have_units_of_rates(built_in: Load) -> None:
    model = built_in("pendulum")
    name = model.q_i[0]
    units = linearise(model, outputs=[name, f"{name}_dot"]).units
    assert units[name] == "rad" and units[f"{name}_dot"] == "rad/s"


def test_a_mechanism_of_micrometres_has_a_length() -> None:
    """Arms of 1e-7 m are its length; 1e-10 m is what rounding leaves of arms that are zero."""
    coordinate, row = SimpleNamespace(turns=True), SimpleNamespace(unit="m")
    model: Any = SimpleNamespace(description=SimpleNamespace(coordinates=[coordinate], constraints=[row]))
    assert mechanism_length(model, np.array([[-1e-7]])) == 1e-7
    assert mechanism_length(model, np.array([[1e-10]])) == 1.0
