"""SUNDIALS through CasADi: CVODES on the condensed equations, IDAS on M_hat a = Q_hat with a algebraic (index 1).

Both get exact Jacobians by CasADi. Right-hand side and Jacobian are compiled by CasADi where there is a C compiler.
"""

from __future__ import annotations

import tempfile
import time
from collections.abc import Mapping
from contextlib import chdir
from dataclasses import dataclass
from typing import Any

import casadi as ca
import numpy as np

from runtime.baselines.condensed_ode import CondensedOde, Start, observed_solution, start_of
from runtime.baselines.pieces import refuse_impulses
from runtime.contract.errors import ArgumentError
from runtime.contract.model import Model
from runtime.contract.status import Status
from runtime.engine.compiled import CompilerError, find_compiler
from runtime.results.solution import Solution
from runtime.schemes.linear_solve import solve_symmetric

METHODS = ("cvodes", "idas")
MULTISTEP = {"bdf": "newton", "adams": "functional"}  # and how the equations of a step are solved
FLAGS = ("-O2", "-march=native", "-fno-math-errno")
MAX_STEPS = 100_000_000
COUNTERS = {
    "evaluations": "nfevals",
    "steps": "nsteps",
    "factorisations": "nlinsetups",
    "rejected": "netfails",
    "iterations": "nniters",
}


def sundials_solution(
    model: Model,
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
    compiled: bool = True,
    most_steps: int = MAX_STEPS,
) -> Solution:
    """Integrate from 0 to t_end [s] with `cvodes` or `idas`; for cvodes, multistep is `bdf` or `adams`.

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
    done = _integrated(model, method, given, t, _options(method, multistep, rtol, atol, most_steps), compiled)
    name = f"{method} {multistep}" if method == "cvodes" else method
    stats = {**done.stats, "rtol": rtol, "atol": atol}
    if done.refused:
        status = Status("integrator_refused", 0.0, None, f"{method} failed: {done.refused}", "Loosen the tolerances.")
        return observed_solution(model, given, np.zeros(1), given.y[None, :], name, stats, status)
    return observed_solution(model, given, t, done.y, name, stats, Status("completed", t_end))


def _options(method: str, multistep: str, rtol: float, atol: float, most_steps: int) -> dict[str, Any]:
    """Of CasADi's integrator."""
    options: dict[str, Any] = {"reltol": rtol, "abstol": atol, "max_num_steps": most_steps}
    if method == "idas":  # accelerations stay out of the error test: as exact, with fewer steps
        return {**options, "suppress_algebraic": True}
    return {**options, "linear_multistep_method": multistep, "nonlinear_solver_iteration": MULTISTEP[multistep]}


@dataclass(frozen=True)
class SundialsRun:
    """y (N, size) at the times asked for, what it took, and why SUNDIALS refused ("" where it did not)."""

    y: np.ndarray
    stats: dict[str, float | int | str]
    refused: str = ""


def _integrated(
    model: Model, method: str, given: Start, t: np.ndarray, options: dict[str, Any], compiled: bool
) -> SundialsRun:
    """Prepare, run once for the first calls and once for the time. Raises CompilerError."""
    system, guess = _system(model, method, given)
    began = time.perf_counter()
    integrator = _integrator(method, system, t, options, compiled)
    native = any(integrator.get_function(part).class_name() == "External" for part in integrator.get_function())
    stats: dict[str, float | int | str] = {
        **dict.fromkeys(COUNTERS, 0),
        "engine": "compiled" if native else "interpreted",
        "setup_seconds": time.perf_counter() - began,
        "wall_seconds": 0.0,
        "cpu_seconds": 0.0,
    }
    arguments = {"x0": given.y, "z0": guess, "p": given.c}
    try:
        try:
            integrator(**arguments)
        except RuntimeError:
            if method != "idas":
                raise
            # IDACalcIC gives up on some consistent starts; without it the rates at the start are taken as zero
            integrator = _integrator(method, system, t, {**options, "calc_ic": False}, compiled)
            integrator(**arguments)
        started, worked = time.perf_counter(), time.process_time()
        result = integrator(**arguments)
    except RuntimeError as error:
        return SundialsRun(given.y[None, :], stats, str(error).strip().splitlines()[-1])
    stats |= {"wall_seconds": time.perf_counter() - started, "cpu_seconds": time.process_time() - worked}
    counted = integrator.stats()
    stats |= {key: int(counted.get(counter, 0)) for key, counter in COUNTERS.items()}
    return SundialsRun(np.asarray(result["xf"]).T, stats)


def _system(model: Model, method: str, given: Start) -> tuple[dict[str, ca.SX], np.ndarray]:
    """CasADi's description, and the algebraic unknowns at the start."""
    ode = CondensedOde(model, 1)
    symbols = {"x": ode.y, "t": ode.t, "p": ode.c}
    if method == "cvodes":
        return {**symbols, "ode": ca.cse(ode.slope(ode.accelerations()))}, np.zeros(0)
    a = ca.SX.sym("a", ode.n)
    M_hat, Q_hat = ode.equations.condensed(ode.motion, ode.v)
    start = ca.Function("start", [ode.t, ode.y, ode.c], [solve_symmetric(M_hat, Q_hat)])
    slope, algebraic = ca.cse([ode.slope(a), ca.densify(ca.mtimes(M_hat, a) - Q_hat)])
    return {**symbols, "z": a, "ode": slope, "alg": algebraic}, np.asarray(start(0.0, given.y, given.c)).ravel()


def _integrator(
    method: str, system: dict[str, ca.SX], t: np.ndarray, options: dict[str, Any], compiled: bool
) -> ca.Function:
    compiler = find_compiler() if compiled else None
    if compiler is None:
        return ca.integrator("baseline", method, system, 0.0, t, options)
    # CasADi writes its C file to the working folder; once loaded, the library is not needed on disk any more
    jit: dict[str, Any] = {
        "jit": True,
        "compiler": "shell",
        "jit_name": "baseline",
        "jit_temp_suffix": False,
        "jit_cleanup": False,
        "jit_options": {
            "compiler": compiler,
            "linker": compiler,
            "flags": list(FLAGS),
            "verbose": False,
            "cleanup": False,
        },
    }
    with tempfile.TemporaryDirectory() as folder, chdir(folder):
        try:
            return ca.integrator("baseline", method, system, 0.0, t, {**options, **jit})
        except RuntimeError as error:
            raise CompilerError(f"CasADi could not compile the equations: {str(error)[-500:]}") from error
