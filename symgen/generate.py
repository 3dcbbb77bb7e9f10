"""Scene in, generated code out: what users call, and what the runtime finds by the entry point `symgen.functions`."""

from __future__ import annotations

from runtime.model import Model
from symgen.derivation import check, digest_on_demand, generate, leave, model_of
from symgen.mechanism.scene import SceneRecord

__all__ = ["check", "digest_on_demand", "generate", "leave", "model_of", "model_of_text"]


def model_of_text(scene_toml: str) -> Model:
    """`model_of` the scene of a TOML text: the entry point `symgen.functions` of the runtime. Raises SceneError."""
    return model_of(SceneRecord.from_toml_text(scene_toml))
