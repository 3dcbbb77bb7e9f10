"""The loggers below `symgen`: silent unless asked, then what was read, compiled and refined, and what happened."""

from __future__ import annotations

import logging
import subprocess
import sys
from pathlib import Path

import pytest

from runtime import load_model
from symgen import Scene
from symgen.scenes import generated_folder


def lines(caplog: pytest.LogCaptureFixture, part: str) -> list[tuple[int, str]]:
    """(level, message) of one of the loggers."""
    return [(one.levelno, one.getMessage()) for one in caplog.records if one.name == f"symgen.{part}"]


def test_levels_of_a_tolerance_and_the_end_are_logged(caplog: pytest.LogCaptureFixture) -> None:
    caplog.set_level(logging.DEBUG, "symgen")
    run = load_model(generated_folder("pendulum")).simulate(t_end=0.5, scheme="rk4", tolerance=1e-8)
    levels = lines(caplog, "refinement")
    assert len(levels) == run.stats["rungs"] >= 2 and all("pendulum: rk4, " in text for _, text in levels)
    steps = [int(text.split(", ")[1].split()[0]) for _, text in levels]
    assert steps == sorted(set(steps)) and steps[-1] == run.stats["steps"]
    ((level, text),) = lines(caplog, "run")
    assert level == logging.INFO and text.startswith("pendulum: completed at t = 0.5 s; rk4")


def test_events_are_logged_and_a_failure_is_a_warning(caplog: pytest.LogCaptureFixture) -> None:
    caplog.set_level(logging.DEBUG, "symgen")
    scene = (
        Scene("ball")
        .gravity(0, -9.81)
        .rigid("ball", mass=1.0, inertia=1.0, free=True)
        .measure("height", "y", of="ball.origin")
        .event("low", when="height + 1", terminal=True)
    )
    run = scene.model().simulate(t_end=1.0)
    ((_, text),) = lines(caplog, "events")
    assert text == f"ball: {run.events[0]}" and "low" in text
    caplog.clear()
    load_model(generated_folder("flexible_slider_crank")).simulate(scheme="rk4", dt=5e-4, t_end=0.05, force=True)
    ((level, text),) = lines(caplog, "run")
    assert level == logging.WARNING and "at t = " in text


def test_programs_are_compiled_once_then_read(
    caplog: pytest.LogCaptureFixture, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("SYMGEN_CACHE", str(tmp_path / "cache"))
    caplog.set_level(logging.DEBUG, "symgen")
    for _ in range(2):
        load_model(generated_folder("pendulum")).simulate(t_end=0.01, scheme="rk4", dt=1e-3)
    compiled, read = lines(caplog, "compile"), [text for _, text in lines(caplog, "cache") if text.endswith(": read")]
    assert compiled and all("compiled in" in text for _, text in compiled)
    assert {text.split(":")[0] for text in read} & {text.split(":")[0] for _, text in compiled}


def test_a_cache_that_is_refused_is_a_warning(
    caplog: pytest.LogCaptureFixture, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "file").write_text("no folder")
    monkeypatch.setenv("SYMGEN_CACHE", str(tmp_path / "file"))
    Scene("alone").rigid("a", mass=1.0, inertia=1.0).revolute("pin", "ground.origin", "a.origin").model()
    assert (logging.WARNING, "the cache is not used") in [(level, text[:21]) for level, text in lines(caplog, "cache")]


def test_nothing_is_written_unless_a_program_asks() -> None:
    """A run that fails would be a warning on standard error, were the logger left to Python's last resort."""
    program = (
        "from runtime import load_model\nfrom symgen.scenes import generated_folder\n"
        "model = load_model(generated_folder('flexible_slider_crank'))\n"
        "run = model.simulate(scheme='rk4', dt=5e-4, t_end=0.05, force=True)\nassert not run.status.ok"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
