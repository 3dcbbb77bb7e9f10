"""Couplings, rows between coordinates of joints: each file is a type (`coupling.py` says what that is)."""

from __future__ import annotations

from importlib import import_module
from pathlib import Path

from symgen.couplings.coupling import Coupling


def _types() -> dict[str, type[Coupling]]:
    """The types of this folder by their name in a scene."""
    for path in sorted(Path(__file__).parent.glob("*.py")):
        if path.stem not in ("__init__", "coupling"):
            import_module(f"{__name__}.{path.stem}")
    return {cls.model_fields["type"].default: cls for cls in Coupling.__subclasses__()}


COUPLINGS = _types()

__all__ = ["COUPLINGS", "Coupling"]
