"""The constant axes of a spatial marker in its body: rotation matrix and quaternion as numbers."""

from __future__ import annotations

import numpy as np

from symgen.scene import MarkerDirections

ALONG = 1.0 - 1e-9  # an axis this much along the body's x-axis takes the body's z-axis for its x-axis


def marker_rotation(marker: MarkerDirections) -> np.ndarray:
    """Columns: the marker's x-, y- and z-axis in the body frame (3 x 3, a rotation)."""
    z = _unit(np.array(marker.axis))
    if marker.x_axis is not None:
        x = np.array(marker.x_axis)
    else:
        x = np.array([1.0, 0.0, 0.0]) if abs(z[0]) < ALONG else np.array([0.0, 0.0, 1.0])
    x = _unit(x - (x @ z) * z)
    rotation = np.column_stack([x, np.cross(z, x), z])
    rotation[np.abs(rotation) < 1e-15] = 0.0
    return rotation


def quaternion_of(rotation: np.ndarray) -> np.ndarray:
    """Unit quaternion (scalar first, not negative) of a rotation matrix."""
    trace = float(np.trace(rotation))
    squares = np.array([1 + trace, *(1 - trace + 2 * rotation[k, k] for k in range(3))]) / 4
    largest = int(np.argmax(squares))
    r = rotation
    numerators = np.array(
        [
            [4 * squares[0], r[2, 1] - r[1, 2], r[0, 2] - r[2, 0], r[1, 0] - r[0, 1]],
            [r[2, 1] - r[1, 2], 4 * squares[1], r[0, 1] + r[1, 0], r[0, 2] + r[2, 0]],
            [r[0, 2] - r[2, 0], r[0, 1] + r[1, 0], 4 * squares[2], r[1, 2] + r[2, 1]],
            [r[1, 0] - r[0, 1], r[0, 2] + r[2, 0], r[1, 2] + r[2, 1], 4 * squares[3]],
        ]
    )
    quaternion = numerators[largest] / (4 * np.sqrt(squares[largest]))
    quaternion[np.abs(quaternion) < 1e-15] = 0.0
    return np.asarray(quaternion if quaternion[0] >= 0 else -quaternion)


def _unit(vector: np.ndarray) -> np.ndarray:
    scaled = vector / np.abs(vector).max()
    return np.asarray(scaled / np.linalg.norm(scaled))
