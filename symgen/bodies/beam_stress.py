"""Von Mises stress of a beam by its shapes: the larger of that at the outermost fibre and that at the neutral line.

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
from symgen.bodies.gauge_stress import SMALLEST
from symgen.scene import BeamBody
from symgen.scene.measures import KNOWN_BY

STATIONS = tuple(float(at) for at in np.linspace(0.0, 1.0, 17))  # where the largest is looked for

Force = Callable[[str, float], ca.SX]  # (kind of section force, fraction of the length) -> [N] or [N m]


def beam_stress(body: BeamBody, force: Force, places: Sequence[float] | None, table: ParameterTable) -> ca.SX:
    """The largest von Mises stress [Pa] at the fractions `places` of the length, or at all stations."""
    found = ca.SX(SMALLEST)
    for at in places or STATIONS:
        found = ca.fmax(found, _square(body, {kind: _part(body, force, kind, at) for kind in KNOWN_BY}, table))
    return ca.sqrt(found)


def _part(body: BeamBody, force: Force, kind: str, at: float) -> ca.SX:
    return ca.SX(0) if getattr(body, KNOWN_BY[kind]) is None else force(kind, at)


def _square(body: BeamBody, parts: dict[str, ca.SX], table: ParameterTable) -> ca.SX:
    area = table.of(body, "area")
    pulled = ca.fabs(parts["normal_force"]) / area
    bent, twisted = ca.SX(0), ca.SX(0)
    if body.lateral is not None:
        bent += ca.fabs(parts["bending_moment"]) / table.of(body, "section_modulus")
    if body.lateral_z is not None:
        bent += ca.fabs(parts["bending_moment_y"]) / table.of(body, "section_modulus_z")
    if body.torsion is not None:
        twisted = ca.fabs(parts["torsion_moment"]) / table.of(body, "torsion_modulus")
    shear = ca.sqrt(parts["shear_force"] ** 2 + parts["shear_force_z"] ** 2 + SMALLEST)
    sheared = twisted + table.of(body, "shear_factor") * shear / area
    return ca.fmax((pulled + bent) ** 2 + 3 * twisted**2, pulled**2 + 3 * sheared**2)
