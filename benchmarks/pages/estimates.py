"""Estimated against true errors: `python -m benchmarks.pages.estimates [--of trees] [--count 200] [--first 0]`.

Random trees, random closed loops (tests/support/random_mechanisms.py) or the cases of the hard suite, the first part of
their motion, are run by three schemes with two steps each, and
compared with DOP853 at 1e-11: of every coordinate the largest error on the way, and the error at the end of the run
that the run itself says (`stats["estimated_error.<coordinate>"]`).
"""

from __future__ import annotations

import argparse
import json
import sys
import tempfile
from collections.abc import Iterator
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import numpy as np
from hypothesis import HealthCheck, Phase, given, seed, settings

from runtime import SymgenError, load_model, reference_solution, simulate
from runtime.contract.model import Model
from runtime.operating.mode_solver import modes_at
from runtime.results.amplitudes import floored
from symgen.generate import generate
from symgen.scene import Scene
from symgen.scenes.hard_suite import HARD_SUITE
from tests.support.random_mechanisms import four_bars, trees

SCHEMES = ("single_rate", "rk4", "exponential")
RADIANS = (0.2, 0.8)  # of the fastest motion a step
STEPS = 200
ROUNDING = 1e-11  # m or rad: errors below this are not estimated
WITHIN, LARGE = 10.0, 0.1


@dataclass(frozen=True)
class Judged:
    """A run: mechanism, settings, status; true and estimated errors of its coordinates, and their amplitudes."""

    mechanism: str
    scheme: str
    radians: float
    status: str
    said: bool
    true: list[float]
    estimated: list[float]
    amplitudes: list[float]

    @property
    def shown(self) -> np.ndarray:
        """Which errors are above rounding."""
        return np.array(self.true) > ROUNDING

    @property
    def ratios(self) -> np.ndarray:
        """Estimated over true errors of those."""
        return np.array(self.estimated)[self.shown] / np.array(self.true)[self.shown]

    @property
    def off(self) -> float:
        """The largest true error relative to its amplitude."""
        return float((np.array(self.true) / np.array(self.amplitudes))[self.shown].max(initial=0.0))

    @property
    def silent(self) -> bool:
        """Off by more than LARGE of an amplitude, completed, and no word of it?"""
        return self.status == "completed" and self.off > LARGE and not self.said


@dataclass(frozen=True)
class Mechanism:
    """A scene, and how it starts: arguments of `simulate`."""

    name: str
    scene: Scene
    start: dict[str, Any]


def mechanisms(of: str, count: int, number: int) -> list[Mechanism]:
    """So many random scenes, the same for the same number; or the hard suite."""
    if of == "hard":
        return [
            Mechanism(name, case.make(), {"parameters": case.parameters, "initial": case.initial, "start": case.start})
            for name, case in list(HARD_SUITE.items())[:count]
        ]
    found: list[Scene] = []

    @seed(number)
    @settings(
        max_examples=count,
        database=None,
        deadline=None,
        phases=[Phase.generate],
        suppress_health_check=list(HealthCheck),
    )
    @given({"trees": trees, "loops": four_bars}[of]())
    def collect(scene: Scene) -> None:
        found.append(scene)

    collect()
    return [Mechanism(f"{of} {k}", scene, {}) for k, scene in enumerate(found[:count])]


def judged(one: Mechanism) -> Iterator[Judged]:
    """All runs of a mechanism."""
    with tempfile.TemporaryDirectory() as folder:
        model = load_model(generate(one.scene, Path(folder) / "model"))
        first = simulate(model, scheme="rk4", dt=1e-9, t_end=1e-9, force=True, engine="interpreted", **one.start)
        modes = modes_at(first, [0])[0]
        rate = max(5.0, float(modes.undamped[-1]), modes.fastest_decay, float(np.abs(first.q_dot[0]).max()))
        for radians in RADIANS:
            times = np.arange(0, STEPS + 1, 10) * (radians / rate)
            if model.loop_unknowns and not _regular(model, one, 0.2 / rate, float(times[-1])):
                print(f"{one.name}: through a singular position in {times[-1]:.3g} s: left out", file=sys.stderr)
                continue
            try:
                exact = reference_solution(model, t_end=float(times[-1]), times=times, **one.start)
            except SymgenError as error:
                print(f"{one.name}: no reference at {radians} rad a step: {error}", file=sys.stderr)
                continue
            for scheme in SCHEMES:
                yield _run(model, one, scheme, radians, radians / rate, exact.q_i)


def _regular(model: Model, one: Mechanism, dt: float, t_end: float) -> bool:
    """Does a loop keep away from singular positions? There the reference shrinks its steps for ever."""
    trial = simulate(model, scheme="rk4", dt=dt, t_end=t_end, engine="interpreted", **one.start)
    return trial.status.ok and not trial.events


def _run(model: Model, one: Mechanism, scheme: str, radians: float, dt: float, exact: np.ndarray) -> Judged:
    run = simulate(model, scheme=scheme, dt=dt, t_end=STEPS * dt, save_every=10, engine="interpreted", **one.start)
    rows = min(len(run.t), len(exact))
    true = np.abs(run.q_i[:rows] - exact[:rows]).max(axis=0) if run.model is model else np.zeros(0)
    names = model.q_i if len(true) else []
    estimated = [float(run.stats.get(f"estimated_error.{name}", 0.0)) for name in names]
    amplitudes = floored(model, np.ptp(exact, axis=0) / 2)[: len(true)]
    said = "remark" in run.stats or bool(run.events)
    return Judged(one.name, scheme, radians, run.status.name, said, true.tolist(), estimated, amplitudes.tolist())


def table(found: list[Judged]) -> list[str]:
    """Rows of the page, by scheme and step."""
    rows = [
        "| scheme | rad a step | runs | completed | within a factor 10 | completed, off by > 10 % | of these silent |",
        "|---|---:|---:|---:|---:|---:|---:|",
    ]
    for scheme in SCHEMES:
        for radians in RADIANS:
            part = [one for one in found if (one.scheme, one.radians) == (scheme, radians)]
            done = [one for one in part if one.status == "completed"]
            ratios = np.concatenate([np.zeros(0), *(one.ratios for one in done)])
            near = np.mean((ratios < WITHIN) & (ratios > 1 / WITHIN)) if len(ratios) else 1.0
            large, silent = sum(one.off > LARGE for one in done), sum(one.silent for one in done)
            rows.append(
                f"| {scheme} | {radians} | {len(part)} | {len(done)} | {100 * near:.1f} % of {len(ratios)} "
                f"| {large} | {silent} |"
            )
    return rows


def main(arguments: list[str] | None = None) -> int:
    """Judge, print the table and the silent runs."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.pages.estimates", description=__doc__)
    parser.add_argument("--of", choices=("trees", "loops", "hard"), default="trees")
    parser.add_argument("--first", type=int, default=0, help="how many to leave out")
    parser.add_argument("--count", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--json", type=Path, default=None, help="every run")
    options = parser.parse_args(arguments)
    found: list[Judged] = []
    for mechanism in mechanisms(options.of, options.first + options.count, options.seed)[options.first :]:
        for one in judged(mechanism):
            found.append(one)
            if options.of == "hard":
                print(one.mechanism, one.scheme, one.radians, one.status, f"off {one.off:.2g}", one.said, flush=True)
            if one.silent:
                print(f"silent: {one.mechanism}, {one.scheme}, {one.radians} rad a step, off {one.off:.2g}", flush=True)
    print("\n".join(table(found)))
    if options.json is not None:
        options.json.write_text(json.dumps([asdict(one) for one in found], indent=1) + "\n", encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
