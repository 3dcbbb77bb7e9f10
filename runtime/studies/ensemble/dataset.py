"""Answers by name: an xarray Dataset, or a dictionary of the same arrays where xarray is not installed."""

from __future__ import annotations

from importlib.util import find_spec
from typing import Any

import numpy as np

from runtime.contract.model import Model
from runtime.results.export import column_units
from runtime.studies.ensemble.question import Question
from runtime.studies.ensemble.rows import NAMES


def dataset(model: Model, question: Question, table: np.ndarray, rows: np.ndarray) -> Any:
    """Of rows (cases, 2 + width): status(case), time_reached(case), what was varied, and the outputs."""
    arrays = columns(model, question, table, rows)
    if find_spec("xarray") is None:
        return {name: values for name, (_, values, _) in arrays.items()}
    import xarray

    varied = [*question.parameters, *(f"initial.{name}" for name in question.initial)]
    coordinates = {name: arrays.pop(name) for name in ("case", "time", *varied) if name in arrays}
    attributes = {"model": model.name, "title": model.title, "scheme": question.scheme, "dt": question.dt}
    return xarray.Dataset(arrays, coords=coordinates, attrs=attributes)


def columns(
    model: Model, question: Question, table: np.ndarray, rows: np.ndarray
) -> dict[str, tuple[tuple[str, ...], np.ndarray, dict[str, str]]]:
    """{name: (dimensions, values, {"units": unit})}."""
    units = column_units(model)
    found: dict[str, Any] = {"case": (("case",), np.arange(question.cases), {})}
    names = {parameter.name: parameter.unit for parameter in model.parameters}
    for k, name in enumerate(question.parameters):
        found[name] = (("case",), table[:, k], _unit(names[name]))
    for k, name in enumerate(question.initial, len(question.parameters)):
        found[f"initial.{name}"] = (("case",), table[:, k], _unit(units.get(name, "")))
    found["status"] = (("case",), np.array(NAMES)[rows[:, 0].astype(int)], {})
    found["time_reached"] = (("case",), rows[:, 1], _unit("s"))
    values = rows[:, 2:]
    if question.reduced:
        for k, (output, reduction) in enumerate(question.reduced):
            found[f"{output}_{reduction}"] = (("case",), values[:, k], _unit(units.get(output, "")))
        return found
    marks = np.array(question.marks(question.plan(model).steps))
    found["time"] = (("time",), question.t0 + marks * question.dt, _unit("s"))
    for k, output in enumerate(question.outputs):
        part = values[:, k * len(marks) : (k + 1) * len(marks)]
        found[output] = (("case", "time"), part, _unit(units.get(output, "")))
    return found


def _unit(unit: str) -> dict[str, str]:
    return {"units": unit} if unit else {}
