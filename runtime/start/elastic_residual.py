"""What is left of the equations of motion where elastic coordinates have no acceleration."""

from __future__ import annotations

import casadi as ca

from runtime.contract.model import Model
from runtime.schemes.linear_solve import solve_symmetric
from runtime.schemes.stage_equations import StageEquations

CLOSURE_ITERATIONS = 4


def positions(model: Model) -> list[int]:
    """Where the elastic coordinates stand in q_i."""
    return [k for k, name in enumerate(model.q_i) if name in model.elastic]


def elastic_residual(model: Model) -> ca.Function:
    """(t, q_i, q_i_dot, loop unknowns, c) -> residual r, dr/dq_e, mass of q_e, q_d, q_d_dot; built once for a model."""
    return model.derived("elastic_equilibrium", lambda: _built(model, positions(model)))


def _built(model: Model, elastic: list[int]) -> ca.Function:
    n = len(model.q_i)
    rigid = [k for k in range(n) if k not in elastic]
    t, q, v = ca.SX.sym("t"), ca.SX.sym("q", n), ca.SX.sym("v", n)
    loop, constants = ca.SX.sym("loop", len(model.loop_unknowns)), ca.SX.sym("c", model.c_size)
    equations = StageEquations(model, constants)
    motion = equations.close(q, loop, t, CLOSURE_ITERATIONS)
    M_hat, Q_hat = equations.condensed(motion, v)
    residual, mass = Q_hat[elastic], M_hat[elastic, elastic]
    if rigid:
        sides = ca.horzcat(Q_hat[rigid], M_hat[rigid, elastic])
        columns = [solve_symmetric(M_hat[rigid, rigid], sides[:, k]) for k in range(sides.size2())]
        residual = residual - ca.mtimes(M_hat[elastic, rigid], columns[0])
        mass = mass - ca.mtimes(M_hat[elastic, rigid], ca.horzcat(*columns[1:]))
    inputs = [t, q, v, loop, constants]
    outputs = [residual, ca.jacobian(residual, q)[:, elastic], mass, motion.q_d, equations.rates(motion, v)]
    return ca.Function("residual", inputs, [ca.densify(output) for output in outputs])
