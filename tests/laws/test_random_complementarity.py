"""Sticking, sliding and closed stops of random small problems, against Lemke's method and Moreau's time stepping."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from runtime import Model
from runtime.schemes.switching.complementarity import balancing, complementary
from symgen.scene import Scene, SceneRecord
from tests.support.lemke import between_bounds, lemke

Build = Callable[[SceneRecord], Model]


def test_lemke_by_hand() -> None:
    """Two blocks that lie on each other and on a floor: forces of both weights, and of one."""
    A = np.array([[1.0, -1.0], [-1.0, 2.0]])  # floor-lower, lower-upper, masses of one
    assert between_bounds(A, np.array([-10.0, 0.0]), np.zeros(2), np.full(2, np.inf)) == pytest.approx([20.0, 10.0])
    assert lemke(np.array([[2.0, 1.0], [0.0, 2.0]]), np.array([-1.0, -2.0])) == pytest.approx([0.0, 1.0])
    assert between_bounds(np.eye(1), np.array([5.0]), np.array([-3.0]), np.array([3.0])) == pytest.approx([-3.0])


@pytest.mark.parametrize("redundant", [False, True])
def test_random_problems_between_bounds(redundant: bool) -> None:
    """Two to four rows of friction, stops and both; where rows say the same, accelerations are still one."""
    random, held, moved = np.random.default_rng(3), 0, 0
    for _ in range(400):
        n = int(random.integers(2, 5))
        m = n - 1 if redundant else n + int(random.integers(0, 2))
        G = random.normal(size=(n, m))
        A, b = G @ np.diag(random.uniform(0.3, 3.0, m)) @ G.T, G @ random.normal(scale=3.0, size=m)
        limit, kind = random.uniform(0.2, 3.0, n), random.integers(0, 4, n)  # friction, stop below, above, both
        lower = np.where(kind == 1, 0.0, np.where(kind == 2, -np.inf, -limit))
        upper = np.where(kind == 2, 0.0, np.where((kind == 1) | (kind == 3), np.inf, limit))
        sides = complementary(A, b, lower, upper)
        assert sides is not None
        f, right = balancing(A, b, lower, upper, sides), between_bounds(A, b, lower, upper)
        scale = 1.0 + np.abs(b).max() + np.abs(A).max() * np.abs(right).max()
        assert np.abs(b + A @ f - b - A @ right).max() < 1e-8 * scale
        if not redundant:
            assert np.abs(f - right).max() < 1e-7 * (1.0 + np.abs(right).max())
        assert (f >= lower - 1e-9 * scale).all() and (f <= upper + 1e-9 * scale).all()
        held, moved = held + int((sides == 0).sum()), moved + int((sides != 0).sum())
    assert held > 200 and moved > 200


def blocks(seed: int) -> tuple[Scene, dict[str, np.ndarray]]:
    """Two to four blocks in line on a rail: each slides on the one before by a clutch of time, up to plastic stops."""
    random = np.random.default_rng(seed)
    n = 2 + seed % 3
    mass, limit, ramp = random.uniform(0.5, 2.0, n), random.uniform(1.0, 4.0, n), random.uniform(-4.0, 8.0, n)
    force, w, way = random.uniform(4.0, 9.0, n), random.uniform(3.0, 9.0, n), random.uniform(0.1, 0.4, n)
    scene, last = Scene("blocks"), "ground.origin"
    for k in range(n):
        scene.rigid(f"b{k}", mass=float(mass[k]), inertia=0.1)
        friction = {"coulomb": f"max(0, {float(limit[k])!r} + {float(ramp[k])!r} * t)"}
        limits = {"lower": float(-way[k]), "upper": float(way[k]), "restitution": 0.0}
        scene.prismatic(f"j{k}", last, f"b{k}.origin", friction=friction, limits=limits)
        scene.force(f"f{k}", f"b{k}.origin", f"{float(force[k])!r} * sin({float(w[k])!r} * t + {k})", 0.0)
        last = f"b{k}.origin"
    data = {"mass": mass, "limit": limit, "ramp": ramp, "force": force, "w": w, "way": way}
    return scene.simulation(t_end=1.0), data


def moreau(data: dict[str, np.ndarray], steps: int) -> np.ndarray:
    """(2 n,) positions and velocities at 1 s: impulses of each step within their bounds, stops at the middle's gaps."""
    mass, n, h = data["mass"], len(data["mass"]), 1.0 / steps
    G = np.eye(n) - np.eye(n, k=-1)
    x, v, A = np.zeros(n), np.zeros(n), h * G / mass @ G.T
    for step in range(steps):
        t = (step + 0.5) * h
        gap, most = G @ (x + h / 2 * v), np.maximum(0.0, data["limit"] + data["ramp"] * t)
        free = v + h / mass * data["force"] * np.sin(data["w"] * t + np.arange(n))
        lower = np.where(gap >= data["way"], -np.inf, -most)
        upper = np.where(gap <= -data["way"], np.inf, most)
        new = free + h / mass * (G.T @ between_bounds(A, G @ free, lower, upper))
        x, v = x + h / 2 * (v + new), new
    return np.concatenate([x, v])


@pytest.mark.parametrize("seed", range(6))
@pytest.mark.long
def test_random_blocks_are_the_limit_of_time_stepping(model_of: Build, seed: int) -> None:
    """Clutches by time, plastic stops and forces: errors of time stepping are of the first order in its step."""
    scene, data = blocks(seed)
    run = model_of(scene.build()).simulate(tolerance=1e-7)
    assert run.status.name == "completed"
    names = [f"b{k}.x" for k in range(len(data["mass"]))]
    right = np.array([run[f"{name}{end}"][-1] for end in ("", "_dot") for name in names])
    for steps in (200, 800):
        assert np.abs(moreau(data, steps) - right).max() < 6.0 / steps * (1.0 + np.abs(right).max())
    assert len([event for event in run.events if event.kind in ("mode", "impact")]) >= 2
