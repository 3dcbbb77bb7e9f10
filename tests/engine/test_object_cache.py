"""What is kept of compiled programs: verified, private, bounded, shown and cleared."""

from __future__ import annotations

import json
import os
import stat
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from runtime.engine import object_cache
from runtime.engine.llvm_code import BEST, FIRST_EFFORT
from runtime.engine.object_cache import ObjectCache
from runtime.engine.program import Form
from runtime.model import Model
from symgen.cli import main
from tests.support.step_programs import step_program

Load = Callable[[str], Model]
posix = os.name == "posix"


@pytest.fixture
def cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> ObjectCache:
    monkeypatch.setenv("SYMGEN_CACHE", str(tmp_path / "cache"))
    return ObjectCache()


def test_what_was_written_is_read(cache: ObjectCache) -> None:
    cache.write("key", b"machine code", 17)
    assert cache.read("key") == (b"machine code", 17)
    assert cache.read("other") is None


@pytest.mark.parametrize(
    "damage", [lambda data: data[:-1], lambda data: data[:60] + b"!" + data[61:], lambda data: b""]
)
def test_damaged_files_are_removed(cache: ObjectCache, damage: Callable[[bytes], bytes]) -> None:
    cache.write("key", bytes(100), 0)
    file = cache.folder / "key.o"
    file.write_bytes(damage(file.read_bytes()))
    assert cache.read("key") is None
    assert not file.exists()


def test_the_folder_is_private(cache: ObjectCache) -> None:
    cache.write("key", b"code", 0)
    assert not posix or stat.S_IMODE(cache.folder.stat().st_mode) == 0o700


def test_an_open_folder_is_not_used(cache: ObjectCache) -> None:
    cache.write("key", b"code", 0)
    cache.folder.chmod(0o777)
    assert not posix or "open to other users" in cache.refused()
    assert not posix or cache.read("key") is None


def test_a_folder_of_another_user_is_not_used(cache: ObjectCache, monkeypatch: pytest.MonkeyPatch) -> None:
    cache.write("key", b"code", 0)
    monkeypatch.setattr(os, "getuid", lambda: 12345, raising=False)
    assert not posix or "another user" in cache.refused()
    assert not posix or cache.read("key") is None


def test_the_least_recently_used_go_first(cache: ObjectCache, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(object_cache, "MOST_CACHE_BYTES", 1000)
    for k in range(4):
        cache.write(f"key{k}", bytes(200), 0)
        os.utime(cache.folder / f"key{k}.o", (k, k))
    cache.read("key0")  # used now
    cache.write("new", bytes(200), 0)
    assert sorted(path.stem for path, _, _ in cache.entries()) == ["key0", "key2", "key3", "new"]
    assert sum(size for _, size, _ in cache.entries()) <= 1000


def test_no_folder_no_cache(tmp_path: Path, built_in: Load, monkeypatch: pytest.MonkeyPatch) -> None:
    """A file in the way: programs are compiled all the same."""
    (tmp_path / "file").write_text("in the way")
    monkeypatch.setenv("SYMGEN_CACHE", str(tmp_path / "file"))
    given = step_program(built_in("pendulum"), "single_rate", None)
    assert np.isfinite(given.run(3, Form(), FIRST_EFFORT)).all()
    assert ObjectCache().refused()


def test_a_program_is_compiled_once(cache: ObjectCache, built_in: Load, monkeypatch: pytest.MonkeyPatch) -> None:
    given = step_program(built_in("pendulum"), "single_rate", None)
    expected = given.run(5, Form(), BEST)
    (kept,) = cache.entries()
    monkeypatch.setattr("runtime.engine.llvm_ir.program_ir", None)  # not to be called
    np.testing.assert_array_equal(given.run(5, Form(), BEST), expected)
    kept[0].write_bytes(b"damaged")
    with pytest.raises(TypeError):
        given.run(5, Form(), BEST)


def test_keys_tell_programs_and_forms_apart(cache: ObjectCache, built_in: Load) -> None:
    step_program(built_in("pendulum"), "single_rate", None, 1e-3).run(1, Form(), BEST)
    kept = len(cache.entries())
    step_program(built_in("pendulum"), "single_rate", None, 2e-3).run(1, Form(), BEST)
    assert len(cache.entries()) == kept > 0  # the step is data of the program: the same code
    given = step_program(built_in("pendulum"), "rk4", None)
    kept = len(cache.entries())
    for form, effort in ((Form(), BEST), (Form(), FIRST_EFFORT), (Form(2), BEST), (Form(mathematics="library"), BEST)):
        given.run(1, form, effort)
    assert len(cache.entries()) == kept + 4


def test_the_command_shows_and_clears(cache: ObjectCache, capsys: pytest.CaptureFixture[str]) -> None:
    cache.write("key", bytes(60), 0)
    assert main(["cache", "--json"]) == 0
    shown = json.loads(capsys.readouterr().out)
    assert (shown["programs"], shown["bytes"]) == (1, 100)
    assert main(["cache", "--clear"]) == 0
    assert "1 removed" in capsys.readouterr().out
    assert cache.entries() == []
