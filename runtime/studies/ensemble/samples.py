"""Samples as an array: one row a case, one column a parameter or initial value."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from runtime.contract.errors import ArgumentError, ModelError
from runtime.contract.model import Model
from runtime.running.inputs import Sampled, bound


def table_of(model: Model, parameters: Any, initial: Any) -> tuple[tuple[list[str], list[str]], np.ndarray]:
    """((names of parameters, names of initial values), samples (cases, names)).

    parameters, initial: mappings of names to arrays (cases,) or to one number for all cases, or tables with named
    columns (a DataFrame); ("a", "b"): array (cases, 2) gives several names the columns of an array, as scipy.stats.qmc
    makes them. Raises ArgumentError or ModelError.
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


def with_functions(model: Model, inputs: Mapping[str, Any] | None, travels: bool) -> tuple[Model, dict[str, Any]]:
    """(the model with functions of time among the inputs, {name: number or array} of the others).

    travels: is the model loaded by others, whom a function does not reach? Raises ArgumentError or ModelError.
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
    if functions and travels:
        raise ArgumentError(
            f"inputs[{next(iter(functions))!r}]", "is a function, and workers load the model", "run it in threads"
        )
    return bound(model, functions), constant


def _values(initial: Any) -> Any:
    """Of an equilibrium or a solution, in which all cases begin, values by name."""
    return initial.initial_values() if hasattr(initial, "initial_values") else initial


def columns_by_name(argument: str, given: Any) -> dict[str, np.ndarray]:
    """Values of each name: (cases,), or () where all cases share one. Raises ArgumentError."""
    return dict(_columns(argument, given))


def _columns(argument: str, given: Any) -> Iterator[tuple[str, np.ndarray]]:
    """(name, values) of each column."""
    if given is None:
        return
    if hasattr(given, "columns") and hasattr(given, "__getitem__"):
        given = {str(name): given[name] for name in given.columns}
    if not isinstance(given, Mapping):
        raise ArgumentError(argument, "must map names to arrays", 'such as {"rod.density": [7800.0, 7900.0]}')
    for name, values in given.items():
        try:
            array = np.asarray(values, dtype=float)
        except (TypeError, ValueError):
            raise ArgumentError(str(name), "does not hold numbers", "give an array of one value a case") from None
        if isinstance(name, tuple):
            if array.ndim != 2 or array.shape[1] != len(name):
                raise ArgumentError(
                    f"{argument}[{name!r}]", f"needs {len(name)} columns, not shape {array.shape}", "one a name"
                )
            yield from ((str(one), array[:, k]) for k, one in enumerate(name))
        elif array.ndim > 1:
            raise ArgumentError(str(name), f"has shape {array.shape}", "give one value a case")
        else:
            yield str(name), array


def _refuse_unusable(model: Model, parameters: list[str], names: list[str], table: np.ndarray) -> None:
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
            raise ModelError(f"{name}[{case}]", f"must be {words}, not {values[case]:g}", "mend or drop the case")
    if model.description.bounded and parameters:
        _refuse_expressions(model, parameters, table)


def _refuse_expressions(model: Model, parameters: list[str], table: np.ndarray) -> None:
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
                raise ModelError(f"case {case}", f"{quantity.item} would be {row.min():.6g}", "mend or drop the case")


def vectors(model: Model, parameters: list[str], table: np.ndarray, own: np.ndarray | None = None) -> np.ndarray:
    """p (cases, n_p) of rows of samples, whose first columns are these parameters; own (n_p,): of the others."""
    index = {parameter.name: k for k, parameter in enumerate(model.parameters)}
    p = np.repeat((model.parameter_vector() if own is None else own)[None, :], len(table), axis=0)
    for k, name in enumerate(parameters):
        p[:, index[name]] = table[:, k]
    return p
