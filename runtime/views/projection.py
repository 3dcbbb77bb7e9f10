"""From which side a spatial mechanism is looked at: the direction against gravity is up, seen a little from above."""

from __future__ import annotations

import numpy as np

from runtime.contract.model import Model

AZIMUTH, ELEVATION = np.radians(-60.0), np.radians(22.0)


def is_spatial(model: Model) -> bool:
    """Does the mechanism move in three dimensions?"""
    return bool(model.drawing.get("space") == "spatial")


def projected(model: Model, points: np.ndarray) -> np.ndarray:
    """Picture coordinates (2, ...) of world points (3, ...)."""
    if not is_spatial(model):
        return points[:2]
    return np.tensordot(view_axes(up_axis(model)), points, axes=1)


def axis_labels(model: Model) -> tuple[str, str]:
    """Labels of the picture's axes."""
    return ("across [m]", f"{'xyz'[up_axis(model)]}, seen from above [m]") if is_spatial(model) else ("x [m]", "y [m]")


def up_axis(model: Model) -> int:
    """The world axis that gravity is along; without gravity z, y in a planar mechanism."""
    if not is_spatial(model):
        return 1
    weights = np.abs(model.description.gravity)
    return int(np.argmax(weights)) if weights.any() else 2


def view_axes(up: int) -> np.ndarray:
    """Rows: the picture's horizontal and vertical direction in world axes (2 x 3)."""
    first, second = (up + 1) % 3, (up + 2) % 3
    axes = np.zeros((2, 3))
    axes[0, first], axes[0, second] = -np.sin(AZIMUTH), np.cos(AZIMUTH)
    axes[1, first], axes[1, second] = -np.sin(ELEVATION) * np.cos(AZIMUTH), -np.sin(ELEVATION) * np.sin(AZIMUTH)
    axes[1, up] = np.cos(ELEVATION)
    return axes
