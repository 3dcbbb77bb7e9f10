"""Where the cases start, before their constants are known: q_i, q_i_dot, a guess of q_d, and whether lanes close it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from runtime.contract.consistent_state import InitialStateError
from runtime.contract.model import Model, ModelError
from runtime.operating.assembly import closable
from runtime.operating.given_state import keeps_independent
from runtime.running.inputs import Schedule, started
from runtime.start.start_state import start_state
from runtime.studies.ensemble.samples import vectors


@dataclass(frozen=True)
class Starts:
    """Of some cases: p (n_p,) and what of it is varied {position: values (cases,)}; q_i, q_i_dot (cases, n_i).

    q_d (cases, n_d); close (cases,): is it a guess that lanes close? impossible (cases,): there is no consistent start.
    """

    p: np.ndarray
    varied: dict[int, np.ndarray]
    q_i: np.ndarray
    q_i_dot: np.ndarray
    q_d: np.ndarray
    close: np.ndarray
    impossible: np.ndarray


def starts_of(
    model: Model, parameters: list[str], initial: list[str], table: np.ndarray, t0: float, start: str
) -> Starts:
    """Starts of the rows of samples (cases, parameters and initial values); start: as in `simulate`, "" the scene's."""
    cases, count = len(table), len(parameters)
    changes = table[:, count:]
    index = {parameter.name: k for k, parameter in enumerate(model.parameters)}
    own = started(model, model.parameter_vector(), Schedule(model.signals), t0)
    varied = {index[name]: table[:, k] for k, name in enumerate(parameters)}
    q = np.repeat(model.initial_q[None, :], cases, axis=0)
    q_dot = np.repeat(model.initial_q_dot[None, :], cases, axis=0)
    close, impossible = np.zeros(cases, dtype=bool), np.zeros(cases, dtype=bool)
    if in_lanes(model, initial, start):
        for k, name in enumerate(initial):
            if name in model.coordinates:
                q[:, model.coordinates.index(name)] = changes[:, k]
            else:
                q_dot[:, rates_of(model).index(name)] = changes[:, k]
        defaults = np.array([parameter.default for parameter in model.parameters])
        known = np.setdiff1d(np.arange(len(own)), list(varied))
        elsewhere = bool(initial or model.sources) or t0 != 0 or not np.array_equal(own[known], defaults[known])
        changed = np.full(cases, elsewhere)
        for position, values in varied.items():
            changed |= values != defaults[position]
        close = changed & closable(model)
    else:
        p = vectors(model, parameters, table, own)
        for case in range(cases):
            given = dict(zip(initial, (float(one) for one in changes[case]), strict=True))
            try:
                found = start_state(model, p[case], model.constants(p[case]), t0, given or None, start or None)
            except (InitialStateError, ModelError, np.linalg.LinAlgError):
                impossible[case] = True
                continue
            q[case], q_dot[case] = found.q, found.q_dot
    i, d = model.independent_columns, model.dependent_columns
    return Starts(own, varied, q[:, i], q_dot[:, i], q[:, d], close, impossible)


def in_lanes(model: Model, initial: list[str], start: str) -> bool:
    """Can these starts be made in lanes? Else Python makes them one by one, as for a run by itself."""
    chosen = start or str(model.simulation.get("start", "given"))
    coordinates = [name for name in initial if name in model.coordinates]
    rates = [
        model.coordinates[rates_of(model).index(name)]
        for name in initial
        if name not in model.coordinates and name in rates_of(model)
    ]
    given = chosen == "given" or (not start and any(name in model.elastic for name in [*coordinates, *rates]))
    free = not model.constraints or (closable(model) and keeps_independent(model, coordinates, rates))
    return given and free


def rates_of(model: Model) -> list[str]:
    """Names of the rates, in the order of the coordinates."""
    return [f"{name}_dot" for name in model.coordinates]
