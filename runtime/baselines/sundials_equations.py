"""What SUNDIALS integrates, with exact derivatives: y' = f(t, y) for CVODES, and M_hat a = Q_hat beside it for IDAS.

Derivatives of accelerations are the emitted ones where every coordinate has a rate, (M_hat^-1 J_q, M_hat^-1 J_v), which
are far shorter on long trees than what differentiates the elimination; bodies with charts take CasADi's. Loop unknowns
follow from q_i, so what depends on them is in J_q.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import casadi as ca

from runtime.baselines.condensed_ode import CondensedOde
from runtime.contract.model import Model
from runtime.schemes.linear_solve import solve_symmetric
from runtime.schemes.sparse_lu import Number, factor, solve

CLOSURES = 1  # Newton steps: y brings a guess that is as good as the states


@dataclass(frozen=True)
class SundialsEquations:
    """inputs t, x (and z = a for IDAS), outputs ode (and alg) in them and in c; slopes by names of both.

    start: (t, y, c) -> z.
    """

    inputs: Mapping[str, ca.SX]
    outputs: Mapping[str, ca.SX]
    slopes: Mapping[tuple[str, str], ca.SX]
    c: ca.SX
    start: ca.Function


def explicit(model: Model) -> SundialsEquations:
    """y' = f(t, y) with the accelerations by the cheapest route."""
    ode = CondensedOde(model, CLOSURES)
    slope = ode.slope(ode.accelerations())
    if _has_rows(model):
        found = ode.equations.along_rotations(ode.motion, ode.v)
        factors = factor(Number(ca.sparsify(found.M_hat)), symmetric=True)
        sides = ca.horzsplit(ca.densify(ca.horzcat(found.J_q, found.J_v)))
        columns = [solve(factors, Number(ca.densify(side))).re for side in sides]
        slopes = _with_accelerations(ode, slope, ca.horzcat(*columns))
    else:
        slopes = ca.jacobian(slope, ode.y)
    start = ca.Function("start", [ode.t, ode.y, ode.c], [ca.SX(0, 1)])
    inputs = {"t": ode.t, "x": ode.y}
    return SundialsEquations(inputs, {"ode": slope}, {("ode", "x"): slopes}, ode.c, start)


def implicit(model: Model) -> SundialsEquations:
    """y' = f(y, a) and M_hat a - Q_hat = 0."""
    ode, a = CondensedOde(model, CLOSURES), ca.SX.sym("a", len(model.q_i))
    M_hat, Q_hat = ode.equations.condensed(ode.motion, ode.v)
    slope, rows = ode.slope(a), ca.densify(ca.mtimes(M_hat, a) - Q_hat)
    if _has_rows(model):
        at = {"q_i": ode.motion.q_i, "q_d": ode.motion.q_d, "q_i_dot": ode.v, "q_d_dot": ode.v_d, "t": ode.t}
        found = ode.equations.call("residual_jacobian", **at, q_i_ddot=a)
        by_y = ca.horzcat(-found["J_q"], -found["J_v"], ca.SX(ode.n, ode.y.numel() - 2 * ode.n))
    else:
        by_y = ca.jacobian(rows, ode.y)
    slopes = {
        ("ode", "x"): ca.jacobian(slope, ode.y),
        ("ode", "z"): ca.jacobian(slope, a),
        ("alg", "x"): ca.sparsify(by_y),
        ("alg", "z"): ca.sparsify(M_hat),
    }
    start = ca.Function("start", [ode.t, ode.y, ode.c], [solve_symmetric(M_hat, Q_hat)])
    inputs = {"t": ode.t, "x": ode.y, "z": a}
    return SundialsEquations(inputs, {"ode": slope, "alg": rows}, slopes, ode.c, start)


def _has_rows(model: Model) -> bool:
    """Are the emitted derivatives those by y? By the parameters of an orientation they are not."""
    return model.has("residual_jacobian") and not len(model.places.turns)


def _with_accelerations(ode: CondensedOde, slope: ca.SX, by_state: ca.SX) -> ca.SX:
    """d y' / d y, that of the accelerations by (q_i, q_i_dot) given."""
    n, rows = ode.n, ca.SX(ode.y.numel(), ode.y.numel())
    rows[:n, n : 2 * n] = ca.SX.eye(n)
    rows[n : 2 * n, : 2 * n] = by_state
    if ode.y.numel() > 2 * n:
        rows[2 * n :, :] = ca.jacobian(slope[2 * n :], ode.y)
    return ca.sparsify(rows)
