"""Motions that are unstable in themselves: what a run says of its error, and until when it can be relied on."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import cast

import numpy as np
import pytest

from runtime import Model, Sampled, Solution, reference_solution, resume, simulate
from runtime.contract.coordinates import followed
from runtime.results.amplitudes import floored
from runtime.running.carried_error import CarriedError
from runtime.running.followed_steps import follow_steps, follows_steps
from runtime.running.plan import make_plan
from runtime.running.segment import Segment
from runtime.start.start_state import start_state
from symgen.scene import Scene, SceneBuilder
from symgen.scenes import SCENES

Load = Callable[[str], Model]
Build = Callable[[Scene], Model]
WITHIN = 10.0
TUMBLING = {"body.omega_x": 0.01, "body.omega_y": 5.0, "body.omega_z": 0.01}  # about the middle axis: flips for ever
OVER_THE_TOP = {"upper.theta": 3.0, "lower.theta": 2.5}


def errors(run: Solution, initial: dict[str, float]) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """(true errors on the way relative to the amplitudes (N, n), true and estimated ones of what moves)."""
    model = run.model
    names, columns = followed(model)
    exact = reference_solution(model, t_end=float(run.t[-1]), times=run.t, initial=initial)
    off = np.abs(run.q - exact.q)[:, columns]
    moves = off.max(axis=0) > 0
    estimated = np.array([run.stats[f"estimated_error.{name}"] for name in names])
    relative = off / floored(model, np.ptp(exact.q[:, columns], axis=0) / 2)
    return relative, off.max(axis=0)[moves], estimated[moves]


@pytest.mark.parametrize(
    "scheme, dt, off",
    [("linearised", 5e-3, 0.38), ("exponential", 2e-2, 0.06), ("radau", 2e-2, 2.5e-3), ("rk4", 2e-2, 2.5e-6)],
)
def test_errors_of_a_tumbling_body_are_known(built_in: Load, scheme: str, dt: float, off: float) -> None:
    """Windows alone say 3e-4, 1.5e-6 and 3e-9 of the first three, and rk4's errors grow no more than they say."""
    settings = {"t_end": 20.0, "initial": TUMBLING, "save_every": 10}
    run = simulate(built_in("tumbling_body"), scheme=scheme, dt=dt, **settings)
    relative, true, estimated = errors(run, TUMBLING)
    assert true.max() == pytest.approx(off, rel=0.1)
    assert (estimated < WITHIN * true).all() and (true < WITHIN * estimated).all(), estimated / true
    late = run.t[(relative > 0.03).any(axis=1)]
    if off > 0.03:
        assert "unstable in itself" in str(run.stats["remark"])
        assert float(run.stats["reliable_until"]) == pytest.approx(late[0], abs=1.0)
    else:
        assert len(late) == 0 and "reliable_until" not in run.stats and "remark" not in run.stats


@pytest.mark.parametrize(
    ("scheme", "tolerance", "error_of", "off"),
    [
        ("dopri5", 1e-3, "motion", (1e-4, 5e-3)),  # 1600 to 2400 times too much was said, and good until 7.2 s
        ("dopri5", 1e-6, "motion", (1e-7, 5e-6)),  # 1400 to 2800 times
        ("exponential_rk4", 1e-4, "step", (1.0, 3.0)),  # 0.03 of it, of a run that was lost and `completed`
    ],
)
def test_errors_of_a_tumbling_body_are_known_with_a_tolerance(
    built_in: Load, scheme: str, tolerance: float, error_of: str, off: tuple[float, float]
) -> None:
    settings = {"dt": 0.1, "t_end": 20.0, "initial": TUMBLING, "options": {"error_of": error_of}}
    run = simulate(built_in("tumbling_body"), scheme=scheme, tolerance=tolerance, **settings)
    relative, true, estimated = errors(run, TUMBLING)
    assert off[0] < true.max() < off[1]
    assert (estimated < WITHIN * true).all() and (true < WITHIN * estimated).all(), estimated / true
    lost = off[1] > 0.1
    assert run.status.name == ("inaccurate" if lost else "completed") and ("reliable_until" in run.stats) == lost
    if lost:
        late = run.t[(relative > 0.03).any(axis=1)][0]
        assert float(run.stats["reliable_until"]) == pytest.approx(late, abs=1.0)


def test_errors_of_a_double_pendulum_are_known_with_a_tolerance(built_in: Load) -> None:
    settings = {"t_end": 10.0, "initial": OVER_THE_TOP, "dt": 0.05}
    for error_of in ("motion", "step"):
        chosen = {"tolerance": 1e-3, "options": {"error_of": error_of}}
        run = simulate(built_in("double_pendulum"), scheme="dopri5", **chosen, **settings)  # type: ignore[arg-type]
        relative, true, estimated = errors(run, OVER_THE_TOP)
        if error_of == "motion":
            rms = float(np.sqrt(np.mean(relative**2, axis=0)).max())
            assert 1e-4 < rms < 3e-3 and true.max() < 0.05 and rms / 10 < float(run.stats["expected_error"]) < 10 * rms
    assert true.max() > 0.1 and (estimated < WITHIN * true).all() and (true < WITHIN * estimated).all()
    assert float(run.stats["reliable_until"]) == pytest.approx(run.t[(relative > 0.03).any(axis=1)][0], abs=2.0)


@pytest.mark.parametrize("scheme, dt, said", [("exponential", 1e-2, True), ("rk4", 5e-3, False)])
def test_errors_of_a_double_pendulum_are_known(built_in: Load, scheme: str, dt: float, said: bool) -> None:
    """Thrown over the top: 0.3 rad and 0.004 rad off after ten seconds."""
    settings = {"t_end": 10.0, "initial": OVER_THE_TOP, "save_every": 10}
    run = simulate(built_in("double_pendulum"), scheme=scheme, dt=dt, **settings)
    relative, true, estimated = errors(run, OVER_THE_TOP)
    assert (estimated < WITHIN * true).all() and (true < WITHIN * estimated).all(), estimated / true
    assert ("reliable_until" in run.stats) == said == bool((relative > 0.03).any())


def falling() -> Scene:
    """x'' = x from x = 1: cosh t."""
    builder = SceneBuilder("falling")
    builder.structure(coordinates=["x"], mass=[[1.0]], stiffness=[[-1.0]]).initial({"x": 1.0})
    return builder.simulation(t_end=8.0, dt=0.02, scheme="single_rate").build()


def test_the_error_of_a_linear_fall_is_that_of_central_differences(model_of: Build) -> None:
    """x_n = cosh(mu n h), sinh(mu h / 2) = h / 2: at t = 8 s the error is 8 sinh(8) h^2 / 24, 0.2 m."""
    h, run = 0.02, simulate(model_of(falling()))
    mu = 2 * np.arcsinh(h / 2) / h
    true = abs(np.cosh(mu * 8.0) - np.cosh(8.0))
    assert run.status.ok  # the energy of a spring that pushes is negative, and no failure
    assert abs(run["x"][-1] - np.cosh(8.0)) == pytest.approx(true, rel=1e-6)
    assert run.stats["estimated_error.x"] == pytest.approx(true, rel=0.2)


@pytest.mark.parametrize(
    "name", ["slider_crank", "four_bar", "flexible_slider_crank_torque", "near_singular_slider_crank"]
)
def test_what_turns_and_does_not_grow_is_not_called_unstable(built_in: Load, name: str) -> None:
    """Linearised at an instant all of them grow; carried along, their errors do not, and are known within 3 times."""
    run = simulate(built_in(name), save_every=50)
    _, true, estimated = errors(run, {})
    assert run.status.ok and "error_growth" not in run.stats and "reliable_until" not in run.stats
    assert (estimated < 3 * true).all() and (true < 3 * estimated).all(), estimated / true


def test_a_neighbour_is_left_where_the_run_goes_back() -> None:
    """The search for a singular position may take a run back behind a mark: minus eleven steps cannot be followed."""
    carried, segment = CarriedError(100), cast(Segment, SimpleNamespace(step_of=lambda z: int(z[0])))
    carried.z = np.array([99.0])
    carried.follow(segment, np.array([99.0]), np.array([88.0]))
    assert carried.z is None


def test_what_is_carried_goes_on_after_a_checkpoint(built_in: Load, tmp_path: Path) -> None:
    """Between two looks: bit for bit, for steps of one length and for others."""
    model, settings = built_in("tumbling_body"), {"t_end": 20.0, "initial": TUMBLING}

    def stop(t: float, t_end: float) -> None:
        if t > 7.3:
            raise KeyboardInterrupt

    for choice in ({"scheme": "single_rate", "dt": 5e-3}, {"scheme": "exponential", "tolerance": 1e-4, "dt": 0.05}):
        whole = simulate(model, **settings, **choice)
        broken = simulate(model, **settings, **choice, checkpoint=tmp_path / "run.npz", progress=stop)
        assert broken.status.name == "interrupted"
        with np.load(tmp_path / "run.npz") as kept:
            assert {"record_neighbour", "record_judged"} <= set(kept.files)
        again = resume(model, tmp_path / "run.npz")
        keys = [key for key in whole.stats if key.startswith(("estimated_error.", "error_growth", "reliable_until"))]
        assert len(keys) > 6 and all(again.stats[key] == whole.stats[key] for key in keys)


def test_an_error_that_is_lost_is_not_forgotten(built_in: Load) -> None:
    """Long steps on stiff joints: 3.9 of an amplitude off, and what the neighbour said was dropped for 0.004."""
    run = simulate(built_in("flexible_joint_arm"), scheme="linearised", t_end=20.0, dt=0.0125, save_every=8)
    assert run.status.name == "inaccurate" and float(run.stats["estimated_error"]) > 0.1
    assert 1.0 < float(run.stats["reliable_until"]) < 10.0 and "is lost" in str(run.stats["remark"])
    one, other = CarriedError(100), CarriedError(100)
    one.lost = True
    other.resume(one.memory(), {})
    assert other.lost


def test_a_neighbour_takes_the_steps_of_a_run_that_watches_events(built_in: Load, model_of: Build) -> None:
    """Stiff joints: steps of its own erred by more than it was beside, and all of the range was said of right runs.

    One event never happens, the other ends steps on the way.
    """
    data, quiet = SCENES["flexible_joint_arm"]().to_dict(), built_in("flexible_joint_arm")
    data["measures"] = [{"type": "coordinate", "name": "a", "coordinate": "link1.theta"}]
    data["events"] = {"never": {"when": "a + 50"}, "passes": {"when": "a + 1"}}
    run = simulate(model_of(Scene.from_dict(data)), scheme="exponential", tolerance=1e-4)
    each = round(float(run.t[1]) / 2.5e-4)
    exact = simulate(quiet, scheme="dop853", dt=float(run.t[1]) / each, save_every=each)
    assert exact.t == pytest.approx(run.t)
    own, right = (one.q[:, followed(quiet)[1]] for one in (run, exact))
    true = float((np.abs(own - right).max(axis=0) / np.ptp(right, axis=0) * 2).max())
    assert len(run.events) > 0 and run.status.ok and true < 1e-3
    assert true / WITHIN < float(run.stats["estimated_error"]) < WITHIN * true and "reliable_until" not in run.stats


def swung() -> Scene:
    """theta'' = -(s + e cos(f t)) theta - 0.05 theta^3 about a pin."""
    builder = SceneBuilder("swung").rigid("rod", mass=1.0, inertia=1.0)
    builder.parameter("s", 4.0).parameter("e", 3.0).parameter("f", 4.0)
    builder.revolute("pin", "ground.origin", "rod.origin").measure_coordinate("a", "rod.theta")
    builder.torque("drive", "rod.origin", "-(s + e*cos(f*t))*a - 0.05*a**3").initial({"rod.theta": 0.1})
    return builder.simulation(t_end=40.0, dt=0.1, scheme="rk4").build()


@pytest.mark.parametrize(("scheme", "dt", "off"), [("rk4", 0.1, 0.33), ("exponential", 0.1, 0.056)])
def test_parametric_resonance_is_seen(model_of: Build, scheme: str, dt: float, off: float) -> None:
    """Every eigenvalue is imaginary at all times, and errors grow 14 to 33 times: 1e-4 was said."""
    model = model_of(swung())
    run, exact = simulate(model, scheme=scheme, dt=dt), simulate(model, dt=0.01, save_every=10)
    true = float(np.abs(run["rod.theta"] - exact["rod.theta"]).max() / (np.ptp(exact["rod.theta"]) / 2))
    assert true == pytest.approx(off, rel=0.1) and run.status.name == ("inaccurate" if off > 0.1 else "completed")
    assert true / 3 < float(run.stats["estimated_error"]) < 3 * true and "reliable_until" in run.stats


@pytest.mark.parametrize(("f", "followed"), [(1.0, False), (40.0, True)])
def test_slow_changes_drive_no_mode(model_of: Build, monkeypatch: pytest.MonkeyPatch, f: float, followed: bool) -> None:
    """Of 20 rad/s, changed by a quarter: beside it slow ones cost no neighbour, those of twice its frequency do."""
    from runtime.schemes.stepper import Stepper

    model, taken, honest = model_of(swung()), [0], Stepper.run

    def counted(self: Stepper, z: np.ndarray, ready: np.ndarray, steps: int) -> None:
        taken[0] += steps
        honest(self, z, ready, steps)

    monkeypatch.setattr(Stepper, "run", counted)
    simulate(model, scheme="rk4", dt=2e-3, t_end=4.0, parameters={"s": 400.0, "e": 100.0, "f": f})
    assert (taken[0] > 2.4 * 2000) if followed else (taken[0] < 1.3 * 2000)


def test_a_motion_that_grows_costs_twice_and_a_half_its_steps(built_in: Load, monkeypatch: pytest.MonkeyPatch) -> None:
    """Its own, the neighbour's, half as many of double length, and the windows' 15 in a hundred."""
    from runtime.schemes.stepper import Stepper

    taken, honest = [0], Stepper.run

    def counted(self: Stepper, z: np.ndarray, ready: np.ndarray, steps: int) -> None:
        taken[0] += steps
        honest(self, z, ready, steps)

    monkeypatch.setattr(Stepper, "run", counted)
    simulate(built_in("double_pendulum"), scheme="single_rate", dt=1e-3, t_end=2.0, initial=OVER_THE_TOP)
    assert 2.4 * 2000 < taken[0] <= 2.7 * 2000


def test_what_a_controller_holds_is_not_called_unstable(model_of: Build) -> None:
    """An inverted pendulum that a sampled torque holds: what the controller would do beside the run is not known."""
    builder = (
        SceneBuilder("held").gravity(0, -9.81).input("u").rigid("rod", mass=1.0, center_of_mass=(0.5, 0), inertia=0.1)
    )
    builder.revolute("pin", "ground.origin", "rod.origin").torque("motor", "rod.origin", "u")
    builder.initial({"rod.theta": 1.5}).simulation(t_end=20.0, dt=1e-2, scheme="rk4")
    hold = Sampled(lambda t, y: -20.0 * (y[0] - np.pi / 2) - 5.0 * y[1], 0.02, reads=("rod.theta", "rod.theta_dot"))
    run = simulate(model_of(builder.build()), inputs={"u": hold})
    assert run["rod.theta"][-1] == pytest.approx(np.pi / 2, abs=1e-6) and "remark" not in run.stats


def test_a_neighbour_takes_the_steps_of_the_run(built_in: Load) -> None:
    """Where they vary: what it differs by is in proportion to what it differed by."""
    model = built_in("double_pendulum")
    options = {"tolerance": 1e-3, "error_of": "step"}
    plan = make_plan(model, 2.0, 0.05, None, "dopri5", 1, options, 0.0, False)
    p = model.parameter_vector(None)
    segment = Segment.build(model, plan, p, "auto")
    state = start_state(model, p, segment.c, 0.0, OVER_THE_TOP, None)
    z, own = segment.start(state.q, state.q_dot), plan.scheme.layout.slice
    segment.run(z, 10)
    before, beside = z.copy(), z.copy()
    segment.run(z, 20)
    assert follows_steps(segment, z) and z[own("accepted")] > before[own("accepted")] + 5
    same = follow_steps(segment, before, z, before.copy())
    assert same is not None and same[own("x")] == pytest.approx(z[own("x")], rel=1e-13, abs=1e-13)
    moved = []
    for offset in (1e-6, 1e-8):  # small steps of a controller would be seen: they do not shrink with the offset
        beside = before.copy()
        for name in ("x", "q_to"):
            beside[own(name)] += offset
        found = follow_steps(segment, before, z, beside)
        assert found is not None
        moved.append((found[own("x")] - z[own("x")]) / offset)
    assert moved[1] == pytest.approx(moved[0], rel=1e-4) and np.abs(moved[0]).max() > 1.0
