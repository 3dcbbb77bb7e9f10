"""Boxes, cylinders, balls and meshes that stand for a rigid body: triangles for the page, edges for films."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from runtime.contract.errors import ModelError
from runtime.contract.model import EmittedModel
from runtime.contract.orientations import tilde
from runtime.contract.records import ShapeRecord
from runtime.results.body_motion import poses_of

if TYPE_CHECKING:
    from runtime.solutions.solution import Solution

AROUND = 48  # sides of a cylinder, and of a ball
RINGS = 12
SHARP = np.cos(np.radians(30.0))  # two triangles that meet at a larger angle have an edge between them
BOX_FACES = ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5))


@dataclass(frozen=True, eq=False)
class Solid:
    """vertices (n, 3) [m] in the body's axes; triangles (m, 3): three vertices each, seen from outside.

    circles (k, 2, 3): ends of the strokes of the great circles of its balls, which have no edges.
    """

    vertices: np.ndarray
    triangles: np.ndarray
    circles: np.ndarray

    def edges(self) -> np.ndarray:
        """(k, 2, 3) ends of the sharp edges, and circles [m]."""
        return np.concatenate([self.vertices[sharp_edges(self.vertices, self.triangles)], self.circles])


def sharp_edges(vertices: np.ndarray, triangles: np.ndarray) -> np.ndarray:
    """(k, 2) places of the ends of every edge where the surface bends by more than 30 degrees, or stops."""
    corners = vertices[triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-300)
    sides = np.sort(np.concatenate([triangles[:, [a, b]] for a, b in ((0, 1), (1, 2), (2, 0))]), axis=1)
    owner = np.tile(np.arange(len(triangles)), 3)
    order = np.lexsort((sides[:, 1], sides[:, 0]))
    sides, owner = sides[order], owner[order]
    pair = np.flatnonzero(np.all(sides[1:] == sides[:-1], axis=1))
    smooth = np.abs(np.einsum("ij,ij->i", normals[owner[pair]], normals[owner[pair + 1]])) > SHARP
    drop = np.zeros(len(sides), dtype=bool)
    drop[pair + 1] = True
    drop[pair[smooth]] = True
    return np.asarray(sides[~drop])


def solid(shapes: list[ShapeRecord]) -> Solid:
    """All shapes of a body as one set of triangles."""
    vertices, triangles, circles, count = [], [], [np.zeros((0, 2, 3))], 0
    for shape in shapes:
        own, faces = _FORMS[shape.type](shape)
        vertices.append(np.array(shape.position) + own @ np.array(shape.axes).T)
        triangles.append(faces + count)
        count += len(own)
        if shape.type == "sphere":
            circles.append(np.array(shape.position) + _circles(shape.size[0]) @ np.array(shape.axes).T)
    return Solid(np.concatenate(vertices), np.concatenate(triangles), np.concatenate(circles))


def _circles(radius: float) -> np.ndarray:
    angle = 2 * np.pi * np.arange(AROUND + 1) / AROUND
    round_z = radius * np.column_stack([np.cos(angle), np.sin(angle), 0 * angle])
    strokes = np.stack([round_z[:-1], round_z[1:]], axis=1)
    return np.concatenate([np.roll(strokes, k, axis=2) for k in range(3)])


def _box(shape: ShapeRecord) -> tuple[np.ndarray, np.ndarray]:
    signs = np.array([[x, y, z] for z in (-1, 1) for y in (-1, 1) for x in (-1, 1)])
    faces = [part for a, b, c, d in BOX_FACES for part in ((a, b, c), (a, c, d))]
    return signs * np.array(shape.size) / 2, np.array(faces)


def _cylinder(shape: ShapeRecord) -> tuple[np.ndarray, np.ndarray]:
    radius, length = shape.size
    angle = 2 * np.pi * np.arange(AROUND) / AROUND
    ring = np.column_stack([radius * np.cos(angle), radius * np.sin(angle), np.zeros(AROUND)])
    end = np.array([0.0, 0.0, length / 2])
    here, there = np.arange(AROUND), (np.arange(AROUND) + 1) % AROUND
    low, high = 2 * AROUND, 2 * AROUND + 1  # the middles of the ends
    faces = [(here, there, AROUND + there), (here, AROUND + there, AROUND + here)]
    faces += [(there, here, np.full(AROUND, low)), (AROUND + here, AROUND + there, np.full(AROUND, high))]
    return np.vstack([ring - end, ring + end, -end, end]), np.concatenate([np.column_stack(face) for face in faces])


def _sphere(shape: ShapeRecord) -> tuple[np.ndarray, np.ndarray]:
    polar, around = np.pi * np.arange(RINGS + 1) / RINGS, 2 * np.pi * np.arange(AROUND) / AROUND
    grid = np.stack(
        [
            np.outer(np.sin(polar), np.cos(around)),
            np.outer(np.sin(polar), np.sin(around)),
            np.outer(np.cos(polar), np.ones(AROUND)),
        ],
        axis=-1,
    )
    a, b = (part.ravel() for part in np.meshgrid(np.arange(RINGS), np.arange(AROUND), indexing="ij"))
    corner = a * AROUND + b, (a + 1) * AROUND + b, (a + 1) * AROUND + (b + 1) % AROUND, a * AROUND + (b + 1) % AROUND
    upper, lower = (np.column_stack([corner[i], corner[j], corner[k]]) for i, j, k in ((0, 1, 2), (0, 2, 3)))
    return shape.size[0] * grid.reshape(-1, 3), np.concatenate([upper[a < RINGS - 1], lower[a > 0]])  # poles are points


def _mesh(shape: ShapeRecord) -> tuple[np.ndarray, np.ndarray]:
    return np.array(shape.vertices), np.array(shape.triangles)


_FORMS = {"box": _box, "cylinder": _cylinder, "sphere": _sphere, "mesh": _mesh}


# ---- Bodies with the points that show them, from the emitted functions `poses` and `geometry` of a model.

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


def bodies(model: EmittedModel, p: np.ndarray) -> list[Body]:
    """All bodies that have points, the ground among them, for the parameters p (n_p,).

    Raises ModelError if the model has nothing to draw.
    """
    if not model.has("geometry"):
        raise ModelError(
            f"model {model.name} has no drawing (a structure without bodies, a model generated without it, or a "
            "solution loaded without its model)"
        )
    record = model.drawing
    values = model.geometry(p)
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
        H_own = np.zeros((nf, nf))
        if entry["stiffened"]:
            H_own, place = H[place : place + nf * nf].reshape(nf, nf), place + nf * nf
        axes = values["axes"][:, k].reshape(3, 3).T
        rows.append((str(entry["name"]), values["positions"][:, k], axes, shapes[:, own], turns[:, own], H_own))
        mode += nf
    return rows


def _picked(rows: list[Row], chosen: list[int], nf: int) -> Points:
    n = len(chosen)
    columns = list(zip(*(rows[k] for k in chosen), strict=True)) if chosen else [()] * 6
    shape = ((n, 3), (n, 3, 3), (n, 3, nf), (n, 3, nf), (n, nf, nf))
    arrays = [np.array(column, dtype=float).reshape(size) for column, size in zip(columns[1:], shape, strict=True)]
    return Points([str(name) for name in columns[0]], *arrays)


# ---- Deformation shown larger than it is, without a gap at any joint.
#
# Multiplying q_f alone moves a body's pins off their partners. Of the deformation u = Phi q_f, the part that the
# body's joint markers make is therefore shown as it is, and only the rest is multiplied:
#
#     shown = follow + s (u - follow),   follow(x) = a + b x x + sum_k w_k(x) r_k
#
# a and b are the small rigid motion that fits the joint markers best (one marker: its own displacement and
# rotation), r_k what remains at marker k, and w_k weights that are 1 at marker k, 0 at the others and sum up to 1
# between them.

SAME_POINT = 1e-9  # of the body's size: points this close are one


@dataclass(frozen=True, eq=False)
class Following:
    """What the joint markers of a body make of its deformation, linear in q_f (nf).

    rigid (6, nf): a, then b; at (K, 3): the markers' positions [m]; rest (K, 3, nf): r_k.
    """

    rigid: np.ndarray
    at: np.ndarray
    rest: np.ndarray

    def weights(self, position: np.ndarray) -> np.ndarray:
        """(n, K) weights of the markers at the positions (n, 3): by inverse squares of the distance."""
        if not len(self.at):
            return np.zeros((len(position), 0))
        squares = ((position[:, None, :] - self.at[None]) ** 2).sum(axis=2)
        near = (SAME_POINT * max(float(np.ptp(self.at, axis=0).max()), 1e-6)) ** 2
        inverse = 1.0 / np.maximum(squares, near)
        return np.asarray(inverse / inverse.sum(axis=1, keepdims=True))

    def displacement(self, position: np.ndarray, q_f: np.ndarray) -> np.ndarray:
        """(frames, n, 3) follow at the positions (n, 3) for q_f (frames, nf)."""
        a, b = self.rigid[:3] @ q_f.T, self.rigid[3:] @ q_f.T  # (3, frames)
        moved = a.T[:, None, :] + np.cross(b.T[:, None, :], position[None])
        left = np.einsum("kia,fa->fki", self.rest, q_f)
        return np.asarray(moved + np.einsum("nk,fki->fni", self.weights(position), left))


def following(markers: Points, joints: list[int]) -> Following:
    """The motion that the markers at the places `joints` make; nothing without any."""
    nf = markers.shapes.shape[2]
    at, shapes = markers.position[joints], markers.shapes[joints]
    if not joints or not nf:
        return Following(np.zeros((6, nf)), np.zeros((0, 3)), np.zeros((0, 3, nf)))
    if len(joints) == 1:
        b = markers.turns[joints[0]]
        rigid = np.vstack([shapes[0] - np.cross(b.T, at[0]).T, b])
    else:
        rows = np.vstack([np.hstack([np.eye(3), -tilde(x)]) for x in at])
        rigid = np.linalg.lstsq(rows, shapes.reshape(-1, nf), rcond=1e-9)[0]
    fitted = np.einsum("kij,ja->kia", np.stack([np.hstack([np.eye(3), -tilde(x)]) for x in at]), rigid)
    return Following(rigid, at, shapes - fitted)


def exaggerated(points: Points, follow: Following, q_f: np.ndarray, factor: float) -> np.ndarray:
    """(frames, n, 3) where the points are in the body's axes, its deformation multiplied by `factor` [m].

    The foreshortening, which is of second order, is shown as it is; a factor of 0 gives the undeformed body.
    """
    if factor == 0.0:
        return np.repeat(points.position[None], len(q_f), axis=0)
    followed = follow.displacement(points.position, q_f)
    return np.asarray(points.position + followed + factor * (points.linear(q_f) - followed) + points.shortening(q_f))


# ---- All that moves in a picture: bodies with poses over time, joints and loads at their points.

VISIBLE = 0.05  # the largest deformation becomes this part of the mechanism's size


@dataclass(frozen=True, eq=False)
class Scenery:
    """A mechanism at the times t (frames,) [s].

    q (frames, n); origin (frames, bodies, 3) [m] and turn (frames, bodies, 3, 3): the poses in the order of
    model.drawing["poses"]; follow: of each body, what its joints show of its deformation.
    """

    model: EmittedModel
    t: np.ndarray
    q: np.ndarray
    origin: np.ndarray
    turn: np.ndarray
    bodies: list[Body]
    follow: list[Following]

    @property
    def joints(self) -> Sequence[Mapping[str, Any]]:
        """Name, type, marker_a and marker_b of each joint."""
        return list(self.model.drawing["joints"])

    @property
    def loads(self) -> Sequence[Mapping[str, Any]]:
        """Name, type and markers of each load."""
        return list(self.model.drawing["loads"])

    def q_f(self, body: Body) -> np.ndarray:
        """(frames, nf) elastic coordinates of a body."""
        return self.q[:, body.elastic]

    def world(self, body: Body, points: Points, factor: float) -> np.ndarray:
        """(frames, n, 3) points of a body in the world, its deformation multiplied by `factor` [m]."""
        return self.placed(body, exaggerated(points, self.follow[self.bodies.index(body)], self.q_f(body), factor))

    def placed(self, body: Body, local: np.ndarray) -> np.ndarray:
        """(frames, n, 3) places in the world of points (frames, n, 3) in a body's axes [m]."""
        if body.pose is None:
            return local
        return np.asarray(
            self.origin[:, body.pose, None, :] + np.einsum("fij,fnj->fni", self.turn[:, body.pose], local)
        )

    def marker(self, reference: str) -> tuple[Body, int]:
        """The body and the place among its markers of "body.marker"."""
        return next(
            (body, place)
            for body in self.bodies
            for place, name in enumerate(body.markers.names)
            if f"{body.name}.{name}" == reference
        )

    def place(self, reference: str, factor: float) -> np.ndarray:
        """(frames, 3) world position of "body.marker" [m]."""
        body, k = self.marker(reference)
        return self.world(body, body.markers, factor)[:, k]

    def axes(self, reference: str) -> np.ndarray:
        """(frames, 3, 3) axes of "body.marker" in the world, without its turning by deformation."""
        body, k = self.marker(reference)
        local = body.markers.axes[k]
        if body.pose is None:
            return np.repeat(local[None], len(self.t), axis=0)
        return np.asarray(self.turn[:, body.pose] @ local)

    def everything(self, factor: float) -> np.ndarray:
        """(frames, n, 3) all stations and markers [m]."""
        return np.concatenate(
            [
                self.world(body, points, factor)
                for body in self.bodies
                for points in (body.stations, body.markers, body.skin())
            ],
            axis=1,
        )

    def size(self) -> float:
        """The longest side of the box around all that is seen [m], at least 1e-9."""
        points = self.everything(0.0)
        return max(float(np.ptp(points, axis=(0, 1)).max(initial=0.0)), 1e-9)

    def deformation(self) -> float:
        """The largest displacement that exaggeration multiplies [m]."""
        found = 0.0
        for body, follow in zip(self.bodies, self.follow, strict=True):
            some = max(1, 0 if body.surface is None else len(body.surface["vertices"]) // 500)
            for points in (body.stations, body.markers, body.skin(slice(None, None, some))):
                if body.elastic and len(points.names):
                    left = points.linear(self.q_f(body)) - follow.displacement(points.position, self.q_f(body))
                    found = max(found, float(np.linalg.norm(left, axis=2).max()))
        return found

    def automatic(self, size: float) -> float:
        """The factor, with two digits, that makes the largest deformation 5 % of a size [m]; at least 1."""
        deformation = self.deformation()
        if deformation <= 1e-12 * size:
            return 1.0
        factor = max(1.0, VISIBLE * size / deformation)
        digits = 10.0 ** (np.floor(np.log10(factor)) - 1)
        return float(max(1.0, np.floor(factor / digits) * digits))


def scenery(solution: Solution, t: np.ndarray) -> Scenery:
    """The mechanism of a solution at the times t (N,) [s]. Raises ModelError if the model has nothing to draw."""
    return _at(solution.model, solution.parameters, t, np.asarray(solution.interpolate(t, "q")))


def still(model: EmittedModel) -> Scenery:
    """The mechanism as the scene starts it, with its own parameters. Raises ModelError if there is nothing to draw."""
    return _at(model, model.parameter_vector(), np.zeros(1), model.initial_q[None, :])


def _at(model: EmittedModel, p: np.ndarray, t: np.ndarray, q: np.ndarray) -> Scenery:
    """With parameters p (n_p,) at coordinates q (frames, n)."""
    found = bodies(model, p)
    origin, turn = poses_of(model, q)
    at_joints = {joint[key] for joint in model.drawing["joints"] for key in ("marker_a", "marker_b")}
    follow = [
        following(body.markers, [k for k, name in enumerate(body.markers.names) if f"{body.name}.{name}" in at_joints])
        for body in found
    ]
    return Scenery(model, t, q, origin, turn, found, follow)
