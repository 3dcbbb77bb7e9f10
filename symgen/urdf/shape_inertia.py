"""Inertia of a link from its shapes, full of a density: for files of shells, which have none."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any
from xml.etree.ElementTree import Element

import numpy as np

from symgen.schema.errors import SceneError
from symgen.urdf.robot import Assumed, Inertia, Link, pose_of, together


def inertia_of_shapes(
    link: Link, density: float, geometry: Callable[[Element, str], dict[str, Any]], assumed: list[Assumed]
) -> Inertia:
    """Of the collision shapes, of the visual ones where there are none; density [kg/m^3].

    geometry: the entry of a body's `shape` for an element's geometry. An open mesh counts as its convex hull.
    Raises SceneError for shapes that cannot be read.
    """
    item, parts, hulls = f"link '{link.name}'", [], 0
    for element in link.collisions or link.visuals:
        own = element.find("geometry")
        if own is None or not len(own):
            continue
        part, whole = _of_shape(geometry(own[0], item), density, item)
        hulls += not whole
        parts.append(part.in_frame(pose_of(element, item)))
    if not parts:
        return Inertia()
    total = together(parts)
    hull = f", {hulls} of them by the convex hull" if hulls else ""
    what = "collision" if link.collisions else "visual"
    detail = f"{total.mass:.4g} kg of {len(parts)} {what} shapes at {density:g} kg/m^3{hull}"
    assumed.append(Assumed(item, detail))
    return total


def _of_shape(shape: dict[str, Any], density: float, item: str) -> tuple[Inertia, bool]:
    """(inertia in the shape's frame, is it the shape's own and not that of its convex hull)."""
    if shape["type"] == "box":
        a, b, c = np.array(shape["size"]) ** 2
        mass = density * float(np.prod(shape["size"]))
        return Inertia(mass, tensor=mass / 12 * np.diag([b + c, a + c, a + b])), True
    if shape["type"] == "sphere":
        r = shape["radius"]
        mass = density * 4 / 3 * np.pi * r**3
        return Inertia(mass, tensor=0.4 * mass * r**2 * np.eye(3)), True
    if shape["type"] == "cylinder":
        r, h = shape["radius"], shape["length"]
        mass = density * np.pi * r**2 * h
        across = mass * (3 * r**2 + h**2) / 12
        return Inertia(mass, tensor=np.diag([across, across, mass * r**2 / 2])), True
    return _of_mesh(shape, density, item)


def _of_mesh(shape: dict[str, Any], density: float, item: str) -> tuple[Inertia, bool]:
    import trimesh  # which has read the mesh

    mesh = trimesh.Trimesh(shape["vertices"], shape["triangles"])
    closed = bool(mesh.is_volume)
    try:
        found = (mesh if closed else mesh.convex_hull).mass_properties  # of density 1
    except Exception as error:  # a flat mesh has no hull
        raise SceneError(item, f"its mesh has no volume ({error})", "give the link an inertial") from None
    tensor = density * np.asarray(found.inertia)
    return Inertia(density * float(found.volume), np.asarray(found.center_mass), tensor), closed
