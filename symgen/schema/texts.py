"""Texts that people write into a scene: which characters they may hold.

Control characters, line separators and the marks that reverse the direction of reading have no place in a title: they
end comments, break XML, move the cursor of a terminal, or show a reader another text than a program reads. They are
refused where a scene is read, and every emitter escapes what is left by the rules of its own format.
"""

from __future__ import annotations

import unicodedata
from typing import Annotated

from pydantic import BeforeValidator, Field, Strict
from pydantic_core import PydanticCustomError

MAX_TEXT = 10_000
REFUSED = {
    "Cc": "control character",
    "Cs": "half a character (a lone surrogate)",
    "Zl": "line separator",
    "Zp": "paragraph separator",
}  # categories of Unicode
DIRECTION = frozenset("\u202a\u202b\u202c\u202d\u202e\u2066\u2067\u2068\u2069")  # of reading, embedded or overridden
BREAKS = frozenset("\n\t")  # in a text of several lines


def refused_character(text: str, breaks: bool = False) -> tuple[str, str] | None:
    """(what is wrong, what to do) of the first character that no text may hold; breaks: may it have several lines?"""
    for place, char in enumerate(text):
        if breaks and char in BREAKS:
            continue
        what = REFUSED.get(unicodedata.category(char))
        if char in DIRECTION:
            what = "mark that changes the direction of reading"
        elif 0xFDD0 <= ord(char) <= 0xFDEF or ord(char) & 0xFFFE == 0xFFFE:
            what = "code that is no character"
        if what is not None:
            problem = f"its character {place + 1}, U+{ord(char):04X}, is a {what}"
            if char in "\r\n\u2028\u2029\x85":
                return problem, "write line breaks as \\n" if breaks else "write it on one line"
            return problem, "remove it"
    return None


def _refuse(problem: str, remedy: str) -> PydanticCustomError:
    return PydanticCustomError("scene", "{problem}; {remedy}", {"problem": problem, "remedy": remedy, "key": ""})


def line(value: object) -> object:
    """A text of one line as a scene holds it; what is no text is left to the field's type.

    Raises the error that `scene_errors` turns into a SceneError.
    """
    return _checked(value, breaks=False) if isinstance(value, str) else value


def paragraph(value: object) -> object:
    """A text that may have several lines, whose ends become those of Unix; else as `line`."""
    return _checked(value.replace("\r\n", "\n"), breaks=True) if isinstance(value, str) else value


def _checked(text: str, breaks: bool) -> str:
    if len(text) > MAX_TEXT:
        raise _refuse(f"the text is {len(text)} characters long", f"shorten it to at most {MAX_TEXT} characters")
    found = refused_character(text, breaks)
    if found is not None:
        raise _refuse(*found)
    return text


Line = Annotated[str, Strict(), BeforeValidator(line), Field(max_length=MAX_TEXT)]
Text = Annotated[str, Strict(), BeforeValidator(paragraph), Field(max_length=MAX_TEXT)]
