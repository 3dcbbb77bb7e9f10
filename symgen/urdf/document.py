"""The elements of an XML file of unknown origin: no entities, no DOCTYPE, bounded size and depth."""

from __future__ import annotations

import os
import stat
from pathlib import Path
from typing import NoReturn
from xml.etree.ElementTree import Element, TreeBuilder
from xml.parsers import expat

from symgen.schema.errors import SceneError

MAX_BYTES = 50_000_000
MAX_DEPTH = 100


def read_document(path: str | Path) -> Element:
    """The root element of a file. Raises SceneError for what is no ordinary file, no XML, too large or hostile."""
    item = f"file '{path}'"
    try:
        if not stat.S_ISREG(os.stat(path).st_mode):  # a pipe or a device may never end
            raise SceneError(item, "is not an ordinary file", "give the path of a URDF file")
        with open(path, "rb") as file:
            content = file.read(MAX_BYTES + 1)
    except (OSError, ValueError, TypeError) as error:
        raise SceneError(item, f"cannot be read ({error})", "give the path of a URDF file") from None
    if len(content) > MAX_BYTES:
        raise SceneError(item, "is larger than 50 MB", "give a URDF file")
    return parse_document(content, item)


def parse_document(content: bytes, item: str) -> Element:
    """The root element of XML text."""
    builder, depth = TreeBuilder(), 0

    def begin(tag: str, attributes: dict[str, str]) -> None:
        nonlocal depth
        depth += 1
        if depth > MAX_DEPTH:
            raise SceneError(item, f"nests elements more than {MAX_DEPTH} deep", "give a URDF file")
        builder.start(tag, attributes)

    def end(tag: str) -> None:
        nonlocal depth
        depth -= 1
        builder.end(tag)

    def refuse(*_: object) -> NoReturn:
        raise SceneError(item, "declares a document type or an entity, which URDF does not need", "remove it")

    parser = expat.ParserCreate()
    parser.StartElementHandler, parser.EndElementHandler = begin, end
    parser.StartDoctypeDeclHandler = parser.EntityDeclHandler = parser.ExternalEntityRefHandler = refuse
    try:
        parser.Parse(content, True)
    except (expat.ExpatError, ValueError, LookupError) as error:
        raise SceneError(item, f"is not XML ({error})", "give a URDF file; a xacro file is expanded first") from None
    return builder.close()
