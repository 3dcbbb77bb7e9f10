"""What is imported when it is asked for: by the path `module:name`, so that a run brings in what it needs and no more.

Rooms below open so what stands above them, and what many runs do without.
"""

from __future__ import annotations

from importlib import import_module
from types import MethodType
from typing import Any


def opened(path: str) -> Any:
    """What `runtime.views.plots:energy` names, its module imported now."""
    module, _, name = path.partition(":")
    return getattr(import_module(module), name)


class Door:
    """A method that is a function of another room, whose first argument is the object; it is imported when asked for.

    Signature and docstring are those of the function: `help(model.simulate)` shows them.
    """

    def __init__(self, path: str) -> None:
        self.path = path

    def __get__(self, owner: Any, kind: type | None = None) -> Any:
        function = opened(self.path)
        return function if owner is None else MethodType(function, owner)
