"""Deflections along the beams of a motion: what their shapes do, and the static rest that the shapes leave out.

The bending moment from equilibrium less that of the shapes is what the shapes lack, w'' = M / E I. It is integrated
twice as a polynomial, but the kink of M where a force acts at one place by itself: w'' = F (s - x) / E I before s. The
rest has neither deflection nor slope where the shapes have none, and no momentum where they are free.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.polynomial import legendre

from runtime.contract.arguments import arguments
from runtime.contract.flexible import BENDING as ENDS
from runtime.results.body_motion import attached_forces, frame_motion, wrench
from runtime.results.samples import Samples
from runtime.results.section_forces import (
    ALONG_Y,
    ALONG_Z,
    BENDING,
    Beam,
    SectionField,
    Way,
    beam_of,
    by_equilibrium,
    moving_place,
    sections_of,
)

MOMENT_POINTS = 48  # of the bending moment along a beam, and four more for each shape


@dataclass(frozen=True, eq=False)
class Deflections:
    """Of the centre line of a beam from the x-axis of its frame, along the frame's y and z.

    t (N,) [s]; at (n,) fractions of the length; y, z (N, n) [m]: zero where it has no shapes.
    """

    body: str
    t: np.ndarray
    at: np.ndarray
    y: np.ndarray
    z: np.ndarray


@arguments()
def deflections(
    solution: Samples, body: str, at: float | Sequence[float] | None = None, way: Way = "equilibrium"
) -> Deflections:
    """Recover the deflections of a beam.

    Parameters
    ----------
    solution : Solution
        N samples.
    body : str
        The beam.
    at : float or sequence of float, optional
        Fractions of its length from 0 to 1; 33 places if left out.
    way : {"equilibrium", "modes"}
        "equilibrium" adds to the sum of the modes the static rest that they leave out, so that static
        answers are exact with any shapes; "modes" is the sum alone, which measures have too.

    Returns
    -------
    Deflections
        Deflections [m] at each sample and place.

    Raises
    ------
    ModelError
        As `section_forces`.
    ArgumentError
        For fractions outside [0, 1] and unknown ways.

    Notes
    -----
    The modes are those of Eq. 19.
    """
    xi = sections_of(at, way)
    beam = beam_of(solution.model, body, solution.parameters)
    found = np.zeros((3, len(solution.t), len(xi)))
    for axis in (axis for axis in BENDING if axis in beam.sets):
        found[axis] = solution.q[:, beam.sets[axis].columns] @ beam.sets[axis].functions.at(xi).T
    if way == "equilibrium":
        _add_rest(found, solution, beam, xi)
    return Deflections(body, solution.t, xi, found[ALONG_Y], found[ALONG_Z])


def _add_rest(found: np.ndarray, solution: Samples, beam: Beam, xi: np.ndarray) -> None:
    """Adds the static rest to the deflections (3, N, n)."""
    count = MOMENT_POINTS + 4 * max((len(one.columns) for one in beam.sets.values()), default=0)
    points, weights = legendre.leggauss(count)
    nodes, shares = (points + 1) / 2, weights / 2
    field = SectionField(beam, nodes)
    lacking = by_equilibrium(solution, beam, field) - field.of_shapes(solution.q)
    moments = {ALONG_Y: lacking[5], ALONG_Z: -lacking[4]}
    forces = _forces_at_places(solution, beam)
    spectrum = legendre.legvander(points, count - 1) * (np.arange(count) + 0.5)  # of interpolation at these points
    where = np.concatenate([xi, nodes, [1.0]])
    for axis in (axis for axis in BENDING if axis in beam.sets):
        one = beam.sets[axis]
        bend = moments[axis] / (one.stiffness * beam.length)
        w, slope = np.zeros((len(bend), len(where))), np.zeros(len(bend))
        for s, force in forces:
            F = (force[:, axis] / one.stiffness)[:, None]
            bend = bend - F * np.maximum(s - nodes, 0.0)
            w += F * (np.maximum(s - where, 0.0) ** 3 - s**3 + 3 * s**2 * where) / 6
            slope += F[:, 0] * s[:, 0] ** 2 / 2
        rate = legendre.legint((spectrum.T * weights) @ bend.T, lbnd=-1, scl=0.5)
        w += legendre.legval(2 * where - 1, legendre.legint(rate, lbnd=-1, scl=0.5))
        slope += legendre.legval(1.0, rate)
        rest, along = w[:, : len(xi)], w[:, len(xi) : -1]
        a, b = _rigid(one.ends, w[:, -1], slope, along @ shares, along @ (shares * nodes))
        found[axis] += rest + a[:, None] + b[:, None] * xi


def _forces_at_places(solution: Samples, beam: Beam) -> list[tuple[np.ndarray, np.ndarray]]:
    """(fraction of the length (N, 1), force in body axes (N, 3)) of what acts at one place between the ends."""
    names = [name for name, places in beam.attached.items() if 0 < places[0] < 1]
    names += [name for name, along in beam.spread.items() if along[2] < 0]
    frame = frame_motion(*(values[:, beam.turning] for values in (solution.q, solution.q_dot, solution.q_ddot)))
    found = []
    for name, generalised in attached_forces(solution, beam.name, [*beam.place, *beam.turning], names):
        if name in names:
            load = wrench(generalised, len(beam.place), frame)
            fixed = beam.attached.get(name)
            s = moving_place(load) / beam.length if fixed is None else np.full(len(load), fixed[0])
            found.append((np.clip(s, 0.0, 1.0)[:, None], load[:, :3]))
    return found


def _rigid(
    ends: str, last: np.ndarray, slope: np.ndarray, mean: np.ndarray, moment: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """a, b (N,) with w + a + b xi as the ends hold it, for w that begins flat at zero.

    last, slope: w and w' at the end; mean, moment: int w and int xi w.
    """
    start, end = ENDS[ends].start, ENDS[ends].end
    none = 0 * last
    rows = [] if start == "free" else [(1.0, 0.0, none)]
    rows += [(0.0, 1.0, none)] if start == "clamped" else []
    rows += [] if end == "free" else [(1.0, 1.0, last)]
    rows += [(0.0, 1.0, slope)] if end == "clamped" else []
    if start == "free":
        rows += [(1 / 2, 1 / 6, mean - moment), (1.0, 1 / 2, mean)]
    else:
        rows += [(1 / 2, 1 / 3, moment)]
    (p, q, u), (r, s, v) = rows[:2]
    return (q * v - s * u) / (p * s - q * r), (r * u - p * v) / (p * s - q * r)
