"""The orientation of one spatial body: its type's SymPy template evaluated with its SX coordinates (Eq. 17).

Orientation of a spatial body's frame, derived in SymPy: rotation matrix A, turning axes, angular velocity (Eq. 17).

For orientation coordinates theta_k the body turns with omega = sum_k g_k theta_k_dot, in body axes with
sum_k gb_k theta_k_dot. The columns gb_k are the axial vectors of A^T dA/dtheta_k, g_k = A gb_k, and the part of
omega_dot in body axes that holds no second derivative is sb = sum_k gb_k_dot theta_k_dot.

theta are Euler parameters (e0, e) of unit length. Products of them are reduced by e.e = 1.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import casadi as ca
import sympy as sp

from runtime.contract.orientations import angles_of
from symgen.algebra.scalar import ONE, ZERO
from symgen.algebra.template import Template, derivative
from symgen.algebra.vectors import Vector, combination, cross, plus, times

e, e_dot = sp.symbols("e0:4"), sp.symbols("e0_dot e1_dot e2_dot e3_dot")


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


@dataclass(frozen=True)
class Orientation:
    """A (rows), turning axes of each coordinate in body and world axes, omega, and omega_dot without theta''.

    coordinates: SX of theta, the Euler parameters. Ground has none and A = 1.
    """

    coordinates: Vector
    A: list[Vector]
    body_axes: list[Vector]
    world_axes: list[Vector]
    omega_body: Vector
    omega: Vector
    bias_body: Vector
    bias: Vector

    def rotate(self, body_vector: Vector) -> Vector:
        """World components of a vector in body axes."""
        return times(self.A, body_vector)

    def turned(self, k: int, world_vector: Vector) -> Vector:
        """d(A v)/dtheta_k of a vector v fixed in the body, whose world components are given."""
        return cross(self.world_axes[k], world_vector)


def fixed_orientation() -> Orientation:
    """The ground's."""
    zero = [ZERO] * 3
    unit = [[ONE if i == j else ZERO for j in range(3)] for i in range(3)]
    return Orientation([], unit, [], [], zero, zero, zero, zero)


def orientation(theta: Vector, theta_dot: Vector) -> Orientation:
    """Orientation by Euler parameters."""
    values = dict(zip((*e, *e_dot), (*theta, *theta_dot), strict=True))
    out = euler_parameters().evaluate(values)
    n = len(theta)
    A = [[out[f"A_{i}{j}"] for j in range(3)] for i in range(3)]
    body = [[out[f"gb_{k}_{i}"] for i in range(3)] for k in range(n)]
    world = [[out[f"g_{k}_{i}"] for i in range(3)] for k in range(n)]
    bias_body = [out[f"sb_{i}"] for i in range(3)]
    return Orientation(
        theta,
        A,
        body,
        world,
        combination(body, theta_dot),
        combination(world, theta_dot),
        bias_body,
        plus(times(A, bias_body)),
    )


def euler_angle(kind: str, k: int, e: Vector) -> ca.SX:
    """Angle k of the sequence `kind` at Euler parameters e."""
    value: ca.SX = angles_of(kind, e, ca.atan2, ca.cos, ca.sin)[k]
    return value
