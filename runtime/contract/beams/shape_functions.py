"""Shapes in closed form: polynomials and the eigenfunctions of a uniform beam, with all their derivatives."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class ShapeFunctions:
    """n shapes phi_a(xi) on [0, 1]: a polynomial plus waves cos, sin and exponentials that decay from either end.

    powers (p, n): coefficients of 1, xi, xi^2, ...  wave_numbers (k,).  waves (k, 4, n): coefficients of cos b xi,
    sin b xi, exp(-b xi) and exp(-b (1 - xi)) for each wave number b. The exponentials never grow, so that high modes
    are as exact as low ones.
    """

    powers: Array
    wave_numbers: Array
    waves: Array

    @property
    def count(self) -> int:
        """Number of shapes."""
        return int(self.powers.shape[1])

    def at(self, xi: Array, order: int = 0) -> Array:
        """d^order phi / d xi^order at the points xi (k,), shape (k, n)."""
        points = np.asarray(xi, dtype=float)
        raised = np.zeros((len(points), len(self.powers)))
        for power in range(order, len(self.powers)):
            factor = float(np.prod(np.arange(power - order + 1, power + 1)))
            raised[:, power] = factor * points ** (power - order)
        b, phase = self.wave_numbers, points[:, None] * self.wave_numbers
        turned = phase + order * (np.pi / 2)
        decays = (-1.0) ** order * np.exp(-phase), np.exp(phase - b)
        basis = np.stack([np.cos(turned), np.sin(turned), *decays], axis=-1) * (b**order)[:, None]
        return raised @ self.powers + basis.reshape(len(points), -1) @ self.waves.reshape(-1, self.count)

    def mixed(self, combination: Array) -> ShapeFunctions:
        """Shapes that are combinations of these: combination (n, m) has a column for each new one."""
        return ShapeFunctions(self.powers @ combination, self.wave_numbers, self.waves @ combination)

    def beside(self, other: ShapeFunctions) -> ShapeFunctions:
        """These shapes, then the others."""
        waves = np.zeros((len(self.wave_numbers) + len(other.wave_numbers), 4, self.count + other.count))
        waves[: len(self.wave_numbers), :, : self.count] = self.waves
        waves[len(self.wave_numbers) :, :, self.count :] = other.waves
        numbers = np.concatenate([self.wave_numbers, other.wave_numbers])
        highest = max(len(self.powers), len(other.powers))
        both = [np.pad(one, ((0, highest - len(one)), (0, 0))) for one in (self.powers, other.powers)]
        return ShapeFunctions(np.hstack(both), numbers, waves)


def polynomials(rows: Sequence[Sequence[float]]) -> ShapeFunctions:
    """Polynomials by their coefficients of 1, xi, xi^2, ...; all of them have as many."""
    return ShapeFunctions(np.array(rows, dtype=float).T, np.zeros(0), np.zeros((0, 4, len(rows))))


def gauss_points(panels: int, end: float = 1.0) -> tuple[Array, Array]:
    """Points and weights on [0, end]: 12 Gauss points in each of `panels` parts.

    A product of two waves of at most half a period a part is integrated to rounding.
    """
    points, weights = np.polynomial.legendre.leggauss(12)
    size = end / panels
    starts = size * np.arange(panels)[:, None]
    return (starts + 0.5 * size * (1.0 + points)).ravel(), np.tile(0.5 * size * weights, panels)
