"""The load types: each file of this folder is one, and says all that is known of it (`load.py` says what that is)."""

from __future__ import annotations

from importlib import import_module
from pathlib import Path

from symgen.loads.load import Load


def _types() -> dict[str, type[Load]]:
    """The load types of this folder by their name in a scene."""
    for path in sorted(Path(__file__).parent.glob("*.py")):
        if path.stem not in ("__init__", "load"):
            import_module(f"{__name__}.{path.stem}")
    return {cls.model_fields["type"].default: cls for cls in Load.__subclasses__()}


LOADS = _types()

__all__ = ["LOADS", "Load"]
