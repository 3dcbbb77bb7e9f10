"""One major step of the flexible slider-crank: native code against gcc's, hand-written C and slower engines."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from statistics import median

from benchmarks.cases.hand_comparison import AGREEMENT_STEPS
from benchmarks.cases.scenes import RATIO, general_rod
from benchmarks.cases.step_case import AGREEMENT, Case, counts, difference, make_case, worker
from benchmarks.contenders.python_stepper import PythonStepper
from benchmarks.harness.models import workplace
from benchmarks.harness.result import Line, Result
from benchmarks.harness.timing import Timing, interleave, ratio
from runtime.engine.interpreted import InterpretedProgram
from runtime.engine.native import Engine, NativeProgram

ROOT = Path(__file__).resolve().parents[2]
PROCESSES, LOOP_STEPS = 7, 20
ROUNDS, SLOW_ROUNDS = 100, 20
VM_BATCH = 64
REFERENCE_US = 0.83  # hand-written C on the machine for which the goal was set
SMALLEST = {"PROCESSES": 1, "ROUNDS": 2, "SLOW_ROUNDS": 2}


def run() -> Result:
    """Two pinned modes against hand-written C; four general modes against the virtual machine and a Python loop."""
    runs = [_compared_with_hand() for _ in range(PROCESSES)]
    with workplace() as folder:
        lines, general = _general(make_case(general_rod(), folder))
    return Result(
        "step_slider_crank",
        f"One major step of the flexible slider-crank, m = {RATIO}",
        _hand_lines(runs) + lines,
        {"two pinned modes": runs, "four general modes": general},
    )


def _compared_with_hand() -> dict:
    """One process, in which all take turns: speeds differ between processes by tens of per cent, for all of them alike.

    Branch prediction in the library's sine is one reason, who else works on the processor's core another.
    """
    command = [sys.executable, "-m", "benchmarks.cases.hand_comparison"]
    result = subprocess.run(command, cwd=ROOT, capture_output=True, text=True)
    if result.returncode != 0:
        raise RuntimeError(f"benchmarks.cases.hand_comparison failed:\n{result.stderr}")
    return json.loads(result.stdout)


def _hand_lines(runs: list[dict]) -> list[Line]:
    generated, by_gcc, hand = (min(run[name] for run in runs) for name in ("generated", "by gcc", "hand"))
    ratios, to_gcc = (sorted(run[name] for run in runs) for name in ("ratio", "ratio to gcc"))
    note = f"best of {PROCESSES} processes"
    return [
        Line("two pinned modes, native code", generated * 1e9, "ns", None, note),
        Line("two pinned modes, generated C by gcc", by_gcc * 1e9, "ns", None, note),
        Line("two pinned modes, hand-written C", hand * 1e9, "ns", None, note),
        Line(
            "native / generated C by gcc",
            median(to_gcc),
            "",
            0.9,
            f"median of the processes: {to_gcc[0]:.2f} to {to_gcc[-1]:.2f}",
        ),
        Line(
            "native / hand-written",
            median(ratios),
            "",
            1.0,
            f"median of the processes: {ratios[0]:.2f} to {ratios[-1]:.2f}",
        ),
        Line(
            "native, where hand-written C takes 0.83 us",
            REFERENCE_US * median(ratios),
            "us",
            0.8,
            "the ratio times 0.83 us",
        ),
        Line(
            f"largest relative difference after {AGREEMENT_STEPS} major steps",
            max(run["difference"] for run in runs),
            "",
            AGREEMENT,
        ),
    ]


def _general(case: Case) -> tuple[list[Line], dict]:
    layout = case.scheme.layout
    compiled, machine = (
        NativeProgram(case.program, wait=True),
        InterpretedProgram(case.program, layout.size, len(case.ready)),
    )
    loop = PythonStepper(case.model, case.scheme, case.c)
    error = _loop_difference(case, compiled, loop)
    timings = interleave({"compiled": worker(case, compiled), "machine": _batched(case, machine)}, ROUNDS)
    slow = interleave(
        {"compiled": worker(case, compiled), "python": lambda n: loop.restart(case.start).run(n)}, SLOW_ROUNDS
    )
    machine_ratio = ratio(timings["machine"], timings["compiled"])
    loop_ratio = ratio(slow["python"], slow["compiled"])
    name = "four general modes"
    lines = [
        _time(f"{name}, native code", timings["compiled"]),
        Line(
            f"{name}, CasADi virtual machine",
            timings["machine"].best * 1e9,
            "ns",
            None,
            f"{machine_ratio[0]:.1f} times native code; quartiles {machine_ratio[1]:.1f} to {machine_ratio[2]:.1f}",
        ),
        Line(
            f"{name}, Python loop over Functions",
            slow["python"].best * 1e9,
            "ns",
            None,
            f"{loop_ratio[0]:.0f} times native code; quartiles {loop_ratio[1]:.0f} to {loop_ratio[2]:.0f}",
        ),
    ]
    return lines, {**counts(case), "difference of the Python loop": error}


def _batched(case: Case, runner: InterpretedProgram) -> Callable[[int], None]:
    """The virtual machine builds one Function a batch length: batches of one length, n counts major steps."""
    z = case.start.copy()

    def work(n: int) -> None:
        z[:] = case.start
        for _ in range(n // VM_BATCH):
            runner.run(z, case.ready, VM_BATCH)
        for _ in range(n % VM_BATCH):
            runner.run(z, case.ready, 1)

    return work


def _loop_difference(case: Case, compiled: Engine, loop: PythonStepper) -> float:
    z = case.start.copy()
    compiled.run(z, case.ready, LOOP_STEPS)
    loop.restart(case.start).run(LOOP_STEPS)
    return difference(loop.x, z[case.scheme.layout.slice("x")], "the Python loop and native code")


def _time(name: str, timing: Timing) -> Line:
    return Line(name, timing.best * 1e9, "ns", None, f"median +{timing.spread:.0%}")
