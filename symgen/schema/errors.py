"""The one error a scene can raise, and the small helpers that make its text useful."""

from __future__ import annotations

import difflib
import reprlib
from collections.abc import Iterable

from runtime.contract.errors import SymgenError


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
    """Say which known name is nearest to ``wrong``, or list the known names."""
    names = list(known)
    close = difflib.get_close_matches(str(wrong)[:80], names, n=1, cutoff=0.6)
    if close:
        return f"did you mean '{close[0]}'?"
    if not names:
        return "there is nothing to choose from here"
    listed = ", ".join(names[:12]) + (", ..." if len(names) > 12 else "")
    return f"known: {listed}"


def show(value: object) -> str:
    """A short representation of any value, also of integers too long to print."""
    if isinstance(value, int) and abs(value) >= 10**20:
        return f"an integer of {value.bit_length()} bits"
    try:
        return reprlib.repr(value)
    except (ValueError, RecursionError):
        return f"a {type(value).__name__}"
