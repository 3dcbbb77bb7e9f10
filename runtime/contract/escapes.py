"""Text of a user inside another language: each function gives text that the language reads as data.

The scene refuses control characters, but nothing here relies on it: a model may come from a folder.
"""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Iterable
from xml.sax.saxutils import quoteattr

_NOT_IN_XML = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")  # XML 1.0, production 2
_MARKDOWN = re.compile(r"([\\`*\[\]|#~$]|(?<![A-Za-z0-9])_|_(?![A-Za-z0-9]))")
_BLOCK = re.compile(r"^(\d*)([-+=.)])(?=\s|[-=]*\s*$)")  # what begins a list or underlines a heading


def shown(text: str) -> str:
    """On one line, what is not printed by its Python escape."""
    if text.isprintable():
        return text
    return "".join(char if char.isprintable() else char.encode("unicode_escape").decode() for char in text)


def python_docstring(lines: Iterable[str]) -> str:
    """A docstring literal whose value is these lines: no quote and no backslash in them ends or changes it."""
    escaped = (shown(line.replace("\\", "\\\\")).replace('"', '\\"') for line in lines)
    return '"""' + "\n".join(escaped) + '"""'


def c_comment(text: str) -> str:
    """What may stand on a line inside a C comment: it neither ends it nor joins it to the next line."""
    plain = shown(text.replace("\\", "\\\\"))
    return plain.replace("*/", "* /").replace("/*", "/ *").replace("??/", "?? /")


def c_string(text: str) -> str:
    """A C string of UTF-8, in ASCII."""
    plain = {34: '\\"', 92: "\\\\", 63: "\\?"}
    encoded = text.encode("utf-8", "replace")
    return '"' + "".join(plain.get(b) or (chr(b) if 32 <= b < 127 else f"\\{b:03o}") for b in encoded) + '"'


def xml_attribute(text: str) -> str:
    """A quoted attribute of XML 1.0; what the standard does not allow becomes U+FFFD."""
    return quoteattr(_NOT_IN_XML.sub("\ufffd", text))


def words(names: Iterable[str], longest: int | None = None, taken: Iterable[str] = ()) -> list[str]:
    """Names with _ for what is not a letter, digit or _, cut to `longest` signs; numbers at the end keep them apart."""
    found, used = list[str](), set(taken)
    for name in names:
        plain, k = re.sub(r"\W", "_", name)[:longest], 2
        own = plain
        while own in used:
            own, k = f"{plain}_{k}", k + 1
        found.append(own)
        used.add(own)
    return found


def csv_row(cells: Iterable[str]) -> str:
    """Cells on a line, in quotes where they hold commas or quotes; without the line's end."""
    text = io.StringIO()
    csv.writer(text, lineterminator="").writerow(cells)
    return text.getvalue()


def markdown(text: str) -> str:
    """Markdown that shows the text as it is, on one line, in a cell of a table, too."""
    plain = _MARKDOWN.sub(r"\\\1", shown(text).strip())
    plain = plain.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")
    return _BLOCK.sub(r"\1\\\2", plain)


def markdown_lines(text: str) -> str:
    """Markdown of a text of several lines."""
    return "\n".join(map(markdown, text.split("\n")))
