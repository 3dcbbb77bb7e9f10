"""The result of an ensemble: an xarray Dataset, without xarray a dictionary of the same arrays."""

from __future__ import annotations

from collections.abc import Mapping
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np

from runtime.contract.escapes import csv_row
from runtime.contract.files import write_text
from runtime.results.dataset import described
from runtime.studies.ensemble.ensemble_spec import EnsembleSpec
from runtime.studies.ensemble.lane_runs import LaneResults


def ensemble_result(spec: EnsembleSpec, table: np.ndarray, results: LaneResults, first: int = 0) -> Any:
    """Of the cases from `first` on: status(case), time_reached(case), what was varied, and the outputs."""
    arrays, model, plan = columns(spec, table, results, first), spec.model, spec.plan
    asked = spec.refinement
    if find_spec("xarray") is None:
        return {name: values for name, (_, values, _) in arrays.items()}
    import xarray

    varied = [*spec.parameters, *(f"initial.{name}" for name in spec.initial)]
    coordinates = {name: arrays.pop(name) for name in ("case", "time", *varied) if name in arrays}
    attributes: dict[str, Any] = {"model": model.name, "title": model.title, "scheme": plan.name}
    attributes |= {"dt": plan.grid.dt_L} if asked is None else {"tolerance": asked.tolerance}
    return xarray.Dataset(arrays, coords=coordinates, attrs=attributes)


def columns(
    spec: EnsembleSpec, table: np.ndarray, results: LaneResults, first: int = 0
) -> dict[str, tuple[tuple[str, ...], np.ndarray, dict[str, str]]]:
    """{name: (dimensions, values, {"units": unit, "long_name": meaning})}."""
    model, values = spec.model, results.values
    labels = described(model, [*spec.initial, *spec.asked])
    found: dict[str, Any] = {"case": (("case",), np.arange(first, first + len(table)), {"long_name": "case"})}

    def keep(name: str, dimensions: tuple[str, ...], column: np.ndarray, meaning: str, unit: str = "") -> None:
        found[name] = (dimensions, column, ({"units": unit} if unit else {}) | {"long_name": meaning})

    def keep_output(name: str, dimensions: tuple[str, ...], column: np.ndarray, of: str, how: str = "") -> None:
        keep(name, dimensions, column, how + labels[of]["long_name"], labels[of].get("units", ""))

    parameters = {one.name: one for one in model.parameters}
    for name, column in zip([*spec.parameters, *spec.initial], table.T, strict=True):
        if name in spec.parameters:
            keep(name, ("case",), column, parameters[name].meaning or name, parameters[name].unit)
        else:
            keep_output(f"initial.{name}", ("case",), column, name, "initial ")
    keep("status", ("case",), results.status, "how the run ended")
    keep("time_reached", ("case",), results.time, "time at which it ended", "s")
    for k, (output, reduction) in enumerate(spec.reduced):
        keep_output(f"{output}_{reduction}", ("case",), values[:, k], output, f"{reduction} of ")
    if not spec.reduced:
        marks = np.array(spec.sampled)
        keep("time", ("time",), spec.plan.times(marks), "time", "s")
        for output, part in zip(spec.asked, np.split(values, len(spec.asked), axis=1), strict=True):
            keep_output(output, ("case", "time"), part, output)
    if spec.refinement is not None:
        keep("error", ("case",), results.errors[:, 0], "estimated RMS error of the motion over its amplitudes", "1")
        keep("steps", ("case",), results.steps, "steps of the run that answers")
        keep("steps_of_all_levels", ("case",), results.steps_of_all_levels, "steps of all levels of the case")
        values_of = spec.reduced or [(name, "") for name in spec.asked]
        for (output, reduction), column in zip(values_of, results.errors.T[1:], strict=True):
            name, how = (f"{output}_{reduction}", f"{reduction} of ") if reduction else (output, "")
            keep_output(f"error.{name}", ("case",), column, output, f"estimated error of {how}")
    return found


# As a table: a row a case, with samples a row a case and time.


def write_csv(result: Any, path: str | Path) -> None:
    """Write a Dataset, or the dictionary that stands for one. Raises OutputError."""
    found = variables(result)
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


def variables(result: Any) -> dict[str, tuple[tuple[str, ...], np.ndarray, str]]:
    """{name: (dimensions, values, unit)}."""
    if isinstance(result, Mapping) and not hasattr(result, "variables"):
        shapes = {2: ("case", "time")}
        return {
            name: (shapes.get(values.ndim, ("time",) if name == "time" else ("case",)), values, "")
            for name, values in result.items()
        }
    return {
        str(name): (tuple(map(str, result[name].dims)), result[name].values, str(result[name].attrs.get("units", "")))
        for name in (*result.coords, *result.data_vars)
    }
