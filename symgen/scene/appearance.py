"""How a rigid body looks: boxes, cylinders, balls and meshes. They are drawn and enter no equation."""

from __future__ import annotations

from typing import Annotated, Literal

import numpy as np
from pydantic import AfterValidator, BeforeValidator, Field

from symgen.schema.fields import Number, StrictModel, refuse

MOST_TRIANGLES = 20_000
Triple = tuple[Number, Number, Number]


Length = Annotated[Number, Field(gt=0)]


class _Shape(StrictModel):
    """position: of the middle [m]; axis, x_axis: the shape's z-axis and the side of its x-axis; in the body frame."""

    position: Triple = (0.0, 0.0, 0.0)
    axis: Triple = (0.0, 0.0, 1.0)
    x_axis: Triple | None = None

    def axes(self) -> np.ndarray:
        """(3, 3) columns: the shape's axes in the body frame. Raises ValueError where they are not defined."""
        z = np.array(self.axis) / (np.linalg.norm(self.axis) or 1.0)
        wanted = np.array(self.x_axis) if self.x_axis is not None else np.eye(3)[int(np.argmin(np.abs(z)))]
        x = wanted - z * (z @ wanted)
        if not np.any(z) or np.linalg.norm(x) <= 1e-9 * np.linalg.norm(wanted):
            raise ValueError("axis is zero, or x_axis is along it")
        x = x / np.linalg.norm(x)
        return np.column_stack([x, np.cross(z, x), z])


class BoxShape(_Shape):
    """size: lengths along the shape's x, y and z [m]."""

    type: Literal["box"] = "box"
    size: tuple[Length, Length, Length]


class CylinderShape(_Shape):
    """A cylinder about its z-axis. radius, length [m]."""

    type: Literal["cylinder"] = "cylinder"
    radius: Length
    length: Length


class SphereShape(_Shape):
    """radius [m]."""

    type: Literal["sphere"] = "sphere"
    radius: Length


class MeshShape(_Shape):
    """vertices (n, 3) [m]; triangles (m, 3): places of vertices. In a scene file also ``file``, see scene_files.py."""

    type: Literal["mesh"] = "mesh"
    vertices: tuple[Triple, ...]
    triangles: tuple[tuple[int, int, int], ...]


Shape = Annotated[BoxShape | CylinderShape | SphereShape | MeshShape, Field(discriminator="type")]


def _several(value: object) -> object:
    """One shape may stand for a list of one."""
    return [value] if isinstance(value, dict | _Shape) else value


def _sound(shapes: tuple[_Shape, ...]) -> tuple[_Shape, ...]:
    for place, shape in enumerate(shapes):
        try:
            shape.axes()
        except ValueError as error:
            raise refuse(f"shape {place + 1}: {error}", "give two directions that are not along each other") from None
        if isinstance(shape, MeshShape):
            _whole(shape)
    return shapes


def _whole(mesh: MeshShape) -> None:
    if not mesh.triangles or len(mesh.triangles) > MOST_TRIANGLES:
        raise refuse(f"the mesh has {len(mesh.triangles)} triangles", f"give 1 to {MOST_TRIANGLES}, coarsen the mesh")
    places = np.array(mesh.triangles)
    if places.min() < 0 or places.max() >= len(mesh.vertices):
        raise refuse(
            f"triangles name vertices from {places.min()} to {places.max()} of {len(mesh.vertices)}", "count from 0"
        )


Shapes = Annotated[tuple[Shape, ...], BeforeValidator(_several), AfterValidator(_sound)]
