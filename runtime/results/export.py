"""A Solution as files and columns: .npz without pickle, CSV, MATLAB, Parquet."""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Mapping
from dataclasses import asdict
from pathlib import Path
from typing import Any

import numpy as np

from runtime.contract.arguments import arguments
from runtime.contract.coordinates import OMEGA, angular_velocities, euler_angles, parameter_columns
from runtime.contract.errors import ModelError
from runtime.contract.escapes import csv_row, words
from runtime.contract.files import OutputError, replacing
from runtime.contract.model import EmittedModel
from runtime.contract.orientations import angle_motion, angle_names
from runtime.contract.records import JointRecord, as_plain, description
from runtime.contract.status import Event, Status
from runtime.results.friction import friction_columns, friction_units
from runtime.results.samples import FORCE_PARTS, Samples
from runtime.results.stream import read_blocks, read_header

FORMAT = "symgen solution 6"
ARRAYS = (
    "parameters",
    "t",
    "q_i",
    "q",
    "q_dot",
    "q_ddot",
    "lam",
    "constraint_error",
    "constraint_rate_error",
    "measures",
    "joint_forces",
    "load_forces",
    "frictions",
)
MAT_CELLS = ("variables", "names", "units")
LONGEST_VARIABLE = 58  # of the 63 characters that MATLAB reads, the rest tells names apart
POWERS = ("power_dissipated", "power_applied", "power_driven")


@arguments()
def write_npz(solution: Samples, path: str | Path) -> None:
    """Save everything in one .npz file of plain arrays (no pickle).

    Parameters
    ----------
    solution : Solution
        N samples.
    path : str or Path
        The file; `Solution.load` reads it.

    Raises
    ------
    OutputError
        For a place that cannot be written.
    """
    header = {
        "format": FORMAT,
        **run_header(solution),
        "energy": list(solution.energy),
        "outputs": list(solution.outputs),
    }
    arrays = {key: np.asarray(getattr(solution, key), dtype=float) for key in ARRAYS}
    arrays |= {f"energy_{key}": np.asarray(series, dtype=float) for key, series in solution.energy.items()}
    arrays |= {f"output_{key}": np.asarray(series, dtype=float) for key, series in solution.outputs.items()}
    with replacing(Path(path)) as temporary, open(temporary, "wb") as stream:
        np.savez_compressed(stream, allow_pickle=False, header=np.array(json.dumps(header)), **arrays)


def read_npz(path: str | Path, model: EmittedModel | None) -> dict[str, Any]:
    """The fields of a Solution.

    Raises OutputError if the file is none or damaged, ModelError if it is of another format or model.
    """
    try:
        with open(path, "rb") as stream, np.load(stream, allow_pickle=False) as data:  # of a path it leaves some open
            header = json.loads(str(data["header"]))
            if header["format"] != FORMAT:
                raise ModelError(f"{path} is a saved solution in another format; simulate again")
            fields: dict[str, Any] = {key: data[key] for key in ARRAYS}
            fields["energy"] = {key: data[f"energy_{key}"] for key in header["energy"]}
            fields["outputs"] = {key: data[f"output_{key}"] for key in header["outputs"]}
        fields |= read_run_header(header, path, model)
    except ModelError:
        raise
    except Exception as error:  # whatever the bytes of a damaged archive lead its readers to
        reason = getattr(error, "strerror", None) or error
        raise OutputError(f"{path} is not a saved solution, or damaged ({reason})") from error
    return fields


def read_stream(path: str | Path, model: EmittedModel | None) -> dict[str, Any]:
    """The fields of a Solution from a stream of whole samples. Raises ModelError."""
    header = read_header(path)
    if header.get("outputs"):
        raise ModelError(f"{path} holds chosen outputs only; read them with runtime.results.stream.read_blocks")
    blocks = list(read_blocks(path))
    if not blocks:
        raise ModelError(f"{path} holds no samples; simulate again")
    columns = {name: np.concatenate([block[name] for block in blocks]) for name in blocks[0]}
    try:
        fields: dict[str, Any] = {key: columns[key] for key in ARRAYS if key != "parameters"}
        fields["energy"] = {
            key.removeprefix("energy_"): values for key, values in columns.items() if key.startswith("energy_")
        }
        fields["parameters"] = np.array(header["parameters"], dtype=float)
        return {**fields, **read_run_header(header, path, model)}
    except (KeyError, TypeError, ValueError, AttributeError) as error:
        if isinstance(error, ModelError):
            raise
        raise ModelError(f"{path} is a stream whose header is damaged ({error}); simulate again") from error


def run_header(solution: Samples) -> dict[str, Any]:
    """What can be said in JSON of the model, the scheme and how the run ended."""
    model = solution.model
    return {
        "model": {
            "description": as_plain(model.description),
            "initial_q": model.initial_q.tolist(),
            "initial_q_dot": model.initial_q_dot.tolist(),
        },
        "scheme": solution.scheme,
        "dt": float(solution.dt),
        "m": [int(ratio) for ratio in solution.m],
        "stats": {key: _plain(value) for key, value in solution.stats.items()},
        "status": asdict(solution.status),
        "events": [asdict(event) for event in solution.events],
        "stops": solution.stops.tolist(),
        "powers": [[None if np.isnan(one) else float(one) for one in row] for row in solution.powers],
    }


def read_run_header(header: dict[str, Any], path: str | Path, model: EmittedModel | None) -> dict[str, Any]:
    """Fields of a Solution from `run_header`'s dictionary. Raises ModelError if it belongs to another model."""
    recorded = _recorded_model(header["model"])
    for key in ("coordinates", "q_i", "constraints", "measures"):
        if model is not None and getattr(model, key) != getattr(recorded, key):
            raise ModelError(f"{path} belongs to model {recorded.name}, whose {key} differ from those of {model.name}")
    return {
        **{key: header[key] for key in ("scheme", "dt", "m", "stats")},
        "status": Status(**header["status"]),
        "events": [Event(**event) for event in header["events"]],
        "stops": np.array(header["stops"], dtype=float).reshape(-1, 2),
        "powers": np.array(header.get("powers", []), dtype=float).reshape(-1, 4),
        "model": model or recorded,
    }


def _recorded_model(header: dict[str, Any]) -> EmittedModel:
    """A model with names but without functions."""
    return EmittedModel(
        description=description(header["description"]),
        initial_q=np.array(header["initial_q"], dtype=float),
        initial_q_dot=np.array(header["initial_q_dot"], dtype=float),
        builders={},
    )


def _plain(value: Any) -> Any:
    return value.item() if isinstance(value, np.generic) else value


def read_angles(
    model: EmittedModel, q: np.ndarray, q_dot: np.ndarray, q_ddot: np.ndarray, body: str
) -> dict[str, np.ndarray]:
    """(N,) angles [rad] by name, from -pi to pi and the middle one in half of it, with their `_dot` and `_ddot`."""
    e = parameter_columns(model)[body]
    moved = angle_motion(euler_angles(model)[body], q[:, e], q_dot[:, e], q_ddot[:, e])
    return {
        f"{name}{suffix}": values[:, k]
        for suffix, values in zip(("", "_dot", "_ddot"), moved, strict=True)
        for k, name in enumerate(angle_names(body))
    }


def columns(solution: Samples) -> dict[str, np.ndarray]:
    """Collect all columns by name, as `pandas.DataFrame` takes them.

    Parameters
    ----------
    solution : Solution
        N samples.

    Returns
    -------
    dict of str to np.ndarray, shape (N,)
        t, coordinates, rates `_dot`, accelerations `_ddot`, `lam.row`, joint forces, loads, energies and
        measures, in SI units.
    """
    model = solution.model
    found = {"t": solution.t}
    for suffix, values in (("", solution.q), ("_dot", solution.q_dot), ("_ddot", solution.q_ddot)):
        found |= {f"{name}{suffix}": values[:, k] for k, name in enumerate(model.coordinates)}
    found |= angular_velocities(model, solution.q, solution.q_dot)
    for body in euler_angles(model):
        found |= read_angles(model, solution.q, solution.q_dot, solution.q_ddot, body)
    found |= {f"lam.{row}": solution.lam[:, k] for k, row in enumerate(model.constraints)}
    found |= {
        f"{joint}.{part}": solution.joint_forces[:, k, axis]
        for k, joint in enumerate(model.joints)
        for axis, part in enumerate(FORCE_PARTS[solution.joint_forces.shape[2]])
    }
    found |= {
        f"load.{load.name}.{part}": solution.load_forces[:, k, axis]
        for k, load in enumerate(model.description.loads)
        for axis, part in enumerate(FORCE_PARTS[solution.load_forces.shape[2]])
    }
    found |= {f"{joint.name}.motor": solution.motor(joint.name) for joint in _driven(model)}
    found |= friction_columns(solution)
    found |= {f"energy.{key}": series for key, series in solution.energy.items()}
    found["constraint_error"] = solution.constraint_error
    found["constraint_rate_error"] = solution.constraint_rate_error
    return found | {f"measure.{name}": solution.measures[:, k] for k, name in enumerate(model.measures)}


def _driven(model: EmittedModel) -> list[JointRecord]:
    """The joints that prescribe a motion."""
    return [joint for joint in model.description.joints if joint.drawing == "drive"]


def column_units(model: EmittedModel) -> dict[str, str]:
    """SI units of these columns, and of energies and measures by their own names."""
    described = model.description
    units = {"t": "s", "constraint_error": "m or rad", "constraint_rate_error": "m/s or rad/s"}
    for order, suffix in enumerate(("", "_dot", "_ddot")):
        units |= {f"{entry.name}{suffix}": entry.unit_of(order) for entry in described.coordinates}
    units |= {f"{body}.{axis}": "rad/s" for body in parameter_columns(model) for axis in OMEGA}
    for name in (name for body in described.bodies for name in body.angles):
        units |= {name: "rad", f"{name}_dot": "rad/s", f"{name}_ddot": "rad/s^2"}
    units |= {f"lam.{row.label}": "N" if row.unit == "m" else "N m" for row in described.constraints}
    for name in (*model.joints, *(f"load.{load.name}" for load in model.description.loads)):
        units |= {f"{name}.{part}": "N" if part.startswith("force") else "N m" for part in FORCE_PARTS[6]}
        units[f"{name}.moment"] = "N m"
    turning = {row.joint: row.unit != "m" for row in reversed(described.constraints)}
    units |= {f"{joint.name}.motor": "N m" if turning[joint.name] else "N" for joint in _driven(model)}
    units |= friction_units(model)
    energies = {key: "W" if key in POWERS else "J" for key in ("kinetic", "elastic", "potential", *POWERS)}
    for prefix in ("", "energy."):
        units |= {f"{prefix}{key}": unit for key, unit in energies.items()}
    for prefix in ("", "measure."):
        units |= {f"{prefix}{entry.name}": entry.unit for entry in described.measures}
    return units


@arguments()
def export(solution: Samples, path: str | Path) -> None:
    """Write a row for each sample, with names and units.

    Parameters
    ----------
    solution : Solution
        N samples.
    path : str or Path
        A name that ends in .csv, .mat (MATLAB) or .parquet.

    Raises
    ------
    ModelError
        For another ending.
    OutputError
        For a place that cannot be written.

    Notes
    -----
    Of the outputs alone if only those were kept.
    """
    suffix = Path(path).suffix.lower()
    if suffix not in WRITERS:
        raise ModelError(f"{path} ends in no known format: choose a name that ends in {', '.join(WRITERS)}")
    WRITERS[suffix](solution, path)


def _columns(solution: Samples) -> tuple[dict[str, np.ndarray], list[str]]:
    """The columns, or the outputs if only those were kept, and their units."""
    kept, units = solution.outputs or columns(solution), column_units(solution.model)
    return dict(kept), [units.get(name, "") for name in kept]


def to_csv(solution: Samples, path: str | Path) -> None:
    """Comma-separated values that read back exactly (17 digits), `name [unit]` above each. Raises OutputError."""
    columns, units = _columns(solution)
    with replacing(path) as temporary:
        np.savetxt(
            temporary,
            np.column_stack(list(columns.values())),
            fmt="%.17g",
            delimiter=",",
            header=csv_row(f"{name} [{unit}]" if unit else name for name, unit in zip(columns, units, strict=True)),
            comments="",
            encoding="utf-8",
        )


def to_mat(solution: Samples, path: str | Path) -> None:
    """A MATLAB file: a variable a column, named with _ for other signs; cells `variables`, `names`, `units`."""
    from scipy.io import savemat

    columns, units = _columns(solution)
    variables = dict(zip(words(columns, LONGEST_VARIABLE, MAT_CELLS), columns, strict=True))
    cells = (list(variables), list(variables.values()), units)
    content: dict[str, Any] = {key: np.array(cell, dtype=object) for key, cell in zip(MAT_CELLS, cells, strict=True)}
    content |= {own: columns[name] for own, name in variables.items()}
    with replacing(path) as temporary:
        savemat(temporary, content, do_compression=True, oned_as="column", long_field_names=True)


def to_parquet(solution: Samples, path: str | Path) -> None:
    """A Parquet file, the unit of each column in its metadata. Raises ImportError naming the extra, or OutputError."""
    try:
        import pyarrow
        from pyarrow import parquet
    except ImportError as error:
        raise ImportError("pyarrow is not installed; install it with: pip install 'symgen[parquet]'") from error
    columns, units = _columns(solution)
    fields = [
        pyarrow.field(name, pyarrow.float64(), nullable=False, metadata={"unit": unit})
        for name, unit in zip(columns, units, strict=True)
    ]
    about = {"model": solution.model.name, "scheme": solution.scheme, "status": str(solution.status)}
    arrays = [pyarrow.array(np.asarray(values, dtype=float)) for values in columns.values()]
    with replacing(path) as temporary:
        parquet.write_table(pyarrow.Table.from_arrays(arrays, schema=pyarrow.schema(fields, metadata=about)), temporary)


WRITERS: dict[str, Callable[[Samples, str | Path], None]] = {
    ".csv": to_csv,
    ".mat": to_mat,
    ".parquet": to_parquet,
}


# ---- Results as strict JSON: no NaN, no infinity.


def as_json(report: Mapping[str, Any]) -> str:
    """Indented JSON text; NaN and infinity become null, which every JSON reader accepts."""
    return json.dumps(finite(report), indent=2, ensure_ascii=False, allow_nan=False) + "\n"


def finite(value: Any) -> Any:
    """The same values with null for numbers that are not finite."""
    if isinstance(value, float) and not math.isfinite(value):
        return None
    if isinstance(value, Mapping):
        return {str(key): finite(part) for key, part in value.items()}
    if isinstance(value, list | tuple):
        return [finite(part) for part in value]
    return value
