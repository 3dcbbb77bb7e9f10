"""Stress at the gauges of a finite-element body by its modal coordinates: the sum of modal stresses."""

from __future__ import annotations

import casadi as ca
import numpy as np

from symgen.algebra.parameters import ParameterTable
from symgen.algebra.scalar import total
from symgen.scene import SpatialModalBody
from symgen.scene.flexible import ALL_GAUGES, COMPONENTS

SMALLEST = 1e-300  # [Pa^2]: keeps the rate of a von Mises stress finite where there is no stress


def gauge_stress(body: SpatialModalBody, gauge: str, component: str, q_f: list[ca.SX], table: ParameterTable) -> ca.SX:
    """A component in the axes of the body, or the von Mises stress [Pa]; of all gauges the largest."""
    if gauge == ALL_GAUGES:
        found = ca.SX(0)
        for name in body.gauges:
            found = ca.fmax(found, _square(_components(body, name, q_f, table)))
        return ca.sqrt(ca.fmax(found, SMALLEST))
    values = _components(body, gauge, q_f, table)
    if component == "von_mises":
        return ca.sqrt(ca.fmax(_square(values), SMALLEST))
    return values[COMPONENTS.index(component)]


def _components(body: SpatialModalBody, gauge: str, q_f: list[ca.SX], table: ParameterTable) -> list[ca.SX]:
    shapes = np.array(body.gauges[gauge].shapes)
    data = table.data(shapes, f"{body.name}.{gauge}.stress", "Pa per unit of q_f", "stress of the modes at a gauge")
    return [total(data[row, a] * q_f[a] for a in range(len(q_f)) if shapes[row, a]) for row in range(len(COMPONENTS))]


def _square(values: list[ca.SX]) -> ca.SX:
    xx, yy, zz, yz, xz, xy = values
    return ((xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2) / 2 + 3 * (yz**2 + xz**2 + xy**2)
