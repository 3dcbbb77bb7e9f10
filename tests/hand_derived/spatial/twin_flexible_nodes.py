"""Flexible body of lumped nodes, shared by the spatial flexible twins: data, sums over the nodes.

Node k has the mass m_k and sits at u_k = x_k + Phi_k q_f in the body frame; Phi_k is (3, nf). Nothing is summed
beforehand: no shape integral appears, each node is a particle with its own Jacobian and bias acceleration.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tests.hand_derived.twin_common import Array


@dataclass(frozen=True, eq=False)
class Nodes:
    """masses (N,) kg, positions (N, 3) m, shapes (N, 3, nf), K_ff and D_ff (nf, nf)."""

    masses: Array
    positions: Array
    shapes: Array
    K_ff: Array
    D_ff: Array

    def places(self, q_f: Array) -> Array:
        """u_k (N, 3) in the body frame."""
        return self.positions + self.shapes @ q_f

    def drift(self, q_f_dot: Array) -> Array:
        """u_k' (N, 3) in the body frame."""
        return self.shapes @ q_f_dot


def particle_sums(masses: Array, J: Array, bias: Array, gravity: Array) -> tuple[Array, Array]:
    """Jourdain for particles: M = sum m J^T J, Q = sum m J^T (g - bias); J (N, 3, n), bias (N, 3), world."""
    return np.einsum("k,kai,kaj->ij", masses, J, J), np.einsum("k,kai,ka->i", masses, J, gravity - bias)


def slender_beam(n: int = 6, length: float = 1.2, mass: float = 0.8) -> Nodes:
    """Beam along x clamped at the frame's origin: two bendings in y, one in z, one axial mode, unlike stiffnesses.

    Polynomial shapes with zero value and slope at the clamp: y: s^2 (3 - s), s^3; z: s^2; x: s (2 - s).
    """
    s = np.linspace(0, 1, n)
    masses = mass / (n - 1) * np.concatenate([[0.5], np.ones(n - 2), [0.5]])
    shapes = np.zeros((n, 3, 4))
    shapes[:, 1, 0], shapes[:, 1, 1], shapes[:, 2, 2], shapes[:, 0, 3] = s**2 * (3 - s) / 2, s**3, s**2, s * (2 - s)
    positions = np.stack([length * s, 0 * s, 0 * s], axis=1)
    K_ff = np.array([[9.0, 4.0, 0, 0], [4.0, 14.0, 0, 0], [0, 0, 21.0, 0], [0, 0, 0, 900.0]])
    return Nodes(masses, positions, shapes, K_ff, 0.01 * K_ff)


def scattered(n: int = 7, modes: int = 3, seed: int = 4) -> Nodes:
    """Arbitrary nodes and shapes, so that no shape integral vanishes."""
    rng = np.random.default_rng(seed)
    root = rng.normal(size=(modes, modes))
    K_ff = 30 * (root @ root.T + np.eye(modes))
    shapes = 0.6 * rng.normal(size=(n, 3, modes))
    return Nodes(rng.uniform(0.1, 0.6, n), rng.normal(size=(n, 3)), shapes, K_ff, 0.02 * K_ff)
