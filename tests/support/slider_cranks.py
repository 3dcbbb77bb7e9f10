"""Slider-cranks that come to dead centres and singular positions."""

from __future__ import annotations

import math

from symgen.scene import Scene


def loop(crank: float, rod: float, independent: str) -> Scene:
    """A slider-crank. With crank and rod of one length, upright, the rod may go on beside the crank or turn with it."""
    scene = Scene("loop").gravity(0, -9.81)
    for name, length in (("crank", crank), ("rod", rod)):
        scene.rigid(
            name, mass=1.0, inertia=0.02, center_of_mass=(length / 2, 0), markers={"tip": {"position": (length, 0)}}
        )
    scene.rigid("slider", mass=0.5, inertia=0.01)
    scene.revolute("A", "ground.origin", "crank.origin").revolute("B", "crank.tip", "rod.origin")
    scene.prismatic("slide", "ground.origin", "slider.origin").revolute("C", "rod.tip", "slider.origin")
    scene.initial({"crank.theta": 0.5, "rod.theta": -math.asin(crank * math.sin(0.5) / rod)})
    scene.rates({"crank.theta": 6.0}).independent(independent)
    return scene.simulation(t_end=5.0, dt=1e-3, scheme="single_rate")


def equal_slider_crank() -> Scene:
    return loop(0.5, 0.5, "crank.theta")


def driven_slider_crank() -> Scene:
    scene = equal_slider_crank().torque("drive", "crank.origin", "2 + 3 * sin(5 * t)")
    return scene.rotational_spring_damper("bearing", "ground.origin", "crank.origin", stiffness=0.5, damping=0.1)
