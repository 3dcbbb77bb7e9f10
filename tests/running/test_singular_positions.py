"""Bifurcations: the branch is kept by continuity and energy, and the run says so; or it ends and says that."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from runtime import Solution, resume, simulate
from runtime.model import Model
from runtime.running.singular import crossing, singular_crossing
from runtime.running.singular.crossing import BranchLost
from symgen.generate import model_of as model_of_scene
from symgen.scene import Scene, SceneRecord
from tests.support.slider_cranks import driven_slider_crank, equal_slider_crank, loop

pytestmark = pytest.mark.long

Load = Callable[[str], Model]
Build = Callable[[SceneRecord], Model]
FIRST, REVOLUTION, SINGULAR = 0.714355529293, 1.94251492261, 10
TIPS = {
    1.0: (-0.19502030194944, -0.98079920566217),
    2.0: (0.057815795768011, 0.99832726786346),
    10.0: (0.32845811154082, 0.9445185381786),
}
SERIES = ("t", "q", "q_dot", "q_ddot", "q_i", "lam")


def tip_error(solution: Solution) -> float:
    """Of B0 at the times with known values; angles of the first upright."""
    found = 0.0
    for time, (x, y) in TIPS.items():
        k = int(np.abs(solution.t - time).argmin())
        angle = solution["upright0.theta"][k]
        found = max(found, abs(math.cos(angle) - x), abs(math.sin(angle) - y))
    return found


def energy_error(solution: Solution) -> float:
    return float(np.abs(solution.energy_balance()).max())


def bars_stay_parallel(solution: Solution) -> bool:
    turned = [solution[f"upright{k}.theta"] for k in (1, 2)]
    return all(np.abs(angle - solution["upright0.theta"]).max() < 1e-6 for angle in turned)


@pytest.mark.parametrize(
    "scheme, dt, tip, energy",
    [
        ("dop853", 1e-3, 1e-6, 1e-4),
        ("rk4", 1e-3, 1e-6, 1e-4),
        ("radau", 1e-3, 1e-6, 1e-4),
        ("single_rate", 1.25e-4, 1e-6, 2e-5),
        ("rk4", 1e-2, 1e-3, 0.1),
        ("coupled", 1e-3, 2e-4, 1e-2),
        ("exponential", 2e-3, 1e-5, 1e-4),
    ],
)
def test_four_bars_pass_ten_singular_positions(
    built_in: Load, scheme: str, dt: float, tip: float, energy: float
) -> None:
    run = simulate(built_in("n_four_bar"), scheme=scheme, dt=dt, t_end=10.0, seen_every=0.01)
    assert run.status.ok
    assert [event.kind for event in run.events] == ["singular_position"] * SINGULAR
    assert len(run.t) == 1001 and np.abs(np.diff(run.t) - 0.01).max() < 1e-9
    assert tip_error(run) < tip
    assert energy_error(run) < energy
    assert bars_stay_parallel(run)
    assert run.constraint_error.max() < 1e-10 and run.constraint_rate_error.max() < 1e-10


def test_singular_times_are_those_of_the_exact_motion(built_in: Load) -> None:
    run = simulate(built_in("n_four_bar"), scheme="dop853", dt=1e-3, t_end=5.0, seen_every=0.1)
    times = [event.time for event in run.events]
    assert times[0] == pytest.approx(FIRST, abs=1e-8)
    assert times[2] - times[0] == pytest.approx(REVOLUTION, abs=1e-8)
    assert "branch kept by continuity" in run.events[0].text


@pytest.mark.parametrize("start, passed", [(0.70, 3), (0.7143, 3), (0.714355, 3), (0.7144, 2)])
def test_a_run_may_start_beside_a_singular_position(built_in: Load, start: float, passed: int) -> None:
    """The determinant has no larger values to be compared with, and few steps before the position."""
    model = built_in("n_four_bar")
    exact = solve_ivp(
        lambda t, y: [y[1], 3.5 * 9.81 / 3 * math.sin(y[0])], (0, start), [0.0, 1.0], rtol=1e-12, atol=1e-12
    ).y[:, -1]
    initial = {f"upright{k}.theta": math.pi / 2 - exact[0] for k in range(3)}
    initial |= {"upright0.theta_dot": -exact[1]}
    run = simulate(model, scheme="rk4", dt=1e-3, t_end=2.0, initial=initial, seen_every=0.01)
    assert run.status.ok and len(run.events) == passed
    assert bars_stay_parallel(run) and energy_error(run) < 1e-6


@pytest.mark.parametrize(
    "scheme, dt, energy",
    [("single_rate", 1e-3, 5e-3), ("rk4", 1e-3, 1e-6), ("dop853", 1e-2, 1e-5), ("single_rate", 1e-2, 0.5)],
)
def test_equal_slider_crank_keeps_its_branch(model_of: Build, scheme: str, dt: float, energy: float) -> None:
    run = simulate(model_of(equal_slider_crank().build()), scheme=scheme, dt=dt, seen_every=0.01)
    assert run.status.ok and len(run.events) == 8
    assert np.abs(run["rod.theta"] + run["crank.theta"]).max() < 1e-9
    assert run["slider.x"].min() < -0.99
    assert energy_error(run) < energy
    assert run.constraint_error.max() < 1e-10 and run.constraint_rate_error.max() < 1e-10


def test_damped_and_driven_mechanisms_pass_too(model_of: Build) -> None:
    """Energy is compared by the work of dampers and loads."""
    run = simulate(model_of(driven_slider_crank().build()), scheme="rk4", t_end=1.5, seen_every=0.0)
    assert run.status.ok and len(run.events) >= 2
    assert np.abs(run.work()).max() > 1.0 and energy_error(run) < 1e-6
    assert np.abs(run["rod.theta"] + run["crank.theta"]).max() < 1e-9


def test_a_step_that_misses_the_energy_is_not_taken(built_in: Load, monkeypatch: pytest.MonkeyPatch) -> None:
    """Whatever the crossing does wrong, the run ends with the named status before the position."""
    monkeypatch.setattr(crossing, "ENERGY", -1.0)
    run = simulate(built_in("n_four_bar"), scheme="rk4", dt=1e-3, t_end=2.0, seen_every=0.01)
    assert run.status.name == "branch_lost" and "cannot be told" in run.status.cause
    assert 0.6 < run.status.time < FIRST and run.t[-1] == run.status.time and not run.events
    assert energy_error(run) < 1e-6


def test_a_step_to_another_branch_is_not_taken(built_in: Load, monkeypatch: pytest.MonkeyPatch) -> None:
    """Behind the position the uprights are turned to the branch on which they are not parallel."""
    honest = crossing._step

    def turned(integrator: Any, t: float, y: np.ndarray, H: float) -> tuple[np.ndarray, float]:
        end, error = honest(integrator, t, y, H)
        loops = integrator.model.loop_unknowns
        other = end.copy()
        for k in (1, 2):  # the antiparallel closure: mirrored about the line through the feet
            other[2 + loops.index(f"upright{k}.theta")] *= -1
        return other, error

    monkeypatch.setattr(crossing, "_step", turned)
    run = simulate(built_in("n_four_bar"), scheme="rk4", dt=1e-3, t_end=2.0, seen_every=0.01)
    assert run.status.name == "branch_lost"
    assert run.status.time < FIRST and bars_stay_parallel(run)


def test_no_way_over_ends_with_a_named_status(built_in: Load, monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(*_: Any) -> None:
        raise BranchLost("made up")

    monkeypatch.setattr(singular_crossing, "cross", refuse)
    run = simulate(built_in("n_four_bar"), scheme="single_rate", dt=1e-3, t_end=2.0)
    assert run.status.name == "branch_lost" and "made up" in run.status.cause and run.status.advice


# ---- reproducible, also across checkpoints --------------------------------------------------------------------


def assert_same(one: Solution, other: Solution) -> None:
    for name in SERIES:
        assert np.array_equal(getattr(one, name), getattr(other, name)), name
    assert one.events == other.events and one.status == other.status


@pytest.mark.parametrize(
    ("scheme", "engine"), [("single_rate", "interpreted"), ("coupled", "compiled"), ("radau", "compiled")]
)
def test_passing_does_not_depend_on_native_calls(built_in: Load, tmp_path: Path, scheme: str, engine: str) -> None:
    """Calls of one step (a checkpoint after each), or as many as are quick: the same run, bit for bit."""
    settings: dict[str, Any] = {"scheme": scheme, "dt": 2e-3, "t_end": 0.9, "seen_every": 0.01, "engine": engine}
    model = built_in("n_four_bar")
    whole = simulate(model, **settings)
    assert len(whole.events) == 1
    assert_same(simulate(model, **settings, checkpoint=tmp_path / "run.npz", checkpoint_every=1), whole)

    def stop(t: float, t_end: float) -> None:
        if t >= 0.71:  # inside the passage
            raise KeyboardInterrupt

    simulate(model, **settings, checkpoint=tmp_path / "run.npz", checkpoint_every=7, progress=stop)
    assert_same(resume(model, tmp_path / "run.npz", engine=engine), whole)


def test_resuming_after_an_exchange_of_coordinates(model_of: Build, tmp_path: Path) -> None:
    model = model_of(loop(0.2, 0.5, "slider.x").build())
    settings: dict[str, Any] = {"scheme": "single_rate", "dt": 1e-3, "t_end": 1.0, "seen_every": 0.005}
    whole = simulate(model, **settings)
    assert [event.kind for event in whole.events] == ["repartition"]

    def stop(t: float, t_end: float) -> None:
        if t >= 0.9:
            raise KeyboardInterrupt

    simulate(model, **settings, checkpoint=tmp_path / "run.npz", checkpoint_every=9, progress=stop)
    assert_same(resume(model, tmp_path / "run.npz"), whole)


# ---- random mechanisms ----------------------------------------------------------------------------------------


def random_four_bar(seed: int) -> SceneRecord:
    """Four bars of random lengths that close at random angles, q_i = crank.theta: most cranks cannot turn round."""
    rng = np.random.default_rng(seed)
    lengths = rng.uniform(0.3, 1.0, 3)
    angles = rng.uniform(-math.pi, math.pi, 3)
    scene = Scene(f"random{seed}").gravity(0, -9.81)
    end = np.zeros(2)
    for name, length, angle in zip(("crank", "coupler", "rocker"), lengths, angles, strict=True):
        scene.rigid(
            name,
            mass=float(rng.uniform(0.5, 2)),
            inertia=float(length**2 * rng.uniform(0.05, 0.2)),
            center_of_mass=(float(length / 2), 0.02),
            markers={"tip": {"position": (float(length), 0)}},
        )
        end += length * np.array([math.cos(angle), math.sin(angle)])
    scene.ground(markers={"right": {"position": (float(end[0]), float(end[1]))}})
    scene.revolute("A", "ground.origin", "crank.origin").revolute("B", "crank.tip", "coupler.origin")
    scene.revolute("C", "coupler.tip", "rocker.origin").revolute("D", "rocker.tip", "ground.right")
    scene.initial(dict(zip(("crank.theta", "coupler.theta", "rocker.theta"), map(float, angles), strict=True)))
    scene.independent("crank.theta").rates({"crank.theta": float(rng.uniform(2, 6))})
    return scene.simulation(t_end=4.0, dt=5e-4, scheme="rk4").build()


@pytest.mark.parametrize("seed", range(8))
def test_random_four_bars_go_on_wherever_they_lead(seed: int) -> None:
    """q_i is exchanged as often as it takes; energy and constraints hold throughout."""
    run = simulate(model_of_scene(random_four_bar(seed)), seen_every=0.01)
    assert run.status.ok, run.status
    assert energy_error(run) < 1e-4 * float(run.energy["kinetic"].max())
    assert run.constraint_error.max() < 1e-10 and run.constraint_rate_error.max() < 1e-10
