"""What is imported when it is asked for: by the path `module:name`, so that a run brings in what it needs and no more.

Rooms below open so what stands above them, and what many runs do without.
"""

from __future__ import annotations

from importlib import import_module
from typing import Any


def opened(path: str) -> Any:
    """What `runtime.views.plots:energy` names, its module imported now."""
    module, _, name = path.partition(":")
    return getattr(import_module(module), name)
