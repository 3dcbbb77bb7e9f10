"""A short piece of a run, stepped as the run steps and once more finely: what errors are told by."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from runtime.contract.model import ModelError
from runtime.running.neighbour import seen_state
from runtime.running.segment import Segment
from runtime.schemes.adaptive.adaptive_steps import AdaptiveSteps

FINER = 8  # tolerance of the run over that of the finer one
STEPS, SHARE = 4, 0.005  # of a run whose steps follow from a tolerance: so many steps, so much of the motion at least


@dataclass(frozen=True)
class Window:
    """When [s] and where it starts (all coordinates and rates (n,)), and states at its end with their constants.

    own: as the run steps; finer: more finely. seconds: its length. more: error over the difference of the two.
    """

    t: float
    q: np.ndarray
    q_dot: np.ndarray
    own: np.ndarray
    own_constants: np.ndarray
    finer: np.ndarray
    finer_constants: np.ndarray
    seconds: float
    more: float


def window_at(segment: Segment, z: np.ndarray, length: int) -> Window | None:
    """The window from z (whole, flat), which is left as it is; length: steps of one length. None if there is none."""
    try:
        if isinstance(segment.plan.scheme, AdaptiveSteps):
            return _of_tolerance(segment, segment.plan.scheme, z.copy())
        return _of_one_length(segment, z.copy(), length)
    except ModelError:
        return None


def _of_one_length(segment: Segment, z: np.ndarray, length: int) -> Window:
    """Steps of the run, and twice as many of half their length."""
    scheme, stepper, dt = segment.plan.scheme, segment.stepper, segment.plan.grid.dt_L
    t, (q, q_dot) = segment.time_of(z), seen_state(segment, z)
    segment.run(z, length)
    halved, half = stepper.start(t, q, q_dot, segment.c, dt / 2), segment.broken_beside(t, t + length * dt, dt / 2)
    half.run(halved, stepper.ready(segment.c, dt / 2), segment.c, 2 * length)
    constants = scheme.constants(segment.c, dt), scheme.constants(segment.c, dt / 2)
    more = 2.0**scheme.order / (2.0**scheme.order - 1)
    return Window(t, q, q_dot, z, constants[0], halved, constants[1], length * dt, more)


def _of_tolerance(segment: Segment, scheme: AdaptiveSteps, z: np.ndarray) -> Window | None:
    """From the end of the last step, for STEPS steps or a SHARE of the run, and the same with a smaller tolerance."""
    stepper, plan = segment.stepper, segment.plan
    seconds = max(scheme.begin_anew(z) * STEPS, SHARE * (plan.t_end - plan.t0))
    t, (q, q_dot) = segment.time_of(z), seen_state(segment, z)
    states, constants = [], []
    for share in (1.0, 1.0 / FINER):
        constants.append(scheme.constants(segment.c, seconds, share * scheme.tolerance))
        states.append(z.copy())
        scheme.with_errors(states[-1], share)
        segment.forget_determinants(states[-1])
        segment.run_varying(states[-1], 1, stepper.ready_for(constants[-1]), seconds)
        if segment.step_of(states[-1]) != 1:
            return None
    own, finer = states
    finest = FINER ** (scheme.order / scheme.error_order)
    more = finest / (finest - 1)
    return Window(t, q, q_dot, own, constants[0], finer, constants[1], seconds, more)
