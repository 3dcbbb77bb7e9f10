"""The answer of an ensemble: an xarray Dataset, without xarray a dictionary of the same arrays."""

from __future__ import annotations

from collections.abc import Mapping
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np

from runtime.contract.escapes import csv_row
from runtime.contract.files import write_text
from runtime.results.dataset import described
from runtime.studies.ensemble.lane_runs import LaneResults
from runtime.studies.ensemble.question import Question


def dataset(question: Question, table: np.ndarray, results: LaneResults) -> Any:
    """Of all cases: status(case), time_reached(case), what was varied, and the outputs."""
    arrays, model, plan = columns(question, table, results), question.model, question.plan
    asked = question.refinement
    if find_spec("xarray") is None:
        return {name: values for name, (_, values, _) in arrays.items()}
    import xarray

    varied = [*question.parameters, *(f"initial.{name}" for name in question.initial)]
    coordinates = {name: arrays.pop(name) for name in ("case", "time", *varied) if name in arrays}
    attributes: dict[str, Any] = {"model": model.name, "title": model.title, "scheme": plan.name}
    attributes |= {"dt": plan.grid.dt_L} if asked is None else {"tolerance": asked.tolerance}
    return xarray.Dataset(arrays, coords=coordinates, attrs=attributes)


def columns(
    question: Question, table: np.ndarray, results: LaneResults
) -> dict[str, tuple[tuple[str, ...], np.ndarray, dict[str, str]]]:
    """{name: (dimensions, values, {"units": unit, "long_name": meaning})}."""
    model, values = question.model, results.values
    told = described(model, [*question.initial, *question.asked])
    found: dict[str, Any] = {"case": (("case",), np.arange(len(table)), {"long_name": "case"})}

    def keep(name: str, dimensions: tuple[str, ...], column: np.ndarray, meaning: str, unit: str = "") -> None:
        found[name] = (dimensions, column, ({"units": unit} if unit else {}) | {"long_name": meaning})

    def keep_output(name: str, dimensions: tuple[str, ...], column: np.ndarray, of: str, how: str = "") -> None:
        keep(name, dimensions, column, how + told[of]["long_name"], told[of].get("units", ""))

    parameters = {one.name: one for one in model.parameters}
    for name, column in zip([*question.parameters, *question.initial], table.T, strict=True):
        if name in question.parameters:
            keep(name, ("case",), column, parameters[name].meaning or name, parameters[name].unit)
        else:
            keep_output(f"initial.{name}", ("case",), column, name, "initial ")
    keep("status", ("case",), results.status, "how the run ended")
    keep("time_reached", ("case",), results.time, "time at which it ended", "s")
    for k, (output, reduction) in enumerate(question.reduced):
        keep_output(f"{output}_{reduction}", ("case",), values[:, k], output, f"{reduction} of ")
    if not question.reduced:
        marks = np.array(question.sampled)
        keep("time", ("time",), question.plan.times(marks), "time", "s")
        for output, part in zip(question.asked, np.split(values, len(question.asked), axis=1), strict=True):
            keep_output(output, ("case", "time"), part, output)
    if question.refinement is not None:
        keep("error", ("case",), results.errors[:, 0], "estimated RMS error of the motion over its amplitudes", "1")
        keep("steps", ("case",), results.steps, "steps of the run that answers")
        keep("steps_of_all_levels", ("case",), results.steps_of_all_levels, "steps of all levels of the case")
        values_of = question.reduced or [(name, "") for name in question.asked]
        for (output, reduction), column in zip(values_of, results.errors.T[1:], strict=True):
            name, how = (f"{output}_{reduction}", f"{reduction} of ") if reduction else (output, "")
            keep_output(f"error.{name}", ("case",), column, output, f"estimated error of {how}")
    return found


# As a table: a row a case, with samples a row a case and time.


def write_csv(answer: Any, path: str | Path) -> None:
    """Write a Dataset, or the dictionary that stands for one. Raises OutputError."""
    found = variables(answer)
    times = len(found["time"][1]) if "time" in found else 1
    cases = len(found["case"][1])
    columns: dict[str, list[str]] = {}
    for name, (dimensions, values, unit) in found.items():
        full = np.tile(values, cases) if dimensions == ("time",) else values
        full = np.repeat(full, times) if dimensions == ("case",) else full.ravel()
        head = f"{name} [{unit}]" if unit else name
        columns[head] = [str(one) if full.dtype.kind in "Ui" else f"{one:.17g}" for one in full.tolist()]
    lines = [csv_row(columns), *(",".join(row) for row in zip(*columns.values(), strict=True))]
    write_text(path, "\n".join(lines) + "\n")


def variables(answer: Any) -> dict[str, tuple[tuple[str, ...], np.ndarray, str]]:
    """{name: (dimensions, values, unit)}."""
    if isinstance(answer, Mapping) and not hasattr(answer, "variables"):
        shapes = {2: ("case", "time")}
        return {
            name: (shapes.get(values.ndim, ("time",) if name == "time" else ("case",)), values, "")
            for name, values in answer.items()
        }
    return {
        str(name): (tuple(map(str, answer[name].dims)), answer[name].values, str(answer[name].attrs.get("units", "")))
        for name in (*answer.coords, *answer.data_vars)
    }
