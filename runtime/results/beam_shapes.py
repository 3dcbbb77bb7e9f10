"""A beam of a model with its shapes and stiffnesses, as its results need them (Eqs. 15-20)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from runtime.contract.errors import ModelError
from runtime.contract.flexible import ShapeFunctions, bending_shapes, gauss_points, panels_for, stretching_shapes
from runtime.contract.model import Model
from runtime.results.attached_forces import attached_markers

STRETCHING, ALONG_Y, ALONG_Z, TORSION = range(4)
BENDING = (ALONG_Y, ALONG_Z)


@dataclass(frozen=True, eq=False)
class BeamShapes:
    """Shapes of one direction: their columns in q.

    stiffness: E I / L^3 [N/m], of stretching E A / L [N/m], of torsion G J / L [N m].
    """

    columns: list[int]
    functions: ShapeFunctions
    stiffness: float


@dataclass(frozen=True, eq=False)
class Beam:
    """place, turning: columns in q of R_o and of the orientation.

    length [m], mass [kg]; radii (2,): I / A [m^2] of the section along y and z; sets: shapes by axis (x, y, z, 3 for
    torsion). stiffened: are bent beams shorter? attached: its joints and loads, with the places xi of their markers.
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

    @property
    def planar(self) -> bool:
        """Does it bend in one plane only?"""
        return len(self.turning) == 1


def beam_of(model: Model, name: str, p: np.ndarray) -> Beam:
    """The beam `name` for the parameters p (n_p,).

    Raises ModelError if the model has no such beam with exact shapes, or no functions.
    """
    records = {record.body: record for record in model.description.beams}
    if name not in records:
        raise ModelError(
            f"model {model.name} has no beam {name!r} with exact shapes; it has {', '.join(records) or 'none'} "
            '(a beam with mesh = "lumped" or elements has no shapes in closed form)'
        )
    if not (model.has("geometry") and model.has("augmented")):
        raise ModelError(f"model {model.name} has no functions geometry and augmented; generate it with all functions")
    described = model.description
    own = [(k, entry.elastic) for k, entry in enumerate(described.coordinates) if entry.owner == name]
    frame, elastic = ([k for k, bent in own if bent is kind] for kind in (False, True))
    dimension = 2 if described.drawing.space == "planar" else 3
    geometry = {key: np.asarray(value) for key, value in model.kernel("geometry")(p=p).items()}
    points = [
        (point, float(x))
        for point, x in zip(described.drawing.points, geometry["positions"][0], strict=True)
        if point.body == name
    ]
    length = max(x for _, x in points)
    sides = geometry["sections"].reshape(2, -1)[:, described.drawing.sections.index(name)]
    n = len(model.coordinates)
    values = model.evaluate("augmented", q=np.zeros(n), q_dot=np.zeros(n), t=0.0, c=model.constants(p))
    M, K = np.asarray(values["M"]), np.asarray(values["K"])
    sets: dict[int, BeamShapes] = {}
    for one in records[name].sets:
        mine, elastic = elastic[: one.modes], elastic[one.modes :]
        functions, eigenvalues = (bending_shapes if one.axis in BENDING else stretching_shapes)(one.ends, one.modes)
        xi, weights = gauss_points(panels_for(one.modes))
        square = float(weights @ functions.at(xi)[:, 0] ** 2)
        sets[one.axis] = BeamShapes(mine, functions, float(K[mine[0], mine[0]] / (eigenvalues[0] * square)))
    places = {point.name: x / length for point, x in points if point.name}
    return Beam(
        name,
        frame[:dimension],
        frame[dimension:],
        length,
        float(M[frame[0], frame[0]]),
        sides**2 / 12,
        sets,
        any(point.stiffened for point, _ in points),
        {load: [places[marker] for marker in own] for load, own in attached_markers(model, name).items()},
    )
