"""Normal force E A u', shear force -E I w''' and bending moment E I w'' of a planar beam from its shapes."""

from __future__ import annotations

import casadi as ca
import numpy as np

from symgen.algebra.parameters import ParameterTable
from symgen.algebra.scalar import add, mul
from symgen.bodies.beam_sets import mode_sets
from symgen.bodies.shape_integrals import mesh_key
from symgen.modes import ExactBarModes, ExactBeamModes
from symgen.scene import BeamBody

ORDERS = {"normal_force": 1, "shear_force": 3, "bending_moment": 2}  # of the derivative by xi


def section_force(body: BeamBody, kind: str, at: float, q_f: list[ca.SX], table: ParameterTable) -> ca.SX:
    """The force [N] or moment [N m] at the fraction `at` of the length as a function of q_f."""
    length, modulus = table.of(body, "length"), table.of(body, "youngs_modulus")
    first, order, value = 0, ORDERS[kind], ca.SX(0)
    for _, modes in mode_sets(body):
        if isinstance(modes, ExactBarModes if kind == "normal_force" else ExactBeamModes):
            rates = modes.functions.at(np.array([at]), order)
            key = f"{mesh_key(body)}@{at!r}.{kind}"
            data = table.data(rates, key, "1", "derivative of the shapes at a section")
            for a in range(modes.modes):
                value = add(value, mul(data[0, a], q_f[first + a]))
        first += modes.modes
    if kind == "normal_force":
        return modulus * table.of(body, "area") / length * value
    bending = modulus * table.of(body, "second_moment")
    return bending / length**2 * value if kind == "bending_moment" else -bending / length**3 * value
