"""Bars and chains with known motions, written down by hand."""

from __future__ import annotations

import numpy as np
import scipy.sparse as sp

from runtime.structures import LinearStructure


def bar(lengths: np.ndarray, held: bool = True) -> tuple[sp.csr_matrix, np.ndarray]:
    """K and lumped M of a bar of two-node elements, EA = rho A = 1: waves of speed 1; the first node held or free."""
    n = len(lengths)
    K, M = np.zeros((n + 1, n + 1)), np.zeros(n + 1)
    for e, length in enumerate(lengths):
        K[e : e + 2, e : e + 2] += np.array([[1, -1], [-1, 1]]) / length
        M[e : e + 2] += length / 2
    first = 1 if held else 0
    return sp.csr_matrix(K[first:, first:]), M[first:]


def two_regions(coarse: int = 20, fine: int = 24, ratio: int = 8) -> LinearStructure:
    """A bar of length 1 + ... whose right part has elements `ratio` times shorter (Fig. 1 of the paper)."""
    K, M = bar(np.array([1.0] * coarse + [1.0 / ratio] * fine))
    return LinearStructure(K, M, name="bar")


def matrices(structure: LinearStructure) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Dense K, M, D with the mass damping."""
    M = np.diag(structure.mass) if structure.is_lumped else structure.mass.toarray()
    D = structure.mass_damping * M + (0 if structure.damping is None else structure.damping.toarray())
    return structure.stiffness.toarray(), M, D
