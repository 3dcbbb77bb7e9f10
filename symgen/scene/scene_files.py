"""Files that a scene file names: meshes of shapes. They are read with the scene, which then holds all it needs."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from symgen.scene.toml_io import MAX_BYTES
from symgen.schema.errors import SceneError, show

FORMATS = (".stl", ".obj", ".ply", ".off", ".glb")


def with_files(data: dict[str, Any], folder: Path) -> dict[str, Any]:
    """Plain scene data with ``shape = {type = "mesh", file = ...}`` replaced by what the files in `folder` hold.

    Raises SceneError for a path that leads out of the folder and for a file that cannot be read.
    """
    bodies = data.get("bodies")
    if not isinstance(bodies, list):
        return data
    return {**data, "bodies": [_with_shapes(body, folder) if isinstance(body, dict) else body for body in bodies]}


def _with_shapes(body: dict[str, Any], folder: Path) -> dict[str, Any]:
    shapes = body.get("shape")
    if isinstance(shapes, dict):
        shapes = [shapes]
    if not isinstance(shapes, list) or not any(isinstance(shape, dict) and "file" in shape for shape in shapes):
        return body
    item = f"bodies '{body.get('name', '?')}'.shape.file"
    return {**body, "shape": [_read(shape, folder, item) if _names_file(shape) else shape for shape in shapes]}


def _names_file(shape: Any) -> bool:
    return isinstance(shape, dict) and "file" in shape


def _read(shape: dict[str, Any], folder: Path, item: str) -> dict[str, Any]:
    name = shape["file"]
    if not isinstance(name, str) or "\0" in name or not (folder / name).resolve().is_relative_to(folder.resolve()):
        raise SceneError(item, f"{show(name)} is not below the scene's folder", "put the mesh beside the scene file")
    return {**{key: value for key, value in shape.items() if key != "file"}, **read_mesh(folder / name, item)}


def read_mesh(path: str | Path, item: str = "shape") -> dict[str, Any]:
    """{type, vertices [m], triangles} of a surface file (STL, OBJ, PLY, GLB, by trimesh), for a body's ``shape``.

    The file alone is read, none that it names. Raises SceneError if trimesh (the extra ``meshes``) is missing, and for
    what is no ordinary file, another format, larger than 50 MB or cannot be read.
    """
    place = Path(path)
    if place.suffix.lower() not in FORMATS:
        raise SceneError(item, f"{path} is of no known format", f"give a file that ends in {', '.join(FORMATS)}")
    if not place.is_file():  # a pipe or a device may never end
        raise SceneError(item, f"{path} is not there, or not an ordinary file", "give the path of a surface file")
    if place.stat().st_size > MAX_BYTES:
        raise SceneError(item, f"{path} is larger than 50 MB", "coarsen the mesh")
    try:
        import trimesh
    except ImportError:
        raise SceneError(item, "mesh files need trimesh", 'install it: pip install "symgen[meshes]"') from None
    try:
        with open(place, "rb") as stream:
            mesh = trimesh.load_mesh(
                stream, file_type=place.suffix[1:].lower(), process=True
            )  # equal corners: one vertex
        vertices, triangles = np.asarray(mesh.vertices, dtype=float), np.asarray(mesh.faces, dtype=int)
    except Exception as error:  # its readers raise whatever they meet in a damaged file
        raise SceneError(item, f"{path} cannot be read as a surface ({error})", "give a file of triangles") from None
    if not len(triangles):
        raise SceneError(item, f"{path} holds no triangles", "give a file of triangles")
    return {"type": "mesh", "vertices": vertices.tolist(), "triangles": triangles.tolist()}
