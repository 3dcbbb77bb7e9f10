"""Iterations of implicit steps on stiff springs and friction that reverses: they converge, or the advice helps."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from runtime import simulate
from runtime.model import Model
from runtime.schemes.radau import lagrange
from symgen.scene import Scene, SceneRecord
from tests.running.test_advice import ball_on_an_arm
from tests.support.scenes import on_rail

pytestmark = pytest.mark.long

Build = Callable[[SceneRecord], Model]


def slider(force: str, x: float) -> SceneRecord:
    """One kilogram on a slide along x under a force, from rest at x [m]."""
    builder = on_rail("slider", "m", "slide", mass=1.0, inertia=1.0).gravity(0, 0).measure("x", "x", of="m.origin")
    return builder.force("pull", "m.origin", force, 0).initial({"m.x": x}).build()


@pytest.mark.parametrize("rest", [0.0, 1.0])
@pytest.mark.parametrize("start", [0.0, 1e-3, 0.01])
def test_radau_on_a_stiff_spring(model_of: Build, rest: float, start: float) -> None:
    """1e7 N/m on 1 kg, 20 steps a period, at rest, too: rest + start cos(omega t), to the scheme's own error."""
    run = simulate(model_of(slider(f"-1e7*(x-{rest})", rest + start)), scheme="radau", dt=1e-4, t_end=0.1)
    assert run.status.name == "completed"
    expected = rest + start * np.cos(np.sqrt(1e7) * run.t)
    assert np.abs(run.q_i[:, 0] - expected).max() <= 2e-3 * start + 1e-12


@pytest.mark.parametrize("width, dt", [(1e-2, 1e-3), (1e-3, 1e-3), (1e-4, 1e-4), (1e-4, 1e-3)])
def test_radau_where_friction_reverses(model_of: Build, width: float, dt: float) -> None:
    """2 N of friction that turns within `width` m/s: it converges to what short steps find, or what is advised does."""
    model = model_of(slider(f"-100*x - 2*tanh(x_dot/{width!r})", 0.1))
    expected = simulate(model, scheme="radau", dt=dt / 50, t_end=0.5, seen_every=dt)
    assert expected.status.ok
    run = simulate(model, scheme="radau", dt=dt, t_end=0.5)
    if not run.status.ok:
        assert run.status.name == "iteration_failed" and f"dt={dt / 10:.2g}" in run.status.advice
        assert dt * 2 / width > 10
        other = simulate(model, scheme="exponential", options={"propagation": "decaying"}, dt=dt, t_end=0.5)
        assert other.status.ok and other.error is not None and other.error.largest < 0.01
        run = simulate(model, scheme="radau", dt=dt / 10, t_end=0.5, seen_every=dt)
    assert run.status.ok
    assert np.abs(run.q_i - expected.q_i).max() < 1e-4


def test_stages_are_continued_by_their_polynomial() -> None:
    """Four nodes take cubics over exactly, at nodes and beyond."""
    nodes, at = np.array([0.0, 0.2, 0.7, 1.0]), np.array([0.2, 1.3, 1.9])
    assert lagrange(nodes, at) @ (1 - nodes**2 + 2 * nodes**3) == pytest.approx(1 - at**2 + 2 * at**3)


def test_rigid_bodies_are_not_bent(model_of: Build) -> None:
    """A ball on an arm falls on a floor with friction: radau's iterations fail where that reverses, and M_hat, which
    the pose of the arm brings to 0.04 of that at the start, has no part in it. A few steps are made in shorter parts,
    which the run counts, and the motion is that of rk4.
    """
    model = model_of(ball_on_an_arm())
    right = simulate(model, scheme="rk4", dt=5e-6, t_end=0.6, error="off", samples=1)
    for call, most in (({"dt": 1e-3}, 2e-5), ({"dt": 1e-4}, 1e-6), ({"tolerance": 1e-4}, 1e-4), ({"dt": 1e-5}, 1e-6)):
        run = simulate(model, scheme="radau", t_end=0.6, error="off", **call)
        assert run.status.name == "completed", run.status
        assert np.abs(run.q[-1] - right.q[-1]).max() < most
        if call.get("dt", 0) >= 1e-4:
            assert 1 <= run.stats["divided_steps"] < 10


@pytest.mark.parametrize("seed", range(4))
def test_linear_beams_that_touch_a_floor(model_of: Build, seed: int) -> None:
    """Beams whose M_hat is a Gram matrix, with friction at the floor: what fails is the iteration, if anything does."""
    rng = np.random.default_rng(seed)
    length, side = float(rng.uniform(0.4, 0.8)), float(rng.uniform(0.008, 0.02))
    beam = {"density": 2700.0, "area": side**2, "second_moment": side**4 / 12, "youngs_modulus": 7e10}
    modes = {"ends": "clamped-free", "modes": 1 + seed % 2}
    scene = Scene(f"beam{seed}").gravity(0, -9.81).ground(markers={"floor": {"position": [0, -0.6 * length]}})
    scene.beam("rod", length=length, lateral=modes, damping_ratio=0.02, **beam).rigid("ball", mass=0.3, inertia=1e-3)
    scene.revolute("pin", "ground.origin", "rod.start").revolute("end", "rod.end", "ball.origin")
    contact = {"plane": "ground.floor", "damping": 0.3, "exponent": 1.5, "friction": float(rng.uniform(0.1, 0.5))}
    scene.contact("touch", "ball.origin", 0.03, 2e4, **contact).initial({"rod.theta": -0.1})
    model = model_of(scene.build())
    assert simulate(model, scheme="radau", dt=1e-3, t_end=0.5).status.name in (
        "completed",
        "inaccurate",
        "iteration_failed",
    )
    run = simulate(model, scheme="radau", tolerance=1e-3, t_end=0.5)
    assert run.status.name == "completed", run.status
    right = simulate(model, scheme="rk4", dt=5e-6, t_end=0.5, error="off", seen_every=0.01)
    sampled = simulate(model, scheme="radau", tolerance=1e-3, t_end=0.5, seen_every=0.01)
    off = np.sqrt(np.mean((sampled.q_i - right.q_i) ** 2, axis=0)) / np.sqrt(np.mean(right.q_i**2, axis=0))
    assert off[model.q_i.index("rod.theta")] < 3e-3
