"""The length of the next step: kept while the estimated error stays in a band, set anew where it leaves it.

With the size e of the estimated error over the tolerance of a step and an estimate of h^p,

    e > REFUSED             the step is thrown away, and tried again with h (AIM / e)^(1/p)
    e > 1                   the step is kept, the next one takes h (AIM / e)^(1/p)
    peak of e below LOW     the next one takes h (AIM / peak)^(1/p)

where the peak forgets by the factor FORGET a step, so that an estimate that passes through zero, as that of a vibration
does twice a period, does not ask for longer steps. In between h stays as it is. Then nothing of the next step waits for
the estimate: processors begin it while e is still being computed, and a test that comes out the same nearly every time
costs nothing. A controller that follows every e makes the next step wait for all of it, 50 to 100 ns.
"""

from __future__ import annotations

import casadi as ca

REFUSED, AIM, LOW = 2.0, 0.5, 0.2  # of e
FORGET, RESUMED = 0.8, 0.3  # what is left of the peak after a step, and where it begins after longer steps
SHRINK, GROW = 0.1, 5.0  # at most, from one step to the next
SMALLEST = 1e-5  # e is taken for at least this: an error of zero says nothing about longer steps


def in_band(square: ca.SX, peak: ca.SX) -> ca.SX:
    """May h stay as it is? From e^2 and the square of its peak; not where the error is no number."""
    return ca.logic_and(square <= 1, peak >= LOW**2)


def step_factor(square: ca.SX, peak: ca.SX, order: int) -> ca.SX:
    """h_next / h, from e^2 and the square of its peak; SHRINK where e is not finite."""
    worst = ca.if_else(square <= 1, ca.if_else(peak < LOW**2, peak, AIM**2), ca.fmin(square, 1 / SMALLEST**2))
    factor = ca.exp((2 * ca.log(AIM) - ca.log(ca.fmax(worst, SMALLEST**2))) / (2 * order))
    known = ca.if_else(square >= 0, factor, SHRINK)
    return ca.fmin(GROW, ca.fmax(SHRINK, known))


def peak_after(square: ca.SX, peak: ca.SX, factor: ca.SX, order: int) -> ca.SX:
    """The square of the peak, after h was changed by a factor: what e would have been with the new length.

    Where it was remembered rather than seen, from e and RESUMED: so steps grow on until e is large again.
    """
    change = factor ** (2 * order)
    expected = ca.fmin(square * change, 1.0)
    return ca.if_else(
        ca.logic_and(peak > square, factor > 1), ca.fmax(expected, RESUMED**2), ca.fmin(peak * change, 1.0)
    )


def not_across(h: ca.SX, left: ca.SX) -> ca.SX:
    """The step to make where h is wanted and nothing may cross what is `left` away [s]: no tiny step is left over."""
    halved = ca.if_else(left < 2 * h, left / 2, h)
    return ca.if_else(left <= 1.1 * h, left, halved)
