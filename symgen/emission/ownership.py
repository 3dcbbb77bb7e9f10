"""Only what the generator wrote may be replaced by it: the manifest of a folder says what that is."""

from __future__ import annotations

import json
import os
from collections.abc import Iterable
from pathlib import Path

from symgen.scene import SceneError

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
