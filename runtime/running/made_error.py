"""The error that the steps of a run make between two of its states, by other steps from the first of them.

Steps of a double length make 2^p times as much with order p, at half the price of the run's. Where those may be
unstable, or too long to be told by their order, steps of half the length make 2^-p of it. Where steps follow from a
tolerance the others follow from TOLERANCE of it: those that it allows are often so long that longer ones have no order.
"""

from __future__ import annotations

import numpy as np

from runtime.contract.model import ModelError
from runtime.operating.mode_solver import ModeSolver
from runtime.running.neighbour import seen_state
from runtime.running.segment import Segment
from runtime.schemes.adaptive.adaptive_steps import AdaptiveSteps

TOLERANCE = 1 / 8
FEWEST = 4  # steps to a tolerance that are judged at once: what the last one is ahead of the end is not seen
ROOM = 4.0  # the limit of the step over the step, from which steps may be doubled


def may_be_longer(segment: Segment) -> bool:
    """Are steps of the double length well below what limits them?"""
    scheme, grid = segment.plan.scheme, segment.plan.grid
    if scheme.adaptive:
        return True
    if len(grid.groups) > 1 or (scheme.limited(scheme.options) and not ModeSolver.possible(segment.model)):
        return False
    limit = segment.monitor.step_limit
    return limit is None or ROOM * grid.h[-1] <= limit


def may_be_judged(segment: Segment, start: np.ndarray, z: np.ndarray) -> bool:
    """Were there steps enough from one state of the run (whole, flat) to another?"""
    scheme = segment.plan.scheme
    if not isinstance(scheme, AdaptiveSteps):
        return True
    accepted = scheme.layout.slice("accepted")
    return bool(z[accepted] - start[accepted] >= FEWEST)


def error_made(
    segment: Segment, start: np.ndarray, end: np.ndarray, here: tuple[np.ndarray, np.ndarray], longer: bool
) -> tuple[np.ndarray, np.ndarray] | None:
    """(n,) of all coordinates and rates, at the end; start, end: whole, flat; here: coordinates and rates of the end.

    longer: by steps that are, where all are of one length. None if the other steps fail.
    """
    try:
        other, constants, share = (_varying if segment.plan.scheme.adaptive else _fixed)(segment, start, end, longer)
    except ModelError:
        return None
    failures = segment.plan.scheme.layout.slice("failures")
    if (other[failures] > start[failures]).any():
        return None
    there = seen_state(segment, other, constants)
    if isinstance(segment.plan.scheme, AdaptiveSteps):
        ended = segment.plan.scheme.at_end(end)
        segment.run_varying(ended, 0, segment.ready, segment.plan.grid.dt_L)  # an impulse that is to be given there
        here = seen_state(segment, ended)
    dq, dq_dot = ((a - b) * share for a, b in zip(there, here, strict=True))
    return (dq, dq_dot) if np.isfinite([*dq, *dq_dot]).all() else None


def _fixed(segment: Segment, start: np.ndarray, end: np.ndarray, longer: bool) -> tuple[np.ndarray, np.ndarray, float]:
    """(the other state, the constants that go with it, error over their difference)."""
    scheme, stepper, begin = segment.plan.scheme, segment.stepper, start.copy()
    steps, factor = segment.step_of(end) - segment.step_of(start), 2.0 if longer else 0.5
    if longer and steps % 2:
        segment.run(begin, 1)
        steps -= 1
    t, dt, c = segment.time_of(begin), factor * segment.plan.grid.dt_L, segment.with_inputs(start)
    other = stepper.start(t, *seen_state(segment, begin), c, dt)
    segment.broken_beside(t, segment.time_of(end), dt).run(other, stepper.ready(c, dt), c, round(steps / factor))
    return other, scheme.constants(c, dt), 1 / (factor**scheme.order - 1)


def _varying(
    segment: Segment, start: np.ndarray, end: np.ndarray, longer: bool
) -> tuple[np.ndarray, np.ndarray, float]:
    """From the end of one step of the run to that of another: in between the interpolant errs, for a moment only."""
    scheme, other = segment.plan.scheme, start.copy()
    assert isinstance(scheme, AdaptiveSteps)
    scheme.with_errors(other, TOLERANCE)
    scheme.begin_anew(other)
    scheme.land(other)
    seconds = scheme.reached(end) - scheme.reached(start)
    constants = scheme.constants(segment.c, seconds, TOLERANCE * scheme.tolerance)
    segment.run_varying(other, 1, segment.stepper.ready_for(constants), seconds)
    if segment.step_of(other) != 1:
        other[:] = np.nan
    return other, constants, 1 / (TOLERANCE ** (scheme.order / scheme.error_order) - 1)
