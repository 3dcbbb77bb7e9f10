"""The price of one evaluation of a scheme's equations."""

from __future__ import annotations

import casadi as ca

from runtime.contract.tape import arithmetic, shared
from runtime.schemes.options import ClosureOptions
from runtime.schemes.scheme import Scheme


def evaluation_operations(scheme: Scheme) -> int:
    """Arithmetic operations of a full evaluation: closure, velocities, M_hat, Q_hat and the solution for q_i_ddot."""
    model = scheme.model
    q_i, v, t = ca.SX.sym("q_i", len(model.q_i)), ca.SX.sym("v", len(model.q_i)), ca.SX.sym("t")
    loop, c = ca.SX.sym("loop", len(model.loop_unknowns)), ca.SX.sym("c", scheme.c_size)
    equations = scheme.equations(c)
    assert isinstance(scheme.options, ClosureOptions)  # who takes sub-steps closes in each of them
    a = equations.accelerations(equations.close(q_i, loop, t, scheme.options.closure_iterations), v)
    return arithmetic(ca.Function("evaluation", [q_i, v, t, loop, c], shared([a])))
