"""Frequencies of the equations linearised along a motion: how stiff the mechanism is on its way."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from runtime.contract.errors import ArgumentError
from runtime.operating.linearise import linearise
from runtime.operating.tracking import Followed, ModeState, tracked
from runtime.results.solution import Solution


@dataclass(frozen=True, eq=False)
class FrequenciesAlong:
    """N moments of a run and the n modes there, a column a mode, followed by modal assurance.

    t (N,) [s]; frequencies (N, n) [rad/s], |lambda|; damping_ratios (N, n), negative where a mode grows; names: those
    of the modes where they are met first; NaN where a real mode of a controller is not there.
    """

    t: np.ndarray
    frequencies: np.ndarray
    damping_ratios: np.ndarray
    names: list[str]


def frequencies_along(solution: Solution, samples: int = 60) -> FrequenciesAlong:
    """Eigenvalues of M x'' + D x' + K x = 0 about at most `samples` saved states of a run, equally spaced.

    The states are no equilibria: K holds what the accelerations there add, d(M_hat a - Q_hat)/dq at fixed a.
    Raises ModelError where the model lacks its Jacobians, ArgumentError for fewer than two samples.
    """
    if samples < 2:
        raise ArgumentError(f"samples must be at least 2, not {samples}")
    last = len(solution.t) - 1
    chosen = np.unique(np.linspace(0, last, min(samples, last + 1)).round().astype(int))

    def modes_at(sample: float) -> ModeState:
        return ModeState.of(linearise(solution.model, (solution, int(round(sample))), inputs=[], outputs=[]))

    found = [modes_at(chosen[0])]
    for before, here in zip(chosen[:-1], chosen[1:], strict=True):
        halvings = int(np.log2(here - before))  # no more than there are samples in between
        found.append(tracked(found[-1], modes_at(here), float(before), float(here), modes_at, halvings))
    followed = Followed.of(found)
    return FrequenciesAlong(solution.t[chosen], followed.frequencies, followed.damping_ratios, followed.names)
