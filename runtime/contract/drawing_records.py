"""What pictures of a model are made of, as records."""

from __future__ import annotations

from dataclasses import dataclass, field


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
class Drawing:
    """What the columns of `poses` (bodies), of `geometry` (points) and of its sections (beams) belong to; shapes."""

    space: str
    poses: list[str]
    points: list[PointRecord]
    sections: list[str]
    shapes: list[ShapeRecord] = field(default_factory=list)
