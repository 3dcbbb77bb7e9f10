"""What moved a flexible body and what acted on it, as the recovery of its stresses takes it."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np


@dataclass(frozen=True, eq=False)
class MarkerForce:
    """A force and moment (N, 6) [N, N m] at a marker, in body axes; position (3,) [m] of the marker while unbent.

    The moment is about the place of the marker in the bent body.
    """

    marker: str
    position: np.ndarray
    wrench: np.ndarray


@dataclass(frozen=True, eq=False)
class BodyMotion:
    """N samples of a flexible body, vectors in its own axes.

    t (N,) [s]; q_f, q_f_dot, q_f_ddot (N, nf); acceleration (N, 3) [m/s^2] of the frame's origin less gravity; omega
    [rad/s], alpha [rad/s^2] (N, 3); forces: of the joints and loads on it, one for each.
    """

    body: str
    t: np.ndarray
    q_f: np.ndarray
    q_f_dot: np.ndarray
    q_f_ddot: np.ndarray
    acceleration: np.ndarray
    omega: np.ndarray
    alpha: np.ndarray
    forces: list[MarkerForce] = field(default_factory=list)

    def field(self) -> np.ndarray:
        """(N, 3, 3) G = alpha~ + omega~ omega~: the acceleration of a point at rest in the frame is a_o + G rho."""
        return spin_field(self.omega, self.alpha)


def spin_field(omega: np.ndarray, alpha: np.ndarray) -> np.ndarray:
    """(N, 3, 3) alpha~ + omega~ omega~."""
    turning = cross_matrix(omega)
    return np.asarray(cross_matrix(alpha) + turning @ turning)


def cross_matrix(v: np.ndarray) -> np.ndarray:
    """(N, 3, 3) with cross_matrix(v) w = v x w, for v (N, 3)."""
    found = np.zeros((len(v), 3, 3))
    for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        found[:, k, j], found[:, j, k] = v[:, i], -v[:, i]
    return found
