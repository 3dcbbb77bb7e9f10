"""A step of exported C over one of our own native code, and how long its text is."""

from __future__ import annotations

import ctypes
import shlex
import subprocess
import tempfile
from pathlib import Path

import numpy as np

from benchmarks.harness.result import Line, Result, Skipped
from benchmarks.harness.timing import interleave, ratio
from runtime import load_model
from runtime.engine.c_source import Style, find_compiler, program_code
from runtime.engine.program import operations_per_step
from runtime.export.c_bundle import exported, write_c
from runtime.model import Model
from symgen.scenes import generated_folder

CASES = (
    ("flexible_slider_crank_free", "exponential"),
    ("double_pendulum", "rk4"),
    ("bricard", "rk4"),
    ("heavy_top", "rk4"),
    ("chain", "rk4"),
)
FLAGS = ("-std=c99", "-O3", "-march=native", "-shared", "-fPIC")
GOAL, MOST_BYTES, ROUNDS = 1.3, 20.0, 60
SMALLEST = {"CASES": CASES[1:2], "ROUNDS": 2}


def run() -> Result:
    """Each case by the machine's compiler. Raises Skipped where there is none."""
    compiler = find_compiler()
    if compiler is None:
        raise Skipped("no C compiler")
    lines = []
    for scene, scheme in CASES:
        with tempfile.TemporaryDirectory() as folder:
            found, size = _measured(load_model(generated_folder(scene)), scheme, Path(folder), shlex.split(compiler))
        name = f"{scene} {scheme}"
        note = f"quartiles {found[1]:.2f} and {found[2]:.2f}"
        lines.append(Line(f"{name}: a step in exported C / native code", found[0], "", GOAL, note))
        lines.append(Line(f"{name}: text of the step program", size, "bytes an operation", MOST_BYTES))
    return Result("exported_c", "Exported C", lines, {})


def _measured(model: Model, scheme: str, folder: Path, compiler: list[str]) -> tuple[tuple[float, float, float], float]:
    """(time of a step over that of native code with quartiles, bytes of the step program's text an operation)."""
    one = exported(model, scheme)
    write_c(one, folder)
    stem = one.prefix[:-1]
    subprocess.run([*compiler, *FLAGS, f"{stem}.c", "-o", "own.so", "-lm"], cwd=folder, check=True)
    step = getattr(ctypes.CDLL(str(folder / "own.so")), f"{stem}_step")
    stepper = model.stepper(scheme=scheme)
    code = program_code("step", one.prepared.program, Style(own=True))
    c, z, w = stepper._own.ready.copy(), one.z.copy(), np.zeros(code.work + 1)
    addresses = [ctypes.c_void_p(array.ctypes.data) for array in (z, c, w)]
    work = {"c": lambda n: step(*addresses, ctypes.c_long(n)), "native": lambda n: stepper.step(n)}
    times = interleave(work, ROUNDS)
    stages = sum(stage.n_instructions() for stage in one.prepared.program.stages())
    assert operations_per_step(one.prepared.program) >= stages > 0
    return ratio(times["c"], times["native"]), len(code.text) / stages
