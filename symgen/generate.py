"""Scene in, folder of generated code out."""

from __future__ import annotations

import json
import shutil
import tempfile
from pathlib import Path

from runtime.contract.cache import cache_folder
from symgen.emission.write import compare_model, emit, kept, write_model
from symgen.pipeline import derive
from symgen.scene import Scene, SceneError


def generate(scene: Scene, folder: str | Path, functions: frozenset[str] | None = None, to_keep: bool = False) -> Path:
    """Derive, condense and emit `scene` into `folder`; returns the folder.

    functions: names of the functions to emit (all by default; large models may leave the Jacobians out). to_keep: leave
    out what a repository does not keep of a large model. Raises SceneError for bad scenes and for a folder that cannot
    be written.
    """
    target = Path(folder)
    files = emit(derive(scene, functions))
    written = kept(files) if to_keep else files
    write_model(written, target)
    for name in files.keys() - written.keys():
        (target / name).unlink(missing_ok=True)
    return target


def check(scene: Scene, folder: str | Path, functions: frozenset[str] | None = None, kept_only: bool = False) -> str:
    """Unified diff between `folder` and what the generator emits now; empty if they agree.

    kept_only: the folder holds what a repository keeps; the manifest's hashes stand for the rest.
    """
    files = emit(derive(scene, functions))
    return compare_model(kept(files) if kept_only else files, Path(folder))


def completed(scene: Scene, folder: Path) -> Path:
    """The folder itself if it has its code, else one in the cache that has: made on first use, never half-written.

    folder: what a repository keeps of the scene. Raises SceneError if there is none, or the cache cannot be written.
    """
    if (folder / "model.py").is_file():
        return folder
    expected = _hash_of_code(folder)
    target = cache_folder() / "models" / f"{scene.name}-{(expected or 'new')[:16]}"
    if expected is not None and _hash_of_code(target) == expected and (target / "model.py").is_file():
        return target
    try:
        target.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=target.parent, prefix=".making-") as work:
            made = generate(scene, Path(work) / "model")
            shutil.rmtree(target, ignore_errors=True)
            made.replace(target)
    except OSError as error:
        if not (target / "manifest.json").is_file():  # else another process was faster
            raise SceneError(
                str(target), f"cannot be written ({error})", "set SYMGEN_CACHE to another folder"
            ) from error
    return target


def _hash_of_code(folder: Path) -> str | None:
    """SHA-256 of model.py by the folder's manifest."""
    try:
        return str(json.loads((folder / "manifest.json").read_text(encoding="utf-8"))["files"]["model.py"])
    except (OSError, ValueError, KeyError, TypeError):
        return None
