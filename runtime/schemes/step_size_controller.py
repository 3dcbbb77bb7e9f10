"""The step size controller: is a step accepted (`judge`), and how long is the next one (`propose`)?

Step size control by the estimated local truncation error, in place of a PI controller, for the reason below.

The rule is that of Hairer, Norsett & Wanner (4.13),

    h_next = h min(GROW, max(SHRINK, AIMED_ERROR^(1/p) e^(-1/p)))

where e is the norm of the estimated error over the tolerance (see error_norm.py) and the estimate is of h^p. It is
applied only where e leaves a band:

    e > REJECTED_ERROR             the step is rejected, and tried again with h (AIMED_ERROR / e)^(1/p)
    e > 1                   the step is accepted, the next one takes h (AIMED_ERROR / e)^(1/p)
    peak of e below LOW_ERROR     the next one takes h (AIMED_ERROR / peak)^(1/p)

where the peak forgets by the factor FORGET a step, so that an estimate that passes through zero, as that of a
vibration does twice a period, does not ask for longer steps. In between h stays as it is. Then nothing of the next
step waits for the estimate: processors begin it while e is still being computed, and a test that comes out the same
nearly every time costs nothing. A controller that follows every e, as PI and PID controllers do, makes the next step
wait for all of it, 50 to 100 ns; what they are for, steps that do not swing, the band and the peak give.

References
----------
E. Hairer, S. P. Norsett, G. Wanner: Solving Ordinary Differential Equations I, 2nd ed., Springer 1993, section II.4.
E. Hairer, G. Wanner: Solving Ordinary Differential Equations II, 2nd ed., Springer 1996, section IV.2 (PI control).
"""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca

REJECTED_ERROR, AIMED_ERROR, LOW_ERROR = 2.0, 0.5, 0.2  # of e
FORGET, RESUMED = 0.8, 0.3  # what is left of the peak after a step, and where it begins after longer steps
SHRINK, GROW = 0.1, 5.0  # at most, from one step to the next
LEAST_CLOSURE = 1e-300  # so that nothing is divided by zero
SMALLEST_ERROR = 1e-5  # e is taken for at least this: an error of zero says nothing about longer steps
# of the C up to which loops may be open: what the next step is made for; C goes at least as h^3
CLOSURE_AIM, CLOSURE_ORDER = 0.5, 3


@dataclass(frozen=True)
class Closure:
    """How well the loops of a step closed: error, the largest C [m or rad] in it, and limit, what is allowed."""

    error: ca.SX
    limit: ca.SX

    @property
    def is_met(self) -> ca.SX:
        """Do they close as well as is asked?"""
        return self.error <= self.limit

    @property
    def step_factor(self) -> ca.SX:
        """h_next / h, at most, with which they would; SHRINK where the error is not a number."""
        factor = (CLOSURE_AIM * self.limit / ca.fmax(self.error, LEAST_CLOSURE)) ** (1 / CLOSURE_ORDER)
        return ca.if_else(self.error >= 0, ca.fmax(factor, SHRINK), SHRINK)


@dataclass(frozen=True)
class StepSizeController:
    """Judges steps and proposes their lengths, from e^2 and the square of its peak.

    error_order: p, the order of the estimated error in h.
    """

    error_order: int

    def keeps_step(self, square: ca.SX, peak: ca.SX) -> ca.SX:
        """May h stay as it is? Not where the error is not a number."""
        return ca.logic_and(square <= 1, peak >= LOW_ERROR**2)

    def judge(self, square: ca.SX, closure: Closure | None) -> ca.SX:
        """Is the step accepted?"""
        accepted = square <= REJECTED_ERROR**2
        return accepted if closure is None else ca.logic_and(accepted, closure.is_met)

    def propose(self, square: ca.SX, peak: ca.SX, closure: Closure | None) -> ca.SX:
        """h_next / h; SHRINK where e is not finite."""
        worst = ca.if_else(
            square <= 1, ca.if_else(peak < LOW_ERROR**2, peak, AIMED_ERROR**2), ca.fmin(square, 1 / SMALLEST_ERROR**2)
        )
        factor = ca.exp((2 * ca.log(AIMED_ERROR) - ca.log(ca.fmax(worst, SMALLEST_ERROR**2))) / (2 * self.error_order))
        known = ca.if_else(square >= 0, factor, SHRINK)
        bounded = ca.fmin(GROW, ca.fmax(SHRINK, known))
        return bounded if closure is None else ca.fmin(bounded, closure.step_factor)

    def peak_after_step(self, square: ca.SX, peak: ca.SX) -> ca.SX:
        """The square of the peak after a step with the error e."""
        return ca.fmax(square, FORGET**2 * peak)

    def peak_after_change(self, square: ca.SX, peak: ca.SX, factor: ca.SX) -> ca.SX:
        """The square of the peak, after h was changed by a factor: what e would have been with the new length.

        Where it was remembered rather than seen, from e and RESUMED: so steps grow on until e is large again.
        """
        change = factor ** (2 * self.error_order)
        expected = ca.fmin(square * change, 1.0)
        return ca.if_else(
            ca.logic_and(peak > square, factor > 1), ca.fmax(expected, RESUMED**2), ca.fmin(peak * change, 1.0)
        )


def not_across(h: ca.SX, left: ca.SX) -> ca.SX:
    """The step to make where h is wanted and nothing may cross what is `left` away [s]: no tiny step is left over."""
    halved = ca.if_else(left < 2 * h, left / 2, h)
    return ca.if_else(left <= 1.1 * h, left, halved)
