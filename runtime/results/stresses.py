"""Stresses of finite-element bodies at the gauges that a scene places on them.

Two ways, as of section forces. The sum of modal stresses needs the static shapes of all loads among the modes.
Equilibrium takes them from the forces on the body and its inertia forces (mode acceleration with inertia relief,
runtime/contract/flexible.py): the modes enter through the motion only.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Literal, NamedTuple

import numpy as np

from runtime.contract.arguments import arguments
from runtime.contract.errors import ArgumentError, ModelError
from runtime.contract.flexible import UnknownInterface, causes
from runtime.contract.records import GaugeRecord
from runtime.results.body_motion import body_motion
from runtime.results.samples import Samples
from runtime.results.section_forces import SectionForces, section_forces

StressWay = Literal["equilibrium", "modes"]
COMPONENTS = ("xx", "yy", "zz", "yz", "xz", "xy")


class LargestStress(NamedTuple):
    """The largest von Mises stress over time and place: value [Pa], t [s], gauge; mesh_error [Pa]: there and then."""

    value: float
    t: float
    gauge: str
    mesh_error: float = np.nan


@dataclass(frozen=True, eq=False)
class Stresses:
    """Stresses of a body in its own axes at its gauges.

    t (N,) [s]; gauges: their names (n); components (N, n, 6) [Pa] in the order xx yy zz yz xz xy; mesh_error (N, n)
    [Pa]: what the mesh of the body leaves unknown of them (von Mises), NaN where its model did not say. It is no bound:
    within a factor 2 of the true error in most places, and it does not shrink at a sharp corner.
    """

    body: str
    t: np.ndarray
    gauges: list[str]
    components: np.ndarray
    mesh_error: np.ndarray

    @property
    def von_mises(self) -> np.ndarray:
        """(N, n) [Pa]."""
        return von_mises(self.components)

    def at(self, gauge: str) -> np.ndarray:
        """(N, 6) [Pa] at a gauge. Raises ModelError for an unknown one."""
        if gauge not in self.gauges:
            raise ModelError(f"{self.body} has no gauge {gauge!r}; it has {', '.join(self.gauges)}")
        return np.asarray(self.components[:, self.gauges.index(gauge)])

    def largest(self) -> LargestStress:
        """The largest von Mises stress over all samples and gauges."""
        values = self.von_mises
        sample, place = np.unravel_index(int(np.nanargmax(values)), values.shape)
        error = float(self.mesh_error[sample, place])
        return LargestStress(float(values[sample, place]), float(self.t[sample]), self.gauges[place], error)


def von_mises(components: np.ndarray) -> np.ndarray:
    """(...,) [Pa] of components (..., 6) in the order xx yy zz yz xz xy."""
    xx, yy, zz, yz, xz, xy = np.moveaxis(components, -1, 0)
    square = ((xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2) / 2 + 3 * (yz**2 + xz**2 + xy**2)
    return np.asarray(np.sqrt(square))


@dataclass(frozen=True, eq=False)
class BeamStresses:
    """Von Mises stress of a beam at fractions of its length, the larger one of two places in each section.

    t (N,) [s]; at (n,); von_mises (N, n) [Pa].
    """

    body: str
    t: np.ndarray
    at: np.ndarray
    von_mises: np.ndarray

    def largest(self) -> tuple[float, float, float]:
        """The largest over all samples and sections: value [Pa], t [s], fraction of the length."""
        sample, place = np.unravel_index(int(np.nanargmax(self.von_mises)), self.von_mises.shape)
        return float(self.von_mises[sample, place]), float(self.t[sample]), float(self.at[place])


def beam_stresses(solution: Samples, body: str, way: StressWay = "equilibrium") -> BeamStresses:
    """Von Mises stress along a beam whose stress the scene measures, with N / A whatever its shapes are.

    Parameters
    ----------
    solution : Samples
        N samples.
    body : str
        A beam.
    way : {"equilibrium", "modes"}
        Section forces by equilibrium of the part beyond each section, or those of the shapes, which know no normal
        force without axial modes.

    Returns
    -------
    BeamStresses
        At 33 sections: sqrt(sigma^2 + 3 tau^2) [Pa], the larger of that at the outermost fibre and at the neutral line
        (symgen/bodies/stresses.py).

    Raises
    ------
    ModelError
        For a beam whose stress no measure asks for, and as `section_forces`.
    """
    section = _section_of(solution, body)
    return with_section(section, section_forces(solution, body, way=way))


def sum_of_shapes(solution: Samples, body: str) -> BeamStresses:
    """The stress of a beam as measures have it: by the forces of its shapes, and N by equilibrium if none stretches it.

    Raises ModelError as `beam_stresses`.
    """
    section, found = _section_of(solution, body), section_forces(solution, body, way="modes")
    if np.isnan(found.normal).any():
        found = replace(found, normal=section_forces(solution, body).normal)
    return with_section(section, found)


def _section_of(solution: Samples, body: str) -> dict[str, float]:
    """Area and moduli of a beam, by their keys. Raises ModelError where they are not known."""
    record = next((one for one in solution.model.description.beams if one.body == body), None)
    if record is None:
        raise ModelError(f"model {solution.model.name} has no beam {body!r}")
    names = [one.name for one in solution.model.parameters]
    if not record.section or any(name not in names for name in record.section.values()):
        remedy = f'measure it: scene.measure("peak", "stress", of="{body}.all")'
        raise ModelError(f"the section of beam {body!r} is not known to model {solution.model.name}; {remedy}")
    return {key: float(solution.parameters[names.index(name)]) for key, name in record.section.items()}


def with_section(value: Mapping[str, float], found: SectionForces) -> BeamStresses:
    """Stresses by section forces; value: the section by its keys."""
    area, zero = value["area"], np.zeros_like(found.moment)
    pulled = np.abs(np.nan_to_num(found.normal)) / area
    moments = {"section_modulus": found.moment, "section_modulus_z": found.moment_y}
    bending = sum((np.abs(np.nan_to_num(moments[key])) / value[key] for key in moments if key in value), zero)
    twisted = np.abs(np.nan_to_num(found.torsion)) / value["torsion_modulus"] if "torsion_modulus" in value else zero
    shear = np.hypot(np.nan_to_num(found.shear), np.nan_to_num(found.shear_z))
    sheared = twisted + value["shear_factor"] * shear / area
    squares = np.maximum((pulled + bending) ** 2 + 3 * twisted**2, pulled**2 + 3 * sheared**2)
    return BeamStresses(found.body, found.t, np.asarray(found.at), np.sqrt(squares))


@arguments()
def stresses(solution: Samples, body: str, way: StressWay = "equilibrium") -> Stresses:
    """Recover stress components and von Mises stress of a finite-element body at the gauges of the scene.

    Parameters
    ----------
    solution : Solution
        N samples.
    body : str
        The body.
    way : {"equilibrium", "modes"}
        Equilibrium of all forces on it (mode acceleration with inertia relief), or the sum of modal
        stresses.

    Returns
    -------
    Stresses
        Stresses [Pa] at each sample and gauge.

    Raises
    ------
    ModelError
        For a body without gauges; by equilibrium for gauges that know modal stresses only, and for forces
        at a marker that was no interface of the finite-element model.
    ArgumentError
        For unknown ways.
    """
    if way not in ("equilibrium", "modes"):
        raise ArgumentError(f"way {way!r} is not known; give equilibrium or modes")
    gauges = [one for one in solution.model.description.gauges if one.body == body]
    if not gauges:
        known = ", ".join(sorted({one.body for one in solution.model.description.gauges})) or "none"
        raise ModelError(
            f"model {solution.model.name} has no gauges on {body!r}, only on: {known}; give its body "
            "FlexibleBody.fields(gauges=...)"
        )
    if way == "modes":
        q_f = solution.q[:, solution.model.columns_of(body)[1]]
        found = [(q_f @ np.array(one.shapes).T, _length(q_f, one.error_shapes)) for one in gauges]
    else:
        found = _by_equilibrium(solution, body, gauges)
    components, errors = (np.stack(part, axis=1) for part in zip(*found, strict=True))
    return Stresses(body, solution.t, [one.name for one in gauges], components, errors)


def _length(amounts: np.ndarray, rows: np.ndarray | list[list[float]]) -> np.ndarray:
    """(N,) lengths of rows (r, k) @ amounts (N, k); NaN where there are no rows."""
    if not len(rows):
        return np.full(len(amounts), np.nan)
    return np.asarray(np.linalg.norm(amounts @ np.array(rows).T, axis=1))


def _by_equilibrium(solution: Samples, body: str, gauges: list[GaugeRecord]) -> list[tuple[np.ndarray, np.ndarray]]:
    """Components (N, 6) and error of the mesh (N,) of each gauge."""
    motion = body_motion(solution, body)
    places = {one.name: one.place for one in solution.model.drawn_points(solution.parameters) if one.body == body}
    size = float(np.ptp(np.array(list(places.values())), axis=0).max())
    found = []
    for one in gauges:
        if not one.fields:
            raise ModelError(f"gauge {body}.{one.name} knows modal stresses only; ask for way='modes'")
        try:
            amounts = causes(motion, {name: places[name] for name in one.forces}, size)
        except UnknownInterface as error:
            raise ModelError(
                f"forces act on {body} at the marker {error}, which was no interface of its finite-element model; "
                "make it one, or ask for way='modes'"
            ) from None
        rows = np.hstack([np.array(one.fields), *(np.array(part) for part in one.forces.values())])
        found.append((amounts @ rows.T, _length(amounts, _error_rows(one))))
    return found


def _error_rows(gauge: GaugeRecord) -> np.ndarray:
    """(r, k) of all causes; none where the model did not say."""
    if not gauge.error_fields:
        return np.zeros((0, 0))
    return np.hstack([np.array(gauge.error_fields), *(np.array(gauge.error_forces[name]) for name in gauge.forces)])
