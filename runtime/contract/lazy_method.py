"""Methods that are functions of other packages, imported when they are asked for."""

from __future__ import annotations

from collections.abc import Callable
from types import MethodType
from typing import Any


class LazyMethod:
    """A method that is a function elsewhere, whose first argument is the object: a run imports what it needs.

    `load` imports the function and returns it. Signature and docstring are the function's: `help` shows them.
    """

    def __init__(self, load: Callable[[], Any]) -> None:
        self.load = load

    def __get__(self, owner: Any, kind: type | None = None) -> Any:
        function = self.load()
        return function if owner is None else MethodType(function, owner)
