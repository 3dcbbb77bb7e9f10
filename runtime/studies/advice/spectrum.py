"""How much longer steps slow coordinates may take than fast ones, by the spectrum of the motion.

A coordinate needs steps in proportion to 1 / w. Of the groups of a partition up to one of them, slow to fast, w is the
largest of

    the frequencies of w'' = A_q w + A_v w' in their rows and columns: what they do while faster ones are given, which
    is what sub-steps make of them,
    how fast the motion moves each of them: RMS of q' over RMS of q about its mean; of an angle of a body at least the
    RMS of q', since forces go with its sine and cosine.

Of all groups it is the largest coupled frequency. The ratio of the steps of two neighbouring groups is that of their
frequencies. A_q and A_v are taken at some states of the motion.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from runtime.contract.coordinates import independent, loop_part
from runtime.operating.mode_solver import ModeSolver, State
from runtime.running.monitor import known_slopes
from runtime.running.problem import Problem
from runtime.solutions.solution import Solution

LINEARISED_STATES = 5  # of the motion at which the equations are linearised
MOST_RATIO = 20  # of a ratio of groups: longer steps of the slow ones lose what couples them
MOST_SUB_STEPS = 8  # of all coordinates on one linear system
UNKNOWN = 5  # where a model cannot be linearised


@dataclass(frozen=True)
class StepRatios:
    """groups: of each two neighbouring groups, slow to fast; overall: for methods that step all coordinates alike and
    take sub-steps of the linear part, whose steps follow what moves in earnest.
    """

    groups: tuple[int, ...]
    overall: int

    @property
    def halved(self) -> tuple[int, ...]:
        """Those of groups, about half as large."""
        return tuple(max(1, round(ratio / 2)) for ratio in self.groups)


def step_ratios(problem: Problem, motion: Solution | None = None) -> StepRatios:
    """Of a problem whose motion is known, at least coarsely; None: by its start alone."""
    model = problem.model
    groups = [list(group.positions) for group in model.groups]
    count = max(len(groups) - 1, 0)
    frequencies = group_frequencies(problem, groups, motion)
    if frequencies is None:
        return StepRatios((1,) * (count - 1) + (UNKNOWN,) * min(count, 1), UNKNOWN)
    moved = float(moving_rates(problem, motion).max(initial=0.0))
    fastest, needed = frequencies[-1], max(moved, frequencies[0] if count else 0.0)
    found = tuple(_ratio(b, a, MOST_RATIO) for a, b in zip(frequencies, frequencies[1:], strict=False))
    return StepRatios(found, _ratio(fastest, needed, MOST_SUB_STEPS))


def _ratio(fast: float, slow: float, most: int) -> int:
    return int(np.clip(fast / slow, 1, most)) if slow > 0 else most


def group_frequencies(
    problem: Problem, groups: Sequence[Sequence[int]], motion: Solution | None = None
) -> list[float] | None:
    """Of the first group, the first two, ... [rad/s]: what they need; of all, the largest coupled frequency.

    None where the model cannot be linearised.
    """
    model, c = problem.model, problem.model.constants(problem.p)
    if not ModeSolver.possible(model):
        return None
    slopes = [one for state in _states(problem, motion) if (one := known_slopes(model, c, state)) is not None]
    if not slopes:
        return None
    rates, found = moving_rates(problem, motion), list[float]()
    for k in range(len(groups)):
        members = sorted(position for group in groups[: k + 1] for position in group)
        own = max(_fastest(A_q[np.ix_(members, members)], A_v[np.ix_(members, members)]) for A_q, A_v in slopes)
        found.append(own if k + 1 == len(groups) else max(own, float(rates[members].max(initial=0.0))))
    return [min(one, found[-1]) for one in found]


def _fastest(A_q: np.ndarray, A_v: np.ndarray) -> float:
    """The largest |eigenvalue| of w'' = A_q w + A_v w' [rad/s]."""
    n = len(A_q)
    return float(np.abs(np.linalg.eigvals(np.block([[np.zeros((n, n)), np.eye(n)], [A_q, A_v]]))).max())


def _states(problem: Problem, motion: Solution | None) -> list[State]:
    model = problem.model
    states = [(problem.t0, problem.state.q, problem.state.q_dot)]
    if motion is not None and len(motion.t) > 1:
        at = np.unique(np.linspace(0, len(motion.t) - 1, LINEARISED_STATES).astype(int))
        states += [(float(motion.t[k]), motion.q[k], motion.q_dot[k]) for k in at]
    return [State(t, *independent(model, q, q_dot), loop_part(model, q)) for t, q, q_dot in states]


def moving_rates(problem: Problem, motion: Solution | None) -> np.ndarray:
    """(n_i,) how fast the motion moves each independent coordinate [rad/s]; zero where it is not known."""
    model = problem.model
    if motion is None or len(motion.t) < 2:
        return np.zeros(len(model.q_i))
    q, rates = (np.array(one) for one in independent(model, motion.q, motion.q_dot))
    entries = {entry.name: entry for entry in model.description.coordinates}
    size, speed = np.std(q, axis=0), np.sqrt(np.mean(rates**2, axis=0))
    found = np.divide(speed, size, out=np.zeros_like(speed), where=size > 0)
    angles = {name for name, entry in entries.items() if entry.unit == "rad" and not entry.elastic}
    angles |= {
        name for record in model.description.orientations for name in record.turns
    }  # no coordinates of their own
    turns = np.array([name in angles for name in model.q_i])
    return np.asarray(np.where(turns, np.maximum(found, speed), found))
