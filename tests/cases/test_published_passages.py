"""Published cases that change their independent coordinates on the way, or pass singular positions."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from runtime import Solution, simulate
from runtime.model import Model
from symgen.scene import SceneRecord
from symgen.scenes.spatial import heavy_top, tumbling_body

pytestmark = pytest.mark.long

Load = Callable[[str], Model]
WINDOWS = {
    1.0: (-0.19502030194944, -0.98079920566217),
    2.0: (0.057815795768011, 0.99832726786346),
    10.0: (0.32845811154082, 0.9445185381786),
}
TOP = {0.2: (0.60555056138, 0.59895768179, -0.52398302743), 1.0: (0.17334396410, 0.64008859207, -0.74849079113)}
INERTIA = np.array([1.0, 2.0, 3.0])


def at(solution: Solution, time: float, name: str) -> float:
    """A coordinate at a saved time."""
    k = int(np.abs(solution.t - time).argmin())
    assert abs(solution.t[k] - time) < 1e-9
    return float(solution[name][k])


def window_error(solution: Solution) -> float:
    """Largest error of the tip B0 at the published times."""
    angle = {time: at(solution, time, "upright0.theta") for time in WINDOWS}
    return max(
        float(np.abs([np.cos(angle[time]) - x, np.sin(angle[time]) - y]).max()) for time, (x, y) in WINDOWS.items()
    )


@pytest.mark.parametrize("scheme, dt, error, energy", [("dop853", 1e-2, 1e-6, 1e-4), ("single_rate", 1e-2, 1e-3, 0.1)])
def test_windows_pass_ten_singular_positions(
    built_in: Load, scheme: str, dt: float, error: float, energy: float
) -> None:
    """P2, N = 2: the branch is kept, energy too; each passage is reported."""
    solution = simulate(built_in("n_four_bar"), scheme=scheme, dt=dt, t_end=10.0, seen_every=0.0)
    assert solution.status.ok
    assert [event.kind for event in solution.events] == ["singular_position"] * 10
    assert np.abs(solution.total_energy - solution.total_energy[0]).max() < energy
    uprights = [solution[f"upright{k}.theta"] for k in range(3)]
    assert len(solution.t) == 1001 and np.ptp(uprights, axis=0).max() < 1e-6  # they stay parallel
    assert window_error(solution) < error
    assert max(solution.constraint_error.max(), solution.constraint_rate_error.max()) < 1e-10


def test_heavy_top(model_of: Callable[[SceneRecord], Model]) -> None:
    """P5: at 150 rad/s no orientation is special."""
    solution = simulate(model_of(heavy_top()), scheme="dop853", dt=5e-4, seen_every=0.01)
    assert solution.status.ok and not solution.events
    for time, place in TOP.items():
        assert np.abs([at(solution, time, f"top.{axis}") for axis in "xyz"] - np.array(place)).max() < 1e-9
    assert np.ptp(solution.total_energy) < 1e-8 * solution.total_energy[0]


ORIENTATIONS = [(1.0, 0.0, 0.0, 0.0), (0.0, 0.0, 1.0, 0.0), (0.5, -0.5, 0.5, 0.5), (1e-9, 0.6, -0.8, 0.0)]


@pytest.mark.parametrize("e", ORIENTATIONS)
def test_a_body_tumbles_from_any_orientation(model_of: Callable[[SceneRecord], Model], e: tuple[float, ...]) -> None:
    """100 s about the middle axis: energy and angular momentum to 1e-8, |e| = 1 throughout."""
    solution = simulate(model_of(tumbling_body(e)), scheme="dop853", dt=0.05, seen_every=1.0)
    assert solution.status.ok
    momentum = angular_momentum(solution)
    assert np.abs(momentum - momentum[0]).max() < 1e-8 * np.linalg.norm(momentum[0])
    assert np.ptp(solution.total_energy) < 1e-8 * solution.total_energy[0]
    assert solution.constraint_error.max() < 1e-12
    turned = np.ptp(solution["body.e0"])
    assert turned > 0.5  # it does turn over


def angular_momentum(solution: Solution) -> np.ndarray:
    """A I omega from e and its rates: omega = 2 (e0 v' - e0' v - v x v') in body axes, rows are samples."""
    e = np.stack([solution[f"body.e{k}"] for k in range(4)], axis=1)
    rate = np.stack([solution.rate(f"body.e{k}") for k in range(4)], axis=1)
    e0, v, e0_dot, v_dot = e[:, :1], e[:, 1:], rate[:, :1], rate[:, 1:]
    spin = INERTIA * 2 * (e0 * v_dot - e0_dot * v - np.cross(v, v_dot))
    return (2 * e0**2 - 1) * spin + 2 * (np.sum(v * spin, axis=1, keepdims=True) * v + e0 * np.cross(v, spin))
