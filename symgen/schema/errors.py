"""The one error a scene can raise, and the small helpers that make its text useful."""

from __future__ import annotations

import difflib
import reprlib
from collections.abc import Iterable

from runtime.contract.errors import SymgenError

MOST_LISTED = 24


class SceneError(SymgenError, ValueError):
    """Something in a scene is wrong; says where, what, and what to do.

    Args:
        item: path of the item, such as ``bodies[2] 'rod'.density``.
        problem: what is wrong with it.
        remedy: what to do about it; never empty.
        also: further errors found in the same pass.
    """


def raise_all(errors: Iterable[SceneError]) -> None:
    """Raise the first of ``errors`` with the others attached to it; return if there are none."""
    found = list(errors)
    if found:
        first = found[0]
        raise SceneError(first.item, first.problem, first.remedy, tuple(found[1:]))


def did_you_mean(wrong: object, known: Iterable[str]) -> str:
    """Say which known name is nearest to ``wrong``, whatever its case, or list the known names, of many the nearest."""
    names, word = list(known), wrong[:80] if isinstance(wrong, str) else show(wrong)[:80]
    by_case = {name.casefold(): name for name in names}
    for asked, own in ((word, names), (word.casefold(), list(by_case))):
        if close := difflib.get_close_matches(asked, own, n=1, cutoff=0.6):
            return f"did you mean '{by_case.get(close[0], close[0])}'?"
    if not names:
        return "there is nothing to choose from here"
    if len(names) > MOST_LISTED:
        names = [*difflib.get_close_matches(word, names, n=MOST_LISTED, cutoff=0.0), "..."]
    return f"known: {', '.join(names)}"


def show(value: object) -> str:
    """A short representation of any value, also of integers too long to print."""
    if isinstance(value, int) and abs(value) >= 10**20:
        return f"an integer of {value.bit_length()} bits"
    try:
        return reprlib.repr(value)
    except (ValueError, RecursionError):
        return f"a {type(value).__name__}"
