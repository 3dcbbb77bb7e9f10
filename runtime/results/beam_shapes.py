"""A planar beam of a model with its shapes and stiffnesses, as its results need them (Eqs. 15-20)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from runtime.contract.beams import ShapeFunctions, bending_shapes, gauss_points, panels_for, stretching_shapes
from runtime.contract.model import Model, ModelError

STRETCHING_AXIS = 0


@dataclass(frozen=True, eq=False)
class BeamShapes:
    """Shapes of one direction: their columns in q; stiffness: E I / L^3 [N/m], of stretching E A / L [N/m]."""

    columns: list[int]
    functions: ShapeFunctions
    stiffness: float


@dataclass(frozen=True, eq=False)
class Beam:
    """frame: columns of x, y, theta in q; length [m], mass [kg]; its sets, None where there are none; stiffened or not.

    attached: the names of its joints and loads with the place xi of their markers on it, [0, 1].
    """

    name: str
    frame: list[int]
    length: float
    mass: float
    bending: BeamShapes | None
    stretching: BeamShapes | None
    stiffened: bool
    attached: dict[str, list[float]]


def beam_of(model: Model, name: str, p: np.ndarray) -> Beam:
    """The beam `name` for the parameters p (n_p,).

    Raises ModelError if the model has no such beam with exact shapes in the plane, or no functions.
    """
    records = {record.body: record for record in model.description.beams}
    if name not in records:
        raise ModelError(
            f"model {model.name} has no planar beam {name!r} with exact shapes; it has {', '.join(records) or 'none'} "
            '(a beam with mesh = "lumped" or elements has no shapes in closed form)'
        )
    if not (model.has("geometry") and model.has("augmented")):
        raise ModelError(f"model {model.name} has no functions geometry and augmented; generate it with all functions")
    columns = [k for k, one in enumerate(model.description.coordinates) if one.owner == name]
    frame, elastic = columns[:3], columns[3:]
    positions = np.asarray(model.kernel("geometry")(p=p)["positions"])
    points = list(zip(model.description.drawing.points, positions[0], strict=True))
    own = [(point, float(x)) for point, x in points if point.body == name]
    length = max(x for _, x in own)
    n = len(model.coordinates)
    c = model.constants(p)
    values = model.evaluate("augmented", q=np.zeros(n), q_dot=np.zeros(n), t=0.0, c=c)
    M, K = np.asarray(values["M"]), np.asarray(values["K"])
    sets: dict[int, BeamShapes] = {}
    for one in records[name].sets:
        mine, elastic = elastic[: one.modes], elastic[one.modes :]
        functions, eigenvalues = (stretching_shapes if one.axis == STRETCHING_AXIS else bending_shapes)(
            one.ends, one.modes
        )
        xi, weights = gauss_points(panels_for(one.modes))
        square = float(weights @ functions.at(xi)[:, 0] ** 2)
        sets[one.axis] = BeamShapes(mine, functions, float(K[mine[0], mine[0]] / (eigenvalues[0] * square)))
    places = {f"{name}.{point.name}": x / length for point, x in own if point.name}
    return Beam(
        name,
        frame,
        length,
        float(M[frame[0], frame[0]]),
        next((found for axis, found in sets.items() if axis != STRETCHING_AXIS), None),
        sets.get(STRETCHING_AXIS),
        any(point.stiffened for point, _ in own),
        _attached(model, records[name].loads, places),
    )


def _attached(model: Model, loads: Sequence[str], places: dict[str, float]) -> dict[str, list[float]]:
    """Joints and loads on the beam -> the places of their markers on it."""
    described, found = model.description, {}
    for joint in described.joints:
        found[joint.name] = [places[one] for one in (joint.marker_a, joint.marker_b) if one in places]
    for load in described.loads:
        if load.name in loads:
            found[load.name] = [places[one] for one in load.markers.values() if one in places]
    return {name: where for name, where in found.items() if where}
