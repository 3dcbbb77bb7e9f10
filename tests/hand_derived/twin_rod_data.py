"""Modal data of the rod for the slider-crank twins: case F1 and pinned sine modes.

Case F1 (Simeon; IVP test set "crank"). Shapes on xi = x/L: lateral sin(pi xi), sin(2 pi xi); axial,
nodes at the middle and the end, N_mid = 4 xi (1 - xi), N_end = xi (2 xi - 1).
Integrals over xi from 0 to 1 (times rho A L: the mass integrals):
    N_mid: 2/3         N_end: 1/6          xi N_mid: 1/3      xi N_end: 1/2 - 1/3 = 1/6
    sin(pi xi): 2/pi   sin(2 pi xi): 0     xi sin(pi xi): 1/pi   xi sin(2 pi xi): -1/(2 pi)
    xi^2 sin(pi xi) = 1/pi - 4/pi^3        xi^2 sin(2 pi xi) = -1/(2 pi)
    N_mid sin(pi xi)  = 4 [1/pi - 1/pi + 4/pi^3] = 16/pi^3
    N_mid sin(2 pi xi) = 4 [-1/(2 pi) + 1/(2 pi)] = 0
    N_end sin(pi xi)  = 2/pi - 8/pi^3 - 1/pi = 1/pi - 8/pi^3
    N_end sin(2 pi xi) = -1/pi + 1/(2 pi) = -1/(2 pi)
G_ab = int (Phi_x,a Phi_y,b - Phi_y,a Phi_x,b) dm: for axial a and lateral b it is + int N_a sin_b (skew).
M_ff and K_ff are the published ones; M_ff's axial block lacks the factor 1/15 of a quadratic element, and
the published code has pi = 3.1415927.
"""

from __future__ import annotations

import numpy as np

from tests.hand_derived.twin_common import Array
from tests.hand_derived.twin_rod_tree import Params, Rod

F1_PI = 3.1415927
# q_i and q_i' at t = 0 and published values at t = 0.1 (driven variant)
F1_START = np.array([0.0, 0.0, 0.103339863e-4, 0.169327969e-4])
F1_START_RATE = np.array([0.444896112581599, 0.00463433931923867, -1.78591076000055e-6, -2.68938671997904e-6])
F1_END = np.array([1.893192899613509e-4, 2.375751249879174e-5, -5.323896770569702e-6, -8.363313279112129e-6])
F1_END_PHI2, F1_END_PHI2_RATE, F1_END_X3 = -0.3311734988256260, 60.25346755138369, 0.1697373328427860


def f1_rod() -> Rod:
    """Case F1's rod: 2 lateral sine modes, then the 2 axial nodal coordinates."""
    rho, width, height, length, modulus, pi = 7870.0, 0.008, 0.008, 0.30, 2e11, F1_PI
    mass = rho * width * height * length
    stiff = modulus * width * height / length
    slender = (height / length) ** 2
    mass_ff, stiff_ff, cross = np.zeros((4, 4)), np.zeros((4, 4)), np.zeros((4, 4))
    mass_ff[:2, :2] = mass * np.diag([0.5, 0.5])
    mass_ff[2:, 2:] = mass * np.array([[8.0, 1.0], [1.0, 2.0]])
    stiff_ff[:2, :2] = stiff * np.diag([pi**4 / 24 * slender, 2 / 3 * pi**4 * slender])
    stiff_ff[2:, 2:] = stiff / 3 * np.array([[16.0, -8.0], [-8.0, 7.0]])
    cross[2:, :2] = mass * np.array([[16 / pi**3, 0.0], [1 / pi - 8 / pi**3, -0.5 / pi]])
    cross[:2, 2:] = -cross[2:, :2].T
    return Rod(
        mass=0.151104,
        length=length,
        first_moment=np.array([0.151104 * length / 2, 0.0]),
        inertia=0.0045339259,
        M_ff=mass_ff,
        K_ff=stiff_ff,
        D_ff=np.zeros((4, 4)),
        phi_integral=mass * np.array([[0.0, 0.0, 2 / 3, 1 / 6], [2 / pi, 0.0, 0.0, 0.0]]),
        rho_dot_phi=mass * length * np.array([0.0, 0.0, 1 / 3, 1 / 6]),
        rho_cross_phi=mass * length * np.array([1 / pi, -0.5 / pi, 0.0, 0.0]),
        phi_cross_phi=cross,
        shape_x=np.array([0.0, 0.0, 0.0, 1.0]),
        shape_y=np.zeros(4),
    )


def f1_params(torque: float = 0.0, gravity: Array | None = None) -> Params:
    """Case F1. The crank's inertia about its pin is the published 0.002727 = J1 + m1 (l1/2)^2."""
    weight = np.zeros(2) if gravity is None else gravity
    return Params(rod=f1_rod(), J1=0.002727 - 0.36 * 0.075**2, gravity=weight, torque=torque)


def pinned_sine_rod(nf: int = 2, damping_ratio: float = 0.0) -> Rod:
    """F1's rod with `nf` lateral modes sin(k pi x / L) only; the tip does not move in the rod's frame.

    int sin^2 = L/2; bending E I (k pi)^4 / (2 L^3); int sin = L (1 - cos k pi)/(k pi); int x sin = -L^2
        cos(k pi)/(k pi).
    Modal damping 2 zeta omega_k M_kk.
    """
    rho, width, height, length, modulus = 7870.0, 0.008, 0.008, 0.30, 2e11
    mass, second_moment = rho * width * height * length, width * height**3 / 12
    k = np.arange(1, nf + 1)
    k_pi, sign = np.pi * k, np.where(k % 2 == 0, 1.0, -1.0)  # sign = cos(k pi)
    modal_mass = np.full(nf, mass / 2)
    modal_stiffness = modulus * second_moment * k_pi**4 / (2 * length**3)
    return Rod(
        mass=mass,
        length=length,
        first_moment=np.array([mass * length / 2, 0.0]),
        inertia=mass * length**2 / 3,
        M_ff=np.diag(modal_mass),
        K_ff=np.diag(modal_stiffness),
        D_ff=np.diag(2 * damping_ratio * np.sqrt(modal_stiffness * modal_mass)),
        phi_integral=np.vstack([np.zeros(nf), mass * (1 - sign) / k_pi]),
        rho_dot_phi=np.zeros(nf),
        rho_cross_phi=-mass * length * sign / k_pi,
        phi_cross_phi=np.zeros((nf, nf)),
        shape_x=np.zeros(nf),
        shape_y=np.zeros(nf),
    )


def general_params(seed: int = 0, nf: int = 3) -> Params:
    """A random rod with every integral and shape non-zero: no term of the derivation is idle."""
    rng = np.random.default_rng(seed)
    mass, length = 0.15, 0.3
    square, skew, damp = rng.normal(size=(3, nf, nf))
    rod = Rod(
        mass=mass,
        length=length,
        first_moment=mass * np.array([0.16, 0.02]),
        inertia=0.0046,
        M_ff=mass * (np.eye(nf) + 0.02 * square @ square.T),
        K_ff=2e5 * (np.eye(nf) + 0.1 * square.T @ square),
        D_ff=0.5 * damp @ damp.T,
        phi_integral=mass * rng.uniform(-0.5, 0.5, size=(2, nf)),
        rho_dot_phi=mass * length * rng.uniform(-0.3, 0.3, size=nf),
        rho_cross_phi=mass * length * rng.uniform(-0.3, 0.3, size=nf),
        phi_cross_phi=0.1 * mass * (skew - skew.T),
        shape_x=rng.uniform(-1, 1, size=nf),
        shape_y=rng.uniform(-1, 1, size=nf),
    )
    return Params(rod=rod, gravity=np.array([1.3, -9.81]), torque=2.5)
