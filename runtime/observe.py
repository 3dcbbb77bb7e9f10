"""From saved states of a scheme to a Solution: all coordinates, rates, reactions, energies, constraint error."""

from __future__ import annotations

import numpy as np

from runtime.model import Model
from runtime.reactions import joint_reactions
from runtime.sampling import evaluate
from runtime.schemes.scheme import Scheme
from runtime.solution import Solution
from runtime.status import Status


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
        lam, forces = joint_reactions(model, values, constraint["C_q"], c)
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
