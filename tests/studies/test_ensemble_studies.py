"""Studies of many cases: kept in folders, shared by executors; what goes in, what comes out, and what is refused."""

from __future__ import annotations

import signal
from collections.abc import Callable
from concurrent.futures import Executor, Future
from concurrent.futures.process import BrokenProcessPool
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.stats import qmc

from runtime import ensemble
from runtime.contract.errors import ArgumentError, NoResult, SymgenError
from runtime.contract.model import Model
from runtime.studies.ensemble import parts, question
from runtime.studies.ensemble.rows import Rows
from tests.support.pendula import SHORT, pendula

pytestmark = pytest.mark.long

Load = Callable[[str], Model]


class InThisProcess(Executor):
    """Runs tasks at once; after `lives` of them it dies, as a pool whose process was killed does."""

    def __init__(self, lives: int = 1000) -> None:
        self.lives = lives

    def submit(self, function: Any, /, *arguments: Any, **named: Any) -> Future[Any]:
        future: Future[Any] = Future()
        if self.lives == 0:
            future.set_exception(BrokenProcessPool("a process ended abruptly"))
            return future
        self.lives -= 1
        assert all(isinstance(argument, str | int) for argument in arguments)  # a folder, a hash and numbers
        future.set_result(function(*arguments, **named))
        return future


@pytest.fixture
def small_parts(monkeypatch: pytest.MonkeyPatch) -> None:
    """Parts of 128 cases."""
    monkeypatch.setattr(question, "LARGEST_PART", 128)


@pytest.fixture
def runs_made(monkeypatch: pytest.MonkeyPatch) -> list[tuple[int, int]]:
    """(first, stop) of all jobs that are run."""
    made: list[tuple[int, int]] = []
    run = Rows.of

    def noted(self: Rows, first: int, stop: int, *more: Any) -> Any:
        made.append((first, stop))
        return run(self, first, stop, *more)

    monkeypatch.setattr(Rows, "of", noted)
    return made


@pytest.mark.usefixtures("small_parts")
def test_an_interrupted_study_goes_on(built_in: Load, tmp_path: Path, runs_made: list[tuple[int, int]]) -> None:
    """Finished parts are not run again; a damaged one is. The answer is that of one process without a folder."""
    model, folder = built_in("pendulum"), tmp_path / "study"

    def stop_at_once(done: float, cases: float) -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        pendula(model, 300, seen_every=5e-3, folder=folder, progress=stop_at_once, workers=1)
    first = sorted(folder.glob("part-*.bin"))
    assert 0 < len(first) < 3
    before = set(runs_made)
    runs_made.clear()
    found = pendula(model, 300, seen_every=5e-3, folder=folder)
    assert runs_made and all(span[0] >= 128 for span in runs_made) and before
    assert found.identical(pendula(model, 300, seen_every=5e-3))
    damaged = folder / "part-00001.bin"
    content = bytearray(damaged.read_bytes())
    content[100] ^= 1
    damaged.write_bytes(bytes(content))
    runs_made.clear()
    assert found.identical(pendula(model, 300, seen_every=5e-3, folder=folder))
    assert {span[0] // 128 for span in runs_made} == {1}
    with pytest.raises(ArgumentError, match="another study"):
        pendula(model, 300, seen_every=4e-3, folder=folder)
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "letter.txt").write_text("dear reader")
    with pytest.raises(ArgumentError, match="not empty"):
        pendula(model, 300, seen_every=5e-3, folder=tmp_path / "mine")


@pytest.mark.usefixtures("ctrl_c")
def test_ctrl_c_keeps_what_is_done(built_in: Load) -> None:
    """Cases that were not run are `interrupted`; those that were have their values."""
    told: list[float] = []

    def press(done: float, cases: float) -> None:
        if not told:
            signal.raise_signal(signal.SIGINT)
        told.append(done)

    model = built_in("pendulum")
    found = pendula(model, 9000, seen_every=5e-3, workers=1, progress=press)
    done = int(told[-1])
    assert 0 < done < 9000 and (found["status"][:done] == "completed").all()
    assert (found["status"][done:] == "interrupted").all() and np.isnan(found["tip_y"][done:]).all()
    np.testing.assert_array_equal(found["tip_y"][:5], pendula(model, 9000, seen_every=5e-3)["tip_y"][:5])


@pytest.mark.usefixtures("small_parts")
def test_executors_change_no_bit_and_may_die(built_in: Load, tmp_path: Path) -> None:
    model = built_in("pendulum")
    expected = pendula(model, 300, seen_every=5e-3)
    assert expected.identical(pendula(model, 300, seen_every=5e-3, executor=InThisProcess()))
    with pytest.raises(NoResult, match="InThisProcess.*BrokenProcessPool") as raised:
        pendula(model, 300, seen_every=5e-3, executor=InThisProcess(lives=1), folder=tmp_path / "study")
    assert str(tmp_path / "study") in str(raised.value)
    assert (tmp_path / "study" / "part-00000.bin").exists()
    assert expected.identical(pendula(model, 300, seen_every=5e-3, folder=tmp_path / "study"))


# ---- what goes in and out -----------------------------------------------------------------------------------------


class Table:
    """What of a DataFrame is used: named columns."""

    def __init__(self, columns: dict[str, list[float]]) -> None:
        self.columns, self._values = list(columns), columns

    def __getitem__(self, name: str) -> list[float]:
        return self._values[name]


def test_samples_and_tables_go_straight_in(built_in: Load, monkeypatch: pytest.MonkeyPatch) -> None:
    """And without xarray a dictionary of the same arrays comes out."""
    model = built_in("pendulum")
    points = qmc.scale(qmc.LatinHypercube(2, rng=1).random(6), [0.5, 0.9], [1.0, 1.1])
    mass = next(parameter.name for parameter in model.parameters if parameter.name == "rod.mass")
    columns = {mass: points[:, 0].tolist(), "length": points[:, 1].tolist()}
    settings: dict[str, Any] = {**SHORT, "reduce": {"tip_y": "end"}}
    by_tuple = ensemble(model, {(mass, "length"): points}, **settings)
    assert by_tuple.identical(ensemble(model, Table(columns), **settings))
    np.testing.assert_array_equal(by_tuple["length"], points[:, 1])
    monkeypatch.setattr(parts, "find_spec", lambda name: None)
    plain = ensemble(model, columns, **settings)
    assert isinstance(plain, dict) and set(plain) == {
        "case",
        mass,
        "length",
        "status",
        "time_reached",
        "tip_y_end",
    }
    np.testing.assert_array_equal(plain["tip_y_end"], by_tuple["tip_y_end"])


@pytest.mark.parametrize(
    "given, words",
    [
        ({"parameters": {"rod.colour": [1.0, 2.0]}}, "rod.colour"),
        ({"initial": {"rod.phi": [1.0, 2.0]}}, "rod.phi"),
        ({"parameters": {"rod.mass": [1.0, 2.0]}, "initial": {"rod.theta": [1.0, 2.0, 3.0]}}, "rod.theta.*3 values.*2"),
        ({"parameters": {"rod.mass": [1.0, float("nan")]}}, r"rod.mass\[1\].*nan"),
        ({"parameters": {"rod.mass": [1.0, -2.0]}}, r"rod.mass\[1\].*at least zero"),
        ({"parameters": {("rod.mass", "length"): np.ones((4, 3))}}, "2 columns"),
        ({"parameters": {"rod.mass": "heavy"}}, "rod.mass"),
        ({"parameters": {"rod.mass": 1.0}}, "one case"),
        ({"parameters": [1.0, 2.0]}, "parameters.*names"),
        ({"outputs": ["tip_z"]}, "tip_z"),
        ({"outputs": "tip_y"}, "outputs.*list"),
        ({"outputs": ["tip_y"], "reduce": {"tip_x": "max"}}, "tip_x.*none of the outputs"),
        ({"reduce": {"tip_y": "median"}}, "median.*max"),
        ({"reduce": {"tip_y": "max"}, "seen_every": 3e-3}, "reduce and seen_every"),
        ({"seen_every": -1.0}, "seen_every"),
        ({"inputs": {"push": [1.0, 2.0]}}, "no input 'push'"),
        ({"workers": 0}, "workers"),
        ({"executor": "two"}, "executor"),
        ({"scheme": "fastest"}, "fastest"),
    ],
)
def test_bad_input_is_named(built_in: Load, given: dict[str, Any], words: str) -> None:
    usual: dict[str, Any] = {**SHORT, "parameters": {"rod.mass": [1.0, 2.0]}, "outputs": ["tip_y"]}
    if "reduce" in given and "outputs" not in given:
        usual["outputs"] = None
    if "initial" in given and "parameters" not in given:
        usual["parameters"] = None
    with pytest.raises(SymgenError, match=words):
        ensemble(built_in("pendulum"), **{**usual, **given})
