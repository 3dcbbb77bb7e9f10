"""The tolerance is that of the motion: what trials of all of it tell before a run."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from runtime import simulate
from runtime.contract.model import Model
from runtime.running.trials import Trials
from runtime.running.tried_motion import SEEN, TrialRuns
from tests.support.prepared_runs import PreparedRuns

Load = Callable[[str], Model]
UNDAMPED = {"c": 0.5, "k_L": 1.0, "w": 8.0, "zeta": 0.0}


@pytest.mark.parametrize(
    ("name", "scheme", "settings", "step_error"),
    [
        ("two_oscillators", "dopri5", {"parameters": UNDAMPED, "initial": {"x_S": 1.0}, "t_end": 800.0}, (3.0, 1e3)),
        ("overdamped_joint", "exponential_rk4", {"t_end": 3.0}, (0.0, 0.3)),
    ],
)
def test_the_tolerance_is_that_of_the_motion(
    built_in: Load, name: str, scheme: str, settings: dict[str, object], step_error: tuple[float, float]
) -> None:
    """Errors of steps add up over 1000 undamped periods and die out in a damper: trials allow for both."""
    model, tolerance = built_in(name), 1e-4
    settings |= {"dt": float(settings["t_end"]) / 200, "save_every": 1}  # type: ignore[arg-type]
    exact = simulate(model, scheme="dop853", **{**settings, "dt": settings["dt"] / 200, "save_every": 200}).q_i  # type: ignore
    delivered = {}
    for error_of in ("motion", "step"):
        run = simulate(model, scheme=scheme, tolerance=tolerance, options={"error_of": error_of}, **settings)  # type: ignore
        delivered[error_of] = float((np.sqrt(np.mean((run.q_i - exact) ** 2, axis=0)) / exact.std(axis=0)).max())
        told = run.stats.get("trials", 0), run.stats.get("expected_error", 0.0)
        assert (told == (0, 0.0)) == (error_of == "step")
        assert (run.stats["step_tolerance"] == tolerance, run.stats["steady_step"] == 0) == (error_of == "step",) * 2
    assert 0.1 * tolerance < delivered["motion"] < 3 * tolerance
    assert step_error[0] * tolerance < delivered["step"] < step_error[1] * tolerance


def test_trials_tell_amplitudes_before_the_first_step(built_in: Load) -> None:
    """An arm begins with small vibrations: with the amplitudes of all of its motion it takes fewer steps."""
    runs = PreparedRuns(built_in("flexible_joint_arm"), "exponential_rk4", options={"tolerance": 1e-3})
    z = runs.stepper.start(0.0, runs.state.q, runs.state.q_dot, runs.c, 0.5 / SEEN)
    trials = TrialRuns(runs.stepper, z, runs.c, 0.5, [])
    first = trials.of_tolerance(1e-2, None)
    assert first is not None
    taken = [
        one.steps for one in (trials.of_tolerance(1e-3, first), trials.of_tolerance(1e-3, None)) if one is not None
    ]
    assert taken[0] < 0.8 * taken[1]


def test_a_start_from_rest_is_no_delay(built_in: Load) -> None:
    """The arm's first step from rest is long; an error of its little energy is not taken for one of all the motion."""
    run = simulate(built_in("flexible_joint_arm"), scheme="exponential_rk4", tolerance=1e-4)
    assert run.status.ok and float(run.stats["estimated_error"]) < 1e-3


def test_trials_have_a_budget(built_in: Load) -> None:
    """A motion whose trials would take more than it tells nothing but about how long they would be."""
    runs = PreparedRuns(built_in("pendulum"), "dopri5", options={"tolerance": 1e-4})
    z = runs.stepper.start(0.0, runs.state.q, runs.state.q_dot, runs.c, 10.0 / SEEN)
    whole = Trials(TrialRuns(runs.stepper, z, runs.c, 10.0, []))
    assert whole.calibration(1e-4) is not None and whole.runs.tries >= 3
    short = Trials(TrialRuns(runs.stepper, z, runs.c, 10.0, [], budget=0.3 * whole.expected))
    assert short.calibration(1e-4) is None and short.runs.tries == 1
    assert 0.5 * whole.expected < short.expected < 2 * whole.expected
