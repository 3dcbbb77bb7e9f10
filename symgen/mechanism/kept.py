"""Models of scenes kept in the cache: generated once, loaded from then on without what derives.

A folder is named by its scene's text, the generator's files and the libraries.
"""

from __future__ import annotations

import hashlib
from dataclasses import replace
from importlib.metadata import version
from pathlib import Path
from typing import TYPE_CHECKING

from runtime.contract.files import stamp_of
from runtime.contract.kept_models import KeptFunctions, KeptModels
from runtime.model import Model, load_model

if TYPE_CHECKING:
    from symgen.mechanism.scene import SceneRecord

KEPT_COMPLETE = 40  # coordinates; of larger scenes each function is derived when it is first asked for
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

    derived: list[Model] = []

    def generated(folder: Path) -> Path:
        from symgen.derivation import generate, leave, model_of

        if scene.tables or len(scene.coordinates()) <= KEPT_COMPLETE:  # a function with tables is kept as text only
            return generate(scene, folder, largest=KEPT_COMPLETE)
        derived.append(model_of(scene))
        return leave(derived[0], folder)

    found = KeptModels("models").model(name, Model, generated)
    if found is None:
        from symgen.derivation import model_of

        return derived[0] if derived else model_of(scene)
    if derived and isinstance(found.builders, KeptFunctions):  # what this process has derived is not derived again
        return replace(found, builders=found.builders.of(derived[0].builders))
    return found


def _text_of(folder: Path) -> str | None:
    """The scene that a folder was generated from; None where there is none."""
    try:
        return (folder / "scene.toml").read_bytes().decode("utf-8")
    except (OSError, UnicodeDecodeError):
        return None
