"""Right-hand side of planar chains, N = 10: accelerations from q_i and q_i_dot, compiled."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import casadi as ca
import numpy as np

from benchmarks.models import constants_size, model_of, workplace
from benchmarks.result import Line, Result
from benchmarks.timing import interleave
from runtime.engine.compiled import CompiledProgram
from runtime.engine.program import Call, Fields, Layout, make_stage
from runtime.model import Model
from runtime.schemes.kernels import StepKernels
from runtime.schemes.linear_solve import solve_symmetric
from symgen.scenes.chain import chain

LINKS = 10
CASES = {"rigid": (0, 1.0), "2 modes a link": (2, 3.0)}  # modes, goal in microseconds
FUNCTIONS = frozenset({"condensed", "closure", "velocities", "forward_dynamics"})
AGREEMENT = 1e-9
ROUNDS = 60
DRIFT = 1e-15  # seconds


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
    stages = {"condensed, L D L^T": _stage(model, "rhs_condensed", _by_condensation)}
    if model.has("forward_dynamics"):
        stages["forward_dynamics"] = _stage(model, "rhs_forward", _by_elimination)
    state, c = _state(model), model.constants(model.parameter_vector())
    programs = {method: CompiledProgram(stage) for method, stage in stages.items()}
    values = {method: _accelerations(program, state, c) for method, program in programs.items()}
    reference = next(iter(values.values()))
    error = max(float(np.max(np.abs(value - reference)) / np.max(np.abs(reference))) for value in values.values())
    if not error < AGREEMENT:
        raise AssertionError(f"chain with {name}: the two right-hand sides differ by {error:.1e}")
    timings = interleave({method: _worker(program, state, c) for method, program in programs.items()}, ROUNDS)
    best = min(timings, key=lambda method: timings[method].best)
    lines = [Line(f"{name}, {method}", timing.best * 1e6, "us", goal if method == best else None,
                  f"{stages[method].stage.n_instructions()} operations, median +{timing.spread:.0%}")
             for method, timing in timings.items()]
    return lines, {"difference": error, "operations": {m: s.stage.n_instructions() for m, s in stages.items()}}


def _stage(model: Model, name: str, accelerations: Callable[[StepKernels, Fields], ca.SX]) -> Call:
    """z <- z with q_i_ddot, and rates that drift a little: otherwise the compiler takes the work out of the loop."""
    n = len(model.q_i)
    layout = Layout({"q_i": n, "q_i_dot": n, "q_i_ddot": n})

    def body(z: Fields, c: ca.SX) -> dict[str, ca.SX]:
        result = accelerations(StepKernels(model, c), z)
        return {"q_i_ddot": result, "q_i_dot": z["q_i_dot"] + DRIFT * result}

    return make_stage(name, layout, constants_size(model), body)


def _by_condensation(kernels: StepKernels, z: Fields) -> ca.SX:
    motion = kernels.close(z["q_i"], ca.SX(0, 1), ca.SX(0), 1)
    return solve_symmetric(*kernels.condensed(motion, z["q_i_dot"]))


def _by_elimination(kernels: StepKernels, z: Fields) -> ca.SX:
    motion = kernels.close(z["q_i"], ca.SX(0, 1), ca.SX(0), 1)
    rates = kernels.rates(motion, z["q_i_dot"])
    return kernels.call("forward_dynamics", q_i=z["q_i"], q_d=motion.q_d, q_i_dot=z["q_i_dot"], q_d_dot=rates,
                        t=motion.t)["q_i_ddot"]


def _state(model: Model) -> np.ndarray:
    """A bent, turning chain: random angles and rates, small modal amplitudes."""
    rng = np.random.default_rng(1)
    soft = np.array([name in model.elastic for name in model.q_i])
    n = len(soft)
    q = rng.uniform(-1, 1, n) * np.where(soft, 1e-3, 1.0)
    return np.concatenate([q, rng.uniform(-1, 1, n) * np.where(soft, 0.05, 2.0), np.zeros(n)])


def _accelerations(program: CompiledProgram, state: np.ndarray, c: np.ndarray) -> np.ndarray:
    z = state.copy()
    program.run(z, c, 1)
    return z[2 * len(z) // 3:]


def _worker(program: CompiledProgram, state: np.ndarray, c: np.ndarray) -> Callable[[int], None]:
    z = state.copy()

    def work(n: int) -> None:
        z[:] = state
        program.run(z, c, n)

    return work
