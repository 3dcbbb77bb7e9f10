"""A study on the disk: its question, its samples, its model, and the parts that are finished, each with its hash.

    study.json      the question and the SHA-256 of the samples
    samples.bin     (cases, parameters and initial values), little-endian doubles
    model/          a copy of the generated folder
    part-00012.bin  SHA-256 of what follows, then rows (cases of the part, 2 + width): status, time reached [s], values

A part is written whole or not at all; one that is damaged counts as missing.
"""

from __future__ import annotations

import hashlib
import json
import shutil
from collections.abc import Mapping
from dataclasses import replace
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np

from runtime.contract.errors import ArgumentError
from runtime.contract.files import OutputError, replacing, write_text
from runtime.contract.model import Model
from runtime.results.export import column_units
from runtime.studies.ensemble.question import FORMAT, NAMES, Question

HEAD = 32


class StudyFolder:
    """A folder that a study is kept in. Raises OutputError if it cannot be written, ArgumentError if it is not ours."""

    def __init__(self, path: str | Path) -> None:
        self.path = Path(path)

    def begin(self, model: Model, question: Question, table: np.ndarray) -> Question:
        """Write what belongs to the study, or see that it is there. The question with the hash of its samples."""
        samples = np.ascontiguousarray(table, dtype="<f8").tobytes()
        asked = replace(question, samples=hashlib.sha256(samples).hexdigest())
        header = self.path / "study.json"
        if header.exists():
            if _question(header) != asked:
                raise ArgumentError(
                    f"folder {self.path}", "holds another study", "choose another folder, or ask what was asked there"
                )
            return asked
        if self.path.exists() and any(self.path.iterdir()):
            raise ArgumentError(f"folder {self.path}", "is not empty and holds no study", "choose another folder")
        self._copy_model(model)
        with replacing(self.path / "samples.bin") as temporary:
            temporary.write_bytes(samples)
        write_text(header, asked.as_text() + "\n")
        return asked

    def _copy_model(self, model: Model) -> None:
        if not model.folder:
            raise ArgumentError(
                f"model {model.name}", "was not loaded from a generated folder", "workers load it: use load_model"
            )
        try:
            shutil.copytree(model.folder, self.path / "model", ignore=shutil.ignore_patterns("__pycache__"))
        except (OSError, shutil.Error) as error:
            raise OutputError(f"{self.path} cannot take a copy of {model.folder}: {error}") from error

    def question(self, key: str) -> Question:
        """What is asked here. Raises ArgumentError if it is not the question with this hash."""
        found = _question(self.path / "study.json")
        if found.key != key:
            raise ArgumentError(f"folder {self.path}", "holds another study than was meant", "start the study again")
        return found

    def table(self, question: Question) -> np.ndarray:
        """The samples. Raises ArgumentError if they are damaged."""
        content = (self.path / "samples.bin").read_bytes()
        if hashlib.sha256(content).hexdigest() != question.samples:
            raise ArgumentError(f"{self.path / 'samples.bin'}", "is damaged", "start the study in another folder")
        return np.frombuffer(content, dtype="<f8").reshape(question.cases, -1).astype(float)

    def room(self, shape: tuple[int, int]) -> np.ndarray:
        """Room for all rows, in a file instead of memory."""
        try:
            return np.memmap(self.path / "values.bin", dtype="<f8", mode="w+", shape=shape)
        except OSError as error:
            raise OutputError(f"{self.path} has no room for the results ({error.strerror})") from error

    def _part(self, number: int) -> Path:
        return self.path / f"part-{number:05d}.bin"

    def write(self, number: int, rows: np.ndarray) -> None:
        """Keep a finished part."""
        content = np.ascontiguousarray(rows, dtype="<f8").tobytes()
        with replacing(self._part(number)) as temporary:
            temporary.write_bytes(hashlib.sha256(content).digest() + content)

    def read(self, number: int, cases: int) -> np.ndarray | None:
        """Rows of a part, None if it is not there or damaged."""
        try:
            content = self._part(number).read_bytes()
        except FileNotFoundError:
            return None
        if hashlib.sha256(content[HEAD:]).digest() != content[:HEAD]:
            return None
        return np.frombuffer(content[HEAD:], dtype="<f8").reshape(cases, -1)


def _question(header: Path) -> Question:
    try:
        plain = json.loads(header.read_text(encoding="utf-8"))
        if plain.pop("format") != FORMAT:
            raise KeyError("format")
        return Question(**plain)
    except (OSError, ValueError, KeyError, TypeError, AttributeError) as error:
        raise ArgumentError(f"{header}", f"is not the header of a study ({error})", "choose another folder") from error


# The answer of an ensemble as a file: NetCDF 3 through SciPy, which needs nothing else, or CSV.

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


# Answers by name: an xarray Dataset, or a dictionary of the same arrays where xarray is not installed.


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
