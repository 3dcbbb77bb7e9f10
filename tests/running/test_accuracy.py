"""What a run says of its own error: estimates against the true error, and things that happen between the steps."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from runtime import Model, ModelError, reference_solution, resume, simulate
from runtime.results.amplitudes import floored
from runtime.studies.work_precision.problem import make_setting
from symgen.scene import Scene, SceneBuilder

Load = Callable[[str], Model]
Build = Callable[[Scene], Model]
WITHIN = 10.0

RUNS = [
    ("pendulum", 5.0, {"scheme": "single_rate", "dt": 0.01}),
    ("pendulum", 5.0, {"scheme": "rk4", "dt": 0.05}),
    ("slider_crank", 0.5, {"scheme": "single_rate", "dt": 1e-3}),
    ("two_oscillators", 10.0, {"scheme": "coupled", "m": [4], "dt": 0.05}),
    ("two_oscillators", 10.0, {"scheme": "exponential", "m": [2], "dt": 0.1}),
    ("two_oscillators", 10.0, {"scheme": "linearised", "m": [4], "dt": 0.1}),
    ("flexible_slider_crank", 0.05, {"scheme": "radau", "dt": 2e-4}),
    ("flexible_slider_crank", 0.05, {"scheme": "exponential", "m": [2], "dt": 2e-4}),
]


def rod(damping: float = 0.0, kick: str | None = None) -> Scene:
    """A rod on a hinge, 0.3 rad and 1 rad/s; inertia about the hinge 0.35 kg m2."""
    builder = SceneBuilder("rod").gravity(0, -9.81).rigid("rod", mass=1.0, inertia=0.1, center_of_mass=(0.5, 0))
    builder.revolute("pin", "ground.origin", "rod.origin", damping=damping)
    if kick is not None:
        builder.torque("kick", "rod.origin", kick)
    builder.initial({"rod.theta": 0.3}).rates({"rod.theta": 1.0})
    return builder.simulation(t_end=1.0, dt=1e-3, scheme="single_rate").build()


def driven(motion: str) -> Scene:
    """A bob on the tip of a crank that a prescribed angle turns."""
    builder = SceneBuilder("driven").gravity(0, -9.81)
    builder.rigid("crank", mass=1.0, inertia=0.01, markers={"tip": {"position": (0.5, 0)}})
    builder.rigid("bob", mass=1.0, inertia=0.1, center_of_mass=(0.5, 0))
    builder.revolute("pin", "ground.origin", "crank.origin").revolute("hinge", "crank.tip", "bob.origin")
    builder.prescribed_angle("drive", "ground.origin", "crank.origin", motion=motion).initial({"bob.theta": -1.57})
    return builder.simulation(t_end=1.0, dt=1e-3, scheme="single_rate").build()


@pytest.mark.parametrize("name, t_end, settings", RUNS)
def test_estimated_errors_are_of_the_right_size(built_in: Load, name: str, t_end: float, settings: dict) -> None:
    """Of every coordinate, within a factor of 10 of the largest true error on the way."""
    model = built_in(name)
    run = simulate(model, t_end=t_end, save_every=1, **settings)
    assert run.status.ok
    chosen = np.unique(np.linspace(0, len(run.t) - 1, 60).astype(int))
    exact = reference_solution(model, t_end=float(run.t[-1]), times=run.t[chosen])
    true = np.abs(run.q_i[chosen] - exact.q_i).max(axis=0)
    estimated = np.array([run.stats[f"estimated_error.{coordinate}"] for coordinate in model.q_i])
    assert (estimated < WITHIN * true).all() and (true < WITHIN * estimated).all(), estimated / true
    assert all(0 <= float(run.stats[f"worst_time.{coordinate}"]) < t_end for coordinate in model.q_i)


def test_a_step_too_long_is_said(built_in: Load) -> None:
    """single_rate with 18 steps a swing: 17 % off, no other check has anything to say; the run is not `completed`."""
    model = built_in("pendulum")
    coarse, fine = (simulate(model, scheme="single_rate", dt=dt, t_end=20.0) for dt in (0.1, 0.002))
    assert coarse.status.name == "inaccurate" and not coarse.status.ok and coarse.status.coordinate == "rod.theta"
    assert coarse.status.time == coarse.t[-1] == pytest.approx(20.0) and "take a smaller step" in coarse.stats["remark"]
    assert fine.status.ok and "remark" not in fine.stats


def test_the_estimate_costs_little(built_in: Load, monkeypatch: pytest.MonkeyPatch) -> None:
    """Steps taken besides those of the run: 15 in a hundred."""
    from runtime.schemes.stepper import Stepper

    taken, honest = [0], Stepper.run

    def counted(self: Stepper, z: np.ndarray, ready: np.ndarray, steps: int) -> None:
        taken[0] += steps
        honest(self, z, ready, steps)

    monkeypatch.setattr(Stepper, "run", counted)
    simulate(built_in("pendulum"), scheme="single_rate", dt=1e-3, t_end=2.0)
    assert 2000 < taken[0] <= 1.15 * 2000 + 1


def test_estimates_are_kept_by_checkpoints(built_in: Load, tmp_path: Path) -> None:
    model, settings = built_in("slider_crank"), {"scheme": "single_rate", "dt": 1e-3, "t_end": 0.4}

    def stop(t: float, t_end: float) -> None:
        if t > 0.2:
            raise KeyboardInterrupt

    whole = simulate(model, **settings)
    simulate(model, **settings, checkpoint=tmp_path / "run.npz", progress=stop)
    again = resume(model, tmp_path / "run.npz")
    key = f"estimated_error.{model.q_i[0]}"
    assert again.stats[key] == whole.stats[key] > 0


@pytest.mark.parametrize("damping", [1e4, 1e6])
def test_a_damper_too_stiff_for_the_step_is_named(model_of: Build, damping: float) -> None:
    """Right is 0.300 rad; central difference with predicted velocities comes to 0.29 and -0.24."""
    run = simulate(model_of(rod(damping)))
    assert not run.status.ok and run.balance.resolved and run.balance.largest > 10.0


def test_a_stiff_decay_that_a_scheme_follows_is_no_failure(model_of: Build) -> None:
    """The damper's power is gone within the first step, and the samples do not resolve it; the motion is right."""
    run = simulate(model_of(rod(1e4)), scheme="exponential")
    assert run.status.ok and run["rod.theta"][-1] == pytest.approx(0.3, abs=1e-3)


@pytest.mark.parametrize("width, said", [(1e-4, True), (1e-2, False)])
def test_a_load_between_the_steps_is_named(model_of: Build, width: float, said: bool) -> None:
    """A smooth pulse of 1000 N m between two ends of steps of 1 ms; a longer one is seen by the steps."""
    run = simulate(model_of(rod(kick=f"1000 * exp(-(((t - 0.50045) / {width})**2))")), t_end=0.7)
    assert [event.kind for event in run.events] == ["load_missed"] * said
    if said:
        assert run.events[0].time == pytest.approx(0.5, abs=1e-9) and "rod.theta" in run.events[0].text


def test_a_pulse_between_the_steps_is_not_missed(model_of: Build) -> None:
    """1000 N m for 0.5 ms, which steps of 1 ms would not see; steps end where it begins and ends."""
    model = model_of(rod(kick="where(t < 0.5002, 0, where(t < 0.5007, 1000, 0))"))
    coarse, fine = (simulate(model, t_end=0.7, dt=dt, scheme="rk4") for dt in (1e-3, 1e-4))
    assert coarse.events == [] and coarse["rod.theta"][-1] == pytest.approx(fine["rod.theta"][-1], abs=1e-9)


def test_a_jump_of_velocity_that_no_condition_tells_of_is_refused(model_of: Build) -> None:
    """A magnitude written as a root of a square."""
    with pytest.raises(ModelError, match=r"drive\.angle: its velocity jumps by 1 at t = 0\.50003 s"):
        simulate(model_of(driven("((t - 0.50003) ** 2 + 1e-40) ** 0.5")))
    for smooth in ("where(t < 0.5, 0, 2 * (t - 0.5) ** 2)", "sin(3 * t)"):
        assert simulate(model_of(driven(smooth))).status.ok


def test_what_symmetry_keeps_still_is_measured_by_what_moves(model_of: Build) -> None:
    """A mode at 1e-15 of another of its kind: relative to its own amplitude rounding would be all of its error."""
    builder = SceneBuilder("still")
    builder.structure(coordinates=["x", "y"], mass=[[1.0, 0.0], [0.0, 1.0]], stiffness=[[1.0, 0.0], [0.0, 9.0]])
    scene = builder.initial({"x": 1.0, "y": 1e-15}).simulation(t_end=6.0, dt=1e-2, scheme="single_rate").build()
    model = model_of(scene)
    assert floored(model, np.array([2.0, 1e-15])) == pytest.approx([2.0, 2e-6], rel=1e-12)
    assert floored(model, np.zeros(2)).tolist() == [1.0, 1.0]
    problem, _ = make_setting(model).quick(1e-3, 5.0)
    assert problem.amplitudes[1] == pytest.approx(1e-6 * problem.amplitudes[0], rel=1e-9)
    run = simulate(model)
    assert run.stats["estimated_error_of"] == "x" and "remark" not in run.stats


def test_a_mechanism_that_turns_is_late_by_its_energy(built_in: Load) -> None:
    """Sub-steps that win energy: the crank is ahead by 0.6 rad after ten turns, and the rod bends at other times.

    Positions of a window alone say 0.002 rad, 280 times too little.
    """
    model = built_in("flexible_slider_crank_torque")
    run = simulate(model, scheme="printed", dt=1e-4, m=[5], t_end=0.4, save_every=40)
    exact = reference_solution(model, t_end=float(run.t[-1]), times=run.t)
    true = np.abs(run.q_i - exact.q_i).max(axis=0)
    estimated = np.array([run.stats[f"estimated_error.{name}"] for name in model.q_i])
    assert true[0] > 0.5
    assert (estimated < WITHIN * true).all() and (true < WITHIN * estimated).all(), estimated / true


def test_equations_of_constants_only_are_stepped(model_of: Build) -> None:
    """A mass on a rail: an evaluation has no operation left, to which the price of a sub-step could be compared."""
    builder = SceneBuilder("rail").gravity(-9.81, 0.0).rigid("mass", mass=2.0, inertia=0.1)
    scene = builder.prismatic("rail", "ground.origin", "mass.origin").simulation(t_end=1.0, dt=0.1).build()
    run = simulate(model_of(scene), scheme="exponential")
    assert run["mass.x"][-1] == pytest.approx(-9.81 / 2, rel=1e-12) and "sub_step_cost" not in run.stats
