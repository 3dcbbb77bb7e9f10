"""Elastic coordinates that follow a driven motion without vibrating, against statics."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from runtime import ModelError, SchemeError, quasi_static_motion
from runtime.model import Model
from symgen.scene import Scene, SceneRecord

Build = Callable[[SceneRecord], Model]
Load = Callable[[str], Model]


def swung_beam() -> SceneRecord:
    """A cantilever of 1 m on a drive: theta = a t^2 / 2."""
    return (
        Scene("swung_beam")
        .parameter("a", 0.5, "rad/s^2", "angular acceleration")
        .beam("beam", length=1.0, density=2700.0, area=4e-5, second_moment=1.3e-11, youngs_modulus=7e10,
              lateral={"ends": "clamped-free", "modes": 8})
        .revolute("pivot", "ground.origin", "beam.start")
        .prescribed_angle("drive", "ground.origin", "beam.start", motion="a * t**2 / 2")
        .measure("tip_y", "y", of="beam.end")
        .simulation(t_end=0.02, dt=0.01, scheme="printed")
        .build()
    )  # fmt: skip


@pytest.mark.long
def test_inertia_bends_as_statics_has_it(model_of: Build) -> None:
    """Hand: a load rho A a x deflects the tip by 11 rho A a L^5 / (120 E I); the motor gives a J = rho A a L^3 / 3."""
    model = model_of(swung_beam())
    solution = quasi_static_motion(model)
    load = 2700.0 * 4e-5 * 0.5
    assert solution["tip_y"][0] == pytest.approx(-11 * load / (120 * 7e10 * 1.3e-11), rel=1e-4)
    assert solution.motor("drive")[0] == pytest.approx(load / 3, rel=1e-4)
    assert not solution["beam.q1_ddot"].any() and solution.status.ok


def test_rates_are_those_of_the_equilibria(built_in: Load) -> None:
    """Law: the elastic rates are the slope of the elastic coordinates along the motion, fourth-order differences."""
    solution = quasi_static_motion(built_in("flexible_slider_crank"), t_end=4e-4, seen_every=1e-5)
    for name in ("rod.q1", "rod.q3"):
        q, h = solution[name], 1e-5
        slope = (8 * (q[3:-1] - q[1:-3]) - (q[4:] - q[:-4])) / (12 * h)
        np.testing.assert_allclose(solution.rate(name)[2:-2], slope, rtol=0, atol=1e-6 * np.abs(slope).max())
    assert np.abs(solution.constraint_error).max() < 1e-12


def test_wrong_requests(model_of: Build, built_in: Load) -> None:
    with pytest.raises(ModelError, match="moves freely in hub.theta"):
        quasi_static_motion(built_in("hub_beam"))
    with pytest.raises(SchemeError, match="seen_every must be a time"):
        quasi_static_motion(model_of(swung_beam()), seen_every=-1.0)
