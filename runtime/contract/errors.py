"""The family of errors that the project raises on purpose: each says which item, what is wrong, and what to do.

Whatever is not of this family is a fault of the project itself.
"""

from __future__ import annotations

from numbers import Real

from runtime.contract.escapes import shown

LARGEST_NUMBER, LARGEST_INTEGER = 1e300, 2**63 - 1
LONGEST_MESSAGE = 2000  # characters: what was given may be as long as it likes, its echo may not


class SymgenError(Exception):
    """Something that a user can mend.

    Args:
        item: what is wrong, such as ``bodies[2] 'rod'.density``; or the whole message where it names the item itself.
        problem: what is wrong with it.
        remedy: what to do about it.
        also: further errors found in the same pass.
    """

    def __init__(self, item: str, problem: str = "", remedy: str = "", also: tuple[SymgenError, ...] = ()) -> None:
        super().__init__(item, problem, remedy, also)
        self.item = item
        self.problem = problem
        self.remedy = remedy
        self.also = also

    def __str__(self) -> str:
        parts = f"{self.item}: {self.problem}" if self.problem else self.item
        return clipped(printable(f"{parts}; {self.remedy}" if self.problem and self.remedy else parts))


def printable(text: str) -> str:
    """A message that moves no cursor and hides nothing: what is not printed, but for line ends, by its escape."""
    return "\n".join(map(shown, text.split("\n")))


def shown_value(value: object) -> str:
    """A value in a message: its repr, or its type where that is too deep or too long to print, or fails itself."""
    try:
        return clipped(repr(value))
    except Exception:
        return f"a {type(value).__name__}"


def is_finite_number(value: object) -> bool:
    """A real number that a float holds, and an integer that NumPy does; no bool."""
    most = LARGEST_INTEGER if isinstance(value, int) else LARGEST_NUMBER
    return isinstance(value, Real) and not isinstance(value, bool) and bool(abs(value) <= most)  # type: ignore[operator]


def clipped(text: str) -> str:
    """A message with its middle left out where it is longer than a person reads."""
    if len(text) <= LONGEST_MESSAGE:
        return text
    half = LONGEST_MESSAGE // 2
    return f"{text[:half]} ... ({len(text) - 2 * half} characters left out) ... {text[-half:]}"


class ArgumentError(SymgenError, ValueError):
    """An argument of a function that cannot be used."""


class ModelError(SymgenError, ValueError):
    """A generated model that cannot be used: missing, edited, stale, or asked for something it does not have."""


class CompilerError(SymgenError, RuntimeError):
    """What compiles a program is missing or failed."""


class NoResult(SymgenError, RuntimeError):
    """A study that came to no result, for a numerical reason that the message names."""
