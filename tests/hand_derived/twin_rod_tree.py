"""Crank, flexible rod and slider opened into a tree z = (theta1, theta2, q_f): inertia, forces, closure.

Shared by `twin_flexible_slider_crank` (free crank) and `twin_driven_slider_crank` (prescribed crank).

Derivation (Lagrange on the tree, then elimination of theta2 by the closure in the two modules named above)
  e_k = (cos theta_k, sin theta_k), n_k = (-sin, cos), D = theta2 - theta1, w = theta2', v1 = theta1'. The
  rod's floating frame sits at the crank tip; a rod point is R + A(theta2) (rho0 + Phi q). Modal data:
      m2 = int dm, s0 = int rho0 dm, J = int |rho0|^2 dm, P = int Phi dm (2 x nf), d = int rho0.Phi dm,
      e = int (x Phi_y - y Phi_x) dm, G = int (Phi_x,a Phi_y,b - Phi_y,a Phi_x,b) dm (skew),
      M_ff = int Phi^T Phi dm, K_ff, D_ff;  S = s0 + P q.
  Tip: A(theta2) (u, v), u = l2 + shape_x.q, v = shape_y.q. Slider x3 = l1 cos1 + u cos2 - v sin2.
  Velocity of a rod point: l1 v1 n1 + A [w e_z x rho + Phi q'], with n1.e2 = sin D, n1.n2 = cos D. Put
      alpha = cos D S_1 - sin D S_2,   sigma = sin D S_1 + cos D S_2,
      beta  = sin D P_1 + cos D P_2,   eta   = cos D P_1 - sin D P_2
  (dalpha/dD = -sigma, dsigma/dD = alpha, dbeta/dD = eta, dalpha/dq = eta, dsigma/dq = beta). Then
      T = 1/2 (J1 + m1 a1^2 + m2 l1^2) v1^2 + 1/2 I w^2 + 1/2 q'.M_ff q' + w g.q'
          + l1 v1 (w alpha + beta.q') + 1/2 m3 x3'^2
      I = J + 2 d.q + q.M_ff q,   g = e + G^T q,
      x3' = X.z',   X = (-l1 sin1, -u sin2 - v cos2, shape_x cos2 - shape_y sin2)
  Lagrange's velocity terms N = dM/dt z' - dT/dz (without the slider; q'.G q' = 0 because G is skew):
      theta1:  l1 [w (eta.q' - sigma D') + D' eta.q'] + l1 v1 (eta.q' - sigma w)
               =  l1 (2 w eta.q' - sigma w^2),   because D' + v1 = w
      theta2:  2 w (d + M_ff q).q' + l1 v1 (eta.q' - sigma D') - l1 v1 (eta.q' - sigma w)
               =  2 w (d + M_ff q).q' + l1 v1^2 sigma
      q_f:     w G^T q' + l1 v1 D' eta - w^2 (d + M_ff q) - w G q' - l1 v1 w eta
               =  -2 w G q' - w^2 (d + M_ff q) - l1 v1^2 eta
  Slider: m3 X (X.z'' + xi),
      xi = -l1 cos1 v1^2 - (u cos2 - v sin2) w^2 - 2 w (shape_x sin2 + shape_y cos2).q'.
  Forces (gravity g = (gx, gy) an acceleration; the slider stays on y = 0, so that only gx works on it):
      theta1: torque + (m1 a1 + m2 l1) g.n1;   theta2: S_1 g.n2 - S_2 g.e2;
      q_f: P_1 g.e2 + P_2 g.n2 - K q - D_ff q';   plus m3 gx X
  Closure c = l1 sin1 + u sin2 + v cos2 = 0; with r = u cos2 - v sin2 and b = shape_x sin2 + shape_y cos2:
      w = kappa.(v1, q'),  kappa = -(l1 cos1, b) / r
      theta2'' = kappa.(v1', q'') + kappa_0,
      kappa_0 = [l1 sin1 v1^2 + (u sin2 + v cos2) w^2 - 2 w (shape_x cos2 - shape_y sin2).q'] / r
  Position: u sin2 + v cos2 = R sin(theta2 + delta), R^2 = u^2 + v^2, tan delta = v/u, so that
      theta2 = -asin(l1 sin1 / R) - atan(v / u)   on the branch cos(theta2 + delta) > 0, u > 0.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from tests.hand_derived.twin_common import Array


@dataclass(frozen=True, eq=False)
class Rod:
    """Modal data of the rod about its origin, SI units; shapes as named in the module docstring."""

    mass: float
    length: float
    first_moment: Array
    inertia: float
    M_ff: Array
    K_ff: Array
    D_ff: Array
    phi_integral: Array
    rho_dot_phi: Array
    rho_cross_phi: Array
    phi_cross_phi: Array
    shape_x: Array
    shape_y: Array


@dataclass(frozen=True, eq=False)
class Params:
    """Slider-crank with a flexible rod, SI units; J1 about the crank's centre of mass (a1, 0).

    Omega (rad/s) drives the prescribed variant only, torque (N m) the free one only.
    """

    rod: Rod
    l1: float = 0.15
    m1: float = 0.36
    J1: float = 0.000702
    a1: float = 0.075
    m3: float = 0.075552
    J3: float = 1e-4
    gravity: Array = field(default_factory=lambda: np.zeros(2))
    torque: float = 0.0
    Omega: float = 150.0


def coordinates(params: Params) -> list[str]:
    modes = [f"rod.q{k + 1}" for k in range(params.rod.M_ff.shape[0])]
    head = [f"{body}.{part}" for body in ("crank", "rod") for part in ("x", "y", "theta")]
    return [*head, *modes, "slider.x", "slider.y", "slider.theta"]


def theta2_of(params: Params, theta1: complex, q: Array) -> complex:
    """Rod angle from the closure, branch cos > 0."""
    u, v = params.rod.length + params.rod.shape_x @ q, params.rod.shape_y @ q
    return -np.arcsin(params.l1 * np.sin(theta1) / np.sqrt(u**2 + v**2)) - np.arctan(v / u)


@dataclass(frozen=True, eq=False)
class Geometry:
    """What inertia, force and closure share at one z; names as in the derivation."""

    reach: complex  # u cos2 - v sin2
    height: complex  # u sin2 + v cos2
    along: Array  # d reach / dq_f
    across: Array  # d height / dq_f
    alpha: complex
    sigma: complex
    beta: Array
    eta: Array
    moment: Array  # S
    centrifugal: Array  # d + M_ff q
    X: Array


def geometry(params: Params, z: Array) -> Geometry:
    r, q = params.rod, z[2:]
    s2, c2, sd, cd = np.sin(z[1]), np.cos(z[1]), np.sin(z[1] - z[0]), np.cos(z[1] - z[0])
    u, v = r.length + r.shape_x @ q, r.shape_y @ q
    moment, (P_1, P_2) = r.first_moment + r.phi_integral @ q, r.phi_integral
    height, along = u * s2 + v * c2, r.shape_x * c2 - r.shape_y * s2
    return Geometry(
        reach=u * c2 - v * s2,
        height=height,
        along=along,
        across=r.shape_x * s2 + r.shape_y * c2,
        alpha=cd * moment[0] - sd * moment[1],
        sigma=sd * moment[0] + cd * moment[1],
        beta=sd * P_1 + cd * P_2,
        eta=cd * P_1 - sd * P_2,
        moment=moment,
        centrifugal=r.rho_dot_phi + r.M_ff @ q,
        X=np.concatenate([[-params.l1 * np.sin(z[0]), -height], along]),
    )


def tree_mass(params: Params, z: Array, k: Geometry) -> Array:
    """Mass matrix of the tree, (nf + 2) x (nf + 2)."""
    p, r, q = params, params.rod, z[2:]
    mass = p.m3 * k.X[:, None] * k.X
    mass[0, 0] += p.J1 + p.m1 * p.a1**2 + r.mass * p.l1**2
    mass[1, 1] += r.inertia + (r.rho_dot_phi + k.centrifugal) @ q
    mass[0, 1] += p.l1 * k.alpha
    mass[1, 0] += p.l1 * k.alpha
    crank, spin = p.l1 * k.beta, r.rho_cross_phi + q @ r.phi_cross_phi
    mass[0, 2:] += crank
    mass[2:, 0] += crank
    mass[1, 2:] += spin
    mass[2:, 1] += spin
    mass[2:, 2:] += r.M_ff
    return mass


def tree_force(params: Params, z: Array, z_dot: Array, k: Geometry) -> Array:
    """Applied minus velocity terms on the tree, (nf + 2,): tree_mass z'' = tree_force with the loop open."""
    p, r, q = params, params.rod, z[2:]
    v1, w, q_dot = z_dot[0], z_dot[1], z_dot[2:]
    xi = -p.l1 * np.cos(z[0]) * v1**2 - k.reach * w**2 - 2 * w * (k.across @ q_dot)
    n_1 = p.l1 * (2 * w * (k.eta @ q_dot) - k.sigma * w**2)
    n_2 = 2 * w * (k.centrifugal @ q_dot) + p.l1 * v1**2 * k.sigma
    n_f = -2 * w * (r.phi_cross_phi @ q_dot) - w**2 * k.centrifugal - p.l1 * v1**2 * k.eta
    gx, gy = p.gravity
    g_e2, g_n2 = gx * np.cos(z[1]) + gy * np.sin(z[1]), gy * np.cos(z[1]) - gx * np.sin(z[1])
    g_n1 = gy * np.cos(z[0]) - gx * np.sin(z[0])
    f_1 = p.torque + (p.m1 * p.a1 + r.mass * p.l1) * g_n1
    f_2 = k.moment[0] * g_n2 - k.moment[1] * g_e2
    f_f = r.phi_integral[0] * g_e2 + r.phi_integral[1] * g_n2 - r.K_ff @ q - r.D_ff @ q_dot
    return np.concatenate([[f_1 - n_1, f_2 - n_2], f_f - n_f]) + p.m3 * (gx - xi) * k.X


def closure_bias(params: Params, z: Array, z_dot: Array, k: Geometry) -> complex:
    """kappa_0: the part of theta2'' that remains without independent accelerations."""
    v1, w, q_dot = z_dot[0], z_dot[1], z_dot[2:]
    bias = params.l1 * np.sin(z[0]) * v1**2 + k.height * w**2 - 2 * w * (k.along @ q_dot)
    return bias / k.reach


def loop_basis(params: Params, z: Array, k: Geometry) -> Array:
    """B (nf + 2) x (nf + 1): z' = B (theta1', q_f'); its second row is kappa."""
    nf = k.across.size
    basis = np.zeros((nf + 2, nf + 1), dtype=z.dtype)
    basis[0, 0] = 1
    basis[1, 0] = -params.l1 * np.cos(z[0]) / k.reach
    basis[1, 1:] = -k.across / k.reach
    basis[2:, 1:] = np.eye(nf)
    return basis


def full_from_tree(params: Params, z: Array) -> Array:
    """All body coordinates, order crank, rod, slider."""
    zero = 0 * z[0]
    start = [params.l1 * np.cos(z[0]), params.l1 * np.sin(z[0])]
    x3 = start[0] + geometry(params, z).reach
    return np.concatenate([[zero, zero, z[0], *start, z[1]], z[2:], [x3, zero, zero]])
