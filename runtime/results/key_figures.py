"""Key figures of a run: peaks with time and place, of its outputs, drives, reactions, deflections and stresses.

They are those of the saved samples. Deflections, section forces and stresses are by equilibrium where that is known.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import nan

import numpy as np

from runtime.contract.errors import ModelError
from runtime.results.deflections import deflections
from runtime.results.samples import Samples
from runtime.results.section_forces import Which, section_forces
from runtime.results.stresses import beam_stresses, stresses

ROUNDING = 1e-12  # of the largest value of a quantity, or of a vector's size: what is below is written as zero
STILL = 1e-9  # of the largest force of its kind: what stays below is none


@dataclass(frozen=True)
class Peak:
    """The largest magnitude of a quantity over a run.

    value: with its sign, in the SI unit; t [s]; place: where on the body; low, high, end: range and last value of a
    quantity that has one value at a time, else NaN.
    """

    quantity: str
    unit: str
    value: float
    t: float
    place: str = ""
    low: float = nan
    high: float = nan
    end: float = nan


@dataclass(frozen=True)
class Reaction:
    """The largest force and moment of a joint or load: force [N] at t_force [s] with its components in the world,
    moment [N m] at t_moment [s].
    """

    name: str
    force: float
    t_force: float
    components: tuple[float, ...]
    moment: float
    t_moment: float


def peak(quantity: str, unit: str, t: np.ndarray, values: np.ndarray) -> Peak:
    """Of values (N,) at t (N,) [s]; NaN count as nothing, all NaN give NaN."""
    if not np.isfinite(values).any():
        return Peak(quantity, unit, nan, nan)
    k = int(np.nanargmax(np.abs(values)))
    low, high, end = (_rounded(x, abs(values[k])) for x in (np.nanmin(values), np.nanmax(values), values[-1]))
    return Peak(quantity, unit, float(values[k]), float(t[k]), "", low, high, end)


def _rounded(value: float, size: float) -> float:
    """Zero for what is rounding beside a size."""
    return 0.0 if abs(value) <= ROUNDING * size else float(value)


def kept_peaks(run: Samples) -> list[Peak]:
    """Of what a run with `outputs` kept."""
    t = run.outputs["t"]
    return [peak(name, _unit(run, name), t, values) for name, values in run.outputs.items() if name != "t"]


def motion_peaks(run: Samples, names: Sequence[str]) -> list[Peak]:
    """Of measures and coordinates by name, and of the rates of those that are independent."""
    turns = [one.name for one in run.model.description.coordinates if one.kind == "euler_parameter"]
    rates = [f"{name}_dot" for name in run.model.q_i if name in names and name not in turns]
    return [peak(name, _unit(run, name), run.t, run[name]) for name in (*names, *rates)]


def _unit(run: Samples, name: str) -> str:
    units = {one.name: one.unit for one in run.model.description.measures}
    for one in run.model.description.coordinates:
        units |= {f"{one.name}{rate}": one.unit_of(k) for k, rate in enumerate(("", "_dot", "_ddot"))}
    units |= dict.fromkeys(("kinetic", "elastic", "potential"), "J")
    units |= dict.fromkeys(("power_dissipated", "power_applied"), "W")
    return units.get(name, "")


def drive_peaks(run: Samples) -> list[Peak]:
    """Torque or force of each prescribed motion, and the power that all of them take."""
    described = run.model.description
    drives = {joint.name for joint in described.joints if joint.drawing == "drive"}
    kinds = {row.joint: row.kind for row in described.constraints if row.joint in drives}
    found = [
        peak(*((f"torque of {name}", "N m") if kind == "angle" else (f"force of {name}", "N")), run.t, run.motor(name))
        for name, kind in kinds.items()
    ]
    return [*found, peak("power of the drives", "W", run.t, run.energy["power_driven"])] if found else []


def joint_peaks(run: Samples) -> list[Reaction]:
    """Of every joint that carries anything: on its body b, at marker b."""
    return _reactions(run, list(run.model.joints), run.joint_forces)


def load_peaks(run: Samples) -> list[Reaction]:
    """Of every load that does anything: on its marker, or its marker b."""
    return _reactions(run, [one.name for one in run.model.description.loads], run.load_forces)


def _reactions(run: Samples, names: list[str], every: np.ndarray) -> list[Reaction]:
    if not every.size:
        return []
    every = np.nan_to_num(every)
    width = 2 if every.shape[2] == 3 else 3
    forces, moments = (np.linalg.norm(part, axis=2) for part in (every[:, :, :width], every[:, :, width:]))
    least = [STILL * float(part.max()) for part in (forces, moments)]
    found = []
    for k, name in enumerate(names):
        i, j = int(forces[:, k].argmax()), int(moments[:, k].argmax())
        force, moment = float(forces[i, k]), float(moments[j, k])
        if force > least[0] or moment > least[1]:
            parts = tuple(_rounded(x, force) for x in every[i, k, :width])
            found.append(Reaction(name, force, float(run.t[i]), parts, moment, float(run.t[j])))
    return found


def deflection_peaks(run: Samples) -> list[Peak]:
    """Of every beam, from the x-axis of its frame."""
    found = []
    for beam in run.model.description.beams:
        try:
            deflection = deflections(run, beam.body)
        except ModelError:
            continue
        size = np.hypot(deflection.y, deflection.z)
        sample, place = np.unravel_index(int(np.nanargmax(size)), size.shape)
        value, t = float(size[sample, place]), float(deflection.t[sample])
        found.append(Peak(f"deflection of {beam.body}", "m", value, t, _along(deflection.at[place])))
    return found


SECTION: dict[Which, tuple[str, str]] = {
    "normal": ("normal force", "N"),
    "shear": ("shear force along y", "N"),
    "shear_z": ("shear force along z", "N"),
    "torsion": ("torque", "N m"),
    "moment_y": ("bending moment about y", "N m"),
    "moment": ("bending moment about z", "N m"),
}


def section_peaks(run: Samples) -> list[Peak]:
    """Of every beam the section forces that are not zero."""
    found = []
    for beam in run.model.description.beams:
        try:
            forces = section_forces(run, beam.body)
        except ModelError:
            continue
        for which, (what, unit) in SECTION.items():
            if np.isfinite(getattr(forces, which)).any():
                value, t, at = forces.largest(which)
                found.append(Peak(f"{what} in {beam.body}", unit, value, t, _along(at)))
    least = {
        unit: STILL * max((abs(one.value) for one in found if one.unit == unit), default=0) for unit in ("N", "N m")
    }
    return [one for one in found if abs(one.value) > least[one.unit]]


def stress_peaks(run: Samples) -> list[Peak]:
    """Von Mises stress of the beams whose stress the scene measures, and at the gauges of finite-element bodies."""
    found = []
    for beam in run.model.description.beams:
        try:
            value, t, at = beam_stresses(run, beam.body).largest()
        except ModelError:
            continue
        found.append(Peak(f"von Mises stress in {beam.body}", "Pa", value, t, _along(at)))
    for body in dict.fromkeys(one.body for one in run.model.description.gauges):
        try:
            largest = stresses(run, body).largest()
        except ModelError:  # gauges that know modal stresses only
            largest = stresses(run, body, way="modes").largest()
        found.append(Peak(f"von Mises stress in {body}", "Pa", largest.value, largest.t, f"gauge {largest.gauge}"))
    return found


def _along(at: float) -> str:
    return "start" if at == 0 else "end" if at == 1 else f"{at:.3g} of the length"
