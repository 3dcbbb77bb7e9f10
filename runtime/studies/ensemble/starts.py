"""Where the cases start, before their constants are known: q_i, q_i_dot, a guess of q_d, and whether lanes close it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from runtime.contract.consistent_state import InitialStateError
from runtime.contract.coordinates import dependent_part, independent
from runtime.contract.errors import ModelError
from runtime.contract.model import Model
from runtime.operating.given_state import angle_starts, closable, keeps_independent, spin_names
from runtime.running.inputs import Schedule, started
from runtime.start.start_state import start_state
from runtime.studies.ensemble.samples import vectors
from runtime.studies.ensemble.settle import quasi_static


@dataclass(frozen=True)
class Starts:
    """Of some cases: p (n_p,) and what of it is varied {position: values (cases,)}; q_i, q_i_dot (cases, n_i).

    q, q_dot (cases, n): the same of all coordinates, before lanes close them. q_d (cases, n_d); close (cases,): is it a
    guess that lanes close? settle (cases,): do lanes bring the elastic coordinates into equilibrium? impossible
    (cases,): there is no consistent start.
    """

    p: np.ndarray
    varied: dict[int, np.ndarray]
    q: np.ndarray
    q_dot: np.ndarray
    q_i: np.ndarray
    q_i_dot: np.ndarray
    q_d: np.ndarray
    close: np.ndarray
    settle: np.ndarray
    impossible: np.ndarray


class CaseStarts:
    """Starts of cases with these parameters and initial values; start: as in `simulate`, "" the scene's own."""

    def __init__(self, model: Model, parameters: list[str], initial: list[str], t0: float, start: str) -> None:
        self.model, self.parameters, self.initial, self.t0, self.start = model, parameters, initial, t0, start
        self._own = started(model, model.parameter_vector(), Schedule(model.signals), t0)
        self._defaults = np.array([parameter.default for parameter in model.parameters])
        index = {parameter.name: k for k, parameter in enumerate(model.parameters)}
        self._varied = {index[name]: k for k, name in enumerate(parameters)}
        others = np.setdiff1d(np.arange(len(self._own)), list(self._varied))
        same = np.array_equal(self._own[others], self._defaults[others])
        # where nothing is changed, the state is the model's own as it was found when it was generated
        self._changed = bool(initial or model.sources) or t0 != 0 or not same
        self._lanes, self._closable = in_lanes(model, initial, start), closable(model)
        self._settle = self._lanes and not _given(model, initial, start)
        self._places = [(name in model.coordinates, _column(model, name)) for name in initial] if self._lanes else []

    def of(self, table: np.ndarray) -> Starts:
        """Of rows of samples (cases, parameters and initial values)."""
        model, cases = self.model, len(table)
        varied = {position: table[:, k] for position, k in self._varied.items()}
        q = np.repeat(model.initial_q[None, :], cases, axis=0)
        q_dot = np.repeat(model.initial_q_dot[None, :], cases, axis=0)
        close, impossible = np.zeros(cases, dtype=bool), np.zeros(cases, dtype=bool)
        if self._lanes:
            for (is_position, place), values in zip(self._places, table.T[len(varied) :], strict=True):
                (q if is_position else q_dot)[:, place] = values
            changed = np.full(cases, self._changed)
            for position, values in varied.items():
                changed |= values != self._defaults[position]
            close = changed & self._closable
        else:
            self._one_by_one(table, q, q_dot, impossible)
        q_i, q_i_dot = independent(model, q, q_dot)
        settle = np.full(cases, self._settle)
        q_d = dependent_part(model, q)
        return Starts(self._own, varied, q, q_dot, q_i, q_i_dot, q_d, close, settle, impossible)

    def _one_by_one(self, table: np.ndarray, q: np.ndarray, q_dot: np.ndarray, impossible: np.ndarray) -> None:
        """As for a run by itself, into q and q_dot."""
        model = self.model
        vectors_ = vectors(model, self.parameters, table, self._own)
        for case, (p, values) in enumerate(zip(vectors_, table[:, len(self.parameters) :].tolist(), strict=True)):
            given = dict(zip(self.initial, values, strict=True)) or None
            try:
                found = start_state(model, p, model.constants(p), self.t0, given, self.start or None)
            except (InitialStateError, ModelError, np.linalg.LinAlgError):
                impossible[case] = True
            else:
                q[case], q_dot[case] = found.q, found.q_dot


def in_lanes(model: Model, initial: list[str], start: str) -> bool:
    """Can these starts be made in lanes? Else Python makes them one by one."""
    if set(initial) & {*spin_names(model), *angle_starts(model)}:
        return False
    names = [model.coordinates[_column(model, name)] for name in initial]
    free = not model.constraints or (closable(model) and keeps_independent(model, names, ()))
    settles = model.places.all_independent and quasi_static(model, start)
    return free and (_given(model, initial, start) or settles)


def _given(model: Model, initial: list[str], start: str) -> bool:
    """Are elastic coordinates left as they are given?"""
    chosen = start or str(model.simulation.get("start", "given"))
    names = [model.coordinates[_column(model, name)] for name in initial]
    return chosen == "given" or (not start and any(name in model.elastic for name in names))


def _column(model: Model, name: str) -> int:
    """The coordinate that a value, a rate or a state of a controller by name belongs to."""
    rates = [entry.owner if entry.kind == "state" else f"{entry.name}_dot" for entry in model.description.coordinates]
    return model.coordinates.index(name) if name in model.coordinates else rates.index(name)
