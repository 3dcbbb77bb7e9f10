"""Variants of a model: the same scene with other independent coordinates, from a cache or generated on demand.

Generating needs the derivation, which this package does not have: it is found by its entry point `symgen.variants`, or
handed over with `use_generator`. Without one, runs that need a variant end with the status `partition_lost`.
"""

from __future__ import annotations

import hashlib
import inspect
import json
import tempfile
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from importlib.metadata import entry_points
from pathlib import Path

import numpy as np

from runtime.contract.errors import ModelError, SymgenError
from runtime.contract.files import cache_folder
from runtime.contract.loading import load_model
from runtime.contract.model import Model

ENTRY_POINTS = "symgen.variants"
Generate = Callable[..., Path]
_handed: list[Generate] = []


class NoVariant(ModelError):
    """A variant that cannot be had; the message says why and what to do."""


def use_generator(generate: Generate | None) -> None:
    """Take this function for the one of the entry point; None: take the entry point again.

    generate(scene_toml_text, independent, groups, folder, state=..., redundant=...) writes a model into the folder.
    """
    _handed[:] = [] if generate is None else [generate]


def variant_of(model: Model, q_i: Sequence[str], q: np.ndarray) -> Model:
    """The model of the same scene with other q_i, group by group in the same places; q: coordinates where it is needed.

    Raises NoVariant.
    """
    groups = [(group.name, [q_i[k] for k in group.positions]) for group in model.groups]
    generate = _generator()
    if generate is None or not model.scene_toml:
        raise NoVariant(
            f"no generator of variants is installed; set partition.independent = {list(q_i)} in the scene, "
            "or install symgen beside the runtime, and run again"
        )
    key = json.dumps([model.digest, list(q_i), groups, made_by(generate)])
    folder = cache_folder() / "variants" / hashlib.sha256(key.encode()).hexdigest()[:32]
    found = _loaded(folder)
    if found is None:
        _generate(generate, model, q_i, groups, q, folder)
        found = load_model(folder)
    same = ("coordinates", "constraints", "elastic", "measures", "joints")
    if (
        any(getattr(found, name) != getattr(model, name) for name in same)
        or list(found.q_i) != list(q_i)
        or [entry.name for entry in found.parameters] != [entry.name for entry in model.parameters]
    ):
        raise NoVariant(
            f"the variant of {model.name} with q_i = {', '.join(q_i)} does not match the model; "
            "regenerate the model with the installed version"
        )
    return replace(found, input_values=model.input_values, sources=model.sources)


def _loaded(folder: Path) -> Model | None:
    try:
        return load_model(folder)
    except ModelError:
        return None


def made_by(generate: Generate) -> str:
    """SHA-256 of the sources beside a generator: what another version made is not taken for its own."""
    found = hashlib.sha256()
    try:
        root = Path(inspect.getfile(generate)).parent
        for path in sorted(root.rglob("*.py")):
            found.update(f"{path.relative_to(root)} ".encode() + path.read_bytes())
    except (OSError, TypeError):  # no sources to be had: by its name alone
        found.update(repr(getattr(generate, "__qualname__", "")).encode())
    return found.hexdigest()


def _generate(
    generate: Generate,
    model: Model,
    q_i: Sequence[str],
    groups: Sequence[tuple[str, Sequence[str]]],
    q: np.ndarray,
    folder: Path,
) -> None:
    state: Mapping[str, float] = dict(zip(model.coordinates, map(float, q), strict=True))
    try:
        folder.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=folder.parent) as work:
            made = generate(
                model.scene_toml, list(q_i), groups, Path(work) / "model", state=state, redundant=list(model.redundant)
            )
            folder.mkdir(exist_ok=True)
            files = sorted(Path(made).iterdir(), key=lambda path: path.name == "manifest.json")  # the manifest last
            for path in files:
                path.replace(folder / path.name)
    except (OSError, SymgenError) as error:
        raise NoVariant(f"a variant with q_i = {', '.join(q_i)} cannot be generated: {error}") from error


def _generator() -> Generate | None:
    if _handed:
        return _handed[0]
    for entry in entry_points(group=ENTRY_POINTS):
        found: Generate = entry.load()
        return found
    return None
