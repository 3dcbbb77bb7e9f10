"""Frequencies of the equations linearised along a motion: how stiff the mechanism is on its way."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from runtime.contract.errors import ArgumentError
from runtime.operating.linearise import linearise
from runtime.operating.mode_tracking import Followed, ModeState, followed_modes, tracked
from runtime.results.samples import Samples


@dataclass(frozen=True, eq=False, repr=False)
class FrequenciesAlong(Followed):
    """Modes at N moments t (N,) [s] of a run; frequencies are |lambda|, damping ratios negative where a mode grows."""

    t: np.ndarray


def frequencies_along(solution: Samples, samples: int = 60) -> FrequenciesAlong:
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
    return FrequenciesAlong(**followed_modes(found), t=solution.t[chosen])
