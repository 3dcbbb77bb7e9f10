"""Orientation of a spatial body's frame, derived in SymPy: rotation matrix A, turning axes, angular velocity (Eq. 17).

For orientation coordinates theta_k the body turns with omega = sum_k g_k theta_k_dot, in body axes with
sum_k gb_k theta_k_dot. The columns gb_k are the axial vectors of A^T dA/dtheta_k, g_k = A gb_k, and the part of
omega_dot in body axes that holds no second derivative is sb = sum_k gb_k_dot theta_k_dot.

Two kinds: Euler angles of any sequence, A = A_1(theta_1) A_2(theta_2) A_3(theta_3) about moving axes, and Euler
parameters (e0, e) of unit length. Products of sines, cosines and parameters are reduced by their norms, s^2 + c^2 = 1
and e.e = 1.
"""

from __future__ import annotations

from functools import cache

import sympy as sp

from symgen.algebra.template import Template, derivative

ANGLES = 3
cosines, sines = sp.symbols("c1:4"), sp.symbols("s1:4")
angle_rates = sp.symbols("theta1_dot theta2_dot theta3_dot")
e, e_dot = sp.symbols("e0:4"), sp.symbols("e0_dot e1_dot e2_dot e3_dot")


def _elementary(axis: str, cosine: sp.Expr, sine: sp.Expr) -> sp.Matrix:
    """Rotation about a coordinate axis."""
    i = "xyz".index(axis)
    j, k = (i + 1) % 3, (i + 2) % 3
    rotation = sp.eye(3)
    rotation[j, j] = rotation[k, k] = cosine
    rotation[j, k], rotation[k, j] = -sine, sine
    return rotation


def axial(matrix: sp.Matrix) -> list[sp.Expr]:
    """Vector v of a skew matrix v~ (the mean of its two halves)."""
    return [(matrix[2, 1] - matrix[1, 2]) / 2, (matrix[0, 2] - matrix[2, 0]) / 2, (matrix[1, 0] - matrix[0, 1]) / 2]


def _outputs(A: sp.Matrix, body: list[list[sp.Expr]], world: list[list[sp.Expr]], bias: list[sp.Expr]) -> Template:
    outputs = {f"A_{i}{j}": A[i, j] for i in range(3) for j in range(3)}
    for k, (in_body, in_world) in enumerate(zip(body, world, strict=True)):
        outputs |= {f"gb_{k}_{i}": value for i, value in enumerate(in_body)}
        outputs |= {f"g_{k}_{i}": value for i, value in enumerate(in_world)}
    outputs |= {f"sb_{i}": value for i, value in enumerate(bias)}
    return Template(outputs)


@cache
def euler_angles(sequence: str) -> Template:
    """Outputs A_ij, gb_k_i, g_k_i, sb_i in the cosines and sines of three angles and their rates."""
    parts = [_elementary(axis, c, s) for axis, c, s in zip(sequence, cosines, sines, strict=True)]
    A = parts[0] * parts[1] * parts[2]
    turns = {s: c for s, c in zip(sines, cosines, strict=True)} | {c: -s for s, c in zip(sines, cosines, strict=True)}
    body, world = [], []
    for k in range(ANGLES):
        own = {x: d for x, d in turns.items() if x in (sines[k], cosines[k])}
        slope = A.applyfunc(lambda entry, own=own: derivative(entry, own))
        body.append([_reduced(entry) for entry in axial(A.T * slope)])
        world.append([_reduced(entry) for entry in axial(slope * A.T)])
    rates = {x: d * rate for k, rate in enumerate(angle_rates) for x, d in turns.items() if x in (sines[k], cosines[k])}
    bias = [sp.Add(*(derivative(body[k][i], rates) * angle_rates[k] for k in range(ANGLES))) for i in range(3)]
    return _outputs(A, body, world, bias)


def _reduced(expression: sp.Expr) -> sp.Expr:
    """Normal form with s^2 = 1 - c^2."""
    result = sp.expand(expression)
    for sine, cosine in zip(sines, cosines, strict=True):
        while sp.degree(result, sine) >= 2:
            result = sp.expand(sp.rem(sp.Poly(result, sine), sp.Poly(sine**2 + cosine**2 - 1, sine)).as_expr())
    return result


@cache
def euler_parameters() -> Template:
    """Outputs A_ij, gb_k_i, g_k_i, sb_i in the Euler parameters (scalar first) and their rates."""
    e0, vector = e[0], sp.Matrix(e[1:])
    tilde = sp.Matrix([[0, -e[3], e[2]], [e[3], 0, -e[1]], [-e[2], e[1], 0]])
    A = 2 * (vector * vector.T + e0 * tilde)
    for i in range(3):  # 2 e0^2 - 1 + 2 e_i^2 = 1 - 2 (e_j^2 + e_k^2)
        A[i, i] = 1 - 2 * sp.Add(*(e[j] ** 2 for j in range(1, 4) if j != i + 1))
    rates = dict(zip(e, e_dot, strict=True))
    slope = A.applyfunc(lambda entry: derivative(entry, rates))
    norm = sp.groebner(
        [sp.Add(*(x**2 for x in e)) - 1, sp.Add(*(x * v for x, v in zip(e, e_dot, strict=True)))],
        *e_dot,
        *e,
        order="grevlex",
    )
    body_rate = [norm.reduce(sp.expand(entry))[1] for entry in axial(A.T * slope)]
    world_rate = [norm.reduce(sp.expand(entry))[1] for entry in axial(slope * A.T)]
    body = [[sp.diff(entry, rate) for entry in body_rate] for rate in e_dot]
    world = [[sp.diff(entry, rate) for entry in world_rate] for rate in e_dot]
    bias = [sp.expand(sp.Add(*(derivative(body[k][i], rates) * e_dot[k] for k in range(4)))) for i in range(3)]
    return _outputs(A, body, world, bias)
