"""manifest.json: the description of a model with the hashes of its files, and what guards it against edits."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from typing import Any

from runtime.contract.records import Description, as_plain, description

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
