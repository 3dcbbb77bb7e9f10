"""Ensembles of the freely running slider-crank: time of a scenario-step, of whole studies, and what others take."""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import Any

import numpy as np

from benchmarks.contenders.exudyn_models import Cable, is_installed
from benchmarks.harness.result import Line, Result
from benchmarks.harness.timing import interleave
from runtime import simulate
from runtime.engine.interpreted import InterpretedProgram, program_function
from runtime.engine.llvm_code import host
from runtime.engine.prepare import prepare
from runtime.model import Model, load_model
from runtime.running.planning import make_plan
from runtime.schemes.catalogue import scheme_kind
from runtime.schemes.stepper import start_vector
from runtime.studies.ensemble.ensemble_spec import EnsembleSpec
from runtime.studies.ensemble.rows import Rows
from runtime.studies.ensemble.starts import CaseStarts, table_of
from symgen.scenes import generated_folder

STEPS, DT, ROUNDS = 250, 2e-5, 15
OUTPUTS = {"crank.theta": ["end"], "rod.q1": ["peak", "rms"], "rod.q2": ["peak"]}
WIDE = "+avx512f" in host().features
# (scheme, m, goal for a scenario-step [ns] with AVX-512, twice that without)
CASES: tuple[tuple[str, list[int], float | None], ...] = (
    ("exponential", [2], 110.0),
    ("single_rate", [], 14.0),
    ("printed", [4], None),
)
MANY, FEW, MAPPED, WALLS = 100_000, 1_000, 16, 3
SMALLEST = {"CASES": CASES[1:2], "STEPS": 20, "ROUNDS": 2, "MANY": 64, "FEW": 64, "WALLS": 1}
REMARK = """\
The scene `flexible_slider_crank_free`, {steps} steps of {dt:g} s, mass of the slider and speed of the crank varied;
kept are the crank's angle at the end, largest and root-mean-square values of the rod's first two modes, over all steps.
Set-up (programs and code, or loading) is left out everywhere. CPU time of one thread; where threads are compared wall
time, which other work on the machine lengthens, and CPU time of all threads. CasADi: the same step program,
{steps} steps a Function, mapped over {mapped} scenarios. Exudyn: a rod of four cable elements, trapezoidal rule, as
many steps, one run after another as its parameter variation does in each process; only `SolveDynamic` is timed."""


def run() -> Result:
    """All schemes, then studies in threads."""
    model = load_model(generated_folder("flexible_slider_crank_free"))
    lines: list[Line] = []
    for scheme, m, goal in CASES:
        lines += _scheme(model, scheme, m, goal if goal is None or WIDE else 2 * goal)
    lines += _studies(model) + _exudyn()
    remark = REMARK.format(steps=STEPS, dt=DT, mapped=MAPPED)
    return Result("ensemble", "Many runs at once", lines, {"avx512": WIDE}, remark)


def _rows(model: Model, scheme: str, m: list[int], cases: int) -> Rows:
    """A study with its code made."""
    share = np.linspace(0.9, 1.1, cases)
    names, table = table_of(model, {"slider.mass": 0.0755 * share}, {"crank.theta_dot": 150.0 * share[::-1]})
    plan = make_plan(model, STEPS * DT, DT, m or None, scheme, None, None, 0.0)
    rows = Rows(EnsembleSpec.ask(model, names, plan, None, None, OUTPUTS), table)
    rows.lanes.programs.compile()
    return rows


def _scheme(model: Model, scheme: str, m: list[int], goal: float | None) -> list[Line]:
    """Steps alone, a whole study, `simulate` and CasADi's map."""
    rows = _rows(model, scheme, m, FEW)
    lanes, job = rows.lanes, FEW - FEW % rows.lanes.programs.width
    starts = CaseStarts(rows.spec)
    blocks = lanes.started(starts.of(rows.table[:job]))
    first = blocks.copy()

    def steps(n: int) -> None:
        for _ in range(n):
            blocks[:] = first
            lanes.advance(blocks, STEPS)

    def whole(n: int) -> None:
        for _ in range(n):
            rows.of(0, job)

    found = interleave({"steps": steps, "whole": whole, "map": _mapped(model, scheme, m)}, ROUNDS)
    loop = _simulated(model, scheme, m)
    unit = 1e9 / STEPS
    width = lanes.programs.width
    alone = found["whole"].best / job * unit
    mapped, simulated = found["map"].best / MAPPED * unit, loop * unit
    return [
        Line(f"{scheme}: a scenario-step", found["steps"].best / job * unit, "ns", goal, f"{width} lanes, one core"),
        Line(f"{scheme}: the same with start, looks and reductions", alone, "ns", None, "of a whole study"),
        Line(f"{scheme}: by CasADi's map", mapped, "ns", None, f"{mapped / alone:.0f} times as long"),
        Line(f"{scheme}: by a loop over simulate", simulated, "ns", None, f"{simulated / alone:.0f} times as long"),
    ]


def _mapped(model: Model, scheme: str, m: list[int]) -> Callable[[int], None]:
    """CasADi's own way: the steps of a run as one Function, mapped over scenarios."""
    on = scheme_kind(scheme).build(scheme, model, DT, m or None, {})
    c = model.constants(model.parameter_vector())
    prepared = prepare(on.program(), on.layout.size, on.c_size)
    ready = prepared.ready(on.constants(c))
    z = prepared.widened(start_vector(on, 0.0, model.initial_q, model.initial_q_dot, c))
    step = program_function(prepared.program, prepared.z_size, len(ready))
    runs = step.fold(STEPS).map(MAPPED)
    states, constants = np.repeat(z[:, None], MAPPED, axis=1), np.repeat(ready[:, None], MAPPED * STEPS, axis=1)
    expected = z.copy()
    InterpretedProgram(prepared.program, len(z), len(ready)).run(expected, ready, STEPS)
    np.testing.assert_array_equal(np.asarray(runs(states, constants))[:, -1], expected)

    def work(n: int) -> None:
        for _ in range(n):
            runs(states, constants)

    return work


def _simulated(model: Model, scheme: str, m: list[int]) -> float:
    """CPU seconds of a run by `simulate` that keeps the same outputs, code from the cache."""
    settings: dict[str, Any] = {"scheme": scheme, "m": m or None, "dt": DT, "t_end": STEPS * DT, "seen_every": 0.0}
    seconds = []
    for speed in (149.0, 150.5, 151.0):
        began = time.thread_time()
        simulate(model, initial={"crank.theta_dot": speed}, outputs=list(OUTPUTS), **settings)
        seconds.append(time.thread_time() - began)
    return min(seconds)


def _studies(model: Model) -> list[Line]:
    """Wall time of studies, and one thread against two; beside it CPU time, which other work does not lengthen."""
    lines = []
    for scheme, m, goals in (("exponential", [2], (0.1, 2.0)), ("single_rate", [], (0.1, None))):
        rows = _rows(model, scheme, m, MANY)
        few = min(_timed(rows, FEW, 2) for _ in range(WALLS))
        pairs = [(_timed(rows, MANY, 1), _timed(rows, MANY, 2)) for _ in range(WALLS)]
        one, two = (tuple(map(min, zip(*times, strict=True))) for times in zip(*pairs, strict=True))
        lines += [
            Line(f"{scheme}: {FEW} scenarios, two threads", few[0], "s", goals[0], f"wall; CPU {few[1]:.3g} s"),
            Line(f"{scheme}: {MANY} scenarios, two threads", two[0], "s", goals[1], f"wall; CPU {two[1]:.3g} s"),
            Line(f"{scheme}: two threads / one", two[0] / one[0], "", 1 / 1.8, f"wall; CPU {two[1] / one[1]:.3g}"),
        ]
    return lines


def _timed(rows: Rows, cases: int, threads: int) -> tuple[float, float]:
    """(wall, CPU) seconds."""
    own = Rows(rows.spec, rows.table[:cases])
    wall, cpu = time.perf_counter(), time.process_time()
    done = sum(len(part.time) for _, part in own.in_threads(threads, lambda: False))
    seconds = time.perf_counter() - wall, time.process_time() - cpu
    assert done == cases
    return seconds


def _exudyn() -> list[Line]:
    """A run of the nearest model, where Exudyn is installed."""
    if not is_installed():
        return []
    cable = Cable(4)
    settings = cable.settings(STEPS * DT, STEPS)
    best = min(cable.solve(settings) for _ in range(ROUNDS))
    note = f"{best * FEW:.3g} s for {FEW} scenarios on one core"
    return [Line("Exudyn, four cable elements: a scenario-step", best / STEPS * 1e9, "ns", None, note)]
