"""Stability of a motion that repeats: Floquet multipliers, what their places mean, and the shapes that grow.

The monodromy matrix dx(t0 + T)/dx(t0) has the eigenvalues mu; a disturbance along an eigenvector is multiplied by mu in
each period. Where nothing depends on time (T free) one multiplier is 1: a shift along the motion itself.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

UNIT_CIRCLE_MARGIN = 1e-6  # at least: multipliers nearer to the unit circle are on it
REAL = 1e-7  # of |mu|: an imaginary part below that is rounding

STABLE, UNSTABLE, NEUTRAL = "stable", "unstable", "neutral"
FOLD, FLIP, NEIMARK_SACKER = "fold", "flip", "Neimark-Sacker"
MEANINGS = {
    FOLD: "a multiplier passes +1: the motion meets another one and both end, or its symmetry breaks",
    FLIP: "a multiplier passes -1: a motion of twice the period branches off",
    NEIMARK_SACKER: "a pair of multipliers leaves the unit circle: a second frequency appears",
}


@dataclass(frozen=True)
class Floquet:
    """multipliers (n,) by falling size and vectors (n, n), a column each; exponents (n,) [1/s].

    trivial: the position of the multiplier 1 of a motion whose period is free, -1 where there is none. margin: nearer
    to the unit circle, multipliers are on it, as far as they are known.
    """

    multipliers: np.ndarray
    vectors: np.ndarray
    exponents: np.ndarray
    trivial: int
    margin: float = UNIT_CIRCLE_MARGIN

    @property
    def largest(self) -> float:
        """Size of the largest multiplier that counts."""
        return float(np.abs(self.counted).max(initial=0.0))

    @property
    def counted(self) -> np.ndarray:
        """Without the trivial one."""
        return self.multipliers if self.trivial < 0 else np.delete(self.multipliers, self.trivial)

    @property
    def stability(self) -> str:
        """`stable`, `unstable`, or `neutral` where the largest multiplier is on the unit circle."""
        return NEUTRAL if abs(self.largest - 1.0) <= self.margin else UNSTABLE if self.largest > 1.0 else STABLE

    @property
    def kind(self) -> str:
        """How stability is lost: `fold`, `flip`, `Neimark-Sacker`; "" for a motion that is not unstable."""
        return "" if self.stability != UNSTABLE else kind_of(complex(self.counted[int(np.abs(self.counted).argmax())]))


def floquet(monodromy: np.ndarray, period: float, free: bool, margin: float = UNIT_CIRCLE_MARGIN) -> Floquet:
    """Of a monodromy matrix (n, n) and a period [s]; margin: see Floquet."""
    multipliers, vectors = np.linalg.eig(monodromy)
    order = np.argsort(-np.abs(multipliers), kind="stable")
    multipliers, vectors = multipliers[order], vectors[:, order]
    with np.errstate(divide="ignore", invalid="ignore"):
        exponents = np.log(multipliers.astype(complex)) / period
    trivial = int(np.abs(multipliers - 1.0).argmin()) if free else -1
    return Floquet(multipliers, vectors, exponents, trivial, margin)


def kind_of(multiplier: complex) -> str:
    """What happens where this multiplier passes the unit circle."""
    if abs(multiplier.imag) > REAL * abs(multiplier):
        return NEIMARK_SACKER
    return FOLD if multiplier.real > 0 else FLIP
