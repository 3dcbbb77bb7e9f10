"""Bodies with the points that show them, from the emitted functions `poses` and `geometry` of a model."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from runtime.contract.errors import ModelError
from runtime.contract.model import Model
from runtime.views.mechanism.solids import Solid, solid

GROUND = "ground"


@dataclass(frozen=True, eq=False)
class Points:
    """n points of a body with nf modes, in its axes: rho = position + shapes q_f - 1/2 q_f^T H q_f e_x.

    position (n, 3) [m]; axes (n, 3, 3): columns are the marker's axes; shapes, turns (n, 3, nf): displacement and
    rotation by each mode; H (n, nf, nf) [1/m]: foreshortening.
    """

    names: list[str]
    position: np.ndarray
    axes: np.ndarray
    shapes: np.ndarray
    turns: np.ndarray
    H: np.ndarray

    def linear(self, q_f: np.ndarray) -> np.ndarray:
        """(frames, n, 3) displacement shapes q_f [m] for q_f (frames, nf)."""
        return np.asarray(np.einsum("kia,fa->fki", self.shapes, q_f))

    def shortening(self, q_f: np.ndarray) -> np.ndarray:
        """(frames, n, 3) displacement -1/2 q_f^T H q_f along x [m]."""
        along = -0.5 * np.einsum("fa,kab,fb->fk", q_f, self.H, q_f)
        return np.stack([along, np.zeros_like(along), np.zeros_like(along)], axis=-1)


@dataclass(frozen=True, eq=False)
class Body:
    """One body: its column in `poses` (None for the ground), its q_f in q, its points.

    stations: along the axis of a beam, otherwise none; markers: by name; section: (height, width) of a beam [m];
    solid: the shapes that the scene gives it, surface: the triangles of a finite-element body (vertices, triangles,
    shapes, stresses), if any.
    """

    name: str
    pose: int | None
    elastic: list[int]
    stations: Points
    markers: Points
    section: tuple[float, float] | None
    solid: Solid | None = None
    surface: dict[str, np.ndarray] | None = None

    def skin(self, places: np.ndarray | slice = slice(None)) -> Points:
        """These vertices of the surface; none without one. Foreshortening of the surface is left out."""
        nf, none = len(self.elastic), np.zeros((0, 3))
        if self.surface is None:
            return Points(
                [], none, np.zeros((0, 3, 3)), np.zeros((0, 3, nf)), np.zeros((0, 3, nf)), np.zeros((0, nf, nf))
            )
        position, shapes = (np.asarray(self.surface[key], dtype=float)[places] for key in ("vertices", "shapes"))
        n = len(position)
        return Points([""] * n, position, np.zeros((0, 3, 3)), shapes, np.zeros((0, 3, nf)), np.zeros((n, nf, nf)))


def bodies(model: Model, p: np.ndarray) -> list[Body]:
    """All bodies that have points, the ground among them, for the parameters p (n_p,).

    Raises ModelError if the model has nothing to draw.
    """
    if not model.has("geometry"):
        raise ModelError(
            f"model {model.name} has no drawing (a structure without bodies, a model generated without it, or a "
            "solution loaded without its model)"
        )
    record = model.drawing
    values = {key: np.asarray(value) for key, value in model.kernel("geometry")(p=p).items()}
    points = _points(record["points"], values)
    surfaces = {one.body: one for one in model.description.drawing.surfaces}
    sections = dict(zip(record["sections"], np.reshape(values.get("sections", ()), (2, -1)).T, strict=True))
    found = []
    for name in dict.fromkeys(entry["body"] for entry in record["points"]):
        own = [k for k, entry in enumerate(record["points"]) if entry["body"] == name]
        stations = [k for k in own if not record["points"][k]["name"]]
        markers = [k for k in own if record["points"][k]["name"]]
        elastic = [
            column
            for column, entry in enumerate(model.description.coordinates)
            if entry.elastic and entry.owner == name
        ]
        pose = record["poses"].index(name) if name in record["poses"] else None
        section = tuple(sections[name]) if name in sections else None
        nf = len(elastic)
        shapes = [shape for shape in model.description.drawing.shapes if shape.body == name]
        look = solid(shapes) if shapes else None
        at, named = _picked(points, stations, nf), _picked(points, markers, nf)
        surface = surfaces[name].arrays() if name in surfaces else None
        found.append(Body(name, pose, elastic, at, named, section, look, surface))
    return found


Row = tuple[str, np.ndarray, np.ndarray, np.ndarray, np.ndarray, np.ndarray]


def _points(entries: list[dict[str, object]], values: dict[str, np.ndarray]) -> list[Row]:
    """Name, position, axes, shapes, turns, H of each point of the record."""
    shapes, turns = (values.get(key, np.zeros((3, 0))) for key in ("shapes", "turns"))
    H = values.get("H", np.zeros((1, 0))).ravel()
    rows, mode, place = [], 0, 0
    for k, entry in enumerate(entries):
        nf = int(str(entry["modes"]))
        own = slice(mode, mode + nf)
        bent = np.zeros((nf, nf))
        if entry["stiffened"]:
            bent, place = H[place : place + nf * nf].reshape(nf, nf), place + nf * nf
        axes = values["axes"][:, k].reshape(3, 3).T
        rows.append((str(entry["name"]), values["positions"][:, k], axes, shapes[:, own], turns[:, own], bent))
        mode += nf
    return rows


def _picked(rows: list[Row], chosen: list[int], nf: int) -> Points:
    n = len(chosen)
    columns = list(zip(*(rows[k] for k in chosen), strict=True)) if chosen else [()] * 6
    shape = ((n, 3), (n, 3, 3), (n, 3, nf), (n, 3, nf), (n, nf, nf))
    arrays = [np.array(column, dtype=float).reshape(size) for column, size in zip(columns[1:], shape, strict=True)]
    return Points([str(name) for name in columns[0]], *arrays)
