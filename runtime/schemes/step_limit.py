"""Largest stable step of an explicit scheme on the equations linearised at a state, w'' = A_q w + A_v w'.

These are guards for the start of a run and for advice: the motion of the state is ignored, and so are steps that
differ from group to group. runtime/stability computes the limit of a scheme from the exact Jacobian of its step.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from runtime.contract.consistent_state import dense_eigenvalues

# Central difference with velocities predicted by the last acceleration: for a pure decay d with x = h d the recursion
# mu^2 - (1 - 3/2 x) mu - x/2 = 0 reaches mu = -1 at x = 1.
PREDICTED_DECAY_REACH = 1.0


@dataclass(frozen=True)
class StepLimit:
    """The largest stable step h [s] and what sets it: a frequency [rad/s] or a decay rate [1/s]."""

    h: float
    rate: float
    by_decay: bool

    def __str__(self) -> str:
        return (
            f"fastest decay rate is {self.rate:.4g} 1/s"
            if self.by_decay
            else f"fastest coupled frequency is {self.rate:.4g} rad/s"
        )


def limit_between_the_axes(A_q: np.ndarray, A_v: np.ndarray, reach: float, decay_reach: float) -> StepLimit | None:
    """For reach on the imaginary axis and decay_reach on the negative real one; None if nothing limits the step.

    Between the axes an ellipse stands for the edge of the stability region: 1 / h = hypot(b / reach, a / decay_reach)
    for an eigenvalue -a +- i b.
    """
    values = eigenvalues(A_q, A_v)
    oscillation, decay = np.abs(values.imag) / reach, np.maximum(-values.real, 0.0) / decay_reach
    needed = np.hypot(oscillation, decay)
    if not needed.max(initial=0.0) > 0:
        return None
    k = int(needed.argmax())
    by_decay = bool(decay[k] > oscillation[k])
    return StepLimit(float(1 / needed[k]), float(-values[k].real if by_decay else abs(values[k].imag)), by_decay)


def limit_beside_deflections(
    A_q: np.ndarray, A_v: np.ndarray, B: np.ndarray, reach: float, decay_reach: float
) -> StepLimit | None:
    """Of what is left to an explicit method whose stiff deflections s = B^T q (B n x n_s) need no step.

    They follow the rest of the motion as in equilibrium: with y across B, A_yy - A_ys A_ss^-1 A_sy takes A's place.
    """
    if not B.shape[1]:
        return limit_between_the_axes(A_q, A_v, reach, decay_reach)
    across = np.linalg.svd(B)[0][:, np.linalg.matrix_rank(B) :]
    if not across.shape[1]:
        return None
    along = B @ np.linalg.inv(B.T @ B)
    follow = np.linalg.lstsq((B.T @ A_q @ along).T, (across.T @ A_q @ along).T, rcond=None)[0].T  # A_ys A_ss^-1
    rows = across.T - follow @ B.T
    return limit_between_the_axes(rows @ A_q @ across, rows @ A_v @ across, reach, decay_reach)


def central_difference_limit(A_q: np.ndarray, A_v: np.ndarray, predicted: bool) -> StepLimit | None:
    """For central difference: the smallest h at which a multiplier reaches mu = -1; None if there is none.

    At mu = -1 the recursion is 4 w + h^2 A_q w = 0 with velocities of the step itself, whatever the damping, and
    4 w + h^2 A_q w + 4 h A_v w = 0 with predicted velocities; s = 2 / h makes that an eigenvalue problem.
    """
    frequency = float(np.sqrt(np.maximum(dense_eigenvalues(-A_q).real, 0.0)).max(initial=0.0))
    s = float(eigenvalues(-A_q, -2 * A_v).real.max(initial=0.0)) if predicted else frequency
    if not s > 0:
        return None
    decay = float((-eigenvalues(A_q, A_v).real).max(initial=0.0)) if predicted else 0.0
    by_decay = decay / PREDICTED_DECAY_REACH > frequency / 2
    return StepLimit(2 / s, decay if by_decay else frequency, by_decay)


def eigenvalues(A_q: np.ndarray, A_v: np.ndarray) -> np.ndarray:
    """Of w'' = A_q w + A_v w'. Raises LinAlgError if they are not finite."""
    if np.abs(A_v).max(initial=0.0) ** 2 <= np.finfo(float).eps ** 2 * np.abs(A_q).max(initial=0.0):  # no rates count
        roots = np.sqrt(dense_eigenvalues(A_q).astype(complex))
        return np.concatenate([roots, -roots])
    n = len(A_q)
    return dense_eigenvalues(np.block([[np.zeros((n, n)), np.eye(n)], [A_q, A_v]]))
