"""Models of scenes kept in the cache: generated once, loaded from then on without what derives.

A folder is named by its scene's text, the generator's files and the libraries.
"""

from __future__ import annotations

import hashlib
from importlib.metadata import version
from pathlib import Path
from typing import TYPE_CHECKING

from runtime.contract.files import stamp_of
from runtime.contract.kept_models import KeptModels
from runtime.model import Model, load_model

if TYPE_CHECKING:
    from symgen.mechanism.scene import SceneRecord

KEPT_COMPLETE = 40  # coordinates; of longer trees what grows with the square of their length is derived when asked for
PACKAGE = Path(__file__).resolve().parents[1]
FOLLOWED = (PACKAGE, PACKAGE.parent / "runtime" / "contract")  # what generated code follows from
LIBRARIES = ("casadi", "sympy")


def kept_model(scene: SceneRecord) -> Model:
    """The model of a scene, generated where it is not kept.

    A built-in scene as it stands is loaded from the code that comes with it. Where the cache cannot be used, functions
    are derived on demand. Raises SceneError for a bad scene.
    """
    text = scene.to_toml()
    own = PACKAGE.parent / "generated" / scene.name
    if _text_of(own) == text:
        return load_model(own)
    facts = [stamp_of(*FOLLOWED), *(version(library) for library in LIBRARIES), text]
    name = f"{scene.name}-{hashlib.sha256(repr(facts).encode()).hexdigest()[:24]}"

    def generated(folder: Path) -> Path:
        from symgen.derivation import generate

        return generate(scene, folder, largest=KEPT_COMPLETE)

    found = KeptModels("models").model(name, Model, generated)
    if found is None:
        from symgen.derivation import model_of

        return model_of(scene)
    return found


def _text_of(folder: Path) -> str | None:
    """The scene that a folder was generated from; None where there is none."""
    try:
        return (folder / "scene.toml").read_bytes().decode("utf-8")
    except (OSError, UnicodeDecodeError):
        return None
