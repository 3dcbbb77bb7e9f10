"""Exponential Adams steps with a point in the middle: order, bodies that turn, matrices by hand, modes, price."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest

from benchmarks.scenes.arm import arm
from runtime import resume, simulate
from runtime.contract.tape import arithmetic
from runtime.model import Model
from runtime.schemes.catalogue import scheme_kind
from runtime.schemes.scheme import Scheme
from runtime.studies.stability.spectra import TangentStep
from symgen.scene import Scene, SceneRecord
from symgen.scenes import SCENES
from symgen.scenes.pendulums import chain
from symgen.scenes.spatial import spatial_chain
from tests.hand_derived.twin_oscillators import Params
from tests.hand_derived.twin_subcycling import matrices, radius
from tests.support.model_values import Array
from tests.support.prepared_runs import PreparedRuns

pytestmark = pytest.mark.long

Load = Callable[[str], Model]
Build = Callable[[SceneRecord], Model]
NAME = "exponential_adams"


def built(model: Model) -> Scheme:
    return scheme_kind(NAME).build(NAME, model, 1.0, None, {})


def with_stiff(*names: str) -> SceneRecord:
    data = SCENES["two_oscillators"]().to_dict()
    data["partition"] = {**data["partition"], "stiff": list(names)}
    return SceneRecord.from_dict(data)


def step_matrix(tangent: TangentStep, params: Params, dt: float) -> Array:
    """On the fields that act on the next step."""
    scheme = tangent.scheme
    model, names = scheme.model, {"c": params.c, "w": params.w, "k_L": params.k_L, "zeta": params.zeta}
    c = scheme.constants(model.constants(model.parameter_vector(names)), dt)
    z = np.asarray(scheme.starter(0.0, np.zeros(2), np.zeros(2), np.zeros(0), c)).ravel()
    return np.asarray(tangent(z, c)[1])


@dataclass(frozen=True)
class Case:
    """A scene, t_end and the coarsest of three steps [s], a cap on the error of q_i at the finest, about 1.5 times the
    measured one, bounds of the slope, the start."""

    scene: Callable[[], SceneRecord]
    t_end: float
    dt: float
    cap: float
    slope: tuple[float, float]
    start: str | None = None


CASES = {
    "time-dependent load": Case(SCENES["hub_beam"], 0.8, 2e-2, 4e-10, (3.7, 4.3)),
    "loop": Case(SCENES["flexible_slider_crank_free"], 0.008, 1e-4, 2e-10, (3.5, 4.8), "quasi_static"),
    "joint spring": Case(SCENES["flexible_joint_arm"], 0.5, 1.25e-3, 2e-12, (3.5, 8.0)),
    "strong damper": Case(SCENES["overdamped_joint"], 0.2, 1e-2, 1e-9, (3.7, 4.6)),
    "all links flexible": Case(lambda: chain(2, 2), 0.25, 1e-3, 4e-9, (3.7, 4.5)),
}


@pytest.mark.parametrize("name", CASES)
def test_order_four(model_of: Build, name: str) -> None:
    """Law: the error of q_i at t_end falls with dt^4, the first step from a start without a past included."""
    case = CASES[name]
    model = model_of(case.scene())
    exact = PreparedRuns(model, "dop853", start=case.start).end(case.t_end, case.dt / 64)
    runs, steps = PreparedRuns(model, NAME, None, {}, case.start), [case.dt, case.dt / 2, case.dt / 4]
    errors = [float(np.max(np.abs(runs.end(case.t_end, step) - exact))) for step in steps]
    slope = float(np.polyfit(np.log(steps), np.log(errors), 1)[0])
    assert case.slope[0] < slope < case.slope[1], (slope, errors)
    assert errors[-1] < case.cap, (slope, errors)


def explicit_matrix(p: Params, dt: float) -> Array:
    """A step without stiff deflections on (x, v, a of the last middle, a of the last start), in half steps k = dt / 2.

    Y2  by the parabola through a at 0, -1, -2:      v + k (23, -16, 5) / 12,  x + k v + k^2 (19, -10, 3) / 24
    end by the cubic through a at 1, 0, -1, -2:      v + k (8, -5, 4, -1) / 3, x + 2 k v + k^2 (62, 24, 6, -2) / 45
    """
    M, K, D = matrices(p)
    x, v, middle, before = np.eye(8).reshape(4, 2, 8)
    k = dt / 2

    def a(x: Array, v: Array) -> Array:
        return np.asarray(-np.linalg.solve(M, K @ x + D @ v))

    def combined(weights: tuple[int, ...], values: tuple[Array, ...]) -> Array:
        return np.asarray(sum(weight * value for weight, value in zip(weights, values, strict=True)))

    now = a(x, v)
    past = (now, middle, before)
    there = a(x + k * v + k * k / 24 * combined((19, -10, 3), past), v + k / 12 * combined((23, -16, 5), past))
    seen = (there, *past)
    x_end = x + 2 * k * v + k * k / 45 * combined((62, 24, 6, -2), seen)
    v_end = v + k / 3 * combined((8, -5, 4, -1), seen)
    return np.concatenate([x_end, v_end, there, now])


def test_matrix_and_reach_without_deflections(model_of: Build) -> None:
    """The step by hand; undamped oscillation is stable up to h w = 2 and not beyond 2.05, decays up to h d = 0.29."""
    tangent = TangentStep(built(model_of(with_stiff())))
    for p in (Params(c=0.5, w=3.0, k_L=1.7, zeta=0.0), Params(c=-0.6, w=2.0, k_L=0.9, zeta=0.07)):
        found = step_matrix(tangent, p, 0.2)
        np.testing.assert_allclose(found, explicit_matrix(p, 0.2), rtol=0, atol=1e-13)
    single = [radius(explicit_matrix(Params(c=0.0, w=h, k_L=h * h, zeta=0.0), 1.0)) for h in (0.5, 1.0, 2.0, 2.05)]
    assert max(single[:3]) < 1.0 + 1e-12 < 1.01 < single[3], single
    critical = [radius(explicit_matrix(Params(c=0.0, w=h, k_L=1e-9, zeta=1.0), 1.0)) for h in (0.28, 0.32)]
    assert critical[0] < 1.0 + 1e-12 < 1.01 < critical[1], critical


@pytest.mark.parametrize("c", [0.3, 0.6])
def test_unresolved_modes_do_not_grow(model_of: Build, c: float) -> None:
    """Law: from H w = 5 to 200 not at all, whatever the phase; from 2 to 5 by less than 1e-3 a step, H w_L = 0.2."""
    tangent, slow = TangentStep(built(model_of(with_stiff("x_S")))), 0.2

    def growth(reach: float) -> float:
        return float(np.log(radius(step_matrix(tangent, Params(c=c, w=reach / slow, k_L=1.0, zeta=0.0), slow))))

    assert max(growth(reach) for reach in np.geomspace(5.0, 200.0, 40)) < 1e-12
    assert max(growth(reach) for reach in np.linspace(2.0, 5.0, 25)) < 1e-3


def test_price(model_of: Build) -> None:
    """270 operations for each further link of an arm; 1,490 for its three modes: 0.7 of `exponential_rk4`."""
    counts = []
    for links in (4, 8):
        stages = built(model_of(arm(links))).program().stages()
        counts.append(sum(arithmetic(stage) for stage in stages))
    assert counts[1] - counts[0] <= 4 * 272
    assert counts[1] <= 8 * 272 + 1_500


def thrown() -> SceneRecord:
    """A rod that bends in two planes, thrown so that it tumbles; nothing acts on it."""
    builder = Scene("thrown", space="spatial")
    free = {"ends": "free-free", "modes": 1}
    builder.beam(
        "rod", length=0.6, density=2700.0, area=1e-4, second_moment=4e-10, second_moment_z=6e-10, youngs_modulus=7e8,
        free=True, lateral=free, lateral_z=free,
    )  # fmt: skip
    builder.initial({"rod.q1": 0.01}).rates({"rod.omega_x": 1.0, "rod.omega_y": 5.0, "rod.omega_z": 3.0})
    return builder.simulation(t_end=0.5, dt=5e-3, scheme=NAME).build()


TURNING = {
    "a free body tumbles": Case(thrown, 0.2, 1e-2, 5e-5, (3.7, 4.6)),
    "links on balls fall": Case(lambda: spatial_chain(2, 1), 0.2, 4e-3, 4e-10, (3.7, 4.2)),
}


@pytest.mark.parametrize("name", TURNING)
def test_order_four_of_turning_bodies(model_of: Build, name: str) -> None:
    """Law: the same for places and charts, though accelerations of the last step have other components in this one."""
    case = TURNING[name]
    model = model_of(case.scene())

    def end(runs: PreparedRuns, dt: float) -> Array:
        steps = round(case.t_end / dt)
        found = runs.samples(case.t_end / steps, steps, steps)
        return np.concatenate([found[field][-1] for field in ("x", "chart")])

    exact = end(PreparedRuns(model, "dop853"), case.dt / 32)
    runs, steps = PreparedRuns(model, NAME), [case.dt, case.dt / 2, case.dt / 4]
    errors = [float(np.max(np.abs(end(runs, step) - exact))) for step in steps]
    slope = float(np.polyfit(np.log(steps), np.log(errors), 1)[0])
    assert case.slope[0] < slope < case.slope[1], (slope, errors)
    assert errors[-1] < case.cap, (slope, errors)


def stopping(last: float) -> Callable[[float, float], None]:
    """Progress of a run that is broken off at a time."""

    def stop(t: float, t_end: float) -> None:
        if t >= last:
            raise KeyboardInterrupt

    return stop


def test_energy_and_resumed_run_of_a_thrown_rod(model_of: Build, tmp_path: Path) -> None:
    """Its energy stays, better by 16 with half the step; a resumed run is bitwise the whole one."""
    model = model_of(thrown())
    wholes = [simulate(model, dt=dt) for dt in (5e-3, 2.5e-3)]
    drifts = [float(np.abs(whole.energy_balance()).max()) for whole in wholes]
    assert drifts[1] < 1.5e-7 and 12 < drifts[0] / drifts[1] < 32, drifts
    simulate(model, checkpoint=tmp_path / "run.npz", checkpoint_every=7, progress=stopping(0.25))
    assert np.array_equal(resume(model, tmp_path / "run.npz").q, wholes[0].q)


def test_exchange_of_a_turn(model_of: Build, tmp_path: Path) -> None:
    """A body on a rigid rod: where its position no longer changes the length a turn takes its place, and all three are
    independent then; energy and the rod's length stay. A run resumed before or behind it is bitwise the whole one."""
    builder = Scene("bob", space="spatial").gravity(0, 0, -9.81)
    builder.rigid("bob", mass=2.0, inertia=[0.1, 0.2, 0.3], markers={"eye": {"position": [0, 0, 0.5]}})
    builder.distance("rod", "ground.origin", "bob.eye", length=1.0).initial({"bob.x": 1.0})
    model = model_of(builder.simulation(t_end=0.7, dt=1e-3, scheme=NAME).build())
    assert model.loop_unknowns == ["bob.turn_y"]
    found = simulate(model)
    assert [event.text.startswith("bob.turn_y took the place of") for event in found.events] == [True]
    assert np.abs(found.energy_balance()).max() < 1e-4 and found.constraint_error.max() < 1e-12
    for last in (0.2, 0.65):
        simulate(model, checkpoint=tmp_path / "run.npz", checkpoint_every=7, progress=stopping(last))
        assert np.array_equal(resume(model, tmp_path / "run.npz").q, found.q)
