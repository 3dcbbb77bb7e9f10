"""A solution as an xarray Dataset with units and meanings, which xarray writes as NetCDF and Zarr."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

import numpy as np

from runtime.contract.arguments import arguments
from runtime.contract.coordinates import OMEGA, parameter_columns
from runtime.contract.model import EmittedModel
from runtime.results.export import column_units, columns
from runtime.results.friction import PARTS, rubbing, stopping
from runtime.results.samples import FORCE_PARTS, Samples

if TYPE_CHECKING:
    from xarray import Dataset

ORDERS = {"": "", "_dot": "rate of ", "_ddot": "acceleration of "}
KINDS = {"position": "position", "angle": "angle", "euler_parameter": "Euler parameter", "modal": "modal coordinate"}
ENERGIES = {
    "kinetic": "kinetic energy",
    "elastic": "elastic energy",
    "potential": "potential energy",
    "power_dissipated": "power that dampers take",
    "power_applied": "power of applied loads",
    "power_driven": "power of prescribed motions",
}


@arguments()
def to_xarray(solution: Samples) -> Dataset:
    """Make an xarray Dataset over `time` of all columns of a run.

    Parameters
    ----------
    solution : Solution
        A run, or what was kept of one.

    Returns
    -------
    xarray.Dataset
        The variables of `run.columns()` (coordinates, rates, accelerations, multipliers, forces, energies, measures,
        inputs among these), or the outputs if only those were kept; each (N,) over the coordinate `time` [s], with
        `units` and `long_name` as attributes. Attributes of the whole: model, title, scheme, dt, m, status,
        status_text, error (relative, NaN where it was not measured), error_text.

    Raises
    ------
    ImportError
        If xarray is not installed (extra `xarray`; `netcdf` and `zarr` for files).

    Notes
    -----
    `to_netcdf` and `to_zarr` of the Dataset keep all of it, `to_dataframe` makes a pandas DataFrame.
    """
    try:
        import xarray
    except ImportError as error:
        raise ImportError("xarray is not installed; install it with: pip install 'symgen[xarray]'") from error
    kept = dict(solution.outputs or columns(solution))
    labels = described(solution.model, kept)
    time = xarray.Variable("time", kept.pop("t"), labels["t"])
    series = {name: ("time", np.asarray(values), labels[name]) for name, values in kept.items()}
    return xarray.Dataset(series, coords={"time": time}, attrs=_attributes(solution))


def _attributes(solution: Samples) -> dict[str, str | float]:
    """Text and numbers, as every format of files takes them."""
    return {
        "model": solution.model.name,
        "title": solution.model.title,
        "scheme": solution.scheme,
        "dt": float(solution.dt),
        "m": ", ".join(map(str, solution.m)),
        "status": solution.status.name,
        "status_text": str(solution.status),
        "error": float(solution.error.largest),
        "error_text": str(solution.error),
    }


def described(model: EmittedModel, names: Iterable[str]) -> dict[str, dict[str, str]]:
    """{name: {"units": SI unit, "long_name": meaning}} of columns and outputs; without a unit where there is none."""
    units, meanings = column_units(model), long_names(model)
    return {
        name: ({"units": units[name]} if units.get(name) else {}) | {"long_name": meanings.get(name, name)}
        for name in names
    }


def long_names(model: EmittedModel) -> dict[str, str]:
    """What the columns of `column_units` mean, by the same names."""
    found = {"t": "time", "constraint_error": "largest |C|", "constraint_rate_error": "largest |C_q q_dot + C_t|"}
    described = model.description
    for one in described.coordinates:
        meaning = f"state {one.owner}, integrated" if one.kind == "state" else f"{KINDS[one.kind]} {one.name}"
        found |= {f"{one.name}{suffix}": f"{order}{meaning}" for suffix, order in ORDERS.items()}
    for body in parameter_columns(model):
        found |= {f"{body}.{axis}": f"angular velocity of {body} about its axis {axis[-1]}" for axis in OMEGA}
    for name in (name for body in described.bodies for name in body.angles):
        found |= {f"{name}{suffix}": f"{order}Euler angle {name}" for suffix, order in ORDERS.items()}
    found |= {f"lam.{row}": f"multiplier of constraint {row}" for row in model.constraints}
    owners = {joint: f"joint {joint} on its body b" for joint in model.joints}
    owners |= {f"load.{load.name}": f"load {load.name}" for load in described.loads}
    parts = {*FORCE_PARTS[3], *FORCE_PARTS[6]}
    found |= {f"{name}.{part}": f"{_part(part)} of {owner}" for name, owner in owners.items() for part in parts}
    for joint in rubbing(model):
        found |= {f"{joint}.friction_{part}": f"friction of joint {joint}: {part}" for part in PARTS}
    found |= {f"{joint}.stop_force": f"force of the stops of joint {joint}" for joint in stopping(model)}
    for prefix in ("", "energy."):
        found |= {f"{prefix}{name}": meaning for name, meaning in ENERGIES.items()}
    given = {one.name: one.meaning for one in described.inputs}
    drives = [one.name for one in described.joints if one.drawing == "drive"]
    found |= {f"{name}.motor": f"what the drive of joint {name} puts on its body b" for name in drives}
    given |= {one.name: one.about for one in described.measures if one.about}
    inputs = {one.name for one in described.inputs}
    for name in model.measures:
        kind = "input" if name in inputs else "measure"
        meaning = f"{kind} {name}: {given[name]}" if given.get(name) else f"{kind} {name}"
        found |= {name: meaning, f"measure.{name}": meaning}
    return found


def _part(part: str) -> str:
    """`force_x` in words."""
    kind, _, axis = part.partition("_")
    if not axis:
        return kind
    return f"{kind} along {axis} of the world" if kind == "force" else f"{kind} about {axis} of the world"
