"""Files of others, and sizes: nothing is overwritten that was not generated, nothing runs that was not named."""

from __future__ import annotations

import errno
import itertools
import os
import subprocess
import sys
import threading
from pathlib import Path
from typing import Any

import pytest

from runtime import SCHEMES, SymgenError, load_model, simulate
from runtime.contract.errors import LONGEST_MESSAGE
from runtime.contract.records import GROUPED_SCHEMES, SCHEME_NAMES
from symgen.cli import main
from symgen.generate import generate
from symgen.scene import Scene, SceneError, SceneRecord
from symgen.scene.checks import MAX_BODY_MODES, MAX_COORDINATES
from symgen.scenes import generated_folder
from symgen.scenes.pendulums import pendulum

PENDULUM = pendulum().to_toml()
ERRORS = 2  # exit code of wrong input


def test_a_scene_and_a_model_of_the_users_own_are_not_overwritten(tmp_path: Path, monkeypatch) -> None:
    folder = tmp_path / "proj"
    folder.mkdir()
    (folder / "scene.toml").write_text(PENDULUM)
    (folder / "model.py").write_text("print('mine')\n")
    monkeypatch.chdir(tmp_path)
    assert main(["generate", "proj"]) == ERRORS
    assert (folder / "model.py").read_text() == "print('mine')\n"
    assert sorted(path.name for path in folder.iterdir()) == ["model.py", "scene.toml"]


@pytest.mark.parametrize("name", ["model.py", "scene.toml", "manifest.json", "data.json", "model.md"])
def test_a_single_file_of_the_users_own_stops_the_generator(name: str, tmp_path: Path) -> None:
    (tmp_path / name).write_text("{}")
    with pytest.raises(SceneError, match="not written by symgen generate"):
        generate(pendulum(), tmp_path)
    assert [path.name for path in tmp_path.iterdir()] == [name]


def test_what_was_generated_is_generated_again(tmp_path: Path) -> None:
    generate(pendulum(), tmp_path)
    (tmp_path / "notes.txt").write_text("kept")
    generate(pendulum(), tmp_path)
    assert load_model(tmp_path).name == "pendulum"
    assert (tmp_path / "notes.txt").read_text() == "kept"


KILLED = """
import os, sys
from pathlib import Path
from runtime.contract import files
from symgen.generate import generate
from symgen import SceneRecord
from symgen.scenes.pendulums import pendulum

text, real = pendulum().to_toml(), os.replace

def killed(placed, folder):
    left = placed

    def replace(source, target):
        nonlocal left
        left -= 1
        if left < 0:
            os._exit(9)  # as kill -9: nothing is cleaned up
        real(source, target)

    files.os.replace = replace
    generate(pendulum(), folder)
    os._exit(0)

for placed in range(5):
    for had in (False, True):
        folder = Path(sys.argv[1]) / f"{had}{placed}"
        if had:
            generate(SceneRecord.from_toml_text(text.replace("-9.81", "-1.62", 1)), folder)
        child = os.fork() or killed(placed, folder)
        assert os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == 9
"""


@pytest.fixture(scope="module")
def left_by_killed(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Folders `False0` to `True4`: was there a model, and how many files were in place when the process was killed.

    One process that has imported all forks those that are killed.
    """
    place = tmp_path_factory.mktemp("killed")
    subprocess.run([sys.executable, "-W", "ignore", "-c", KILLED, str(place)], env=_environment(), check=True)
    return place


@pytest.mark.every_push("0-new", "3-again")
@pytest.mark.skipif(os.name == "nt", reason="processes fork on POSIX only")
@pytest.mark.parametrize("had", [False, True], ids=["new", "again"])
@pytest.mark.parametrize("placed", range(5))
def test_a_generate_that_was_killed_is_repeated(placed: int, had: bool, left_by_killed: Path) -> None:
    """After so many of the five files are in place: what is there is not loaded if it is not whole, and is replaced."""
    folder = left_by_killed / f"{had}{placed}"
    if had and placed == 0:
        assert load_model(folder).name == "pendulum"  # the old one
    else:
        with pytest.raises(SymgenError):
            load_model(folder)
    generate(pendulum(), folder)
    assert load_model(folder).name == "pendulum" and main(["generate", str(folder), "--check"]) == 0


@pytest.mark.parametrize("written", range(5))
def test_a_full_disk_changes_no_file_of_a_folder(written: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    generate(SceneRecord.from_toml_text(PENDULUM.replace("-9.81", "-1.62", 1)), tmp_path)
    before = {path.name: path.read_bytes() for path in tmp_path.iterdir()}
    real, count = Path.write_text, itertools.count()

    def full(path: Path, text: str, **how: Any) -> int:
        if next(count) == written:
            real(path, text[: len(text) // 2], **how)
            raise OSError(errno.ENOSPC, "No space left on device")
        return real(path, text, **how)

    monkeypatch.setattr(Path, "write_text", full)
    with pytest.raises(SceneError, match="No space left"):
        generate(pendulum(), tmp_path)
    assert {path.name: path.read_bytes() for path in tmp_path.iterdir()} == before
    assert load_model(tmp_path).name == "pendulum"


@pytest.mark.skipif(os.name == "nt", reason="modes are those of POSIX")
def test_files_are_as_private_as_the_user_wants(tmp_path: Path) -> None:
    before = os.umask(0o077)
    try:
        generate(pendulum(), tmp_path / "private")
        os.umask(0o000)
        generate(pendulum(), tmp_path / "open")
    finally:
        os.umask(before)
    assert {path.stat().st_mode & 0o777 for path in (tmp_path / "private").iterdir()} == {0o600}
    assert {path.stat().st_mode & 0o777 for path in (tmp_path / "open").iterdir()} == {0o644}


def test_results_do_not_replace_a_model_folder_of_the_users_own(tmp_path: Path) -> None:
    model = tmp_path / "out" / "model"
    model.mkdir(parents=True)
    (model / "model.py").write_text("mine")
    assert main(["simulate", "pendulum", "--t-end", "0.01", "--out", str(tmp_path / "out")]) == ERRORS
    assert (model / "model.py").read_text() == "mine"


def test_code_beside_a_scene_file_does_not_run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A folder ./arm with a matching manifest is not loaded for arm.toml; named itself, it is."""
    scene = SceneRecord.from_toml_text(PENDULUM.replace('name = "pendulum"', 'name = "arm"', 1))
    (tmp_path / "arm.toml").write_text(scene.to_toml())
    generate(scene, tmp_path / "arm")
    planted = tmp_path / "arm" / "model.py"
    text = planted.read_text()
    planted.write_text(text + f"\nopen({str(tmp_path / 'ran')!r}, 'w').close()\n")
    _refresh_manifest(tmp_path / "arm")
    monkeypatch.chdir(tmp_path)
    assert main(["simulate", "arm.toml", "--t-end", "0.01"]) == 0
    assert not (tmp_path / "ran").exists()
    assert main(["simulate", "arm", "--t-end", "0.01"]) == 0
    assert (tmp_path / "ran").exists()


def _refresh_manifest(folder: Path) -> None:
    """As somebody would who wants the code to be run: the hashes fit."""
    import hashlib
    import json

    from runtime.contract import loading

    manifest = json.loads((folder / "manifest.json").read_text())
    manifest["files"]["model.py"] = hashlib.sha256((folder / "model.py").read_bytes()).hexdigest()
    manifest["sha256"] = loading.manifest_digest(manifest)
    (folder / "manifest.json").write_text(json.dumps(manifest))


def _environment() -> dict[str, str]:
    root = str(Path(__file__).resolve().parents[2])
    return {**os.environ, "PYTHONPATH": os.pathsep.join([root, os.environ.get("PYTHONPATH", "")])}


def test_line_ends_in_an_expression_do_not_make_the_model_look_edited(tmp_path: Path) -> None:
    scene = Scene("wobble", description="one\r\ntwo").gravity(0, -9.81).parameter("g", 2.0)
    scene = scene.rigid("bob", mass="g\r\n", inertia=1.0).revolute("pin", "ground.origin", "bob.origin")
    folder = generate(scene.build(), tmp_path / "wobble")
    assert load_model(folder).name == "wobble"
    assert main(["generate", str(folder), "--check"]) == 0


def test_long_dotted_names_are_refused_at_once() -> None:
    for key in ("a." * 200_000 + "a", '"a".' * 1000 + "a", "a . " * 1000 + "a"):
        with pytest.raises(SceneError, match="dotted name"):
            SceneRecord.from_toml_text(f"{key} = 1\n")
    with pytest.raises(SceneError, match="characters"):  # one long word is no dotted name, and takes no time
        SceneRecord.from_toml_text(f'name = "pendulum"\ntitle = "{"a" * 1_000_000}"\n')


def test_a_pipe_is_not_a_scene_file(tmp_path: Path) -> None:
    pipe = tmp_path / "scene.toml"
    os.mkfifo(pipe)
    found: list[str] = []

    def read() -> None:
        try:
            SceneRecord.from_toml(pipe)
        except SceneError as error:
            found.append(str(error))

    thread = threading.Thread(target=read, daemon=True)
    thread.start()
    thread.join(timeout=20)
    assert found and "not a regular file" in found[0]


def test_sizes_have_limits_with_names() -> None:
    many = Scene("many")
    for k in range(MAX_COORDINATES // 3 + 1):
        many = many.rigid(f"b{k}", mass=1, inertia=1, free=True)
    with pytest.raises(SceneError, match=f"more than {MAX_COORDINATES}"):
        many.build()
    lateral = {"ends": "clamped-free", "modes": MAX_BODY_MODES + 1}
    sizes = {"length": 1, "density": 1, "area": 1, "second_moment": 1, "youngs_modulus": 1}
    with pytest.raises(SceneError, match=f"more than {MAX_BODY_MODES}"):
        Scene("fine").beam("b", **sizes, lateral=lateral, free=True).build()


@pytest.mark.parametrize(
    "arguments",
    [
        ["animate", "pendulum", "--frames", "1000000000"],
        ["advise", "pendulum", "--tolerance", "-1"],
        ["advise", "pendulum", "--tolerance", "0"],
        ["generate", "n_four_bar", "--with", "windows=0", "--out", "nowhere"],
        ["generate", "pendulum", "--functions", "substep_99", "--out", "nowhere"],
        ["generate", "spin_up_beam", "--with", "stiffening=3", "--out", "nowhere"],
    ],
    ids=lambda arguments: " ".join(arguments[2:4]),
)
def test_impossible_numbers_are_refused(arguments: list[str], tmp_path: Path, monkeypatch, capsys) -> None:
    monkeypatch.chdir(tmp_path)
    assert main(arguments) == ERRORS
    assert capsys.readouterr().err
    assert not list(tmp_path.iterdir())


def test_a_scheme_that_there_is_not_is_refused_with_the_scene() -> None:
    with pytest.raises(SceneError, match="did you mean 'exponential'"):
        SceneRecord.from_toml_text(PENDULUM.replace('scheme = "', 'scheme = "expnential" # "'))


def test_scenes_may_ask_for_every_scheme() -> None:
    assert set(SCHEME_NAMES) == {*SCHEMES, "auto"}
    assert set(GROUPED_SCHEMES) == {name for name, kind in SCHEMES.items() if kind.ratios == "groups"}


def test_the_start_of_a_model_is_not_written_to() -> None:
    """It would be that of all later runs."""
    model = load_model(generated_folder("pendulum"))
    for start in (model.initial_q, model.initial_q_dot):
        with pytest.raises(ValueError, match="read-only"):
            start[0] = 1.0


def test_what_was_given_is_not_echoed_at_full_length(capsys) -> None:
    assert main(["simulate", "x" * 1_000_000]) == ERRORS
    assert len(capsys.readouterr().err) < 2 * LONGEST_MESSAGE


@pytest.mark.parametrize(
    "given", [{"scheme": "x" * 10**6}, {"parameters": {"x" * 10**6: 1.0}}, {"initial": {"x" * 10**6: 1.0}}], ids=list
)
def test_a_long_name_is_shortened_in_a_message(given: dict[str, object]) -> None:
    with pytest.raises(SymgenError) as caught:
        simulate(load_model(generated_folder("pendulum")), **given)
    message = str(caught.value)
    assert len(message) < 1.1 * LONGEST_MESSAGE and "characters left out" in message
