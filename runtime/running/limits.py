"""How far a run was taken: deflection over length, slope, missing shapes, buckling, Euler angles that are singular."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from runtime.contract.model import DrawnPoint
from runtime.contract.records import Description
from runtime.contract.status import Event, Status
from runtime.results.body_motion import poses_of
from runtime.results.missing import missing_sections, missing_shapes, missing_stresses
from runtime.results.singular_angles import singular_angles
from runtime.running.monitor import flexible_bodies
from runtime.solutions.solution import Solution

SAMPLES_AT_ONCE = 1024  # samples


def with_limits(solution: Solution) -> Solution:
    """The solution with what was found in its statistics, in its events, and in its status beyond a buckling load."""
    shares, missing = missing_shapes(solution)
    left_out, unstressed = missing_stresses(solution)
    not_held, unloaded = missing_sections(solution)
    pushed, beyond = buckling(solution)
    events = [*solution.events, *missing, *unstressed, *unloaded, *beyond, *singular_angles(solution)]
    status = (off_a_beam(solution) if solution.status.ok else None) or solution.status
    if beyond and status.ok:
        status = replace(status, cause=beyond[0].text, advice=ADVICE)
    stats = {**solution.stats, **limits(solution), **pushed, **shares, **left_out, **not_held}
    return solution.but(status=status, stats=stats, events=events)


def limits(solution: Solution) -> dict[str, float]:
    """`deflection.body`, largest over its length, and `slope.body` [rad], largest turn, of the saved samples.

    Both are of the body's drawn points against its axes; a run stops beyond the limits of the status
    `deflection_too_large`.
    """
    found = {}
    for name, columns, length, shapes, turns in flexible_bodies(solution.model, solution.parameters):
        q = solution.q[:, columns]
        found[f"deflection.{name}"] = _largest(shapes, q) / length
        found[f"slope.{name}"] = _largest(turns, q)
    return found


def _largest(columns: np.ndarray, q: np.ndarray) -> float:
    """Largest length of columns (points, 3, nf) q over the samples q (N, nf)."""
    blocks = (q[first : first + SAMPLES_AT_ONCE] for first in range(0, len(q), SAMPLES_AT_ONCE))
    sizes = [float(np.square(columns @ block.T).sum(axis=1).max(initial=0.0)) for block in blocks]
    return float(np.sqrt(max(sizes, default=0.0)))


def off_a_beam(solution: Solution) -> Status | None:
    """Where what slides on a beam first was beyond its ends in a saved sample: shapes mean nothing there."""
    model = solution.model
    rails = [joint for joint in model.description.joints if joint.type == "slides_on"]
    if not rails or not (model.has("poses") and model.has("geometry")):
        return None
    (r, A), drawing = poses_of(model, solution.q), model.description.drawing
    points = model.drawn_points(solution.parameters)
    for joint in rails:
        a, beam = drawing.poses.index(joint.body_a), joint.body_a
        length = max(_places(points, beam).values(), key=lambda place: place[0])[0]
        point = _places(points, joint.body_b)[joint.marker_b]
        if joint.body_b in drawing.poses:
            point = r[:, (b := drawing.poses.index(joint.body_b))] + A[:, b] @ point
        distance = np.einsum("sj,sj->s", A[:, a, :, 0], point - r[:, a])
        off = np.flatnonzero((distance < -END * length) | (distance > (1 + END) * length))
        if len(off):
            cause = f"{joint.marker_b} is {distance[off[0]]:.4g} m along {beam}, which is {length:.4g} m long"
            advice = "Start on the beam, and end the run where it is left, by an event on the way along it"
            return Status("off_the_beam", float(solution.t[off[0]]), joint.name, cause, advice)
    return None


# How much of its buckling load each flexible body carried in a run, by the forces that its two ends take.
#
# Of a beam Euler's load pi^2 E I / (K L)^2 of the beam by itself: K = 1 between two ends that are held in place by
# what is attached to them, K = 2 where only one is. Of a finite-element body the like between two of its interfaces,
# from its elements. Against it stands the mean of the normal forces at the two ends, which also serves where the force
# changes along the body: a column between pins buckles under a weight of 18.6 E I / L^2, a mean of 9.3.

END = 1e-9  # of the length: a marker this near to an end is there
MOST_SHARE = 1.0
ADVICE = "Make it stiffer or shorter; stiffening = true follows what happens near the load"
ALONG_Y, ALONG_Z = 1, 2  # axes of deflections


class Strut(NamedTuple):
    """A body as a strut: its markers at the two ends, the line between them in its axes, its critical load [N]."""

    body: str
    start: set[str]
    end: set[str]
    line: np.ndarray
    critical: float


class Acting(NamedTuple):
    """A joint or load: world forces (N, 2 or 3) that it puts on its marker b, and the signs at all of its markers."""

    signs: dict[str, float]
    force: np.ndarray


def buckling(solution: Solution) -> tuple[dict[str, float], list[Event]]:
    """`buckling.body`, largest compression over the critical load of each flexible body; in words beyond 1."""
    model = solution.model
    if not model.elastic or not model.has("geometry"):
        return {}, []
    points = model.drawn_points(solution.parameters)
    rigidities = model.geometry(solution.parameters).get("rigidities", np.zeros(0))  # none without beams
    struts = [*beam_struts(model.description, points, rigidities), *element_struts(model.description, points)]
    acting = acting_forces(solution) if struts else []
    shares: dict[str, float] = {}
    events: dict[str, Event] = {}
    for strut in struts:
        share = np.maximum(0.0, -mean_normal_force(solution, strut, acting)) / strut.critical
        largest, key = int(share.argmax()), f"buckling.{strut.body}"
        if share[largest] < shares.get(key, 0.0):
            continue
        shares[key] = float(share[largest])
        if share[largest] > MOST_SHARE:
            text = (
                f"{strut.body} is pushed with {share[largest]:.2g} of its buckling load, which a straight body does "
                "not carry for long and of which its model knows nothing without stiffening"
            )
            events[key] = Event(float(solution.t[largest]), "beyond_buckling", text)
    return shares, list(events.values())


def beam_struts(described: Description, points: Sequence[DrawnPoint], rigidities: np.ndarray) -> Iterator[Strut]:
    """Beams, whatever their shapes; rigidities: of `geometry`."""
    stiffness = rigidities.reshape(2, -1)
    for k, body in enumerate(described.drawing.sections):
        moved = np.sum([np.abs(one.shapes).sum(axis=1) for one in points if one.body == body], axis=0)
        weakest = min((float(stiffness[axis - 1, k]) for axis in (ALONG_Y, ALONG_Z) if moved[axis] > 0.0), default=None)
        if weakest is None:
            continue
        places = {name: float(place[0]) for name, place in _places(points, body).items()}
        length = max(places.values())
        start = {marker for marker, x in places.items() if x <= END * length}
        end = {marker for marker, x in places.items() if x >= (1 - END) * length}
        held = [is_held(described, body, markers) for markers in (start, end)]
        effective = length * (2.0 if sum(held) == 1 else 1.0)
        yield Strut(body, start, end, np.eye(3)[0], math.pi**2 * weakest / effective**2)


def element_struts(described: Description, points: Sequence[DrawnPoint]) -> Iterator[Strut]:
    """Finite-element bodies between two of their interfaces."""
    for record in described.struts:
        places = _places(points, record.body)
        first, second = (places[f"{record.body}.{name}"] for name in record.markers)
        apart = second - first
        length = float(np.linalg.norm(apart))
        start, end = (
            {marker for marker, place in places.items() if np.linalg.norm(place - at) <= END * length}
            for at in (first, second)
        )
        at_start, at_end = (is_held(described, record.body, markers) for markers in (start, end))
        critical = record.held if at_start == at_end else record.first if at_start else record.second
        if critical > 0.0:
            yield Strut(record.body, start, end, apart / length, critical)


def _places(points: Sequence[DrawnPoint], body: str) -> dict[str, np.ndarray]:
    """Reference of each point of a body -> its place (3,) [m]."""
    return {f"{body}.{one.name}": one.place for one in points if one.body == body}


def is_held(described: Description, body: str, markers: set[str]) -> bool:
    """Do joints at these markers lead to the ground by a way that does not pass through the body?"""
    joints = [(one.body_a, one.body_b, {one.marker_a, one.marker_b} & markers) for one in described.joints]
    reached = {other for a, b, here in joints if here for other in (a, b) if other != body}
    while "ground" not in reached:
        more = {other for a, b, _ in joints if body not in (a, b) and {a, b} & reached for other in (a, b)} - reached
        if not more:
            return False
        reached |= more
    return True


def acting_forces(solution: Solution) -> list[Acting]:
    """Of all joints and loads."""
    described, dimension = solution.model.description, 2 if solution.joint_forces.shape[2] == 3 else 3
    columns = {name: k for k, name in enumerate(solution.model.joints)}
    return [
        Acting({one.marker_a: -1.0, one.marker_b: 1.0}, solution.joint_forces[:, columns[one.name], :dimension])
        for one in described.joints
        if one.name in columns
    ] + [
        Acting(
            {name: -1.0 if role in ("marker_a", "reaction") else 1.0 for role, name in load.markers.items()},
            solution.load_forces[:, k, :dimension],
        )
        for k, load in enumerate(described.loads)
    ]


def mean_normal_force(solution: Solution, strut: Strut, acting: list[Acting]) -> np.ndarray:
    """(N,) mean of the normal forces at the two ends [N], tension positive, by what joints and loads do there."""
    described, dimension = solution.model.description, 2 if solution.joint_forces.shape[2] == 3 else 3
    frame = [k for k, one in enumerate(described.coordinates) if one.owner == strut.body and not one.elastic]
    turning = (values[:, frame[dimension:]] for values in (solution.q, solution.q_dot, solution.q_ddot))
    from runtime.results.body_motion import frame_motion

    along = frame_motion(*turning).A[:, :dimension] @ strut.line
    total = np.zeros(len(solution.t))
    for signs, force in acting:
        for marker, sign in signs.items():
            pull = float(marker in strut.end) - float(marker in strut.start)
            if pull:
                total += 0.5 * pull * sign * np.einsum("si,si->s", force, along)
    return total
