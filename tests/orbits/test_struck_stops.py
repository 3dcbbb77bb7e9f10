"""Motions that repeat with stops in them: the closed form of flight and contact, and what is refused."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from scipy.linalg import expm
from scipy.optimize import fsolve

from runtime import Model, ModelError, periodic, periodic_over
from runtime.gradients import Integral
from symgen.scene import Scene, SceneRecord

Build = Callable[[SceneRecord], Model]
M, K, C, PUSH, OMEGA, GAP, STIFF = 1.0, 4.0, 0.3, 2.0, 2.5, 0.2, 2e3


def hammer() -> SceneRecord:
    """A mass on a spring, pushed by a cosine, that strikes a stop a hundred times as stiff."""
    builder = Scene("hammer").parameter("omega", OMEGA, "rad/s").parameter("push", PUSH, "N")
    builder.rigid("mass", mass=M, inertia=1.0).parameter("stiff", STIFF, "N/m")
    builder.prismatic("rail", "ground.origin", "mass.origin", limits={"upper": GAP, "stiffness": "stiff"})
    builder.measure("x", "x", "mass.origin")
    builder.force("f", "mass.origin", f"-{K}*x - {C}*x_dot + push*cos(omega*t)", 0.0)
    return builder.simulation(t_end=5.0, dt=1e-3, scheme="rk4").build()


def phase(stiffness: float, rest: float, z: np.ndarray, t0: float, t: float) -> np.ndarray:
    """(x, x') at t from z at t0 of M x'' + C x' + (K + stiffness) x - stiffness rest = PUSH cos."""
    k = K + stiffness
    A = np.array([[0.0, 1.0], [-k / M, -C / M]])

    def forced(at: float) -> np.ndarray:
        X = PUSH / (k - M * OMEGA**2 + 1j * C * OMEGA) * np.exp(1j * OMEGA * at)
        return np.array([X.real + stiffness * rest / k, (1j * OMEGA * X).real])

    return np.asarray(expm(A * (t - t0)) @ (z - forced(t0)) + forced(t))


def by_hand(guess: list[float]) -> tuple[np.ndarray, np.ndarray, float]:
    """(state at the time 0, multipliers, duration of the contact): enters at t1 with v, leaves at t2.

    The force is continuous where the mass meets the stop, so tangents go through and the monodromy is the product of
    the exponentials of both phases.
    """
    T = 2 * np.pi / OMEGA

    def open_(y: np.ndarray) -> list[float]:
        t1, v, t2 = y
        out = phase(STIFF, GAP, np.array([GAP, v]), t1, t2)
        back = phase(0.0, 0.0, out, t2, t1 + T)
        return [out[0] - GAP, back[0] - GAP, back[1] - v]

    t1, v, t2 = fsolve(open_, guess, xtol=1e-13)
    assert np.abs(open_([t1, v, t2])).max() < 1e-12
    out = phase(STIFF, GAP, np.array([GAP, v]), t1, t2)
    free, held = (np.array([[0.0, 1.0], [-(K + s) / M, -C / M]]) for s in (0.0, STIFF))
    multipliers = np.linalg.eigvals(expm(free * (T - (t2 - t1))) @ expm(held * (t2 - t1)))
    return phase(0.0, 0.0, out, t2, T * np.ceil(t2 / T)), multipliers, t2 - t1


@pytest.fixture(scope="module")
def hammering(model_of: Build) -> Model:
    return model_of(hammer())


def test_a_stop_is_struck_once_a_period_as_by_hand(hammering: Model) -> None:
    z, multipliers, contact = by_hand([0.02, 1.6, 0.09])
    found = periodic(hammering, speed="omega", tolerance=1e-9, scheme="dop853", settle=10)
    assert found.x == pytest.approx(z, abs=1e-10)
    assert np.sort_complex(found.floquet.multipliers) == pytest.approx(np.sort_complex(multipliers), abs=1e-9)
    x = found.simulate(1, seen_every=0.0)["x"]
    assert (x > GAP).mean() * found.period == pytest.approx(contact, abs=2 * found.period / found.steps)


@pytest.mark.long
def test_gradients_cross_the_stop(hammering: Model) -> None:
    how, of = {"speed": "omega", "steps": 400, "scheme": "dop853"}, Integral("x", squared=True)
    found = periodic(hammering, settle=10, **how)
    slopes = found.gradient(of, ["push", "stiff", "omega"])
    for name, value in (("push", PUSH), ("stiff", STIFF), ("omega", OMEGA)):
        values = []
        for sign in (1, -1):
            moved = periodic(hammering, **how, parameters={name: value * (1 + sign * 1e-5)}, start=found)
            run = moved.simulate(1, seen_every=0.0)
            values.append(of.weighed(run.t, run["x"][:, None])[0])
        assert slopes[name] == pytest.approx((values[0] - values[1]) / (2e-5 * value), rel=1e-5), name


@pytest.mark.long
def test_a_stop_comes_into_a_branch_where_the_amplitude_meets_it(hammering: Model) -> None:
    """Without contact x is A cos, A = push / |K - M w^2 + i C w|, until A = GAP; then A grows less."""
    per_newton = 1 / abs(K - M * OMEGA**2 + 1j * C * OMEGA)
    met = GAP / per_newton
    branch = periodic_over(hammering, "push", (0.5 * met, 1.5 * met), speed="omega", steps=200, scheme="dop853")
    largest = branch.largest("x")
    free = branch.values < 0.999 * met
    assert largest[free] == pytest.approx(per_newton * branch.values[free], rel=1e-3)  # of 200 samples
    assert (largest[branch.values > 1.1 * met] < 0.98 * per_newton * branch.values[branch.values > 1.1 * met]).all()


def test_an_event_that_ends_the_run_is_refused_by_name(model_of: Build) -> None:
    ending = Scene("ending").parameter("omega", OMEGA).rigid("mass", mass=M, inertia=1.0)
    ending.prismatic("rail", "ground.origin", "mass.origin").measure("x", "x", "mass.origin")
    ending.force("f", "mass.origin", "cos(omega*t) - x_dot", 0.0).event("there", "x - 0.1", terminal=True)
    with pytest.raises(ModelError, match="there"):
        periodic(model_of(ending.simulation(t_end=1.0, dt=1e-3, scheme="rk4").build()), speed="omega")
