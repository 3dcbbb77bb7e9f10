"""Surfaces that move with a body's modes: prisms along beams, and given triangles."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from runtime.contract.errors import ModelError
from runtime.views.mechanism.points import Body, Points
from runtime.views.mechanism.solids import Solid
from runtime.views.viewer.section_stress import RIM

MOST_TRIANGLES = 200_000
KEYS = ("vertices", "triangles", "shapes")


@dataclass(frozen=True, eq=False)
class SurfaceMesh:
    """points: the vertices; triangles (m, 3): three vertices each; H of every `per` vertices in turn is the same.

    stresses (n, 6, nf): xx yy zz yz xz xy [Pa] of each vertex per unit of q_f, where they are known.
    """

    points: Points
    triangles: np.ndarray
    per: int = 1
    stresses: np.ndarray | None = None
    von_mises: np.ndarray | None = None


def beam_mesh(body: Body) -> SurfaceMesh:
    """A prism with the beam's own section: eight vertices a station, turned with it by the deformation."""
    assert body.section is not None
    stations, (height, width) = body.stations, body.section
    n, nf, rim = len(stations.names), stations.shapes.shape[2], len(RIM)
    places = np.array([[0.0, y * height, z * width] for y, z in RIM]) / 2.0
    position = (stations.position[:, None] + places[None]).reshape(-1, 3)
    arm = np.broadcast_to(places[None, :, :, None], (n, rim, 3, nf))
    turned = np.cross(np.broadcast_to(stations.turns[:, None], (n, rim, 3, nf)), arm, axis=2)
    shapes = (stations.shapes[:, None] + turned).reshape(-1, 3, nf)
    sides = [
        (first + i, first + (i + 1) % rim, first + rim + i, first + rim + (i + 1) % rim)
        for first in range(0, rim * (n - 1), rim)
        for i in range(rim)
    ]
    triangles = [part for a, b, c, d in sides for part in ((a, b, d), (a, d, c))]
    last = rim * (n - 1)
    fan = [(i, (i + 1) % rim) for i in range(2, rim)]  # about the middle of a side
    triangles += [part for i, j in fan for part in ((1, j, i), (last + 1, last + i, last + j))]
    return SurfaceMesh(_points(position, shapes, stations.H), np.array(triangles), per=rim)


def solid_mesh(solid: Solid) -> SurfaceMesh:
    """The shapes of a rigid body, which has no modes."""
    return SurfaceMesh(
        _points(solid.vertices, np.zeros((len(solid.vertices), 3, 0)), np.zeros((0, 0, 0))), solid.triangles
    )


def surface_mesh(body: Body, surface: Mapping[str, Any]) -> SurfaceMesh:
    """Given triangles: vertices (n, 3) [m] in the axes of the body, triangles (m, 3), shapes and stresses per mode.

    von_mises, if given: (samples, n) [Pa] of the motion, which goes before the stresses of the modes.
    Raises ModelError for other sizes, for numbers that are not finite, and for vertices that are not there.
    """
    missing = [key for key in KEYS if key not in surface]
    if missing:
        raise ModelError(f"the surface of {body.name} has no {missing[0]}; it needs {', '.join(KEYS)}")
    position, shapes = (np.asarray(surface[key], dtype=float) for key in ("vertices", "shapes"))
    triangles = np.asarray(surface["triangles"])
    n, nf = len(position), len(body.elastic)
    if position.shape != (n, 3) or shapes.shape != (n, 3, nf) or triangles.ndim != 2 or triangles.shape[1:] != (3,):
        raise ModelError(
            f"the surface of {body.name} must have vertices (n, 3), triangles (m, 3) and shapes (n, 3, {nf}), not "
            f"{position.shape}, {triangles.shape} and {shapes.shape}"
        )
    if not (np.all(np.isfinite(position)) and np.all(np.isfinite(shapes))):
        raise ModelError(f"the surface of {body.name} holds numbers that are not finite")
    if triangles.dtype.kind not in "iu" or (triangles.size and not 0 <= triangles.min() <= triangles.max() < n):
        raise ModelError(f"the triangles of {body.name} must be whole numbers from 0 to {n - 1}: places of vertices")
    if len(triangles) > MOST_TRIANGLES:
        raise ModelError(
            f"the surface of {body.name} has {len(triangles)} triangles; at most {MOST_TRIANGLES} are shown"
        )
    stresses = np.asarray(surface["stresses"], dtype=float) if "stresses" in surface else None
    if stresses is not None and (stresses.shape != (n, 6, nf) or not np.all(np.isfinite(stresses))):
        raise ModelError(f"the stresses of {body.name} must be finite and (n, 6, nf) = {(n, 6, nf)}")
    mises = np.asarray(surface["von_mises"], dtype=float) if "von_mises" in surface else None
    if mises is not None and (mises.shape[1:] != (n,) or not np.all(np.isfinite(mises))):
        raise ModelError(f"von_mises of {body.name} must be finite and (samples, {n}), not {mises.shape}")
    return SurfaceMesh(_points(position, shapes, np.zeros((0, nf, nf))), triangles, stresses=stresses, von_mises=mises)


def _points(position: np.ndarray, shapes: np.ndarray, H: np.ndarray) -> Points:
    n, nf = len(position), shapes.shape[2]
    return Points([""] * n, position, np.zeros((0, 3, 3)), shapes, np.zeros((0, 3, nf)), H)
