"""Scene in, folder of generated code out."""

from __future__ import annotations

from pathlib import Path

from symgen.emission.write import compare_model, emit, write_model
from symgen.pipeline import derive
from symgen.scene import Scene


def generate(scene: Scene, folder: str | Path, functions: frozenset[str] | None = None) -> Path:
    """Derive, condense and emit `scene` into `folder`; returns the folder.

    functions: names of the functions to emit (all by default; large models may leave the Jacobians out).
    Raises SceneError for bad scenes and for a folder that cannot be written.
    """
    target = Path(folder)
    write_model(emit(derive(scene, functions)), target)
    return target


def check(scene: Scene, folder: str | Path) -> str:
    """Unified diff between `folder` and what the generator emits now; empty if they agree."""
    return compare_model(emit(derive(scene)), Path(folder))
