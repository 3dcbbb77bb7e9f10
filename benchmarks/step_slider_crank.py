"""One major step of the flexible slider-crank: generated against hand-written C, and against slower engines."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from benchmarks.hand_stepper import HandStepper
from benchmarks.models import model_of, workplace
from benchmarks.python_stepper import PythonStepper
from benchmarks.result import Line, Result
from benchmarks.scenes import MAJOR_STEP, RATIO, general_rod, pinned_rod, slider_crank
from benchmarks.timing import Timing, interleave, ratio
from runtime.engine.choose import operations_per_step
from runtime.engine.compiled import CompiledProgram
from runtime.engine.interpreted import InterpretedProgram
from runtime.engine.program import Program, stages
from runtime.model import Model
from runtime.schemes.central_difference import CentralDifference
from runtime.schemes.grid import make_grid
from runtime.schemes.options import Options
from runtime.simulate import start_vector

AGREEMENT, AGREEMENT_STEPS = 1e-9, 300
ROUNDS, SLOW_ROUNDS = 150, 20
VM_BATCH = 64
REFERENCE_US = 0.83  # hand-written C on the machine for which the goal was set


@dataclass(frozen=True)
class Case:
    """A model with its scheme, step program, constants and start."""

    model: Model
    scheme: CentralDifference
    program: Program
    c: np.ndarray
    start: np.ndarray


def run() -> Result:
    """Two pinned modes against hand-written C; four general modes against the virtual machine and a Python loop."""
    with workplace() as folder:
        pinned_lines, pinned = _pinned(_case(pinned_rod(), folder))
        general_lines, general = _general(_case(general_rod(), folder))
    return Result("step_slider_crank", f"One major step of the flexible slider-crank, m = {RATIO}",
                  pinned_lines + general_lines, {"two pinned modes": pinned, "four general modes": general})


def _case(rod: dict, folder: Path) -> Case:
    model = model_of(slider_crank(rod), folder)
    scheme = CentralDifference(model, make_grid(model, MAJOR_STEP, [RATIO], False), Options())
    c = model.constants(model.parameter_vector())
    start = start_vector(model, scheme, model.initial_q, model.initial_q_dot, 0.0, c)
    return Case(model, scheme, scheme.program(), c, start)


def _pinned(case: Case) -> tuple[list[Line], dict]:
    compiled, hand = CompiledProgram(case.program), HandStepper(case.scheme.layout, MAJOR_STEP, RATIO)
    error = _hand_difference(case, compiled, hand)
    state, start = hand.state(case.start), hand.state(case.start)

    def by_hand(n: int) -> None:
        state[:] = start
        hand.run(state, n)

    timings = interleave({"generated": _worker(case, compiled), "hand": by_hand}, ROUNDS)
    quotient, lower, upper = ratio(timings["generated"], timings["hand"])
    lines = [
        _time("two pinned modes, generated C", timings["generated"]),
        _time("two pinned modes, hand-written C", timings["hand"]),
        Line("generated / hand-written", quotient, "", 1.0, f"quartiles {lower:.2f} to {upper:.2f}"),
        Line("generated, where hand-written C takes 0.83 us", REFERENCE_US * quotient, "us", 0.8,
             "the ratio times 0.83 us"),
        Line(f"largest relative difference after {AGREEMENT_STEPS} major steps", error, "", AGREEMENT),
    ]
    return lines, _counts(case)


def _general(case: Case) -> tuple[list[Line], dict]:
    layout = case.scheme.layout
    compiled, machine = CompiledProgram(case.program), InterpretedProgram(case.program, layout.size, len(case.c))
    loop = PythonStepper(case.model, case.scheme, case.c)
    difference = _loop_difference(case, compiled, loop)
    timings = interleave({"compiled": _worker(case, compiled), "machine": _batched(case, machine)}, ROUNDS)
    slow = interleave({"compiled": _worker(case, compiled), "python": lambda n: loop.restart(case.start).run(n)},
                      SLOW_ROUNDS)
    machine_ratio = ratio(timings["machine"], timings["compiled"])
    loop_ratio = ratio(slow["python"], slow["compiled"])
    name = "four general modes"
    lines = [
        _time(f"{name}, generated C", timings["compiled"]),
        Line(f"{name}, CasADi virtual machine", timings["machine"].best * 1e9, "ns", None,
             f"{machine_ratio[0]:.1f} times generated C; quartiles {machine_ratio[1]:.1f} to {machine_ratio[2]:.1f}"),
        Line(f"{name}, Python loop over Functions", slow["python"].best * 1e9, "ns", None,
             f"{loop_ratio[0]:.0f} times generated C; quartiles {loop_ratio[1]:.0f} to {loop_ratio[2]:.0f}"),
    ]
    return lines, {**_counts(case), "difference of the Python loop": difference}


def _counts(case: Case) -> dict:
    return {"operations per major step": operations_per_step(case.program),
            "stages": {stage.name(): stage.n_instructions() for stage in stages(case.program)}}


def _worker(case: Case, runner: CompiledProgram) -> Callable[[int], None]:
    z = case.start.copy()

    def work(n: int) -> None:
        z[:] = case.start
        runner.run(z, case.c, n)

    return work


def _batched(case: Case, runner: InterpretedProgram) -> Callable[[int], None]:
    """The virtual machine builds one Function a batch length: batches of one length, n counts major steps."""
    z = case.start.copy()

    def work(n: int) -> None:
        z[:] = case.start
        for _ in range(n // VM_BATCH):
            runner.run(z, case.c, VM_BATCH)
        for _ in range(n % VM_BATCH):
            runner.run(z, case.c, 1)

    return work


def _hand_difference(case: Case, compiled: CompiledProgram, hand: HandStepper) -> float:
    z, state = case.start.copy(), hand.state(case.start)
    compiled.run(z, case.c, AGREEMENT_STEPS)
    hand.run(state, AGREEMENT_STEPS)
    return _difference(state[:9], hand.state(z)[:9], "hand-written and generated C")


def _loop_difference(case: Case, compiled: CompiledProgram, loop: PythonStepper) -> float:
    z, steps = case.start.copy(), 20
    compiled.run(z, case.c, steps)
    loop.restart(case.start).run(steps)
    return _difference(loop.x, z[case.scheme.layout.slice("x")], "the Python loop and generated C")


def _difference(value: np.ndarray, reference: np.ndarray, what: str) -> float:
    error = float(np.max(np.abs(value - reference) / np.abs(reference)))
    if not error < AGREEMENT:
        raise AssertionError(f"{what} differ by {error:.1e}")
    return error


def _time(name: str, timing: Timing) -> Line:
    return Line(name, timing.best * 1e9, "ns", None, f"median +{timing.spread:.0%}")
