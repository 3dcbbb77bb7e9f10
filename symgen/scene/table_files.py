"""CSV files that tables of a scene name: read with the scene, which then holds their numbers."""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path, PurePosixPath
from typing import Any

from symgen.scene.tables import MAX_POINTS
from symgen.schema.errors import SceneError, show

MAX_BYTES = 20_000_000


def with_tables(data: dict[str, Any], folder: Path) -> dict[str, Any]:
    """Plain scene data with ``file`` and ``columns`` of its tables replaced by x and y.

    Raises SceneError for a path that leads out of the folder and for a file that cannot be read.
    """
    tables = data.get("tables")
    if not isinstance(tables, dict):
        return data
    return {**data, "tables": {name: _read(f"tables.{name}", entry, folder) for name, entry in tables.items()}}


def _read(item: str, entry: Any, folder: Path) -> Any:
    if not isinstance(entry, dict) or "file" not in entry:
        return entry
    name, columns = entry["file"], entry.get("columns", (0, 1))
    if not isinstance(name, str) or PurePosixPath(name).is_absolute() or ".." in PurePosixPath(name).parts:
        raise SceneError(
            f"{item}.file", f"{show(name)} is not below the scene's folder", "put it beside the scene file"
        )
    kept = {key: value for key, value in entry.items() if key not in ("file", "columns")}
    return {**kept, **read_points(folder / name, columns, item)}


def read_points(path: str | Path, columns: Sequence[int], item: str) -> dict[str, Any]:
    """{x, y} from two columns (counted from 0) of a CSV file. Raises SceneError."""
    try:
        with open(path, encoding="utf-8-sig") as stream:
            text = stream.read(MAX_BYTES + 1)
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise SceneError(f"{item}.file", f"'{path}' cannot be read ({reason})", "give the path of a CSV file") from None
    if len(text) > MAX_BYTES:
        raise SceneError(f"{item}.file", f"'{path}' is larger than 20 MB", f"give at most {MAX_POINTS} points")
    rows = _rows(f"{item}.file", text)
    try:
        x, y = ([row[column] for row in rows] for column in columns)
    except (IndexError, TypeError, ValueError):
        raise SceneError(
            f"{item}.columns", f"'{path}' has no columns {show(columns)}", "count columns from 0"
        ) from None
    return {"x": x, "y": y}


def _rows(item: str, text: str) -> list[list[float]]:
    """Rows of numbers between commas, semicolons or blanks; # begins a comment, names above are left out."""
    found: list[list[float]] = []
    for number, line in enumerate(text.splitlines(), 1):
        words = line.partition("#")[0].replace(";", ",").replace("\t", ",").split(",")
        words = [word for part in words for word in part.split()]
        if not words:
            continue
        try:
            values = [float(word) for word in words]
        except ValueError:
            if found:
                raise SceneError(item, f"line {number} is not a row of numbers", "correct that line") from None
            continue
        if not all(map(math.isfinite, values)):
            raise SceneError(item, f"line {number} holds a number that is not finite", "correct that line")
        found.append(values)
    return found
