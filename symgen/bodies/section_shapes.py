"""Forces and moments in a section of a beam by the strains of its shapes: E A u', -E I w''', E I w'', G J tau'."""

from __future__ import annotations

import casadi as ca
import numpy as np

from symgen.algebra.parameters import ParameterTable
from symgen.algebra.scalar import add, mul
from symgen.bodies.beam_sets import mode_sets
from symgen.modes import ExactBarModes, ExactBeamModes
from symgen.scene import BeamBody

# kind -> axis of the shapes (x, y, z, 3 for torsion) and order of their derivative by xi
KINDS = {
    "normal_force": (0, 1),
    "shear_force": (1, 3),
    "bending_moment": (1, 2),
    "shear_force_z": (2, 3),
    "bending_moment_y": (2, 2),
    "torsion_moment": (3, 1),
}


def section_force(body: BeamBody, mesh: str, kind: str, at: float, q_f: list[ca.SX], table: ParameterTable) -> ca.SX:
    """The force [N] or moment [N m] at the fraction `at` of the length by q_f; mesh: key of the shapes."""
    wanted, order = KINDS[kind]
    first, value = 0, ca.SX(0)
    for axis, modes in mode_sets(body):
        if axis == wanted and isinstance(modes, ExactBarModes | ExactBeamModes):
            rates = modes.functions.at(np.array([at]), order)
            data = table.data(rates, f"{mesh}@{at!r}.{kind}", "1", "derivative of the shapes at a section")
            for a in range(modes.modes):
                value = add(value, mul(data[0, a], q_f[first + a]))
        first += modes.modes
    length, modulus = table.of(body, "length"), table.of(body, "youngs_modulus")
    if kind == "torsion_moment":
        return table.of(body, "shear_modulus") * table.of(body, "torsion_constant") / length * value
    if kind == "normal_force":
        return modulus * table.of(body, "area") / length * value
    bending = modulus * table.of(body, "second_moment" if wanted == 1 else "second_moment_z")
    factor = bending / length**order
    return factor * value if kind == "bending_moment" else -factor * value
