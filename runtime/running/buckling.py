"""How much of its buckling load each beam carried in a run, by the forces that its two ends take.

Euler's load pi^2 E I / (K L)^2 of the beam by itself: K = 1 between two ends that are held in place by what is attached
to them, K = 2 where only one is. Against it stands the mean of the normal forces at the two ends, which also serves
where the force changes along the beam: a column between pins buckles under a weight of 18.6 E I / L^2, a mean of 9.3.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import NamedTuple

import numpy as np

from runtime.contract.records import Description
from runtime.contract.status import Event
from runtime.results.frame_motion import frame_motion
from runtime.results.solution import Solution

END = 1e-9  # of the length: a marker this near to an end is there
MOST_SHARE = 1.0
ADVICE = "Make it stiffer or shorter; stiffening = true follows what happens near the load"
BENDING = (1, 2)  # axes of deflections


class Strut(NamedTuple):
    """A beam as a strut: its markers at the start and the end, and its Euler load [N]."""

    start: set[str]
    end: set[str]
    critical: float


class Acting(NamedTuple):
    """A joint or load: world forces (N, 2 or 3) that it puts on its marker b, and the signs at all of its markers."""

    signs: dict[str, float]
    force: np.ndarray


def buckling(solution: Solution) -> tuple[dict[str, float], list[Event]]:
    """`buckling.body`, largest compression over Euler's load of each beam with exact shapes; in words beyond 1."""
    model = solution.model
    bending = {one.body: [own.axis for own in one.sets if own.axis in BENDING] for one in model.description.beams}
    if not any(bending.values()) or not model.has("geometry"):
        return {}, []
    shares, events = {}, []
    geometry = {key: np.asarray(value) for key, value in model.kernel("geometry")(p=solution.parameters).items()}
    acting = acting_forces(solution) if "rigidities" in geometry else []
    for body, axes in bending.items():
        if not axes or "rigidities" not in geometry:  # a model that was generated before there were any
            continue
        strut = strut_of(model.description, body, axes, geometry)
        share = np.maximum(0.0, -mean_normal_force(solution, body, strut, acting)) / strut.critical
        largest = int(share.argmax())
        shares[f"buckling.{body}"] = float(share[largest])
        if share[largest] > MOST_SHARE:
            text = (
                f"{body} is pushed with {share[largest]:.2g} of its buckling load, which a straight beam does not "
                "carry for long and of which its model knows nothing without stiffening"
            )
            events.append(Event(float(solution.t[largest]), "beyond_buckling", text))
    return shares, events


def strut_of(described: Description, body: str, axes: list[int], geometry: Mapping[str, np.ndarray]) -> Strut:
    """The beam as a strut that bends along these axes; geometry: what the function of that name gives."""
    places = {
        f"{body}.{point.name}": float(x)
        for point, x in zip(described.drawing.points, geometry["positions"][0], strict=True)
        if point.body == body
    }
    length = max(places.values())
    start = {marker for marker, x in places.items() if x <= END * length}
    end = {marker for marker, x in places.items() if x >= (1 - END) * length}
    held = [is_held(described, body, markers) for markers in (start, end)]
    stiffness = geometry["rigidities"].reshape(2, -1)[:, described.drawing.sections.index(body)]
    weakest = min(float(stiffness[axis - 1]) for axis in axes)
    effective = length * (2.0 if sum(held) == 1 else 1.0)
    return Strut(start, end, math.pi**2 * weakest / effective**2)


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
            {name: -1.0 if role == "marker_a" else 1.0 for role, name in load.markers.items()},
            solution.load_forces[:, k, :dimension],
        )
        for k, load in enumerate(described.loads)
    ]


def mean_normal_force(solution: Solution, body: str, strut: Strut, acting: list[Acting]) -> np.ndarray:
    """(N,) mean of the normal forces at the two ends [N], tension positive, by what joints and loads do there."""
    described, dimension = solution.model.description, 2 if solution.joint_forces.shape[2] == 3 else 3
    frame = [k for k, one in enumerate(described.coordinates) if one.owner == body and not one.elastic]
    orientation = next(one.orientation for one in described.bodies if one.name == body)
    turning = (values[:, frame[dimension:]] for values in (solution.q, solution.q_dot, solution.q_ddot))
    along = frame_motion(orientation, *turning).A[:, :dimension, 0]
    total = np.zeros(len(solution.t))
    for signs, force in acting:
        for marker, sign in signs.items():
            pull = float(marker in strut.end) - float(marker in strut.start)
            if pull:
                total += 0.5 * pull * sign * np.einsum("si,si->s", force, along)
    return total
