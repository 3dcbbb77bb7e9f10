"""A generated folder: its manifest with the hashes of its files, loaded so that exactly the text that was checked
runs, and the functions that it leaves out, derived from its scene when they are asked for.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable, Iterable, Mapping
from functools import cache, partial
from importlib.abc import InspectLoader
from importlib.util import module_from_spec, spec_from_loader
from pathlib import Path
from types import ModuleType
from typing import Any, TypeVar

import casadi as ca
import numpy as np

from runtime.contract.errors import ModelError, SymgenError
from runtime.contract.model import EmittedModel
from runtime.contract.records import Description, as_plain, description
from runtime.contract.tape import table_from

# manifest.json: the description of a model with the hashes of its files, and what guards it against edits.

FORMAT = 3
# What an old folder is told, by its format.
OLDER = {1: "symgen 0.3 or older", 2: "a version between 0.3 and 0.4"}


def manifest_text(
    described: Description, files: Mapping[str, str], versions: Mapping[str, str], more: Mapping[str, Any]
) -> str:
    """The manifest as text, one record a line; files: name -> contents; more: what else is kept.

    Default values of parameters are data, so they are left to data.json.
    """
    plain = as_plain(described)
    for entry in plain["parameters"]:
        del entry["default"]
    manifest = {
        "format": FORMAT,
        **plain,
        **more,
        "files": {name: sha256(text) for name, text in files.items()},
        "versions": dict(versions),
    }
    manifest["sha256"] = manifest_digest(manifest)
    return "{\n" + ",\n".join(f" {json.dumps(key)}: {_value(value)}" for key, value in manifest.items()) + "\n}\n"


def _value(value: Any) -> str:
    """A list of records with each on a line of its own, everything else on one line."""
    if isinstance(value, list) and value and isinstance(value[0], dict):
        return "[\n" + ",\n".join(f"  {json.dumps(entry)}" for entry in value) + "\n ]"
    return json.dumps(value)


def described(manifest: Mapping[str, Any], defaults: Mapping[str, float]) -> Description:
    """The description in a manifest, with the default values of its parameters by name."""
    parameters = [{**entry, "default": defaults[entry["name"]]} for entry in manifest["parameters"]]
    return description({**manifest, "parameters": parameters})


def manifest_digest(manifest: Mapping[str, Any]) -> str:
    """SHA-256 of a manifest without its versions and its own hash."""
    kept = {key: value for key, value in manifest.items() if key not in ("versions", "sha256")}
    return hashlib.sha256(json.dumps(kept, sort_keys=True).encode()).hexdigest()


def sha256(text: str) -> str:
    """Hexadecimal SHA-256 of a text in UTF-8."""
    return hashlib.sha256(text.encode()).hexdigest()


# Functions that a folder leaves out: derived from its scene when they are asked for.
#
# Deriving needs the generator, which this package does not have: it is found by its entry point `symgen.functions`.

ENTRY_POINTS = "symgen.functions"
Builders = Mapping[str, Callable[[], ca.Function]]
SAME = ("coordinates", "q_i", "q_d", "groups", "constraints", "redundant", "bounded", "inputs")


def left_out(folder: Path, names: Iterable[str], described: Description, scene_toml: str) -> Builders:
    """What builds each function of these names, with the arguments of the emitted ones, c = p among them.

    A builder raises ModelError where no generator is installed, where it refuses the scene, and where the installed
    one chooses other coordinates or parameters than the folder has.
    """

    @cache
    def builders() -> Builders:
        from importlib.metadata import entry_points  # takes as long to import as a short run

        found = next(iter(entry_points(group=ENTRY_POINTS)), None)
        if found is None:
            raise _refused(folder, "no generator is installed", "install symgen beside the runtime")
        try:
            model = found.load()(scene_toml)
        except SymgenError as error:
            raise _refused(folder, str(error), "generate the folder anew") from error
        own = [entry.name for entry in described.parameters]
        if own != [entry.name for entry in model.description.parameters] or any(
            getattr(model.description, what) != getattr(described, what) for what in SAME
        ):
            raise _refused(folder, "the installed version derives another model of its scene", "generate it anew")
        derived: Builders = model.builders
        return derived

    def build(name: str) -> ca.Function:
        return builders()[name]()

    return {name: partial(build, name) for name in names}


def _refused(folder: Path, problem: str, remedy: str) -> ModelError:
    item = f"{folder} leaves out functions that it was not requested when it was written"
    return ModelError(item, problem, f"{remedy}, or write all with: symgen generate {folder} --complete")


# Load a generated folder: check its hashes, then run exactly the text that was checked.


class _CheckedSource(InspectLoader):
    """Runs a text already in memory: neither read again nor taken from a bytecode cache."""

    def __init__(self, text: str) -> None:
        self._text = text

    def get_source(self, fullname: str) -> str:
        """The text that was checked."""
        return self._text


M = TypeVar("M", bound=EmittedModel)


def load_folder(
    folder: str | Path, kind: type[M], digest: str | None = None, read: Callable[[Path], bytes] = Path.read_bytes
) -> M:
    """The model in a folder, as one of this kind, after comparing its files with the manifest's hashes.

    digest: that of the model that is meant; another one is refused before any of its code runs. read: how its files are
    read; what raises OSError there is not loaded. Raises ModelError if
    files are missing, were edited since generation, or belong to another format.
    """
    path = Path(folder)
    manifest = read_manifest(path, read)
    if digest is not None and manifest["sha256"] != digest:
        raise ModelError(f"{path}", "it holds a different model: it was regenerated", "start again with it")
    try:
        texts = {name: _checked_text(path / name, expected, read) for name, expected in manifest["files"].items()}
        module = _module(path / "model.py", texts["model.py"])
        return _model(kind, path, manifest, json.loads(texts["data.json"]), module, texts.get("scene.toml", ""))
    except (KeyError, TypeError, ValueError, AttributeError) as error:
        if isinstance(error, ModelError):
            raise
        raise ModelError(
            f"{path} is incomplete or was edited ({type(error).__name__}: {error}); "
            f"regenerate with: symgen generate {path}"
        ) from error


def read_manifest(path: Path, read: Callable[[Path], bytes] = Path.read_bytes) -> dict[str, Any]:
    """The manifest of a folder, its own hash checked. Raises ModelError."""
    try:
        manifest = json.loads(read(path / "manifest.json").decode("utf-8"))
    except (OSError, UnicodeDecodeError, json.JSONDecodeError, RecursionError) as error:
        raise ModelError(
            f"{path} is not a generated model (manifest.json: {error}); "
            f"generate it with: symgen generate SCENE --out {path}"
        ) from error
    if not isinstance(manifest, dict) or manifest.get("format") != FORMAT:
        found = manifest.get("format") if isinstance(manifest, dict) else None
        by = f", by {OLDER[found]}," if isinstance(found, int) and found in OLDER else ""
        raise ModelError(
            f"{path} was generated{by} in another format ({found!r}, where this version reads {FORMAT}); "
            f"regenerate it with: symgen generate {path}"
        )
    if manifest.get("sha256") != manifest_digest(manifest):
        raise ModelError(
            f"{path / 'manifest.json'} was edited since it was generated; regenerate with: symgen generate {path}"
        )
    return manifest


def _checked_text(path: Path, expected: str, read: Callable[[Path], bytes]) -> str:
    remedy = f"regenerate with: symgen generate {path.parent}"
    try:
        text = read(path).decode("utf-8")  # line ends as they are: the hash is of the bytes
    except (OSError, UnicodeDecodeError) as error:
        raise ModelError(f"{path} cannot be read ({error}); {remedy}") from error
    if hashlib.sha256(text.encode()).hexdigest() != expected:
        raise ModelError(f"{path} was edited since it was generated (its hash differs from manifest.json); {remedy}")
    return text


def _module(path: Path, text: str) -> ModuleType:
    name = f"generated_model_{hashlib.sha256(text.encode()).hexdigest()[:16]}"
    loader = _CheckedSource(text)
    spec = spec_from_loader(name, loader, origin=str(path))
    assert spec is not None
    module = module_from_spec(spec)
    loader.exec_module(module)
    return module


def _model(
    kind: type[M], path: Path, manifest: dict[str, Any], data: dict[str, Any], module: ModuleType, scene_toml: str
) -> M:
    found = described(manifest, data["p"])
    names = [coordinate.name for coordinate in found.coordinates]
    for name, plain in data.get("tables", {}).items():
        module.TABLES[name] = table_from(plain).shared()
    return kind(
        description=found,
        initial_q=np.array([data["q"][name] for name in names]),
        initial_q_dot=np.array([data["q_dot"][name] for name in names]),
        builders={**module.FUNCTIONS, **left_out(path, manifest.get("left_out", ()), found, scene_toml)},
        initial_changes={name: (given, used) for name, (given, used) in data["changed"].items()},
        assembly=tuple(data.get("assembled", ())),
        digest=manifest["sha256"],
        scene_toml=scene_toml,
        folder=str(path.resolve()),
    )


def _reloaded(*_: Any) -> None:
    """Where pickles of version 0.4 and older lead. Raises ModelError."""
    raise ModelError("this pickle of a model", "was written by an older version", "load the folder with load_model")
