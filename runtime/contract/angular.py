"""Unit quaternions e (scalar first) and angular velocities in body axes: omega = 2 conj(e) o e'."""

from __future__ import annotations

import numpy as np


def product(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Quaternion product a o b, (..., 4) each: first the rotation b, seen in the frame that a turns."""
    scalar = a[..., :1] * b[..., :1] - np.sum(a[..., 1:] * b[..., 1:], axis=-1, keepdims=True)
    vector = a[..., :1] * b[..., 1:] + b[..., :1] * a[..., 1:] + np.cross(a[..., 1:], b[..., 1:])
    return np.concatenate([scalar, vector], axis=-1)


def angular_velocity(e: np.ndarray, e_dot: np.ndarray) -> np.ndarray:
    """omega (..., 3) [rad/s] in body axes of Euler parameters and their rates, (..., 4)."""
    conjugate = np.concatenate([e[..., :1], -e[..., 1:]], axis=-1)
    return 2 * product(conjugate, e_dot)[..., 1:]


def exponential(theta: np.ndarray) -> np.ndarray:
    """Unit quaternion (..., 4) of a rotation vector (..., 3)."""
    size = np.linalg.norm(theta, axis=-1, keepdims=True)
    return np.concatenate([np.cos(size / 2), np.sinc(size / (2 * np.pi)) * theta / 2], axis=-1)


def rotation_vector(e: np.ndarray) -> np.ndarray:
    """theta (..., 3) with e = exp(theta), below 2 pi, of quaternions (..., 4) of any length; zero for (-1, 0, 0, 0)."""
    size = np.linalg.norm(e[..., 1:], axis=-1, keepdims=True)
    angle = 2 * np.arctan2(size, e[..., :1])
    with np.errstate(divide="ignore", invalid="ignore"):
        share = np.where(size > 0, angle / size, np.where(e[..., :1] > 0, 2.0 / np.abs(e[..., :1]), 0.0))
    return np.asarray(share * e[..., 1:])


def chart_rates(theta: np.ndarray) -> np.ndarray:
    """T^-1 (3 x 3) of theta' = T^-1(theta) omega, for theta (3,) below 2 pi."""
    half = float(np.linalg.norm(theta)) / 2
    g = 1 / 12 if half < 1e-4 else (1 - half / np.tan(half)) / (4 * half**2)
    return np.asarray(np.eye(3) + tilde(theta) / 2 + g * tilde(theta) @ tilde(theta))


def tilde(vector: np.ndarray) -> np.ndarray:
    """(3 x 3) whose product with b is vector x b."""
    x, y, z = vector
    return np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])


def parameter_rates(e: np.ndarray, omega: np.ndarray) -> np.ndarray:
    """e' = e o (0, omega) / 2 (..., 4)."""
    return product(e, np.concatenate([np.zeros((*omega.shape[:-1], 1)), omega / 2], axis=-1))


def rotation(theta: np.ndarray) -> np.ndarray:
    """Rotation matrix (3 x 3) of a rotation vector (3,)."""
    e, v = exponential(theta)[0], tilde(exponential(theta)[1:])
    return np.asarray(np.eye(3) + 2 * e * v + 2 * v @ v)
