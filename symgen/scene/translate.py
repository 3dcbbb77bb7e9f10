"""From pydantic's errors to `SceneError`: item path, problem, remedy."""

from __future__ import annotations

import re
from typing import Any

from pydantic import ValidationError
from pydantic_core import ErrorDetails

from symgen.schema.errors import SceneError, did_you_mean, show

SECTIONS = ("bodies", "joints", "couplings", "loads", "measures")
_EXAMPLES = {
    "bodies": 'say what it is, for instance type = "rigid"',
    "joints": 'say what it is, for instance type = "revolute"',
    "couplings": 'say what it is, for instance type = "gear"',
    "loads": 'say what it is, for instance type = "force"',
    "measures": 'say what it is, for instance type = "angle"',
}
_LIMITS = {
    "greater_than": ("gt", "greater than"),
    "greater_than_equal": ("ge", "at least"),
    "less_than": ("lt", "less than"),
    "less_than_equal": ("le", "at most"),
}
_KINDS = {
    "int": "a whole number",
    "bool": "true or false",
    "string": "text",
    "float": "a number",
    "dict": "a table of entries",
    "model": "a table of entries",
    "tuple": "a list",
    "finite": "a finite number",
}


def item_path(section: str, index: int, name: object) -> str:
    """The path of an entry of a list, such as ``bodies[2] 'rod'``."""
    return f"{section}[{index}] '{name}'" if isinstance(name, str) else f"{section}[{index}]"


def scene_errors(error: ValidationError, data: Any) -> list[SceneError]:
    """One `SceneError` for each thing pydantic refused in ``data``, in the order of the scene."""
    details = error.errors(include_url=False)
    found = [_translate(detail, data) for detail in details if detail["type"] != "default_factory_not_called"]
    return found or [SceneError("scene", "is not valid", "compare it with the JSON Schema")]


def _translate(detail: ErrorDetails, data: Any) -> SceneError:
    kind, context, value = detail["type"], detail.get("ctx", {}), detail["input"]
    path = _path(detail["loc"], data)
    if kind == "scene":
        key = context["key"]
        return SceneError(_join(path, key) if key else path, context["problem"], context["remedy"])
    if kind == "missing":
        last = detail["loc"][-1]
        return SceneError(
            path, "is missing", f"add {last}" if isinstance(last, str) else "give all entries of the list"
        )
    if kind == "union_tag_not_found":
        return SceneError(_join(path, "type"), "is missing", _EXAMPLES[str(detail["loc"][0])])
    if kind == "union_tag_invalid":
        return SceneError(_join(path, "type"), f"unknown type {show(context['tag'])}", _tags(context, context["tag"]))
    if kind == "literal_error":
        choices = re.findall(r"'([^']*)'", context["expected"])
        return SceneError(path, f"{show(value)} is not a possible value", did_you_mean(value, choices))
    if kind in _LIMITS:
        limit, words = _LIMITS[kind]
        return SceneError(path, f"{show(value)} is out of range", f"it must be {words} {context[limit]}")
    if kind in ("too_long", "string_too_long"):
        most = context["max_length"]
        return SceneError(path, "has too many entries or characters", f"give at most {most}")
    expected = next((words for start, words in _KINDS.items() if kind.startswith(start)), None)
    if expected:
        return SceneError(path, f"{show(value)} is not {expected}", f"give {expected}")
    return SceneError(path, detail["msg"], "compare it with the JSON Schema")


def _tags(context: dict[str, Any], tag: object) -> str:
    return did_you_mean(tag, re.findall(r"'([^']*)'", context.get("expected_tags", "")))


def _path(location: tuple[int | str, ...], data: Any) -> str:
    steps = [step for step in location if step != "[key]"]
    if len(steps) >= 2 and steps[0] in SECTIONS and isinstance(steps[1], int):
        section, index = str(steps[0]), steps[1]
        path = item_path(section, index, _name_of(data, section, index))
        steps = steps[3:]  # the third is the entry's type, put there by pydantic
    else:
        path = ""
        if steps[:1] == ["tables"]:
            del steps[2:3]  # its kind
    for step in steps:
        path = f"{path}[{step}]" if isinstance(step, int) else _join(path, step)
    return path or "scene"


def _name_of(data: Any, section: str, index: int) -> object:
    try:
        name = data[section][index]["name"]
    except (KeyError, IndexError, TypeError):
        return None
    return name if isinstance(name, str) and len(name) <= 80 else None


def _join(path: str, key: str) -> str:
    if not path or path == "scene":
        return key
    return f"{path}.{key}" if re.fullmatch(r"\w+", key) else f"{path}[{key!r}]"
