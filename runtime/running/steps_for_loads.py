"""How many steps see what loads do.

Coarse motions that miss a load agree with each other, as do those that see a fast one at like phases. So forces along
q_i, which are known functions of time while all else is held as at the start, are integrated twice as steps see them,
by Simpson's rule, and once by FINE_STEPS steps. So many steps are enough from which on that is off by SEES at most.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from runtime.contract.consistent_state import ConsistentState
from runtime.contract.model import EmittedModel
from runtime.running.problem import (
    Problem,
)
from runtime.running.time_functions import OfTime, force_of_time
from runtime.schemes.switching.times import switching_times

FINE_STEPS, COARSE_STEPS = 8192, 4  # numbers of steps that are compared, by factors of two
SEES = 0.02  # of what a force alone would move in the whole time (RMS)
VARIES = 1e-6  # of its largest value: a force that changes by less is constant
MOST_LEGS = 50  # between jumps; where there are more, steps see them


def steps_for_loads(problem: Problem) -> int:
    """Steps over the motion of a problem that see its loads."""
    c = problem.model.constants(problem.p)
    return steps_that_see_loads(problem.model, c, problem.state, problem.t0, problem.t_end)


def steps_that_see_loads(model: EmittedModel, c: np.ndarray, state: ConsistentState, t0: float, t_end: float) -> int:
    """The least number of steps over the time [s], which end where loads jump; 0 where no force depends on time."""
    switches = switching_times(model, c, t0, t_end)
    function = force_of_time(model, c, state) if len(switches) < MOST_LEGS else None
    if function is None:
        return 0
    inside = [one for one in switches if t0 < one.time < t_end]
    legs = list(zip([t0, *(one.after for one in inside)], [*(one.before for one in inside), t_end], strict=True))
    fine = _moved_by_loads(function, legs, FINE_STEPS)
    varies = np.ptp(fine[2], axis=1) > VARIES * np.abs(fine[2]).max(axis=1)
    if not varies.any():
        return 0
    exact, size = fine[1][varies], fine[1][varies].std(axis=1)
    least, steps = FINE_STEPS, FINE_STEPS // 2
    while steps >= COARSE_STEPS:
        at, found, _ = _moved_by_loads(function, legs, steps)
        off = found[varies] - np.array([np.interp(at, fine[0], row) for row in exact])
        if not (np.sqrt(np.mean(off**2, axis=1)) <= SEES * size).all():
            break
        least, steps = steps, steps // 2
    return least


def _moved_by_loads(
    forces_at: OfTime, legs: Sequence[tuple[float, float]], steps: int
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """(times of ends of steps, what each force alone moves until then, forces that were seen), (n_i, .) each."""
    span = legs[-1][1] - legs[0][0]
    times, rises, moves, compared = [np.array([legs[0][0]])], [], [], []
    for begin, end in legs:
        count = max(1, round(steps * (end - begin) / span))
        t = np.linspace(begin, end, 2 * count + 1)
        forces, h = forces_at(t), (end - begin) / count
        first, middle, last = forces[:, 0:-1:2], forces[:, 1::2], forces[:, 2::2]
        rises.append(h / 6 * (first + 4 * middle + last))
        moves.append(h * h / 6 * (first + 2 * middle))
        times.append(t[2::2])
        compared.append(forces)
    ends, rise, move = np.concatenate(times), np.concatenate(rises, axis=1), np.concatenate(moves, axis=1)
    none = np.zeros((len(rise), 1))
    rate = np.concatenate([none, np.cumsum(rise, axis=1)], axis=1)
    place = np.cumsum(rate[:, :-1] * np.diff(ends) + move, axis=1)
    return ends, np.concatenate([none, place], axis=1), np.concatenate(compared, axis=1)
