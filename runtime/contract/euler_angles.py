"""Euler angles of a body in space as input and output: A = A_1(theta_1) A_2(theta_2) A_3(theta_3) about moving axes.

A body moves with its angular velocity omega in body axes and has Euler parameters e, whatever it is described by.
Angles give the e of a start and are read off it:

    omega = W(theta) theta',    columns of W: A_3^T A_2^T e_1, A_3^T e_2, e_3

Where the first and the last axis coincide (the middle angle is 90 degrees for three different axes, 0 otherwise) the
first and the third angle are not determined. Only what is read off is ill-defined there.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from runtime.contract.angular import angular_velocity, exponential, parameter_rates, product

NAMES = ("theta1", "theta2", "theta3")
NEAR_SINGULAR = 0.02  # cosine or sine of the middle angle: two angles turn fifty times as fast as the body
SMALLEST = 1e-150  # beside zero: arctan2(0, 0) has no derivative
EULER_PARAMETERS = "euler_parameters"


def angle_names(body: str) -> list[str]:
    """Of a body's Euler angles, in order."""
    return [f"{body}.{name}" for name in NAMES]


def is_sequence(orientation: str) -> bool:
    """Is it a sequence of axes?"""
    return orientation not in ("", EULER_PARAMETERS)


Operation = Callable[..., Any]


def angles_of(kind: str, e: Sequence[Any], arctan2: Operation, cos: Operation, sin: Operation) -> list[Any]:
    """The three angles of the sequence `kind` at Euler parameters e (4), numbers or symbols: from -pi to pi.

    The middle one is from -pi/2 to pi/2, or from 0 to pi where the first axis is the last. Beyond the first turn is
    B = A_1^T A, of which the two others are read, so that all three make the orientation, singular or not.
    """
    A = rotation_rows(e)
    i, j = "xyz".index(kind[0]), "xyz".index(kind[1])
    k, s = 3 - i - j, 1 if (j - i) % 3 == 1 else -1
    last = "xyz".index(kind[2])
    side, level = (A[j][i], -s * A[k][i]) if last == i else (-s * A[j][k], A[k][k])
    first = arctan2(side, level + SMALLEST)
    c, sine = cos(first), sin(first)
    row = [c * A[j][m] + s * sine * A[k][m] for m in range(3)]  # of B: the turn about the middle axis leaves it
    if last == i:
        middle = arctan2(sine * A[j][i] - s * c * A[k][i], A[i][i])
        return [first, middle, arctan2(-s * row[k], row[j])]
    middle = arctan2(s * A[i][k], c * A[k][k] - s * sine * A[j][k])
    return [first, middle, arctan2(s * row[i], row[j])]


def rotation_rows(e: Sequence[Any]) -> list[list[Any]]:
    """Rotation matrix by rows of unit Euler parameters (4)."""
    e0, x, y, z = e
    return [
        [1 - 2 * (y * y + z * z), 2 * (x * y - e0 * z), 2 * (x * z + e0 * y)],
        [2 * (x * y + e0 * z), 1 - 2 * (x * x + z * z), 2 * (y * z - e0 * x)],
        [2 * (x * z - e0 * y), 2 * (y * z + e0 * x), 1 - 2 * (x * x + y * y)],
    ]


def angles(kind: str, e: np.ndarray) -> np.ndarray:
    """theta (..., 3) of Euler parameters (..., 4), see `angles_of`."""
    return np.stack(angles_of(kind, [e[..., k] for k in range(4)], np.arctan2, np.cos, np.sin), axis=-1)


def quaternion(kind: str, theta: np.ndarray) -> np.ndarray:
    """e (..., 4) of angles (..., 3)."""
    turns = [exponential(theta[..., k : k + 1] * np.eye(3)["xyz".index(axis)]) for k, axis in enumerate(kind)]
    return product(product(turns[0], turns[1]), turns[2])


def turning_axes(kind: str, theta: np.ndarray) -> np.ndarray:
    """W (..., 3, 3) of omega = W theta', for angles (..., 3)."""
    found, after = [], np.broadcast_to(np.array([1.0, 0.0, 0.0, 0.0]), (*theta.shape[:-1], 4))
    for k in (2, 1, 0):
        unit = np.eye(3)["xyz".index(kind[k])]
        found.append(_rotated(_conjugate(after), unit))
        after = product(exponential(theta[..., k : k + 1] * unit), after)
    return np.stack(found[::-1], axis=-1)


def turning_axes_rate(kind: str, theta: np.ndarray, theta_dot: np.ndarray) -> np.ndarray:
    """W' (..., 3, 3): each axis is turned back by the turns after it."""
    W = turning_axes(kind, theta)
    after = np.zeros_like(W[..., 0])
    found = []
    for k in (2, 1, 0):
        found.append(-np.cross(after, W[..., k]))
        after = after + W[..., k] * theta_dot[..., k : k + 1]
    return np.stack(found[::-1], axis=-1)


def parameter_slopes(kind: str, theta: np.ndarray) -> np.ndarray:
    """de/dtheta (4, 3) at angles (3,)."""
    return parameter_rates(quaternion(kind, theta), turning_axes(kind, theta).T).T


def angle_rates(kind: str, theta: np.ndarray, omega: np.ndarray) -> np.ndarray:
    """theta' (..., 3) of angular velocities (..., 3); of least size where the angles are singular."""
    return np.asarray((np.linalg.pinv(turning_axes(kind, theta)) @ omega[..., None])[..., 0])


def regularity(kind: str, theta: np.ndarray) -> np.ndarray:
    """(...) |cosine| of the middle angle for three different axes, else its |sine|: zero where angles are singular."""
    middle = theta[..., 1]
    return np.asarray(np.abs(np.cos(middle) if len(set(kind)) == 3 else np.sin(middle)))


def angle_motion(
    kind: str, e: np.ndarray, e_dot: np.ndarray, e_ddot: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """theta, see `angles_of`, theta', theta'' (N, 3) of Euler parameters and their rates (N, 4)."""
    theta = angles(kind, e)
    rate = angle_rates(kind, theta, angular_velocity(e, e_dot))
    bias = (turning_axes_rate(kind, theta, rate) @ rate[..., None])[..., 0]
    return theta, rate, angle_rates(kind, theta, angular_velocity(e, e_ddot) - bias)


def _conjugate(e: np.ndarray) -> np.ndarray:
    return np.asarray(e * np.array([1.0, -1.0, -1.0, -1.0]))


def _rotated(e: np.ndarray, vector: np.ndarray) -> np.ndarray:
    """A v of a vector (3,), A of unit quaternions (..., 4)."""
    pure = np.broadcast_to(np.concatenate([[0.0], vector]), e.shape)
    return np.asarray(product(product(e, pure), _conjugate(e))[..., 1:])
