"""One definition of each verb; only the schemes ask of which kind a method is."""

from __future__ import annotations

import ast
import re
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def kinds_of_method() -> set[str]:
    """Names of the classes of the schemes that are built on Scheme."""
    bases: dict[str, set[str]] = {}
    for path in (ROOT / "runtime" / "schemes").rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.ClassDef):
                bases[node.name] = {base.id for base in node.bases if isinstance(base, ast.Name)}
    found = {"Scheme"}
    while more := {name for name, own in bases.items() if own & found} - found:
        found |= more
    return found


def test_nobody_but_the_schemes_asks_of_which_kind_a_method_is() -> None:
    """What differs between methods is an attribute of theirs, and no isinstance elsewhere."""
    kinds, asked = kinds_of_method(), []
    assert {"Scheme", "Radau"} < kinds
    for path in (ROOT / "runtime").rglob("*.py"):
        if path.is_relative_to(ROOT / "runtime" / "schemes"):
            continue
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "isinstance":
                names = {one.id for one in ast.walk(node.args[1]) if isinstance(one, ast.Name)}
                asked += [f"{path.relative_to(ROOT)}:{node.lineno}"] if names & kinds else []
    assert not asked


def test_each_verb_has_the_definition_that_the_table_names() -> None:
    text = (ROOT / "docs" / "inside" / "architecture.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\| [a-z ]+ \| `([\w/]+\.py):(\w+)` \|$", text, re.MULTILINE)
    assert len(rows) >= 8
    for file, name in rows:
        content = ast.parse((ROOT / file).read_text(encoding="utf-8"))
        assert name in {getattr(node, "name", "") for node in content.body}, f"{file} has no {name}"
