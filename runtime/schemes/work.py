"""The work done on a mechanism, integrated along with the steps of any scheme: dW/dt = P.

P = power_applied + lam^T C_t - power_dissipated at the end of every major step. W is the integral of the cubic through
the last four of them (Adams-Moulton, order 4; the first three steps by the trapezoidal rule, Simpson's and the 3/8
rule), so it does not depend on which samples are kept. A mechanism that nothing feeds or damps has no such fields.
"""

from __future__ import annotations

from collections.abc import Mapping

import casadi as ca
import numpy as np

from runtime.contract.model import Model
from runtime.engine.program import Fields, Program, Sequence
from runtime.schemes.scheme import Scheme
from runtime.schemes.stage_equations import StageEquations

# work [J], and by how much it may be wrong; where it stood when the powers were counted from; the last three powers
# [W], newest first; how many steps were counted
FIELDS = {"work": 1, "work_doubt": 1, "work_base": 1, "power": 3, "powers": 1}


def works(model: Model) -> bool:
    """Do loads, dampers or prescribed motions do work on the mechanism? False where no function tells."""
    if not model.has("energy") or (model.constraints and not (model.has("constraints") and model.has("reactions"))):
        return False
    outputs = [("energy", "power_applied"), ("energy", "power_dissipated")]
    outputs += [("constraints", "C_t")] if model.constraints else []
    return not all(model.structurally_zero(function, output) for function, output in outputs)


def account_for_work(scheme: Scheme) -> None:
    """Give z the fields of the work, where there is any. Before anything of the scheme is built."""
    if works(scheme.model) and "work" not in scheme.layout.sizes:
        scheme.keep_account(FIELDS)


def program_with_work(scheme: Scheme) -> Program:
    """A major step, and the account of its work where z has its fields."""
    if "work" not in scheme.layout.sizes:
        return scheme.program()
    return Sequence((scheme.program(), scheme.stage("work", lambda z, equations: _accounted(scheme, z, equations))))


def begin_account(scheme: Scheme, z: np.ndarray, c: np.ndarray, work: float = 0.0) -> None:
    """Count anew from a state z (at least the scheme's part, flat) with this work [J]; c as the stages read it."""
    if "work" not in scheme.layout.sizes:
        return
    layout = scheme.layout
    z[layout.slice("work")] = z[layout.slice("work_base")] = work
    z[layout.slice("powers")] = 0.0
    z[layout.slice("power")] = 0.0
    state = z[: layout.size]
    z[layout.slice("power")][0] = float(_power_function(scheme)(state, c))


def work_of(scheme: Scheme, z: np.ndarray) -> float:
    """W of a state [J]; zero where there is no account."""
    return float(z[scheme.layout.slice("work")][0]) if "work" in scheme.layout.sizes else 0.0


def doubt_of(scheme: Scheme, z: np.ndarray) -> float:
    """By how much W may be wrong where the power changes within a step [J]: a stiff damper, a pulse."""
    return float(z[scheme.layout.slice("work_doubt")][0]) if "work" in scheme.layout.sizes else 0.0


def _power_function(scheme: Scheme) -> ca.Function:
    """(z, c) -> P, built once for a scheme."""
    if scheme.power_function is None:
        z, c = ca.SX.sym("z", scheme.layout.size), ca.SX.sym("c", scheme.c_size)
        power = _power(scheme, scheme.layout.unpack(z), scheme.equations(c, scheme.layout.unpack(z)), c)
        scheme.power_function = ca.Function("power", [z, c], [power])
    return scheme.power_function


def _power(scheme: Scheme, z: Fields, equations: StageEquations, c: ca.SX) -> ca.SX:
    """P at the state that z shows [W]."""
    model = scheme.model
    seen = scheme.observer(z=scheme.layout.pack(z), c=c)
    n = len(model.coordinates)
    full = {name: ca.SX(n, 1) for name in ("q", "q_dot", "q_ddot")}
    for columns, kind in ((model.independent_columns, "i"), (model.dependent_columns, "d")):
        for position, column in enumerate(columns):
            for name, end in (("q", ""), ("q_dot", "_dot"), ("q_ddot", "_ddot")):
                full[name][int(column)] = seen[f"q_{kind}{end}"][position]
    at = {**full, "t": seen["t"]}
    energy = equations.call("energy", **at)
    power = energy["power_applied"] - energy["power_dissipated"]
    if model.constraints and not model.structurally_zero("constraints", "C_t"):
        lam = equations.call("reactions", **at, lam_R=ca.SX.zeros(len(model.redundant)))["lam"]
        power = power + ca.dot(lam, equations.call("constraints", **at)["C_t"])
    return power


def _accounted(scheme: Scheme, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
    """W after one more major step."""
    h, past, count = equations.h[0], z["power"], z["powers"] + 1
    P = _power(scheme, z, equations, ca.vertcat(equations.c, equations.h))
    trapezoid = z["work_base"] + h / 2 * (P + past[0])
    simpson = z["work_base"] + h / 3 * (P + 4 * past[0] + past[1])
    three_eighths = z["work_base"] + 3 * h / 8 * (P + 3 * past[0] + 3 * past[1] + past[2])
    further = z["work"] + h / 24 * (9 * P + 19 * past[0] - 5 * past[1] + past[2])
    early = ca.if_else(count < 2, trapezoid, ca.if_else(count < 3, simpson, three_eighths))
    work = ca.if_else(count < 4, early, further)
    doubt = z["work_doubt"] + ca.fabs(work - z["work"] - h / 2 * (P + past[0]))
    doubt = doubt + ca.if_else(count < 2, h / 2 * ca.fabs(P - past[0]), 0)
    return {"work": work, "work_doubt": doubt, "power": ca.vertcat(P, past[:2]), "powers": ca.fmin(count, 4)}
