"""manifest.json (what the model is: its records, hashes) and data.json (its numbers)."""

from __future__ import annotations

import json
from collections.abc import Mapping
from importlib.metadata import version
from typing import Any

from runtime.contract import loading as contract
from symgen.emission.description import describe
from symgen.pipeline import Derived


def data_text(derived: Derived) -> str:
    """Default parameters, the consistent initial state, tables; floats by repr, one entry a line."""
    initial = derived.initial
    names = derived.system.equations.names
    data: dict[str, Any] = {
        "p": {entry.name: entry.default for entry in derived.parameters},
        "q": dict(zip(names, map(clean, initial.q), strict=True)),
        "q_dot": dict(zip(names, map(clean, initial.q_dot), strict=True)),
        "changed": {name: list(pair) for name, pair in initial.changed.items()},
    }
    if initial.told:
        data["assembled"] = [text for _, text in initial.told]
    text = json.dumps(data, indent=1)
    if derived.scene.tables:  # each on a line
        tables = (
            f"  {json.dumps(name)}: {json.dumps(table.curve.plain())}" for name, table in derived.scene.tables.items()
        )
        text = text[: -len("\n}")] + ',\n "tables": {\n' + ",\n".join(tables) + "\n }\n}"
    return text + "\n"


def clean(value: float) -> float:
    """Rounding dust of the assembly as an exact zero."""
    return 0.0 if abs(value) < 1e-15 else float(value)


def manifest_text(derived: Derived, files: Mapping[str, str]) -> str:
    """The manifest, with sha256 of every other file of the model."""
    scene = derived.scene
    more: dict[str, Any] = {
        "description": scene.description,
        "baumgarte": scene.baumgarte.model_dump(mode="json") if scene.baumgarte else None,
    }
    if derived.left_out:
        more["left_out"] = derived.left_out
    versions = {package: version(package) for package in ("casadi", "sympy", "symgen")}
    return contract.manifest_text(describe(derived), files, versions, more)
