"""Right-hand side of planar chains, N = 10: accelerations from q_i and q_i_dot, compiled."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from benchmarks.cases.right_hand_side import FUNCTIONS, evaluated, routes, worker
from benchmarks.contenders.by_c_compiler import CompiledProgram
from benchmarks.harness.models import model_of, workplace
from benchmarks.harness.result import Line, Result
from benchmarks.harness.timing import interleave
from runtime.model import Model
from symgen.scenes.pendulums import chain

LINKS = 10
CASES = {"rigid": (0, 1.0), "2 modes a link": (2, 3.0)}  # modes, goal in microseconds
AGREEMENT = 1e-9
ROUNDS = 60
SMALLEST = {"LINKS": 2, "ROUNDS": 2}


def run() -> Result:
    """Time `condensed` with L D L^T, and `forward_dynamics` where the generator has it."""
    lines: list[Line] = []
    details: dict = {}
    with workplace() as folder:
        for name, (modes, goal) in CASES.items():
            case_lines, details[name] = _case(name, modes, goal, folder)
            lines += case_lines
    return Result("rhs_chain", "Right-hand side of planar chains, N = 10", lines, details)


def _case(name: str, modes: int, goal: float, folder: Path) -> tuple[list[Line], dict]:
    model = model_of(chain(LINKS, modes), folder, FUNCTIONS)
    stages = routes(model)
    state, c = _state(model), model.constants(model.parameter_vector())
    programs = {method: CompiledProgram(stage) for method, stage in stages.items()}
    values = {method: evaluated(program, state, c) for method, program in programs.items()}
    reference = next(iter(values.values()))
    error = max(float(np.max(np.abs(value - reference)) / np.max(np.abs(reference))) for value in values.values())
    if not error < AGREEMENT:
        raise AssertionError(f"chain with {name}: the two right-hand sides differ by {error:.1e}")
    timings = interleave({method: worker(program, state, c) for method, program in programs.items()}, ROUNDS)
    best = min(timings, key=lambda method: timings[method].best)
    lines = [
        Line(
            f"{name}, {method}",
            timing.best * 1e6,
            "us",
            goal if method == best else None,
            f"{stages[method].stage.n_instructions()} operations, median +{timing.spread:.0%}",
        )
        for method, timing in timings.items()
    ]
    return lines, {"difference": error, "operations": {m: s.stage.n_instructions() for m, s in stages.items()}}


def _state(model: Model) -> np.ndarray:
    """A bent, turning chain: random angles and rates, small modal amplitudes."""
    rng = np.random.default_rng(1)
    soft = np.array([name in model.elastic for name in model.q_i])
    n = len(soft)
    q = rng.uniform(-1, 1, n) * np.where(soft, 1e-3, 1.0)
    return np.concatenate([q, rng.uniform(-1, 1, n) * np.where(soft, 0.05, 2.0), np.zeros(n)])
