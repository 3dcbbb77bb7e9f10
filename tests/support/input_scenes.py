"""Scenes that something outside drives."""

from __future__ import annotations

from typing import Any

import numpy as np

from symgen.scene import Scene, SceneRecord
from tests.support.scenes import on_rail


def cart(**simulation: Any) -> SceneRecord:
    """2 kg on a rail, pushed by an input."""
    return (
        on_rail("cart", "cart", "rail", mass=2.0, inertia=0.1)
        .input("force", 0.0, "N", "push")
        .force("push", "cart.origin", "force", 0.0)
        .simulation(**{"t_end": 1.0, "dt": 1e-3, "scheme": "rk4", **simulation})
        .build()
    )


def crane(**declared: Any) -> SceneRecord:
    """A pendulum of 1 m on a trolley that goes where an input says."""
    return (
        Scene("crane")
        .input("way", 0.0, "m", "of the trolley", **declared)
        .gravity(0, -9.81)
        .rigid("trolley", mass=2.0, inertia=0.1)
        .rigid("load", mass=1.0, inertia=0.0, center_of_mass=(0, -1.0))
        .prismatic("rail", "ground.origin", "trolley.origin")
        .prescribed_displacement("drive", "ground.origin", "trolley.origin", motion="way")
        .revolute("hook", "trolley.origin", "load.origin")
        .simulation(t_end=1.0, dt=1e-3, scheme="rk4")
        .build()
    )


def wave(t: Any) -> Any:
    """Way of the trolley [m]."""
    return 0.1 * np.sin(3 * t)
