"""N-four-bar mechanism (case A02 of the IFToMM library): its exact motion of one degree of freedom.

N + 1 cranks A_k B_k, A_k = (k, 0) on the ground, and N couplers B_{k-1} B_k, all bars 1 m, 1 kg, uniform. Cranks
stand upright (+y) at the start, B_0' = (1, 0), gravity 9.81 along -y. phi: common angle of the cranks from the upright,
clockwise: B_k = (k + sin phi, cos phi); couplers stay parallel to the ground and only translate.

Derivation: T = 1/2 I phi'^2, I = (N + 1) 1/3 + N;  V = m_g cos phi, m_g = 9.81 ((N + 1)/2 + N);
    I phi'' = m_g sin phi,   phi'^2 = 1 + 2 (m_g/I) (1 - cos phi).
    The bars lie in one line at phi = pi/2 + n pi, where the mechanism gains a degree of freedom;
    this motion passes there at the times t = integral of dphi / phi'.
"""

from __future__ import annotations

import numpy as np

from tests.hand_derived.twin_common import Array


def pull(N: int) -> float:
    """m_g / I, 1/s^2."""
    return 9.81 * ((N + 1) / 2 + N) / ((N + 1) / 3 + N)


def speed(N: int, phi: Array) -> Array:
    """phi' at the angle phi."""
    return np.sqrt(1 + 2 * pull(N) * (1 - np.cos(phi)))


def time_at(N: int, phi: float) -> float:
    """Time at which the angle phi >= 0 is reached: Gauss-Legendre on pieces of a sixteenth of a revolution."""
    x, w = np.polynomial.legendre.leggauss(24)
    edges = np.linspace(0.0, phi, max(2, int(np.ceil(phi / (np.pi / 8))) + 1))
    half = np.diff(edges) / 2
    points = edges[:-1, None] + half[:, None] * (1 + x)
    return float(np.sum(half[:, None] * w / speed(N, points)))


def angle_at(N: int, t: float) -> float:
    """phi(t) by Newton's method on time_at, whole revolutions taken out first (phi' > 0 throughout)."""
    period = time_at(N, 2 * np.pi)
    turns, rest = divmod(t, period)
    phi = 2 * np.pi * rest / period
    for _ in range(60):
        step = (time_at(N, phi) - rest) * float(speed(N, np.array(phi)))
        phi = min(max(phi - step, 0.0), 2 * np.pi)
        if abs(step) < 1e-14:
            break
    return phi + 2 * np.pi * turns


def singular_times(N: int, t_end: float) -> list[float]:
    """Times up to t_end at which all bars lie in one line."""
    period = time_at(N, 2 * np.pi)
    pair = time_at(N, np.pi / 2), time_at(N, 3 * np.pi / 2)
    times = [turn * period + t for turn in range(int(t_end / period) + 1) for t in pair]
    return [t for t in times if t <= t_end]


def B0(N: int, t: float) -> Array:
    """Position (2,) of B_0."""
    phi = angle_at(N, t)
    return np.array([np.sin(phi), np.cos(phi)])


def B0_dot(N: int, t: float) -> Array:
    """Velocity (2,) of B_0."""
    phi = angle_at(N, t)
    return float(speed(N, np.array(phi))) * np.array([np.cos(phi), -np.sin(phi)])


def energy(N: int) -> float:
    """Energy of the motion with V = m g y summed over the bars, J."""
    return 0.5 * ((N + 1) / 3 + N) + 9.81 * ((N + 1) / 2 + N)
