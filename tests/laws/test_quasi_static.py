"""The quasi-static start: elastic coordinates in equilibrium, with little vibration left; where there is none."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from runtime.contract.consistent_state import InitialStateError
from runtime.contract.model import Model
from runtime.start.start_state import start_state
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
