"""What pictures of a model are made of, as records."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from runtime.contract.packing import unpacked


@dataclass(frozen=True)
class PointRecord:
    """A column of `positions`: a marker of a body, or a station of a beam (name ""), with its modes; has it an H?"""

    body: str
    name: str
    modes: int
    stiffened: bool = False


@dataclass(frozen=True)
class ShapeRecord:
    """How a rigid body looks, in its axes: a box, cylinder, sphere or mesh at `position` [m] turned by `axes` (3 x 3).

    size [m]: three lengths; radius and length; radius. A mesh has vertices [m] and triangles, places of vertices.
    """

    body: str
    type: str
    position: list[float]
    axes: list[list[float]]
    size: list[float] = field(default_factory=list)
    vertices: list[list[float]] = field(default_factory=list)
    triangles: list[list[int]] = field(default_factory=list)


@dataclass(frozen=True)
class SurfaceRecord:
    """The surface of a flexible body as packed arrays (runtime.contract.packing), float32 and int32.

    vertices (n, 3) [m] in its axes, triangles (m, 3), shapes (n, 3, nf) per unit of q_f; stresses (n, 6, nf) [Pa] per
    unit of q_f in the order xx yy zz yz xz xy, "" if not known.
    """

    body: str
    vertices: str
    triangles: str
    shapes: str
    stresses: str = ""

    def arrays(self) -> dict[str, np.ndarray]:
        """vertices, triangles, shapes, and stresses if they are known. Raises ValueError if they do not fit."""
        vertices = unpacked(self.vertices).reshape(-1, 3)
        found: dict[str, np.ndarray] = {"vertices": vertices}
        found["triangles"] = unpacked(self.triangles, "<i4").reshape(-1, 3)
        found["shapes"] = unpacked(self.shapes).reshape(len(vertices), 3, -1)
        return found | ({"stresses": unpacked(self.stresses).reshape(len(vertices), 6, -1)} if self.stresses else {})


@dataclass(frozen=True)
class Drawing:
    """What the columns of `poses` (bodies), of `geometry` (points) and of its sections (beams) belong to; looks."""

    space: str
    poses: list[str]
    points: list[PointRecord]
    sections: list[str]
    shapes: list[ShapeRecord] = field(default_factory=list)
    surfaces: list[SurfaceRecord] = field(default_factory=list)
