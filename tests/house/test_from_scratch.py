""" "symgen from scratch" is one short program: it runs, uses nothing of symgen, and computes what is right."""

from __future__ import annotations

import ast
import ctypes
import runpy
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from runtime.engine.c_source import find_compiler
from tests.hand_derived import twin_double_pendulum as twin

PROGRAM = Path(__file__).resolve().parents[2] / "docs" / "inside" / "symgen_from_scratch.py"
PERIOD = 2.36784194757624  # s, of the pendulum of case P1
SOURCE = PROGRAM.read_text(encoding="utf-8")


@pytest.fixture(scope="module")
def page() -> dict[str, Any]:
    """Everything the program defines."""
    return runpy.run_path(str(PROGRAM))


def test_the_program_from_scratch_stands_alone() -> None:
    imported = set()
    for node in ast.walk(ast.parse(SOURCE)):
        if isinstance(node, ast.Import):
            imported |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            imported.add(str(node.module))
    assert imported == {"__future__", "casadi", "sympy", "math", "dataclasses", "collections.abc"}


def test_the_program_from_scratch_runs(page: dict[str, Any]) -> None:
    """The period is of second order, and without its leading error the published one."""
    assert page["exact_period"](1.0, 9.81, np.pi / 2) == pytest.approx(PERIOD, rel=1e-14)
    errors = [page[name] - PERIOD for name in ("coarse", "fine")]
    assert np.log2(errors[0] / errors[1]) == pytest.approx(2.0, abs=0.01)
    assert page["extrapolated"] == pytest.approx(PERIOD, abs=2e-10)


def test_a_second_bar_gives_the_equations_derived_by_hand(page: dict[str, Any]) -> None:
    p = twin.Params()
    moments = [p.m1, p.m1 * p.a1, p.J1 + p.m1 * p.a1**2, p.l1, p.m2, p.m2 * p.a2, p.J2 + p.m2 * p.a2**2, 0.7]
    q_i, q_i_dot = np.array([0.3, -1.1]), np.array([2.0, -3.0])
    M_hat, Q_hat = (value.full() for value in page["kernel"](2)(q_i, q_i_dot, [p.g, *moments]))
    assert M_hat == pytest.approx(twin.M_hat(p, q_i, 0.0), rel=1e-14)
    assert Q_hat.ravel() == pytest.approx(twin.Q_hat(p, q_i, q_i_dot, 0.0), rel=1e-13)


def test_the_split_step_is_the_step(page: dict[str, Any]) -> None:
    """Bit for bit, with fewer operations a step, and nothing that depends on c only left in it."""
    whole = page["recorded"](page["step"](2))
    before, each = page["split"](whole)
    c = [1e-3, 9.81, 1.3, 0.6, 0.4, 1.0, 0.8, 0.3, 0.2, 0.7]
    z = [0.3, -1.1, 2e-3, -3e-3, 1.0, -2.0]
    once = page["run"](before, c=c)
    assert page["run"](each, z=z, once=once) == page["run"](whole, z=z, c=c)
    assert page["operations"](before) + page["operations"](each) == page["operations"](whole)
    depends = set()
    for k, node in enumerate(each.nodes):
        if node.op == "z" or depends.intersection(node.arguments):
            depends.add(k)
        assert k in depends or not node.arguments


@pytest.mark.skipif(find_compiler() is None, reason="no C compiler")
def test_its_two_engines_agree_bit_for_bit(page: dict[str, Any], tmp_path: Path) -> None:
    before, each = page["split"](page["recorded"](page["step"](1)))
    source, library = tmp_path / "step.c", tmp_path / "step.so"
    source.write_text(page["c_source"](each), encoding="utf-8")
    compiler = str(find_compiler())
    flags = ["-O1", "-ffp-contract=off", "-shared", "-fPIC"]
    subprocess.run([compiler, *flags, str(source), "-o", str(library), "-lm"], check=True)
    once = np.array(page["run"](before, c=[1e-3, *page["PENDULUM"]]))
    path = page["motion"](1, [0.0], 1e-3, page["PENDULUM"], 50)
    z = np.array(path[0])
    step = ctypes.CDLL(str(library)).step
    for expected in path[1:]:
        step(ctypes.c_void_p(z.ctypes.data), ctypes.c_void_p(once.ctypes.data))
        assert list(z) == expected
