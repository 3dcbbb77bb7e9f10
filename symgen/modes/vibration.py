"""The free-vibration problem of the mesh, K w = lambda M w, solved through the nodal flexibility."""

from __future__ import annotations

import numpy as np

from symgen.modes.cleaning import Array

SIGN_THRESHOLD = 1e-6
RIGID_RATIO = 1e-2


def free_vibration(
    flexibility: Array, masses: Array, count: int, mirrored: bool, rigid: Array | None = None
) -> tuple[Array, Array]:
    """Lowest `count` elastic modes: eigenvalues lambda = omega^2 (count,) ascending and shapes w (k, count).

    flexibility (k, k) and lumped masses (k,) belong to the k free nodes.
    mirrored: supports and mesh are symmetric about the middle; the symmetric and antisymmetric shapes are
    then sought apart, which makes their symmetry exact.
    rigid (k, r): rigid motions of an unsupported body, removed by mass-orthogonal projection.
    Shapes are orthogonal in the masses; the caller normalises them.
    """
    root = np.sqrt(masses)
    dynamic = root[:, None] * flexibility * root[None, :]
    held = np.linalg.qr(root[:, None] * rigid)[0] if rigid is not None else np.zeros((len(masses), 0))
    values: list[Array] = []
    vectors: list[Array] = []
    for basis in _parity_bases(len(masses)) if mirrored else [np.eye(len(masses))]:
        held_part = basis.T @ held
        projector = np.eye(basis.shape[1]) - held_part @ held_part.T
        part = projector @ (basis.T @ dynamic @ basis) @ projector
        part_values, part_vectors = np.linalg.eigh(0.5 * (part + part.T))
        values.append(part_values[::-1][:count])
        # Project once more: modes with small eigenvalues may have picked up a trace of rigid motion.
        vectors.append(basis @ (projector @ part_vectors[:, ::-1][:, :count]))
    inverse = np.concatenate(values)
    order = np.argsort(-inverse, kind="stable")[:count]
    return 1.0 / inverse[order], np.concatenate(vectors, axis=1)[:, order] / root[:, None]


def _parity_bases(nodes: int) -> list[Array]:
    """Orthonormal bases of the shapes that are symmetric and antisymmetric about the middle node."""
    half = nodes // 2
    near = np.arange(half)
    bases = []
    for sign in (1.0, -1.0):
        middle = nodes % 2 if sign > 0 else 0
        basis = np.zeros((nodes, half + middle))
        basis[near, near] = np.sqrt(0.5)
        basis[nodes - 1 - near, near] = sign * np.sqrt(0.5)
        if middle:
            basis[half, half] = 1.0
        bases.append(basis)
    return [basis for basis in bases if basis.shape[1]]


def normalised(shapes: Array) -> Array:
    """Shapes (k, modes) with largest nodal value 1; the first value above 1e-6 in magnitude is positive."""
    scaled = shapes / np.max(np.abs(shapes), axis=0)
    first = np.argmax(np.abs(scaled) > SIGN_THRESHOLD, axis=0)
    return np.asarray(scaled * np.sign(scaled[first, np.arange(scaled.shape[1])]))


def check_rigid_modes(stiffness: Array, masses: Array, count: int) -> None:
    """Check that an unsupported mesh has exactly `count` rigid modes: stiffness (k, k), lumped masses (k,).

    Raises RuntimeError otherwise: the projection would then remove elastic motion or keep rigid motion.
    """
    root = np.sqrt(masses)
    values = np.linalg.eigvalsh(stiffness / np.outer(root, root))
    limit = RIGID_RATIO * values[count]
    if not (values[count] > 0.0 and np.all(np.abs(values[:count]) < limit)):
        found = values[: count + 1]
        raise RuntimeError(f"expected {count} rigid modes, found eigenvalues {found}; check the stiffness")
