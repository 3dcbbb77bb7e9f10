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

from runtime.contract.errors import ArgumentError
from runtime.contract.model import ModelError
from runtime.results.beam_shapes import Beam, beam_of
from runtime.results.frame_motion import FrameMotion, frame_motion
from runtime.results.sampling import evaluate
from runtime.results.section_field import SectionField

if TYPE_CHECKING:
    from runtime.results.samples import Samples

Way = Literal["equilibrium", "modes"]
Which = Literal["normal", "shear", "shear_z", "torsion", "moment_y", "moment"]
WAYS = ("equilibrium", "modes")
STATIONS = tuple(float(at) for at in np.linspace(0.0, 1.0, 33))
LONGEST = 256  # samples at once


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
    parts = _generalised(solution, beam)
    for first in range(0, len(solution.t), LONGEST):
        rows = slice(first, first + LONGEST)
        moved = solution.q[rows], solution.q_dot[rows], solution.q_ddot[rows]
        frame = frame_motion(beam.orientation, *(values[:, beam.turning] for values in moved))
        into_body = frame.A.transpose(0, 2, 1)
        a_o = into_body @ (_vectors(moved[2][:, beam.place]) - gravity)[:, :, None]
        loads = [(place, _wrench(force[rows], len(beam.place), frame, into_body)) for place, force in parts]
        found[:, rows] = field.forces(moved, frame, a_o[:, :, 0], loads)
    return found


def _vectors(values: np.ndarray) -> np.ndarray:
    """(N, 3) from x and y, or x, y and z."""
    return np.pad(values, ((0, 0), (0, 3 - values.shape[1])))


def _wrench(generalised: np.ndarray, dimension: int, frame: FrameMotion, into_body: np.ndarray) -> np.ndarray:
    """(N, 6) force and moment about the frame origin, in the beam's axes, of forces on its frame's coordinates."""
    force = (into_body @ _vectors(generalised[:, :dimension])[:, :, None])[:, :, 0]
    turning = generalised[:, dimension : dimension + frame.W.shape[2]]
    return np.hstack([force, frame.moment(turning)])


def _generalised(solution: Samples, beam: Beam) -> list[tuple[float, np.ndarray]]:
    """(place, force on the frame's coordinates (N, .)) of each joint and load on the beam."""
    model, N = solution.model, len(solution.t)
    frame = [*beam.place, *beam.turning]
    places = {name: _one_place(name, where, beam) for name, where in beam.attached.items()}
    values = {"q": solution.q, "q_dot": solution.q_dot, "t": solution.t[:, None]}
    c = model.constants(solution.parameters)
    rows = {name: [k for k, row in enumerate(model.description.constraints) if row.joint == name] for name in places}
    acting = {name: np.zeros((N, len(frame))) for name, own in rows.items() if own}
    n_c, n = len(model.constraints), len(model.coordinates)
    for first in range(0, N if acting else 0, LONGEST):
        some = {key: value[first : first + LONGEST] for key, value in values.items()}
        C_q = evaluate(model.kernel("constraints"), some, c)["C_q"].reshape(-1, n, n_c)
        lam = solution.lam[first : first + LONGEST]
        for name, force in acting.items():
            part = np.einsum("sir,sr->si", C_q[:, frame][:, :, rows[name]], lam[:, rows[name]])
            force[first : first + LONGEST] = -part
    found = [(places[name], force) for name, force in acting.items()]
    columns = [(record.body, name) for record in model.description.beams for name in record.loads]
    if any(body == beam.name for body, _ in columns):
        forces = evaluate(model.kernel("load_forces"), values, c)["load_forces"].reshape(N, len(columns), -1)
        found += [(places[name], forces[:, k]) for k, (body, name) in enumerate(columns) if body == beam.name]
    return found


def _one_place(name: str, where: Sequence[float], beam: Beam) -> float:
    if len(where) > 1:
        raise ModelError(
            f"{name} acts on {beam.name} at two places, whose parts are not told apart; divide the beam or the load"
        )
    return where[0]
