"""Motions by tables of their velocity or acceleration: exact integrals, and the forces that they need."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from runtime import simulate
from symgen.generate import model_of
from symgen.scene import CurveTable, Scene, s_curve, trapezoid


@pytest.mark.parametrize("interpolation", ["linear", "cubic", "monotone"])
@pytest.mark.parametrize("integrated", [1, 2])
def test_an_integrated_table_has_the_table_as_its_derivative(interpolation: str, integrated: int) -> None:
    points: dict[str, Any] = {"x": [0.5, 1.0, 1.7, 3.0], "y": [1.0, -2.0, 0.5, 0.7], "interpolation": interpolation}
    plain, whole = CurveTable(**points).curve, CurveTable(**points, integrated=integrated).curve
    x = np.array([0.1, 0.5, 0.8, 1.0, 1.3, 1.7, 2.9, 3.0, 4.2])
    assert whole(x, integrated) == pytest.approx(plain(x), abs=1e-14)
    inner = np.array([0.5, 1.0, 1.7, 3.0])
    for order in range(integrated):  # continuous at the points, and zero at the first
        assert whole(inner - 1e-12, order) == pytest.approx(whole(inner, order), abs=1e-10)
        assert abs(whole(np.array([0.5]), order)[0]) < 1e-15


@pytest.mark.parametrize("distance", [2.0, -0.05, 1e-4])
def test_profiles_arrive_and_keep_their_limits(distance: float) -> None:
    for profile, jerk in ((trapezoid(distance, 0.8, 3.0), np.inf), (s_curve(distance, 0.8, 3.0, 20.0), 20.0)):
        curve = CurveTable(**profile).curve
        t = np.linspace(0.0, profile["x"][-1], 5001)
        assert curve(np.array([profile["x"][-1] + 1.0]))[0] == pytest.approx(distance, rel=1e-12)
        assert np.abs(curve(t, 1)).max() <= 0.8 * (1 + 1e-12)
        assert np.abs(curve(t, 2)).max() <= 3.0 * (1 + 1e-12)
        assert np.abs(curve(t, 3)).max() <= jerk * (1 + 1e-9)
        assert (np.diff(curve(t)) * np.sign(distance) > -1e-15).all()


@pytest.mark.parametrize("distance", [0.0])
def test_a_profile_over_no_distance_is_refused(distance: float) -> None:
    with pytest.raises(ValueError, match="distance that is not zero"):
        trapezoid(distance, 1.0, 1.0)
    with pytest.raises(ValueError, match="limits above zero"):
        s_curve(1.0, 1.0, -1.0, 1.0)


def test_a_slide_driven_by_a_profile_and_shaken_on_its_base() -> None:
    """m a is what the drive gives; a load on a spring on a base by its acceleration answers as the convolution."""
    builder = Scene("drive").ground(markers={"line": {"position": [0.0, 0.0]}})
    builder.table("move", **trapezoid(1.0, 0.5, 2.0))
    builder.rigid("cart", mass=3.0, inertia=1.0).prismatic("rail", "ground.line", "cart.origin")
    builder.prescribed_displacement("motor", "ground.line", "cart.origin", 'table("move", t)')
    builder.rigid("load", mass=0.5, inertia=1.0).prismatic("slide", "cart.origin", "load.origin")
    builder.spring_damper("spring", "cart.origin", "load.origin", stiffness=50.0)
    builder.initial({"load.x": 0.0})
    run = simulate(model_of(builder.build()), t_end=3.0, dt=1e-3, scheme="rk4")
    a = np.where(run.t < 0.25, 2.0, np.where((run.t >= 2.0) & (run.t < 2.25), -2.0, 0.0))
    w = 10.0

    def step(t: np.ndarray) -> np.ndarray:
        return np.where(t > 0, (1 - np.cos(w * t)) / w**2, 0.0)

    relative = -2.0 * (step(run.t) - step(run.t - 0.25) - step(run.t - 2.0) + step(run.t - 2.25))
    assert run["load.x"] - run["cart.x"] == pytest.approx(relative, abs=1e-9)
    force = 3.0 * a - 50.0 * relative
    assert run.joint_force("motor")[:, 0] == pytest.approx(force, abs=1e-6)
