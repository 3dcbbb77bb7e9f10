"""From saved states of a scheme to a Solution: all coordinates, rates, reactions, energies, constraint error."""

from __future__ import annotations

import casadi as ca
import numpy as np

from runtime.model import Model
from runtime.schemes.scheme import Scheme
from runtime.solution import Solution
from runtime.status import Status

BLOCK = 256  # samples a call


def observe_samples(model: Model, scheme: Scheme, samples: np.ndarray, p: np.ndarray, c: np.ndarray,
                    name: str, stats: dict[str, float | int | str], status: Status) -> Solution:
    """Solution of the samples (N, len(z)) of a scheme's state between major steps."""
    observed = evaluate(scheme.observe(), {"z": samples}, scheme.constants(c))
    q = join(model, observed["q_i"], observed["q_d"])
    q_dot = join(model, observed["q_i_dot"], observed["q_d_dot"])
    q_ddot = join(model, observed["q_i_ddot"], observed["q_d_ddot"])
    t = observed["t"][:, 0]
    stats = {**stats, "closure_error": float(samples[-1][scheme.layout.slice("closure_error")][0])}
    return assemble_solution(model, t, q, q_dot, q_ddot, p, c, name, scheme.grid.dt_L, scheme.grid.m, stats, status)


def assemble_solution(
    model: Model, t: np.ndarray, q: np.ndarray, q_dot: np.ndarray, q_ddot: np.ndarray, p: np.ndarray, c: np.ndarray,
    name: str, dt: float, m: list[int], stats: dict[str, float | int | str], status: Status,
) -> Solution:
    """Solution from full coordinate histories (N, n): what any integrator on the emitted functions can call."""
    values = {"q": q, "q_dot": q_dot, "q_ddot": q_ddot, "t": t[:, None]}
    energy = {key: column[:, 0] for key, column in evaluate(model.kernel("energy"), values, c).items()}
    n = len(t)
    lam, error, driven, measures = np.zeros((n, 0)), np.zeros(n), np.zeros(n), np.zeros((n, 0))
    forces = np.zeros((n, 0, 3))
    if model.constraints:
        constraint = evaluate(model.kernel("constraints"), values, c)
        reactions = evaluate(model.kernel("reactions"), values, c)
        lam, forces = reactions["lam"], reactions["joint_forces"].reshape(n, len(model.joints), 3)
        error = np.abs(constraint["C"]).max(axis=1)
        driven = np.sum(lam * constraint["C_t"], axis=1)
    if model.measures:
        measures = evaluate(model.kernel("measures"), values, c)["measures"]
    return Solution(model=model, scheme=name, dt=dt, m=list(m), parameters=p, t=t, q_i=q[:, model.independent_columns],
                    q=q, q_dot=q_dot, q_ddot=q_ddot, lam=lam, energy={**energy, "power_driven": driven},
                    constraint_error=error, measures=measures, joint_forces=forces, stats=stats, status=status)


def join(model: Model, independent: np.ndarray, dependent: np.ndarray) -> np.ndarray:
    """(N, n) in coordinate order from (N, n_i) and (N, n_d)."""
    full = np.zeros((independent.shape[0], len(model.coordinates)))
    full[:, model.independent_columns] = independent
    full[:, model.dependent_columns] = dependent
    return full


def evaluate(function: ca.Function, values: dict[str, np.ndarray], c: np.ndarray) -> dict[str, np.ndarray]:
    """Outputs (N, size) of a Function at N samples (rows of each value), matrices flattened column by column."""
    n = next(iter(values.values())).shape[0]
    constant = [k for k, name in enumerate(function.name_in()) if name == "c"]
    size = min(BLOCK, max(1, n))
    mapped = function.map("samples", "serial", size, constant, [])  # building a map takes time for each sample
    output = {name: np.zeros((n, function.numel_out(name))) for name in function.name_out()}
    for first in range(0, n, size):
        rows = np.minimum(np.arange(first, first + size), n - 1)
        columns: dict[str, np.ndarray] = {name: c[:, None] if name == "c" else values[name][rows].T
                                          for name in function.name_in()}
        result = mapped(**columns)
        for name, table in output.items():
            height, width = function.size_out(name)
            block = np.asarray(result[name], dtype=float).reshape(height, size, width)
            table[first:first + size] = block.transpose(1, 2, 0).reshape(size, -1)[:n - first]
    return output
