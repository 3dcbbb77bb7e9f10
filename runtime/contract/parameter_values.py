"""Values of parameters and inputs given by name, checked."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import casadi as ca
import numpy as np

from runtime.contract.errors import ModelError
from runtime.contract.records import Bound, BoundedQuantity, InputRecord, Parameter
from runtime.contract.signals import traced

WORDS = {"positive": "positive", "not negative": "at least zero"}


def changed_vector(model: str, parameters: Sequence[Parameter], changes: Mapping[str, float]) -> np.ndarray:
    """(n_p,) defaults of the parameters, some changed by name. Raises ModelError for a name or value that cannot be."""
    p = np.array([parameter.default for parameter in parameters])
    index = {parameter.name: k for k, parameter in enumerate(parameters)}
    for name, value in changes.items():
        if name not in index:
            known = ", ".join(q.name for q in parameters if q.kind != "data")
            zero = (
                "; a number that is zero in the scene is left out of the code: to keep it, declare it in "
                "[parameters] with default 0 and write its name there"
                if "." in name
                else ""
            )
            raise ModelError(f"model {model} has no parameter {name!r}; it has {known}{zero}")
        p[index[name]] = checked_value(parameters[index[name]], value)
    return p


def require_bounds(quantities: Sequence[BoundedQuantity], values: np.ndarray) -> None:
    """Raises ModelError if an expression of the scene has lost the sign that its use asks for; values (k,)."""
    for quantity, value in zip(quantities, values, strict=True):
        if not _within(quantity.bound, value):
            raise ModelError(
                f"{quantity.item} = {quantity.expression!r} would be {value:.6g} but must be "
                f"{WORDS[quantity.bound]}: choose other values of its parameters"
            )


def checked_value(parameter: Parameter, value: float) -> float:
    """The value as a float. Raises ModelError if it is not finite or has the wrong sign."""
    what = "input" if parameter.kind == "input" else "parameter"
    if isinstance(value, bool) or not isinstance(value, int | float | np.number) or not np.isfinite(value):
        raise ModelError(f"{what} {parameter.name!r} must be a finite number, not {value!r}")
    if not _within(parameter.bound, float(value)):
        raise ModelError(f"{what} {parameter.name!r} must be {WORDS[parameter.bound]}, not {value}")
    return float(value)


def checked_inputs(
    model: str,
    inputs: Sequence[InputRecord],
    held: Sequence[Parameter],
    values: Mapping[str, float | Callable[..., Any]],
) -> tuple[dict[str, float], dict[str, ca.Function]]:
    """(numbers, functions of time) by name. Raises ModelError or ArgumentError for what cannot be an input."""
    numbers: dict[str, float] = {}
    functions: dict[str, ca.Function] = {}
    records, slots = {entry.name: entry for entry in inputs}, {parameter.name: parameter for parameter in held}
    for name, value in values.items():
        if name not in slots or (callable(value) and name not in records):
            raise ModelError(f"model {model} has no input {name!r}; it has {', '.join(records) or 'none'}")
        if not callable(value):
            numbers[name] = checked_value(slots[name], value)
        elif records[name].filter:
            raise ModelError(
                f"input {name!r} has a filter, which takes constants and held values: declare it with rates = true, "
                "the rate and acceleration of a function are exact"
            )
        else:
            functions[name] = traced(value, name)
    return numbers, functions


def _within(bound: Bound, value: float) -> bool:
    """Has a value the sign that a bound asks for?"""
    return bool({"any": True, "positive": value > 0, "not negative": value >= 0}[bound])
