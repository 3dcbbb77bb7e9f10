"""Generalised-alpha: implicit steps of a linear structure, one sparse factorisation for all of them.

It pays where loads are slow against the mesh: from some hundreds of explicit steps in one of its own.

References
----------
.. [1] Chung, J., Hulbert, G. M., A time integration algorithm for structural dynamics with improved numerical
   dissipation: the generalized-alpha method, J. Appl. Mech. 60 (1993) 371-375.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import scipy.sparse as sp
import scipy.sparse.linalg as spl

from runtime.structures.structure import Array, LinearStructure, StructureError


class Coefficients(NamedTuple):
    """alpha_m, alpha_f, beta, gamma."""

    alpha_m: float
    alpha_f: float
    beta: float
    gamma: float

    @classmethod
    def of(cls, rho_inf: float) -> Coefficients:
        """Second order, spectral radius rho_inf at infinite frequency (1: none is damped; 0: all of it at once)."""
        if not 0 <= rho_inf <= 1:
            raise StructureError("rho_inf", f"{rho_inf!r}", "give a number from 0 (damps most) to 1 (damps nothing)")
        alpha_m, alpha_f = (2 * rho_inf - 1) / (rho_inf + 1), rho_inf / (rho_inf + 1)
        return cls(alpha_m, alpha_f, (1 - alpha_m + alpha_f) ** 2 / 4, 0.5 - alpha_m + alpha_f)


NEWMARK = Coefficients(0.0, 0.0, 0.25, 0.5)  # average acceleration


def hht(alpha: float) -> Coefficients:
    """Hilber, Hughes and Taylor's method with alpha from -1/3 to 0."""
    if not -1 / 3 <= alpha <= 0:
        raise StructureError("alpha", f"{alpha!r}", "give a number from -1/3 to 0")
    return Coefficients(0.0, -alpha, (1 - alpha) ** 2 / 4, 0.5 - alpha)


class GeneralisedAlpha:
    """Steps h [s] of a structure; mass lumped or consistent, any damping.

    Notes
    -----
    M a(t + (1 - alpha_m) h) + D v(t + (1 - alpha_f) h) + K x(t + (1 - alpha_f) h) = F(t + (1 - alpha_f) h), with
    Newmark's x and v; unconditionally stable and of second order.
    """

    def __init__(self, structure: LinearStructure, step: float, coefficients: Coefficients) -> None:
        if not (np.isfinite(step) and step > 0):
            raise StructureError("dt", f"{step!r} s", "give a positive step")
        self.structure, self.major_step, self.t, self._with = structure, step, 0.0, coefficients
        M = sp.diags(structure.mass) if structure.is_lumped else structure.mass
        D = structure.mass_damping * M
        self._M, self._K = sp.csr_matrix(M), structure.stiffness
        self._D = sp.csr_matrix(D if structure.damping is None else D + structure.damping)
        alpha_m, alpha_f, beta, gamma = coefficients
        h = step
        matrix = (1 - alpha_m) * self._M + (1 - alpha_f) * (gamma * h * self._D + beta * h * h * self._K)
        # symmetric pivoting keeps the factors sparse: the matrix is positive definite
        self._solve = spl.splu(
            sp.csc_matrix(matrix), permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options={"SymmetricMode": True}
        ).solve
        n = structure.size
        self.x, self.rates, self._a = np.zeros(n), np.zeros(n), np.zeros(n)

    def start(self, x: Array, rates: Array, t: float = 0.0) -> None:
        """Begin at x (n,) [m] with rates (n,) [m/s] at t [s]; the accelerations follow from the equations."""
        self.t, self.x, self.rates = t, np.array(x, dtype=float), np.array(rates, dtype=float)
        force = self.structure.force(np.array([t]))[0] - self._D @ self.rates - self._K @ self.x
        self._a = (
            force / self.structure.mass if self.structure.is_lumped else spl.spsolve(sp.csc_matrix(self._M), force)
        )

    def advance(self, steps: int) -> None:
        """So many steps."""
        if steps <= 0:
            return
        alpha_m, alpha_f, beta, gamma = self._with
        h = self.major_step
        times = self.t + h * (np.arange(steps) + 1 - alpha_f)
        laws = self.structure.law_values(np.asarray(times, dtype=np.float64))
        patterns = [(load.pattern, load.law) for load in self.structure.loads]
        for k in range(steps):
            x = self.x + h * self.rates + h * h * (0.5 - beta) * self._a
            v = self.rates + h * (1 - gamma) * self._a
            right = -alpha_m * (self._M @ self._a)
            right -= self._D @ ((1 - alpha_f) * v + alpha_f * self.rates) + self._K @ (
                (1 - alpha_f) * x + alpha_f * self.x
            )
            for pattern, law in patterns:
                right += laws[k, law] * pattern
            self._a = self._solve(right)
            self.x, self.rates = x + beta * h * h * self._a, v + gamma * h * self._a
        self.t += steps * h

    def near(self, t: float) -> Array:
        """x (n,) [m] at a time within half a step, to second order in the distance."""
        away = t - self.t
        return self.x + away * self.rates + away**2 / 2 * self._a

    def energy(self) -> tuple[float, float]:
        """Kinetic and elastic energy [J] at t."""
        return float(self.rates @ (self._M @ self.rates) / 2), float(self.x @ (self._K @ self.x) / 2)
