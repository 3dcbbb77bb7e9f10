"""Total Jacobians of the condensed equations, through q_d = f(q_i, t) and q_d_dot = f'(q_i, q_i_dot, t)."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import casadi as ca

from symgen.algebra.scalar import ZERO
from symgen.condensed.condensation import Condensed
from symgen.kernels.held_multipliers import held_jacobians
from symgen.kernels.kernel import Kernel, shortest

if TYPE_CHECKING:
    from symgen.kernels.arguments import Arguments


def jacobian_kernels(system: Condensed, a: Arguments) -> dict[str, Callable[[], Kernel]]:
    """Builders of dQ_hat/dq_i, dQ_hat/dq_i_dot, and both of Q_hat - M_hat q_i_ddot, which share what both need."""
    state = a.select("q_i", "q_d", "q_i_dot", "q_d_dot")
    moving = a.select("q_i", "q_d", "q_i_dot", "q_d_dot", q_i_ddot=a.q_i_ddot)

    def of_force(name: str, which: int) -> Kernel:
        forms = held_jacobians(system, [ZERO] * a.q_i.numel())
        return shortest(state, [{name: form[which]} for form in forms])

    def of_residual() -> Kernel:
        forms = held_jacobians(system, ca.vertsplit(a.q_i_ddot))
        return shortest(moving, [{"J_q": J_q, "J_v": J_v} for J_q, J_v in forms])

    return {
        "dQ_hat_dq_i": lambda: of_force("dQ_hat_dq_i", 0),
        "dQ_hat_dq_i_dot": lambda: of_force("dQ_hat_dq_i_dot", 1),
        "residual_jacobian": of_residual,
    }
