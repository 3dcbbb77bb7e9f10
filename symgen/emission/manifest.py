"""manifest.json (what the model is: names, partition, counts, hashes) and data.json (its numbers)."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from importlib.metadata import version

from runtime.contract.loading import manifest_digest
from symgen.emission.model_text import meaning
from symgen.pipeline import Derived

FORMAT = 2


def data_text(derived: Derived) -> str:
    """Default parameters and the consistent initial state; floats by repr, one entry a line."""
    initial = derived.initial
    names = derived.system.equations.names
    data = {
        "p": {entry.name: entry.default for entry in derived.parameters},
        "q": dict(zip(names, map(_clean, initial.q), strict=True)),
        "q_dot": dict(zip(names, map(_clean, initial.q_dot), strict=True)),
        "changed": {name: list(pair) for name, pair in initial.changed.items()},
    }
    return json.dumps(data, indent=1) + "\n"


def _clean(value: float) -> float:
    """Rounding dust of the assembly as an exact zero."""
    return 0.0 if abs(value) < 1e-15 else float(value)


def manifest_text(derived: Derived, operations: Mapping[str, int], files: Mapping[str, str]) -> str:
    """The manifest, with sha256 of every other file of the model."""
    eq, choice, scene = derived.system.equations, derived.system.choice, derived.scene
    manifest = {
        "format": FORMAT,
        "scene": scene.name,
        "title": scene.title or scene.name,
        "description": scene.description,
        "coordinates": eq.names,
        "elastic": [eq.names[c] for c in sorted(eq.elastic_columns)],
        "q_i": [eq.names[c] for c in choice.independent],
        "q_d": [eq.names[c] for c in derived.dependent],
        "loop_unknowns": [eq.names[c] for c in choice.loop_columns],
        "groups": [
            {"name": group.name, "coordinates": [eq.names[choice.independent[k]] for k in group.positions]}
            for group in derived.groups
        ],
        "constraints": [row.label for row in eq.constraints],
        "redundant": [eq.constraints[row].label for row in derived.redundant],
        "joints": eq.joints,
        "measures": list(eq.measures),
        "drawing": drawing_record(derived),
        "simulation": scene.simulation.model_dump(mode="json"),
        "baumgarte": scene.baumgarte.model_dump(mode="json") if scene.baumgarte else None,
        "parameters": [
            {"name": entry.name, "unit": entry.unit, "description": entry.description, "kind": entry.kind}
            for entry in derived.parameters
        ],
        "functions": {
            name: {"meaning": meaning(name, bool(derived.redundant)), "operations": count}
            for name, count in operations.items()
        },
        "files": {name: sha256(text) for name, text in files.items()},
        "versions": {package: version(package) for package in ("casadi", "sympy", "symgen")},
    }
    return json.dumps({**manifest, "sha256": manifest_digest(manifest)}, indent=1) + "\n"


def drawing_record(derived: Derived) -> dict[str, object]:
    """What the columns of `poses` and `geometry` belong to, and what is drawn between the points."""
    scene, picture = derived.scene, derived.system.equations.picture
    markers = ("marker_a", "marker_b", "marker", "reaction")
    parts = {
        kind: [
            {"name": part.name, "type": part.type, **{key: getattr(part, key) for key in markers if hasattr(part, key)}}
            for part in listed
        ]
        for kind, listed in (("joints", scene.joints), ("loads", scene.loads))
    }
    return {
        "space": scene.space,
        "poses": list(picture.poses),
        "points": [
            {"body": point.body, "name": point.name, "modes": len(point.shapes), "stiffened": bool(point.H)}
            for point in picture.points
        ],
        "sections": list(picture.sections),
        **parts,
    }


def sha256(text: str) -> str:
    """Hexadecimal SHA-256 of a text in UTF-8."""
    return hashlib.sha256(text.encode()).hexdigest()
