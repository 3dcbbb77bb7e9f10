"""May the equations linearised at a state let something grow because their coefficients change with time?

With w'' = (A_q + a cos(W t)) w a mode of frequency omega grows where W is about 2 omega (parametric resonance), though
every eigenvalue is imaginary at all times; first at a / 4 omega. Changes that are slow beside a mode let it be. So for
each mode the change over half a period of such a W is taken, by fourth differences, which leave slow ones out.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from runtime.contract.one_thread import one_thread
from runtime.operating.mode_solver import ModeSolver, State

DIFFERENCE = np.array([1.0, -4.0, 6.0, -4.0, 1.0]) / 16  # 1 for what changes its sign from point to point
CENTRES = (0.0, 0.5)  # of them, in distances of the points: a phase at which one sees nothing is a peak for the other
LONGEST = 1 / 8  # of the run: the distance of the points
MOST = 8  # frequencies, the lowest: those of many modes would cost more than the run, and changes are slow beside them
UNCHANGED = 1e-9  # of the linearised equations: less is no change
FURTHER, GOLDEN = 3, (1 + 5**0.5) / 2  # other times of the run, at which it is seen whether they change at all


def first_order(A_q: np.ndarray, A_v: np.ndarray) -> np.ndarray:
    """(2 n, 2 n) of w'' = A_q w + A_v w'."""
    return np.block([[np.zeros_like(A_q), np.eye(len(A_q))], [A_q, A_v]])


def pumped(solver: ModeSolver, state: State, here: np.ndarray, t0: float, span: float) -> float:
    """Rate [1/s] at which something may grow, at most; here: `first_order` at the state; t0, span [s]: of the run.

    Raises LinAlgError where the equations are not finite.
    """

    def at(t: float) -> np.ndarray:
        return first_order(*solver.slopes(replace(state, t=t), moving=True))

    times = [t0 + (state.t - t0 + span * k / GOLDEN) % span for k in range(1, FURTHER + 1)]
    size = np.abs(here).max(initial=0.0)
    if not any(np.abs(at(t) - here).max(initial=0.0) > UNCHANGED * size for t in times):
        return 0.0
    n = len(here) // 2
    raised = here.copy()
    raised[n:, :n] -= np.eye(n) / span**2  # what is free has modes, too
    with one_thread(2 * n):
        values, modes = np.linalg.eig(raised)
    rate = 0.0
    for frequency in sorted({float(f"{abs(value.imag):.3g}") for value in values} - {0.0})[:MOST]:
        apart = min(np.pi / 2 / frequency, LONGEST * span)
        centre = min(max(state.t, t0 + 2 * apart), t0 + span - 3 * apart)
        for shift in CENTRES:
            points = [at(centre + (k + shift) * apart) for k in (-2, -1, 0, 1, 2)]
            change = np.linalg.solve(modes, np.tensordot(DIFFERENCE, points, 1) @ modes)
            near = np.abs(values.imag) <= 1.01 * frequency  # faster ones have points of their own
            between = np.sqrt(np.abs(change * change.T))[np.ix_(near, near)]
            rate = max(rate, float(between.max(initial=0.0)))
    return rate
