"""Native code by LLVM: time to the first step, time of a step in both tiers, gcc beside it where it is not too slow."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

from benchmarks.harness.result import Line, Result

ROOT = Path(__file__).resolve().parents[2]
# (built-in scene, arguments, scheme, ratios, goal for the first step [s], with gcc)
CASES: tuple[tuple[str, dict[str, int], str, list[int], float, bool], ...] = (
    ("flexible_slider_crank_free", {}, "exponential", [2], 0.06, True),
    ("flexible_slider_crank_free", {}, "single_rate", [], 0.06, True),
    ("flexible_slider_crank_free", {}, "printed", [4], 0.06, True),
    ("bricard", {}, "radau", [], 1.0, True),
    ("spatial_slider_crank", {}, "exponential", [4], 1.0, True),
    ("spatial_slider_crank", {}, "radau", [], 6.0, False),
)
MOST_MB = 400.0
SMALLEST = {"CASES": CASES[1:2]}


def run() -> Result:
    """Each case in a process of its own, with an empty cache."""
    lines, details = [], {}
    for scene, made_with, scheme, m, goal, with_gcc in CASES:
        word = json.dumps([scene, made_with, scheme, m, with_gcc])
        command = [sys.executable, "-m", "benchmarks.harness.native_probe", word]
        result = subprocess.run(command, cwd=ROOT, capture_output=True, text=True)
        if result.returncode != 0:
            raise RuntimeError(f"benchmarks.harness.native_probe failed:\n{result.stderr}")
        found = json.loads(result.stdout)
        name = f"{scene} {scheme}, {found['operations']} operations"
        details[name] = found
        lines += [
            Line(f"{name}: first step after set-up", found["first_step"], "s", goal, "CPU, empty cache"),
            Line(f"{name}: memory of the first code", found["first_mb"], "MB", MOST_MB),
            Line(f"{name}: a step, first code", found["first"] * 1e6, "us"),
            Line(f"{name}: a step, best code", found["best"] * 1e6, "us", None, f"made in {found['best_build']:.2f} s"),
        ]
        if with_gcc:
            note = f"gcc: {found['gcc'] * 1e6:.3g} us, compiled in {found['gcc_build']:.2f} s"
            lines.append(Line(f"{name}: best code / gcc's", found["ratio"], "", 1.0, note))
    return Result("native_code", "Native code without a compiler", lines, details)
