"""Amplification matrices of the sub-stepping schemes on case L1, from the equations written here.

Model: M a = -K x - D v with x = (x_L, x_S), M = [[1, c], [c, 1]], K = diag(k_L, w^2), D = diag(0, 2 zeta w).
Every scheme is linear here, so its action on unit states is its matrix.

Held slow coordinate (`coupled`), dt = m h, state y = (x, v, a, x_last, v_last), each of two numbers:
  once a major step, with ahead = (dt + h) / 2 = (1 + 1/m) / 2 of dt,
    x* = x + (1 + 1/m) / 2 (x - x_last),   v* = v + (1 + 1/m) / 2 (v - v_last),
    then x_last = x, v_last = v;
  m times, with u = v + h a / 2:
    x <- x + h u,   a <- from the rows below at velocity u + h a / 2 (the old a),   v <- u + h a / 2 (the new a).
    both rows at once, x_L replaced by x_L* in them: M a = (-k_L x_L*,  -w^2 x_S - 2 zeta w v_S).
  With m = 1 nothing is held: x_L itself stands in the rows.

Decoupled, dt = m h: Y = x_L + c x_S has Y'' = Q_L, which is constant over a major step. State (x, v, x_last, v_last,
Y''):
  half a step of Y with the last Y'', and x_S on its secant, say where x_L is in the middle,
    x* = Y + dt/2 Y' + dt^2/8 Y'' - c (x_S + (x_S - x_last_S) / 2);   then Y'' = -k_L x*, x_last = x, v_last = v;
  x_S by m steps of (1 - c^2) a_S = -w^2 x_S - 2 zeta w v_S - c Y'', the first a_S at the start of the major step,
    u = v_S + h a_S / 2,   x_S <- x_S + h u,   a_S <- at velocity u + h a_S / 2 (the old a_S),   v_S <- u + h a_S / 2;
  at the end Y <- Y + dt Y' + dt^2/2 Y'', Y' <- Y' + dt Y'' and x_L = Y - c x_S.

Linearised, a linear system: y = (x, v) is carried by m sub-steps h = dt / m of the system itself.
  rational: R(h A)^m, A = [0 1; -M^-1 K, -M^-1 D], R(z) = P(z) / P(-z) with P = 1 + z/2 + z^2/10 + z^3/120, the
    diagonal Pade approximation of exp of degree (3, 3).
  central difference: a = M^-1 (-K x - D v) at the start of the major step, then m of the steps above with
    M a = -K x - D (u + h a / 2).
Exponential, rational: the same R(h A)^m (what it adds corrects for the change of the system, and there is none).
Classical Runge-Kutta of order 4: 1 + z + z^2/2 + z^3/6 + z^4/24 at z = dt A.
"""

from __future__ import annotations

import numpy as np

from tests.hand_derived.twin_common import Array
from tests.hand_derived.twin_oscillators import Params


def matrices(p: Params) -> tuple[Array, Array, Array]:
    """M, K, D."""
    return (np.array([[1.0, p.c], [p.c, 1.0]]), np.diag([p.k_L, p.w**2]), np.diag([0.0, 2 * p.zeta * p.w]))


def generator(p: Params) -> Array:
    """A of y' = A y, y = (x, v)."""
    M, K, D = matrices(p)
    return np.block([[np.zeros((2, 2)), np.eye(2)], [-np.linalg.solve(M, K), -np.linalg.solve(M, D)]])


def held_slow_matrix(p: Params, dt: float, m: int) -> Array:
    """One major step dt of `coupled` on (x, v, a, x_last, v_last)."""
    M, _, _ = matrices(p)
    h, share = dt / m, (1 + 1 / m) / 2
    x, v, a, x_last, v_last = np.eye(10).reshape(5, 2, 10)
    x_star = x + share * (x - x_last)
    x_last, v_last = x, v
    for _ in range(m):
        u = v + h / 2 * a
        x, old = x + h * u, a
        velocity = u + h / 2 * old
        force_L = -p.k_L * (x_star[0] if m > 1 else x[0])
        force_S = -(p.w**2) * x[1] - 2 * p.zeta * p.w * velocity[1]
        a = np.linalg.solve(M, np.array([force_L, force_S]))
        v = u + h / 2 * a
    return np.concatenate([x, v, a, x_last, v_last])


def pade(z: Array) -> Array:
    """R(z) of degree (3, 3) of a matrix."""
    one, square = np.eye(len(z)), z @ z
    even, odd = one + square / 10, z @ (one / 2 + square / 120)
    return np.linalg.solve(even - odd, even + odd)


def pade_of_five(z: Array) -> Array:
    """R(z) of degree (5, 5), from its eigenvalues: fifth powers of a stiff matrix leave no digits."""
    values, vectors = np.linalg.eig(z)
    square = values * values
    even, odd = 1 + square * (1 / 9 + square / 1_008), values * (1 / 2 + square * (1 / 72 + square / 30_240))
    return (vectors * ((even + odd) / (even - odd)) @ np.linalg.inv(vectors)).real


def rational_matrix(p: Params, dt: float, m: int) -> Array:
    """One major step of `exponential` with rational sub-steps on (x, v)."""
    return np.linalg.matrix_power(pade(dt / m * generator(p)), m)


def runge_kutta_matrix(p: Params, dt: float) -> Array:
    """One step of the classical method on (x, v)."""
    z = dt * generator(p)
    return np.eye(4) + z @ (np.eye(4) + z / 2 @ (np.eye(4) + z / 3 @ (np.eye(4) + z / 4)))


def radius(matrix: Array) -> float:
    """Spectral radius."""
    return float(np.max(np.abs(np.linalg.eigvals(matrix))))


def modes(p: Params) -> tuple[Array, Array]:
    """Frequencies of the undamped system, ascending, and of each mode the share kappa = k_L x_L^2 / (x M x)."""
    M, K, _ = matrices(p)
    squares, shapes = np.linalg.eig(np.linalg.solve(M, K))
    order = np.argsort(squares.real)
    shapes = shapes[:, order].real
    return np.sqrt(squares.real[order]), p.k_L * shapes[0] ** 2 / np.einsum("ij,ij->j", shapes, M @ shapes)
