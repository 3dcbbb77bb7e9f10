"""From saved states of a scheme to a Solution: all coordinates, rates, reactions, energies, constraint error."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import fields, replace
from typing import Any

import casadi as ca
import numpy as np

from runtime.contract.coordinates import at_home, independent_part, whole
from runtime.contract.model import EmittedModel
from runtime.contract.status import Status
from runtime.engine.rows import evaluate
from runtime.results.samples import Later
from runtime.schemes.scheme import Scheme
from runtime.solutions.solution import Solution

# ---- Multipliers and joint forces of saved states; with redundant constraints those of least norm.
#
# Redundant rows leave the multipliers open by C_q^T N = 0: each choice gives the same motion. The one taken here
# has the least sum of squares, and the joint forces are those that go with it.


def joint_reactions(
    model: EmittedModel, values: Mapping[str, np.ndarray], C_q: np.ndarray, c: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """(lam (N, n_c), world forces and moments of the joints (N, joints, 3)) at N states.

    values: q, q_dot, q_ddot and t, samples by rows; C_q (N, n_c n), flattened column by column.
    """
    kernel, n = model.kernel("reactions"), len(values["q"])
    given = {**values, "lam_R": np.zeros((n, len(model.redundant)))}
    found = evaluate(kernel, given, c)
    if model.redundant:
        jacobians = C_q.reshape(n, len(model.coordinates), len(model.constraints)).transpose(0, 2, 1)
        least = least_norm(found["lam"], jacobians, len(model.kept_rows))
        found = evaluate(kernel, {**given, "lam_R": least[:, model.redundant_rows]}, c)
    return found["lam"], found["joint_forces"].reshape(n, len(model.joints), kernel.size1_out("joint_forces"))


def least_norm(lam: np.ndarray, C_q: np.ndarray, rank: int) -> np.ndarray:
    """lam (N, n_c) without what C_q^T (C_q: N, n_c, n) maps to zero; rank: number of independent rows."""
    kept = np.linalg.svd(C_q, full_matrices=False)[0][:, :, :rank]
    return np.asarray(np.einsum("sik,sjk,sj->si", kept, kept, lam))


OBSERVED_CLOSURE_TOLERANCE = (
    1e-12  # constraint error of a sample [mechanism lengths, at least 1 m] beyond which its closure is repeated
)
MOST_OBSERVED_CLOSURES = 8


def observe_samples(
    model: EmittedModel,
    scheme: Scheme,
    samples: np.ndarray,
    p: np.ndarray,
    c: np.ndarray,
    name: str,
    stats: dict[str, float | int | str],
    status: Status,
) -> Solution:
    """Solution of the samples (N, len(z)) of a scheme's state between major steps."""
    observed = evaluate(scheme.observer, {"z": samples}, scheme.constants(c))
    if "inputs" in scheme.layout.sizes:  # each sample has its own
        c = np.tile(c, (len(samples), 1))
        c[:, -model.signals.size :] = samples[:, scheme.layout.slice("inputs")]
    if model.loop_unknowns:
        _close_tightly(model, observed, c)
    q = whole(model, observed["q_i"], observed["q_d"])
    q_dot = whole(model, observed["q_i_dot"], observed["q_d_dot"])
    q_ddot = whole(model, observed["q_i_ddot"], observed["q_d_ddot"])
    t = observed["t"][:, 0]
    stats = {**stats, "closure_error": float(samples[-1][scheme.layout.slice("closure_error")][0])}
    return assemble_solution(model, t, q, q_dot, q_ddot, p, c, name, scheme.grid.dt_L, scheme.grid.m, stats, status)


def _close_tightly(model: EmittedModel, observed: dict[str, np.ndarray], c: np.ndarray) -> None:
    """More Newton steps for samples whose constraints do not hold to rounding; their rates follow (Eq. 36).

    Turns are observed at zero, so the charts are where the bodies are.
    """
    for _ in range(MOST_OBSERVED_CLOSURES):
        c, observed["q_d"] = at_home(model, c, observed["q_d"])
        found = evaluate(model.kernel("closure"), observed, c)
        scale = np.maximum(1.0, np.abs(observed["q_d"]).max(axis=1, initial=0.0))
        open_ = np.flatnonzero(np.abs(found["C_loop"]).max(axis=1) > OBSERVED_CLOSURE_TOLERANCE * scale)
        if not len(open_) or not np.isfinite(found["q_d_next"][open_]).all():
            return
        observed["q_d"][open_] = found["q_d_next"][open_]
        rows = {name: values[open_] for name, values in observed.items()}
        own = c if c.ndim == 1 else c[open_]
        observed["q_d_dot"][open_] = evaluate(model.kernel("velocities"), rows, own)["q_d_dot"]


def assemble_solution(
    model: EmittedModel,
    t: np.ndarray,
    q: np.ndarray,
    q_dot: np.ndarray,
    q_ddot: np.ndarray,
    p: np.ndarray,
    c: np.ndarray,
    name: str,
    dt: float,
    m: list[int],
    stats: dict[str, float | int | str],
    status: Status,
) -> Solution:
    """Solution from full coordinate histories (N, n): what any integrator on the emitted functions can call.

    c: the model's constants (c_size,), or those of each sample (N, c_size).
    """
    values = {"q": q, "q_dot": q_dot, "q_ddot": q_ddot, "t": t[:, None]}
    forces = Later(lambda: _constraint_forces(model, values, c))
    from runtime.results.friction import frictions

    return Solution(
        model=model,
        scheme=name,
        dt=dt,
        m=list(m),
        parameters=p,
        t=t,
        q_i=independent_part(model, q),
        q=q,
        q_dot=q_dot,
        q_ddot=q_ddot,
        lam=forces.part("lam"),  # type: ignore[arg-type]
        energy=Later(lambda: {**_energies(model, values, c), "power_driven": forces()["power_driven"]}),  # type: ignore[arg-type]
        constraint_error=forces.part("error"),  # type: ignore[arg-type]
        constraint_rate_error=forces.part("rate_error"),  # type: ignore[arg-type]
        measures=Later(lambda: _measures(model, values, c, forces)),  # type: ignore[arg-type]
        joint_forces=forces.part("joint_forces"),  # type: ignore[arg-type]
        load_forces=Later(lambda: _load_forces(model, values, c)),  # type: ignore[arg-type]
        frictions=Later(lambda: frictions(model, values, c)),  # type: ignore[arg-type]
        stats=stats,
        status=status,
    )


def _energies(model: EmittedModel, values: Mapping[str, np.ndarray], c: np.ndarray) -> dict[str, np.ndarray]:
    return {key: column[:, 0] for key, column in evaluate(model.kernel("energy"), dict(values), c).items()}


def _measures(
    model: EmittedModel, values: Mapping[str, np.ndarray], c: np.ndarray, forces: Callable[[], Mapping[str, np.ndarray]]
) -> np.ndarray:
    """Measures and their rates; behind them those that follow from accelerations and the multipliers of `forces`."""
    found = [np.zeros((len(values["t"]), 0))]
    if model.state_measures:
        found.append(evaluate(model.kernel("measures"), dict(values), c)["measures"])
    if model.acceleration_measures:
        lam_R = forces()["lam"][:, model.redundant_rows]
        kernel = model.kernel("acceleration_measures")
        found.append(evaluate(kernel, {**values, "lam_R": lam_R}, c)["acceleration_measures"])
    return np.hstack(found)


def _load_forces(model: EmittedModel, values: Mapping[str, np.ndarray], c: np.ndarray) -> np.ndarray:
    n = len(values["t"])
    if not model.has("load_actions"):
        return np.zeros((n, len(model.description.loads), _parts(model)))
    flat = evaluate(model.kernel("load_actions"), dict(values), c)["load_actions"]  # one load after another
    return flat.reshape(n, -1, _parts(model))


def _constraint_forces(model: EmittedModel, values: Mapping[str, np.ndarray], c: np.ndarray) -> dict[str, np.ndarray]:
    """Multipliers, joint forces, power of the drives and how well the constraints hold."""
    n = len(values["t"])
    if not model.constraints:
        nothing, none = np.zeros(n), np.zeros((n, 0))
        found = {"lam": none, "joint_forces": np.zeros((n, 0, _parts(model))), "power_driven": nothing}
        return {**found, "error": nothing, "rate_error": nothing}
    constraint = evaluate(model.derived("constraint_errors", lambda: _constraint_errors(model)), dict(values), c)
    C_q = evaluate(model.kernel("constraints"), dict(values), c)["C_q"] if model.redundant else np.zeros((n, 0))
    lam, forces = joint_reactions(model, values, C_q, c)
    with np.errstate(all="ignore"):  # of states that are not finite
        driven = np.sum(lam * constraint["C_t"], axis=1)
    errors = {"error": np.abs(constraint["C"]).max(axis=1), "rate_error": np.abs(constraint["C_dot"]).max(axis=1)}
    return {"lam": lam, "joint_forces": forces, "power_driven": driven, **errors}


def _parts(model: EmittedModel) -> int:
    return 6 if model.description.drawing.space == "spatial" else 3


def concatenated(parts: Sequence[Solution], model: EmittedModel) -> Solution:
    """One Solution from parts that follow each other, perhaps with other q_i: q_i become those of `model`."""
    if len(parts) == 1 and parts[0].model is model:
        return parts[0]
    arrays: dict[str, Any] = {
        entry.name: np.concatenate([getattr(part, entry.name) for part in parts])
        for entry in fields(Solution)
        if isinstance(getattr(parts[-1], entry.name), np.ndarray) and entry.name not in ("parameters", "q_i")
    }
    energy = {key: np.concatenate([part.energy[key] for part in parts]) for key in parts[-1].energy}
    return replace(parts[-1], **arrays, energy=energy, model=model, q_i=independent_part(model, arrays["q"]))


def _constraint_errors(model: EmittedModel) -> ca.Function:
    """(q, q_dot, t, c) -> C, C_t, C_dot = C_q q_dot + C_t."""
    n = len(model.coordinates)
    values = {
        "q": ca.SX.sym("q", n),
        "q_dot": ca.SX.sym("q_dot", n),
        "t": ca.SX.sym("t"),
        "c": ca.SX.sym("c", model.c_size),
    }
    found = model.evaluate("constraints", **values)
    C_dot = ca.mtimes(found["C_q"], values["q_dot"]) + found["C_t"]
    return ca.Function(
        "constraint_errors",
        list(values.values()),
        [found["C"], found["C_t"], C_dot],
        list(values),
        ["C", "C_t", "C_dot"],
    )
