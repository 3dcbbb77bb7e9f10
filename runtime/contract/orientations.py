"""Orientations with velocities of their own: unit quaternions, Euler angles as input and output, and where bodies'
turns stand in q_i and q, with their charts.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

# Unit quaternions e (scalar first) and angular velocities in body axes: omega = 2 conj(e) o e'.


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


# Euler angles of a body in space as input and output: A = A_1(theta_1) A_2(theta_2) A_3(theta_3) about moving axes.
#
# A body moves with its angular velocity omega in body axes and has Euler parameters e, whatever it is described by.
# Angles give the e of a start and are read off it:
#
#     omega = W(theta) theta',    columns of W: A_3^T A_2^T e_1, A_3^T e_2, e_3
#
# Where the first and the last axis coincide (the middle angle is 90 degrees for three different axes, 0 otherwise) the
# first and the third angle are not determined. Only what is read off is ill-defined there.

NAMES = ("theta1", "theta2", "theta3")
NEAR_GIMBAL_LOCK = 0.02  # cosine or sine of the middle angle: two angles turn fifty times as fast as the body
BESIDE_ZERO = 1e-150  # beside zero: arctan2(0, 0) has no derivative
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
    first = arctan2(side, level + BESIDE_ZERO)
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


# Orientations with velocities of their own: where they stand in q_i and q, and their charts.
#
# The turns of such a body are a rotation vector theta from a chart, a unit quaternion, and their velocities are the
# angular velocity omega in body axes; its Euler parameters e are dependent coordinates. Of a body in a closed loop some
# or all turns may be loop unknowns: they stand in q_d, which then is not of coordinates alone. What the runtime calls
# takes [c, charts] instead of c, so whatever evaluates a model has the charts as well. Outside time steps, which have
# one chart a step, charts are 1.

IDENTITY = (1.0, 0.0, 0.0, 0.0)


@dataclass(frozen=True)
class OrientationRecord:
    """An orientation with velocities of its own: names of its turns in q_i or q_d, of its Euler parameters in q_d."""

    body: str
    turns: list[str]
    parameters: list[str]


@dataclass(frozen=True)
class Places:
    """Where things stand: entries of q_i that are coordinates, their columns of q; the same of q_d.

    turns (k, 3): positions of each orientation in q_i followed by q_d; parameters (k, 4): columns of q of its Euler
    parameters. loops: positions in q_d of the loop unknowns.
    """

    plain: np.ndarray
    columns: np.ndarray
    dependent_plain: np.ndarray
    dependent: np.ndarray
    turns: np.ndarray
    parameters: np.ndarray
    loops: np.ndarray
    n_i: int

    @property
    def split(self) -> bool:
        """Is there an orientation of which some turns are independent and some not?"""
        return bool(len(self.turns)) and bool(((self.turns < self.n_i).sum(axis=1) % 3).any())

    @property
    def all_independent(self) -> bool:
        """Are all turns in q_i?"""
        return bool((self.turns < self.n_i).all())


def places_of(
    coordinates: list[str], q_i: list[str], q_d: list[str], loops: list[str], records: list[OrientationRecord]
) -> Places:
    """Of a model's names."""
    at = {name: column for column, name in enumerate(coordinates)}
    turning = {name for record in records for name in record.turns}
    plain, dependent = ([k for k, name in enumerate(names) if name not in turning] for names in (q_i, q_d))
    turns = [[[*q_i, *q_d].index(name) for name in record.turns] for record in records]
    parameters = [[at[name] for name in record.parameters] for record in records]

    def array(values: Any, *shape: int) -> np.ndarray:
        return np.array(values, dtype=int).reshape(*shape)

    return Places(
        array(plain, -1),
        array([at[q_i[k]] for k in plain], -1),
        array(dependent, -1),
        array([at[q_d[k]] for k in dependent], -1),
        array(turns, len(records), 3),
        array(parameters, len(records), 4),
        array([q_d.index(name) for name in loops], -1),
        len(q_i),
    )
