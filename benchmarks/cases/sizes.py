"""Large scenes from scene to first step, with the functions that a run asks for and nothing in the cache."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

from benchmarks.harness.result import Line, Result

ROOT = Path(__file__).resolve().parents[2]
# (scene, arguments, scheme)
CASES: tuple[tuple[str, dict[str, int], str], ...] = (
    ("arm", {"links": 40}, "single_rate"),
    ("arm", {"links": 40}, "exponential"),
    ("chain", {"links": 100, "modes": 1}, "single_rate"),
    ("chain", {"links": 100, "modes": 2}, "single_rate"),
    ("chain", {"links": 100, "modes": 1}, "coupled"),
    ("chain", {"links": 100, "modes": 1}, "exponential_rk4"),
)
MOST_SECONDS, MOST_MB = 10.0, 1000.0
SMALLEST = {"CASES": (("chain", {"links": 2, "modes": 1}, "single_rate"),)}


def run() -> Result:
    """Each case in a process of its own, on one thread."""
    lines, details = [], {}
    for scene, made_with, scheme in CASES:
        name = f"{scene}, {', '.join(f'{what} {count}' for what, count in made_with.items())}, {scheme}"
        command = [sys.executable, "-m", "benchmarks.harness.size_probe", json.dumps([scene, made_with, scheme])]
        alone = {**os.environ, "OPENBLAS_NUM_THREADS": "1"}
        result = subprocess.run(command, cwd=ROOT, env=alone, capture_output=True, text=True)
        if result.returncode != 0:
            raise RuntimeError(f"benchmarks.harness.size_probe failed:\n{result.stderr}")
        found = details[name] = json.loads(result.stdout)
        note = f"imports included; {found['operations']} operations derived"
        lines += [
            Line(f"{name}: scene to first step", found["seconds"], "s", MOST_SECONDS, note),
            Line(f"{name}: memory", found["mb"], "MB", MOST_MB),
        ]
    load = f"The machine's load average was {os.getloadavg()[0]:.1f} on {os.cpu_count()} cores: CPU times grow with it."
    return Result("sizes", "Large scenes, from scene to first step", lines, details, load)
