"""Planar mechanisms of the hard suite once more, by material points: `python -m benchmarks.pages.hard_twins --points`.

Written from the sources of the cases, not from their scenes; nothing of the generator takes part. The start alone
(q and q_dot) is that of the case.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import casadi as ca
import numpy as np

from benchmarks.contenders.material_points import Array, Beam, Points, cantilever, sines

STEEL = 2e11


@dataclass(frozen=True)
class ByPoints:
    """A mechanism, and the times at which a force jumps [s]."""

    make: Callable[[], Points]
    breaks: tuple[float, ...] = ()


def quadratic(s: Array) -> tuple[Array, Array, Array]:
    """Axial shapes of the rod: 1 at the middle, 1 at the end."""
    return (
        np.array([4 * s * (1 - s), s * (2 * s - 1)]),
        np.array([4 - 8 * s, 4 * s - 1]),
        np.array([0 * s - 8, 0 * s + 4]),
    )


def published_rod(pi: float, false: bool, stiff: float = 1.0) -> Beam:
    """The rod of Simeon's slider-crank; false: with the axial mass as published, 15 times too large."""
    length, side = 0.30, 0.008
    mass = 7870.0 * side**2 * length
    E = np.zeros((4, 4))
    E[2:, 2:] = mass * 14 / 15 * np.array([[8.0, 1.0], [1.0, 2.0]])
    axial = STEEL * side**2 / length * stiff * np.array([[16 / 3, -8 / 3], [-8 / 3, 7 / 3]])
    return Beam(
        length,
        mass / length,
        STEEL * side**4 / 12 * (pi / np.pi) ** 4,
        sines(2),
        along=(quadratic, axial),
        turning=0.0045339259 - mass * length**2 / 3,
        false_mass=E if false else None,
    )


def slider_crank(rod: Beam, gravity: float = 0.0, crank: tuple[float, ...] = (0.36, 0.15, 0.075)) -> Points:
    """Crank (mass, length, centre of mass), rod, slider along x."""
    mass, length, center = crank
    m = Points(gravity)
    if center:
        m.rigid("crank", mass, 0.002727 - mass * center**2, center)
    else:
        m.rigid("crank", mass, 0.02)
    m.beam("rod", rod)
    m.rigid("slider", 0.075552 if center else 0.075, 1e-5)
    m.pin((0.0, 0.0), "crank")
    m.pin("crank", "rod", length)
    m.pin("rod", "slider", 1.0)
    m.hold(ca.vertcat(m["slider.y"], m["slider.theta"]))
    return m


def driven(rod: Beam) -> Points:
    """The crank at 150 rad/s."""
    m = slider_crank(rod)
    m.hold(m["crank.theta"] - 150.0 * m.t)
    return m


def torque() -> Points:
    """8 N m until 0.15 s; gravity, 2 % damping of the modes."""
    rod = Beam(0.30, 7870.0 * 0.008**2, STEEL * 0.008**4 / 12, sines(2), True, 0.02)
    m = slider_crank(rod, 9.81)
    m.force("crank.theta", ca.if_else(m.t < 0.15, 8.0, 0.0))
    return m


def hub(inertia: float) -> Points:
    """Wu and Haug's."""
    m = Points()
    m.rigid("hub", 1.0, inertia)
    m.beam("beam", Beam(8.0, 2766.7 * 7.2968e-5, 6.8952e10 * 8.2189e-9, cantilever(3), True))
    m.pin((0.0, 0.0), "hub")
    m.pin("hub", "beam")
    m.hold(m["beam.theta"] - m["hub.theta"])
    m.force("hub.theta", ca.if_else(m.t < 2, 10.0 * ca.sin(ca.pi * m.t), 0.0))
    return m


def spin_up() -> Points:
    """To 6 rad/s in 15 s: 6/15 (t^2/2 + (15/(2 pi))^2 (cos(2 pi t/15) - 1))."""
    m = Points()
    m.beam("beam", Beam(10.0, 1200.0 * 1e-3, 2.8e10 * 5e-7, cantilever(5), True))
    m.pin((0.0, 0.0), "beam")
    ramp = 6 / 15 * (m.t**2 / 2 + (15 / (2 * ca.pi)) ** 2 * (ca.cos(2 * ca.pi * m.t / 15) - 1))
    m.hold(m["beam.theta"] - ca.if_else(m.t < 15, ramp, 6 * (m.t - 7.5)))
    return m


def four_bar() -> Points:
    """A heavy crank and two thin beams."""
    m = Points(9.81)
    m.rigid("crank", 0.8, 4e-3)
    for name, length in (("coupler", 0.30), ("rocker", 0.25)):
        m.beam(name, Beam(length, 7850.0 * 4.8e-5, 2.1e11 * 0.012 * 0.004**3 / 12, sines(2), True))
    m.pin((0.0, 0.0), "crank")
    m.pin("crank", "coupler", 0.10)
    m.pin("coupler", "rocker", 1.0, 1.0)
    m.pin((0.30, 0.0), "rocker")
    return m


def chain() -> Points:
    """Ten links with two modes each."""
    m, previous = Points(9.81), ""
    for k in range(1, 11):
        name = f"link{k}"
        m.beam(name, Beam(0.5, 7800.0 * 2e-5, STEEL * 1e-11, cantilever(2)))
        m.pin(previous or (0.0, 0.0), name, 1.0)
        previous = name
    return m


def overdamped() -> Points:
    """A pendulum with a finger."""
    inertia = 0.02 * 0.1**2 / 3
    m = Points(9.81)
    m.rigid("rod", 0.5, 0.5 * 0.4**2 / 12, 0.2)
    m.rigid("finger", 0.02, inertia / 4, 0.05)
    m.pin((0.0, 0.0), "rod")
    m.pin("rod", "finger", 0.4)
    moment = 5.0 * (m["finger.theta"] - m["rod.theta"]) + 2e4 * inertia * (m.rate("finger.theta") - m.rate("rod.theta"))
    m.force("rod.theta", moment)
    m.force("finger.theta", -moment)
    return m


def near_singular() -> Points:
    """The crank is 0.98 of the rod."""
    rod = Beam(0.30, 7870.0 * 0.008**2, STEEL * 0.008**4 / 12, sines(2), True)
    return slider_crank(rod, crank=(0.7, 0.294, 0.0))


def joint_arm() -> Points:
    """Two links and two rotors behind stiff springs."""
    m, previous = Points(9.81), ""
    for k, mass in ((1, 4.0), (2, 3.0)):
        m.rigid(f"link{k}", mass, mass * 0.5**2 / 12, 0.25)
        m.rigid(f"rotor{k}", 0.5, 8e-3)
        for name in (f"link{k}", f"rotor{k}"):
            m.pin(previous or (0.0, 0.0), name, 0.5)
        moment = 3e4 * (m[f"link{k}.theta"] - m[f"rotor{k}.theta"])
        m.force(f"rotor{k}.theta", moment)
        m.force(f"link{k}.theta", -moment)
        previous = f"link{k}"
    elbow = 6.0 * ca.sin(2 * ca.pi * m.t)
    m.force("rotor1.theta", 25.0 * ca.sin(ca.pi * m.t))
    m.force("rotor2.theta", elbow)
    m.force("link1.theta", -elbow)
    return m


PUBLISHED = published_rod(3.1415927, True)
BY_POINTS = {
    "f1_smooth": ByPoints(lambda: driven(PUBLISHED)),
    "f1_rigid": ByPoints(lambda: driven(PUBLISHED)),
    "f1_physical": ByPoints(lambda: driven(published_rod(np.pi, False))),
    "slider_crank_free": ByPoints(lambda: slider_crank(published_rod(np.pi, False))),
    "slider_crank_torque": ByPoints(torque, (0.15,)),
    "f2_heavy_hub": ByPoints(lambda: hub(10.0), (2.0,)),
    "f2_light_hub": ByPoints(lambda: hub(0.1), (2.0,)),
    "f3_spin_up": ByPoints(spin_up, (15.0,)),
    "four_bar": ByPoints(four_bar),
    "chain": ByPoints(chain),
    "overdamped": ByPoints(overdamped),
    "near_singular": ByPoints(near_singular),
    "joint_arm": ByPoints(joint_arm),
}
