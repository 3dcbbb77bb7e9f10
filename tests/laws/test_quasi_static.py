"""The quasi-static start: elastic coordinates in equilibrium, with little vibration left; where there is none."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from runtime import InitialStateError, equilibrium, simulate
from runtime.model import Model
from runtime.start.start_state import start_state
from symgen.scene import Scene, SceneRecord
from tests.support.model_values import Array, condensed_accelerations, evaluate, make_state
from tests.support.prepared_runs import PreparedRuns

Load = Callable[[str], Model]
FLEXIBLE = (
    "flexible_slider_crank",
    "flexible_slider_crank_free",
    "flexible_slider_crank_torque",
    "physical_slider_crank",
    "stiff_slider_crank",
    "flexible_four_bar",
)


def elastic_accelerations(model: Model, start: str) -> tuple[Array, Array]:
    """(q_e_ddot at the start, that which the stiffness alone would give: M_ee^-1 K q_e)."""
    p = model.parameter_vector()
    state = start_state(model, p, model.constants(p), 0.0, None, start)
    columns = model.independent_columns
    elastic = [k for k, name in enumerate(model.q_i) if name in model.elastic]
    at = make_state(model, state.q[columns], state.q_dot[columns], guess=state.q)
    found = condensed_accelerations(model, at)[columns][elastic]
    n = len(model.q_i)
    M = evaluate(model, "condensed", **at.values())["M_hat"].reshape(n, n)[np.ix_(elastic, elastic)]
    slope = evaluate(model, "dQ_hat_dq_i", **at.values())["dQ_hat_dq_i"].reshape(n, n)[np.ix_(elastic, elastic)]
    return found, np.linalg.solve(M, slope @ at.q_i[elastic])


@pytest.mark.parametrize("name", FLEXIBLE)
def test_elastic_accelerations_vanish(built_in: Load, name: str) -> None:
    """Law: in equilibrium q_e_ddot vanishes against M^-1 K q_e; what is left comes from renewing the rates last."""
    quiet, stiffness = elastic_accelerations(built_in(name), "quasi_static")
    assert np.max(np.abs(stiffness)) > 1.0
    assert np.max(np.abs(quiet)) < 3e-6 * np.max(np.abs(stiffness))


def vibration(model: Model, start: str, t_end: float, dt: float) -> Array:
    """Root mean square of the elastic accelerations over a run of small steps."""
    runs = PreparedRuns(model, "coupled", [1], start=start)
    samples = runs.samples(dt, round(t_end / dt), 5)["a"]
    elastic = [k for k, name in enumerate(model.q_i) if name in model.elastic]
    return np.asarray(np.sqrt(np.mean(samples[:, elastic] ** 2, axis=0)))


@pytest.mark.parametrize(
    "name, t_end, dt", [("flexible_slider_crank_free", 0.01, 1e-5), ("flexible_four_bar", 0.05, 1e-4)]
)
def test_little_vibration_is_left(built_in: Load, name: str, t_end: float, dt: float) -> None:
    """Law: elastic accelerations over a run are far below those after an undeformed start.

    Measured: 0.2 for the first bending mode, mostly its slow motion, and at most 0.04 for the others.
    """
    model = built_in(name)
    given, quiet = (vibration(model, start, t_end, dt) for start in ("given", "quasi_static"))
    share = quiet / given
    assert np.all(given > 50) and share[0] < 0.25 and np.all(share[1:] < 0.05)


@pytest.mark.parametrize("name", ["two_oscillators", "double_pendulum", "slider_crank", "overdamped_joint"])
def test_nothing_elastic_nothing_changes(built_in: Load, name: str) -> None:
    """Law: a model without elastic coordinates starts where it started."""
    model = built_in(name)
    p = model.parameter_vector()
    c = model.constants(p)
    given, quiet = (start_state(model, p, c, 0.0, None, start) for start in ("given", "quasi_static"))
    np.testing.assert_array_equal(quiet.q, given.q)
    np.testing.assert_array_equal(quiet.q_dot, given.q_dot)


@pytest.mark.parametrize("name", ["flexible_slider_crank_free", "flexible_four_bar"])
def test_rigid_coordinates_are_kept(built_in: Load, name: str) -> None:
    """Law: only elastic coordinates move, and those that follow from them."""
    model = built_in(name)
    p = model.parameter_vector()
    c = model.constants(p)
    given, quiet = (start_state(model, p, c, 0.0, None, start) for start in ("given", "quasi_static"))
    for k, coordinate in enumerate(model.coordinates):
        if coordinate in model.q_i and coordinate not in model.elastic:
            assert quiet.q[k] == given.q[k] and quiet.q_dot[k] == given.q_dot[k]
    assert max(abs(quiet.q[k] - given.q[k]) for k in map(model.coordinates.index, model.elastic)) > 1e-6


def test_elastic_rates_follow_the_equilibrium(built_in: Load) -> None:
    """Law: q_e_dot is the derivative of the equilibrium along the rigid motion, to (rigid rate / frequency)^2."""
    model, step = built_in("flexible_slider_crank_free"), 1e-4
    p = model.parameter_vector()
    c = model.constants(p)
    rate = float(model.initial_q_dot[model.coordinates.index("crank.theta")])
    near = [start_state(model, p, c, 0.0, {"crank.theta": 0.5 + turn}, "quasi_static") for turn in (-step, 0.0, step)]
    elastic = [model.coordinates.index(name) for name in model.elastic]
    slope = (near[2].q - near[0].q)[elastic] / (2 * step) * rate
    allowed = 3 * (150 / 1408) ** 2 * np.max(np.abs(slope))
    np.testing.assert_allclose(near[1].q_dot[elastic], slope, rtol=0, atol=allowed)


@pytest.mark.parametrize(
    "parameters, initial", [({"rod.K_ff[0,0]": 0.0}, {"crank.theta_dot": 0.0}), ({}, {"crank.theta_dot": 1e170})]
)
def test_no_equilibrium_is_an_error(built_in: Load, parameters: dict, initial: dict) -> None:
    """Law: a mode without stiffness at rest, or forces that overflow, have no equilibrium, and the error says so."""
    model = built_in("flexible_slider_crank_free")
    p = model.parameter_vector(parameters)
    with pytest.raises(InitialStateError, match="no quasi-static elastic equilibrium"):
        start_state(model, p, model.constants(p), 0.0, initial, "quasi_static")


def geared_arm(stiffness: float) -> SceneRecord:
    """Two beams and a rotor, with springs between them that are wound up: angles 0.2 and 0.5 from a rotor at 0."""
    bends = {"length": 1.0, "density": 7800.0, "area": 4e-4, "second_moment": 0.02**4 / 12, "youngs_modulus": 2e11}
    return (
        Scene("geared")
        .gravity(0, -9.81)
        .rigid("rotor", mass=1.0, inertia=0.008)
        .beam("upper", **bends, lateral={"ends": "welded-welded", "modes": 2}, stiffening=True)
        .beam("lower", **bends, lateral={"ends": "clamped-free", "modes": 2}, stiffening=True)
        .revolute("axle", "ground.origin", "rotor.origin")
        .revolute("shoulder", "ground.origin", "upper.start")
        .revolute("elbow", "upper.end", "lower.start")
        .rotational_spring_damper("gear", "rotor.origin", "upper.start", stiffness=stiffness)
        .rotational_spring_damper("knee", "upper.end", "lower.start", stiffness=stiffness)
        .initial({"upper.theta": 0.2, "lower.theta": 0.5})
        .simulation(t_end=0.01, dt=1e-4, scheme="exponential", start="quasi_static")
        .build()
    )


@pytest.mark.long
def test_stiff_gears_settle_with_the_rest(model_of: Callable[[SceneRecord], Model]) -> None:
    """Springs of 2e4 N m/rad wound by 0.2 rad throw the beams about: no elastic equilibrium is there, which is said.

    With start = equilibrium all of it rests: nothing moves, and the run begins in what `equilibrium` finds.
    """
    model = model_of(geared_arm(2e4))
    with pytest.raises(InitialStateError, match="start = equilibrium"):
        simulate(model)
    told = [event for event in simulate(model_of(geared_arm(200.0))).events if event.kind == "not_settled"]
    assert len(told) == 1 and "rotor.theta" in told[0].text and "start = equilibrium" in told[0].text
    run = simulate(model, start="equilibrium")
    np.testing.assert_allclose(run.q[0], equilibrium(model).q, atol=1e-9)
    assert np.abs(run.q - run.q[0]).max() < 1e-9 and run.status.name == "completed", run.status


def test_a_start_in_equilibrium_keeps_what_turns_and_what_drives(model_of: Callable[[SceneRecord], Model]) -> None:
    """A pendulum on a trolley that begins with 0.2 m/s: it hangs plumb, moves along, and stays so."""
    scene = (
        Scene("crane")
        .gravity(0, -9.81)
        .rigid("trolley", mass=2.0, inertia=0.1)
        .rigid("load", mass=1.0, inertia=0.0, center_of_mass=(0, -1.0))
        .prismatic("rail", "ground.origin", "trolley.origin")
        .prescribed_displacement("drive", "ground.origin", "trolley.origin", motion="0.2 * t")
        .revolute("hook", "trolley.origin", "load.origin")
        .initial({"load.theta": 0.3})
        .simulation(t_end=1.0, dt=1e-3, scheme="rk4", start="equilibrium")
        .build()
    )
    run = simulate(model_of(scene))
    assert np.abs(run["load.theta"]).max() < 1e-10 and run["trolley.x_dot"][0] == pytest.approx(0.2)
    assert run["trolley.x"][-1] == pytest.approx(0.2)


def braked_arm() -> SceneRecord:
    """An arm driven by a velocity that rises for half a second at 2 rad/s^2, and falls as fast."""
    return (
        Scene("braked_arm")
        .beam(
            "arm",
            length=1.0,
            density=2700.0,
            area=4e-5,
            second_moment=1.3e-10,
            youngs_modulus=7e10,
            lateral={"modes": 2},
        )
        .revolute("axle", "ground.origin", "arm.start")
        .table("speed", x=[0.0, 0.5, 1.0], y=[0.0, 1.0, 0.0], integrated=1)
        .prescribed_angle("drive", "ground.origin", "arm.start", motion="table('speed', t)")
        .build()
    )


@pytest.mark.parametrize("t0, side", [(0.49995, 1), (0.5, -1), (0.50005, -1)])
def test_a_jump_beside_the_start_is_no_rate(model_of: Callable[[SceneRecord], Model], t0: float, side: int) -> None:
    """Deflections are those of the acceleration on this side, opposite ones on the other, and stay: no vibration.

    As differences across the jump the rates were 20 m/s.
    """
    model = model_of(braked_arm())
    before = simulate(model, t0=0.4, t_end=0.401, start="quasi_static", scheme="rk4", dt=1e-5)
    run = simulate(model, t0=t0, t_end=t0 + 4e-5, start="quasi_static", scheme="rk4", dt=1e-5)
    assert run["arm.q1"][0] == pytest.approx(side * before["arm.q1"][0], rel=1e-3)
    assert abs(run["arm.q1_dot"][0]) < 0.01
    case = model.ensemble(
        {"arm.density": [2700.0, 2700.0]}, t0=t0, t_end=t0 + 4e-5, start="quasi_static", scheme="rk4", dt=1e-5,
        outputs=["arm.q1"], seen_every=0.0,
    )  # fmt: skip
    np.testing.assert_array_equal(np.asarray(case["arm.q1"])[0], run["arm.q1"])
    assert run.interpolate(t0).shape == (len(model.coordinates),)


def test_a_motion_that_only_coarse_steps_end_is_not_completed(model_of: Callable[[SceneRecord], Model]) -> None:
    """A beam that is hit at 22 m/s bends by more than its modes describe; twenty steps of 25 ms pass that by."""
    hit = {"arm.q1_dot": 21.9, "arm.q1": -0.0257}
    run = simulate(model_of(braked_arm()), t0=0.5, t_end=1.0, initial=hit, tolerance=1e-3)
    assert run.status.name == "deflection_too_large", run.status
