"""Floquet modes as they are drawn: of a linear oscillator they are its free vibration, whatever drives it."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from runtime import Model
from symgen.scene import Scene, SceneRecord

Build = Callable[[SceneRecord], Model]
MASS, STIFFNESS, DAMPING, DRIVE = 2.0, 50.0, 1.5, 3.3  # kg, N/m, N s/m, rad/s


@pytest.mark.parametrize("k", [0, 1])
def test_a_drawn_mode_of_an_oscillator_is_its_free_vibration(model_of: Build, k: int) -> None:
    """Without its decay: Re v e^{i w_d t} over three periods of a drive that has nothing to do with it.

    Its rate is Re i w_d v e^{i w_d t}; the other sign of w_d belongs to the other mode of the pair.
    """
    scene = Scene("oscillator").rigid("cart", mass=MASS, inertia=0.1).prismatic("rail", "ground.origin", "cart.origin")
    scene.measure("way", "x", "cart.origin")
    scene.force("spring", "cart.origin", f"4*cos({DRIVE}*t) - {STIFFNESS}*way - {DAMPING}*way_dot", 0.0)
    model = model_of(scene.simulation(t_end=1.0, dt=1e-3, scheme="rk4").build())
    found = model.periodic(period=2 * np.pi / DRIVE, scheme="dop853", steps=200)
    decay, size = DAMPING / (2 * MASS), 0.7
    w_d = np.sqrt(STIFFNESS / MASS - decay**2)
    turned = found.floquet.multipliers[k] * np.exp(decay * found.period)
    sign = 1 if abs(turned - np.exp(1j * w_d * found.period)) < 1e-6 else -1
    assert turned == pytest.approx(np.exp(1j * sign * w_d * found.period), abs=1e-7)
    shown, still = found.mode(k, periods=3, amplitude=size), found.mode(k, periods=3, amplitude=0.0)
    place = model.coordinates.index("cart.x")
    v = found.floquet.vectors[found.states.names.index("cart.x"), k]
    wave = size * v * np.exp(1j * sign * w_d * (shown.t - shown.t[0]))
    assert shown.t[-1] == pytest.approx(3 * found.period)
    assert shown.q[:, place] - still.q[:, place] == pytest.approx(wave.real, abs=1e-7 * size)
    rate = (1j * sign * w_d * wave).real + 0.0
    off = shown.q_dot[:, place] - still.q_dot[:, place]
    assert off == pytest.approx(rate - decay * wave.real, abs=1e-6 * size)  # of what decays, its growth taken out
    drive = 4 / (STIFFNESS - MASS * DRIVE**2 + 1j * DAMPING * DRIVE)
    assert still.q[:, place] == pytest.approx((drive * np.exp(1j * DRIVE * still.t)).real, abs=1e-7)
