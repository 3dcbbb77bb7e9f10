"""The answer of an ensemble as a file: NetCDF 3 through SciPy, which needs nothing else, or CSV."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from runtime.contract.errors import ArgumentError
from runtime.contract.files import replacing

SUFFIXES = (".nc", ".csv")
Variable = tuple[tuple[str, ...], np.ndarray, str]


def write_answer(answer: Any, path: str | Path) -> None:
    """Write a Dataset, or the dictionary that stands for one, by the suffix of the path: .nc or .csv.

    CSV has a row a case, with samples a row a case and time. Raises ArgumentError or OutputError.
    """
    check_suffix(path)
    found = variables(answer)
    with replacing(path) as temporary:
        if Path(path).suffix == ".nc":
            _write_netcdf(found, temporary)
        else:
            _write_csv(found, temporary)


def check_suffix(path: str | Path) -> None:
    """Raises ArgumentError for a suffix that says nothing."""
    if Path(path).suffix not in SUFFIXES:
        raise ArgumentError(str(path), f"has none of the endings {', '.join(SUFFIXES)}", "name it study.nc")


def variables(answer: Any) -> dict[str, Variable]:
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


def _write_netcdf(found: Mapping[str, Variable], path: Path) -> None:
    from scipy.io import netcdf_file

    with netcdf_file(path, "w", version=2) as file:
        for name in ("case", "time"):
            if name in found:
                file.createDimension(name, len(found[name][1]))
        for name, (dimensions, values, unit) in found.items():
            if values.dtype.kind == "U":
                letters = np.char.encode(values, "utf-8").astype("S")
                width = letters.dtype.itemsize
                file.createDimension(f"{name}_letters", width)
                variable = file.createVariable(name, "c", (*dimensions, f"{name}_letters"))
                variable[:] = letters.view("S1").reshape(len(values), width)
                variable._Encoding = "utf-8"
                continue
            kind = "i" if values.dtype.kind == "i" else "d"
            variable = file.createVariable(name, kind, dimensions)
            variable[:] = values
            if unit:
                variable.units = unit


def _write_csv(found: Mapping[str, Variable], path: Path) -> None:
    samples = {name for name, (dimensions, _, _) in found.items() if len(dimensions) == 2}
    times = len(found["time"][1]) if samples else 1
    cases = len(found["case"][1])
    columns: dict[str, list[str]] = {}
    for name, (dimensions, values, unit) in found.items():
        full = np.tile(values, cases) if dimensions == ("time",) else values
        full = np.repeat(full, times) if dimensions == ("case",) else full.ravel()
        head = f"{name} [{unit}]" if unit else name
        columns[head] = [str(one) if full.dtype.kind in "Ui" else f"{one:.17g}" for one in full.tolist()]
    lines = [",".join(columns), *(",".join(row) for row in zip(*columns.values(), strict=True))]
    path.write_text("\n".join(lines) + "\n", encoding="utf-8", newline="\n")
