"""Places that a run writes to: tried before it starts, and nothing in memory is lost where they fail later."""

from __future__ import annotations

import os
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from runtime import ArgumentError, OutputError, SchemeError, resume, simulate
from runtime.contract.files import STALE, replacing, write_text
from runtime.model import Model
from runtime.results.stream import ROWS, StreamFile, read_blocks
from runtime.running.checkpoint import Checkpoint
from symgen.scenes.pendulums import pendulum

Load = Callable[[str], Model]


@pytest.mark.parametrize("place", ["folder", "nul\0name", "/proc/x", "/dev/null", "scene.toml"])
def test_a_checkpoint_that_cannot_be_written_stops_the_run_before_it_starts(
    built_in: Load, place: str, tmp_path: Path
) -> None:
    (tmp_path / "folder").mkdir()
    (tmp_path / "scene.toml").write_text(pendulum().to_toml())
    path = place if place.startswith("/") else str(tmp_path / place)
    seen: list[float] = []
    with pytest.raises((OutputError, ArgumentError)):
        simulate(built_in("pendulum"), checkpoint=path, progress=lambda t, end: seen.append(t))
    assert not seen
    assert (tmp_path / "scene.toml").read_text() == pendulum().to_toml()
    assert sorted(entry.name for entry in tmp_path.iterdir()) == ["folder", "scene.toml"]


def test_an_older_checkpoint_may_be_replaced(built_in: Load, tmp_path: Path) -> None:
    path = tmp_path / "run.npz"
    for _ in range(2):
        simulate(built_in("pendulum"), t_end=0.2, dt=1e-3, checkpoint=path, checkpoint_every=50)
    assert resume(built_in("pendulum"), path).status.ok


def test_a_checkpoint_that_fails_on_the_way_costs_nothing(built_in: Load, tmp_path: Path, monkeypatch) -> None:
    def full(self: Checkpoint, path: str | Path) -> None:
        raise OutputError(f"{path} cannot be written (No space left on device)")

    monkeypatch.setattr(Checkpoint, "write", full)
    arguments = {"t_end": 0.2, "dt": 1e-3, "seen_every": 0.01}
    found = simulate(built_in("pendulum"), **arguments, checkpoint=tmp_path / "run.npz", checkpoint_every=50)
    monkeypatch.undo()
    undisturbed = simulate(built_in("pendulum"), **arguments)
    assert found.status.ok
    np.testing.assert_array_equal(found.q, undisturbed.q)
    assert [event.kind for event in found.events] == ["checkpoint_failed"]
    assert "No space left" in found.events[0].text


def test_two_runs_do_not_write_one_stream(built_in: Load, tmp_path: Path) -> None:
    first = StreamFile(tmp_path / "rows", [("t", ())])
    with pytest.raises(OutputError, match="another run"):
        simulate(built_in("pendulum"), t_end=0.1, dt=1e-3, stream=tmp_path / "rows")
    first.close()
    assert simulate(built_in("pendulum"), t_end=0.1, dt=1e-3, stream=tmp_path / "rows").status.ok
    assert simulate(built_in("pendulum"), t_end=0.1, dt=1e-3, stream=tmp_path / "rows").status.ok


@pytest.mark.parametrize("name", ["notes.txt", "header.json", ".hidden"])
def test_a_folder_with_files_of_others_takes_no_stream(built_in: Load, tmp_path: Path, name: str) -> None:
    (tmp_path / name).write_text("mine")
    with pytest.raises(OutputError, match=f"holds {name} and is not a stream of samples; choose a new or an empty"):
        simulate(built_in("pendulum"), t_end=0.01, stream=tmp_path)
    assert [path.name for path in tmp_path.iterdir()] == [name] and (tmp_path / name).read_text() == "mine"


def test_rows_of_somebody_else_are_not_written_over(built_in: Load, tmp_path: Path) -> None:
    (tmp_path / ROWS).write_bytes(b"mine")
    with pytest.raises(OutputError, match="not a stream of samples"):
        simulate(built_in("pendulum"), t_end=0.1, dt=1e-3, stream=tmp_path)
    assert (tmp_path / ROWS).read_bytes() == b"mine"


def test_a_stream_that_takes_no_more_ends_the_run_by_name(built_in: Load, tmp_path: Path, monkeypatch) -> None:
    """The disk is full after some rows: status with the time, the rows before it stay readable."""
    append, blocks = StreamFile.append, []

    def until_full(self: StreamFile, block: np.ndarray) -> None:
        if blocks:
            raise OutputError(f"{self.folder} cannot take more samples (No space left on device); free some space")
        blocks.append(len(block))
        append(self, block)

    monkeypatch.setattr(StreamFile, "append", until_full)
    run = simulate(built_in("pendulum"), t_end=5.0, dt=1e-3, seen_every=0.0, stream=tmp_path / "rows")
    assert run.status.name == "output_failed"
    assert 0 < run.status.time < 5.0
    assert "No space left" in run.status.cause
    assert sum(len(block["t"]) for block in read_blocks(tmp_path / "rows")) == blocks[0]


def test_what_a_killed_process_left_is_removed_at_the_next_write(tmp_path: Path) -> None:
    """After an hour, whichever file it wrote; what is younger may be written still."""
    program = (
        "import os, sys\nfrom runtime.contract.files import replacing\n"
        "with replacing(sys.argv[1] + '/killed.npz'): os.kill(os.getpid(), 9)"
    )
    subprocess.run([sys.executable, "-c", program, str(tmp_path)], check=False)
    (stale,) = tmp_path.iterdir()
    assert stale.name.startswith(".writing-")
    recent = tmp_path / ".writing-b.npz"
    recent.write_text("")
    old = time.time() - STALE - 10
    os.utime(stale, (old, old))
    with replacing(tmp_path / "other.npz") as mine:
        write_text(tmp_path / "run.npz", "new")
        assert sorted(path.name for path in tmp_path.iterdir()) == sorted([recent.name, mine.name, "run.npz"])
    with pytest.raises(KeyboardInterrupt), replacing(tmp_path / "run.npz"):
        raise KeyboardInterrupt
    assert (tmp_path / "run.npz").read_text() == "new"


def test_what_breaks_a_run_closes_its_stream(built_in: Load, tmp_path: Path) -> None:
    """An exception that nobody expects: the next run may write to the same folder while the first is looked into."""

    def breaks(t: float, t_end: float) -> None:
        raise ValueError("of the caller's own")

    with pytest.raises(ValueError, match="of the caller's own") as found:
        simulate(built_in("pendulum"), t_end=0.01, stream=tmp_path / "samples", progress=breaks)
    assert simulate(built_in("pendulum"), t_end=0.01, stream=tmp_path / "samples").status.ok
    assert found.tb is not None  # the frames of the first run are still there


@pytest.mark.parametrize(
    "scheme, option",
    [("single_rate", "newton_iterations"), ("rk4", "closure_iterations"), ("printed", "max_iterations")],
)
def test_iterations_without_end_are_refused(built_in: Load, scheme: str, option: str) -> None:
    """Written out, or repeated: a number that would take hours is refused by name."""
    with pytest.raises(SchemeError, match=f"{option} must be a whole number from 1 to "):
        simulate(built_in("pendulum"), scheme=scheme, options={option: 1_000_000})


def test_files_are_read_by_all_and_written_by_their_owner(tmp_path: Path) -> None:
    write_text(tmp_path / "a.txt", "a")
    assert (tmp_path / "a.txt").stat().st_mode & 0o777 == 0o644
