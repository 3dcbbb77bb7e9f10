"""Fast heavy top (the heavy top of the Lie-group literature): Euler parameters and body angular velocity.

Mass 15, inertia diag(0.234375, 0.46875, 0.234375) about the centre of mass, which is at (0, 1, 0) in the body frame;
the frame's origin is fixed in the world's origin; gravity 9.81 along -z. A = 1 at the start, omega = (0, 150, -4.61538)
(body and world axes agree there).

Derivation: J_o = J + m (r.r 1 - r r^T) = diag(15.234375, 0.46875, 15.234375);
    J_o omega' = r x A^T m g - omega x J_o omega,   e' = 1/2 e o (0, omega).
    The y-row reads J_y omega_y' = 0: the spin is constant.
"""

from __future__ import annotations

import numpy as np

from tests.hand_derived.spatial.twin_spatial import parameters_A, parameters_dot
from tests.hand_derived.twin_common import Array

MASS, G = 15.0, 9.81
CENTRE = np.array([0.0, 1.0, 0.0])
INERTIA = np.diag([0.234375, 0.46875, 0.234375])
INERTIA_O = np.diag([15.234375, 0.46875, 15.234375])
START = np.array([1.0, 0.0, 0.0, 0.0, 0.0, 150.0, -4.61538])  # e, omega


def rate(t: float, y: Array) -> Array:
    """Time derivative of y = (e, omega)."""
    e, omega = y[:4], y[4:]
    weight = np.cross(CENTRE, parameters_A(e).T @ np.array([0.0, 0.0, -MASS * G]))
    return np.concatenate(
        [parameters_dot(e, omega), np.linalg.solve(INERTIA_O, weight - np.cross(omega, INERTIA_O @ omega))]
    )


def centre(y: Array) -> Array:
    """World position of the centre of mass."""
    return parameters_A(y[:4] / np.linalg.norm(y[:4])) @ CENTRE


def energy(y: Array) -> float:
    """Kinetic energy about the fixed point plus m g z."""
    return 0.5 * y[4:] @ INERTIA_O @ y[4:] + MASS * G * centre(y)[2]
