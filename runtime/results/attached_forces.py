"""What the joints and loads of a body do to it, as forces on the coordinates of its frame and as wrenches."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from runtime.contract.model import Model
from runtime.results.frame_motion import FrameMotion
from runtime.results.sampling import evaluate

if TYPE_CHECKING:
    from runtime.results.samples import Samples

LONGEST = 256  # samples at once


def attached_markers(model: Model, body: str) -> dict[str, list[str]]:
    """Joints and loads on a body -> the names of their markers on it."""
    described, found = model.description, {}
    markers = {f"{body}.{marker}": marker for one in described.bodies if one.name == body for marker in one.markers}
    pairs = [(joint.name, [joint.marker_a, joint.marker_b]) for joint in described.joints]
    acting = {name for owner, name in described.load_columns if owner == body}
    pairs += [(load.name, list(load.markers.values())) for load in described.loads if load.name in acting]
    for name, references in pairs:
        own = [markers[one] for one in references if one in markers]
        if own:
            found[name] = own
    return found


def attached_forces(
    solution: Samples, body: str, frame: Sequence[int], names: Sequence[str]
) -> list[tuple[str, np.ndarray]]:
    """(name, force on the frame's coordinates (N, .)) of each joint and load; frame: columns in q.

    A name comes twice where a joint has friction.
    """
    model, N = solution.model, len(solution.t)
    values = {"q": solution.q, "q_dot": solution.q_dot, "t": solution.t[:, None]}
    c = model.constants(solution.parameters)
    rows = {name: [k for k, row in enumerate(model.description.constraints) if row.joint == name] for name in names}
    acting = {name: np.zeros((N, len(frame))) for name, own in rows.items() if own}
    n_c, n = len(model.constraints), len(model.coordinates)
    for first in range(0, N if acting else 0, LONGEST):
        some = {key: value[first : first + LONGEST] for key, value in values.items()}
        C_q = evaluate(model.kernel("constraints"), some, c)["C_q"].reshape(-1, n, n_c)
        lam = solution.lam[first : first + LONGEST]
        for name, force in acting.items():
            part = np.einsum("sir,sr->si", C_q[:, list(frame)][:, :, rows[name]], lam[:, rows[name]])
            force[first : first + LONGEST] = -part
    found = list(acting.items())
    columns = model.description.load_columns
    if any(owner == body for owner, _ in columns):
        forces = evaluate(model.kernel("load_forces"), values, c)["load_forces"].reshape(N, len(columns), -1)
        found += [(name, forces[:, k]) for k, (owner, name) in enumerate(columns) if owner == body]
    return found


def wrench(generalised: np.ndarray, dimension: int, frame: FrameMotion) -> np.ndarray:
    """(N, 6) force and moment about the frame origin, in body axes, of forces on its frame's coordinates (N, .)."""
    world = vectors(generalised[:, :dimension])
    turning = generalised[:, dimension : dimension + frame.W.shape[2]]
    return np.hstack([into_body(frame, world), frame.moment(turning)])


def vectors(values: np.ndarray) -> np.ndarray:
    """(N, 3) from x and y, or x, y and z."""
    return np.pad(values, ((0, 0), (0, 3 - values.shape[1])))


def into_body(frame: FrameMotion, world: np.ndarray) -> np.ndarray:
    """(N, 3) components in body axes."""
    return np.asarray(np.einsum("sji,sj->si", frame.A, world))
