"""Euler angles of a body over the saved samples, read off its Euler parameters."""

from __future__ import annotations

import numpy as np

from runtime.contract.coordinates import euler_angles, parameter_columns
from runtime.contract.model import Model
from runtime.contract.orientations import angle_motion, angle_names


def read_angles(model: Model, q: np.ndarray, q_dot: np.ndarray, q_ddot: np.ndarray, body: str) -> dict[str, np.ndarray]:
    """(N,) angles [rad] by name, from -pi to pi and the middle one in half of it, with their `_dot` and `_ddot`."""
    e = parameter_columns(model)[body]
    moved = angle_motion(euler_angles(model)[body], q[:, e], q_dot[:, e], q_ddot[:, e])
    return {
        f"{name}{suffix}": values[:, k]
        for suffix, values in zip(("", "_dot", "_ddot"), moved, strict=True)
        for k, name in enumerate(angle_names(body))
    }
