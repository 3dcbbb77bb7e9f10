"""The length of the next step by proportional-integral control (Gustafsson 1991; Hairer and Wanner, Solving II, IV.2).

With the size e of the estimated error over the tolerance, e_last that of the accepted step before, and an estimate of
order p - 1 (an error of h^p),

    accepted, e <= 1:  h_next = h 0.8 e^(-0.7/p) e_last^(0.4/p)        rejected:  h_next = h 0.8 e^(-1/p)

A controller that looks at e alone (h e^(-1/p)) rejects a quarter of its steps on mechanisms.
"""

from __future__ import annotations

import casadi as ca

SAFETY, PROPORTIONAL, INTEGRAL = 0.8, 0.7, 0.4
SHRINK, GROW = 0.2, 5.0  # at most, from one step to the next
SMALLEST = 1e-4  # e is taken for at least this: an error of zero says nothing about longer steps


def step_factor(accepted: ca.SX, log_error: ca.SX, log_last: ca.SX, order: int, was_rejected: ca.SX) -> ca.SX:
    """h_next / h, from log e and log e_last; SHRINK where e is not finite. No growth right after a rejection."""
    after_acceptance = INTEGRAL / order * log_last - PROPORTIONAL / order * log_error
    factor = SAFETY * ca.exp(ca.if_else(accepted, after_acceptance, -log_error / order))
    most = ca.if_else(accepted, ca.if_else(was_rejected > 0, 1.0, GROW), SAFETY)
    return ca.fmin(most, ca.fmax(SHRINK, factor))


def not_across(h: ca.SX, left: ca.SX) -> ca.SX:
    """The step to make where h is wanted and nothing may cross what is `left` away [s]: no tiny step is left over."""
    halved = ca.if_else(left < 2 * h, left / 2, h)
    return ca.if_else(left <= 1.1 * h, left, halved)
