"""Built-in scenes. `SCENES` maps a name to a function that returns the scene.

Which scenes there are, what they are about, and whether the code that the repository has of them is current, is told
without importing them: they bring in most of the generator.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable, Iterator, Mapping
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING

from runtime.contract.cache import cache_folder
from runtime.contract.files import OutputError, stamp_of, write_text

if TYPE_CHECKING:
    from symgen.mechanism.scene import SceneRecord

ROOT = Path(__file__).resolve().parents[2]
GENERATOR = (ROOT / "symgen", ROOT / "runtime" / "contract")  # what the text and the code of a scene follow from
GROUPS = {  # modules of this package, and the scenes that each of them has a function for
    "pendulums": (
        "pendulum", "double_pendulum", "elastic_pendulum", "overdamped_joint", "flexible_joint_arm", "chain",
        "two_oscillators",
    ),
    "linkages": ("four_bar", "n_four_bar", "flexible_four_bar", "slider_crank", "near_singular_slider_crank"),
    "flexible_slider_crank": (
        "flexible_slider_crank", "flexible_slider_crank_free", "flexible_slider_crank_torque", "physical_slider_crank",
        "stiff_slider_crank",
    ),
    "beams": ("hub_beam", "spin_up_beam"),
    "spatial": (
        "heavy_top", "tumbling_body", "bricard", "flyball_governor", "spatial_chain", "spatial_slider_crank",
    ),
}  # fmt: skip
MODULES = {name: module for module, names in GROUPS.items() for name in names}


class Catalogue(Mapping[str, "Callable[..., SceneRecord]"]):
    """The functions by name, each imported when it is asked for."""

    def __getitem__(self, name: str) -> Callable[..., SceneRecord]:
        make: Callable[..., SceneRecord] = getattr(import_module(f"symgen.scenes.{MODULES[name]}"), name)
        return make

    def __contains__(self, name: object) -> bool:
        return name in MODULES

    def __iter__(self) -> Iterator[str]:
        return iter(MODULES)

    def __len__(self) -> int:
        return len(MODULES)


SCENES: Mapping[str, Callable[..., SceneRecord]] = Catalogue()


def summary(name: str) -> str:
    """The first line that is said of a built-in scene."""
    import ast

    text = Path(__file__).with_name(f"{MODULES[name]}.py").read_text(encoding="utf-8")
    made = (one for one in ast.parse(text).body if isinstance(one, ast.FunctionDef) and one.name == name)
    return (ast.get_docstring(next(made)) or "").partition("\n")[0]


def generated_folder(name: str) -> Path:
    """Folder of the emitted code of a built-in scene, beside this package."""
    return ROOT / "generated" / name


def current_folder(name: str) -> Path | None:
    """Folder of the emitted code if that was generated from the scene as it stands today, else None.

    The comparison builds the scene, so a stamp in the user's cache says for which files of the generator it was made.
    In an installed package, which has no pyproject.toml, both are as they were built.
    """
    folder = generated_folder(name)
    if not (ROOT / "pyproject.toml").is_file():
        return folder if folder.is_dir() else None
    try:
        text = (folder / "scene.toml").read_bytes().decode("utf-8")
        digest = str(json.loads((folder / "manifest.json").read_bytes())["sha256"])
    except (OSError, ValueError, KeyError, TypeError):
        return None
    stamp = cache_folder() / "current" / hashlib.sha256(str(folder).encode()).hexdigest()[:16]
    expected = _stamp(digest, folder / "scene.toml")
    if _read(stamp) == expected:
        return folder
    if SCENES[name]().to_toml() != text:
        return None
    try:
        write_text(stamp, expected)
    except OutputError:  # a cache that cannot be written: the scene is built again the next time
        pass
    return folder


def _stamp(digest: str, scene: Path) -> str:
    """The digest of a folder with a hash of names, sizes and times of the generator's files and of the scene's."""
    about = scene.stat()
    return f"{digest} {stamp_of(*GENERATOR)} {about.st_size} {about.st_mtime_ns}"


def _read(path: Path) -> str:
    try:
        return path.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError):
        return ""
