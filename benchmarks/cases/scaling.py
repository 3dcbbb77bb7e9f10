"""How time and memory grow with a chain: scene to first step, memory, time of a step, ours and those of others."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

from benchmarks.contenders.long_chains import OURS, installed
from benchmarks.harness.growth import growth
from benchmarks.harness.result import Line, Result

ROOT = Path(__file__).resolve().parents[2]
SIZES = {"chain in a plane": (3, 10, 30, 100, 300, 1000), "chain in space": (3, 10, 30, 100)}
MEASURES = {"first": "scene to first step", "mb": "memory", "step": "a step"}
UNITS, FACTORS = {"first": "s", "mb": "MB", "step": "us"}, {"first": 1.0, "mb": 1.0, "step": 1e6}
GOALS = {("chain in a plane", 1000): {"first": 10.0, "mb": 300.0}, ("chain in space", 100): {"first": 5.0}}
STEP_GOAL = 0.1  # of ours over MuJoCo's, at the longest chain in a plane
SMALLEST = {"SIZES": {family: (2, 3) for family in SIZES}}
REMARK = """\
A chain of N rigid links hangs from a hinge (in space: from a spherical joint). Each cell is a process of its own, on
one thread, with an empty cache. Scene to first step: CPU time of the process until its first step is done, imports
included; memory: the peak until then; a step: the fastest of three bursts after it. All make steps of the classical
Runge-Kutta method (four evaluations), but Exudyn, which makes one implicit step (generalized-alpha, sparse, with all
constraints). Pinocchio's `aba` is called from Python, which is most of its time below N = 30. NumPy and SciPy: the full
matrix of absolute angles, solved by its Cholesky factors."""


def run() -> Result:
    """All programs that are installed."""
    lines: list[Line] = []
    details: dict[str, Any] = {}
    failed: list[str] = []
    for family, sizes in SIZES.items():
        details[family] = {name: _measured(family, name, sizes, failed) for name in installed(family)}
        lines += _lines(family, sizes, details[family])
    load = (
        f" The machine's load average was {os.getloadavg()[0]:.1f} on {os.cpu_count()} cores: CPU times grow with it."
    )
    remark = REMARK + load + "".join(f" {text}" for text in failed)
    return Result("scaling", "How time and memory grow with a chain", lines, details, remark)


def _measured(family: str, program: str, sizes: tuple[int, ...], failed: list[str]) -> dict[str, dict[str, float]]:
    """By size, until another program fails; ours may not."""
    found: dict[str, dict[str, float]] = {}
    for links in sizes:
        try:
            found[str(links)] = measured(family, program, links)
        except RuntimeError as error:
            if program == OURS:
                raise
            failed.append(f"{program} ends with an error at N = {links}: {str(error).strip().splitlines()[-1]}.")
            break
    return found


def measured(family: str, program: str, links: int) -> dict[str, float]:
    """What benchmarks/harness/chain_probe.py prints. Raises RuntimeError where the program fails."""
    print(f"  {family}, {program}, N = {links} ...", file=sys.stderr, flush=True)
    alone = {**os.environ, "OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1"}
    command = [sys.executable, "-m", "benchmarks.harness.chain_probe", json.dumps([family, program, links])]
    found = subprocess.run(command, cwd=ROOT, env=alone, capture_output=True, text=True)
    if found.returncode != 0:
        ending = f"{found.stderr}\nexit status {found.returncode}"
        raise RuntimeError(f"{program} with {links} links of the {family} failed:\n{ending}")
    values: dict[str, float] = json.loads(found.stdout.splitlines()[-1])
    return values


def _lines(family: str, sizes: tuple[int, ...], found: dict[str, Any]) -> list[Line]:
    lines = []
    for name, by_size in found.items():
        for key, what in MEASURES.items():
            known = [links for links in sizes if str(links) in by_size]
            values = [FACTORS[key] * by_size[str(links)][key] for links in known]
            if not known:
                continue
            note = f"exponent {growth(known, values)}" if len(known) > 1 else ""
            goal = GOALS.get((family, known[-1]), {}).get(key) if name == OURS else None
            lines.append(Line(f"{family} of {known[-1]}, {name}: {what}", values[-1], UNITS[key], goal, note))
    last = str(sizes[-1])
    if last in found.get("MuJoCo", {}):
        ratio = found[OURS][last]["step"] / found["MuJoCo"][last]["step"]
        goal = STEP_GOAL if (family, sizes[-1]) in GOALS and family.endswith("plane") else None
        lines.append(Line(f"{family} of {last}: a step of ours / MuJoCo's", ratio, "", goal))
    return lines
