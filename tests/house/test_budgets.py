"""Ceilings of docs/inside/decisions/budgets.md: walks of two runs, lines behind two doors, lines of the rooms."""

from __future__ import annotations

import ast
import json
import re
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs" / "inside" / "decisions" / "budgets.md"
OWN = ("runtime", "symgen")
ANONYMOUS = ("<module>", "<genexpr>", "<listcomp>", "<dictcomp>", "<lambda>", "<setcomp>")
WALKS = """
import importlib, json, pkgutil, sys

import runtime
from runtime import load_model, simulate
from symgen.scenes import generated_folder

root = sys.argv[1] + "/"
for found in pkgutil.walk_packages(runtime.__path__, "runtime."):  # what a module does when it is imported is no step
    importlib.import_module(found.name)
runs = {
    "steps of one length": ("flexible_slider_crank_free", {"scheme": "exponential", "dt": 2e-4, "t_end": 0.05}),
    "a tolerance": ("flexible_joint_arm", {"tolerance": 1e-4}),
}
entered = {}
for name, (scene, how) in runs.items():
    model, seen = load_model(generated_folder(scene)), set()

    def profile(frame, event, _):
        code = frame.f_code
        if event == "call" and code.co_filename.startswith(root):
            seen.add((code.co_filename[len(root):], code.co_qualname))

    sys.setprofile(profile)
    simulate(model, **how)
    sys.setprofile(None)
    entered[name] = sorted(seen)
print(json.dumps(entered))
"""


def ceilings(first: str) -> dict[str, int]:
    """Rows of the table of the page whose first column is called so."""
    table = re.search(rf"^\| {first} \|.*?\n\|[-|]+\|\n((?:\|.*\n)*)", PAGE.read_text(encoding="utf-8"), re.MULTILINE)
    assert table is not None
    rows = (row.strip("|").split("|") for row in table.group(1).splitlines())
    return {name.strip(): int(count) for name, count in rows}


def lines(path: Path) -> int:
    return len(path.read_text(encoding="utf-8").splitlines())


@pytest.mark.long
def test_walks_stay_within_their_budget(tmp_path: Path) -> None:
    """In a fresh process with an empty cache, so that all of a first run is walked."""
    environment = {
        "PYTHONPATH": str(ROOT),
        "SYMGEN_CACHE": str(tmp_path),
        "PATH": "/usr/bin:/bin",
        "HOME": str(tmp_path),
    }
    result = subprocess.run(
        [sys.executable, "-c", WALKS, str(ROOT)], capture_output=True, text=True, env=environment, cwd=ROOT
    )
    assert result.returncode == 0, result.stderr
    for name, seen in json.loads(result.stdout).items():
        own = {(file, inner) for file, inner in seen if file.split("/")[0] in OWN and not inner.endswith(ANONYMOUS)}
        counts = {"files": len({file for file, _ in own}), "functions": len(own)}
        allowed = {kind: ceilings("what")[f"walk of a run {words(name)}: {kind}"] for kind in counts}
        assert all(counts[kind] <= allowed[kind] for kind in counts), f"{name}: {counts}, allowed {allowed}"


def words(name: str) -> str:
    return f"to {name}" if name == "a tolerance" else f"with {name}"


def reached(module: str) -> set[Path]:
    """Own files that the imports of a module lead to, those inside functions too."""
    found: set[Path] = set()
    waiting = [module]
    while waiting:
        name = waiting.pop()
        base = ROOT.joinpath(*name.split("."))
        path = next((one for one in (base.with_suffix(".py"), base / "__init__.py") if one.is_file()), None)
        if name.split(".")[0] not in OWN or path is None or path in found:
            continue
        found.add(path)
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Import):
                waiting += [alias.name for alias in node.names]
            elif isinstance(node, ast.ImportFrom) and node.module and not node.level:
                waiting += [node.module, *(f"{node.module}.{alias.name}" for alias in node.names)]
    return found


def test_doors_reach_no_more_than_their_budget() -> None:
    allowed = {name: count for name, count in ceilings("what").items() if name.startswith("reach of")}
    assert len(allowed) == 2
    for name, count in allowed.items():
        found = sum(map(lines, reached(name.split("`")[1])))
        assert found <= count, f"{name}: {found} lines, allowed {count}"


def test_rooms_stay_within_their_budget() -> None:
    """Every room of the runtime and of the generator that is a folder has one."""
    allowed = {name.strip("`"): count for name, count in ceilings("room").items()}
    rooms = {f"{package}/{folder.name}" for package in OWN for folder in (ROOT / package).iterdir() if folder.is_dir()}
    known = {room for room in rooms if any((ROOT / room).rglob("*.py"))}
    assert known <= set(allowed), sorted(known - set(allowed))
    found = {room: sum(map(lines, (ROOT / room).rglob("*.py"))) for room in known}
    assert not {room: count for room, count in found.items() if count > allowed[room]}


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
