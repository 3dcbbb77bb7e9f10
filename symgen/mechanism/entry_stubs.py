"""Signatures of the methods of `Scene` that add an entry, for type checkers, editors and the site: `entries.pyi`.

The methods are made of the records at run time, which no checker sees. `python -m symgen.mechanism.entry_stubs` writes
the file again; a test compares it with the records.
"""

from __future__ import annotations

from pathlib import Path
from textwrap import indent
from types import NoneType
from typing import Any, Literal, get_args, get_origin

from runtime.contract.lazy_method import LazyMethod
from symgen.mechanism.builder import ENTRIES, Scene
from symgen.mechanism.entry_docs import EntryField, alternatives, entry_doc, entry_fields
from symgen.scene.bodies import Orientation
from symgen.schema.fields import StrictModel

ORIENTATIONS = get_args(Orientation)[0]
STUBS = Path(__file__).with_name("entries.pyi")
HEAD = '''# ruff: noqa: E501
"""Methods of `Scene` that add a body, a joint, a coupling or a load, from the fields of their records.

Written by `python -m symgen.mechanism.entry_stubs`.
"""

from collections.abc import Mapping, Sequence
from typing import Any, Literal, Self, TypeAlias

import numpy as np

Quantity: TypeAlias = float | str | np.number[Any]
Array: TypeAlias = Sequence[Any] | np.ndarray[Any, Any]
Orientation: TypeAlias = Literal[
    ORIENTATIONS
]

class SceneEntries:
    """Bodies, joints, couplings and loads that can be added to a `Scene`, a method for each type."""
'''


def stub_text() -> str:
    """The text of `entries.pyi`."""
    methods = [
        _method(section, type, record)
        for section, records in ENTRIES.items()
        for type, record in records.items()
        if isinstance(vars(Scene)[type], LazyMethod)
    ]
    return HEAD.replace("ORIENTATIONS", _words(ORIENTATIONS)) + "".join(methods)


def _method(section: str, type: str, record: type[StrictModel]) -> str:
    fields = entry_fields(record)
    required = [f"{one.name}: {_annotation(one)}," for one in fields if one.required]
    optional = [f"{one.name}: {_annotation(one)} = ...," for one in fields if not one.required]
    lines = ["self,", "name: str,", *required, *(["*,", *optional] if optional else [])]
    doc = indent(f'"""{entry_doc(section, type, record)}\n"""', "        ", lambda line: bool(line.strip()))
    return f"\n    def {type}(\n" + "".join(f"        {line}\n" for line in lines) + f"    ) -> Self:\n{doc}\n"


def _annotation(field: EntryField) -> str:
    kinds = [_kind(one, field) for one in alternatives(field.info.annotation)]
    if "Quantity" in kinds:
        kinds = [kind for kind in kinds if kind not in ("float", "str")]
    return " | ".join(
        dict.fromkeys([*(kind for kind in kinds if kind != "None"), *(["None"] if "None" in kinds else [])])
    )


def _kind(annotation: Any, field: EntryField) -> str:
    origin = get_origin(annotation)
    if origin is Literal:
        return "Orientation" if annotation == ORIENTATIONS else f"Literal[{_words(annotation)}]"
    if origin is tuple:
        return "Mapping[str, Any] | Array" if field.records else "Array"
    if origin is dict:
        return "Mapping[str, Any]"
    if isinstance(annotation, type) and issubclass(annotation, StrictModel):
        return "Mapping[str, Any]"
    if annotation is NoneType:
        return "None"
    return "Quantity" if annotation in (float, str) and field.meaning is not None else annotation.__name__


def _words(literal: Any) -> str:
    return ", ".join(f'"{word}"' for word in get_args(literal))


if __name__ == "__main__":
    STUBS.write_text(stub_text(), encoding="utf-8")
