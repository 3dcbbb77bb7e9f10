"""Accelerations from q_i and q_i_dot as programs that can be timed: ours by two routes, or any CasADi function."""

from __future__ import annotations

from collections.abc import Callable

import casadi as ca
import numpy as np

from benchmarks.contenders.by_c_compiler import CompiledProgram
from benchmarks.harness.models import constants_size
from runtime.engine.program import Call, Fields, Layout, make_stage
from runtime.model import Model
from runtime.schemes.sparse_lu import solve_symmetric
from runtime.schemes.stage_equations import StageEquations

FUNCTIONS = frozenset({"condensed", "closure", "velocities", "forward_dynamics"})
DRIFT = 1e-15  # seconds


def routes(model: Model) -> dict[str, Call]:
    """`condensed` with L D L^T, and `forward_dynamics` where the generator has it."""
    size = constants_size(model)

    def stage(name: str, accelerations: Callable[[StageEquations, Fields], ca.SX]) -> Call:
        return _stage(name, len(model.q_i), size, lambda z, c: accelerations(StageEquations(model, c), z))

    found = {"condensed, L D L^T": stage("rhs_condensed", _by_condensation)}
    if model.has("forward_dynamics"):
        found["forward_dynamics"] = stage("rhs_forward", _by_elimination)
    return found


def expression(function: ca.Function) -> Call:
    """The same program from a function (q_i, q_i_dot) -> q_i_ddot."""
    return _stage("rhs_expression", int(function.size1_in(0)), 0, lambda z, c: function(z["q_i"], z["q_i_dot"]))


def _stage(name: str, n: int, constants: int, accelerations: Callable[[Fields, ca.SX], ca.SX]) -> Call:
    """z <- z with q_i_ddot. q_i and q_i_dot drift a little: otherwise the compiler takes work out of the loop.

    With constant q_i that would be the sines, M_hat and its factors.
    """

    def body(z: Fields, c: ca.SX) -> dict[str, ca.SX]:
        result = accelerations(z, c)
        return {"q_i_ddot": result, "q_i_dot": z["q_i_dot"] + DRIFT * result, "q_i": z["q_i"] + DRIFT * z["q_i_dot"]}

    return make_stage(name, Layout({"q_i": n, "q_i_dot": n, "q_i_ddot": n}), constants, body)


def _by_condensation(equations: StageEquations, z: Fields) -> ca.SX:
    motion = equations.close(z["q_i"], ca.SX(0, 1), ca.SX(0), 1)
    return solve_symmetric(*equations.condensed(motion, z["q_i_dot"]))


def _by_elimination(equations: StageEquations, z: Fields) -> ca.SX:
    motion = equations.close(z["q_i"], ca.SX(0, 1), ca.SX(0), 1)
    return equations.tree_accelerations(motion, z["q_i_dot"])


def evaluated(program: CompiledProgram, state: np.ndarray, c: np.ndarray) -> np.ndarray:
    """q_i_ddot at a state (q_i, q_i_dot, space for q_i_ddot)."""
    z = state.copy()
    program.run(z, c, 1)
    return z[2 * len(z) // 3 :]


def worker(program: CompiledProgram, state: np.ndarray, c: np.ndarray) -> Callable[[int], None]:
    """What evaluates the accelerations n times, from a state."""
    z = state.copy()

    def work(n: int) -> None:
        z[:] = state
        program.run(z, c, n)

    return work
