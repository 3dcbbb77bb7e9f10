"""Flexible slider-crank (case F1: Simeon; IVP test set "crank") and its freely running and torque-driven twins."""

from __future__ import annotations

import math

import numpy as np

from symgen.mechanism.builder import Scene
from symgen.mechanism.scene import SceneRecord

L1, L2, WIDTH = 0.15, 0.30, 0.008
M1, M2, M3 = 0.36, 0.151104, 0.075552
J1, J2 = 0.002727, 0.0045339259  # about the hinge of the crank, about the crank end of the rod
E, RHO = 2e11, 7870.0
PUBLISHED_PI = 3.1415927  # the published code's value: it enters the elastic data
LATERAL, AXIAL = 5253.5, 62358.7  # rad/s: the fastest coupled lateral and axial frequency of the freely running twin


def rod_data(pi: float, axial_mass_factor: float, axial_stiffness_factor: float = 1.0) -> dict:
    """Modal data of the rod: sin(pi x/L), sin(2 pi x/L) across, quadratic nodal shapes (mid, end) along.

    The published axial mass block lacks the factor 1/15 of a real quadratic element: axial_mass_factor = 1 gives the
    published numbers, 1/15 a rod that is built from rho, b, h. axial_stiffness_factor stiffens it along its axis only.
    """
    mass, area_length = RHO * WIDTH * WIDTH * L2, E * WIDTH * WIDTH / L2
    slender = (WIDTH / L2) ** 2
    M_ff, K_ff = np.zeros((4, 4)), np.zeros((4, 4))
    M_ff[:2, :2] = mass * np.diag([0.5, 0.5])
    M_ff[2:, 2:] = mass * axial_mass_factor * np.array([[8.0, 1.0], [1.0, 2.0]])
    K_ff[:2, :2] = area_length * np.diag([pi**4 / 24 * slender, 2 / 3 * pi**4 * slender])
    K_ff[2:, 2:] = area_length * axial_stiffness_factor * np.array([[16 / 3, -8 / 3], [-8 / 3, 7 / 3]])
    cross = np.zeros((4, 4))  # int (Phi_x,a Phi_y,b - Phi_y,a Phi_x,b) dm
    cross[2, 0], cross[3, 0], cross[3, 1] = 16 / pi**3, -(8 / pi**3 - 1 / pi), -0.5 / pi
    cross = mass * (cross - cross.T)
    return {
        "mass": M2,
        "first_moment": (M2 * L2 / 2, 0.0),
        "inertia": J2,
        "M_ff": M_ff.tolist(),
        "K_ff": K_ff.tolist(),
        "phi_integral": (mass * np.array([[0, 0, 2 / 3, 1 / 6], [2 / pi, 0, 0, 0]])).tolist(),
        "rho_dot_phi": (mass * L2 * np.array([0, 0, 1 / 3, 1 / 6])).tolist(),
        "rho_cross_phi": (mass * L2 * np.array([1 / pi, -0.5 / pi, 0, 0])).tolist(),
        "phi_cross_phi": cross.tolist(),
        "markers": {
            **{f"at{n}": _point(n / 8) for n in range(1, 8)},
            "end": {"position": (L2, 0.0), "shape_x": [0.0, 0.0, 0.0, 1.0]},
        },
    }


def _point(s: float) -> dict:
    """Marker at the fraction s of the rod, where an animation draws it."""
    return {
        "position": (L2 * s, 0.0),
        "shape_x": [0.0, 0.0, 4 * s * (1 - s), s * (2 * s - 1)],
        "shape_y": [math.sin(math.pi * s), math.sin(2 * math.pi * s) if s != 0.5 else 0.0, 0.0, 0.0],
    }


def _mechanism(name: str, title: str, rod: dict | None) -> Scene:
    builder = Scene(name, title=title)
    builder.rigid(
        "crank",
        mass=M1,
        inertia=J1 - M1 * (L1 / 2) ** 2,
        center_of_mass=(L1 / 2, 0),
        markers={"tip": {"position": (L1, 0)}},
    )
    if rod is not None:
        builder.modal("rod", **rod)
    else:
        builder.beam(
            "rod",
            length=L2,
            density=RHO,
            area=WIDTH**2,
            second_moment=WIDTH**4 / 12,
            youngs_modulus=E,
            lateral={"ends": "pinned-pinned", "modes": 2},
            stiffening=True,
            damping_ratio=0.02,
        )
    start = "rod.origin" if rod is not None else "rod.start"
    builder.rigid("slider", mass=M3, inertia=1e-5)
    builder.revolute("A", "ground.origin", "crank.origin").revolute("B", "crank.tip", start)
    builder.prismatic("slide", "ground.origin", "slider.origin").revolute("C", "rod.end", "slider.origin")
    return builder


def flexible_slider_crank() -> SceneRecord:
    """Case F1 as published: the crank turns at 150 rad/s, the rod has two lateral and two axial coordinates."""
    q = (0.0, 0.0, 0.103339863e-4, 0.169327969e-4)
    q_dot = (0.444896112581599, 0.00463433931923867, -1.78591076000055e-6, -2.68938671997904e-6)
    builder = _mechanism(
        "flexible_slider_crank", "Flexible slider-crank, crank angle prescribed (F1)", rod_data(PUBLISHED_PI, 1.0)
    )
    builder.parameter("omega", 150.0, "rad/s", "speed of the crank")
    builder.prescribed_angle("drive", "ground.origin", "crank.origin", motion="omega * t")
    builder.groups(L=["rod.q1", "rod.q2"], S=["rod.q3", "rod.q4"])
    coordinates = {"crank.theta": 0.0, "rod.theta": 0.0, "slider.x": 0.450016933}
    rates = {"crank.theta": 150.0, "rod.theta": -74.99576703969453, "slider.x": -2.68938671997904e-6}
    for k in range(4):
        coordinates[f"rod.q{k + 1}"], rates[f"rod.q{k + 1}"] = q[k], q_dot[k]
    return (
        builder.initial(coordinates)
        .rates(rates)
        .simulation(t_end=0.1, dt=4e-5, m=[2], scheme="printed", seen_every=0.0004)
        .build()
    )


def flexible_slider_crank_free() -> SceneRecord:
    """Freely running twin with the physical axial mass: the crank angle is the slow coordinate, nothing damps."""
    builder = _mechanism(
        "flexible_slider_crank_free", "Flexible slider-crank, running freely", rod_data(math.pi, 1 / 15)
    )
    return (
        builder.independent("crank.theta", "rod.q1", "rod.q2", "rod.q3", "rod.q4")
        .initial({"crank.theta": 0.0, "rod.theta": 0.0})
        .rates({"crank.theta": 150.0})
        .simulation(t_end=0.05, dt=2.5e-5, m=[1], scheme="exponential", seen_every=0.0005)
        .build()
    )


def flexible_slider_crank_torque() -> SceneRecord:
    """Torque-driven twin: a meshed rod with two lateral modes, geometric stiffening and 2 % modal damping."""
    builder = _mechanism("flexible_slider_crank_torque", "Flexible slider-crank, driven by a torque", None)
    builder.gravity(0, -9.81)
    builder.parameter("motor_torque", 8.0, "N m", "torque of the motor while it runs up")
    builder.torque("motor", "crank.origin", "where(t < 0.15, motor_torque, 0)")
    return (
        builder.independent("crank.theta", "rod.q1", "rod.q2")
        .initial({"crank.theta": 0.0, "rod.theta": 0.0})
        .simulation(t_end=0.4, dt=1e-4, m=[5], scheme="exponential", seen_every=0.001)
        .build()
    )


def physical_slider_crank() -> SceneRecord:
    """Case F1 with the physical axial mass, started in elastic equilibrium: axial modes nearly 3 times as fast."""
    builder = _mechanism(
        "physical_slider_crank",
        "Flexible slider-crank, crank prescribed, physical axial mass",
        rod_data(math.pi, 1 / 15),
    )
    builder.parameter("omega", 150.0, "rad/s", "speed of the crank")
    builder.prescribed_angle("drive", "ground.origin", "crank.origin", motion="omega * t")
    builder.groups(L=["rod.q1", "rod.q2"], S=["rod.q3", "rod.q4"])
    return (
        builder.initial({"crank.theta": 0.0, "rod.theta": 0.0})
        .rates({"crank.theta": 150.0})
        .simulation(t_end=0.1, dt=1e-5, m=[1], scheme="single_rate", seen_every=0.0005, start="quasi_static")
        .build()
    )


def stiff_slider_crank(ratio: float = 200.0) -> SceneRecord:
    """The freely running twin, stiffer along the rod: fastest frequency `ratio` times the fastest lateral one."""
    factor = (ratio * LATERAL / AXIAL) ** 2
    builder = _mechanism(
        "stiff_slider_crank",
        "Flexible slider-crank, running freely, stiff along the rod",
        rod_data(math.pi, 1 / 15, factor),
    )
    builder.independent("crank.theta", "rod.q1", "rod.q2", "rod.q3", "rod.q4")
    return (
        builder.initial({"crank.theta": 0.0, "rod.theta": 0.0})
        .rates({"crank.theta": 150.0})
        .simulation(t_end=0.05, dt=1e-6, m=[1], scheme="single_rate", seen_every=0.0005, start="quasi_static")
        .build()
    )
