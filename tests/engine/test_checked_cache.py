"""All kinds of the cache have one way in: nothing of another owner, and nothing that others can write, is run."""

from __future__ import annotations

import errno
import json
import os
import subprocess
import time
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from runtime import load_model
from runtime.contract import cache as contract_cache
from runtime.contract import files
from runtime.contract.cache import read_own
from runtime.contract.errors import CompilerError
from runtime.contract.loading import manifest_digest, sha256
from runtime.engine.object_cache import ObjectCache
from runtime.export.c_bundle import exported
from runtime.export.fmu import write_fmu
from runtime.running.singular.exchange import variant_of
from symgen.cli import main
from symgen.scene import Scene
from symgen.scenes import generated_folder

pytestmark = pytest.mark.skipif(os.name == "nt", reason="owners and modes are those of POSIX")


@pytest.fixture(autouse=True)
def root(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("SYMGEN_CACHE", str(tmp_path / "cache"))
    return tmp_path / "cache"


def arm() -> Any:
    return Scene("kept_arm").rigid("arm", mass=1, inertia=0.1).revolute("pin", "ground.origin", "arm.origin").build()


def scene_model() -> str:
    """A model of a scene: what it is called."""
    return str(arm().model().name)


def model_variant() -> str:
    """A variant of a model, as a run asks for it."""
    model = load_model(generated_folder("four_bar"))
    (crank,) = model.q_i
    return str(variant_of(model, ["rocker.theta"], model.initial_q).name) if crank != "rocker.theta" else ""


KINDS = {"models": (scene_model, "kept_arm"), "variants": (model_variant, "four_bar")}


def plant(room: Path, mark: Path) -> Path:
    """Code that leaves a mark, in the one model of a room, with hashes that fit; the model's folder."""
    (folder,) = [path for path in room.iterdir() if path.is_dir()]
    text = (folder / "model.py").read_text() + f"\nopen({str(mark)!r}, 'w').close()\n"
    (folder / "model.py").write_text(text)
    manifest = json.loads((folder / "manifest.json").read_text())
    manifest["files"]["model.py"] = sha256(text)
    manifest["sha256"] = manifest_digest(manifest)
    (folder / "manifest.json").write_text(json.dumps(manifest))
    return folder


def opened_to_all(room: Path, folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    room.chmod(0o777)


def of_another_user(room: Path, folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(os, "getuid", lambda: 12345)


def one_file_of_another_user(room: Path, folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    real, number = os.fstat, (folder / "model.py").stat().st_ino

    def fstat(handle: int) -> Any:
        found = real(handle)
        if found.st_ino != number:
            return found
        return SimpleNamespace(st_mode=found.st_mode, st_uid=found.st_uid + 1, st_ino=found.st_ino)

    monkeypatch.setattr(contract_cache.os, "fstat", fstat)


def written_by_all(room: Path, folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (folder / "model.py").chmod(0o666)


def written_by_a_group(room: Path, folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (folder / "manifest.json").chmod(0o664)


def behind_a_link(room: Path, folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    elsewhere = room.parent / "elsewhere.py"
    (folder / "model.py").rename(elsewhere)
    (folder / "model.py").symlink_to(elsewhere)


WAYS = (opened_to_all, of_another_user, one_file_of_another_user, written_by_all, written_by_a_group, behind_a_link)


@pytest.mark.parametrize("way", WAYS, ids=lambda way: way.__name__)
@pytest.mark.parametrize("kind", KINDS)
def test_planted_code_is_not_run(
    kind: str,
    way: Callable[[Path, Path, pytest.MonkeyPatch], None],
    root: Path,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """It does run where the folder is the user's own and closed, which shows that the plant works."""
    make, name = KINDS[kind]
    mark = tmp_path / "ran"
    assert make() == name
    folder = plant(root / kind, mark)
    make()
    assert mark.exists()
    mark.unlink()
    way(root / kind, folder, monkeypatch)
    assert make() == name and not mark.exists()


def test_a_folder_that_others_could_only_read_is_closed(root: Path, tmp_path: Path) -> None:
    """As older versions made that of variants: what is in it is the user's, so it is used on."""
    make, name = KINDS["variants"]
    make()
    plant(root / "variants", tmp_path / "ran")
    (root / "variants").chmod(0o755)
    assert make() == name and (tmp_path / "ran").exists()
    assert (root / "variants").stat().st_mode & 0o777 == 0o700


def test_a_user_without_a_home_has_no_cache(monkeypatch: pytest.MonkeyPatch) -> None:
    def home() -> Path:
        raise RuntimeError("Could not determine home directory.")

    for name in ("SYMGEN_CACHE", "XDG_CACHE_HOME"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setattr(Path, "home", home)
    assert ObjectCache().refused()
    assert scene_model() == "kept_arm"


def test_an_object_that_others_can_write_is_not_loaded(root: Path) -> None:
    cache = ObjectCache()
    cache.write("key", b"machine code", 1)
    (root / "objects" / "key.o").chmod(0o666)
    assert cache.read("key") is None


def test_what_is_read_is_an_ordinary_file_of_ones_own(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")
    (tmp_path / "file").write_bytes(b"own")
    (tmp_path / "link").symlink_to(tmp_path / "file")
    assert read_own(tmp_path / "file") == b"own"
    for name in ("pipe", "link", "", "none"):
        with pytest.raises(OSError):
            read_own(tmp_path / name)


@pytest.mark.parametrize("kind", KINDS)
def test_a_full_disk_keeps_nothing_and_stops_nothing(kind: str, root: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    real = files.os.replace

    def full(source: Any, target: Any) -> None:
        if str(root) in str(target):
            raise OSError(errno.ENOSPC, "No space left on device")
        real(source, target)

    monkeypatch.setattr(files.os, "replace", full)
    make, name = KINDS[kind]
    assert make() == name
    assert not list((root / kind).iterdir())


def test_nothing_is_left_of_what_could_not_be_written(root: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    real = Path.write_bytes

    def full(path: Path, data: bytes) -> int:
        real(path, data[: len(data) // 2])
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(Path, "write_bytes", full)
    ObjectCache().write("key", bytes(1000), 0)
    assert not list((root / "objects").iterdir())


def litter(room: Path, age: float) -> list[Path]:
    """What killed processes leave: a file and a folder, as this version and older ones call them."""
    room.mkdir(mode=0o700, parents=True, exist_ok=True)
    made = [room / ".writing-abc", room / "tmpab12_xyz"]
    made[0].write_bytes(bytes(10))
    if room.name == "objects":
        made[1].write_bytes(bytes(10))
    else:
        made[1].mkdir(exist_ok=True)
        (made[1] / "model.py").write_text("half")
    for path in made:
        os.utime(path, (time.time() - age, time.time() - age))
    return made


def test_what_was_left_under_way_is_swept(root: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """By the next process that writes, once it is old: what is young may be another's that still writes."""
    monkeypatch.setattr(ObjectCache, "written", float("inf"))
    for age, stays in ((10.0, True), (2 * files.STALE, False)):
        left = [path for room in ("objects", "models") for path in litter(root / room, age)]
        ObjectCache().write("key", b"code", 0)
        ObjectCache.written = float("inf")
        for folder in (root / "models").glob("kept_arm*"):
            (folder / "manifest.json").unlink()
        assert scene_model() == "kept_arm"
        assert [path.exists() for path in left] == [stays] * len(left)


def test_clear_sees_all_of_it(root: Path, capsys: pytest.CaptureFixture[str]) -> None:
    ObjectCache().write("key", b"code", 0)
    scene_model()
    model_variant()
    for room in ("objects", "models", "variants"):
        litter(root / room, 0.0)
    assert main(["cache", "--clear", "--json"]) == 0
    shown = json.loads(capsys.readouterr().out)
    assert (shown["programs"], shown["models"], shown["variants"], shown["removed"]) == (1, 1, 1, 9)
    assert not [path for room in ("objects", "models", "variants") for path in (root / room).iterdir()]


def test_the_command_says_which_folder_is_refused_and_clears_the_others(root: Path, capsys: Any) -> None:
    ObjectCache().write("key", b"code", 0)
    model_variant()
    (root / "variants").chmod(0o777)
    assert main(["cache", "--clear", "--json"]) == 0
    shown = json.loads(capsys.readouterr().out)
    assert "variants is open to other users" in shown["refused"] and shown["removed"] == 1
    assert list((root / "variants").iterdir())


@pytest.mark.parametrize("mode", [0o700, 0o777])
def test_a_compilers_cache_is_in_ours_or_private(mode: int, root: Path, tmp_path: Path, monkeypatch: Any) -> None:
    """It was one folder of a fixed name in the shared temporary folder, where anybody could put libraries."""
    (root / "zig").mkdir(parents=True)
    (root / "zig").chmod(mode)
    seen: list[Path] = []

    def run(command: Any, **how: Any) -> Any:
        seen.append(Path(how["env"]["ZIG_GLOBAL_CACHE_DIR"]))
        private = seen[-1] == (root / "zig").resolve() or (seen[-1].stat().st_mode & 0o777) == 0o700
        return SimpleNamespace(returncode=1, stderr=f"private: {private}")

    monkeypatch.setenv("CC", "cc")
    monkeypatch.setattr(subprocess, "run", run)
    with pytest.raises(CompilerError, match="private: True"):
        write_fmu(exported(load_model(generated_folder("pendulum"))), tmp_path / "p.fmu", platforms=["linux64"])
    assert (seen[0] == (root / "zig").resolve()) is (mode == 0o700)
