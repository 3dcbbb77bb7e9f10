"""A run that is broken off and resumed is the uninterrupted run, bit for bit; wrong checkpoints are refused."""

from __future__ import annotations

import json
import shutil
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from runtime import SCHEMES, ArgumentError, ModelError, OutputError, SchemeError, Solution, load_model, resume, simulate
from runtime.model import Model
from runtime.running.checkpoint import Checkpoint, read_checkpoint
from symgen.generate import generate
from symgen.scenes import SCENES

pytestmark = pytest.mark.long

Load = Callable[[str], Model]
SERIES = (
    "t",
    "q",
    "q_dot",
    "q_ddot",
    "q_i",
    "lam",
    "joint_forces",
    "measures",
    "constraint_error",
    "constraint_rate_error",
)
STEPS, EVERY, SAVED, BROKEN_OFF = 60, 7, 4, 33
STEP = {"hub_beam": 2e-4, "slider_crank": 2e-5, "flexible_slider_crank_free": 2e-5}


class Break:
    """Progress that presses Ctrl-C after so many steps, and keeps a copy of the checkpoint that was there before."""

    def __init__(self, time: float, path: Path) -> None:
        self.time, self.path, self.copy = time, path, path.with_name("copy.npz")

    def __call__(self, t: float, t_end: float) -> None:
        if t >= self.time:
            shutil.copy(self.path, self.copy)
            raise KeyboardInterrupt


def assert_same(one: Solution, other: Solution) -> None:
    for name in SERIES:
        assert np.array_equal(getattr(one, name), getattr(other, name)), name
    for key in one.energy:
        assert np.array_equal(one.energy[key], other.energy[key]), key
    assert one.status == other.status and one.stats["steps"] == other.stats["steps"]
    assert one.stats["full_evaluations"] == other.stats["full_evaluations"]


def stop_at(t: float, end: float) -> None:
    if t >= end:
        raise KeyboardInterrupt


def told(one: Solution) -> dict[str, Any]:
    """Statistics that no clock is in."""
    return {name: value for name, value in one.stats.items() if "seconds" not in name}


def settings_of(name: str, scheme: str, engine: str) -> dict[str, Any]:
    dt = STEP[name]
    m = {"none": None, "sub_steps": [2], "groups": [3] if name != "slider_crank" else None}[SCHEMES[scheme].ratios]
    return {
        "scheme": scheme,
        "dt": dt,
        "m": m,
        "t_end": STEPS * dt,
        "seen_every": SAVED * dt,
        "engine": engine,
        "force": True,
    }


def broken_off(model: Model, settings: dict[str, Any], path: Path, **more: Any) -> Break:
    stop = Break(BROKEN_OFF * settings["dt"], path)
    solution = simulate(model, **settings, checkpoint=path, checkpoint_every=EVERY, progress=stop, **more)
    assert solution.status.name == "interrupted"
    assert BROKEN_OFF <= solution.stats["steps"] < STEPS  # type: ignore[operator]
    return stop


ENGINES = ("interpreted", "compiled")
CASES = [(name, scheme, engine) for name in ("hub_beam", "slider_crank") for scheme in SCHEMES for engine in ENGINES]
CASES += [("flexible_slider_crank_free", scheme, ENGINES[-1]) for scheme in ("printed", "coupled")]


@pytest.mark.parametrize("name, scheme, engine", CASES)
def test_resumed_run_is_the_uninterrupted_run(
    built_in: Load, tmp_path: Path, name: str, scheme: str, engine: str
) -> None:
    model, settings, path = built_in(name), settings_of(name, scheme, engine), tmp_path / "run.npz"
    whole = simulate(model, **settings)
    assert whole.status.ok, whole.status
    stop = broken_off(model, settings, path)
    assert_same(resume(model, path, engine=engine), whole)  # from Ctrl-C
    assert_same(resume(model, stop.copy, engine=engine), whole)  # from the last one before, as after a crash


@pytest.mark.parametrize("scheme", ["auto", "exponential_rk4"])
def test_a_resumed_run_to_a_tolerance_is_the_same(built_in: Load, tmp_path: Path, scheme: str) -> None:
    """The checkpoint is of the run that is the answer; its error is measured by a companion then."""
    model, path = built_in("hub_beam"), tmp_path / "run.npz"
    settings: dict[str, Any] = {"scheme": scheme, "tolerance": 1e-4, "t_end": 0.6}
    whole, stop = simulate(model, **settings), Break(0.3, path)

    def late(t: float, t_end: float) -> None:
        if path.exists():
            stop(t, t_end)

    broken = simulate(model, **settings, checkpoint=path, checkpoint_every=EVERY, progress=late)
    assert broken.status.name == "interrupted"
    for kept in (path, stop.copy):
        resumed = resume(model, kept)
        assert_same(resumed, whole)
        assert 0 < resumed.error.largest < 10 * whole.error.largest < 1e-3


def test_checkpoints_do_not_change_a_run(built_in: Load, tmp_path: Path) -> None:
    model, settings = built_in("slider_crank"), settings_of("slider_crank", "single_rate", "interpreted")
    assert_same(
        simulate(model, **settings, checkpoint=tmp_path / "run.npz", checkpoint_every=1), simulate(model, **settings)
    )


@pytest.mark.parametrize(
    "more",
    [
        {"stream": "rows"},
        {"outputs": ["hub.theta", "hub.theta_dot", "kinetic"]},
        {"outputs": ["hub.theta", "kinetic"], "stream": "rows"},
    ],
)
def test_streams_and_outputs_resume_too(built_in: Load, tmp_path: Path, more: dict[str, Any]) -> None:
    model, settings = built_in("hub_beam"), settings_of("hub_beam", "printed", "interpreted")

    def kept_in(folder: str) -> dict[str, Any]:
        return {**more, "stream": tmp_path / folder} if "stream" in more else more

    whole = simulate(model, **settings, **kept_in("whole"))
    stop = broken_off(model, settings, tmp_path / "run.npz", **kept_in("broken"))
    resumed = resume(model, stop.copy)
    assert_same(resumed, whole)
    for name, values in whole.outputs.items():
        assert np.array_equal(resumed.outputs[name], values)
    if "stream" in more:
        assert (tmp_path / "broken" / "samples.bin").read_bytes() == (tmp_path / "whole" / "samples.bin").read_bytes()


def test_changed_parameters_and_initial_values_are_kept(built_in: Load, tmp_path: Path) -> None:
    model = built_in("slider_crank")
    settings = {
        **settings_of("slider_crank", "rk4", "interpreted"),
        "parameters": {"rod.mass": 0.2},
        "initial": {"crank.theta": 0.3},
        "t0": 0.5,
        "t_end": 0.5 + STEPS * 2e-5,
    }
    whole = simulate(model, **settings)
    stop = Break(0.5 + BROKEN_OFF * 2e-5, tmp_path / "run.npz")
    simulate(model, **settings, checkpoint=tmp_path / "run.npz", checkpoint_every=EVERY, progress=stop)
    resumed = resume(model, stop.copy)
    assert_same(resumed, whole)
    assert np.array_equal(resumed.parameters, whole.parameters)


@pytest.fixture(scope="module")
def checkpoint(tmp_path_factory: pytest.TempPathFactory, built_in: Load) -> Path:
    path = tmp_path_factory.mktemp("checkpoint") / "run.npz"
    broken_off(built_in("slider_crank"), settings_of("slider_crank", "single_rate", "interpreted"), path)
    return path


def test_checkpoint_of_another_model_is_refused(built_in: Load, checkpoint: Path, tmp_path: Path) -> None:
    with pytest.raises(ModelError, match="belongs to model slider_crank"):
        resume(built_in("four_bar"), checkpoint)
    changed = SCENES["slider_crank"]().model_copy(update={"title": "Another"})
    with pytest.raises(ModelError, match="generated anew"):
        resume(load_model(generate(changed, tmp_path / "model")), checkpoint)


def test_a_state_of_another_length_is_refused(built_in: Load, checkpoint: Path, tmp_path: Path) -> None:
    kept, path = read_checkpoint(checkpoint), tmp_path / "short.npz"
    replace(kept, z=kept.z[:-1]).write(path)
    with pytest.raises(
        ModelError, match=f"{len(kept.z) - 1} numbers, where .* single_rate prepared here have {len(kept.z)}"
    ):
        resume(built_in("slider_crank"), path)


def test_damaged_checkpoints_are_refused(built_in: Load, checkpoint: Path, tmp_path: Path) -> None:
    """Cut short, or with one byte changed: never a traceback of another kind, never a silent wrong run."""
    model, good = built_in("slider_crank"), checkpoint.read_bytes()
    whole = resume(model, checkpoint, checkpoint=tmp_path / "further.npz")
    rng = np.random.default_rng(3)
    path = tmp_path / "damaged.npz"
    refused = 0
    for position in [0, 10, len(good) // 2, len(good) - 1, *rng.integers(0, len(good), 40)]:
        for damaged in (good[:position], good[:position] + bytes([good[position] ^ 0x5A]) + good[position + 1 :]):
            path.write_bytes(damaged)
            try:
                assert_same(resume(model, path), whole)  # a byte that nothing depends on (a date in the archive)
            except ModelError as error:
                refused += 1
                assert str(path) in str(error)
    assert refused > 60
    with pytest.raises(ModelError, match="whole checkpoint"):
        resume(model, tmp_path / "none.npz")


@pytest.mark.parametrize(
    "key, value",
    [
        ("steps", 1e300),
        ("options", None),
        ("digest", 3),
        ("scheme", ["rk4"]),
        ("guard", None),
        ("scene_toml", "import os"),
        ("z", 1.0),
        ("p", 2.0),
    ],
)
def test_edited_checkpoints_are_refused(built_in: Load, checkpoint: Path, tmp_path: Path, key: str, value: Any) -> None:
    """Also those that are whole archives: a run goes on with what it wrote itself, and with nothing else."""
    with np.load(checkpoint) as stored:
        arrays = dict(stored)
    header = json.loads(str(arrays["header"]))
    for own in (header, header["plan"]):
        if key in own:
            own[key] = value
    if key in header or key in header["plan"]:
        arrays["header"] = np.array(json.dumps(header))
    else:
        arrays[key] = arrays[key] + value
    path = tmp_path / "edited.npz"
    np.savez(path, **arrays)
    with pytest.raises(ModelError, match="was edited since it was written"):
        resume(built_in("slider_crank"), path)


def test_wrong_words_about_checkpoints(built_in: Load, tmp_path: Path) -> None:
    for wrong in (
        {"checkpoint_every": 5},
        {"checkpoint": tmp_path / "a.npz", "checkpoint_every": 0},
        {"checkpoint": tmp_path / "a.npz", "checkpoint_every": 2.5},
    ):
        with pytest.raises((ArgumentError, SchemeError), match="checkpoint_every"):
            simulate(built_in("pendulum"), **wrong)  # type: ignore[arg-type]


def _streamed(built_in: Load, tmp_path: Path) -> tuple[Model, Path, Path]:
    """(model, checkpoint of a run that was broken off, its stream)."""
    model, settings = built_in("hub_beam"), settings_of("hub_beam", "printed", "interpreted")
    stop = broken_off(model, settings, tmp_path / "run.npz", stream=tmp_path / "rows")
    return model, Path(stop.copy), tmp_path / "rows"


def _contents(folder: Path) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in sorted(folder.iterdir())}


def _naming(checkpoint: Path, **header: Any) -> Path:
    """As somebody would who wants another folder to be written to: a checkpoint whose hash fits."""
    kept = read_checkpoint(checkpoint)
    Checkpoint({**kept.header, **header}, kept.z, kept.p, kept.arrays).write(checkpoint)
    return checkpoint


def test_a_checkpoint_leads_to_no_folder_but_its_streams(built_in: Load, tmp_path: Path) -> None:
    """Somebody's files, and the stream of another run, stay as they are; of no run at all, too."""
    model, checkpoint, _ = _streamed(built_in, tmp_path)
    files, other, empty = tmp_path / "files", tmp_path / "other", tmp_path / "empty"
    for folder in (files, empty):
        folder.mkdir()
    (files / "samples.bin").write_bytes(bytes(300_000))
    (files / "header.json").write_text('{"mine": 1}')
    simulate(model, **settings_of("hub_beam", "printed", "interpreted"), stream=other)
    own = read_checkpoint(checkpoint).header["stream_run"]
    for folder in (files, other, empty):
        before = _contents(folder)
        for run in ("", own):
            with pytest.raises(ModelError, match="stream=|leave stream out"):
                resume(model, _naming(checkpoint, stream=str(folder), stream_run=run))
            assert _contents(folder) == before


def test_a_stream_that_was_moved_is_named(built_in: Load, tmp_path: Path) -> None:
    model, checkpoint, rows = _streamed(built_in, tmp_path)
    rows.rename(tmp_path / "moved")
    with pytest.raises(ModelError, match="stream="):
        resume(model, checkpoint)
    assert not rows.exists()
    assert resume(model, checkpoint, stream=tmp_path / "moved").status.ok


def test_samples_behind_a_link_are_not_cut(built_in: Load, tmp_path: Path) -> None:
    model, checkpoint, rows = _streamed(built_in, tmp_path)
    mine = tmp_path / "mine"
    mine.write_bytes(bytes(300_000))
    (rows / "samples.bin").unlink()
    (rows / "samples.bin").symlink_to(mine)
    with pytest.raises(OutputError):
        resume(model, checkpoint)
    with pytest.raises(OutputError):
        simulate(model, **settings_of("hub_beam", "printed", "interpreted"), stream=rows)
    assert mine.read_bytes() == bytes(300_000)
