"""From a word on the command line to a scene or a model: built-in name, .toml file, or folder of a generated model.

A built-in scene whose code is current, and a folder that is named, are opened without the generator.
"""

from __future__ import annotations

import inspect
import json
import tempfile
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from symgen.scenes import SCENES, current_folder, generated_folder

if TYPE_CHECKING:
    from runtime.contract.model import EmittedModel
    from runtime.model import Model
    from symgen.mechanism.scene import SceneRecord

MAX_COUNT = 1000
NOTHING: Mapping[str, float] = {}


@dataclass(frozen=True)
class Source:
    """A scene and the folder its generated code belongs in."""

    scene: SceneRecord
    folder: Path


def builtin_name(word: str) -> str | None:
    """The built-in scene that `word` names; dashes count as underscores."""
    name = word.replace("-", "_")
    return name if name in SCENES else None


def find_source(word: str, made_with: Mapping[str, float] = NOTHING) -> Source:
    """The scene that `word` names, and where its code goes: ./NAME if not a built-in scene as it stands.

    made_with: arguments of a built-in scene's function. Raises SceneError.
    """
    from symgen.mechanism.scene import SceneRecord
    from symgen.scene import SceneError
    from symgen.schema.errors import did_you_mean

    path, name, folder = Path(word), builtin_name(word), is_folder(word)
    if name is not None:
        scene = _made(name, SCENES[name], made_with)
        return Source(scene, Path(scene.name) if made_with else generated_folder(name))
    if made_with:
        raise SceneError("--with", f"'{word}' is not a built-in scene", "change the scene file, or use --set")
    if path.suffix == ".toml":
        scene = SceneRecord.from_toml(path)
        return Source(scene, Path(scene.name))
    if folder and (path / "scene.toml").is_file():
        return Source(SceneRecord.from_toml(path / "scene.toml"), path)
    if folder:
        raise SceneError(f"folder '{word}'", "contains no scene.toml", "give a folder written by symgen generate")
    if path.suffix == ".py":
        remedy = "in it write scene.to_toml('NAME.toml') and give that file, or call what you want of scene.model()"
        raise SceneError(f"scene '{word}'", "is a Python program, which is not run here", remedy)
    raise SceneError(
        f"scene '{word}'",
        "is neither a built-in scene nor a .toml file",
        f"{did_you_mean(word.replace('-', '_'), SCENES)} (see: symgen list)",
    )


def is_folder(word: str) -> bool:
    """Is there a folder of that name? A word that cannot be a path names none."""
    try:
        return Path(word).is_dir()
    except (OSError, ValueError):
        return False


def _made(name: str, make: Callable[..., SceneRecord], made_with: Mapping[str, float]) -> SceneRecord:
    """The scene of a function called with arguments by name; whole numbers where it counts something."""
    from symgen.scene import SceneError
    from symgen.schema.errors import did_you_mean

    known = inspect.signature(make).parameters
    values: dict[str, float | int] = {}
    for key, value in made_with.items():
        if key not in known:
            raise SceneError(f"--with {key}", f"scene {name} does not take that", did_you_mean(key, known))
        if isinstance(known[key].default, bool):
            if value not in (0, 1):
                raise SceneError(f"--with {key}", f"{value:g} is neither 0 nor 1", "give 1 for yes or 0 for no")
            values[key] = bool(value)
            continue
        counts = isinstance(known[key].default, int)
        if counts and (value != int(value) or not 0 <= value <= MAX_COUNT):
            raise SceneError(f"--with {key}", f"{value:g} is not a whole number from 0 to {MAX_COUNT}", "correct it")
        values[key] = int(value) if counts else value
    return make(**values)


def opened_model(
    word: str, made_with: Mapping[str, float] = NOTHING, keep: Path | None = None, digest: str | None = None
) -> Model:
    """The model of a generated folder, or of a scene: from its own folder if current, else derived anew.

    Code is only run from a folder that was named (or is built in): a file arm.toml does not run what lies in ./arm.
    Functions of a scene are derived when a run asks for them. digest: of the model that is meant, where a run goes on;
    keep: folder of the model's files if that one was generated. Raises ModelError or SceneError.
    """
    from runtime.model import load_model

    name = builtin_name(word)
    if name is not None and not made_with and (folder := current_folder(name)):
        return load_model(folder)
    if name is not None or made_with or not is_folder(word):
        return _derived(find_source(word, made_with).scene, keep, digest)
    if digest is not None and (text := _scene_text(Path(word))) is not None:
        from symgen.generate import digest_on_demand, model_of_text

        if digest == digest_on_demand(text):
            return model_of_text(text)  # what its run was derived from, bit for bit
    return load_model(word)


def opened_text(name: str, text: str, digest: str, keep: Path | None = None) -> Model:
    """The model of a scene's TOML text with a digest: the built-in one if that is the same scene, else derived anew.

    Raises ModelError or SceneError.
    """
    from runtime.model import load_model

    known = builtin_name(name)
    if known is not None and (folder := current_folder(known)) and _scene_text(folder) == text:
        return load_model(folder)
    from symgen.mechanism.scene import SceneRecord

    return _derived(SceneRecord.from_toml_text(text), keep, digest)


def _derived(scene: SceneRecord, keep: Path | None, digest: str | None) -> Model:
    """On demand, unless the digest says that it was generated: into the folder to keep, or one for this moment."""
    from runtime.model import load_model
    from symgen.generate import digest_on_demand, generate, model_of

    if digest is None or digest == digest_on_demand(scene.to_toml()):
        return model_of(scene)
    if keep is not None:
        return load_model(generate(scene, keep))
    with tempfile.TemporaryDirectory(prefix="symgen-") as folder:
        return load_model(generate(scene, folder))


def _scene_text(folder: Path) -> str | None:
    try:
        return (folder / "scene.toml").read_bytes().decode("utf-8")
    except (OSError, UnicodeDecodeError):
        return None


def try_leaving_model(folder: Path) -> None:
    """See that `leave_model` can write, before something long is begun. Raises SceneError or OutputError."""
    from runtime.contract.files import try_writing
    from symgen.emission.write import FILES, MANIFEST, refuse_foreign_files

    refuse_foreign_files(FILES, folder)
    try_writing(folder / MANIFEST)


def leave_model(model: EmittedModel, folder: Path) -> None:
    """The files of a model that ran: those of its folder, or what was derived for the run. Raises SceneError."""
    if not model.folder:
        from symgen.generate import leave

        leave(model, folder)
    elif Path(model.folder) != folder.resolve():
        from symgen.emission.write import write_model

        source = Path(model.folder)
        listed = json.loads((source / "manifest.json").read_text(encoding="utf-8"))["files"]
        files = {name: (source / name).read_bytes().decode("utf-8") for name in (*listed, "manifest.json")}
        write_model(files, folder)
