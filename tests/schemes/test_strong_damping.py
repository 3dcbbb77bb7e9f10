"""A decay far faster than the step: the creep that is left is right, or the run says by name that it is not."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from runtime import simulate
from runtime.model import Model
from symgen.scene import SceneRecord

pytestmark = pytest.mark.long

Build = Callable[[SceneRecord], Model]
ANGLE, DT, T_END = 0.3, 1e-3, 1.0
WEIGHT_ARM = 9.81 * 0.5  # m g l of a uniform rod of 1 kg and 1 m

PENDULUM = """
name = "strong_damper"
gravity = [0.0, -9.81]

[parameters]
D = { default = 1e4, unit = "N m s/rad" }

[initial]
coordinates."rod.theta" = 0.3

[[bodies]]
type = "rigid"
name = "rod"
mass = 1.0
inertia = 0.08333333333333333
center_of_mass = [0.5, 0.0]

[[joints]]
type = "revolute"
name = "hinge"
marker_a = "ground.origin"
marker_b = "rod.origin"
damping = "D"
"""


def creep(damping: float, rate: float) -> float:
    """theta(T_END) of D theta' = -m g l cos(theta), after the fast transient has turned by rate I / D.

    With s = sin(theta): s' = -(m g l / D) (1 - s^2), so artanh(s) falls linearly in time.
    """
    start = ANGLE + rate * (1 / 3) / damping
    return float(np.arcsin(np.tanh(np.arctanh(np.sin(start)) - WEIGHT_ARM / damping * T_END)))


@pytest.mark.parametrize("rate", [0.0, -1.0])
@pytest.mark.parametrize("damping", [1e4, 1e6, 1e8])
@pytest.mark.parametrize("scheme", ["single_rate", "exponential", "radau"])
def test_strong_damping_is_right_or_named(model_of: Build, scheme: str, damping: float, rate: float) -> None:
    """Positions within 1e-4 rad of the creep and rates that have died out, or another status than completed.

    `inaccurate` is right too, but of a creep that is short itself: an error of its own size is one of 1e-6 rad.
    """
    run = simulate(
        model_of(SceneRecord.from_toml_text(PENDULUM)),
        scheme=scheme,
        t_end=T_END,
        dt=DT,
        parameters={"D": damping},
        initial={"rod.theta_dot": rate},
        seen_every=10 * DT,
    )
    if run.status.name == "inaccurate":
        assert rate or (scheme == "single_rate" and np.ptp(run.q_i) < 1e-3)
    elif run.balance.resolved and run.balance.largest > damping / 100:
        # a decay too fast for any step to see leaves a rate that does not die out: the balance of energy tells it
        assert rate and scheme in ("single_rate", "exponential")
    elif run.status.ok:
        assert run.q_i[-1, 0] == pytest.approx(creep(damping, rate), abs=1e-4)
        assert abs(run.q_dot[-1, run.model.independent_columns[0]]) < 1e-2
    else:
        assert run.status.name in ("diverged", "step_too_long", "iteration_failed")
        advice, decays = run.status.advice, damping * 3  # D / (m l^2 / 3)
        assert f"decay at {decays:.3g} 1/s" in advice and "radau" in advice and "propagation = decaying" in advice
        assert rate  # without a transient there is nothing to fail on


@pytest.mark.parametrize("damping", [1e4, 1e6, 1e8])
def test_radau_lets_every_decay_die_out(model_of: Build, damping: float) -> None:
    run = simulate(
        model_of(SceneRecord.from_toml_text(PENDULUM)),
        scheme="radau",
        t_end=T_END,
        dt=DT,
        parameters={"D": damping},
        initial={"rod.theta_dot": -1.0},
        seen_every=10 * DT,
    )
    assert run.status.name == "completed"
    assert run.q_i[-1, 0] == pytest.approx(creep(damping, -1.0), abs=1e-6)


@pytest.mark.parametrize("rate", [0.0, -1.0])
@pytest.mark.parametrize("damping", [1e4, 1e6, 1e8])
@pytest.mark.parametrize("scheme", ["exponential"])
def test_decaying_propagation_lets_every_decay_die_out(
    model_of: Build, scheme: str, damping: float, rate: float
) -> None:
    """With the symmetric approximation such a decay rings on, and the run is named."""
    run = simulate(
        model_of(SceneRecord.from_toml_text(PENDULUM)),
        scheme=scheme,
        options={"propagation": "decaying"},
        t_end=T_END,
        dt=DT,
        parameters={"D": damping},
        initial={"rod.theta_dot": rate},
        seen_every=10 * DT,
    )
    assert run.status.name == "completed"
    assert run.q_i[-1, 0] == pytest.approx(creep(damping, rate), abs=1e-6)
    assert abs(run.q_dot[-1, run.model.independent_columns[0]]) < 1e-2
