"""Shapes of uniform beams in closed form: what derives a model and what reads its results must mean the same ones."""

from runtime.contract.beams.end_shapes import BENDING, STRETCHING
from runtime.contract.beams.orthogonal import (
    OrthogonalShapes,
    bending_shapes,
    panels_for,
    slope_size,
    stretching_shapes,
)
from runtime.contract.beams.shape_functions import ShapeFunctions, gauss_points

__all__ = [
    "BENDING",
    "STRETCHING",
    "OrthogonalShapes",
    "ShapeFunctions",
    "bending_shapes",
    "gauss_points",
    "panels_for",
    "slope_size",
    "stretching_shapes",
]
