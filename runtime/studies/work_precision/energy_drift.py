"""Energy along a run of a method, on mechanisms that nothing feeds: largest error and trend."""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca
import numpy as np

from runtime.contract.model import Model
from runtime.results.observe import join
from runtime.results.sampling import evaluate
from runtime.studies.work_precision.contender import Contender


@dataclass(frozen=True)
class EnergyDrift:
    """Relative to the largest kinetic and elastic energy: largest error, and slope of a linear fit times duration."""

    largest: float
    trend: float


def is_closed(model: Model) -> bool:
    """Do neither loads nor prescribed motions do work on the mechanism?"""
    needed = ("energy", "constraints") if model.constraints else ("energy",)
    if not all(model.has(name) for name in needed):
        return False
    outputs = [("energy", "power_applied")] + ([("constraints", "C_t")] if model.constraints else [])
    return all(model.structurally_zero(function, output) for function, output in outputs)


def energy_drift(contender: Contender, steps: int) -> EnergyDrift | None:
    """Of a run in so many steps; None where the mechanism is fed or damped on purpose."""
    model, problem = contender.problem.model, contender.problem
    if not is_closed(model):
        return None
    times, moving, total = energies(contender, steps)
    scale = float(moving.max())
    if not np.isfinite(total).all() or scale <= 0:
        return None
    error = (total - total[0]) / scale
    trend = float(np.polyfit(times / problem.t_end, error, 1)[0])
    return EnergyDrift(float(np.abs(error).max()), trend)


def energies(contender: Contender, steps: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Times, kinetic plus elastic energy, and total energy [J] at samples of a run."""
    model = contender.problem.model
    observed, c = contender.observed(steps)
    q = join(model, observed["q_i"], observed["q_d"])
    q_dot = join(model, observed["q_i_dot"], observed["q_d_dot"])
    kernel: ca.Function = model.kernel("energy")
    found = evaluate(kernel, {"q": q, "q_dot": q_dot, "t": observed["t"]}, c)
    moving = (found["kinetic"] + found["elastic"])[:, 0]
    return observed["t"][:, 0], moving, moving + found["potential"][:, 0]
