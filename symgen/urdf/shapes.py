"""How the links look: boxes, cylinders, balls, and meshes of files that the URDF names."""

from __future__ import annotations

from pathlib import Path
from typing import Any
from xml.etree.ElementTree import Element

import numpy as np

from symgen.scene.appearance import MOST_TRIANGLES
from symgen.scene.scene_files import read_mesh
from symgen.schema.errors import SceneError
from symgen.urdf.robot import Dropped, Link, Pose, numbers, pose_of


def shapes_of(link: Link, seat: Pose, folder: Path, meshes: bool, dropped: list[Dropped]) -> list[dict[str, Any]]:
    """Entries of a body's `shape`; seat: the link's pose in the body.

    Where a visual cannot be had the collision geometry stands for all visuals of the link, if it can be had.
    """
    shapes, lost = _shapes(link.name, link.visuals, seat, folder, meshes)
    dropped += lost
    solid, missing = _shapes(link.name, link.collisions, seat, folder, meshes) if lost else ([], [])
    if solid and not missing:
        return solid
    if link.collisions:
        dropped.append(Dropped("collision", link.name))
    return shapes


def _shapes(
    name: str, elements: list[Element], seat: Pose, folder: Path, meshes: bool
) -> tuple[list[dict[str, Any]], list[Dropped]]:
    found, lost = [], []
    for element in elements:
        geometry = element.find("geometry")
        kind = geometry[0] if geometry is not None and len(geometry) else None
        try:
            if kind is None:
                raise SceneError(f"link '{name}'", "its geometry is empty", "give a shape")
            if kind.tag == "mesh" and not meshes:
                raise SceneError(f"link '{name}'", "meshes were not asked for", "ask for them")
            own = seat.then(pose_of(element, f"link '{name}'"))
            place = {"position": own.p.tolist(), "axis": own.R[:, 2].tolist(), "x_axis": own.R[:, 0].tolist()}
            found.append({**_geometry(kind, f"link '{name}'", folder), **place})
        except SceneError as error:
            lost.append(Dropped(element.tag, name, f"{kind.get('filename', '') if kind is not None else ''} "
                                f"{error.problem}".strip()))  # fmt: skip
    return found, lost


def _geometry(kind: Element, item: str, folder: Path) -> dict[str, Any]:
    if kind.tag == "box":
        return {"type": "box", "size": _lengths(kind, "size", item, 3)}
    if kind.tag == "sphere":
        return {"type": "sphere", "radius": _lengths(kind, "radius", item)[0]}
    if kind.tag == "cylinder":
        return {
            "type": "cylinder",
            "radius": _lengths(kind, "radius", item)[0],
            "length": _lengths(kind, "length", item)[0],
        }
    if kind.tag != "mesh":
        raise SceneError(item, f"a {kind.tag} is not drawn", "give a box, a sphere, a cylinder or a mesh")
    mesh = read_mesh(located(kind.get("filename", ""), folder, item), item)
    if len(mesh["triangles"]) > MOST_TRIANGLES:
        problem = f"{len(mesh['triangles'])} triangles are more than {MOST_TRIANGLES}"
        raise SceneError(item, problem, "coarsen the mesh")
    vertices = np.array(mesh["vertices"]) * numbers(kind, "scale", item, "1 1 1")
    return {**mesh, "vertices": vertices.tolist()}


def _lengths(kind: Element, key: str, item: str, count: int = 1) -> list[float]:
    found = numbers(kind, key, item, "", count)
    if np.any(found <= 0):
        raise SceneError(item, f"{key} of a {kind.tag} is not positive", "give lengths above 0")
    return [float(value) for value in found]


def located(name: str, folder: Path, item: str) -> Path:
    """The file behind `package://package/rest`, `file:///...` or a path beside the URDF.

    A package is looked for in the URDF's folder and in those above it, by its name or, as where the folder is the
    package, without. Raises SceneError where there is none.
    """
    scheme, colon, rest = name.partition("://")
    if not colon:
        return folder / name
    if scheme == "file":
        return Path(rest)
    if scheme == "package" and "\0" not in rest and ".." not in Path(rest).parts:
        package, _, inner = rest.lstrip("/").partition("/")
        for above in (folder.resolve(), *folder.resolve().parents):
            for place in (above / package / inner, *([above / inner] if above.name == package else [])):
                if place.is_file():
                    return place
    raise SceneError(item, "is in no folder above the URDF", "put the package there")
