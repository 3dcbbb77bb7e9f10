"""Motions that repeat against published numbers, closed forms and independent computations."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import root
from scipy.special import mathieu_a, mathieu_b

from runtime import ArgumentError, InitialStateError, Model, periodic, periodic_over, simulate
from runtime.gradients import Integral, Largest
from runtime.orbits.shooting import NoPeriodicMotion
from symgen.scene import Scene, SceneRecord

pytestmark = pytest.mark.long

Build = Callable[[SceneRecord], Model]
Load = Callable[[str], Model]
DUFFING = {"delta": 0.2, "alpha": 1.0, "beta": 1.0, "gamma": 0.3, "omega": 0.5}


def oscillator(name: str, force: str, start: tuple[float, float] = (0.0, 0.0), **parameters: float) -> SceneRecord:
    """1 kg on a rail under a force that may depend on x, x_dot and t."""
    builder = Scene(name).rigid("mass", mass=1.0, inertia=1.0)
    for key, value in parameters.items():
        builder.parameter(key, value)
    builder.prismatic("rail", "ground.origin", "mass.origin").measure("x", "x", "mass.origin")
    builder.force("f", "mass.origin", force, 0.0).initial({"mass.x": start[0]}).rates({"mass.x": start[1]})
    return builder.simulation(t_end=10.0, dt=1e-2, scheme="rk4").build()


@pytest.fixture(scope="module")
def van_der_pol(model_of: Build) -> Model:
    return model_of(oscillator("van_der_pol", "mu*(1-x*x)*x_dot-x", (2.0, 0.0), mu=1.0))


@pytest.fixture(scope="module")
def duffing(model_of: Build) -> Model:
    force = "-delta*x_dot-alpha*x-beta*x*x*x+gamma*cos(omega*t)"
    return model_of(oscillator("duffing", force, **DUFFING))


def harmonic_residual(omega: float, a: np.ndarray) -> np.ndarray:
    """Galerkin's equations of the Duffing oscillator for the coefficients of cos and sin of odd harmonics."""
    n, d = len(a) // 2, DUFFING
    orders = 2 * np.arange(n) + 1
    angles = np.outer(np.linspace(0.0, np.pi, 4 * n, endpoint=False), orders)
    waves = np.hstack([np.cos(angles), np.sin(angles)])
    rates = np.hstack([-np.sin(angles) * orders, np.cos(angles) * orders]) * omega
    x, bends = waves @ a, -(waves * np.tile(orders**2, 2)) @ a * omega**2
    force = bends + d["delta"] * rates @ a + d["alpha"] * x + d["beta"] * x**3
    return np.asarray(waves.T @ (force - d["gamma"] * waves[:, 0]))


def harmonic_balance(omega: float, guess: np.ndarray) -> np.ndarray:
    found = root(lambda a: harmonic_residual(omega, a), guess, tol=1e-13)
    assert np.abs(harmonic_residual(omega, found.x)).max() < 1e-11
    return np.asarray(found.x)


def test_van_der_pol_has_its_period_and_multipliers(van_der_pol: Model) -> None:
    """Period of Andersen & Geer (1982); the second multiplier is exp of the integral of mu (1 - x^2)."""
    found = periodic(van_der_pol, period="free", tolerance=1e-11, scheme="dop853")
    assert abs(found.period - 6.66328685932313) < 1e-10
    assert found.stability == "stable"
    assert found.error.largest <= 1e-11

    def motion(t: float, z: np.ndarray) -> list[float]:
        return [z[1], (1 - z[0] ** 2) * z[1] - z[0], 1 - z[0] ** 2]

    start = [*found.state.values(), 0.0]
    exponent = solve_ivp(motion, (0.0, found.period), start, "DOP853", rtol=1e-13, atol=1e-13).y[2, -1]
    assert found.floquet.multipliers[found.floquet.trivial] == pytest.approx(1.0, abs=1e-8)
    assert found.floquet.counted[0] == pytest.approx(np.exp(exponent), abs=1e-8)


def test_a_free_period_of_a_machine_that_turns_is_that_of_its_turns(model_of: Build) -> None:
    """J w' = T - c w - m g s cos(angle) of a rotor out of balance: its turn by another integrator; without a guess."""
    J, T, c, m, g, s = 0.5, 8.0, 0.4, 3.0, 9.81, 0.2
    scene = (
        Scene("unbalanced")
        .gravity(0.0, -g)
        .rigid("rotor", mass=m, inertia=J - m * s**2, center_of_mass=(s, 0.0))
        .revolute("axle", "ground.origin", "rotor.origin", damping=c)
        .torque("motor", "rotor.origin", T)
        .rates({"rotor.theta": 15.0})
        .simulation(t_end=4.0)
        .build()
    )

    def turn(w: float) -> tuple[float, float]:
        """Time and rate at the end of a turn that begins at the angle 0 with w; over the angle, as w stays above 0."""
        run = solve_ivp(
            lambda a, z: [1 / z[1], (T - c * z[1] - m * g * s * np.cos(a)) / (J * z[1])],
            (0.0, 2 * np.pi), [0.0, w], "DOP853", rtol=1e-12, atol=1e-13,
        )  # fmt: skip
        return float(run.y[0, -1]), float(run.y[1, -1])

    w = 20.0
    for _ in range(400):
        w = turn(w)[1]
    found = periodic(model_of(scene), period="free", tolerance=1e-9)
    assert found.period == pytest.approx(turn(w)[0], rel=1e-8) and found.stability == "stable"
    assert found.turns == {"rotor.theta": 1}
    two = periodic(model_of(scene), period="free", turns=2, tolerance=1e-9)
    assert two.period == pytest.approx(2 * turn(w)[0], rel=1e-8)


def test_a_branch_of_free_periods(van_der_pol: Model) -> None:
    """Periods at mu = 3 of Zonneveld (1966). At mu = 0 every amplitude is a motion, and beyond all are unstable."""
    branch = periodic_over(van_der_pol, "mu", (1.0, 3.0), period="free", scheme="dop853", steps=400)
    assert branch.periods[-1] == pytest.approx(8.85909550, abs=5e-9) and set(branch.stability) == {"stable"}
    through = periodic_over(van_der_pol, "mu", (1.0, -0.5), period="free", scheme="dop853", steps=200)
    (special,) = through.specials
    assert special.kind.startswith("stability changes") and abs(special.value) < 0.1
    assert through.stability[0] == "stable" and through.stability[-1] == "unstable"


def test_where_stability_changes_is_told_between_the_points_around(model_of: Build) -> None:
    """At d = 3 every amplitude is a motion, so that nothing can be located: the place is told to half a step."""
    model = model_of(oscillator("shifted", "(d-3)*(1-x*x)*x_dot-x", (2.0, 0.0), d=4.0))
    branch = periodic_over(model, "d", (4.0, 2.5), period="free", scheme="dop853", steps=200)
    (special,) = branch.specials
    assert not branch.stopped and branch.values[-1] == pytest.approx(2.5, abs=1e-12)
    k = branch.stability.index("unstable")
    below, above = sorted(branch.values[k - 1 : k + 1])
    assert below < 3 < above and above - below < 0.5
    assert below < special.value < above and special.kind.startswith("stability changes")


def test_duffing_through_both_folds_is_that_of_harmonic_balance(duffing: Model) -> None:
    branch = periodic_over(duffing, "omega", (1.0, 1.6), speed="omega", tolerance=1e-9, scheme="dop853")
    folds = [one for one in branch.specials if one.kind == "fold"]
    assert len(folds) == 2 and not branch.stopped
    assert branch.stability.count("unstable") >= 3
    for k in np.linspace(1, len(branch.points) - 2, 7).astype(int):
        state = branch.points[k].x[0]
        guess = np.zeros(30)
        guess[0], guess[15] = state[0], state[1] / branch.values[k]
        a = harmonic_balance(branch.values[k], guess)
        assert a[:15].sum() == pytest.approx(state[0], abs=1e-8)
    for fold in folds:  # there two solutions of harmonic balance meet: the amplitude has an infinite slope
        assert _fold_of_harmonic_balance(fold.value, fold.state) == pytest.approx(fold.value, abs=1e-6)


def _fold_of_harmonic_balance(omega: float, state: np.ndarray) -> float:
    """Where Galerkin's equations hold and their Jacobian J is singular: g = 0 in [[J, u], [v^T, 0]] [w, g] = [0, 1]."""

    def jacobian(omega: float, a: np.ndarray) -> np.ndarray:
        steps = 1e-30j * np.eye(len(a))
        return np.column_stack([harmonic_residual(omega, a + step).imag / 1e-30 for step in steps])

    guess = np.zeros(30)
    guess[0], guess[15] = state[0], state[1] / omega
    a = root(lambda a: harmonic_residual(omega, a), guess, method="lm", tol=1e-13).x  # near the fold: no root is sure
    left, _, right = np.linalg.svd(jacobian(omega, a))
    border = np.append(np.zeros(len(a)), 1.0)

    def off(y: np.ndarray) -> np.ndarray:
        inner = jacobian(float(y[-1]), y[:-1])
        bordered = np.block([[inner, left[:, -1:]], [right[-1:], np.zeros((1, 1))]])
        return np.append(harmonic_residual(float(y[-1]), y[:-1]), np.linalg.solve(bordered, border)[-1])

    found, steps = np.append(a, omega), 1e-6 * np.eye(31)
    for _ in range(8):
        slopes = np.column_stack([(off(found + step) - off(found - step)) / 2e-6 for step in steps])
        found -= np.linalg.solve(slopes, off(found))
    assert np.abs(off(found)).max() < 1e-10
    return float(found[-1])


@pytest.mark.parametrize(("tongue", "edge"), [(1, "a"), (1, "b"), (2, "a"), (2, "b"), (3, "b")])
def test_edges_of_mathieu_tongues(model_of: Build, tongue: int, edge: str) -> None:
    """x'' + (a - 2 q cos 2t) x = 0 at q = 1: a multiplier is +1 or -1 on the edge, and the pair leaves the circle."""
    a = float((mathieu_a if edge == "a" else mathieu_b)(tongue, 1.0))
    model = model_of(oscillator("mathieu", "-(a-2*q*cos(2*t))*x", a=1.0, q=1.0))
    sign = 1.0 if tongue % 2 == 0 else -1.0

    def trace(value: float) -> float:
        found = periodic(model, period=np.pi, parameters={"a": value}, scheme="dop853", steps=200)
        assert np.linalg.det(found.found.shot.monodromy) == pytest.approx(1.0, abs=1e-11)
        return float(np.trace(found.found.shot.monodromy)) - 2 * sign

    step = 1e-4
    slope = (trace(a + step) - trace(a - step)) / (2 * step)
    assert trace(a) / slope == pytest.approx(0.0, abs=1e-8)


def test_a_jeffcott_rotor_has_the_response_by_hand(model_of: Build) -> None:
    """m r'' + c r' + k r = m e w^2 exp(i w t), a circle; with a tangential force k_t unstable above c sqrt(k/m)."""
    mass, k, c, e, omega = 2.0, 800.0, 6.0, 1e-3, 15.0
    builder = Scene("jeffcott").rigid("disk", mass=mass, inertia=1.0, free=True)
    for name, value in {"k": k, "c": c, "e": e, "omega": omega, "k_t": 0.0}.items():
        builder.parameter(name, value)
    builder.measure("x", "x", "disk.origin").measure("y", "y", "disk.origin").measure("a", "coordinate", "disk.theta")
    builder.force("shaft", "disk.origin", "-k*x-c*x_dot-k_t*y", "-k*y-c*y_dot+k_t*x")
    push = f"{mass}*e*omega*omega"
    builder.force("unbalance", "disk.origin", f"{push}*cos(omega*t)", f"{push}*sin(omega*t)")
    builder.torque("hold", "disk.origin", "-100*a-20*a_dot")
    model = model_of(builder.simulation(t_end=1.0, dt=1e-3, scheme="rk4").build())
    found = periodic(model, speed="omega", tolerance=1e-11, scheme="dop853")
    r = mass * e * omega**2 / (k - mass * omega**2 + 1j * c * omega)
    assert found.state["disk.x"] == pytest.approx(r.real, abs=1e-9 * abs(r))
    assert found.state["disk.y"] == pytest.approx(r.imag, abs=1e-9 * abs(r))
    assert found.stability == "stable"
    threshold = c * np.sqrt(k / mass)
    branch = periodic_over(model, "k_t", (0.9 * threshold, 1.1 * threshold), period=2 * np.pi / omega, scheme="dop853")
    (leaves,) = [one for one in branch.specials if one.kind == "Neimark-Sacker"]
    assert leaves.value == pytest.approx(threshold, rel=1e-9)


def test_a_flexible_four_bar_repeats_as_the_end_of_a_long_run(model_of: Build) -> None:
    model = model_of(driven_four_bar())
    found = periodic(model, speed="omega", tolerance=1e-9)
    settings = {"scheme": found.scheme, "dt": found.period / found.steps, "error": "off"}
    run = simulate(model, initial=found.state, t_end=40 * found.period, seen_every=found.period, **settings)
    late = run.q[-1, [model.coordinates.index(name) for name in model.q_i]]
    off = [found.state[name] for name in model.q_i] - late
    assert np.abs(off).max() < 1e-8 * np.abs(found.solution.q[:, model.coordinates.index(model.q_i[0])]).max()
    free = periodic(model, speed="omega", start={}, settle=5, steps=found.steps)
    assert list(free.state.values()) == pytest.approx(list(found.state.values()), rel=1e-7, abs=1e-12)


def test_without_damping_a_motion_is_neutral(built_in: Load) -> None:
    """The multipliers are on the unit circle; how far steps put them beside it is seen with other steps."""
    model = built_in("flexible_slider_crank")
    coarse, fine = (periodic(model, speed="omega", steps=steps) for steps in (200, 1600))
    assert coarse.stability == fine.stability == "neutral" and coarse.remarks() == []
    assert abs(coarse.floquet.largest - 1) > 1e-5 > abs(fine.floquet.largest - 1)
    assert fine.floquet.margin < coarse.floquet.margin / 20


def driven_four_bar() -> SceneRecord:
    """A crank at 300 rpm drives a flexible coupler with damping, and a rigid rocker."""
    builder = Scene("driven_four_bar").parameter("omega", 10 * np.pi, "rad/s").gravity(0, -9.81)
    builder.ground(markers={"right": {"position": (0.30, 0)}})
    builder.rigid("crank", mass=0.8, inertia=4e-3, markers={"tip": {"position": (0.10, 0)}})
    builder.parameter("height", 0.004, "m")
    builder.beam(
        "coupler", length=0.30, density=7850.0, area="0.012*height", second_moment="0.001*height*height*height",
        youngs_modulus=2.1e11, lateral={"ends": "pinned-pinned", "modes": 2}, damping_ratio=0.02,
    )  # fmt: skip
    builder.rigid("rocker", mass=0.1, inertia=6e-4, center_of_mass=(0.12, 0), markers={"end": {"position": (0.25, 0)}})
    builder.revolute("A", "ground.origin", "crank.origin").revolute("B", "crank.tip", "coupler.start")
    builder.revolute("C", "coupler.end", "rocker.end").revolute("D", "ground.right", "rocker.origin")
    builder.prescribed_angle("drive", "ground.origin", "crank.origin", motion="omega * t")
    return builder.initial({"coupler.theta": 0.9, "rocker.theta": 1.9}).simulation(t_end=0.2, dt=1e-4).build()


def test_gradients_of_what_repeats_are_those_of_differences(model_of: Build, duffing: Model) -> None:
    found = periodic(duffing, speed="omega", steps=240, scheme="dop853")
    of = Integral("mass.x", squared=True)
    slopes = found.gradient(of, ["gamma", "beta", "omega"])
    for name in slopes.by:
        values, step = [], 1e-4
        for sign in (1, -1):
            moved = {name: DUFFING[name] + sign * step}
            run = periodic(duffing, speed="omega", steps=240, scheme="dop853", parameters=moved, start=found)
            solution = run.simulate(1, seen_every=0.0)
            values.append(of.weighed(solution.t, solution.q[:, [0]])[0])
        assert slopes[name] == pytest.approx((values[0] - values[1]) / (2 * step), rel=1e-6)


def test_a_gradient_is_of_the_motion_under_its_inputs(model_of: Build) -> None:
    """x = u / k + X cos(2 t + phase), X^2 = 1 / ((k - 4)^2 + 4 c^2): the integral of x^2 over pi, and its slope."""
    builder = Scene("pushed").parameter("k", 3.0, "N/m").parameter("c", 0.4, "N s/m").input("u", 0.0, "N")
    builder.rigid("mass", mass=1.0, inertia=1.0).prismatic("rail", "ground.origin", "mass.origin")
    builder.measure("x", "x", "mass.origin").force("f", "mass.origin", "u - k*x - c*x_dot + cos(2*t)", 0.0)
    model = model_of(builder.simulation(t_end=10.0, dt=1e-2, scheme="single_rate").build())
    found = periodic(model, period=np.pi, inputs={"u": 0.7}, steps=200, scheme="dop853")
    slope, own = found.gradient(Integral("x", squared=True), ["k"]), (3.0 - 4.0) ** 2 + 4 * 0.4**2
    assert slope.value == pytest.approx(np.pi * (0.49 / 9.0 + 0.5 / own), rel=1e-6)
    assert slope["k"] == pytest.approx(np.pi * (-2 * 0.49 / 27.0 + 1.0 / own**2), rel=1e-6)


def test_an_unstable_motion_is_known_as_well_as_a_stable_one(model_of: Build) -> None:
    """x'' = 16 x + cos(2 t) has x = -cos(2 t) / 20; what is beside it grows by exp(4 pi) in a period."""
    found = periodic(model_of(oscillator("falling", "16*x+cos(2*t)")), period=np.pi, tolerance=1e-9, scheme="dop853")
    assert found.x == pytest.approx([-1 / 20, 0.0], abs=1e-10) and found.error.largest < 1e-9
    assert found.floquet.largest == pytest.approx(np.exp(4 * np.pi), rel=1e-6) and found.stability == "unstable"


def test_multiple_shooting_finds_what_single_shooting_finds(van_der_pol: Model) -> None:
    one = periodic(van_der_pol, period="free", steps=240, scheme="dop853")
    many = periodic(van_der_pol, period="free", steps=240, scheme="dop853", parts=4)
    assert many.period == pytest.approx(one.period, rel=1e-12)
    assert np.abs(many.floquet.multipliers) == pytest.approx(np.abs(one.floquet.multipliers), abs=1e-9)


def test_a_branch_goes_on_where_it_was_stopped(duffing: Model) -> None:
    how = {"speed": "omega", "steps": 100, "scheme": "rk4"}
    whole = periodic_over(duffing, "omega", (0.5, 1.0), **how)

    def stop(value: float, end: float) -> None:
        if value > 0.7:
            raise KeyboardInterrupt

    part = periodic_over(duffing, "omega", (0.5, 1.0), progress=stop, **how)
    assert part.stopped == "interrupted" and 0.7 < part.values[-1] < 1.0
    motion = periodic(duffing, speed="omega", parameters={"gamma": 0.2, "omega": 0.5}, steps=100, scheme="rk4")
    weaker = periodic_over(duffing, "omega", (0.5, 0.6), start=motion, **how)
    assert weaker.points[0].x == pytest.approx(motion.found.shot.x, abs=1e-9)  # of the motion's own parameters
    rest = periodic_over(duffing, "omega", (0.5, 1.0), start=part)
    assert not rest.stopped and rest.values[-1] == pytest.approx(whole.values[-1])
    assert rest.points[-1].x == pytest.approx(whole.points[-1].x, abs=1e-9)


def test_wrong_questions_are_refused_by_name(duffing: Model, model_of: Build, tmp_path: Path) -> None:
    with pytest.raises(ArgumentError, match="period"):
        periodic(duffing)
    with pytest.raises(ArgumentError, match=r"-1.*positive number of seconds"):
        periodic(duffing, period=-1)
    with pytest.raises(ArgumentError, match="sped"):
        periodic(duffing, speed="sped")
    with pytest.raises(ArgumentError, match="nothing turns"):
        periodic(duffing, speed="omega", parameters={"omega": 0.0})
    with pytest.raises(NoPeriodicMotion, match="do not repeat after 3"):
        periodic(duffing, period=3.0)
    beaten = oscillator("beaten", "-x-x_dot+cos(2*t)+0.003*cos(2.5*t)")  # together they repeat after 4 pi only
    with pytest.raises(NoPeriodicMotion, match="do not repeat after 3.14"):
        periodic(model_of(beaten), period=np.pi)
    assert periodic(model_of(beaten), period=4 * np.pi).stability == "stable"
    with pytest.raises(NoPeriodicMotion, match=r"leaves mass\.x.* open by"):  # it comes to drift by 1 m/s for ever
        periodic(model_of(oscillator("drifting", "1+cos(2*t)-x_dot")), period=np.pi)
    with pytest.raises(InitialStateError, match="mass.z"):
        periodic(duffing, speed="omega", start={"mass.z": 1.0})
    with pytest.raises(ArgumentError, match="spun"):
        periodic_over(duffing, "spun", (1, 2), speed="omega")
    with pytest.raises(ArgumentError, match="nothing"):
        periodic(duffing, speed="omega").gradient(Largest("mass.x"), ["nothing"])
