"""Loops of spherical joints with a rod that bends and spins about its line: Jacobian, orders of the schemes, stops.

The spin about the line between the balls is independent and moves neither ball, the other two turns follow; modes are
a group of their own. Equations by hand are in test_orientations_in_loops.py.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from runtime import simulate
from runtime.contract.coordinates import independent
from runtime.model import Model
from runtime.studies.stability.chart import StabilityStudy, states_along
from runtime.studies.stability.spectra import ExactMotion
from symgen.scene import Scene, SceneRecord
from tests.laws.test_orientations_in_loops import mechanism
from tests.laws.test_random_spatial import turned_place
from tests.support.model_values import Array, evaluate, make_state, relative_error
from tests.support.prepared_runs import PreparedRuns

pytestmark = pytest.mark.long

Build = Callable[..., Model]
CRANK, ROCKER, PIVOT, ANGLE = 0.25, 0.4, np.array([0.3, 1.0, 0.0]), 0.3
T_END, REFERENCE = 0.08, 5e-4


def linkage() -> SceneRecord:
    """A crank about x, a rod between two balls that bends in two planes, a rocker about y."""
    builder = Scene("flexible_linkage", space="spatial").gravity(0, 0, -9.81).parameter("E", 7e10)
    about = {"a": {"axis": [1, 0, 0], "x_axis": [0, 1, 0]}, "b": {"axis": [0, 1, 0], "x_axis": [1, 0, 0]}}
    builder.ground(markers={"a": about["a"], "b": {**about["b"], "position": PIVOT.tolist()}})
    crank, rocker = {"position": [0, CRANK, 0]}, {"position": [ROCKER, 0, 0]}
    builder.rigid(
        "crank", mass=1.0, inertia=[0.02, 0.01, 0.015], center_of_mass=[0, 0.1, 0], markers={**about, "tip": crank}
    )
    builder.rigid(
        "rocker", mass=1.5, inertia=[0.03, 0.02, 0.04], center_of_mass=[0.2, 0, 0], markers={**about, "tip": rocker}
    )
    bending = {"ends": "pinned-pinned", "modes": 1}
    builder.beam(
        "rod", length=1.0, density=2700.0, area=4e-4, second_moment=8e-9, second_moment_z=5e-9,
        youngs_modulus="E", lateral=bending, lateral_z=bending, stiffening=True,
        markers={"near": {"at": 0.0}, "far": {"at": 1.0}},
    )  # fmt: skip
    builder.revolute("left", "ground.a", "crank.a").revolute("right", "ground.b", "rocker.b")
    builder.spherical("first", "crank.tip", "rod.near").spherical("second", "rod.far", "rocker.tip")
    near = CRANK * np.array([0, np.cos(ANGLE), np.sin(ANGLE)])
    along = PIVOT + [0.38, 0, -0.1] - near
    along /= np.linalg.norm(along)
    e = np.r_[1 + along[0], np.cross([1, 0, 0], along)]
    place = dict(zip(("x", "y", "z", "e0", "e1", "e2", "e3"), [*near, *(e / np.linalg.norm(e))], strict=True))
    builder.initial({"left.angle": {"value": ANGLE, "fixed": True}, **{f"rod.{k}": float(v) for k, v in place.items()}})
    builder.rates({"left.angle": {"value": 4.0, "fixed": True}, "rod.omega_x": 6.0})
    return builder.simulation(t_end=T_END, dt=1e-3, scheme="rk4").build()


@pytest.fixture(scope="module")
def model(model_of: Build) -> Model:
    found = model_of(linkage())
    groups = [[found.q_i[k] for k in group.positions] for group in found.groups]
    assert groups == [["left.angle", "rod.turn_x"], ["rod.q1", "rod.q2"]]
    assert found.loop_unknowns == ["right.angle", "rod.turn_y", "rod.turn_z"]
    return found


def test_residual_jacobian(model: Model) -> None:
    """Differences of Q_hat - M_hat a, the loop closed anew: the spin moves no ball and yet changes their accelerations,

    omega x (omega x r) having a part of omega_x (omega_y, omega_z)."""
    rng, n, h = np.random.default_rng(5), len(model.q_i), 1e-5
    reach = np.where([name in model.elastic for name in model.q_i], 1e-2, 0.1)
    start = independent(model, model.initial_q, model.initial_q_dot)[0] + reach * rng.uniform(-1, 1, n)
    state, a = make_state(model, start, 3 * rng.uniform(-1, 1, n)), rng.uniform(-1, 1, n)

    def residual(step: Array, change: Array) -> Array:
        at = make_state(model, turned_place(model, state, step), state.q_i_dot + change, 0.0, state.q)
        out = evaluate(model, "condensed", **at.values())
        return np.asarray(out["Q_hat"] - out["M_hat"].reshape(n, n) @ a)

    found = evaluate(model, "residual_jacobian", **state.values(), q_i_ddot=a)
    none, units = np.zeros(n), h * np.eye(n)
    J_q = np.array([residual(unit, none) - residual(-unit, none) for unit in units]).T / (2 * h)
    J_v = np.array([residual(none, unit) - residual(none, -unit) for unit in units]).T / (2 * h)
    for name, wanted in (("J_q", J_q), ("J_v", J_v)):  # by columns: those of the spin are small beside the modes'
        for k in range(n):
            assert relative_error(found[name].reshape(n, n)[:, k], wanted[:, k]) < 1e-6, (name, model.q_i[k])


# scheme, m, options, step, order, error at half of the step at most
SCHEMES: list[tuple[str, int | None, dict[str, Any], float, float, float]] = [
    ("printed", 1, {}, 1e-3, 2, 1.5e-6),
    ("printed", 2, {}, 5e-4, 1, 7e-5),
    ("coupled", 2, {}, 2e-3, 2, 1e-5),
    ("exponential", 2, {}, 2e-3, 4, 1.3e-8),
    ("exponential", 1, {"order": 5}, 4e-3, 6, 2.6e-9),
    ("exponential_rk4", None, {}, 4e-3, 4, 6.5e-8),
    ("exponential_adams", None, {}, 2e-3, 4, 7e-8),
    ("radau", None, {}, 4e-3, 5, 1.2e-7),
]


@pytest.fixture(scope="module")
def wanted(model: Model) -> Array:
    return end(PreparedRuns(model, "dop853", engine="interpreted"), REFERENCE)


def end(runs: PreparedRuns, dt: float) -> Array:
    """Angle of the crank, modes and quaternion of the rod at T_END."""
    seen = runs.seen(T_END, dt)
    return np.array([seen[name] for name in ("left.angle", "rod.q1", "rod.q2", *(f"rod.e{k}" for k in range(4)))])


@pytest.mark.parametrize("scheme, m, options, dt, order, most", SCHEMES)
def test_orders(
    model: Model,
    wanted: Array,
    scheme: str,
    m: int | None,
    options: dict[str, Any],
    dt: float,
    order: float,
    most: float,
) -> None:
    """Slope and size of the errors against order 8, the modes in a group of their own; `printed` with m > 1 is of first
    order because inertia couples the groups, `exponential` of order 5 is better than its name here."""
    runs = PreparedRuns(model, scheme, None if m is None else [m], options, engine="interpreted")
    errors = [float(np.abs(end(runs, h) - wanted).max()) for h in (dt, dt / 2)]
    assert errors[1] < most, errors
    assert np.log2(errors[0] / errors[1]) == pytest.approx(order, abs=0.25), errors


def test_a_sweep_that_is_too_slow_is_made_in_parts(model: Model) -> None:
    """A soft rod bends so far that its spin and its modes are nearly the same motion: a sweep leaves 0.96 of its error.
    The state before is a mark of the error's growth, at which the run looks twice."""
    settings: dict[str, Any] = {"parameters": {"E": 7e8}, "scheme": "printed", "m": [1], "dt": 5e-3, "t_end": 0.25}
    run = simulate(model, **settings, engine="interpreted")
    assert run.status.whole and run.t[-1] == 0.25 and run.stats["divided_steps"] >= 1
    direct = simulate(model, **settings, options={"common_update": "direct"}, engine="interpreted")
    assert direct.status.whole and direct.t[-1] == 0.25


def test_predicted_limit_is_real(model: Model) -> None:
    """A step 2 % below the predicted limit stays in bounds and one 2 % above it blows up. Steps in which the rod turns
    more than once have no limit to tell."""
    c, t_end = model.constants(model.parameter_vector()), 0.5
    states, exact = states_along(model, t_end=t_end, count=6, start="quasi_static"), ExactMotion(model, c)
    coupled = StabilityStudy(model, "coupled", [4], {}, c, states, t_end, exact)
    assert coupled.at(0.1)[0] == np.inf
    limit = StabilityStudy(model, "single_rate", None, {}, c, states, t_end, exact).curve(np.array([7e-3, 1e-2])).limit
    assert limit is not None

    def whole(dt: float) -> bool:
        settings: dict[str, Any] = {"scheme": "single_rate", "start": "quasi_static", "force": True}
        return simulate(model, dt=dt, t_end=t_end, engine="interpreted", **settings).status.whole

    assert whole(0.98 * limit) and not whole(1.02 * limit)


def test_a_ball_twice(model_of: Build) -> None:
    """Its rows are found redundant, whichever body is named first, and change nothing."""
    once, twice = model_of(mechanism()), model_of(mechanism(twice=True))
    assert len(twice.redundant) == 3 and twice.loop_unknowns == once.loop_unknowns
    ends = [simulate(one, scheme="rk4", dt=4e-3, t_end=0.2, engine="interpreted") for one in (once, twice)]
    np.testing.assert_allclose(ends[1].q, ends[0].q, rtol=0, atol=1e-13)
