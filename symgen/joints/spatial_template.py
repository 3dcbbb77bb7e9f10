"""From a joint's rows in the markers' points and axes to C, C_q, C_t and gamma in space (Eqs. 21-27), in SymPy.

A joint type states only its rows C(r_a, axes_a, r_b, axes_b, f(t)) = 0. An axis turns with its marker: its virtual
change is pi x axis, its rate omega x axis. Axis rates are symbols of their own, which keeps second derivatives short.
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from symgen.algebra.template import Template, derivative
from symgen.joints.joint_type import JointType, f, f_t, f_tt

Vector = tuple[sp.Expr, sp.Expr, sp.Expr]


def _vector(name: str) -> Vector:
    x, y, z = sp.symbols(f"{name}_x {name}_y {name}_z")
    return x, y, z


r_a, r_b, r_a_dot, r_b_dot = (_vector(name) for name in ("r_a", "r_b", "r_a_dot", "r_b_dot"))
omega_a, omega_b = _vector("omega_a"), _vector("omega_b")
axes = {f"{axis}_{marker}": _vector(f"{axis}_{marker}") for marker in "ab" for axis in "xyz"}
axis_rates = {name: _vector(f"{name}_dot") for name in axes}
travel, travel_dot = _vector("travel"), _vector("travel_dot")
x_a, y_a, z_a, x_b, y_b, z_b = (axes[name] for name in ("x_a", "y_a", "z_a", "x_b", "y_b", "z_b"))
d: Vector = (r_b[0] - r_a[0], r_b[1] - r_a[1], r_b[2] - r_a[2])


def dot(u: Sequence[sp.Expr], v: Sequence[sp.Expr]) -> sp.Expr:
    """u . v."""
    return sp.Add(*(p * q for p, q in zip(u, v, strict=True)))


def _cross(u: Sequence[sp.Expr], v: Sequence[sp.Expr]) -> list[sp.Expr]:
    return [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]


def _turn(marker: str, k: int) -> dict[sp.Symbol, sp.Expr]:
    """Virtual rotation of a marker about world axis k."""
    unit = [sp.Integer(i == k) for i in range(3)]
    rules: dict[sp.Symbol, sp.Expr] = {}
    for name, axis in axes.items():
        if name.endswith(marker):
            rules |= dict(zip(axis, _cross(unit, axis), strict=True))
    return rules


def _rates() -> dict[sp.Symbol, sp.Expr]:
    rules: dict[sp.Symbol, sp.Expr] = {f: f_t, f_t: f_tt}
    for values, slopes in ((r_a, r_a_dot), (r_b, r_b_dot), (travel, travel_dot)):
        rules |= dict(zip(values, slopes, strict=True))
    for name, axis in axes.items():
        omega = omega_a if name.endswith("a") else omega_b
        rules |= dict(zip(axis, axis_rates[name], strict=True))
        rules |= dict(zip(axis_rates[name], _cross(omega, axis_rates[name]), strict=True))
    return rules


SLOTS = (*(f"{point}_{axis}" for point in ("r_a", "r_b", "turn_a", "turn_b", "travel") for axis in "xyz"),)


def spatial_joint_type(rows: Sequence[tuple[str, sp.Expr]]) -> JointType:
    """Derive the template of a joint from its labelled constraint rows; slots as in SLOTS."""
    outputs: dict[str, sp.Expr] = {}
    rates = _rates()
    for k, (_, row) in enumerate(rows):
        outputs[f"C_{k}"] = row
        for symbol in (*r_a, *r_b, *travel):
            outputs[f"C_{k}_{symbol.name}"] = sp.diff(row, symbol)
        for marker in "ab":
            for i, axis in enumerate("xyz"):
                outputs[f"C_{k}_turn_{marker}_{axis}"] = derivative(row, _turn(marker, i))
        outputs[f"C_t_{k}"] = derivative(row, {f: f_t})
        outputs[f"drift_{k}"] = derivative(derivative(row, rates), rates)
    return JointType(tuple(label for label, _ in rows), Template(outputs))


def placed() -> list[tuple[str, sp.Expr]]:
    """r_b - r_a - travel along the axes of marker a: nothing for a hinge, the joint's own coordinates for a slide."""
    return [
        (label, d[i] - travel[0] * x_a[i] - travel[1] * y_a[i] - travel[2] * z_a[i]) for i, label in enumerate("xyz")
    ]


def parallel() -> list[tuple[str, sp.Expr]]:
    """z_b along z_a."""
    return [("parallel_x", dot(z_b, x_a)), ("parallel_y", dot(z_b, y_a))]


def aligned() -> list[tuple[str, sp.Expr]]:
    """The axes of b along those of a."""
    return [*parallel(), ("twist", dot(x_b, y_a))]


def on_axis() -> list[tuple[str, sp.Expr]]:
    """Point b on the z-axis of marker a."""
    return [("across_x", dot(x_a, d)), ("across_y", dot(y_a, d))]
