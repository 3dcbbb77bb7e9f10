"""The joint types: each file of this folder is one, and says all that is known of it (`joint.py` says what that is)."""

from __future__ import annotations

from importlib import import_module
from pathlib import Path

from symgen.joints.joint import Joint


def _types() -> dict[str, type[Joint]]:
    """The joint types of this folder by their name in a scene."""
    for path in sorted(Path(__file__).parent.glob("*.py")):
        if path.stem not in ("__init__", "joint"):
            import_module(f"{__name__}.{path.stem}")
    return {cls.model_fields["type"].default: cls for cls in Joint.__subclasses__()}


JOINTS = _types()

__all__ = ["JOINTS", "Joint"]
