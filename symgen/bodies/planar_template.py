"""Mass blocks and quadratic-velocity force of a planar flexible body, derived in SymPy (Eq. 20).

The virtual work of the inertia forces of one mass point is delta_r . r_ddot dm. Its coefficients are products
of at most two world vectors of that point; integrating them over the body (summing over the lumped masses)
turns every product into an inertia shape integral. A rotation keeps dot and cross products, so the integrals
of pairs are those of the body-fixed vectors and hold no angle:

    first moments   h = int a dm,  s_a = int f dm,  hd = int b dm,  hn = int n dm          (world components)
    pairs           I = int rho.rho,  k_a = int rho.Phi_a,  g_a = int rho x Phi_a,  M_ff = int Phi_a.Phi_b,
                    kd = int rho.rho_dot,  Gd_a = int Phi_a x rho_dot

The kinetic energy is kept to second order in (q_f, q_f_dot), so pairs with the second-order vector n drop out.

Kinematics of one material point of a planar body, derived in SymPy (Eqs. 15-19).

The point is r = R_o + A(theta) rho(q_f). Everything is written in *world* components of the body vectors:

    a = A rho          arm from the frame origin to the point
    f = A drho/dq_a    shape of a representative mode a at the point (e: of a second mode b)
    b = A rho_dot      relative velocity by deformation, sum of f q_a_dot
    n = A rho_nu       part of rho_ddot without accelerations (zero for linear shapes)

so that d/dtheta of a vector v is J v, with J the rotation by 90 degrees. No sine or cosine appears here.
"""

from __future__ import annotations

from collections.abc import Sequence
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


m, I_theta, k_a, g_a, M_ff_ab, kd, Gd_a = sp.symbols("m I k_a g_a M_ff_ab kd Gd_a")
h_x, h_y, s_x, s_y, hd_x, hd_y, hn_x, hn_y = sp.symbols("h_x h_y s_x s_y hd_x hd_y hn_x hn_y")

_VECTORS = {
    "a": (a_x, a_y),
    "f": (f_x, f_y),
    "e": (e_x, e_y),
    "b": (b_x, b_y),
    "n": (n_x, n_y),
}
_FIRST_MOMENTS = {"a": (h_x, h_y), "f": (s_x, s_y), "b": (hd_x, hd_y), "n": (hn_x, hn_y)}
# (u, v): (integral of u.v, integral of u x v); None marks a pair that must not survive the derivation
_PAIRS: dict[tuple[str, str], tuple[sp.Expr | None, sp.Expr | None]] = {
    ("a", "a"): (I_theta, sp.Integer(0)),
    ("a", "f"): (k_a, g_a),
    ("a", "b"): (kd, None),
    ("f", "b"): (None, Gd_a),
    ("f", "e"): (M_ff_ab, None),
    ("a", "n"): (sp.Integer(0), sp.Integer(0)),
    ("f", "n"): (sp.Integer(0), sp.Integer(0)),
}


def _integrate_over_body(expression: sp.Expr) -> sp.Expr:
    """int(expression dm): every product of point vectors becomes its shape integral."""
    symbols = [component for vector in _VECTORS.values() for component in vector]
    polynomial = sp.Poly(sp.expand(expression), *symbols)
    rest: list[sp.Expr] = []
    for powers, coefficient in polynomial.terms():
        factors = [symbol for symbol, power in zip(symbols, powers, strict=True) for _ in range(power)]
        rest.append(coefficient * _moment(factors))
    total = sp.expand(sp.Add(*rest))
    leftover = [symbol for symbol in total.free_symbols if symbol.name.startswith("_")]
    if leftover:
        raise AssertionError(f"inertia products are not rotation invariant: {leftover}")
    return total


def _moment(factors: Sequence[sp.Symbol]) -> sp.Expr:
    if not factors:
        return m
    owners = [
        (name, axis)
        for symbol in factors
        for name, vector in _VECTORS.items()
        for axis in (0, 1)
        if vector[axis] == symbol
    ]
    if len(owners) == 1:
        name, axis = owners[0]
        return _FIRST_MOMENTS[name][axis]
    (u, i), (v, j) = owners
    if (u, v) not in _PAIRS:
        (u, i), (v, j) = (v, j), (u, i)
    dot, cross = _PAIRS[u, v]
    hidden_yy, hidden_yx = sp.symbols(f"_{u}{v}_yy _{u}{v}_yx")
    # u_x v_x = dot - u_y v_y and u_x v_y = cross + u_y v_x: the hidden parts must cancel
    if i == j:
        known = dot if dot is not None else sp.Symbol(f"_dot_{u}{v}")
        return known - hidden_yy if i == 0 else hidden_yy
    known = cross if cross is not None else sp.Symbol(f"_cross_{u}{v}")
    if u == v:
        return hidden_yx
    return known + hidden_yx if i == 0 else hidden_yx


def _dot(u: Sequence[sp.Expr], v: Sequence[sp.Expr]) -> sp.Expr:
    return sp.Add(*(x * y for x, y in zip(u, v, strict=True)))


@cache
def body_template() -> Template:
    """M_RR ... M_ff and Q_v of Eq. (20) in shape integrals, for a representative pair of modes (a, b)."""
    kinematics = point_kinematics()
    columns = kinematics.columns
    second_mode = [component.subs({f_x: e_x, f_y: e_y}) for component in columns["mode"]]
    mass = {
        "M_RR": (columns["R_x"], columns["R_x"]),
        "M_Rtheta_x": (columns["R_x"], columns["theta"]),
        "M_Rtheta_y": (columns["R_y"], columns["theta"]),
        "M_Rf_x": (columns["R_x"], columns["mode"]),
        "M_Rf_y": (columns["R_y"], columns["mode"]),
        "M_thetatheta": (columns["theta"], columns["theta"]),
        "M_thetaf": (columns["theta"], columns["mode"]),
        "M_ff": (columns["mode"], second_mode),
    }
    outputs = {name: _integrate_over_body(_dot(*pair)) for name, pair in mass.items()}
    force = {"Q_v_x": "R_x", "Q_v_y": "R_y", "Q_v_theta": "theta", "Q_v_f": "mode"}
    for name, column in force.items():
        outputs[name] = _integrate_over_body(-_dot(columns[column], kinematics.bias))
    return Template(outputs)
