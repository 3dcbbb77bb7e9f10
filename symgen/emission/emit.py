"""The text of a model's files."""

from __future__ import annotations

from symgen.emission.description import data_text, manifest_text
from symgen.emission.model_page import model_page
from symgen.emission.model_text import model_text
from symgen.pipeline import Derived


def emit(derived: Derived) -> dict[str, str]:
    """All files of the model by name."""
    files = {
        "model.py": model_text(derived),
        "data.json": data_text(derived),
        "model.md": model_page(derived),
        "scene.toml": derived.scene.to_toml(),
    }
    return {**files, "manifest.json": manifest_text(derived, files)}
