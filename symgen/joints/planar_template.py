"""From a joint's constraint rows in marker quantities to C, C_q, C_t and gamma (Eqs. 21-27), in SymPy.

A joint type states only its rows C(r_a, phi_a, r_b, phi_b, f(t)) = 0. The direction t_a = (cos phi_a, sin phi_a)
of marker a and its normal n_a turn with phi_a; the chain to the body coordinates is the markers' business.
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from symgen.algebra.template import Template, derivative
from symgen.joints.joint_type import JointType, f, f_t, f_tt

r_a = sp.symbols("r_a_x r_a_y")
r_b = sp.symbols("r_b_x r_b_y")
t_a = sp.symbols("t_a_x t_a_y")
phi_a, phi_b = sp.symbols("phi_a phi_b")
r_a_dot = sp.symbols("r_a_dot_x r_a_dot_y")
r_b_dot = sp.symbols("r_b_dot_x r_b_dot_y")
phi_a_dot, phi_b_dot = sp.symbols("phi_a_dot phi_b_dot")

n_a = (-t_a[1], t_a[0])
d = (r_b[0] - r_a[0], r_b[1] - r_a[1])

_TURN_A = {t_a[0]: -t_a[1], t_a[1]: t_a[0], phi_a: sp.Integer(1)}
_MOTION = {f: f_t, f_t: f_tt}
_RATES = {
    **dict(zip(r_a, r_a_dot, strict=True)),
    **dict(zip(r_b, r_b_dot, strict=True)),
    **{symbol: rate * phi_a_dot for symbol, rate in _TURN_A.items()},
    phi_b: phi_b_dot,
    **_MOTION,
}
SLOTS = ("r_a_x", "r_a_y", "r_b_x", "r_b_y", "phi_a", "phi_b")


def joint_type(rows: Sequence[tuple[str, sp.Expr]]) -> JointType:
    """Derive the template of a joint from its labelled constraint rows."""
    outputs: dict[str, sp.Expr] = {}
    for k, (_, row) in enumerate(rows):
        outputs[f"C_{k}"] = row
        for slot, symbol in zip(SLOTS, (*r_a, *r_b), strict=False):
            outputs[f"C_{k}_{slot}"] = sp.diff(row, symbol)
        outputs[f"C_{k}_phi_a"] = derivative(row, _TURN_A)
        outputs[f"C_{k}_phi_b"] = sp.diff(row, phi_b)
        outputs[f"C_t_{k}"] = derivative(row, _MOTION)
        outputs[f"drift_{k}"] = sp.expand(derivative(derivative(row, _RATES), _RATES))
    return JointType(tuple(label for label, _ in rows), Template(outputs))


def cross_slide() -> sp.Expr:
    """Distance of point b from the line through a along t_a."""
    return n_a[0] * d[0] + n_a[1] * d[1]


def along_slide() -> sp.Expr:
    """Travel of point b along the line through a."""
    return t_a[0] * d[0] + t_a[1] * d[1]
