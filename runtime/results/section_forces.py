"""Normal and shear forces, torque and bending moments along the beams of a motion.

Two ways. The sum of modal forces takes them from the strains of the shapes, M_z = E I w'', Q_y = -E I w''', N = E A u',
T = G J tau': shapes that do not hold what the loads do make it converge slowly. Equilibrium of the part beyond the
section takes them from the loads and joint forces on that part less its inertia forces (mode acceleration with
inertia relief): the shapes enter through the accelerations only, so static answers are exact with any shapes.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal, NamedTuple

import numpy as np

from runtime.contract.arguments import arguments
from runtime.contract.errors import ArgumentError, ModelError
from runtime.contract.flexible import (
    ShapeFunctions,
    bending_shapes,
    cross_matrix,
    gauss_points,
    panels_for,
    stretching_shapes,
)
from runtime.contract.model import EmittedModel
from runtime.results.body_motion import (
    MAX_SAMPLES_AT_ONCE,
    FrameMotion,
    attached_forces,
    attached_markers,
    frame_motion,
    into_body,
    one_place,
    vectors,
    wrench,
)
from runtime.results.samples import Samples

# ---- A beam of a model with its shapes and stiffnesses, as its results need them (Eqs. 15-20).

STRETCHING, ALONG_Y, ALONG_Z, TORSION = range(4)
BENDING = (ALONG_Y, ALONG_Z)
MOVING = [0.0, 1.0, -1.0]  # `along` of a force at one place that moves


@dataclass(frozen=True, eq=False)
class BeamShapes:
    """Shapes of one direction: their columns in q.

    ends: their name; stiffness: E I / L^3 [N/m], of stretching E A / L [N/m], of torsion G J / L [N m].
    """

    ends: str
    columns: list[int]
    functions: ShapeFunctions
    stiffness: float


@dataclass(frozen=True, eq=False)
class Beam:
    """place, turning: columns in q of R_o and of the orientation.

    length [m], mass [kg]; radii (2,): I / A [m^2] of the section along y and z; sets: shapes by axis (x, y, z, 3 for
    torsion). stiffened: are bent beams shorter? attached: its joints and loads, with the places xi of their markers.
    spread: its loads along the beam, with `along` of `LoadRecord`, and what slides on it.
    """

    name: str
    place: list[int]
    turning: list[int]
    length: float
    mass: float
    radii: np.ndarray
    sets: dict[int, BeamShapes]
    stiffened: bool
    attached: dict[str, list[float]]
    spread: dict[str, list[float]]

    @property
    def planar(self) -> bool:
        """Does it bend in one plane only?"""
        return len(self.turning) == 1


def beam_of(model: EmittedModel, name: str, p: np.ndarray) -> Beam:
    """The beam `name` for the parameters p (n_p,).

    Raises ModelError if the model has no such beam, or no functions.
    """
    records = {record.body: record for record in model.description.beams}
    if name not in records:
        raise ModelError(f"model {model.name} has no beam {name!r}; it has {', '.join(records) or 'none'}")
    if not (model.has("geometry") and model.has("augmented")):
        raise ModelError(f"model {model.name} has no functions geometry and augmented; generate it with all functions")
    described = model.description
    frame, elastic = model.columns_of(name)
    dimension = 2 if described.drawing.space == "planar" else 3
    points = [(one.name, float(one.place[0])) for one in model.drawn_points(p) if one.body == name]
    length = max(x for _, x in points)
    sides = model.geometry(p)["sections"].reshape(2, -1)[:, described.drawing.sections.index(name)]
    n = len(model.coordinates)
    values = model.evaluate("augmented", q=np.zeros(n), q_dot=np.zeros(n), t=0.0, c=model.constants(p))
    M, K = np.asarray(values["M"]), np.asarray(values["K"])
    sets: dict[int, BeamShapes] = {}
    for one in records[name].sets:
        mine, elastic = elastic[: one.modes], elastic[one.modes :]
        functions, eigenvalues = (bending_shapes if one.axis in BENDING else stretching_shapes)(one.ends, one.modes)
        xi, weights = gauss_points(panels_for(one.modes))
        square = float(weights @ functions.at(xi)[:, 0] ** 2)
        sets[one.axis] = BeamShapes(one.ends, mine, functions, float(K[mine[0], mine[0]] / (eigenvalues[0] * square)))
    places = {marker: x / length for marker, x in points if marker}
    spread = {
        one.name: one.along for one in described.loads if one.along and (name, one.name) in described.load_columns
    }
    spread |= {one.name: MOVING for one in described.joints if one.type == "slides_on" and one.body_a == name}
    attached = {key: own for key, own in attached_markers(model, name).items() if key not in spread}
    return Beam(
        name,
        frame[:dimension],
        frame[dimension:],
        length,
        float(M[frame[0], frame[0]]),
        sides**2 / 12,
        sets,
        any(point.stiffened for point in described.drawing.points if point.body == name),
        {key: [places[marker] for marker in own] for key, own in attached.items()},
        spread,
    )


# ---- Motion along a beam and the balance of the part beyond each section: forces on it less its inertia forces.

Rates = tuple[np.ndarray, np.ndarray, np.ndarray]


class SectionField:
    """Positions and accelerations along a beam, at the sections xi (ascending) and at points of the mass between them.

    Vectors are (3, N, points) in the beam's axes; the planar beam has none along z.
    """

    def __init__(self, beam: Beam, xi: np.ndarray) -> None:
        self.beam, self.sections = beam, xi
        borders, panels = [*xi, 1.0], panels_for(max((len(one.columns) for one in beam.sets.values()), default=0))
        spans = [b - a for a, b in zip(borders, borders[1:], strict=False)]
        parts = [gauss_points(max(1, math.ceil(panels * span)), span) for span in spans]
        points = [a + part[0] for a, part in zip(xi, parts, strict=True)]
        self.mass = [beam.mass * part[1] for part in parts]
        self.sizes = np.cumsum([len(xi), *(len(part) for part in points)])
        self.xi = np.concatenate([xi, *points])
        self.values = {axis: one.functions.at(self.xi) for axis, one in beam.sets.items()}
        self.slopes = {axis: one.functions.at(xi, 1) / beam.length for axis, one in beam.sets.items()}
        polar = float(beam.radii.sum())
        scales = {ALONG_Y: 1.0, ALONG_Z: 1.0, TORSION: polar} if beam.stiffened else {}
        self.H = {axis: self._shortening(axis) * scales[axis] / beam.length for axis in scales if axis in beam.sets}

    def _shortening(self, axis: int) -> np.ndarray:
        """(points, n, n) integral of phi'^T phi' from the start to each point."""
        functions = self.beam.sets[axis].functions
        H = np.zeros((len(self.xi), functions.count, functions.count))
        last, total = 0.0, np.zeros(H.shape[1:])
        for k in np.argsort(self.xi):
            points, weights = gauss_points(1, float(self.xi[k]) - last)
            rate = functions.at(last + points, 1)
            total = total + rate.T @ (weights[:, None] * rate)
            H[k], last = total, float(self.xi[k])
        return H

    def forces(
        self,
        moved: Rates,
        frame: FrameMotion,
        a_o: np.ndarray,
        loads: list[tuple[float, np.ndarray]],
        spread: Sequence[tuple[Sequence[float], np.ndarray]],
    ) -> np.ndarray:
        """(6, N, n): N, Q_y, Q_z, T, M_y, M_z along the axes of the sections.

        moved: q, q_dot, q_ddot (N, .); a_o (N, 3): acceleration of the frame less gravity, body axes; loads: place, and
        force and moment about the frame origin (N, 6) of each, body axes; spread: `along` of a load along the beam, and
        the same with the force of the second half of a linear one (N, 9).
        """
        rho, a, spin = self._motion(moved, frame, a_o)
        n = len(self.sections)
        force, moment = np.zeros((2, 3, len(a_o), n))  # moment about the frame origin
        for k in range(n - 1, -1, -1):
            own = slice(self.sizes[k], self.sizes[k + 1])
            push = self.mass[k] * a[:, :, own]
            turning = np.cross(rho[:, :, own], push, axis=0) + self.mass[k] * spin[:, :, own]
            force[:, :, k], moment[:, :, k] = -push.sum(axis=2), -turning.sum(axis=2)
            if k + 1 < n:
                force[:, :, k] += force[:, :, k + 1]
                moment[:, :, k] += moment[:, :, k + 1]
        for place, load in loads:
            beyond = (place > self.sections) | ((place == 1.0) & (self.sections == 1.0))
            force += load.T[:3, :, None] * beyond
            moment += load.T[3:, :, None] * beyond
        for along, load in spread:
            parts = _beyond(along, load, self.beam.length, self.sections)
            force, moment = force + parts[0], moment + parts[1]
        moment -= np.cross(rho[:, :, :n], force, axis=0)
        R = self._axes(moved[0])
        return np.concatenate([np.einsum("snij,isn->jsn", R, vector) for vector in (force, moment)])

    def _motion(self, moved: Rates, frame: FrameMotion, a_o: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """rho [m], acceleration less gravity [m/s^2], and rate of spin of the sections a mass [m^2/s^2]."""
        rho, rate, a = (np.zeros((3, len(a_o), len(self.xi))) for _ in range(3))
        for axis, phi in self.values.items():
            if axis != TORSION:
                for vector, values in zip((rho, rate, a), moved, strict=True):
                    vector[axis] = values[:, self.beam.sets[axis].columns] @ phi.T
        rho[0] += self.xi * self.beam.length
        for axis, H in self.H.items():
            b, b_dot, b_ddot = (values[:, self.beam.sets[axis].columns] for values in moved)
            rho[0] -= 0.5 * _form(b, H, b)
            rate[0] -= _form(b, H, b_dot)
            a[0] -= _form(b_dot, H, b_dot) + _form(b, H, b_ddot)
        omega, alpha = cross_matrix(frame.omega), cross_matrix(frame.alpha)
        a += np.einsum("sij,jsk->isk", alpha + omega @ omega, rho) + 2 * np.einsum("sij,jsk->isk", omega, rate)
        return rho, a + a_o.T[:, :, None], self._spin(moved, frame)

    def _spin(self, moved: Rates, frame: FrameMotion) -> np.ndarray:
        """J omega' + omega x J omega of sections that turn and twist, over the mass; none in the plane."""
        found = np.zeros((3, len(frame.omega), len(self.xi)))
        if self.beam.planar:
            return found
        tau, tau_dot, tau_ddot = np.zeros((3, *found.shape[1:]))
        if TORSION in self.beam.sets:
            own = self.beam.sets[TORSION].columns
            tau, tau_dot, tau_ddot = (values[:, own] @ self.values[TORSION].T for values in moved)
        (x, y, z), (x_dot, y_dot, z_dot) = (vector.T[:, :, None] for vector in (frame.omega, frame.alpha))
        c, s, (ry, rz) = np.cos(tau), np.sin(tau), self.beam.radii
        yy, zz, yz = ry * c**2 + rz * s**2, ry * s**2 + rz * c**2, (ry - rz) * s * c
        J = np.array([[ry + rz + 0 * yy, 0 * yy, 0 * yy], [0 * yy, zz, -yz], [0 * yy, -yz, yy]])
        w = np.stack([x + tau_dot, y + 0 * tau, z + 0 * tau])
        w_dot = np.stack([x_dot + tau_ddot, y_dot + z * tau_dot, z_dot - y * tau_dot])
        found = np.einsum("ijsk,jsk->isk", J, w_dot)
        return np.asarray(found + np.cross(w, np.einsum("ijsk,jsk->isk", J, w), axis=0))

    def _axes(self, q: np.ndarray) -> np.ndarray:
        """(N, n, 3, 3): columns are the axes of the sections, turned as a marker there is."""
        turns = {axis: q[:, one.columns] @ self.slopes[axis].T for axis, one in self.beam.sets.items()}
        none = np.zeros((len(q), len(self.sections)))
        if self.beam.planar:
            turn = turns.get(ALONG_Y, none)
            psi = np.stack([none, none, 2 * np.tan(0.5 * turn)], axis=-1)
        else:
            angle = none
            if TORSION in turns:
                own = self.beam.sets[TORSION]
                angle = q[:, own.columns] @ own.functions.at(self.sections).T
            psi = np.stack([angle, -turns.get(ALONG_Z, none), turns.get(ALONG_Y, none)], axis=-1)
        tilde = cross_matrix(psi.reshape(-1, 3)).reshape(*none.shape, 3, 3)
        k = 1 + 0.25 * np.square(psi).sum(axis=-1)[:, :, None, None]
        return np.asarray(np.eye(3) + (tilde + 0.5 * tilde @ tilde) / k)

    def of_shapes(self, q: np.ndarray) -> np.ndarray:
        """(6, N, n): N, Q_y, Q_z, T, M_y, M_z by the strains of the shapes; NaN where there are none."""
        beam = self.beam
        found = np.full((6, len(q), len(self.sections)), np.nan)
        if beam.planar:
            found[2:5] = 0.0
        for axis, order, row, factor in (
            (STRETCHING, 1, 0, 1.0),
            (ALONG_Y, 3, 1, -1.0),
            (ALONG_Z, 3, 2, -1.0),
            (TORSION, 1, 3, 1.0),
            (ALONG_Z, 2, 4, -beam.length),
            (ALONG_Y, 2, 5, beam.length),
        ):
            if axis in beam.sets:
                one = beam.sets[axis]
                found[row] = factor * one.stiffness * q[:, one.columns] @ one.functions.at(self.sections, order).T
        return found


def _form(left: np.ndarray, H: np.ndarray, right: np.ndarray) -> np.ndarray:
    return np.asarray(np.einsum("sa,kab,sb->sk", left, H, right, optimize=True))


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


@arguments()
def section_forces(
    solution: Samples, body: str, at: float | Sequence[float] | None = None, way: Way = "equilibrium"
) -> SectionForces:
    """Recover normal and shear forces, torque and bending moments of a beam.

    Parameters
    ----------
    solution : Solution
        N samples.
    body : str
        The beam.
    at : float or sequence of float, optional
        Fractions of its length from 0 to 1; 33 places if left out.
    way : {"equilibrium", "modes"}
        Equilibrium of the part beyond each section (mode acceleration with inertia relief), or the sum of
        what the modes bear.

    Returns
    -------
    SectionForces
        Forces [N] and moments [N m] at each sample and place.

    Raises
    ------
    ModelError
        For a body that is not a beam with exact shapes, and for a load with two markers on it.
    ArgumentError
        For fractions outside [0, 1] and unknown ways.

    Notes
    -----
    The inertia forces are those of the deformed beam's motion (Eqs. 15-20).
    """
    xi = sections_of(at, way)
    beam = beam_of(solution.model, body, solution.parameters)
    order = np.argsort(xi)
    field = SectionField(beam, xi[order])
    values = field.of_shapes(solution.q) if way == "modes" else by_equilibrium(solution, beam, field)
    return SectionForces(body, solution.t, xi, *values[:, :, np.argsort(order)])


def sections_of(at: float | Sequence[float] | None, way: str) -> np.ndarray:
    """(n,) fractions of the length. Raises ArgumentError for those off the beam, and for unknown ways."""
    if way not in WAYS:
        raise ArgumentError(f"way {way!r} is not known; give one of {', '.join(WAYS)}")
    xi = np.atleast_1d(np.asarray(STATIONS if at is None else at, dtype=float))
    if xi.ndim != 1 or not len(xi):
        raise ArgumentError("at", f"has the shape {xi.shape}", "give fractions of the length, from 0 to 1")
    if not ((xi >= 0.0) & (xi <= 1.0)).all():
        raise ArgumentError(f"sections {at!r} are off the beam; give fractions of its length from 0 to 1")
    return xi


def by_equilibrium(solution: Samples, beam: Beam, field: SectionField) -> np.ndarray:
    """(6, N, n) from the forces on the part beyond each section."""
    for name, along in beam.spread.items():
        if along[2] > 1:
            raise ModelError(
                f"{name} is more than linear along {beam.name}, so its part beyond a section cannot be separated; "
                'take way="modes", or loads on parts of the beam that are linear there'
            )
    gravity = np.resize([*solution.model.description.gravity, 0.0, 0.0, 0.0], 3)
    found = np.empty((6, len(solution.t), len(field.sections)))
    places = {name: one_place(name, where, beam.name) for name, where in beam.attached.items()}
    parts = attached_forces(solution, beam.name, [*beam.place, *beam.turning], [*places, *beam.spread])
    for first in range(0, len(solution.t), MAX_SAMPLES_AT_ONCE):
        rows = slice(first, first + MAX_SAMPLES_AT_ONCE)
        moved = solution.q[rows], solution.q_dot[rows], solution.q_ddot[rows]
        frame = frame_motion(*(values[:, beam.turning] for values in moved))
        a_o = into_body(frame, vectors(moved[2][:, beam.place]) - gravity)
        acting = [(name, wrench(force[rows], len(beam.place), frame)) for name, force in parts]
        loads = [(places[name], load) for name, load in acting if name in places]
        halves = {name: vectors(force[rows][:, -len(beam.place) :]) for name, force in parts}
        spread = [
            (beam.spread[name], np.hstack([load, into_body(frame, halves[name])]))
            for name, load in acting
            if name in beam.spread
        ]
        found[:, rows] = field.forces(moved, frame, a_o, loads, spread)
    return found


def _beyond(along: Sequence[float], load: np.ndarray, length: float, xi: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Force and moment about the frame origin (3, N, n) of the part of a load along the beam beyond sections.

    Force and moment say where one force is, the forces of the whole and of the second half what p_0 + p_1 x of a linear
    load is; what is left of the moment, of the deflection, is shared as the force is.
    """
    start, end, power = along[0] * length, along[1] * length, along[2]
    F, M, second = load.T[:3, :, None], load.T[3:6, :, None], load.T[6:, :, None]
    if power < 0:
        beyond = moving_place(load)[:, None] > xi * length
        return F * beyond, M * beyond
    A, B = end - start, (end**2 - start**2) / 2
    p_1 = 4 * (2 * second - F) / A**2 if power else np.zeros_like(F)
    p_0 = (F - B * p_1) / A
    low = np.clip(xi * length, start, end)

    def integrals(low: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        a, b, c = end - low, (end**2 - low**2) / 2, (end**3 - low**3) / 3
        moved = p_0 * b + p_1 * c
        return p_0 * a + p_1 * b, np.stack([np.zeros_like(moved[0]), -moved[2], moved[1]])

    force, moment = integrals(low)
    _, straight = integrals(np.array([start]))
    return force, moment + (M - straight) * (end - low) / A


def moving_place(load: np.ndarray) -> np.ndarray:
    """(N,) [m] from the start where a force acts, by it and its moment about the frame origin (N, 6); 0 of none."""
    _, F_y, F_z, _, M_y, M_z = load.T[:6]
    size = F_y**2 + F_z**2
    return np.asarray(np.divide(M_z * F_y - M_y * F_z, size, out=np.zeros_like(size), where=size > 0))
