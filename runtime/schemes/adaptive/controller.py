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


def after_acceptance(h: ca.SX, error: ca.SX, last: ca.SX, order: int, was_rejected: ca.SX) -> ca.SX:
    """h after a step h [s] of this error; it does not grow right after a rejection."""
    factor = SAFETY * error ** (-PROPORTIONAL / order) * last ** (INTEGRAL / order)
    return h * ca.fmin(ca.if_else(was_rejected > 0, 1.0, GROW), ca.fmax(SHRINK, factor))


def after_rejection(h: ca.SX, error: ca.SX, order: int) -> ca.SX:
    """h to try instead of a step h [s]; SHRINK h where the error is not finite."""
    return h * ca.fmin(SAFETY, ca.fmax(SHRINK, SAFETY * error ** (-1 / order)))


def not_across(h: ca.SX, left: ca.SX) -> ca.SX:
    """The step to make where h is wanted and nothing may cross what is `left` away [s]: no tiny step is left over."""
    halved = ca.if_else(left < 2 * h, left / 2, h)
    return ca.if_else(left <= 1.1 * h, left, halved)
