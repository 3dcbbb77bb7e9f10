"""Motion of a body's frame from its saved coordinates: rotation, angular velocity and acceleration (Eq. 17).

The one place of the results that knows what the coordinates of an orientation are: the angle theta in the plane, Euler
angles A = A_1 A_2 A_3 about moving axes, or Euler parameters. omega = W theta', in the body's axes.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from runtime.contract.body_motion import cross_matrix

EULER_PARAMETERS = "euler_parameters"


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


def frame_motion(kind: str, theta: np.ndarray, theta_dot: np.ndarray, theta_ddot: np.ndarray) -> FrameMotion:
    """Of coordinates theta (N, n), their rates and accelerations.

    kind: a sequence of axes, "euler_parameters", or "" for the angle of a planar body.
    """
    if kind == EULER_PARAMETERS:
        return _of_parameters(theta, theta_dot, theta_ddot)
    if not kind:
        return _planar(theta, theta_dot, theta_ddot)
    return _of_angles(kind, theta, theta_dot, theta_ddot)


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


def _of_angles(kind: str, theta: np.ndarray, theta_dot: np.ndarray, theta_ddot: np.ndarray) -> FrameMotion:
    """Axes of the three turns in the body: A_3^T A_2^T e_1, A_3^T e_2, e_3; each turns back by those after it."""
    axes = ["xyz".index(axis) for axis in kind]
    A = np.tile(np.eye(3), (len(theta), 1, 1))
    W, W_dot = np.zeros((2, len(theta), 3, 3))
    after = np.zeros((len(theta), 3))  # angular velocity of the turns after the one at hand
    for k in (2, 1, 0):
        own = A.transpose(0, 2, 1)[:, :, axes[k]]
        W[:, :, k], W_dot[:, :, k] = own, -np.cross(after, own)
        after = after + own * theta_dot[:, k : k + 1]
        A = _turn(axes[k], theta[:, k]) @ A
    alpha = np.einsum("sij,sj->si", W, theta_ddot) + np.einsum("sij,sj->si", W_dot, theta_dot)
    return FrameMotion(A, after, alpha, W)


def _turn(axis: int, angle: np.ndarray) -> np.ndarray:
    j, k = (axis + 1) % 3, (axis + 2) % 3
    A = np.tile(np.eye(3), (len(angle), 1, 1))
    A[:, j, j] = A[:, k, k] = np.cos(angle)
    A[:, k, j] = np.sin(angle)
    A[:, j, k] = -A[:, k, j]
    return A
