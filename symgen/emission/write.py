"""Write a model's files, or compare them with what is there: one code path for `generate` and its `--check`.

Only what the generator wrote may be replaced by it: the manifest of a folder says what that is. Nothing is derived
here, so the files of a model that was loaded are copied without the generator.
"""

from __future__ import annotations

import difflib
import json
import math
import os
from collections.abc import Iterable
from pathlib import Path

from runtime.contract.files import WRITING, OutputError, write_texts
from symgen.schema.errors import SceneError

MANIFEST = "manifest.json"


def refuse_foreign_files(names: Iterable[str], folder: Path) -> None:
    """Raises SceneError if one of the files would take the place of one that the folder's manifest does not list."""
    own = _listed(folder / MANIFEST)
    foreign = [name for name in names if name not in own and os.path.lexists(folder / name)]
    if foreign:
        raise SceneError(
            str(folder / foreign[0]),
            "is there and was not written by symgen generate",
            "choose another output folder (--out), or move the file away",
        )


def _listed(manifest: Path) -> set[str]:
    """The files that a manifest says were generated, itself included; none where there is no manifest of ours."""
    try:
        content = json.loads(manifest.read_bytes())
    except (OSError, ValueError, RecursionError):
        return set()
    if not isinstance(content, dict) or not isinstance(content.get("files"), dict) or "sha256" not in content:
        return set()
    return {MANIFEST, *content["files"]}


FILES = ("model.py", "data.json", "model.md", "scene.toml", "manifest.json")
DATA_TOLERANCE = 1e-9  # eigenvectors and assembled states differ in the last digits between machines


def write_model(files: dict[str, str], folder: Path) -> None:
    """Write the files: all to temporary names, then each to its place, the manifest first.

    So a full disk changes nothing, and where the process is killed in between the manifest that is there names the
    files: they do not fit its hashes, so they are not loaded, but they are known as the generator's and are replaced
    the next time. Raises SceneError if the folder cannot be written, or holds files of these names that were not
    generated.
    """
    refuse_foreign_files(files, folder)
    try:
        write_texts(folder, {MANIFEST: files[MANIFEST], **files})
    except OutputError as error:
        raise SceneError(str(folder), str(error), "choose another output folder or change its permissions") from error


def compare_model(files: dict[str, str], folder: Path) -> str:
    """Unified diff between the files and the folder; empty if they agree.

    Text is compared byte for byte, data.json number by number; versions in the manifest may differ.
    """
    report: list[str] = []
    for name, text in files.items():
        path = folder / name
        present = path.read_bytes().decode("utf-8", "replace") if path.is_file() else ""
        if name == "data.json" and _same_data(present, text):
            continue
        if name == "manifest.json":
            present, text = _comparable_manifest(present), _comparable_manifest(text)
        if present != text:
            report += difflib.unified_diff(
                present.splitlines(True), text.splitlines(True), str(path), f"{path} (regenerated)"
            )
    surplus = (
        sorted(
            path.name
            for path in folder.glob("*")
            if path.is_file() and path.name not in (*files, "__init__.py") and not path.name.startswith(WRITING)
        )
        if folder.is_dir()
        else []
    )
    report += [f"only in {folder}: {name}\n" for name in surplus]
    return "".join(report)


def _comparable_manifest(text: str) -> str:
    try:
        manifest = json.loads(text)
    except json.JSONDecodeError:
        return text
    if not isinstance(manifest, dict):
        return text
    for machine_dependent in ("versions", "sha256"):
        manifest.pop(machine_dependent, None)
    manifest.get("files", {}).pop("data.json", None)
    return json.dumps(manifest, indent=1) + "\n"


def _same_data(present: str, regenerated: str) -> bool:
    try:
        return _close(json.loads(present), json.loads(regenerated))
    except json.JSONDecodeError:
        return False


def _close(a: object, b: object) -> bool:
    if isinstance(a, dict) and isinstance(b, dict):
        return list(a) == list(b) and all(_close(a[key], b[key]) for key in a)
    if isinstance(a, list) and isinstance(b, list):
        return len(a) == len(b) and all(_close(x, y) for x, y in zip(a, b, strict=True))
    if isinstance(a, int | float) and isinstance(b, int | float):
        return math.isclose(a, b, rel_tol=DATA_TOLERANCE, abs_tol=1e-12)
    return a == b
