"""Shared fixtures: built-in models as checked in, and scenes generated into a temporary folder (once a worker)."""

from __future__ import annotations

import gc
import os
import signal
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from runtime.contract.loading import load_model
from runtime.contract.model import Model
from symgen.generate import generate
from symgen.scene import SceneRecord
from symgen.scenes import SCENES, generated_folder

# What `pytest -m fast` runs: folders and files whose tests together take less than 40 s on two cores.
TESTS = Path(__file__).parent
FAST = (
    "bad_scenes",
    "cases/test_published.py",
    "derivation",
    "fe/test_beams.py",
    "fe/test_errors.py",
    "hand_derived/test_generated_flexible.py",
    "hand_derived/test_generated_rigid.py",
    "hand_derived/spatial/test_spatial_twins_selfcheck.py",
    "house/test_architecture.py",
    "house/test_from_scratch.py",
    "house/test_inside_pages.py",
    "house/test_packaging.py",
    "house/test_words.py",
    "laws/test_augmented_form.py",
    "laws/test_condensation_laws.py",
    "laws/test_invariants.py",
    "laws/test_linear_sub_steps.py",
    "laws/test_loop_blocks.py",
    "laws/test_predictor_laws.py",
    "laws/test_printed_scheme_laws.py",
    "laws/test_quasi_static.py",
    "laws/test_redundant_constraints.py",
    "laws/test_single_rate_laws.py",
    "laws/test_spatial_loads.py",
    "laws/test_step_limits.py",
    "laws/test_sub_cycling_matrices.py",
    "running/test_solution.py",
    "scene/test_scene.py",
    "views/test_plots.py",
)


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Mark what is fast. A place on the list that is not there is a mistake in the list."""
    places = [TESTS / place for place in FAST]
    missing = [str(place) for place in places if not place.exists()]
    if missing:
        raise pytest.UsageError(f"tests/conftest.py lists as fast what is not there: {', '.join(missing)}")
    fast = {path for path in {item.path for item in items} if any(path.is_relative_to(place) for place in places)}
    for item in items:
        if item.path in fast:
            item.add_marker("fast")


@pytest.fixture(scope="session", autouse=True)
def compiled_cache(tmp_path_factory: pytest.TempPathFactory) -> None:
    """Compiled programs of the tests go to a temporary cache, unless the caller chose one."""
    os.environ.setdefault("SYMGEN_CACHE", str(tmp_path_factory.getbasetemp() / "compiled"))


def pytest_addoption(parser: pytest.Parser) -> None:
    """`--fresh-models`: see `built_in`."""
    parser.addoption("--fresh-models", action="store_true", help="generate the models of built-in scenes anew")


@pytest.fixture(scope="session")
def built_in(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Callable[[str], Model]:
    """Model of a built-in scene, from its emitted code in the repository (or generated anew: what the generator does
    now, not what it did when the code was checked in)."""
    models: dict[str, Model] = {}
    fresh = bool(request.config.getoption("--fresh-models"))

    def load(name: str) -> Model:
        if name not in models:
            folder = generate(SCENES[name](), tmp_path_factory.mktemp(name)) if fresh else generated_folder(name)
            models[name] = load_model(folder)
        return models[name]

    return load


@pytest.fixture(scope="session")
def model_of(tmp_path_factory: pytest.TempPathFactory) -> Callable[[SceneRecord], Model]:
    """Model of any scene: generated into a temporary folder and loaded, once for equal scenes."""
    models: dict[str, Model] = {}

    def build(scene: SceneRecord) -> Model:
        key = scene.to_toml()
        if key not in models:
            models[key] = load_model(generate(scene, tmp_path_factory.mktemp(scene.name)))
        return models[key]

    return build


@pytest.fixture(scope="session")
def build(tmp_path_factory: pytest.TempPathFactory) -> Callable[[SceneRecord, frozenset[str] | None], Model]:
    """Model of any scene with the named functions only (None: all), generated anew."""
    return lambda scene, functions: load_model(generate(scene, tmp_path_factory.mktemp(scene.name), functions))


def pytest_collection_finish() -> None:
    """What is imported and collected stays: the garbage collector need not look at it again with every test."""
    gc.collect()
    gc.freeze()
    gc.set_threshold(50_000, 50, 50)


@pytest.fixture
def ctrl_c() -> Iterator[None]:
    """SIGINT is heard as Python hears it, though the parent of the tests ignores it, as nohup and & do."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)
