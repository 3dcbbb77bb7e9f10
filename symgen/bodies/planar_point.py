"""Kinematics of one material point of a planar body, derived in SymPy (Eqs. 15-19).

The point is r = R_o + A(theta) rho(q_f). Everything is written in *world* components of the body vectors:

    a = A rho          arm from the frame origin to the point
    f = A drho/dq_a    shape of a representative mode a at the point (e: of a second mode b)
    b = A rho_dot      relative velocity by deformation, sum of f q_a_dot
    n = A rho_nu       part of rho_ddot without accelerations (zero for linear shapes)

so that d/dtheta of a vector v is J v, with J the rotation by 90 degrees. No sine or cosine appears here.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import sympy as sp

from symgen.algebra.template import Template, derivative_all

R_ddot_x, R_ddot_y, theta_dot, theta_ddot = sp.symbols("R_ddot_x R_ddot_y theta_dot theta_ddot")
R_dot_x, R_dot_y, R_x, R_y = sp.symbols("R_dot_x R_dot_y R_x R_y")
a_x, a_y, b_x, b_y, n_x, n_y = sp.symbols("a_x a_y b_x b_y n_x n_y")
f_x, f_y, e_x, e_y, q_a_ddot = sp.symbols("f_x f_y e_x e_y q_a_ddot")

TIME_RULES = {
    R_x: R_dot_x,
    R_y: R_dot_y,
    R_dot_x: R_ddot_x,
    R_dot_y: R_ddot_y,
    theta_dot: theta_ddot,
    a_x: -theta_dot * a_y + b_x,
    a_y: theta_dot * a_x + b_y,
    b_x: -theta_dot * b_y + f_x * q_a_ddot + n_x,
    b_y: theta_dot * b_x + f_y * q_a_ddot + n_y,
}
ANGLE_RULES = {a_x: -a_y, a_y: a_x}
MODE_RULES = {a_x: f_x, a_y: f_y}
ACCELERATIONS = (R_ddot_x, R_ddot_y, theta_ddot, q_a_ddot)


@dataclass(frozen=True)
class PointKinematics:
    """Closed forms of one point: every entry is a list of the x and y component."""

    position: list[sp.Expr]
    velocity: list[sp.Expr]
    columns: dict[str, list[sp.Expr]]  # dr/d(R_x, R_y, theta, mode a)
    bias: list[sp.Expr]  # acceleration with all second derivatives zero


@cache
def point_kinematics() -> PointKinematics:
    """Position, velocity, Jacobian columns and bias acceleration of a point: q of (15)-(18), u by (19)."""
    position = [R_x + a_x, R_y + a_y]
    velocity = derivative_all(position, TIME_RULES)
    acceleration = [sp.expand(component) for component in derivative_all(velocity, TIME_RULES)]
    columns = {
        "R_x": [sp.diff(component, R_x) for component in position],
        "R_y": [sp.diff(component, R_y) for component in position],
        "theta": derivative_all(position, ANGLE_RULES),
        "mode": derivative_all(position, MODE_RULES),
    }
    bias = [component.subs({symbol: 0 for symbol in ACCELERATIONS}) for component in acceleration]
    return PointKinematics(position, velocity, columns, bias)


@cache
def kinematics_template() -> Template:
    """Position, velocity, bias acceleration and angle column of a point, as one template."""
    kinematics = point_kinematics()
    vectors = {
        "r": kinematics.position,
        "r_dot": kinematics.velocity,
        "bias": kinematics.bias,
        "theta": kinematics.columns["theta"],
    }
    return Template(
        {
            f"{name}_{axis}": component
            for name, vector in vectors.items()
            for axis, component in zip("xy", vector, strict=True)
        }
    )
