"""What the equations of a stage give: closed configurations, linear systems."""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca


@dataclass(frozen=True)
class ClosedConfiguration:
    """A configuration with consistent q_d; C_loop is the largest error before the last Newton step, det_loop the
    determinants of the loop blocks there.
    """

    q_i: ca.SX
    q_d: ca.SX
    t: ca.SX
    C_loop: ca.SX
    det_loop: ca.SX


@dataclass(frozen=True)
class LinearisedEquations:
    """M_hat dv' = Q_hat - M_hat a + J_q dq + J_v dv about a state with q_i_ddot = a; J_q is d(Q_hat - M_hat a)/dq_i.

    Turns are at theta = 0 of their charts, and dq, dv of them rotation vectors there and their rates.
    """

    M_hat: ca.SX
    Q_hat: ca.SX
    a: ca.SX
    J_q: ca.SX
    J_v: ca.SX
