"""Which mode is which after a parameter has changed: by the likeness of shapes (modal assurance), not by order."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from runtime.operating.linearisation import Linearisation

MOST_INTERVAL_HALVINGS = 6  # of an interval in which shapes change too much to tell
SURE_ASSURANCE = 0.7  # modal assurance from which two shapes are the same mode
EIGENVALUE_WEIGHT = 0.1  # weight of the eigenvalues' distance beside the assurance: decides between equal shapes


@dataclass(frozen=True)
class ModeState:
    """Eigenvalues (n,) [1/s], frequencies (n,) [rad/s], damping ratios, shapes (n_x, n), and the mass matrix.

    A column that is NaN is a mode that is gone: two real eigenvalues have become a pair, or the other way round.
    """

    eigenvalues: np.ndarray
    frequencies: np.ndarray
    damping_ratios: np.ndarray
    shapes: np.ndarray
    M: np.ndarray
    names: list[str]

    @staticmethod
    def of(system: Linearisation) -> ModeState:
        """The modes of a linear system."""
        return ModeState(
            system.eigenvalues,
            system.frequencies,
            system.damping_ratios,
            system.shapes,
            system.M,
            system.mode_names,
        )

    def ordered(self, order: np.ndarray) -> ModeState:
        """The same modes in another order, -1: none."""
        none = order < 0
        return ModeState(
            np.where(none, np.nan, self.eigenvalues[order]),
            np.where(none, np.nan, self.frequencies[order]),
            np.where(none, np.nan, self.damping_ratios[order]),
            np.where(none, np.nan, self.shapes[:, order]),
            self.M,
            ["" if k < 0 else self.names[k] for k in order],
        )


@dataclass(frozen=True, eq=False, repr=False)
class Followed:
    """Modes at N values, a column a mode, followed by modal assurance: frequencies (N, n) [rad/s], damping_ratios
    (N, n), eigenvalues (N, n) [1/s], shapes (N, n_x, n); names: of each mode where it is met first.

    Real modes of controllers come and go, two of them for an oscillating one: NaN where a mode is not there.
    """

    frequencies: np.ndarray
    damping_ratios: np.ndarray
    eigenvalues: np.ndarray
    shapes: np.ndarray
    names: list[str]


def followed_modes(found: list[ModeState]) -> dict[str, Any]:
    """Fields of `Followed`, of what `tracked` gives at one value after the other: columns may have come on the way."""
    n = len(found[-1].eigenvalues)
    whole = [modes.ordered(np.r_[: len(modes.names), np.full(n - len(modes.names), -1)]) for modes in found]
    names = [next(modes.names[k] for modes in whole if modes.names[k]) for k in range(n)]
    arrays = ("frequencies", "damping_ratios", "eigenvalues", "shapes")
    return {name: np.array([getattr(modes, name) for modes in whole]) for name in arrays} | {"names": names}


def modal_assurance(left: np.ndarray, right: np.ndarray, M: np.ndarray) -> np.ndarray:
    """(n_left, n_right) |a^H M b|^2 / (a^H M a  b^H M b) of complex shapes, columns: 1 for equal, 0 for orthogonal."""
    cross = np.abs(left.conj().T @ M @ right) ** 2
    sizes = [np.real(np.einsum("ik,ij,jk->k", shapes.conj(), M, shapes)) for shapes in (left, right)]
    return np.asarray(cross / np.maximum(np.outer(*sizes), 1e-300))


def tracked(
    before: ModeState,
    after: ModeState,
    first: float,
    last: float,
    at: Callable[[float], ModeState],
    left: int = MOST_INTERVAL_HALVINGS,
) -> ModeState:
    """The modes `after` (at value `last`) in the order of those `before` (at `first`).

    at(value) gives the modes in between, which are asked for where shapes change too much to be told, and where two
    modes change places: frequencies that veer apart look like a crossing from afar.
    """
    order, sure = _matched(before, after)
    met = order[np.argsort(before.frequencies, kind="stable")]
    crossed = bool(np.any(np.diff(met[met >= 0]) < 0))
    if not left or (sure and not crossed):
        return after.ordered(order)
    middle = 0.5 * (first + last)
    between = tracked(before, at(middle), first, middle, at, left - 1)
    return tracked(between, after, middle, last, at, left - 1)


def _matched(before: ModeState, after: ModeState) -> tuple[np.ndarray, bool]:
    """(for each column before, the mode of `after`, -1: none, and behind them those that are new; are pairs alike?).

    A new mode takes a column that was empty.
    """
    there = np.flatnonzero(np.isfinite(before.frequencies))
    likeness = modal_assurance(before.shapes[:, there], after.shapes, 0.5 * (before.M + after.M))
    apart = np.abs(before.eigenvalues[there, None] - after.eigenvalues[None, :])
    scale = np.abs(before.eigenvalues)[there, None] + np.abs(after.eigenvalues)[None, :]
    from scipy.optimize import linear_sum_assignment  # when it is needed: importing it takes long

    rows, columns = linear_sum_assignment(-likeness + EIGENVALUE_WEIGHT * apart / np.maximum(scale, 1e-300))
    order = np.full(len(before.frequencies), -1)
    order[there[rows]] = columns
    new = [k for k in range(len(after.names)) if k not in columns]
    empty = np.flatnonzero(~np.isfinite(before.frequencies))[: len(new)]
    order[empty] = new[: len(empty)]
    return np.r_[order, new[len(empty) :]].astype(int), bool(likeness[rows, columns].min(initial=1.0) >= SURE_ASSURANCE)
