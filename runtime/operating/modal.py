"""Modes of M x'' + D x' + K x = 0: any D and K, so damped, gyroscopic and unstable systems too.

With M = L L^T and x = L^-T y, y'' + (L^-1 D L^-T) y' + (L^-1 K L^-T) y = 0. Without D and with K symmetric the modes
are real and come from a symmetric eigenvalue problem; else from the first-order form of twice the size.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

NO_STIFFNESS = 1e-13  # relative eigenvalue of K below which a direction has no stiffness
NO_RATE = 3e-6  # relative size up to which an eigenvalue of a direction without stiffness is a zero split by rounding
SYMMETRIC = 1e-11  # relative asymmetry that is rounding
NO_DAMPING = 1e-13  # D against twice the critical one of the fastest mode
GROWING = 1e-9  # real part, relative to the largest eigenvalue, that is more than rounding


@dataclass(frozen=True)
class Modal:
    """The n modes of a system of n coordinates, sorted by frequency.

    eigenvalues (n,) [1/s]: of each conjugate pair the one with a positive imaginary part, of a pair of real ones the
    one that decays slowest; frequencies (n,) [rad/s]: sqrt(|lambda_1 lambda_2|) of the pair, |lambda| if they are
    conjugate; damping_ratios (n,): -(lambda_1 + lambda_2) / (2 frequency), above 1 where overdamped, -1 where a real
    eigenvalue grows, 0 for rigid-body modes; shapes (n, n): complex displacements, columns, of modal mass 1, the
    largest entry real; rigid (n,): is it a motion without stiffness; every_eigenvalue (2 n,).
    """

    eigenvalues: np.ndarray
    frequencies: np.ndarray
    damping_ratios: np.ndarray
    shapes: np.ndarray
    rigid: np.ndarray
    every_eigenvalue: np.ndarray

    @property
    def stable(self) -> bool:
        """Does no mode grow? (Rigid-body modes count as neutral.)"""
        every = self.every_eigenvalue
        return not len(every) or float(every.real.max()) <= GROWING * float(np.abs(every).max(initial=0.0))


def modal_analysis(M: np.ndarray, D: np.ndarray, K: np.ndarray, states: int = 0) -> Modal:
    """Modes of M x'' + D x' + K x = 0 (n x n each), M symmetric positive definite. Raises LinAlgError if it is not.

    states: of the last so many coordinates only the rate counts, the state of a controller. Then there are as many
    modes as conjugate pairs and real eigenvalues, each of which is a mode with ratio 1.
    """
    n = len(M)
    if states:
        return _closed_loop(M, D, K, states)
    if not n:
        none = np.zeros(0)
        return Modal(none, none, none, np.zeros((0, 0)), np.zeros(0, dtype=bool), none)
    L = np.linalg.cholesky(M)
    K_L = np.linalg.solve(L, np.linalg.solve(L, K.T).T)
    D_L = np.linalg.solve(L, np.linalg.solve(L, D.T).T)
    size = float(np.linalg.norm(K_L, 2))
    singular = np.linalg.svd(K_L, compute_uv=False)
    free = int(np.sum(singular <= NO_STIFFNESS * size)) if size > 0 else n
    symmetric = float(np.abs(K_L - K_L.T).max()) <= SYMMETRIC * size
    if symmetric and float(np.abs(D_L).max()) <= NO_DAMPING * np.sqrt(size):
        found = _undamped(0.5 * (K_L + K_L.T), free)
    else:
        found = _general(D_L, K_L, free)
    return _normalised(found, np.linalg.inv(L).T)


def _undamped(K: np.ndarray, free: int) -> Modal:
    squares, vectors = np.linalg.eigh(K)
    order = np.argsort(np.abs(squares), kind="stable")
    squares, vectors = squares[order], vectors[:, order]
    squares[:free] = 0.0
    roots = np.sqrt(squares.astype(complex))
    values = np.where(squares >= 0, 1j * np.abs(roots), np.abs(roots))
    ratios = np.where(squares < 0, -1.0, 0.0)
    rigid = np.arange(len(K)) < free
    every = np.concatenate([values, -values])
    return Modal(values, np.abs(roots), ratios, vectors.astype(complex), rigid, every)


def _general(D: np.ndarray, K: np.ndarray, free: int) -> Modal:
    n = len(K)
    A = np.block([[np.zeros((n, n)), np.eye(n)], [-K, -D]])
    values, vectors = np.linalg.eig(A)
    every = values.astype(complex)
    order = np.argsort(np.abs(every), kind="stable")
    every, shapes = every[order], vectors[:n, order].astype(complex)
    fastest = float(np.abs(every).max())
    every[:free] = 0.0
    split = np.arange(2 * n) < 2 * free
    every[split & (np.abs(every) <= NO_RATE * fastest)] = 0.0
    pairs = _pairs(every, shapes)
    pairs.sort(key=lambda pair: _frequency(every, pair))
    lead = [first for first, _ in pairs]
    frequencies = np.array([_frequency(every, pair) for pair in pairs])
    rigid = np.array([every[first] == 0 or every[second] == 0 for first, second in pairs])
    return Modal(
        every[lead], frequencies, np.array([_damping(every, pair) for pair in pairs]), shapes[:, lead], rigid, every
    )


def _closed_loop(M: np.ndarray, D: np.ndarray, K: np.ndarray, states: int) -> Modal:
    n = len(M)
    A = np.block([[np.zeros((n, n)), np.eye(n)], [-np.linalg.solve(M, K), -np.linalg.solve(M, D)]])
    kept = np.delete(np.arange(2 * n), np.arange(n - states, n))
    values, vectors = np.linalg.eig(A[np.ix_(kept, kept)])
    fastest = float(np.abs(values).max(initial=0.0))
    values = np.where(np.abs(values) <= GROWING * fastest, 0.0, values.astype(complex))
    lead = sorted((k for k in range(len(values)) if values[k].imag >= 0), key=lambda k: abs(values[k]))
    found = values[lead]
    rigid = found == 0
    x = vectors[: n - states, lead].astype(complex)
    rates = vectors[len(kept) - states :, lead]
    x = np.vstack([x, np.where(rigid, 0.0, rates / np.where(rigid, 1.0, found))])
    size = np.abs(found)
    ratios = np.where(rigid, 0.0, -found.real / np.where(rigid, 1.0, size))
    mass = np.real(np.einsum("ik,ij,jk->k", x.conj(), M, x))
    shapes = x / np.sqrt(np.maximum(mass, 1e-300))
    largest = shapes[np.abs(shapes).argmax(axis=0), np.arange(len(found))]
    return Modal(found, size, ratios, shapes * (np.abs(largest) / np.where(largest == 0, 1, largest)), rigid, values)


def _pairs(values: np.ndarray, shapes: np.ndarray) -> list[tuple[int, int]]:
    """Conjugate eigenvalues together; real ones by the likeness of their shapes, rigid-body modes first."""
    upper = [k for k in range(len(values)) if values[k].imag > 0]
    lower = {k: min(_others(values, k), key=lambda j: abs(values[j] - values[k].conjugate())) for k in upper}
    pairs = list(lower.items())
    real = sorted((k for k in range(len(values)) if values[k].imag == 0), key=lambda k: abs(values[k]))
    unit = shapes / np.maximum(np.linalg.norm(shapes, axis=0), 1e-300)
    while real:
        first = real.pop(0)
        second = max(real, key=lambda k: abs(np.vdot(unit[:, first], unit[:, k])))
        real.remove(second)
        pairs.append((first, second) if values[first].real >= values[second].real else (second, first))
    return pairs


def _others(values: np.ndarray, k: int) -> list[int]:
    return [j for j in range(len(values)) if values[j].imag < 0]


def _frequency(values: np.ndarray, pair: tuple[int, int]) -> float:
    return float(np.sqrt(np.abs(values[pair[0]]) * np.abs(values[pair[1]])))


def _damping(values: np.ndarray, pair: tuple[int, int]) -> float:
    first, second = values[list(pair)]
    size = _frequency(values, pair)
    if size == 0:
        return 0.0
    return -1.0 if first.imag == 0 and first.real > 0 else float(-(first + second).real / (2 * size))


def _normalised(found: Modal, back: np.ndarray) -> Modal:
    """Shapes of unit modal mass in x = back y, turned so that the largest entry is real and positive."""
    y = found.shapes / np.maximum(np.linalg.norm(found.shapes, axis=0), 1e-300)
    x = back @ y
    largest = x[np.abs(x).argmax(axis=0), np.arange(x.shape[1])]
    x = x * (np.abs(largest) / np.where(largest == 0, 1.0, largest))
    return Modal(found.eigenvalues, found.frequencies, found.damping_ratios, x, found.rigid, found.every_eigenvalue)
