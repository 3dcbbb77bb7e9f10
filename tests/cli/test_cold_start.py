"""A built-in scene runs from the code that is there: the generator is not imported, and the scene is built only
where a file has changed since it was last compared."""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path

import pytest

import symgen.scenes as scenes
from symgen.scenes.pendulums import pendulum

HEAVY = {
    "sympy",
    "pydantic",
    "matplotlib",
    "scipy",
    "symgen.scene",
    "symgen.mechanism",
    "symgen.pipeline",
    "symgen.generate",
}
MOST = 135  # modules of this project that a run brings in
METHODS = {"printed", "coupled", "single_rate", "exponential_rk4", "exponential_adams"}
SELDOM = {  # what only some runs ask for, and what prints code that the cache has
    "runtime.baselines",
    "runtime.engine.interpreted",
    "runtime.engine.llvm_ir",
    "runtime.operating.equilibrium",
    "runtime.running.checkpoint",
    "runtime.running.driven",
    "runtime.running.step_refinement",
    "runtime.running.singular.singular_crossing",
    "runtime.start.quasi_static",
}


def imported_by(words: list[str], folder: Path) -> set[str]:
    """Modules of HEAVY that a command brings into a fresh interpreter."""
    return HEAVY & all_imported_by(words, folder)


def all_imported_by(words: list[str], folder: Path) -> set[str]:
    """Modules that a command brings into a fresh interpreter."""
    program = (
        "import sys; from symgen.cli import main; assert main(sys.argv[1:]) == 0; "
        "print(*sys.modules, file=open('modules', 'w'))"
    )
    done = subprocess.run([sys.executable, "-c", program, *words], cwd=folder, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return set((folder / "modules").read_text().split())


@pytest.mark.long
@pytest.mark.parametrize("name", ["pendulum", "flexible_slider_crank_free"])
def test_a_built_in_scene_runs_without_the_generator(name: str, tmp_path: Path, monkeypatch) -> None:
    monkeypatch.setenv("SYMGEN_CACHE", str(tmp_path / "cache"))
    words = ["simulate", name, "--t-end", "0.001"]
    assert "symgen.scene" in imported_by(words, tmp_path)  # the first time it is compared
    assert imported_by(words, tmp_path) == set()
    assert imported_by([*words, "--out", "results", "--no-plots"], tmp_path) == set()
    assert imported_by(["list"], tmp_path) == set()


def test_a_run_imports_the_method_that_it_takes(tmp_path: Path, monkeypatch) -> None:
    monkeypatch.setenv("SYMGEN_CACHE", str(tmp_path / "cache"))
    words = ["simulate", "flexible_slider_crank_free", "--t-end", "0.001"]
    first = all_imported_by(words, tmp_path)
    assert "runtime.engine.llvm_ir" in first  # the first time code is printed
    found = all_imported_by(words, tmp_path)
    assert "runtime.schemes.exponential" in found
    assert not {f"runtime.schemes.{name}" for name in METHODS} & found
    assert not SELDOM & found
    own = {name for name in found if name.split(".")[0] in ("runtime", "symgen")}
    assert len(own) <= MOST, len(own)


def test_a_model_that_is_kept_runs_without_the_generator(tmp_path: Path) -> None:
    assert imported_by(["simulate", str(scenes.generated_folder("pendulum")), "--t-end", "0.001"], tmp_path) == set()


@pytest.fixture
def built(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """A copy of the pendulum's folder and a generator of one file; each time that the scene is built is noted."""
    copy = Path(shutil.copytree(scenes.generated_folder("pendulum"), tmp_path / "pendulum"))
    (tmp_path / "generator").mkdir()
    (tmp_path / "generator" / "stage.py").write_text("one")
    noted: list[str] = []
    monkeypatch.setenv("SYMGEN_CACHE", str(tmp_path / "cache"))
    monkeypatch.setattr(scenes, "GENERATOR", (tmp_path / "generator",))
    monkeypatch.setattr(scenes, "generated_folder", lambda name: copy)
    monkeypatch.setattr(scenes, "SCENES", {"pendulum": lambda: noted.append("built") or pendulum()})
    return noted


def test_a_scene_is_built_again_only_where_a_file_has_changed(built: list[str], tmp_path: Path) -> None:
    for _ in range(3):
        assert scenes.current_folder("pendulum") == tmp_path / "pendulum"
    assert len(built) == 1
    (tmp_path / "generator" / "stage.py").write_text("another")
    assert scenes.current_folder("pendulum") and scenes.current_folder("pendulum")
    assert len(built) == 2
    (tmp_path / "generator" / "more.json").write_text("{}")
    assert scenes.current_folder("pendulum") and len(built) == 3


def test_a_folder_of_another_scene_is_not_current(built: list[str], tmp_path: Path) -> None:
    """Edited behind the stamp; without a manifest; with one that is none."""
    assert scenes.current_folder("pendulum")
    scene = tmp_path / "pendulum" / "scene.toml"
    scene.write_text(scene.read_text() + "# edited\n")
    assert scenes.current_folder("pendulum") is None and scenes.current_folder("pendulum") is None
    assert len(built) == 3
    (tmp_path / "pendulum" / "manifest.json").write_text("[]")
    assert scenes.current_folder("pendulum") is None and len(built) == 3
    shutil.rmtree(tmp_path / "pendulum")
    assert scenes.current_folder("pendulum") is None


def test_a_cache_that_cannot_be_written_costs_only_time(built: list[str], tmp_path: Path, monkeypatch) -> None:
    (tmp_path / "file").write_text("")
    monkeypatch.setenv("SYMGEN_CACHE", str(tmp_path / "file" / "cache"))
    assert scenes.current_folder("pendulum") and scenes.current_folder("pendulum")
    assert len(built) == 2


def test_the_catalogue_is_that_of_the_modules() -> None:
    """Names, functions and first lines agree, whether a scene is imported or not."""
    for name, make in scenes.SCENES.items():
        assert make.__name__ == name and make().name == name
        assert scenes.summary(name) and scenes.summary(name) == (make.__doc__ or "").strip().partition("\n")[0]
    assert "vehicle" not in scenes.SCENES and len(scenes.SCENES) == len(list(scenes.SCENES))
