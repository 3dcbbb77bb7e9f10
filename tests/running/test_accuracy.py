"""What runs say of their own error, against an independent reference: the true error, the told one, the status."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.linalg import eigh

from runtime import Model, ModelError, Sampled, Solution, reference_solution, simulate
from runtime.contract.coordinates import followed
from runtime.results.motion_error import floored
from runtime.running.comparison_times import common_steps, comparison_steps, coprime
from symgen.scene import Scene, SceneRecord
from tests.support.scenes import driven_bob, on_hinge

pytestmark = pytest.mark.long

Load = Callable[[str], Model]
Build = Callable[[SceneRecord], Model]
Law = Callable[[float, float, float], float]
WITHIN = 10.0
TUMBLING = {"body.omega_x": 0.01, "body.omega_y": 5.0, "body.omega_z": 0.01}  # about the middle axis: flips for ever
OVER_THE_TOP = {"upper.theta": 3.0, "lower.theta": 2.5}


def relative_error(run: Solution, exact: np.ndarray) -> float:
    """RMS over the motion of the worst coordinate, over its RMS amplitude; exact: (N, n) of what tells the motion."""
    off = np.sqrt(np.mean((run.q[:, followed(run.model)[1]] - exact) ** 2, axis=0))
    return float((off / floored(run.model, exact.std(axis=0))).max())


# ---- a rod with unit inertia under one torque, whose equation is integrated here
# -------------------------------------


@dataclass(frozen=True)
class Rod:
    """theta'' = law(t, theta, theta') from `start`; runs: scheme, steps, status, and whether an error is told."""

    torque: str
    law: Law
    start: tuple[float, float]
    t_end: float
    runs: Sequence[tuple[str, int, str]]
    method: str = "DOP853"

    def scene(self) -> SceneRecord:
        builder = on_hinge("rod", "rod", "pin", mass=1.0, inertia=1.0).measure("a", "coordinate", "rod.theta")
        builder.torque("drive", "rod.origin", self.torque)
        builder.initial({"rod.theta": self.start[0]}).rates({"rod.theta": self.start[1]})
        return builder.simulation(t_end=self.t_end, dt=0.01, scheme="rk4").build()

    def exact(self, t: np.ndarray) -> np.ndarray:
        """(N, 1) at times t."""
        found = solve_ivp(
            lambda t, y: [y[1], self.law(t, y[0], y[1])],
            (t[0], t[-1]),
            self.start,
            t_eval=t,
            method=self.method,
            max_step=(t[-1] - t[0]) / 1000,
            rtol=1e-10,
            atol=1e-13,
        )
        return np.asarray(found.y[0])[:, None]


def stop(t: float, a: float, v: float) -> float:
    return -10 * np.sin(a) + (2000 * (-1.2 - a) if a < -1.2 else 0.0)


RODS = {
    "elastic stop": Rod(
        "-10*sin(a) + where(a < -1.2, 2000*(-1.2 - a), 0)",
        stop,
        (1.5, 0.0),
        5.0,
        [
            ("rk4", 25, "inaccurate"),
            ("rk4", 100, "inaccurate"),
            ("rk4", 1000, "completed"),
            ("single_rate", 400, "completed"),
            ("exponential", 100, "completed"),
        ],
    ),
    "one-sided spring": Rod(
        "-10*sin(a) - 1e5*max(0, a - 0.2)",
        lambda t, a, v: -10 * np.sin(a) - 1e5 * max(0.0, a - 0.2),
        (-1.0, 0.0),
        2.0,
        [("rk4", 500, "completed"), ("rk4", 2000, "completed"), ("exponential", 500, "completed")],
    ),
    "dry friction": Rod(
        "-10*sin(a) - 2*tanh(a_dot/0.001)",
        lambda t, a, v: -10 * np.sin(a) - 2 * np.tanh(v / 0.001),
        (1.0, 0.0),
        2.0,
        [("exponential", 200, "completed"), ("exponential", 1000, "completed")],
        "Radau",
    ),
    "kinked damper": Rod(
        "-10*a - 50*abs(a)*a_dot",
        lambda t, a, v: -10 * a - 50 * abs(a) * v,
        (1.0, 0.0),
        3.0,
        [("rk4", 100, "completed"), ("exponential", 60, "completed"), ("single_rate", 300, "completed")],
    ),
    "parametric resonance": Rod(
        "-(4 + 3*cos(4*t))*a - 0.05*a**3",
        lambda t, a, v: -(4 + 3 * np.cos(4 * t)) * a - 0.05 * a**3,
        (0.1, 0.0),
        40.0,
        [("rk4", 400, "inaccurate"), ("exponential", 400, "completed")],
    ),
    "unstable": Rod(
        "a", lambda t, a, v: a, (1e-3, 0.0), 7.0, [("single_rate", 350, "completed"), ("rk4", 20, "completed")]
    ),
    "creep": Rod(
        "-1e3*a_dot - 1e3*sin(a)",
        lambda t, a, v: -1e3 * v - 1e3 * np.sin(a),
        (1.0, 0.0),
        3.0,
        [
            ("radau", 30, "completed"),
        ],
        "Radau",
    ),
    "force at like phases": Rod(
        "0.2*cos(t) + 2*sin(31.41592653589793*t)**8",
        lambda t, a, v: 0.2 * np.cos(t) + 2 * np.sin(10 * np.pi * t) ** 8,
        (0.0, 0.0),
        2.0,
        [("rk4", 40, "inaccurate"), ("exponential", 40, "inaccurate"), ("single_rate", 200, "completed")],
    ),
}


@pytest.mark.parametrize("name", RODS)
def test_a_rod_whose_equation_is_known(model_of: Build, name: str) -> None:
    rod = RODS[name]
    model = model_of(rod.scene())
    for scheme, steps, status in rod.runs:
        run = simulate(model, scheme=scheme, dt=rod.t_end / steps, seen_every=0.0)
        true = relative_error(run, rod.exact(run.t)) if run.status.name in ("completed", "inaccurate") else np.nan
        assert run.status.name == status, (scheme, steps, true, run.error.largest, run.status)
        if true > 0.5:
            assert run.error.largest > 0.1
        elif run.error.measured:
            assert true / WITHIN < run.error.largest < true * WITHIN, (scheme, steps, true, run.error.largest)
        assert true < 0.1 or "remark" in run.stats or status == "inaccurate"


# ---- mechanisms, against SciPy's DOP853 at 1e-11
# ---------------------------------------------------------------------

MECHANISMS: list[tuple[str, float, dict[str, Any], str]] = [
    ("pendulum", 5.0, {"scheme": "rk4", "dt": 0.25}, "completed"),
    ("pendulum", 20.0, {"scheme": "single_rate", "dt": 0.1}, "completed"),
    ("slider_crank", 0.5, {"scheme": "single_rate", "dt": 1e-3}, "completed"),
    ("two_oscillators", 10.0, {"scheme": "coupled", "m": [4], "dt": 0.05}, "completed"),
    ("flexible_slider_crank", 0.05, {"scheme": "radau", "dt": 2e-4}, "completed"),
    ("flexible_slider_crank_torque", 0.4, {"scheme": "printed", "m": [5], "dt": 1e-4}, "inaccurate"),
    ("tumbling_body", 20.0, {"scheme": "rk4", "dt": 2e-2, "initial": TUMBLING}, "completed"),
    ("double_pendulum", 10.0, {"scheme": "exponential", "dt": 2e-2, "initial": OVER_THE_TOP}, "inaccurate"),
    ("double_pendulum", 1.0, {"scheme": "rk4", "dt": 1 / 39}, "completed"),
    ("four_bar", 0.3, {"scheme": "rk4", "dt": 0.01}, "completed"),
]


@pytest.mark.parametrize(("name", "t_end", "settings", "status"), MECHANISMS)
def test_a_mechanism(built_in: Load, name: str, t_end: float, settings: dict[str, Any], status: str) -> None:
    """Energy that is won by sub-steps, a body that flips, long steps on stiff joints: what is lost is told."""
    model = built_in(name)
    run = simulate(model, t_end=t_end, samples=100, **settings)
    if name == "flexible_joint_arm":
        exact = simulate(model, scheme="dop853", t_end=t_end, dt=1.25e-3, seen_every=0.2, error="off")
    else:
        exact = reference_solution(model, t_end=float(run.t[-1]), times=run.t, initial=settings.get("initial"))
    names, columns = followed(model)
    off = np.sqrt(np.mean((run.q - exact.q)[:, columns] ** 2, axis=0))
    moves = off > 1e-13
    told = np.array([run.error.over_motion[one] for one in names])
    assert run.status.name == status, (run.status, run.error.largest)
    assert (told[moves] < WITHIN * off[moves]).all() and (off[moves] < WITHIN * told[moves]).all(), told / off


def test_behind_two_singular_positions(built_in: Load) -> None:
    """Of long steps, against order 8 with a tenth of them."""
    model = built_in("n_four_bar")
    exact = simulate(model, scheme="dop853", dt=1e-3, t_end=3.0, seen_every=0.03, error="off")
    for scheme in ("rk4", "single_rate"):
        run = simulate(model, scheme=scheme, dt=7.5e-3, t_end=3.0, seen_every=0.03)
        true = relative_error(run, exact.q[:, followed(model)[1]])
        assert run.status.ok and len(run.events) == len(exact.events) > 1
        assert true / WITHIN < run.error.largest < true * WITHIN


def held() -> SceneRecord:
    """An upright rod that a sampled torque holds."""
    builder = Scene("held").gravity(0, -9.81).input("u")
    builder.rigid("rod", mass=1.0, center_of_mass=(0.5, 0), inertia=0.1)
    builder.revolute("pin", "ground.origin", "rod.origin").torque("motor", "rod.origin", "u")
    return builder.initial({"rod.theta": 1.2}).simulation(t_end=4.0, dt=1e-2, scheme="rk4").build()


def controller(memory: Sequence[float] | None) -> Sampled:
    """Proportional, differential and, by what it remembers, integral."""
    own = np.zeros(1)

    def hold(t: float, seen: np.ndarray, total: np.ndarray = own) -> float:
        total[0] += 0.02 * (seen[0] - np.pi / 2)
        return float(-20.0 * (seen[0] - np.pi / 2) - 5.0 * seen[1] - 10.0 * total[0])

    return Sampled(hold, 0.02, reads=("rod.theta", "rod.theta_dot"), memory=memory)


def test_a_controller_with_a_memory_is_set_back(model_of: Build) -> None:
    """So that the motion can be made twice; one whose memory is its own cannot, and the run says why."""
    model = model_of(held())
    fine = simulate(model, dt=1e-3, seen_every=0.02, inputs={"u": controller([0.0])})
    run = simulate(model, dt=2e-2, seen_every=0.0, inputs={"u": controller([0.0])})
    true = relative_error(run, fine.q[:, followed(model)[1]])
    assert run.status.ok and true / WITHIN < run.error.largest < true * WITHIN
    alone = simulate(model, dt=2e-2, inputs={"u": controller(None)})
    assert alone.status.ok and not alone.error.measured and "memory" in str(alone.stats["error_not_measured"])
    assert alone["rod.theta"][-1] == pytest.approx(run["rod.theta"][-1], abs=1e-12)


# ---- what belongs to the measurement -----------------------------------------------------------------------------


def test_a_tolerance_resolves_a_fast_mode_that_nothing_damps(built_in: Load) -> None:
    """Levels that leave it out agree to what it moves, 7e-3: the refinement goes on where steps resolve it."""
    w, asked = 10000.0, 1e-5
    parameters, initial = {"c": 0.5, "k_L": 1.0, "w": w, "zeta": 0.0}, {"x_L": 1.0, "x_S": 0.0}
    run = simulate(built_in("two_oscillators"), t_end=4.0, parameters=parameters, initial=initial, tolerance=asked)
    frequencies, shapes = eigh(np.diag([1.0, w**2]), np.array([[1.0, 0.5], [0.5, 1.0]]))
    size = shapes.T @ np.array([[1.0, 0.5], [0.5, 1.0]]) @ [1.0, 0.0]
    exact = (shapes @ (size[:, None] * np.cos(np.outer(np.sqrt(frequencies), run.t)))).T
    assert run.status.ok and run.error.largest < asked and relative_error(run, exact) < asked


@pytest.mark.parametrize("order", [2, 4, 5, 8])
@pytest.mark.parametrize("steps", [1, 2, 3, 7, 20, 39, 100, 1000, 99_991])
def test_numbers_of_steps_without_a_common_divisor(steps: int, order: int) -> None:
    """From some ten steps on the companion's steps are 2^(1/p) as long, to a tenth, and most of the run is
    compared.
    """
    ratio = 2 ** (1 / order)
    a = common_steps(steps, ratio)
    b = coprime(a, ratio)
    assert np.gcd(a, b) == 1 and a != b and a <= steps
    if steps >= 10:
        assert a / b == pytest.approx(ratio, rel=0.1) and steps % a <= 0.1 * steps
    at = comparison_steps(steps, a)
    assert (np.diff(at) > 0).all() and at[0] >= a and at[-1] == steps - steps % a and (at % a == 0).all()


@pytest.mark.parametrize(("dt", "t_end"), [(0.1, 0.2), (0.1, 4.0), (0.02, 4.0)])
def test_steps_that_vary_are_measured_by_another_tolerance(built_in: Load, dt: float, t_end: float) -> None:
    """Whatever the number of samples, which are not the steps."""
    model = built_in("pendulum")
    run = simulate(model, scheme="dopri5", tolerance=1e-5, seen_every=dt, t_end=t_end, options={"error_of": "step"})
    true = relative_error(run, reference_solution(model, t_end=t_end, times=run.t).q[:, followed(model)[1]])
    assert run.status.ok and true / WITHIN < run.error.largest < max(WITHIN * true, 1e-8)


def test_a_measured_error_does_not_depend_on_what_is_kept(built_in: Load, tmp_path: Any) -> None:
    model, settings = built_in("pendulum"), {"scheme": "single_rate", "dt": 0.01, "t_end": 3.0}
    whole = simulate(model, **settings, seen_every=0.0)
    for few in ({"outputs": ["rod.theta"]}, {"stream": tmp_path / "rows"}, {"samples": 1}):
        run = simulate(model, **settings, **few)  # type: ignore[arg-type]
        assert run.error.over_motion == whole.error.over_motion and run.status.ok
    off = simulate(model, **settings, error="off", seen_every=0.0)
    assert not off.error.measured and off.error.reason and np.array_equal(off.q, whole.q)


def test_a_step_too_long_is_said(built_in: Load) -> None:
    """single_rate with 14 steps a swing: no other check has anything to say; the run is not `completed`."""
    model = built_in("pendulum")
    coarse, fine = (simulate(model, scheme="single_rate", dt=dt, t_end=20.0) for dt in (0.15, 0.002))
    assert coarse.status.name == "inaccurate" and not coarse.status.ok and coarse.status.coordinate == "rod.theta"
    assert coarse.t[-1] >= 20.0 and "smaller step" in coarse.status.advice
    assert fine.status.ok and "remark" not in fine.stats


def test_the_price_is_less_than_that_of_the_run(built_in: Load, monkeypatch: pytest.MonkeyPatch) -> None:
    """Steps taken besides those of the run: 0.71 of them by order 2, 0.84 by order 4, and a fifth where it damps."""
    from runtime.engine.native import NativeProgram

    taken, honest = [0], NativeProgram.run_rows

    def counted(self: NativeProgram, z: np.ndarray, c: np.ndarray, counts: np.ndarray, rows: np.ndarray) -> None:
        taken[0] += int(counts.sum())
        honest(self, z, c, counts, rows)

    monkeypatch.setattr(NativeProgram, "run_rows", counted)
    for scheme, more in (("single_rate", 0.71), ("rk4", 0.84 + 0.2)):
        taken[0] = 0
        simulate(built_in("pendulum"), scheme=scheme, dt=1e-3, t_end=2.0)
        assert taken[0] == pytest.approx((1 + more) * 2000, rel=0.03)


def test_ctrl_c_while_an_error_is_measured_leaves_the_run(built_in: Load, monkeypatch: pytest.MonkeyPatch) -> None:
    from runtime.running import outcome

    def pressed(*_: object, **__: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(outcome, "compared", pressed)
    run = simulate(built_in("pendulum"), scheme="single_rate", dt=0.01, t_end=1.0)
    assert run.status.ok and run.t[-1] == pytest.approx(1.0) and "user" in run.error.reason


def test_what_turns_on_is_judged_modulo_a_turn(model_of: Build) -> None:
    """A rotor at 100 rad/s that comes late by 0.3 rad: of a thousand radians little, of a turn too much."""
    model = model_of(Rod("cos(a)*30", lambda t, a, v: 0.0, (0.0, 100.0), 10.0, []).scene())
    run = simulate(model, scheme="single_rate", dt=0.012, seen_every=0.0)
    exact = reference_solution(model, t_end=float(run.t[-1]), times=run.t)
    late = float(np.sqrt(np.mean((run.q - exact.q) ** 2)))
    assert run.error.amplitude["rod.theta"] == pytest.approx(np.pi / np.sqrt(3))
    assert late / WITHIN < run.error.over_motion["rod.theta"] < late * WITHIN
    assert run.error.relative["rod.theta"] == pytest.approx(run.error.over_motion["rod.theta"] / (np.pi / np.sqrt(3)))


def test_what_symmetry_keeps_still_is_measured_by_what_moves(model_of: Build) -> None:
    """A mode at 1e-15 of another of its kind: relative to its own amplitude rounding would be all of its error."""
    builder = Scene("still")
    builder.structure(coordinates=["x", "y"], mass=[[1.0, 0.0], [0.0, 1.0]], stiffness=[[1.0, 0.0], [0.0, 9.0]])
    scene = builder.initial({"x": 1.0, "y": 1e-15}).simulation(t_end=6.0, dt=1e-2, scheme="single_rate").build()
    model = model_of(scene)
    assert floored(model, np.array([2.0, 1e-15])) == pytest.approx([2.0, 2e-6], rel=1e-12)
    assert floored(model, np.zeros(2)).tolist() == [1.0, 1.0]
    run = simulate(model)
    assert run.error.of == "x" and "remark" not in run.stats


# ---- things that happen between the steps --------------------------------------------------------------------------


def rod(damping: float = 0.0, kick: str | None = None) -> SceneRecord:
    """A rod on a hinge, 0.3 rad and 1 rad/s; inertia about the hinge 0.35 kg m2."""
    builder = Scene("rod").gravity(0, -9.81).rigid("rod", mass=1.0, inertia=0.1, center_of_mass=(0.5, 0))
    builder.revolute("pin", "ground.origin", "rod.origin", damping=damping)
    if kick is not None:
        builder.torque("kick", "rod.origin", kick)
    builder.initial({"rod.theta": 0.3}).rates({"rod.theta": 1.0})
    return builder.simulation(t_end=1.0, dt=1e-3, scheme="single_rate").build()


def driven(motion: str) -> SceneRecord:
    """A bob on the tip of a crank that a prescribed angle turns."""
    builder = driven_bob("driven", motion).gravity(0, -9.81).initial({"bob.theta": -1.57})
    return builder.simulation(t_end=1.0, dt=1e-3, scheme="single_rate").build()


def test_a_rate_that_is_lost_is_told_though_the_place_is_right(model_of: Build) -> None:
    """1e8 N m s stop the rod at once; steps of 1 ms leave rates that change their signs, 0.26 rad/s in the end."""
    run = simulate(model_of(rod(1e8)), scheme="exponential")
    assert run["rod.theta"][-1] == pytest.approx(0.3, abs=1e-6) and abs(run["rod.theta_dot"][-1]) > 0.1
    assert (
        run.error.judged["rod.theta_dot"] > 0.5 and run.status.name == "inaccurate"
    )  # of its size, which is all error


@pytest.mark.parametrize("damping", [1e4, 1e6, 1e8])
def test_a_damper_too_stiff_for_the_step_is_named(model_of: Build, damping: float) -> None:
    """Right is 0.300 rad; central difference with predicted velocities comes to 0.29 and -0.24."""
    run = simulate(model_of(rod(damping)))
    assert not run.status.ok and run.balance.resolved and run.balance.largest > 10.0


def test_a_stiff_decay_that_a_scheme_follows_is_no_failure(model_of: Build) -> None:
    """The damper's power is gone within the first step, and the samples do not resolve it; the motion is right."""
    run = simulate(model_of(rod(1e4)), scheme="exponential")
    assert run.status.ok and run["rod.theta"][-1] == pytest.approx(0.3, abs=1e-3)


@pytest.mark.parametrize("width", [1e-4, 1e-2])
def test_a_load_between_the_steps_is_seen(model_of: Build, width: float) -> None:
    """A smooth pulse of 1000 N m between two ends of steps of 1 ms, and a longer one."""
    model = model_of(rod(kick=f"1000 * exp(-(((t - 0.50045) / {width})**2))"))
    coarse, fine = (simulate(model, scheme="rk4", t_end=0.7, dt=dt, error="off") for dt in (1e-3, 2e-5))
    assert coarse.events == [] and coarse["rod.theta"][-1] == pytest.approx(fine["rod.theta"][-1], rel=1e-4)


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


def test_equations_of_constants_only_are_stepped(model_of: Build) -> None:
    """A mass on a rail: an evaluation has no operation left."""
    builder = Scene("rail").gravity(-9.81, 0.0).rigid("mass", mass=2.0, inertia=0.1)
    scene = (
        builder.prismatic("rail", "ground.origin", "mass.origin")
        .simulation(t_end=1.0, dt=0.1, scheme="printed")
        .build()
    )
    run = simulate(model_of(scene), scheme="exponential")
    assert run["mass.x"][-1] == pytest.approx(-9.81 / 2, rel=1e-12)
