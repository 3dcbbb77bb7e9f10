"""Samples that do not stay in memory: streams, chosen outputs, and what a crash leaves of them."""

from __future__ import annotations

import json
import tracemalloc
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from runtime import ModelError, Solution, simulate
from runtime.model import Model
from runtime.results.stream import read_blocks

Load = Callable[[str], Model]
SETTINGS = {"scheme": "single_rate", "dt": 2e-5, "t_end": 0.02, "seen_every": 6e-05, "engine": "interpreted"}
OUTPUTS = ["crank.theta", "crank.theta_dot", "slider.x_ddot", "kinetic", "energy.potential", "lam.C.x"]


def test_streamed_run_reads_back_as_the_run_in_memory(built_in: Load, tmp_path: Path) -> None:
    model = built_in("slider_crank")
    whole = simulate(model, **SETTINGS)  # type: ignore[arg-type]
    ends = simulate(model, **SETTINGS, stream=tmp_path / "run")  # type: ignore[arg-type]
    back = Solution.load(tmp_path / "run", model)
    assert len(whole.t) == 335 and len(ends.t) == 2
    for name in ("t", "q", "q_dot", "q_ddot", "q_i", "lam", "joint_forces", "constraint_error", "parameters"):
        assert np.array_equal(getattr(back, name), getattr(whole, name)), name
    assert np.array_equal(back.total_energy, whole.total_energy)
    assert back.status == whole.status and back.stats["steps"] == 1000
    assert np.array_equal(ends.q, whole.q[[0, -1]])


def test_outputs_are_the_columns_of_the_whole_run(built_in: Load, tmp_path: Path) -> None:
    model = built_in("slider_crank")
    whole = simulate(model, **SETTINGS)  # type: ignore[arg-type]
    kept = simulate(model, **SETTINGS, outputs=OUTPUTS)  # type: ignore[arg-type]
    expected = {
        "t": whole.t,
        "crank.theta": whole["crank.theta"],
        "crank.theta_dot": whole.rate("crank.theta"),
        "slider.x_ddot": whole.acceleration("slider.x"),
        "kinetic": whole.energy["kinetic"],
        "energy.potential": whole.energy["potential"],
        "lam.C.x": whole.multiplier("C.x"),
    }
    assert list(kept.outputs) == list(expected)
    for name, values in expected.items():
        assert np.array_equal(kept.outputs[name], values), name
    assert len(kept.t) == 2
    kept.save(tmp_path / "kept.npz")
    assert np.array_equal(Solution.load(tmp_path / "kept.npz").outputs["kinetic"], whole.energy["kinetic"])
    simulate(model, **SETTINGS, outputs=OUTPUTS, stream=tmp_path / "run")  # type: ignore[arg-type]
    blocks = list(read_blocks(tmp_path / "run", rows=100))
    assert [len(block["t"]) for block in blocks] == [100, 100, 100, 35]
    for name, values in expected.items():
        assert np.array_equal(np.concatenate([block[name] for block in blocks]), values), name
    with pytest.raises(ModelError, match="read_blocks"):
        Solution.load(tmp_path / "run")


def test_unknown_output_is_refused(built_in: Load) -> None:
    with pytest.raises(ModelError, match="no output 'crank.phi'.*crank.theta"):
        simulate(built_in("slider_crank"), **SETTINGS, outputs=["crank.phi"])  # type: ignore[arg-type]


# a crash closes no file: that is left to Python, which says so
@pytest.mark.filterwarnings("ignore::pytest.PytestUnraisableExceptionWarning")
def test_what_a_crash_leaves_is_readable(built_in: Load, tmp_path: Path) -> None:
    """The header is written before the run; a last row that is not complete is left out."""
    model, settings = built_in("slider_crank"), {**SETTINGS, "seen_every": 2e-5}

    def crash(t: float, t_end: float) -> None:
        if t > 0.009:
            raise MemoryError("crash")

    with pytest.raises(MemoryError):
        simulate(model, **settings, stream=tmp_path / "run", progress=crash)  # type: ignore[arg-type]
    rows = tmp_path / "run" / "samples.bin"
    rows.write_bytes(rows.read_bytes() + b"half a row")
    left = Solution.load(tmp_path / "run", model)
    whole = simulate(model, **settings)  # type: ignore[arg-type]
    assert 200 < len(left.t) < 1001 and left.status.name == "interrupted"
    assert np.array_equal(left.q, whole.q[: len(left.t)])


def test_failed_run_ends_its_stream_with_the_last_good_state(built_in: Load, tmp_path: Path) -> None:
    model = built_in("two_oscillators")
    settings = {"parameters": {"zeta": 0.0}, "scheme": "printed", "m": [4], "t_end": 200.0, "seen_every": 0.07}
    whole = simulate(model, **settings)  # type: ignore[arg-type]
    simulate(model, **settings, stream=tmp_path / "run")  # type: ignore[arg-type]
    back = Solution.load(tmp_path / "run", model)
    assert back.status.name == whole.status.name == "diverged"
    assert back.t[-1] == back.status.time and np.isfinite(back.q).all()
    assert np.all(np.diff(back.t) > 0)


@pytest.mark.every_push("stream")
@pytest.mark.parametrize("kept", ["stream", "outputs"])
def test_memory_stays_bounded(built_in: Load, tmp_path: Path, kept: str) -> None:
    """Four times the samples do not take more memory than a few blocks of them."""
    model = built_in("slider_crank")
    more = {"stream": tmp_path / "run"} if kept == "stream" else {"outputs": ["crank.theta"]}

    def run(steps: int, engine: str) -> None:
        asked = {"scheme": "single_rate", "dt": 2e-5, "t_end": steps * 2e-5, "seen_every": 0.0, "engine": engine}
        simulate(model, **asked, **more)  # type: ignore[arg-type]

    def peak(steps: int) -> int:
        tracemalloc.start()
        run(steps, "interpreted")
        found = tracemalloc.get_traced_memory()[1]
        tracemalloc.stop()
        return found

    run(4800, "auto")  # so many points are evaluated by native code, which takes memory when it is made
    few, many = peak(1200), peak(4800)
    row = 8 * 2 if kept == "outputs" else 0
    assert many - few < 3600 * row * 3 + 300_000


@pytest.mark.parametrize(
    "damage",
    [
        {"columns": None},
        {"columns": [["t", [-1]]]},
        {"columns": [["t", [10**12]], ["q", [10**12]]]},
        {"columns": []},
        {"columns": [["t"]]},
        {"columns": [["t", []]]},
        {"model": {}},
        {"status": {"name": 1, "more": 2}},
        {"parameters": "x"},
    ],
    ids=str,
)
def test_a_damaged_header_is_refused(built_in: Load, tmp_path: Path, damage: dict[str, object]) -> None:
    """By name, and before memory is asked for that there is not."""
    simulate(built_in("slider_crank"), **SETTINGS, stream=tmp_path / "run")  # type: ignore[arg-type]
    file = tmp_path / "run" / "header.json"
    file.write_text(json.dumps({**json.loads(file.read_text()), **damage}))
    with pytest.raises(ModelError, match="header is damaged"):
        Solution.load(tmp_path / "run")
