"""Driven mechanisms with flexible bodies whose elastic coordinates follow the loads without vibrating.

At each instant Q_hat(q_i, 0, t) = 0 for the elastic coordinates (Eq. 38 with q_i_ddot = q_i_dot = 0): loads and
inertia of the driven motion against stiffness. Their rates are those of the equilibrium along the motion,
J_q q_i_dot = -dQ_hat/dt.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from runtime.contract.coordinates import parts
from runtime.contract.errors import ModelError
from runtime.contract.model import Model
from runtime.contract.status import Status
from runtime.engine.rows import evaluate
from runtime.operating.balance import Clamped
from runtime.operating.equilibrium import NoEquilibrium
from runtime.operating.functions import PointFunctions
from runtime.operating.given_state import given_position
from runtime.results.observe import assemble_solution, join
from runtime.results.solution import Solution
from runtime.running.limits import with_limits
from runtime.schemes.options import SchemeError

SCHEME = "quasi_static"


def quasi_static_motion(
    model: Model,
    *,
    t_end: float | None = None,
    dt: float | None = None,
    parameters: Mapping[str, float] | None = None,
    t0: float = 0.0,
) -> Solution:
    """Positions, deformations, reactions and motors of a driven mechanism from t0 to t_end [s], a sample each dt.

    Every rigid coordinate must be driven. What is not given comes from the scene. Elastic accelerations are zero.
    Raises ModelError for free rigid coordinates, SchemeError for times, NoEquilibrium with the time where there is
    none.
    """
    free = [name for name in model.q_i if name not in model.elastic]
    if free:
        raise ModelError(f"model {model.name} moves freely in {', '.join(free)}: drive it, or simulate")
    end = float(model.simulation["t_end"] if t_end is None else t_end)
    step = float(model.simulation["dt"] if dt is None else dt)
    if not (np.isfinite([t0, end, step]).all() and step > 0 and end > t0):
        raise SchemeError("t_end, dt", "do not make a motion", "take t_end > t0 and dt > 0")
    times = t0 + step * np.arange(int(np.ceil((end - t0) / step * (1 - 1e-12))) + 1)
    p = model.parameter_vector(parameters)
    c = model.constants(p)
    q, q_i_dot = _followed(model, PointFunctions(model, c), times, *given_position(model, p, c, t0, {}))
    (independent, dependent), still = parts(model, q), np.zeros_like(q_i_dot)
    values = {"q_i": independent, "q_d": dependent, "q_i_dot": q_i_dot, "t": times[:, None]}
    values["q_d_dot"], values["q_i_ddot"], q_d_ddot = np.zeros_like(dependent), still, np.zeros_like(dependent)
    if model.q_d:
        values["q_d_dot"] = evaluate(model.kernel("velocities"), values, c)["q_d_dot"]
        q_d_ddot = evaluate(model.kernel("accelerations"), values, c)["q_d_ddot"]
    q_dot, q_ddot = join(model, q_i_dot, values["q_d_dot"]), join(model, still, q_d_ddot)
    status = Status("completed", float(times[-1]))
    return with_limits(assemble_solution(model, times, q, q_dot, q_ddot, p, c, SCHEME, step, [], {}, status))


def _followed(
    model: Model, functions: PointFunctions, times: np.ndarray, q_i: np.ndarray, loop: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """(q (N, n), q_i_dot (N, n_i)) of the equilibria, each reached from the one before."""
    task = Clamped(model, functions, float(times[0]), np.zeros(len(q_i)), [], np.zeros(0), loop)
    places, rates = [], []
    for t in times:
        task.t = float(t)
        found = task.solve(q_i)
        at = task.values(found.x) if found.converged else None
        if at is None:
            raise NoEquilibrium(f"model {model.name} has no quasi-static equilibrium in reach at t = {t:.9g} s", {})
        q_i = found.x
        places.append(at.q)
        rates.append(np.linalg.lstsq(at.J_q, -at.Q_t, rcond=1e-12)[0])
    return np.array(places), np.array(rates)
