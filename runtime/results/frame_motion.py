"""Motion of a body's frame from its saved coordinates: rotation, angular velocity and acceleration (Eq. 17).

The one place of the results that knows what the coordinates of an orientation are: the angle theta in the plane, or
Euler parameters. omega = W theta', in the body's axes.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from runtime.contract.flexible import cross_matrix


class FrameMotion(NamedTuple):
    """N samples: A (N, 3, 3) turns body axes into the world's; omega, alpha (N, 3) in body axes; W (N, 3, n)."""

    A: np.ndarray
    omega: np.ndarray
    alpha: np.ndarray
    W: np.ndarray

    def moment(self, generalised: np.ndarray) -> np.ndarray:
        """(N, 3) moment in body axes whose virtual work is that of the forces (N, n) on theta."""
        if self.W.shape[2] == 1:
            return np.asarray(self.W[:, :, 0] * generalised)
        square = self.W @ self.W.transpose(0, 2, 1)
        return np.asarray(np.linalg.solve(square, self.W @ generalised[:, :, None])[:, :, 0])


def frame_motion(theta: np.ndarray, theta_dot: np.ndarray, theta_ddot: np.ndarray) -> FrameMotion:
    """Of the angle (N, 1) of a planar body or Euler parameters (N, 4), their rates and accelerations."""
    return (_planar if theta.shape[1] == 1 else _of_parameters)(theta, theta_dot, theta_ddot)


def _planar(theta: np.ndarray, theta_dot: np.ndarray, theta_ddot: np.ndarray) -> FrameMotion:
    W = np.tile(np.eye(3)[:, 2:], (len(theta), 1, 1))
    return FrameMotion(_turn(2, theta[:, 0]), W[:, :, 0] * theta_dot, W[:, :, 0] * theta_ddot, W)


def _of_parameters(e: np.ndarray, e_dot: np.ndarray, e_ddot: np.ndarray) -> FrameMotion:
    """W = 2 [-e_v, e_0 - e_v~]; W' e' = 0. Lengths other than 1 are rounding and left out."""
    tilde = cross_matrix(e[:, 1:])
    A = np.eye(3) + 2 * (e[:, :1, None] * tilde + tilde @ tilde)
    W = 2 * np.concatenate([-e[:, 1:, None], e[:, :1, None] * np.eye(3) - tilde], axis=2)
    omega, alpha = (np.einsum("sij,sj->si", W, rate) for rate in (e_dot, e_ddot))
    return FrameMotion(A, omega, alpha, W)


def _turn(axis: int, angle: np.ndarray) -> np.ndarray:
    j, k = (axis + 1) % 3, (axis + 2) % 3
    A = np.tile(np.eye(3), (len(angle), 1, 1))
    A[:, j, j] = A[:, k, k] = np.cos(angle)
    A[:, k, j] = np.sin(angle)
    A[:, j, k] = -A[:, k, j]
    return A
