"""SciPy's adaptive integrators on the condensed equations, right-hand side and Jacobian as native code."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from runtime.baselines.condensed_ode import CondensedOde, observed_solution, start_of
from runtime.contract.errors import ArgumentError, NoResult
from runtime.contract.model import Model
from runtime.contract.status import Status
from runtime.engine.functions import evaluator
from runtime.results.solution import Solution

EXPLICIT = ("RK23", "RK45", "DOP853")
IMPLICIT = ("Radau", "BDF", "LSODA")
Slope = Callable[[float, np.ndarray], np.ndarray]
MOST_EVALUATIONS = 5_000_000  # minutes of work: at a singular position steps would shrink for ever


def scipy_solution(
    model: Model,
    method: str = "DOP853",
    *,
    t_end: float,
    times: np.ndarray | None = None,
    rtol: float = 1e-9,
    atol: float = 1e-11,
    parameters: Mapping[str, float] | None = None,
    initial: Mapping[str, float] | None = None,
    start: str | None = None,
    compiled: bool = True,
    closure_iterations: int = 1,
) -> Solution:
    """Integrate the condensed equations from 0 to t_end with one of EXPLICIT or IMPLICIT (exact Jacobian).

    times: where to report (the end only by default). Raises ArgumentError for an unknown method, ModelError or
    InitialStateError for bad arguments, NoResult after MOST_EVALUATIONS.
    """
    from scipy.integrate import solve_ivp  # when it is needed: importing it takes a third of a second

    if method not in EXPLICIT + IMPLICIT:
        raise ArgumentError(f"method must be one of {', '.join(EXPLICIT + IMPLICIT)}, not {method!r}")
    given = start_of(model, parameters, initial, start)
    ode = CondensedOde(model, closure_iterations)
    slope, size = evaluator(ode.right_hand_side(), given.c, compiled), len(given.y)
    more: dict[str, Any] = {}
    if method in IMPLICIT:
        jacobian = evaluator(ode.jacobian(), given.c, compiled)
        more["jac"] = lambda t, y: jacobian(t, y).reshape(size, size).T.copy()
    t = np.array([t_end]) if times is None else np.asarray(times, dtype=float)
    started = time.perf_counter()
    result = solve_ivp(
        counted(slope, method), (0.0, t_end), given.y, method=method, t_eval=t, rtol=rtol, atol=atol, **more
    )
    wall = time.perf_counter() - started
    status = (
        Status("completed", t_end)
        if result.success
        else Status(
            "integrator_refused",
            float(result.t[-1]) if len(result.t) else 0.0,
            None,
            str(result.message),
            "Loosen the tolerances.",
        )
    )
    stats: dict[str, float | int | str] = {
        "evaluations": int(result.nfev),
        "wall_seconds": wall,
        "rtol": rtol,
        "atol": atol,
    }
    if method in IMPLICIT:
        stats |= {"jacobians": int(result.njev), "factorisations": int(result.nlu)}
    return observed_solution(model, given, result.t, result.y.T, method, stats, status)


def counted(slope: Slope, method: str) -> Slope:
    """The slope as a fresh array, up to MOST_EVALUATIONS times. Raises NoResult."""
    done = 0

    def evaluated(t: float, y: np.ndarray) -> np.ndarray:
        nonlocal done
        done += 1
        if done > MOST_EVALUATIONS:
            raise NoResult(
                f"{method} needs more than {MOST_EVALUATIONS:.0e} evaluations to get beyond t = {t:.9g} s: "
                "its steps shrink, as at a singular position of q_i or of Euler angles"
            )
        return slope(t, y).copy()

    return evaluated
