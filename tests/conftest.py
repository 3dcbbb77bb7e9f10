"""Shared fixtures: built-in models as checked in, and scenes generated into a temporary folder (once a worker)."""

from __future__ import annotations

import os
from collections.abc import Callable

import pytest

from runtime.contract.loading import load_model
from runtime.contract.model import Model
from symgen.generate import generate
from symgen.scene import Scene
from symgen.scenes import generated_folder


@pytest.fixture(scope="session", autouse=True)
def compiled_cache(tmp_path_factory: pytest.TempPathFactory) -> None:
    """Compiled programs of the tests go to a temporary cache, unless the caller chose one."""
    os.environ.setdefault("SYMGEN_CACHE", str(tmp_path_factory.getbasetemp() / "compiled"))


@pytest.fixture(scope="session")
def built_in() -> Callable[[str], Model]:
    """Model of a built-in scene, from its emitted code in the repository."""
    models: dict[str, Model] = {}

    def load(name: str) -> Model:
        if name not in models:
            models[name] = load_model(generated_folder(name))
        return models[name]

    return load


@pytest.fixture(scope="session")
def model_of(tmp_path_factory: pytest.TempPathFactory) -> Callable[[Scene], Model]:
    """Model of any scene: generated into a temporary folder and loaded, once for equal scenes."""
    models: dict[str, Model] = {}

    def build(scene: Scene) -> Model:
        key = scene.to_toml()
        if key not in models:
            models[key] = load_model(generate(scene, tmp_path_factory.mktemp(scene.name)))
        return models[key]

    return build


@pytest.fixture(scope="session")
def build(tmp_path_factory: pytest.TempPathFactory) -> Callable[[Scene, frozenset[str] | None], Model]:
    """Model of any scene with the named functions only (None: all), generated anew."""
    return lambda scene, functions: load_model(generate(scene, tmp_path_factory.mktemp(scene.name), functions))
