"""Normal force, shear force and bending moment along the beams of a motion.

Two ways. The sum of modal forces takes them from the curvature of the shapes, M = E I w'', Q = -E I w''', N = E A u':
shapes that do not hold what the loads do make it converge slowly. Equilibrium of the part beyond the section takes them
from the loads and joint forces on that part less its inertia forces, which is the mode acceleration method with inertia
relief: the shapes enter through the accelerations only, so static answers are exact with any shapes.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal, NamedTuple

import numpy as np

from runtime.contract.beams import gauss_points, panels_for
from runtime.contract.errors import ArgumentError
from runtime.contract.model import Model, ModelError
from runtime.results.beam_shapes import Beam, beam_of
from runtime.results.sampling import evaluate

if TYPE_CHECKING:
    from runtime.results.samples import Samples

Way = Literal["equilibrium", "modes"]
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

    t (N,) [s]; at (n,) fractions of the length; normal (N, n) [N], tension positive; shear (N, n) [N] along the
    section's y-axis; moment (N, n) [N m] about z, so that moment = E I curvature. NaN where the way does not know it.
    """

    body: str
    t: np.ndarray
    at: np.ndarray
    normal: np.ndarray
    shear: np.ndarray
    moment: np.ndarray

    def largest(self, which: Literal["normal", "shear", "moment"]) -> LargestForce:
        """The largest magnitude of `normal`, `shear` or `moment` over all samples and sections."""
        values = np.asarray(getattr(self, which))
        sample, place = np.unravel_index(int(np.nanargmax(np.abs(values))), values.shape)
        return LargestForce(float(values[sample, place]), float(self.t[sample]), float(self.at[place]))


def section_forces(
    solution: Samples, body: str, at: float | Sequence[float] | None = None, way: Way = "equilibrium"
) -> SectionForces:
    """N, Q and M of the beam `body` at fractions `at` of its length (33 sections if left out).

    Raises ModelError for a body that is no planar beam with exact shapes or for a load with two markers on it,
    ArgumentError for fractions outside [0, 1] and unknown ways.
    """
    if way not in WAYS:
        raise ArgumentError(f"way {way!r} is not known; give one of {', '.join(WAYS)}")
    xi = np.atleast_1d(np.asarray(STATIONS if at is None else at, dtype=float))
    if not ((xi >= 0.0) & (xi <= 1.0)).all():
        raise ArgumentError(f"sections {at!r} are off the beam; give fractions of its length from 0 to 1")
    beam = beam_of(solution.model, body, solution.parameters)
    order = np.argsort(xi)
    compute = _by_modes if way == "modes" else _by_equilibrium
    values = compute(solution, beam, xi[order])[:, :, np.argsort(order)]
    return SectionForces(body, solution.t, xi, *values)


def _by_modes(solution: Samples, beam: Beam, xi: np.ndarray) -> np.ndarray:
    """(3, N, n): N, Q, M from the shapes."""
    found = np.full((3, len(solution.t), len(xi)), np.nan)
    if beam.stretching is not None:
        q, functions = solution.q[:, beam.stretching.columns], beam.stretching.functions
        found[0] = beam.stretching.stiffness * q @ functions.at(xi, 1).T
    if beam.bending is not None:
        q, functions = solution.q[:, beam.bending.columns], beam.bending.functions
        found[1] = -beam.bending.stiffness * q @ functions.at(xi, 3).T
        found[2] = beam.bending.stiffness * beam.length * q @ functions.at(xi, 2).T
    return found


def _by_equilibrium(solution: Samples, beam: Beam, xi: np.ndarray) -> np.ndarray:
    """(3, N, n) from the forces on the part beyond each section; xi ascending."""
    field = _Field(beam, xi, _gravity(solution.model))
    loads = _loads(solution, beam)
    found = np.empty((3, len(solution.t), len(xi)))
    for first in range(0, len(solution.t), LONGEST):
        rows = slice(first, first + LONGEST)
        parts = [(place, wrench[rows]) for place, wrench in loads]
        found[:, rows] = field.forces(solution.q[rows], solution.q_dot[rows], solution.q_ddot[rows], parts)
    return found


class _Field:
    """Positions and accelerations along a beam, at the sections and at the points of the mass between them."""

    def __init__(self, beam: Beam, xi: np.ndarray, gravity: np.ndarray) -> None:
        self.beam, self.sections, self.gravity = beam, xi, gravity
        modes = max((len(one.columns) for one in (beam.bending, beam.stretching) if one is not None), default=0)
        borders, panels = [*xi, 1.0], panels_for(modes)
        spans = [b - a for a, b in zip(borders, borders[1:], strict=False)]
        parts = [gauss_points(max(1, math.ceil(panels * span)), span) for span in spans]
        points = [a + part[0] for a, part in zip(xi, parts, strict=True)]
        self.mass = [beam.mass * part[1] for part in parts]
        self.sizes = np.cumsum([len(xi), *(len(part) for part in points)])
        self.xi = np.concatenate([xi, *points])
        self.w = beam.bending.functions.at(self.xi) if beam.bending else np.zeros((len(self.xi), 0))
        self.u = beam.stretching.functions.at(self.xi) if beam.stretching else np.zeros((len(self.xi), 0))
        self.slope = beam.bending.functions.at(xi, 1) / beam.length if beam.bending else np.zeros((len(xi), 0))
        self.H = self._foreshortening() / beam.length

    def _foreshortening(self) -> np.ndarray:
        """(points, n, n) integral of phi'^T phi' from the start to each point; zero without stiffening."""
        n, beam = self.w.shape[1], self.beam
        H = np.zeros((len(self.xi), n, n))
        if beam.bending is not None and beam.stiffened:
            order = np.argsort(self.xi)
            last, total = 0.0, np.zeros((n, n))
            for k in order:
                points, weights = gauss_points(1, float(self.xi[k]) - last)
                rate = beam.bending.functions.at(last + points, 1)
                total = total + rate.T @ (weights[:, None] * rate)
                H[k], last = total, float(self.xi[k])
        return H

    def forces(
        self, q: np.ndarray, q_dot: np.ndarray, q_ddot: np.ndarray, loads: list[tuple[float, np.ndarray]]
    ) -> np.ndarray:
        """(3, N, n): N, Q, M; loads: place and world force and moment about the frame origin (N, 3) of each."""
        rho, a = self._motion(q, q_dot, q_ddot)
        cosine, sine = np.cos(q[:, self.beam.frame[2]]), np.sin(q[:, self.beam.frame[2]])
        n = len(self.sections)
        force, moment = np.zeros((2, len(q), n)), np.zeros((len(q), n))  # moment about the frame origin
        for k in range(n - 1, -1, -1):
            own = slice(self.sizes[k], self.sizes[k + 1])
            inertia = np.einsum("j,isj->is", self.mass[k], a[:, :, own])
            turning = np.einsum("j,sj->s", self.mass[k], rho[0][:, own] * a[1][:, own] - rho[1][:, own] * a[0][:, own])
            before = (force[:, :, k + 1], moment[:, k + 1]) if k + 1 < n else (0.0, 0.0)
            force[:, :, k], moment[:, k] = before[0] - inertia, before[1] - turning
        for place, wrench in loads:
            beyond = (place > self.sections) | ((place == 1.0) & (self.sections == 1.0))
            along = cosine * wrench[:, 0] + sine * wrench[:, 1], cosine * wrench[:, 1] - sine * wrench[:, 0]
            force[0] += np.outer(along[0], beyond)
            force[1] += np.outer(along[1], beyond)
            moment += np.outer(wrench[:, 2], beyond)
        moment -= rho[0][:, :n] * force[1] - rho[1][:, :n] * force[0]
        bend = q[:, self.beam.bending.columns] if self.beam.bending else np.zeros((len(q), 0))
        turn = bend @ self.slope.T
        normal = np.cos(turn) * force[0] + np.sin(turn) * force[1]
        return np.stack([normal, np.cos(turn) * force[1] - np.sin(turn) * force[0], moment])

    def _motion(self, q: np.ndarray, q_dot: np.ndarray, q_ddot: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """rho (2, N, points) [m] and acceleration less gravity (2, N, points) [m/s^2], in the beam's axes."""
        beam = self.beam
        bend, stretch = (one.columns if one else [] for one in (beam.bending, beam.stretching))
        w, w_dot, w_ddot = (values[:, bend] @ self.w.T for values in (q, q_dot, q_ddot))
        u, u_dot, u_ddot = (values[:, stretch] @ self.u.T for values in (q, q_dot, q_ddot))
        if beam.stiffened:
            b, b_dot, b_ddot = (values[:, bend] for values in (q, q_dot, q_ddot))
            u = u - 0.5 * np.einsum("sa,kab,sb->sk", b, self.H, b, optimize=True)
            u_dot = u_dot - np.einsum("sa,kab,sb->sk", b, self.H, b_dot, optimize=True)
            u_ddot = u_ddot - np.einsum("sa,kab,sb->sk", b_dot, self.H, b_dot, optimize=True)
            u_ddot = u_ddot - np.einsum("sa,kab,sb->sk", b, self.H, b_ddot, optimize=True)
        x = self.xi * beam.length + u
        x_column, y_column, turn = beam.frame
        cosine, sine = np.cos(q[:, turn])[:, None], np.sin(q[:, turn])[:, None]
        omega, alpha = q_dot[:, turn][:, None], q_ddot[:, turn][:, None]
        R = [q_ddot[:, column][:, None] - g for column, g in zip((x_column, y_column), self.gravity, strict=True)]
        a_x = cosine * R[0] + sine * R[1] + u_ddot - alpha * w - omega**2 * x - 2 * omega * w_dot
        a_y = cosine * R[1] - sine * R[0] + w_ddot + alpha * x - omega**2 * w + 2 * omega * u_dot
        return np.stack([x, w]), np.stack([a_x, a_y])


def _gravity(model: Model) -> np.ndarray:
    return np.asarray(model.description.gravity[:2] or [0.0, 0.0])


def _loads(solution: Samples, beam: Beam) -> list[tuple[float, np.ndarray]]:
    """(place, world force and moment about the frame origin (N, 3)) of each joint and load on the beam."""
    model, N = solution.model, len(solution.t)
    places = {name: _one_place(name, where, beam) for name, where in beam.attached.items()}
    found: list[tuple[float, np.ndarray]] = []
    values = {"q": solution.q, "q_dot": solution.q_dot, "t": solution.t[:, None]}
    c = model.constants(solution.parameters)
    rows = {name: [k for k, row in enumerate(model.description.constraints) if row.joint == name] for name in places}
    wrenches = {name: np.zeros((N, 3)) for name, own in rows.items() if own}
    n_c, n = len(model.constraints), len(model.coordinates)
    for first in range(0, N if wrenches else 0, LONGEST):
        some = {key: value[first : first + LONGEST] for key, value in values.items()}
        C_q = evaluate(model.kernel("constraints"), some, c)["C_q"].reshape(-1, n, n_c)
        lam = solution.lam[first : first + LONGEST]
        for name, wrench in wrenches.items():
            part = np.einsum("sir,sr->si", C_q[:, beam.frame][:, :, rows[name]], lam[:, rows[name]])
            wrench[first : first + LONGEST] = -part
    found += [(places[name], wrench) for name, wrench in wrenches.items()]
    columns = [(record.body, name) for record in model.description.beams for name in record.loads]
    if any(body == beam.name for body, _ in columns):
        forces = evaluate(model.kernel("load_forces"), values, c)["load_forces"].reshape(N, -1, 3)
        found += [(places[name], forces[:, k]) for k, (body, name) in enumerate(columns) if body == beam.name]
    return found


def _one_place(name: str, where: Sequence[float], beam: Beam) -> float:
    if len(where) > 1:
        raise ModelError(
            f"{name} acts on {beam.name} at two places, whose parts are not told apart; divide the beam or the load"
        )
    return where[0]
