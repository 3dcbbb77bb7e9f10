"""Stresses at the gauges of finite-element bodies, sums of modal stresses, and of beams.

Von Mises stress of a beam by its shapes: the larger of that at the outermost fibre and that at the neutral line.

    outermost fibre   sigma = |N| / A + |M_z| / W_z + |M_y| / W_y,   tau = |T| / W_t
    neutral line      sigma = |N| / A,                               tau = |T| / W_t + k sqrt(Q_y^2 + Q_z^2) / A
    s = sqrt(sigma^2 + 3 tau^2)

W: section moduli, k: largest over mean stress of a shear force. Exact at the corner of a rectangle; of a circle bent in
both planes at once, and where torsion is largest elsewhere than bending, a little too large.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import casadi as ca
import numpy as np

from symgen.algebra.parameters import ParameterTable
from symgen.algebra.scalar import total
from symgen.scene import BeamBody, SpatialModalBody
from symgen.scene.flexible import ALL_GAUGES, COMPONENTS
from symgen.scene.measures import KNOWN_BY, MESH_ERROR

NO_STRESS = 1e-300  # [Pa^2]: keeps the rate of a von Mises stress finite where there is no stress


def gauge_stress(body: SpatialModalBody, gauge: str, component: str, q_f: list[ca.SX], table: ParameterTable) -> ca.SX:
    """A component in the axes of the body, the von Mises stress, or the error of the mesh [Pa]; of all gauges the
    largest.
    """
    square = _error_square if component == MESH_ERROR else _von_mises_square
    if gauge == ALL_GAUGES:
        found = ca.SX(0)
        for name in body.gauges:
            found = ca.fmax(found, square(body, name, q_f, table))
        return ca.sqrt(ca.fmax(found, NO_STRESS))
    if component in COMPONENTS:
        return _components(body, gauge, q_f, table)[COMPONENTS.index(component)]
    return ca.sqrt(ca.fmax(square(body, gauge, q_f, table), NO_STRESS))


def _components(body: SpatialModalBody, gauge: str, q_f: list[ca.SX], table: ParameterTable) -> list[ca.SX]:
    shapes = np.array(body.gauges[gauge].shapes)
    data = table.data(shapes, f"{body.name}.{gauge}.stress", "Pa per unit of q_f", "stress of the modes at a gauge")
    return [total(data[row, a] * q_f[a] for a in range(len(q_f)) if shapes[row, a]) for row in range(len(COMPONENTS))]


def _error_square(body: SpatialModalBody, gauge: str, q_f: list[ca.SX], table: ParameterTable) -> ca.SX:
    rows = np.array(body.gauges[gauge].error_shapes)
    data = table.data(rows, f"{body.name}.{gauge}.mesh_error", "Pa per unit of q_f", "error of the mesh at a gauge")
    parts = [total(data[r, a] * q_f[a] for a in range(len(q_f)) if rows[r, a]) for r in range(len(rows))]
    return ca.SX(total(part**2 for part in parts))


def _von_mises_square(body: SpatialModalBody, gauge: str, q_f: list[ca.SX], table: ParameterTable) -> ca.SX:
    values = _components(body, gauge, q_f, table)
    xx, yy, zz, yz, xz, xy = values
    return ((xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2) / 2 + 3 * (yz**2 + xz**2 + xy**2)


STATIONS = tuple(float(at) for at in np.linspace(0.0, 1.0, 17))  # where the largest is looked for

Force = Callable[[str, float], ca.SX]  # (kind of section force, fraction of the length) -> [N] or [N m]


def beam_stress(body: BeamBody, force: Force, places: Sequence[float] | None, table: ParameterTable) -> ca.SX:
    """The largest von Mises stress [Pa] at the fractions `places` of the length, or at all stations.

    force: the normal force whatever the shapes are, the others where there are shapes that know them.
    """
    found = ca.SX(NO_STRESS)
    for at in places or STATIONS:
        found = ca.fmax(found, _of_beam(body, {kind: _part(body, force, kind, at) for kind in KNOWN_BY}, table))
    return ca.sqrt(found)


def _part(body: BeamBody, force: Force, kind: str, at: float) -> ca.SX:
    unknown = kind != "normal_force" and getattr(body, KNOWN_BY[kind]) is None
    return ca.SX(0) if unknown else force(kind, at)


def _of_beam(body: BeamBody, parts: dict[str, ca.SX], table: ParameterTable) -> ca.SX:
    area = table.of(body, "area")
    pulled = ca.fabs(parts["normal_force"]) / area
    bending, twisted = ca.SX(0), ca.SX(0)
    if body.lateral is not None:
        bending += ca.fabs(parts["bending_moment"]) / table.of(body, "section_modulus")
    if body.lateral_z is not None:
        bending += ca.fabs(parts["bending_moment_y"]) / table.of(body, "section_modulus_z")
    if body.torsion is not None:
        twisted = ca.fabs(parts["torsion_moment"]) / table.of(body, "torsion_modulus")
    shear = ca.sqrt(parts["shear_force"] ** 2 + parts["shear_force_z"] ** 2 + NO_STRESS)
    sheared = twisted + table.of(body, "shear_factor") * shear / area
    return ca.fmax((pulled + bending) ** 2 + 3 * twisted**2, pulled**2 + 3 * sheared**2)
