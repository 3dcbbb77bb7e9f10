"""Models of scenes kept in the cache: generated once, loaded from then on without what derives.

A folder is named by its scene's text, the generator's files and the libraries. It must be the user's own and closed to
others, as all of the cache, since the code in it is run.
"""

from __future__ import annotations

import contextlib
import hashlib
import os
import shutil
import tempfile
from importlib.metadata import version
from pathlib import Path
from typing import TYPE_CHECKING

from runtime.contract.errors import ModelError
from runtime.contract.files import cache_folder, refused_folder, stamp_of
from runtime.model import Model, load_model

if TYPE_CHECKING:
    from symgen.scene.scene import SceneRecord

MOST_KEPT = 100  # models
KEPT_COMPLETE = 40  # coordinates; of longer trees what grows with the square of their length is derived when asked for
PACKAGE = Path(__file__).resolve().parents[1]
FOLLOWED = (PACKAGE, PACKAGE.parent / "runtime" / "contract")  # what generated code follows from
LIBRARIES = ("casadi", "sympy")


def models_folder() -> Path:
    """Where models are kept."""
    return cache_folder() / "models"


def kept_model(scene: SceneRecord) -> Model:
    """The model of a scene, generated where it is not kept.

    A built-in scene as it stands is loaded from the code that comes with it. Where the cache cannot be used, functions
    are derived on demand. Raises SceneError for a bad scene.
    """
    text = scene.to_toml()
    own = PACKAGE.parent / "generated" / scene.name
    if _text_of(own) == text:
        return load_model(own)
    models = models_folder()
    if refused_folder(models):
        from symgen.generate import model_of

        return model_of(scene)
    facts = [stamp_of(*FOLLOWED), *(version(library) for library in LIBRARIES), text]
    folder = models / f"{scene.name}-{hashlib.sha256(repr(facts).encode()).hexdigest()[:24]}"
    try:
        found = load_model(folder)
        os.utime(folder)  # the least recently used go first
        return found
    except (ModelError, OSError):
        _write(scene, folder)
        return load_model(folder)


def _write(scene: SceneRecord, folder: Path) -> None:
    """The folder, complete at once: another process sees all of it or nothing. The oldest go where there are many."""
    from symgen.generate import generate

    with tempfile.TemporaryDirectory(dir=folder.parent) as place:
        made = Path(generate(scene, Path(place) / "model", largest=KEPT_COMPLETE))
        shutil.rmtree(folder, ignore_errors=True)  # one that cannot be loaded
        with contextlib.suppress(OSError):  # another process was first
            made.rename(folder)
    used = sorted((one for one in folder.parent.iterdir() if one.is_dir()), key=lambda one: one.stat().st_mtime)
    for old in used[:-MOST_KEPT]:
        shutil.rmtree(old, ignore_errors=True)


def _text_of(folder: Path) -> str | None:
    """The scene that a folder was generated from; None where there is none."""
    try:
        return (folder / "scene.toml").read_bytes().decode("utf-8")
    except (OSError, UnicodeDecodeError):
        return None
