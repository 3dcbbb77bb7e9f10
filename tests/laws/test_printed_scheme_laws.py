"""The paper's scheme as printed: m = 1, starting guesses, amplification matrix and growth on L1, nested groups."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from runtime import simulate
from runtime.contract.coordinates import independent
from runtime.engine.interpreted import program_function
from runtime.model import Model
from runtime.running.planning import make_plan
from runtime.schemes.stepper import Stepper
from symgen.scene import Scene, SceneRecord
from symgen.scenes import SCENES
from tests.hand_derived.twin_oscillators import Params, growth_rate_law, printed_subcycling_matrix
from tests.support.model_values import evaluate, make_state

Load = Callable[[str], Model]
Build = Callable[[SceneRecord], Model]
# steps and dt of runs of the two-group scenes; hub_beam needs 130 sweeps a step (strong inertia coupling)
RUNS = {
    "flexible_slider_crank": (100, 2e-5),
    "flexible_slider_crank_free": (100, 2e-5),
    "flexible_slider_crank_torque": (100, 1e-4),
    "hub_beam": (50, 1e-3),
    "two_oscillators": (100, 1e-2),
}

COARSE = ("flexible_slider_crank_torque",)  # runs say that their error passes a tenth of an amplitude

# tolerances of the sweep just above the rounding of h^2 q_ddot in each scene: h^2 q_ddot is about 1e-2 on L1
TIGHT: dict[str, Any] = {"eps": (1e-20,), "stopping": "absolute"}
TIGHT_L1: dict[str, Any] = {"eps": (1e-17,), "stopping": "absolute"}


def tight(name: str) -> dict[str, Any]:
    return TIGHT_L1 if name == "two_oscillators" else TIGHT


def trajectory(model: Model, steps: int, dt: float, **given: Any) -> Any:
    solution = simulate(model, t_end=steps * dt, dt=dt, seen_every=10 * dt, **given)
    assert solution.status.ok or (model.name in COARSE and solution.status.whole), solution.status
    return solution.q


@pytest.mark.every_push("two_oscillators", "flexible_slider_crank")
@pytest.mark.parametrize("name", RUNS)
def test_one_sub_step_is_single_rate(built_in: Load, name: str) -> None:
    """To rounding, where both iterations are converged; with one Newton iteration (default) to 1e-7."""
    model, (steps, dt) = built_in(name), RUNS[name]
    printed = trajectory(model, steps, dt, scheme="printed", m=[1], options=tight(name))
    converged = trajectory(model, steps, dt, scheme="single_rate", options={"newton_iterations": 3})
    np.testing.assert_allclose(printed, converged, rtol=0, atol=1e-11 * np.max(np.abs(converged)))
    single = trajectory(model, steps, dt, scheme="single_rate")
    np.testing.assert_allclose(single, converged, rtol=0, atol=1e-7 * np.max(np.abs(converged)))


@pytest.mark.every_push("two_oscillators", "3-flexible_slider_crank")
@pytest.mark.parametrize("name", RUNS)
@pytest.mark.parametrize("m", [1, 3])
def test_starting_guesses_lead_to_the_same_step(built_in: Load, name: str, m: int) -> None:
    model, (steps, dt) = built_in(name), RUNS[name]
    taylor, previous = (
        trajectory(model, steps, dt, scheme="printed", m=[m], options={**tight(name), "guess": guess})
        for guess in ("taylor", "previous")
    )
    np.testing.assert_allclose(previous, taylor, rtol=0, atol=1e-10 * np.max(np.abs(taylor)))


@pytest.mark.every_push("two_oscillators", "flexible_slider_crank")
@pytest.mark.parametrize("name", RUNS)
def test_the_sweep_solves_the_coupled_equations(built_in: Load, name: str) -> None:
    """The fixed point of (52)-(53) is the direct solution of (39), also with sub-steps."""
    model, (steps, dt) = built_in(name), RUNS[name]
    sweep = trajectory(model, steps, dt, scheme="printed", m=[2], options=tight(name))
    direct = trajectory(
        model, steps, dt, scheme="printed", m=[2], options={"common_update": "direct", "newton_iterations": 3}
    )
    np.testing.assert_allclose(sweep, direct, rtol=0, atol=1e-10 * np.max(np.abs(direct)))


@pytest.mark.parametrize("name", ["flexible_slider_crank_free", "flexible_slider_crank_torque"])
def test_what_a_sweep_leaves(built_in: Load, name: str) -> None:
    """A sweep leaves the spectral radius of D^-1 (M_hat - D - h/2 J) of its error, D the blocks of the groups in M_hat,
    J = dQ_hat/dq_i_dot: close to one where inertia couples the groups closely, and then whatever the step."""
    model, dt = built_in(name), RUNS[name][1]
    state = make_state(model, *independent(model, model.initial_q, model.initial_q_dot)[:2])
    M_hat = evaluate(model, "condensed", **state.values())["M_hat"]
    group = np.empty(len(M_hat), dtype=int)
    for g, one in enumerate(model.groups):
        group[list(one.positions)] = g
    D = np.where(group[:, None] == group[None, :], M_hat, 0.0)
    J = evaluate(model, "dQ_hat_dq_i_dot", **state.values())["dQ_hat_dq_i_dot"]
    left = np.abs(np.linalg.eigvals(np.linalg.solve(D, M_hat - D - dt / 2 * J))).max()

    def change(sweeps: int) -> float:
        plan = make_plan(
            model, dt, dt, [1], "printed", 1, {"max_iterations": sweeps, "eps": 1e-16, "guess": "previous"}, 0.0
        )
        start = Stepper(plan.scheme, "interpreted")
        c = model.constants(model.parameter_vector())
        z = start.start(0.0, model.initial_q, model.initial_q_dot, c, dt)
        start.run(z, start.ready(c, dt), 1)
        return float(z[plan.scheme.layout.slice("change")].max())

    assert 0.3 < left < 1 and (change(30) / change(20)) ** 0.1 == pytest.approx(left, rel=0.01)


def amplification(model: Model, params: Params, dt_S: float, m: int, **options: Any) -> Any:
    """Matrix of one major step on (q_L(t - dt_L), q_L, q_S(t - dt_S), q_S): the program applied to unit states."""
    plan = make_plan(model, 1.0, dt_S * m, [m], "printed", 1, options, 0.0)
    layout = plan.scheme.layout
    step = program_function(plan.scheme.program(), layout.size, plan.scheme.c_size)
    values = {"c": params.c, "w": params.w, "k_L": params.k_L, "zeta": params.zeta}
    c = plan.scheme.constants(model.constants(model.parameter_vector(values)))
    columns = []
    for L_before, L, S_before, S in np.eye(4):
        z = np.zeros(layout.size)
        z[layout.slice("x")], z[layout.slice("d")] = (L, S), (L - L_before, S - S_before)
        after = np.asarray(step(z, c)).ravel()
        x, d = after[layout.slice("x")], after[layout.slice("d")]
        columns.append([x[0] - d[0], x[0], x[1] - d[1], x[1]])
    return np.array(columns).T


@pytest.mark.parametrize("common_update", ["fixed_point", "direct"])
@pytest.mark.parametrize("zeta", [0.0, 0.05])
@pytest.mark.parametrize("m", [1, 2, 3, 10])
def test_amplification_matrix_of_L1(built_in: Load, m: int, zeta: float, common_update: str) -> None:
    params = Params(c=0.5, w=3.0, k_L=0.7, zeta=zeta)
    matrix = amplification(
        built_in("two_oscillators"),
        params,
        0.01,
        m,
        common_update=common_update,
        eps=(1e-16,),
        stopping="absolute",
        sub_step_velocity="newton",
    )
    np.testing.assert_allclose(matrix, printed_subcycling_matrix(params, 0.01, m), rtol=0, atol=1e-12)


def test_predicted_velocity_differs_from_the_twin_by_its_order(built_in: Load) -> None:
    """The default `predictor` takes q_S_dot with the last acceleration: the difference falls with dt^3."""
    model, params = built_in("two_oscillators"), Params(c=0.5, w=3.0, k_L=0.7, zeta=0.05)
    differences = []
    for dt in (0.01, 0.005):
        matrix = amplification(model, params, dt, 3, common_update="direct")
        # on (position, velocity): unit positions and unit rates instead of unit histories
        to_history = np.array([[1, -3 * dt, 0, 0], [1, 0, 0, 0], [0, 0, 1, -dt], [0, 0, 1, 0]])
        twin = printed_subcycling_matrix(params, dt, 3)
        differences.append(np.max(np.abs((matrix - twin) @ to_history)))
    assert 0 < differences[1] < 0.3 * differences[0]


@pytest.mark.parametrize("c, m", [(0.3, 2), (0.3, 5), (0.6, 2), (0.6, 5)])
def test_growth_of_L1_follows_the_law(built_in: Load, c: float, m: int) -> None:
    """A frozen q_L_ddot feeds energy in: sigma = 1/4 c^2 (1 - 1/m) w_c^2 dt_L, measured over a long run."""
    w, dt = 3.0, 0.01
    s = simulate(
        built_in("two_oscillators"),
        t_end=100.0,
        dt=dt,
        m=[m],
        scheme="printed",
        seen_every=20 * dt,
        engine="compiled",
        parameters={"c": c, "w": w, "k_L": 0.0, "zeta": 0.0},
        initial={"x_L": 0.0, "x_S": 0.1},
    )
    coupled = w / math.sqrt(1 - c * c)
    amplitude = 0.5 * np.log(s["x_S"] ** 2 + (s.rate("x_S") / coupled) ** 2)
    assert np.polyfit(s.t, amplitude, 1)[0] == pytest.approx(growth_rate_law(c, w, m, dt), rel=0.05)


def three_oscillators(c: float, damping: float) -> SceneRecord:
    """Slow, middle and fast, coupled by springs and (c > 0) by inertia."""
    k = 5.0
    builder = Scene("three_oscillators").structure(
        coordinates=["a", "b", "c"],
        mass=[[1, c, c / 2], [c, 1, c], [c / 2, c, 1]],
        stiffness=[[1 + k, -k, 0], [-k, k + 60, -k], [0, -k, 900 + k]],
        damping=np.diag([damping, 2 * damping, 4 * damping]),
    )
    builder.groups(A=["a"], B=["b"], C=["c"]).initial({"a": 1.0, "b": 0.3, "c": 0.05})
    return builder.simulation(t_end=1.0, dt=0.01, m=[1, 1], scheme="printed").build()


@pytest.mark.parametrize("damping", [0.0, 0.3])
def test_three_groups_of_one_sub_step_are_single_rate(model_of: Build, damping: float) -> None:
    model = model_of(three_oscillators(0.3, damping))
    single = trajectory(model, 100, 0.01, scheme="single_rate")
    nested = trajectory(model, 100, 0.01, scheme="printed", m=[1, 1], options=TIGHT_L1)
    np.testing.assert_allclose(nested, single, rtol=0, atol=1e-12)


@pytest.mark.every_push("m1")
@pytest.mark.parametrize("name, m", [("flexible_slider_crank_free", [1, 1]), ("flexible_slider_crank_free", [2, 2])])
def test_three_groups_on_a_mechanism(model_of: Build, name: str, m: list[int]) -> None:
    """Crank, lateral and axial modes as three groups: m = 1 is single-rate, m = 2, 2 stays near it for a while."""
    data = SCENES[name]().model_dump()
    data["partition"]["groups"] = [
        {"name": "crank", "coordinates": ["crank.theta"]},
        {"name": "lateral", "coordinates": ["rod.q1", "rod.q2"]},
        {"name": "axial", "coordinates": ["rod.q3", "rod.q4"]},
    ]
    data["simulation"]["m"] = [1, 1]
    model = model_of(SceneRecord.from_dict(data))
    assert [group.positions for group in model.groups] == [[0], [1, 2], [3, 4]]
    single = trajectory(model, 100, 1e-5, scheme="single_rate", options={"newton_iterations": 3})
    nested = trajectory(model, 100, 1e-5, scheme="printed", m=m, options=TIGHT)
    tolerance = 1e-11 if m == [1, 1] else 2e-3
    np.testing.assert_allclose(nested, single, rtol=0, atol=tolerance * np.max(np.abs(single)))


def three_group_slope(model: Model, **options: Any) -> tuple[float, float]:
    """(slope, error at the finest step) at t = 1 for m = (2, 3)."""
    reference = simulate(model, t_end=1.0, dt=1e-4, scheme="single_rate", samples=1).q[-1]
    steps = np.array([0.01, 0.005, 0.0025])
    errors = [
        np.max(
            np.abs(
                simulate(model, t_end=1.0, dt=dt, m=[2, 3], scheme="printed", samples=1, options=options).q[-1]
                - reference
            )
        )
        for dt in steps
    ]
    return float(np.polyfit(np.log(steps), np.log(errors), 1)[0]), float(errors[-1])


@pytest.mark.every_push("constant_acceleration", "chord-0.3")
@pytest.mark.parametrize("damping", [0.0, 0.3])
@pytest.mark.parametrize("reading", ["end_point_sum", "constant_acceleration", "chord"])
def test_three_groups_without_inertia_coupling_are_second_order(model_of: Build, reading: str, damping: float) -> None:
    slope, error = three_group_slope(model_of(three_oscillators(0.0, damping)), slow_interpolation=reading)
    assert slope == pytest.approx(2.0, abs=0.1)
    assert error < 1.5e-5


def test_equation_13_as_printed_costs_an_order(model_of: Build) -> None:
    """`chord_ahead` weights j/m at time (j - 1) h: one sub-step ahead, first order."""
    slope, _ = three_group_slope(model_of(three_oscillators(0.0, 0.0)), slow_interpolation="chord_ahead")
    assert slope == pytest.approx(1.0, abs=0.1)


@pytest.mark.parametrize("reading", ["end_point_sum", "constant_acceleration", "chord", "chord_ahead"])
def test_three_groups_with_inertia_coupling_are_first_order(model_of: Build, reading: str) -> None:
    """The printed scheme freezes slow accelerations; no reading of the interpolation mends that (theory/schemes.md)."""
    slope, error = three_group_slope(model_of(three_oscillators(0.3, 0.0)), slow_interpolation=reading)
    assert slope == pytest.approx(1.0, abs=0.1)
    assert error < 1.2e-3
