"""Mass blocks and quadratic-velocity force of a spatial flexible body, derived in SymPy (Eq. 20).

All in body axes: a mass point at rho = rho0 + Phi q_f, rho_dot = Phi q_f_dot, of a body with angular velocity w has

    velocity       v_o + w x rho + rho_dot                      (v_o: velocity of the frame origin)
    acceleration   a_o + w_dot x rho + Phi q_f_ddot + w x (w x rho) + 2 w x rho_dot + nu

(nu = -q_f_dot^T H q_f_dot where the shapes are of second order). The virtual work of its inertia forces, summed over
the points, gives the blocks. They are written below in shape integrals, with the sums that many entries share as
symbols of their own; `body_template` derives them from the two lines above for one point and compares. As every block
is linear in the mass, what holds for a point holds for the body.

    h = int rho dm, J = int rho rho^T dm, u = J w, L_a = int rho phi_a^T dm, B_a = int rho x phi_a dm,
    s_a = int phi_a dm, W = int rho rho_dot^T dm, y = W^T w, tW = tr W, hd = int rho_dot dm, x_a = w.(L_a w),
    tL_a = tr L_a, Gd_a = int rho_dot x phi_a dm, hn = int nu dm
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache

import sympy as sp

from symgen.algebra.template import Template

Vector = Sequence[sp.Expr]


def _vector(name: str) -> tuple[sp.Symbol, sp.Symbol, sp.Symbol]:
    x, y, z = sp.symbols(f"{name}_x {name}_y {name}_z")
    return x, y, z


m, tW, tL, x_a, ww = sp.symbols("m tW tL_a x_a ww")
J = [[sp.Symbol(f"J_{min(i, j)}{max(i, j)}") for j in range(3)] for i in range(3)]
w, h, u, y, hd, hn, s, B, Gd = (_vector(name) for name in ("w", "h", "u", "y", "hd", "hn", "s_a", "B_a", "Gd_a"))


def cross(a: Vector, b: Vector) -> list[sp.Expr]:
    """a x b."""
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a: Vector, b: Vector) -> sp.Expr:
    """a . b."""
    return sp.Add(*(p * q for p, q in zip(a, b, strict=True)))


def _mass() -> dict[str, sp.Expr]:
    """M_RR, M_Rturn, M_turnturn, M_Rf, M_turnf in shape integrals, body axes."""
    blocks: dict[str, sp.Expr] = {"M_RR": m}
    for i in range(3):
        blocks |= {f"M_Rf_{i}": s[i], f"M_turnf_{i}": B[i]}
        for j in range(3):
            blocks[f"M_Rturn_{i}{j}"] = cross([sp.Integer(k == j) for k in range(3)], h)[i]
            inertia = sp.Add(*(J[k][k] for k in range(3) if k != i)) if i == j else -J[i][j]
            blocks[f"M_turnturn_{i}{j}"] = inertia
    return blocks


def _force() -> dict[str, list[sp.Expr]]:
    """Q_v in shape integrals: on R_o (body axes), on the rotation (moment in body axes), on mode a."""
    inner = [p + 2 * q for p, q in zip(cross(w, h), hd, strict=True)]
    return {
        "R": [-p - q for p, q in zip(cross(w, inner), hn, strict=True)],
        "turn": [p - 2 * (tW * q - r) for p, q, r in zip(cross(w, u), w, y, strict=True)],
        "mode": [ww * tL - x_a - 2 * dot(w, Gd)],
    }


def _of_one_point() -> tuple[dict[str, sp.Expr], dict[sp.Symbol, sp.Expr]]:
    """Blocks of a unit mass point from its velocity and acceleration, and the shape integrals of that point."""
    rho, phi, rate, nu = (_vector(name) for name in ("rho", "phi", "rate", "nu"))
    units = [[sp.Integer(i == k) for i in range(3)] for k in range(3)]
    bias = [p + 2 * q + r for p, q, r in zip(cross(w, cross(w, rho)), cross(w, rate), nu, strict=True)]
    partial = {"R": units, "turn": [cross(unit, rho) for unit in units], "mode": [list(phi)]}
    kept = {symbol: 0 for symbol in nu}  # pairs with nu are beyond the second order that the energy keeps
    blocks = {
        f"Q_{name}_{i}": -dot(column, bias) if name == "R" else (-dot(column, bias)).subs(kept)
        for name, columns in partial.items()
        for i, column in enumerate(columns)
    }
    blocks["M_RR"] = dot(units[0], units[0])
    for i in range(3):
        blocks |= {f"M_Rf_{i}": dot(units[i], phi), f"M_turnf_{i}": dot(partial["turn"][i], phi)}
        for j in range(3):
            blocks[f"M_Rturn_{i}{j}"] = dot(units[i], partial["turn"][j])
            blocks[f"M_turnturn_{i}{j}"] = dot(partial["turn"][i], partial["turn"][j])
    values = {m: sp.Integer(1), tW: dot(rho, rate), tL: dot(rho, phi), x_a: dot(w, rho) * dot(phi, w), ww: dot(w, w)}
    pairs = [
        (h, rho),
        (u, [p * dot(rho, w) for p in rho]),
        (y, [p * dot(rho, w) for p in rate]),
        (hd, rate),
        (hn, nu),
        (Gd, cross(rate, phi)),
        (s, phi),
        (B, cross(rho, phi)),
    ]
    for names, components in pairs:
        values |= dict(zip(names, components, strict=True))
    values |= {J[i][j]: rho[i] * rho[j] for i in range(3) for j in range(3)}
    return blocks, values


PER_MODE = tuple(f"{block}_{i}" for block in ("M_Rf", "M_turnf") for i in range(3))
FORCE_ON_MODE = "Q_mode_0"


@cache
def body_template() -> Template:
    """M_RR, M_Rturn_ij, M_turnturn_ij, M_Rf_i, M_turnf_i and Q_R_i, Q_turn_i, Q_mode_0 of Eq. (20), in body axes."""
    outputs = _mass() | {
        f"Q_{name}_{i}": component for name, components in _force().items() for i, component in enumerate(components)
    }
    derived, values = _of_one_point()
    for name, written in outputs.items():
        if sp.expand(written.subs(values, simultaneous=True) - derived[name]) != 0:
            raise AssertionError(f"{name} is not what the mass point's motion gives")
    return Template(outputs)
