"""A model is pickled with the files of its folder: where that is not, a copy comes into the cache, hashes compared."""

from __future__ import annotations

import copyreg
import json
import zlib
from collections.abc import Mapping
from dataclasses import replace
from functools import lru_cache
from pathlib import Path
from types import MappingProxyType
from typing import Any, TypeVar

import casadi as ca

from runtime.contract.errors import ModelError
from runtime.contract.files import replacing, write_text
from runtime.contract.kept_models import FUNCTIONS, KeptFunctions, KeptModels, generated_aside, with_kept_functions
from runtime.contract.loading import load_folder, read_manifest
from runtime.contract.model import EmittedModel

KIND = "sent"  # folder of the cache
M = TypeVar("M", bound=EmittedModel)


def reduced(model: EmittedModel) -> tuple[Any, ...]:
    """What pickle keeps of a model: how it is loaded again. Raises ModelError for one without a folder."""
    if not model.folder:
        raise ModelError(f"model {model.name} was not loaded from a folder, and cannot be pickled without one")
    functions = {name: function.serialize() for name, function in model.sources.items()}
    numbers, files = dict(model.input_values), _packed(model.folder, model.digest)
    kept = model.builders.files() if isinstance(model.builders, KeptFunctions) else {}
    return reloaded, (type(model), model.folder, model.digest, numbers, functions, model.driven_by, files, kept)


@lru_cache(maxsize=8)
def _packed(folder: str, digest: str) -> bytes:
    """The files of a model's folder, compressed. Raises ModelError where they are no longer those of the hash."""
    path = Path(folder)
    manifest = read_manifest(path)
    if manifest["sha256"] != digest:
        raise ModelError(f"{folder}", "it was regenerated after this model was loaded", "load it again")
    names = ("manifest.json", *manifest["files"])
    return zlib.compress(json.dumps({name: (path / name).read_text(encoding="utf-8") for name in names}).encode())


def reloaded(
    kind: type[M],
    folder: str,
    digest: str,
    numbers: Mapping[str, float],
    functions: Mapping[str, str],
    driven_by: str,
    files: bytes,
    kept: Mapping[str, bytes] = MappingProxyType({}),
) -> M:
    """The model that was pickled: from its folder, if it still holds the same, else of its files. Raises ModelError.

    kept: functions that its files leave out, as they were kept in the cache.
    """
    try:
        found = load_folder(folder, kind, digest)
        if Path(folder).parent == KeptModels("models").folder.resolve():
            found = with_kept_functions(found, Path(folder))
    except ModelError:
        found = _unpacked(kind, files, digest, kept)
    sources = {name: ca.Function.deserialize(text) for name, text in functions.items()}
    return replace(found, input_values=dict(numbers), sources=sources, driven_by=driven_by)


def _unpacked(kind: type[M], files: bytes, digest: str, kept: Mapping[str, bytes]) -> M:
    """From the cache; where that cannot be used, from a folder of this process."""

    def write(folder: Path) -> Path:
        for name, text in json.loads(zlib.decompress(files)).items():
            if Path(name).name != name:
                raise ModelError("a pickled model", f"has a file {name!r}", "pickle it again")
            write_text(folder / name, text)
        for name, content in kept.items():
            if not name.isidentifier():
                raise ModelError("a pickled model", f"has a function {name!r}", "pickle it anew")
            with replacing(folder / FUNCTIONS / name) as temporary:
                temporary.write_bytes(content)
        return folder

    found = KeptModels(KIND).model(digest[:32], kind, write) or generated_aside(kind, write)
    if found.digest != digest:
        raise ModelError("a pickled model", "its files are not those of its hash", "pickle it again")
    return found


copyreg.pickle(EmittedModel, reduced)
