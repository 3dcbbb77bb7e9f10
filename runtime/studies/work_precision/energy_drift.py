"""Energy along a run of a method, on mechanisms that nothing feeds: largest error and trend."""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca
import numpy as np

from runtime.engine.rows import evaluate
from runtime.results.observe import join
from runtime.studies.work_precision.prepared_method import PreparedMethod


@dataclass(frozen=True)
class EnergyDrift:
    """Relative to the largest kinetic and elastic energy: largest error, and slope of a linear fit times duration."""

    largest: float
    trend: float


def energy_drift(prepared: PreparedMethod, steps: int) -> EnergyDrift | None:
    """Of a run in so many steps; None where the mechanism is fed or damped on purpose."""
    model, problem = prepared.problem.model, prepared.problem
    if not model.conservative:
        return None
    times, moving, total = energies(prepared, steps)
    scale = float(moving.max())
    if not np.isfinite(total).all() or scale <= 0:
        return None
    error = (total - total[0]) / scale
    trend = float(np.polyfit(times / problem.t_end, error, 1)[0])
    return EnergyDrift(float(np.abs(error).max()), trend)


def energies(prepared: PreparedMethod, steps: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Times (N,) [s], kinetic plus elastic energy (N,), and total energy (N,) [J] at samples of a run."""
    model = prepared.problem.model
    observed, c = prepared.observed(steps)
    q = join(model, observed["q_i"], observed["q_d"])
    q_dot = join(model, observed["q_i_dot"], observed["q_d_dot"])
    kernel: ca.Function = model.kernel("energy")
    found = evaluate(kernel, {"q": q, "q_dot": q_dot, "t": observed["t"]}, c)
    moving = (found["kinetic"] + found["elastic"])[:, 0]
    return observed["t"][:, 0], moving, moving + found["potential"][:, 0]
