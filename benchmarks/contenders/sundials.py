"""SUNDIALS through CasADi: CVODES on the condensed equations, IDAS on M_hat a = Q_hat with a algebraic (index 1).

Both call the native code that steps are made of, and get exact Jacobians as native code; without LLVM or a C compiler
CasADi interprets the same expressions and derives the Jacobians.
"""

from __future__ import annotations

import time
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import casadi as ca
import numpy as np

from benchmarks.contenders.external import External
from runtime import ArgumentError, ModelError, Solution, Status
from runtime.baselines.condensed_ode import CondensedOde, Start, observed_solution, start_of
from runtime.baselines.scipy_methods import Impulses
from runtime.contract.model import EmittedModel
from runtime.contract.tape import shared
from runtime.engine.c_source import find_compiler
from runtime.engine.llvm_code import find_llvm
from runtime.schemes.sparse_lu import Number, factor, solve, solve_symmetric
from runtime.schemes.switching.impulse import moves_in_time
from runtime.schemes.switching.times import SwitchTime, switching_times

# ---- What SUNDIALS integrates, with exact derivatives: y' = f(t, y) for CVODES, and M_hat a = Q_hat beside it
# for IDAS.
#
# Derivatives of accelerations are the emitted ones where every coordinate has a rate, (M_hat^-1 J_q, M_hat^-1 J_v),
# which are far shorter on long trees than what differentiates the elimination; bodies with charts take CasADi's.
# Loop unknowns follow from q_i, so what depends on them is in J_q.

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


def explicit(model: EmittedModel) -> SundialsEquations:
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


def implicit(model: EmittedModel) -> SundialsEquations:
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


def _has_rows(model: EmittedModel) -> bool:
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


def refuse_impulses(model: EmittedModel, c: np.ndarray, t_end: float, y: np.ndarray, who: str) -> None:
    """Raises ModelError for a prescribed motion whose velocity jumps, by the start y."""
    impulses = Impulses(model, c)
    times: list[SwitchTime] = switching_times(model, c, 0.0, t_end) if moves_in_time(model) else []
    for one in times:
        if 0 < one.time < t_end and impulses.across(y, one.before, one.after) is not y:
            raise ModelError(
                f"{', '.join(one.owners)} of model {model.name}",
                f"its velocity jumps at t = {one.time:.6g} s, and {who} knows no impulses",
                "take simulate, or let the velocity change in a finite time",
            )


METHODS = {"cvodes": explicit, "idas": implicit}
MULTISTEP = {"bdf": "newton", "adams": "functional"}  # and how the equations of a step are solved
MAX_STEPS = 100_000_000
COUNTERS = {
    "evaluations": "nfevals",
    "steps": "nsteps",
    "factorisations": "nlinsetups",
    "rejected": "netfails",
    "iterations": "nniters",
}
Stats = dict[str, float | int | str]


def sundials_solution(
    model: EmittedModel,
    method: str = "cvodes",
    *,
    t_end: float,
    times: np.ndarray | None = None,
    rtol: float = 1e-9,
    atol: float = 1e-11,
    parameters: Mapping[str, float] | None = None,
    initial: Mapping[str, float] | None = None,
    start: str | None = None,
    multistep: str = "bdf",
    highest_order: int | None = None,
    compiled: bool = True,
    most_steps: int = MAX_STEPS,
) -> Solution:
    """Integrate from 0 to t_end [s] with `cvodes` or `idas`; for cvodes, multistep is `bdf` or `adams`.

    highest_order: of the method; BDF of order 2 at most does not choose small steps to be stable on undamped modes.
    times: where to report (the end only by default); most_steps: from one of them to the next. A failed integration
    gives the start only, with its status. The times in stats are those of a second run: they hold no compilation or
    first call. Raises ArgumentError for an unknown method, ModelError or InitialStateError for bad arguments,
    CompilerError if compiling fails.
    """
    if method not in METHODS or multistep not in MULTISTEP:
        raise ArgumentError(
            f"method must be one of {', '.join(METHODS)} and multistep one of {', '.join(MULTISTEP)}, "
            f"not {method!r} and {multistep!r}"
        )
    given = start_of(model, parameters, initial, start)
    refuse_impulses(model, given.c, t_end, given.y, method)
    t = np.array([t_end]) if times is None else np.asarray(times, dtype=float)
    began = time.perf_counter()
    prepared = Sundials(model, method, given, compiled)
    ready = time.perf_counter() - began
    done = prepared.run(t, rtol, atol, multistep, highest_order, most_steps)
    name = f"{method} {multistep}" if method == "cvodes" else method
    stats = {**done.stats, "setup_seconds": ready, "rtol": rtol, "atol": atol}
    if done.refused:
        status = Status("integrator_refused", 0.0, None, f"{method} failed: {done.refused}", "Loosen the tolerances.")
        return observed_solution(model, given, np.zeros(1), given.y[None, :], name, stats, status)
    return observed_solution(model, given, t, done.y, name, stats, Status("completed", t_end))


@dataclass(frozen=True)
class SundialsRun:
    """y (N, size) at the times asked for, what it took, and why SUNDIALS refused ("" where it did not)."""

    y: np.ndarray
    stats: Stats
    refused: str = ""


@dataclass
class Sundials:
    """`cvodes` or `idas` on a model from a start, made ready once for runs to any tolerance.

    native: the compiled functions, None where CasADi interprets. Raises CompilerError.
    """

    model: EmittedModel
    method: str
    given: Start
    compiled: bool = True
    native: External | None = field(init=False, default=None)

    def __post_init__(self) -> None:
        self._equations: SundialsEquations = METHODS[self.method](self.model)
        e = self._equations
        if self.compiled and find_compiler() and not find_llvm():
            self.native = External(e.inputs, e.outputs, e.slopes, e.c, self.given.c)

    def run(
        self,
        t: np.ndarray,
        rtol: float,
        atol: float,
        multistep: str = "bdf",
        highest_order: int | None = None,
        most_steps: int = MAX_STEPS,
        repeats: int = 1,
    ) -> SundialsRun:
        """From 0 to times t (N,) [s]: once for the first calls, and then for the time, the least of so many repeats."""
        options: dict[str, Any] = {"reltol": rtol, "abstol": atol, "max_num_steps": most_steps}
        options |= {"disable_internal_warnings": True}  # what they say is in the status
        if highest_order is not None:
            options |= {"max_order": highest_order}
        if self.method == "idas":  # accelerations stay out of the error test: as exact, with fewer steps
            options |= {"suppress_algebraic": True}
        else:
            options |= {"linear_multistep_method": multistep, "nonlinear_solver_iteration": MULTISTEP[multistep]}
        stats: Stats = {
            **dict.fromkeys(COUNTERS, 0),
            "engine": "interpreted" if self.native is None else "compiled",
            "wall_seconds": 0.0,
            "cpu_seconds": 0.0,
        }
        try:
            integrator, arguments = self._started(t, options)
            spent = []
            for _ in range(repeats):
                started, worked = time.perf_counter(), time.process_time()
                result = integrator(**arguments)
                spent.append((time.process_time() - worked, time.perf_counter() - started))
        except RuntimeError as error:
            return SundialsRun(self.given.y[None, :], stats, str(error).strip().splitlines()[-1])
        stats["cpu_seconds"], stats["wall_seconds"] = min(spent)
        counted = integrator.stats()
        stats |= {key: int(counted.get(counter, 0)) for key, counter in COUNTERS.items()}
        return SundialsRun(np.asarray(result["xf"]).T, stats)

    def _started(self, t: np.ndarray, options: dict[str, Any]) -> tuple[ca.Function, dict[str, Any]]:
        """An integrator that has run once, and its arguments."""
        system, arguments = self._system()
        if self.method == "idas":  # the start is consistent: IDACalcIC, which gives up on some, has nothing to find
            options = {**options, "calc_ic": False, "init_xdot": self._slope(arguments)}
        integrator = ca.integrator("baseline", self.method, system, 0.0, t, options)
        integrator(**arguments)
        return integrator, arguments

    def _slope(self, arguments: dict[str, Any]) -> list[float]:
        """y' at the start."""
        e = self._equations
        slope = ca.Function("slope", [*e.inputs.values(), e.c], [ca.densify(e.outputs["ode"])])
        found = slope(0.0, arguments["x0"], arguments["z0"], self.given.c)
        return [float(value) for value in np.asarray(found).ravel()]

    def _system(self) -> tuple[dict[str, Any], dict[str, Any]]:
        """CasADi's description, and the arguments of a run."""
        e, given = self._equations, self.given
        z = np.asarray(e.start(0.0, given.y, given.c)).ravel()
        arguments = {"x0": given.y, "z0": z}
        if self.native is None:
            outputs = dict(zip(e.outputs, shared([ca.densify(value) for value in e.outputs.values()]), strict=True))
            return {**e.inputs, **outputs, "p": e.c}, {**arguments, "p": given.c}
        symbols = {name: ca.MX.sym(name, value.numel()) for name, value in e.inputs.items()}
        found = self.native.function.call(list(symbols.values()))
        return {**symbols, **dict(zip(e.outputs, found, strict=True))}, arguments
