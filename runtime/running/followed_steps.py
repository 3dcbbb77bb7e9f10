"""A neighbour of a run whose steps follow from a tolerance takes steps of the lengths that the run's take.

Steps that the neighbour's own estimates ask for make other errors than the run's: what the two differ by is then no
longer the error that the motion carries on. Where all steps of the run are of one length the neighbour takes them by
itself. Else the run's motion is stepped once more, step by step, and each step is followed by the neighbour's of its
length; what these two have come to differ by is put beside the run. So it is where events are watched: behind one that
happens a neighbour is placed anew.
"""

from __future__ import annotations

import numpy as np

from runtime.running.neighbour import placed_beside, seen_state, small_change, stepped_to
from runtime.running.segment import Segment
from runtime.schemes.adaptive.adaptive_steps import AdaptiveSteps

AHEAD = 1e-3  # of the shortest step: what is to be seen lies so far ahead, so that one step leads there


def follows_steps(segment: Segment, z: np.ndarray) -> bool:
    """Can a neighbour of the run at z (whole, flat) take steps of its lengths? Not across what comes from outside."""
    scheme = segment.plan.scheme
    if not isinstance(scheme, AdaptiveSteps):
        return True
    own = scheme.layout.slice
    return not (bool(segment.switches) or z[own("lands")][0] > 0)


def follow_steps(segment: Segment, before: np.ndarray, z: np.ndarray, other: np.ndarray) -> np.ndarray | None:
    """The state beside z that `other`, beside `before`, has come to by the steps between the two; all whole and flat.

    None where these steps could not be made again.
    """
    scheme = segment.plan.scheme
    assert isinstance(scheme, AdaptiveSteps)
    own = scheme.layout.slice
    if z[own("steady")][0] > 0:
        segment.run(other, segment.step_of(z) - segment.step_of(before))
        return other
    tiny = scheme.constants(segment.with_inputs(before), AHEAD * float(z[own("h_least")][0]))
    ready, both, seen = segment.stepper.ready_for(tiny), (before.copy(), other.copy()), segment.time_of(z)
    while both[0][own("t_to")][0] < seen:
        for one in both:
            made = one[own("accepted")] + 1
            scheme.begin_anew(one)
            segment.stepper.run(one, ready, 1)
            if one[own("accepted")] != made:
                return None
            both[1][own("steady")] = both[0][own("t_to")] - both[0][own("t_from")]
    for one in both:
        one[own("t0")], one[own("n")] = z[own("t0")], z[own("n")] - 1
        one[own("steady")] = 0.0
        segment.stepper.run(one, segment.ready, 1)
    if any(segment.step_of(one) != segment.step_of(z) for one in both):
        return None
    (q, q_dot), (q_other, q_dot_other) = (seen_state(segment, stepped_to(segment, one)) for one in both)
    change = small_change(segment.model, q, q_dot, q_other - q, q_dot_other - q_dot)
    return placed_beside(segment, z, *change)
