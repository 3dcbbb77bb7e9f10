"""Time and memory from a scene to kernels, files, a loaded model and native code; each case in fresh processes."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

from benchmarks.harness.result import Line, Result

ROOT = Path(__file__).resolve().parents[2]
REPEATS = {"slider_crank": 5, "chain_20_stepping": 3, "chain_20": 3, "chain_50": 1}
SMALLEST = {"REPEATS": {"slider_crank": 1}}


def run() -> Result:
    """Minimum of the repeats for every phase, in CPU seconds of the process and its compiler."""
    found = {case: _least([_probe(case) for _ in range(repeats)]) for case, repeats in REPEATS.items()}
    lines: list[Line] = []
    for case, make in LINES.items():
        if case in found:
            lines += make(found[case])
    for case in REPEATS:
        found[case]["hottest"] = _probe(case, "--profile")["hottest"]
    return Result("generation", "Generation, loading and compilation", lines, found)


def _slider_crank(found: dict) -> list[Line]:
    return [
        *_generate("slider-crank, all functions", found, 0.5),
        Line("slider-crank, compile its step", found["compile"], "s", 1.2, "empty cache"),
        Line("imports of the generator", found["imports"], "s", None, "not in the times above"),
    ]


def _long_chain(found: dict) -> list[Line]:
    operations = f"{found['operations']['condensed']} operations, empty cache"
    return [
        *_generate("chain, 50 links with 2 modes, M_hat and Q_hat", found, 8.0),
        Line("chain, 50 links, load and build M_hat and Q_hat", found["load"], "s", 3.0),
        Line("chain, 50 links, compile M_hat and Q_hat", found["compile"], "s", 20.0, operations),
        Line("chain, 50 links, memory of the compiler", found["compiler_mb"], "MB", 1024.0),
    ]


def _generate(name: str, found: dict, goal: float) -> list[Line]:
    total = sum(found[phase] for phase in ("scene", "derive", "emit", "write"))
    return [
        Line(
            f"{name}: scene to files",
            total,
            "s",
            goal,
            f"derive {found['derive']:.2f}, emit and write {found['emit'] + found['write']:.2f}",
        )
    ]


LINES: dict[str, Callable[[dict], list[Line]]] = {
    "slider_crank": _slider_crank,
    "chain_20_stepping": lambda found: _generate("chain, 20 links with 2 modes, functions of a step", found, 2.0),
    "chain_20": lambda found: _generate("chain, 20 links with 2 modes, all functions", found, 2.0),
    "chain_50": _long_chain,
}


def _probe(*arguments: str) -> dict:
    result = subprocess.run(
        [sys.executable, "-m", "benchmarks.harness.probe", *arguments], cwd=ROOT, capture_output=True, text=True
    )
    if result.returncode != 0:
        raise RuntimeError(f"benchmarks.harness.probe {' '.join(arguments)} failed:\n{result.stderr}")
    return json.loads(result.stdout)


def _least(runs: list[dict]) -> dict:
    return {key: min(run[key] for run in runs) if isinstance(value, float) else value for key, value in runs[0].items()}
