"""A differentiated run over another time is the run that is prepared there, with nothing compiled again."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from runtime import DifferentiableRun, Model

SETTINGS = {"scheme": "exponential_rk4", "samples": 5}


@pytest.mark.long
def test_over_another_time_and_number_of_steps(built_in: Callable[[str], Model]) -> None:
    model, names = built_in("hub_beam"), ["hub.theta", "hub.theta_dot"]  # its torque stops at 2 s
    by = ["hub.theta", "hub.inertia"]
    run = DifferentiableRun(model, names, by, t_end=1.0, dt=0.01, **SETTINGS)
    moved = run.over(1.5, 0.8)
    own = DifferentiableRun(model, names, by, t0=1.5, t_end=2.3, dt=0.008, **SETTINGS)
    assert np.allclose(moved.t, own.t, rtol=1e-14)
    assert np.array_equal(moved.values(moved.x0), own.values(own.x0))
    assert np.array_equal(moved.jacobian(moved.x0).derivatives, own.jacobian(own.x0).derivatives)
    finer = run.over(1.5, 0.8, steps=200)
    own = DifferentiableRun(model, names, by, t0=1.5, t_end=2.3, dt=0.004, scheme="exponential_rk4", seen_every=0.8)
    assert np.array_equal(finer.jacobian(finer.x0).derivatives, own.jacobian(own.x0).derivatives)
    assert np.array_equal(run.over(0.0, 1.0).values(run.x0), run.values(run.x0))


def test_with_other_parameters_and_outputs_on_the_way(built_in: Callable[[str], Model]) -> None:
    model, names, by = built_in("hub_beam"), ["hub.theta"], ["hub.theta_dot", "hub.inertia"]
    run = DifferentiableRun(model, names, by, t_end=1.0, dt=0.01, **SETTINGS)
    given = {"hub.inertia": 0.4, "beam.youngs_modulus": 6e10}
    moved = run.over(0.5, 0.8, steps=160, every=40, parameters=given)
    settings = {"t0": 0.5, "t_end": 1.3, "dt": 0.005, "scheme": "exponential_rk4", "seen_every": 0.2}
    own = DifferentiableRun(model, names, by, parameters=given, **settings)
    assert len(moved.t) == 5 and np.allclose(moved.t, own.t, rtol=1e-14)
    assert np.array_equal(moved.jacobian(moved.x0).derivatives, own.jacobian(own.x0).derivatives)
    assert not np.array_equal(run.over(0.5, 0.8, steps=160, every=40).values(run.x0), moved.values(moved.x0))
