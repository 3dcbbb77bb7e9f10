"""The emitted code in the repository is what the generator emits; edited, missing and surplus files are noticed."""

from __future__ import annotations

import hashlib
import json
import os
import shutil
import subprocess
import sys
from importlib.metadata import version
from pathlib import Path

import pytest

from runtime import ModelError, load_model
from symgen.emission.files import emit
from symgen.emission.write import compare_model
from symgen.generate import check, generate
from symgen.pipeline import derive
from symgen.scenes import SCENES, generated_folder

pytestmark = pytest.mark.long

ROOT = Path(__file__).resolve().parents[2]
FILES = ("model.py", "data.json", "model.md", "scene.toml", "manifest.json")
WRITTEN = json.loads((generated_folder("pendulum") / "manifest.json").read_text(encoding="utf-8"))["versions"]
LIBRARIES = ("casadi", "sympy")  # they order and count the operations: the text is that of one version of each


@pytest.fixture
def copy(tmp_path: Path) -> Path:
    """A writable copy of the emitted pendulum."""
    return Path(
        shutil.copytree(
            generated_folder("pendulum"), tmp_path / "pendulum", ignore=shutil.ignore_patterns("__pycache__")
        )
    )


@pytest.mark.skipif(
    any(version(library) != WRITTEN[library] for library in LIBRARIES),
    reason=f"the text is that of {', '.join(f'{library} {WRITTEN[library]}' for library in LIBRARIES)}",
)
@pytest.mark.parametrize("name", SCENES)
def test_emitted_code_is_current(name: str) -> None:
    assert check(SCENES[name](), generated_folder(name)) == "", f"regenerate with: symgen generate {name}"


def test_every_emitted_folder_belongs_to_a_scene() -> None:
    folders = {
        path.name
        for path in generated_folder("pendulum").parent.iterdir()
        if path.is_dir() and not path.name.startswith(("_", "."))
    }
    assert folders == set(SCENES)


def test_generation_is_deterministic(tmp_path: Path) -> None:
    scene = SCENES["four_bar"]()
    first, second = generate(scene, tmp_path / "a"), generate(scene, tmp_path / "b")
    assert sorted(path.name for path in first.iterdir()) == sorted(FILES)
    for name in FILES:
        assert (first / name).read_bytes() == (second / name).read_bytes(), name


def test_emission_does_not_depend_on_the_hash_seed() -> None:
    """Sets and dictionaries may be walked in another order in another process: the text must not show it."""
    program = (
        "import hashlib; from symgen.emission.files import emit; from symgen.pipeline import derive; "
        "from symgen.scenes import SCENES; files = emit(derive(SCENES['flexible_slider_crank']())); "
        "print(hash('a'), hashlib.sha256(''.join(files.values()).encode()).hexdigest())"
    )
    other = str(1 + int(os.environ.get("PYTHONHASHSEED", "0").replace("random", "0")))
    environment = {**os.environ, "PYTHONHASHSEED": other}
    command = [sys.executable, "-c", program]
    done = subprocess.run(command, cwd=ROOT, check=True, capture_output=True, text=True, env=environment)
    seen, digest = done.stdout.split()
    here = emit(derive(SCENES["flexible_slider_crank"]()))
    assert int(seen) != hash("a")
    assert digest == hashlib.sha256("".join(here.values()).encode()).hexdigest()


def test_a_copy_agrees(copy: Path) -> None:
    assert check(SCENES["pendulum"](), copy) == ""
    assert load_model(copy).name == "pendulum"


@pytest.mark.parametrize(
    "file, old, new",
    [
        ("model.py", "ca.cos(rod_theta)", "ca.sin(rod_theta)"),
        ("model.py", '"""Simple', '"""Very simple'),
        ("data.json", "9.81", "9.82"),
        ("scene.toml", "9.81", "9.82"),
        ("model.md", "pendulum", "clock"),
    ],
)
def test_an_edit_is_a_diff_and_is_refused(copy: Path, file: str, old: str, new: str) -> None:
    path = copy / file
    text = path.read_text(encoding="utf-8")
    assert old in text
    path.write_text(text.replace(old, new, 1), encoding="utf-8")
    difference = check(SCENES["pendulum"](), copy)
    assert file in difference
    assert any(line.startswith("-") and new in line for line in difference.splitlines())
    assert any(line.startswith("+") and old in line for line in difference.splitlines())
    with pytest.raises(ModelError, match="edited.*symgen generate"):
        load_model(copy)


@pytest.mark.parametrize("file", FILES)
def test_a_missing_file_is_reported(copy: Path, file: str) -> None:
    (copy / file).unlink()
    assert file in check(SCENES["pendulum"](), copy)
    with pytest.raises(ModelError, match="symgen generate"):
        load_model(copy)


def test_a_surplus_file_is_reported(copy: Path) -> None:
    (copy / "extra.py").write_text("x = 1\n")
    assert "extra.py" in check(SCENES["pendulum"](), copy)


def test_a_folder_that_does_not_exist_differs_in_every_file(tmp_path: Path) -> None:
    difference = check(SCENES["pendulum"](), tmp_path / "nothing")
    assert all(name in difference for name in FILES)


def test_another_format_is_refused(copy: Path) -> None:
    path = copy / "manifest.json"
    manifest = json.loads(path.read_text(encoding="utf-8"))
    path.write_text(json.dumps({**manifest, "format": manifest["format"] + 1}), encoding="utf-8")
    with pytest.raises(ModelError, match="another format"):
        load_model(copy)


def test_another_scene_differs(copy: Path) -> None:
    """A changed number of the scene changes data only, a changed structure the code too."""
    scene = SCENES["pendulum"]()
    heavier = scene.model_copy(update={"gravity": (0.0, -1.62)})
    assert "data.json" in check(heavier, copy)
    assert "model.py" in check(SCENES["double_pendulum"](), copy)


def test_a_folder_that_agrees_but_for_versions_is_current(tmp_path: Path) -> None:
    """Versions of a manifest belong to the machine; what differs, is missing or surplus is said."""
    manifest = {"format": 1, "versions": {"casadi": "1"}, "sha256": "a"}
    files = {"model.py": "x = 1\n", "manifest.json": json.dumps(manifest)}
    for name, text in files.items():
        (tmp_path / name).write_text(text)
    (tmp_path / "__init__.py").write_text("")
    assert compare_model(files, tmp_path) == ""
    other = {**files, "manifest.json": json.dumps({**manifest, "versions": {"casadi": "2"}, "sha256": "b"})}
    assert compare_model(other, tmp_path) == ""
    assert "format" in compare_model({**files, "manifest.json": json.dumps({**manifest, "format": 2})}, tmp_path)
    assert "-x = 1" in compare_model({**files, "model.py": "x = 2\n"}, tmp_path)
    (tmp_path / "notes.txt").write_text("")
    assert compare_model(files, tmp_path) == f"only in {tmp_path}: notes.txt\n"
