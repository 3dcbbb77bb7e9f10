"""Bodies that spin: every orientation alike, groups of spinning bodies, steady spins and what is near them."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from runtime import campbell, ensemble, equilibrium, simulate
from runtime.model import Model
from symgen.scene import Scene, SceneRecord
from tests.support.model_values import Array, evaluate, relative_error

pytestmark = pytest.mark.long

Build = Callable[..., Model]
AXES, PARAMETERS = ("omega_x", "omega_y", "omega_z"), ("e0", "e1", "e2", "e3")
CASES = 400
A, C, WEIGHT = 0.234375 + 15.0, 0.46875, 15.0 * 9.81  # heavy top about its foot, one metre below its centre of mass


def rotations(e: Array) -> Array:
    """(k, 3, 3) of unit quaternions (k, 4)."""
    w, x, y, z = e.T
    rows = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ]
    return np.array(rows).transpose(2, 0, 1)


@pytest.mark.parametrize(
    "name, body, dt, J, weight",
    [("tumbling_body", "body", 0.01, [1.0, 2.0, 3.0], 0.0), ("heavy_top", "top", 1e-3, [A, C, A], WEIGHT)],
)
def test_no_orientation_is_special(
    built_in: Build, name: str, body: str, dt: float, J: list[float], weight: float
) -> None:
    """Ten steps from random orientations and spins, those with one Euler parameter alone among them: energy, and the
    angular momentum that no force changes. 10,000 of them: `python -m benchmarks.pages.orientations`."""
    rng, J_o = np.random.default_rng(1), np.array(J)
    orientations = np.vstack([np.eye(4), rng.normal(size=(CASES - 4, 4))])
    orientations /= np.linalg.norm(orientations, axis=1, keepdims=True)
    spins = 3 * rng.normal(size=(CASES, 3))
    names = [f"{body}.{end}" for end in (*PARAMETERS, *AXES)]
    start = dict(zip(names, np.hstack([orientations, spins]).T, strict=True))
    found: Any = ensemble(
        built_in(name), initial=start, scheme="rk4", dt=dt, t_end=10 * dt, reduce={one: ["end"] for one in names},
        outputs=names, workers=1,
    )  # fmt: skip
    after = np.array([np.asarray(found[f"{one}_end"]) for one in names]).T

    def invariants(e: Array, omega: Array) -> tuple[Array, Array]:
        turned, L = rotations(e), np.einsum("kij,kj->ki", rotations(e), omega * J_o)
        return (omega**2 @ J_o) / 2 + weight * turned[:, 2, 1], L if weight == 0 else L[:, 2:]

    for before, now in zip(invariants(orientations, spins), invariants(after[:, :4], after[:, 4:]), strict=True):
        assert relative_error(now, before) < 1e-6
    assert np.abs(np.linalg.norm(after[:, :4], axis=1) - 1).max() < 1e-14


def two_tumblers() -> SceneRecord:
    """Two free bodies that tumble, a slow one and a fast one, and a spring between points of theirs."""
    builder = Scene("two_tumblers", space="spatial").gravity(0, 0, -1.0)
    builder.rigid("slow", mass=2.0, inertia=[0.2, 0.3, 0.4], free=True, markers={"eye": {"position": [0.3, 0, 0]}})
    builder.rigid("fast", mass=0.4, inertia=[0.01, 0.02, 0.015], free=True, markers={"eye": {"position": [0, 0, 0.2]}})
    builder.spring_damper("spring", "slow.eye", "fast.eye", stiffness=20.0, damping=0.1, free_length=0.4)
    builder.initial({"fast.x": 0.8, "fast.z": 0.1}).groups(L=["slow.*"], S=["fast.*"])
    slow, fast = zip(AXES, (1.0, -0.7, 2.0), strict=True), zip(AXES, (3.0, 0.0, 4.0), strict=True)
    builder.rates({f"slow.{axis}": w for axis, w in slow} | {f"fast.{axis}": w for axis, w in fast})
    return builder.simulation(t_end=0.32, dt=8e-3, scheme="rk4", m=[2]).build()


def test_groups_of_spinning_bodies(model_of: Build) -> None:
    """Order two of every sub-cycling scheme, `printed` too as no inertia couples the groups; the spring's force on its
    bodies is the one by hand."""
    model = model_of(two_tumblers())

    def end(scheme: str, dt: float, **settings: Any) -> Array:
        return np.asarray(simulate(model, scheme=scheme, dt=dt, samples=1, **settings).q[-1])

    wanted = end("dop853", 4e-3)
    readings = [{"common_update": "direct", "slow_interpolation": one} for one in ("end_point_sum", "chord")]
    runs: list[tuple[str, dict[str, Any]]] = [("printed", {"m": [2], "options": reading}) for reading in readings]
    for scheme, settings in [*runs, ("coupled", {"m": [4]})]:
        errors = [np.abs(end(scheme, dt, **settings) - wanted).max() for dt in (4e-3, 2e-3)]
        assert errors[0] < 3e-5, (scheme, errors)
        assert np.log2(errors[0] / errors[1]) == pytest.approx(2, abs=0.1), (scheme, errors)
    at = {"q": model.initial_q, "q_dot": model.initial_q_dot, "t": 0.0}
    gap = np.array([0.8, 0, 0.3]) - [0.3, 0, 0]
    speed = np.cross([3.0, 0, 4.0], [0, 0, 0.2]) - np.cross([1.0, -0.7, 2.0], [0.3, 0, 0])
    length = np.linalg.norm(gap)
    force = -(20.0 * (length - 0.4) + 0.1 * gap @ speed / length) * gap / length
    assert relative_error(evaluate(model, "load_actions", **at)["load_actions"].ravel()[:3], force) < 1e-13


def test_steady_spins(built_in: Build) -> None:
    """A top with its centre of mass above the foot, by hand in fixed axes A p^2 - C W p + m g l = 0: unstable below the
    spin 2 sqrt(A m g l) / C. Roots i p are i (p - W) in axes that spin; a top that hangs, along spins."""
    top, limit = built_in("heavy_top"), 2 * np.sqrt(A * WEIGHT) / C
    upright = {"top.e0": np.sqrt(0.5), "top.e1": np.sqrt(0.5), "top.e2": 0.0, "top.e3": 0.0}
    for spin in (0.3 * limit, 0.999 * limit, 1.001 * limit):
        found = equilibrium(top, rates={"top.omega_y": spin}, initial=upright)
        wanted = 1j * (np.roots([A, -C * spin, WEIGHT]) - spin)
        assert found.steady and found["top.z"] == pytest.approx(1.0, abs=1e-12)
        assert found.stable == (spin > limit) and found.holding["top.turn_y"] == pytest.approx(0.0, abs=1e-9)
        assert max(np.abs(found.eigenvalues - one).min() for one in wanted) < 1e-6 * spin
    spins = np.array([100.0, 200.0])
    diagram = campbell(top, "top.omega_y", spins)
    for row, spin in zip(diagram.frequencies, spins, strict=True):
        hanging = np.abs(np.roots([A, -C * spin, -WEIGHT]).real - spin)
        assert relative_error(np.sort(row)[1:], np.sort(hanging)) < 1e-9
