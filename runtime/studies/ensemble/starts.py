"""Where the cases start, before their constants are known: q_i, q_i_dot, a guess of q_d, and whether lanes close it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from runtime.contract.consistent_state import InitialStateError
from runtime.contract.coordinates import dependent_part, independent
from runtime.contract.errors import ArgumentError, ModelError
from runtime.contract.model import EmittedModel
from runtime.operating.given_state import angle_starts, closable, keeps_independent, spin_names
from runtime.running.inputs import Sampled, Schedule, bound, started
from runtime.start.start_state import start_state
from runtime.studies.ensemble.ensemble_spec import EnsembleSpec
from runtime.studies.ensemble.lane_programs import quasi_static


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
    """Starts of the cases of an ensemble."""

    def __init__(self, spec: EnsembleSpec) -> None:
        self.model, self.parameters, self.initial = spec.model, spec.parameters, spec.initial
        self.t0, self.start = spec.plan.t0, spec.start
        model, parameters, initial, t0, start = self.model, self.parameters, self.initial, self.t0, self.start
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


def in_lanes(model: EmittedModel, initial: list[str], start: str) -> bool:
    """Can these starts be made in lanes? Else Python makes them one by one."""
    if set(initial) & {*spin_names(model), *angle_starts(model)}:
        return False
    names = [model.coordinates[_column(model, name)] for name in initial]
    free = not model.constraints or (closable(model) and keeps_independent(model, names, ()))
    settles = model.places.all_independent and quasi_static(model, start)
    return free and (_given(model, initial, start) or settles)


def _given(model: EmittedModel, initial: list[str], start: str) -> bool:
    """Are elastic coordinates left as they are given?"""
    chosen = start or str(model.simulation.get("start", "given"))
    names = [model.coordinates[_column(model, name)] for name in initial]
    return chosen == "given" or (not start and any(name in model.elastic for name in names))


def _column(model: EmittedModel, name: str) -> int:
    """The coordinate that a value, a rate or a state of a controller by name belongs to."""
    rates = [entry.owner if entry.kind == "state" else f"{entry.name}_dot" for entry in model.description.coordinates]
    return model.coordinates.index(name) if name in model.coordinates else rates.index(name)


# Samples as an array: one row a case, one column a parameter or initial value.


def table_of(model: EmittedModel, parameters: Any, initial: Any) -> tuple[tuple[list[str], list[str]], np.ndarray]:
    """((names of parameters, names of initial values), samples (cases, names)).

    parameters, initial: mappings of names to arrays (cases,) or to one number for all cases, or tables with named
    columns (a DataFrame). Raises ArgumentError or ModelError.
    """
    groups = [columns_by_name("parameters", parameters), columns_by_name("initial", _values(initial))]
    known = {parameter.name for parameter in model.parameters}
    for name in groups[0]:
        if name not in known:
            model.parameter_vector({name: 1.0})  # says what there is
    lengths = {name: len(values) for group in groups for name, values in group.items() if values.ndim}
    if not lengths:
        raise ArgumentError("parameters, initial", "no array is among them: there is one case", "use simulate")
    cases = next(iter(lengths.values()))
    for name, count in lengths.items():
        if count != cases:
            first = next(iter(lengths))
            raise ArgumentError(name, f"has {count} values where {first} has {cases}", "give all the same length")
    if cases == 0:
        raise ArgumentError(next(iter(lengths)), "holds no values", "give at least one case")
    columns = {name: np.broadcast_to(values, cases) for group in groups for name, values in group.items()}
    table = np.column_stack(list(columns.values())).astype(float)
    _refuse_unusable(model, list(groups[0]), list(columns), table)
    return (list(groups[0]), list(groups[1])), table


def with_functions(model: EmittedModel, inputs: Mapping[str, Any] | None) -> tuple[EmittedModel, dict[str, Any]]:
    """(the model with functions of time among the inputs, {name: number or array} of the others).

    Raises ArgumentError or ModelError.
    """
    functions: dict[str, Any] = {}
    constant: dict[str, Any] = {}
    for name, value in (inputs or {}).items():
        if name not in model.signals.names:
            raise ModelError(f"model {model.name} has no input {name!r}; it has {', '.join(model.inputs) or 'none'}")
        if isinstance(value, tuple | Sampled):
            raise ArgumentError(
                f"inputs[{name!r}]", "samples and controllers belong to single runs", "give a constant or a function"
            )
        (functions if callable(value) else constant)[name] = value
    return bound(model, functions), constant


def _values(initial: Any) -> Any:
    """Of an equilibrium or a solution, in which all cases begin, values by name."""
    return initial.initial_values() if hasattr(initial, "initial_values") else initial


def columns_by_name(argument: str, given: Any) -> dict[str, np.ndarray]:
    """Values of each name: (cases,), or () where all cases share one. Raises ArgumentError."""
    found: dict[str, np.ndarray] = {}
    if given is None:
        return found
    if not hasattr(given, "items"):
        raise ArgumentError(argument, "must map names to arrays", 'such as {"rod.density": [7800.0, 7900.0]}')
    for name, values in given.items():
        try:
            array = np.asarray(values, dtype=float)
        except (TypeError, ValueError):
            raise ArgumentError(str(name), "does not hold numbers", "give an array of one value a case") from None
        if array.ndim > 1:
            raise ArgumentError(str(name), f"has shape {array.shape}", "give one value a case")
        found[str(name)] = array
    return found


def _refuse_unusable(model: EmittedModel, parameters: list[str], names: list[str], table: np.ndarray) -> None:
    """Numbers that are none, and signs that a use does not allow. Raises ArgumentError or ModelError."""
    bad = np.argwhere(~np.isfinite(table))
    if len(bad):
        case, k = (int(one) for one in bad[0])
        raise ArgumentError(f"{names[k]}[{case}]", f"is {table[case, k]}", "give finite numbers")
    bounds = {parameter.name: parameter.bound for parameter in model.parameters}
    for k, name in enumerate(parameters):
        values, bound = table[:, k], bounds[name]
        wrong = values <= 0 if bound == "positive" else values < 0 if bound == "not negative" else values != values
        if wrong.any():
            case = int(np.argmax(wrong))
            words = "positive" if bound == "positive" else "at least zero"
            raise ModelError(f"{name}[{case}]", f"must be {words}, not {values[case]:g}", "correct or remove the case")
    if model.description.bounded and parameters:
        _refuse_expressions(model, parameters, table)


def _refuse_expressions(model: EmittedModel, parameters: list[str], table: np.ndarray) -> None:
    """Expressions of the scene that have lost the sign that their use asks for. Raises ModelError."""
    function = model.kernel("bounded")
    for first in range(0, len(table), 4096):
        p = vectors(model, parameters, table[first : first + 4096])
        values = np.asarray(function.map(len(p))(p.T)).reshape(-1, len(p))
        for quantity, row in zip(model.description.bounded, values, strict=True):
            wrong = ~(row > 0) if quantity.bound == "positive" else ~(row >= 0)
            if quantity.bound != "any" and wrong.any():
                case = first + int(np.argmax(wrong))
                model.parameter_vector(dict(zip(parameters, table[case], strict=False)))  # says it in its words
                raise ModelError(
                    f"case {case}", f"{quantity.item} would be {row.min():.6g}", "correct or remove the case"
                )


def vectors(model: EmittedModel, parameters: list[str], table: np.ndarray, own: np.ndarray | None = None) -> np.ndarray:
    """p (cases, n_p) of rows of samples, whose first columns are these parameters; own (n_p,): of the others."""
    index = {parameter.name: k for k, parameter in enumerate(model.parameters)}
    p = np.repeat((model.parameter_vector() if own is None else own)[None, :], len(table), axis=0)
    for k, name in enumerate(parameters):
        p[:, index[name]] = table[:, k]
    return p
