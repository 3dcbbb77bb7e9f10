"""Motion of a flexible body in space with the forces at its markers, for the recovery of its stresses."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from runtime.contract.errors import ModelError
from runtime.contract.flexible import BodyMotion, MarkerForce
from runtime.contract.model import Model
from runtime.results.attached_forces import attached_forces, attached_markers, into_body, wrench
from runtime.results.frame_motion import frame_motion

if TYPE_CHECKING:
    from runtime.results.samples import Samples


def body_motion(solution: Samples, body: str) -> BodyMotion:
    """Of the flexible body named.

    Raises ModelError for a body without modes or in the plane, and where one joint or load acts on it at two places.
    """
    model = solution.model
    own = [(k, entry.elastic) for k, entry in enumerate(model.description.coordinates) if entry.owner == body]
    frame, elastic = ([k for k, bent in own if bent is kind] for kind in (False, True))
    if not elastic or model.description.drawing.space == "planar" or not model.has("geometry"):
        raise ModelError(f"model {model.name} has no flexible body {body!r} in space whose forces are known")
    moved = solution.q, solution.q_dot, solution.q_ddot
    motion = frame_motion(*(values[:, frame[3:]] for values in moved))
    q_f, q_f_dot, q_f_ddot = (values[:, elastic] for values in moved)
    places, names = _places(model, body, solution.parameters), attached_markers(model, body)
    forces = []
    for name, generalised in attached_forces(solution, body, frame, list(names)):
        marker = _one(name, names[name], body)
        position, shape = places[marker]
        acting = wrench(generalised, 3, motion)
        acting[:, 3:] -= np.cross(position + q_f @ shape.T, acting[:, :3])
        forces.append(MarkerForce(marker, position, acting))
    acceleration = into_body(motion, solution.q_ddot[:, frame[:3]] - np.resize(model.description.gravity or [0.0], 3))
    return BodyMotion(body, solution.t, q_f, q_f_dot, q_f_ddot, acceleration, motion.omega, motion.alpha, forces)


def _places(model: Model, body: str, p: np.ndarray) -> dict[str, tuple[np.ndarray, np.ndarray]]:
    """Marker -> its position (3,) and shapes (3, nf)."""
    values = {key: np.asarray(value) for key, value in model.kernel("geometry")(p=p).items()}
    found, first = {}, 0
    for k, point in enumerate(model.description.drawing.points):
        if point.body == body and point.name:
            shapes = values["shapes"][:, first : first + point.modes]
            found[point.name] = np.array(values["positions"][:, k]), np.array(shapes)
        first += point.modes
    return found


def _one(name: str, markers: list[str], body: str) -> str:
    if len(markers) > 1:
        raise ModelError(f"{name} acts on {body} at two places, whose parts are not told apart; divide the load")
    return markers[0]
