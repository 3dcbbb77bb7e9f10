"""Boxes, cylinders, balls and meshes that stand for a rigid body: triangles for the page, edges for films."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from runtime.contract.records import ShapeRecord

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
