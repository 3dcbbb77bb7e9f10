"""Shared fixtures: built-in models as checked in, and scenes generated into a temporary folder (once a worker)."""

from __future__ import annotations

import gc
import os
import signal
from collections.abc import Callable, Iterator
from typing import Any

import pytest

from runtime.model import Model, load_model
from symgen.generate import generate
from symgen.scene import SceneRecord
from symgen.scenes import SCENES, generated_folder

LONG = pytest.StashKey[bool]()

# `pytest` leaves out what is marked `long`; `pytest --all` runs everything, and so does `pytest PATH` of what is named.


def pytest_addoption(parser: pytest.Parser) -> None:
    """`--all`: also what is marked `long`. `--fresh-models`: see `built_in`."""
    parser.addoption("--all", action="store_true", help="also the tests that not every push needs (marked long)")
    parser.addoption("--fresh-models", action="store_true", help="generate the models of built-in scenes anew")


def pytest_configure(config: pytest.Config) -> None:
    """Whether long tests run is decided once, where the command line was read, and told to the workers."""
    told = getattr(config, "workerinput", None)
    named = config.args_source is not pytest.Config.ArgsSource.TESTPATHS
    config.stash[LONG] = bool(config.getoption("--all") or named) if told is None else bool(told["long"])


@pytest.hookimpl(optionalhook=True)
def pytest_configure_node(node: Any) -> None:
    """Of a worker of xdist."""
    node.workerinput["long"] = node.config.stash[LONG]


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Leave out what is long, unless it was asked for."""
    if not config.stash[LONG]:
        long = {item: is_long(item) for item in items}
        all_cases = {item.nodeid.partition("[")[0] for item in items if item.get_closest_marker("every_push")}
        nothing = all_cases - {item.nodeid.partition("[")[0] for item in items if not long[item]}
        if nothing and not config.option.keyword:
            raise pytest.UsageError(f"every_push names no case that is there: {sorted(nothing)}")
        items[:] = [item for item in items if not long[item]]
        config.hook.pytest_deselected(items=[item for item in long if long[item]])


def is_long(item: pytest.Item) -> bool:
    """Marked long, or a case of a matrix that its mark `every_push` does not name."""
    if item.get_closest_marker("long"):
        return True
    kept = item.get_closest_marker("every_push")
    if kept is not None and not kept.args:
        raise pytest.UsageError(
            f"{item.nodeid}: every_push names the cases of a matrix that every push runs; name them"
        )
    case = getattr(item, "callspec", None)
    return kept is not None and not any(case and f"-{name}-" in f"-{case.id}-" for name in kept.args)


@pytest.fixture(scope="session", autouse=True)
def compiled_cache(tmp_path_factory: pytest.TempPathFactory) -> None:
    """Compiled programs of the tests go to a temporary cache, unless the caller chose one."""
    os.environ.setdefault("SYMGEN_CACHE", str(tmp_path_factory.getbasetemp() / "compiled"))


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
