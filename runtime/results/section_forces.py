"""Normal and shear forces, torque and bending moments along the beams of a motion.

Two ways. The sum of modal forces takes them from the strains of the shapes, M_z = E I w'', Q_y = -E I w''', N = E A u',
T = G J tau': shapes that do not hold what the loads do make it converge slowly. Equilibrium of the part beyond the
section takes them from the loads and joint forces on that part less its inertia forces (mode acceleration with
inertia relief): the shapes enter through the accelerations only, so static answers are exact with any shapes.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal, NamedTuple

import numpy as np

from runtime.contract.errors import ArgumentError, ModelError
from runtime.results.attached_forces import LONGEST, attached_forces, into_body, vectors, wrench
from runtime.results.beam_shapes import Beam, beam_of
from runtime.results.frame_motion import frame_motion
from runtime.results.section_field import SectionField

if TYPE_CHECKING:
    from runtime.results.samples import Samples

Way = Literal["equilibrium", "modes"]
Which = Literal["normal", "shear", "shear_z", "torsion", "moment_y", "moment"]
WAYS = ("equilibrium", "modes")
STATIONS = tuple(float(at) for at in np.linspace(0.0, 1.0, 33))


class LargestForce(NamedTuple):
    """The largest magnitude over time and place: value with its sign, t [s], at (fraction of the length)."""

    value: float
    t: float
    at: float


@dataclass(frozen=True, eq=False)
class SectionForces:
    """What the part of a beam beyond the section does to the part before it, along the axes of the section.

    t (N,) [s]; at (n,) fractions of the length; normal (N, n) [N], tension positive; shear, shear_z (N, n) [N] along
    the section's y- and z-axis; torsion, moment_y, moment (N, n) [N m] about x, y and z: moment = E I curvature of the
    deflection along y. NaN where the way does not know it; zero across the plane of a planar beam.
    """

    body: str
    t: np.ndarray
    at: np.ndarray
    normal: np.ndarray
    shear: np.ndarray
    shear_z: np.ndarray
    torsion: np.ndarray
    moment_y: np.ndarray
    moment: np.ndarray

    def largest(self, which: Which) -> LargestForce:
        """The largest magnitude of a force or moment, by its name, over all samples and sections."""
        values = np.asarray(getattr(self, which))
        sample, place = np.unravel_index(int(np.nanargmax(np.abs(values))), values.shape)
        return LargestForce(float(values[sample, place]), float(self.t[sample]), float(self.at[place]))


def section_forces(
    solution: Samples, body: str, at: float | Sequence[float] | None = None, way: Way = "equilibrium"
) -> SectionForces:
    """Forces and moments in the beam `body` at fractions `at` of its length (33 sections if left out).

    Raises ModelError for a body that is no beam with exact shapes or for a load with two markers on it, ArgumentError
    for fractions outside [0, 1] and unknown ways.
    """
    if way not in WAYS:
        raise ArgumentError(f"way {way!r} is not known; give one of {', '.join(WAYS)}")
    xi = np.atleast_1d(np.asarray(STATIONS if at is None else at, dtype=float))
    if not ((xi >= 0.0) & (xi <= 1.0)).all():
        raise ArgumentError(f"sections {at!r} are off the beam; give fractions of its length from 0 to 1")
    beam = beam_of(solution.model, body, solution.parameters)
    order = np.argsort(xi)
    field = SectionField(beam, xi[order])
    values = field.of_shapes(solution.q) if way == "modes" else _by_equilibrium(solution, beam, field)
    return SectionForces(body, solution.t, xi, *values[:, :, np.argsort(order)])


def _by_equilibrium(solution: Samples, beam: Beam, field: SectionField) -> np.ndarray:
    """(6, N, n) from the forces on the part beyond each section."""
    gravity = np.resize([*solution.model.description.gravity, 0.0, 0.0, 0.0], 3)
    found = np.empty((6, len(solution.t), len(field.sections)))
    places = {name: _one_place(name, where, beam) for name, where in beam.attached.items()}
    parts = attached_forces(solution, beam.name, [*beam.place, *beam.turning], list(places))
    for first in range(0, len(solution.t), LONGEST):
        rows = slice(first, first + LONGEST)
        moved = solution.q[rows], solution.q_dot[rows], solution.q_ddot[rows]
        frame = frame_motion(*(values[:, beam.turning] for values in moved))
        a_o = into_body(frame, vectors(moved[2][:, beam.place]) - gravity)
        loads = [(places[name], wrench(force[rows], len(beam.place), frame)) for name, force in parts]
        found[:, rows] = field.forces(moved, frame, a_o, loads)
    return found


def _one_place(name: str, where: Sequence[float], beam: Beam) -> float:
    if len(where) > 1:
        raise ModelError(
            f"{name} acts on {beam.name} at two places, whose parts are not told apart; divide the beam or the load"
        )
    return where[0]
