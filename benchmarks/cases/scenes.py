"""The mechanisms that are timed: a flexible slider-crank with a freely running crank, no gravity, no damping."""

from __future__ import annotations

import math

import numpy as np

from symgen.scene import Scene, SceneRecord

CRANK_LENGTH, CRANK_MASS, CRANK_CENTER, CRANK_INERTIA = 0.15, 0.36, 0.075, 7.02e-4
ROD_LENGTH, ROD_WIDTH, ROD_DENSITY, ROD_MODULUS = 0.30, 0.008, 7870.0, 2e11
SLIDER_MASS, SPEED = 0.075552, 150.0
MAJOR_STEP, RATIO = 2e-5, 10


def pinned_rod(modes: int = 2) -> dict:
    """A uniform rod with the modes sin(k pi x / L) across: all its other integrals are zero.

    Over the length: int sin^2 = L/2; int sin = L (1 - cos k pi) / (k pi); int x sin = -L^2 cos(k pi) / (k pi).
    """
    mass = ROD_DENSITY * ROD_WIDTH**2 * ROD_LENGTH
    k = np.arange(1, modes + 1)
    k_pi, sign = math.pi * k, np.where(k % 2 == 0, 1.0, -1.0)
    stiffness = ROD_MODULUS * ROD_WIDTH**4 / 12 * k_pi**4 / (2 * ROD_LENGTH**3)
    return {
        "mass": mass,
        "first_moment": (mass * ROD_LENGTH / 2, 0.0),
        "inertia": mass * ROD_LENGTH**2 / 3,
        "M_ff": np.diag(np.full(modes, mass / 2)),
        "K_ff": np.diag(stiffness),
        "phi_integral": np.vstack([np.zeros(modes), mass * (1 - sign) / k_pi]),
        "rho_cross_phi": -mass * ROD_LENGTH * sign / k_pi,
        "markers": {"end": {"position": (ROD_LENGTH, 0.0)}},
    }


def general_rod(modes: int = 4, damped: bool = False, orthogonal: bool = False) -> dict:
    """A rod with every shape integral and both components of every shape at its end non-zero.

    orthogonal: M_ff and K_ff diagonal, as modes of a free-vibration problem have them. damped: a full D_ff.
    """
    rng = np.random.default_rng(0)
    mass, length = 0.15, ROD_LENGTH
    square, skew, damping = rng.normal(size=(3, modes, modes))
    M_ff = mass * (np.eye(modes) + 0.02 * square @ square.T)
    K_ff = 2e5 * (np.eye(modes) + 0.1 * square.T @ square)
    if orthogonal:
        M_ff, K_ff = np.diag(np.diag(M_ff)), np.diag(np.diag(K_ff))
    rod = {
        "mass": mass,
        "first_moment": (0.16 * mass, 0.02 * mass),
        "inertia": 0.0046,
        "M_ff": M_ff,
        "K_ff": K_ff,
        "phi_integral": mass * rng.uniform(-0.1, 0.1, size=(2, modes)),
        "rho_dot_phi": mass * length * rng.uniform(-0.06, 0.06, size=modes),
        "rho_cross_phi": mass * length * rng.uniform(-0.06, 0.06, size=modes),
        "phi_cross_phi": 0.1 * mass * (skew - skew.T),
        "markers": {
            "end": {
                "position": (length, 0.0),
                "shape_x": rng.uniform(-1, 1, size=modes),
                "shape_y": rng.uniform(-1, 1, size=modes),
            }
        },
    }
    return {**rod, "D_ff": 0.5 * damping @ damping.T} if damped else rod


def slider_crank(rod: dict) -> SceneRecord:
    """Crank (slow group), flexible rod (its modes are the fast group) and slider, running freely from 150 rad/s."""
    modes = [f"rod.q{k + 1}" for k in range(len(rod["M_ff"]))]
    builder = Scene("slider_crank_benchmark")
    builder.rigid(
        "crank",
        mass=CRANK_MASS,
        inertia=CRANK_INERTIA,
        center_of_mass=(CRANK_CENTER, 0),
        markers={"tip": {"position": (CRANK_LENGTH, 0)}},
    )
    builder.modal("rod", **rod).rigid("slider", mass=SLIDER_MASS, inertia=1e-5)
    builder.revolute("A", "ground.origin", "crank.origin").revolute("B", "crank.tip", "rod.origin")
    builder.prismatic("slide", "ground.origin", "slider.origin").revolute("C", "rod.end", "slider.origin")
    builder.independent("crank.theta", *modes).groups(L=["crank.theta"], S=modes)
    builder.initial({"crank.theta": 0.3, "rod.theta": -0.15}).rates({"crank.theta": SPEED})
    return builder.simulation(t_end=0.1, dt=MAJOR_STEP, m=[RATIO], scheme="single_rate").build()
