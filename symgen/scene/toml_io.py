"""Scene files: reading TOML, and writing it so that it reads back to an equal scene.

Files that a scene file names: meshes of shapes. They are read with the scene, which then holds all it needs.
"""

from __future__ import annotations

import io
import os
import re
import stat
import tomllib
from difflib import get_close_matches
from pathlib import Path
from typing import Any

import numpy as np
from pydantic import BaseModel

from symgen.schema.errors import SceneError, show

MAX_BYTES = 50_000_000
MAX_KEY_PARTS = 100
LONGEST_LINE = 100  # characters of a line that an error shows
_WITH_UNIT = re.compile(r"=\s*([-+]?\d[\d.eE+-]*)\s*[A-Za-z]+[\w/^* ]*'?$")  # mass = 3.0 kg
# dotted names longer than that: tomllib takes time with the square of their length
_LONG_KEY = re.compile(
    r"""(?<![\w"'-])(?:(?:[\w-]{1,200}|"[^"\n]{0,200}"|'[^'\n]{0,200}')[ \t]*\.[ \t]*)""" + f"{{{MAX_KEY_PARTS}}}"
)
_ESCAPES = {'"': '\\"', "\\": "\\\\", "\n": "\\n", "\t": "\\t", "\r": "\\r"}


def read(path: str | Path) -> dict[str, Any]:
    """The contents of a TOML file; raises SceneError when it cannot be read, is not UTF-8 or not TOML."""
    item = f"file '{path}'"
    return parse(text_of(path, item, "a scene file"), item)


def text_of(path: str | Path, item: str, kind: str) -> str:
    """The text of a file in UTF-8; arguments and errors as of `content_of`."""
    try:
        return content_of(path, item, kind).decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise SceneError(item, f"is not UTF-8 text (byte {error.start})", "save the file as UTF-8") from None


def content_of(path: str | Path, item: str, kind: str) -> bytes:
    """The bytes of a file; kind: what should be there, such as "a scene file".

    Raises SceneError, with this item, for what is not a regular file, larger than 50 MB or cannot be read.
    """
    try:
        if not stat.S_ISREG(os.stat(path).st_mode):  # a pipe or a device may never end
            raise SceneError(item, "is not a regular file", f"give the path of {kind}")
        with open(path, "rb") as file:
            content = file.read(MAX_BYTES + 1)
    except FileNotFoundError:
        beside = _names_beside(Path(path))
        near = get_close_matches(Path(path).name[:80], beside, 1)
        raise SceneError(item, "does not exist", f"did you mean '{near[0]}'?" if near else "check the path") from None
    except (OSError, ValueError, TypeError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise SceneError(item, f"cannot be read ({reason})", f"give the path of {kind}") from None
    if len(content) > MAX_BYTES:
        raise SceneError(item, "is larger than 50 MB", f"give the path of {kind}")
    return content


def _names_beside(path: Path) -> list[str]:
    """Names of the files beside a path with its ending."""
    try:
        return [one.name for one in path.parent.iterdir() if one.suffix == path.suffix]
    except OSError:
        return []


def within(path: Path, *folders: Path) -> Path | None:
    """The file behind a path and its links, None where it is below none of the folders."""
    try:
        found = path.resolve()
        if found.is_symlink():  # links in a circle, which resolve() raises up to Python 3.12
            return None
        return found if any(found.is_relative_to(folder.resolve()) for folder in folders) else None
    except (OSError, ValueError, RuntimeError):  # what no path can hold, links in a circle
        return None


def named_file(name: object, folder: Path, item: str, what: str) -> Path:
    """A file that a scene in the folder names. Raises SceneError for one that is not below it."""
    found = within(folder / name, folder) if isinstance(name, str) else None
    if found is None:
        raise SceneError(item, f"{show(name)} is not below the scene's folder", f"put the {what} beside the scene file")
    return found


def parse(text: str, item: str) -> dict[str, Any]:
    """The contents of a TOML text; raises SceneError naming ``item``."""
    if _LONG_KEY.search(text):
        raise SceneError(item, f"holds a dotted name of more than {MAX_KEY_PARTS} parts", "shorten the name")
    try:
        return tomllib.loads(text)
    except RecursionError:
        raise SceneError(item, "is nested too deeply", "flatten the lists and tables") from None
    except (ValueError, TypeError, AttributeError) as error:
        line = _line_of(text, error)
        unit = _WITH_UNIT.search(line)
        remedy = f"write the number alone: all are in SI units, here {unit[1]}" if unit else "correct that line"
        raise SceneError(item, f"is not valid TOML ({error}){line}", remedy) from None


def _line_of(text: str, error: Exception) -> str:
    """The line that the error names, as it stands in the text."""
    place = re.search(r"at line (\d+)", str(error))
    lines = text.splitlines()
    if place is None or not 1 <= int(place.group(1)) <= len(lines):
        return ""
    return f": {lines[int(place.group(1)) - 1].strip()[:LONGEST_LINE]!r}"


def plain(model: BaseModel) -> dict[str, Any]:
    """``model`` as dictionaries, lists and numbers; entries equal to their default are left out.

    ``type`` and ``name`` come first and always stay, for people and because ``type`` selects the model.
    """
    fields = type(model).model_fields
    ordered: list[str] = [key for key in ("type", "name") if key in fields]
    ordered += [key for key in fields if key not in ordered]
    result: dict[str, Any] = {}
    for key in ordered:
        value = getattr(model, key)
        default = fields[key].get_default(call_default_factory=True, validated_data=model.__dict__)
        if key in ("type", "name") or (value is not None and value != default):
            result[key] = _plain_value(value)
    return result


def _plain_value(value: Any) -> Any:
    if isinstance(value, BaseModel):
        contents = plain(value)
        return contents["value"] if set(contents) == {"value"} else contents
    if isinstance(value, tuple):
        return [_plain_value(part) for part in value]
    if isinstance(value, dict):
        return {key: _plain_value(part) for key, part in value.items()}
    return value


def write(data: dict[str, Any]) -> str:
    """TOML text of plain values: simple entries, then tables, then arrays of tables."""
    lines = [f"{_key(key)} = {_value(value)}" for key, value in data.items() if not _is_section(value)]
    for key, value in data.items():
        if isinstance(value, dict):
            lines += ["", f"[{_key(key)}]", *_entries(value)]
    for key, value in data.items():
        if _is_section(value) and isinstance(value, list):
            for entry in value:
                lines += ["", f"[[{_key(key)}]]", *_entries(entry)]
    return "\n".join(lines) + "\n"


def _is_section(value: Any) -> bool:
    return isinstance(value, dict) or (isinstance(value, list) and bool(value) and isinstance(value[0], dict))


def _entries(table: dict[str, Any]) -> list[str]:
    lines = []
    for key, value in table.items():
        if isinstance(value, dict) and key in (
            "markers",
            "coordinates",
            "rates",
        ):  # an entry a line, dotted keys
            lines += [f"{key}.{_key(name)} = {_value(part)}" for name, part in value.items()]
        else:
            lines.append(f"{_key(key)} = {_value(value)}")
    return lines


def _value(value: Any) -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, int | float):
        return repr(value)
    if isinstance(value, str):
        return _string(value)
    if isinstance(value, dict):
        inner = ", ".join(f"{_key(key)} = {_value(part)}" for key, part in value.items())
        return f"{{ {inner} }}" if inner else "{}"
    parts = [_value(part) for part in value]
    if value and isinstance(value[0], list | dict):  # a matrix row or a group a line
        return "[\n" + "".join(f"    {part},\n" for part in parts) + "]"
    return f"[{', '.join(parts)}]"


def _key(key: str) -> str:
    return key if re.fullmatch(r"[A-Za-z0-9_-]+", key) else _string(key)


def _string(text: str) -> str:
    escaped = (
        _ESCAPES.get(char) or (f"\\u{ord(char):04x}" if ord(char) < 32 or ord(char) == 127 else char) for char in text
    )
    return '"' + "".join(escaped) + '"'


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
    found = named_file(shape["file"], folder, item, "mesh")
    return {**{key: value for key, value in shape.items() if key != "file"}, **read_mesh(found, item)}


def read_mesh(path: str | Path, item: str = "shape") -> dict[str, Any]:
    """{type, vertices [m], triangles} of a surface file (STL, OBJ, PLY, GLB, by trimesh), for a body's ``shape``.

    The file alone is read, none that it names. Raises SceneError if trimesh (the extra ``meshes``) is missing, and for
    what is not a regular file, another format, larger than 50 MB or cannot be read.
    """
    place = Path(path)
    if place.suffix.lower() not in FORMATS:
        raise SceneError(item, f"{path} is of no known format", f"give a file that ends in {', '.join(FORMATS)}")
    content = content_of(path, f"{item} '{path}'", "a surface file")
    try:
        import trimesh
    except ImportError:
        raise SceneError(item, "mesh files need trimesh", 'install it: pip install "symgen[meshes]"') from None
    try:
        mesh = trimesh.load_mesh(io.BytesIO(content), file_type=place.suffix[1:].lower(), process=True)
        # equal corners are one vertex; earlier versions give a file that holds nothing as an empty scene
        empty = isinstance(mesh, trimesh.Scene) and not mesh.geometry
        vertices = np.asarray([] if empty else mesh.vertices, dtype=float)
        triangles = np.asarray([] if empty else mesh.faces, dtype=int)
    except Exception as error:  # its readers raise whatever they meet in a damaged file
        raise SceneError(item, f"{path} cannot be read as a surface ({error})", "give a file of triangles") from None
    if not len(triangles):
        raise SceneError(item, f"{path} holds no triangles", "give a file of triangles")
    return {"type": "mesh", "vertices": vertices.tolist(), "triangles": triangles.tolist()}
