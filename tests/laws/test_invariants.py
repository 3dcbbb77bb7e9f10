"""Values that a repetition fixes, taken out of it: the same numbers, fewer operations in a sub-step."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import casadi as ca
import numpy as np
import pytest

from runtime.contract.tape import as_function, read_tape
from runtime.engine.interpreted import InterpretedProgram
from runtime.engine.prepare import hoist_invariants, prepare, widened
from runtime.engine.program import Program, Repeat, Sequence
from runtime.model import Model
from runtime.running.planning import make_plan
from runtime.schemes.stepper import start_vector

Load = Callable[[str], Model]
CASES = [
    ("flexible_slider_crank_free", 1e-5),
    ("hub_beam", 2e-3),
    ("flexible_slider_crank_torque", 5e-5),
    ("two_oscillators", 1e-2),
    ("overdamped_joint", 4e-5),
]


def started(model: Model, scheme: str, m: list[int], dt: float) -> tuple[Any, Any, Any]:
    plan = make_plan(model, 1.0, dt, m, scheme, 1, {}, 0.0)
    c = model.constants(model.parameter_vector())
    z = start_vector(plan.scheme, 0.0, model.initial_q, model.initial_q_dot, c)
    return plan.scheme, z, plan.scheme.constants(c)


@pytest.mark.parametrize("scheme, m", [("coupled", [2]), ("coupled", [7])])
@pytest.mark.parametrize("name, dt", CASES)
def test_hoisting_changes_no_bit(built_in: Load, name: str, dt: float, scheme: str, m: list[int]) -> None:
    """Law: the program with invariants taken out of its repetitions gives the scheme's z bit by bit."""
    scheme_on, z, c = started(built_in(name), scheme, m, dt)
    program, size = hoist_invariants(scheme_on.program(), len(z))
    program = program.map(lambda stage: as_function(stage.name(), widened(read_tape(stage), size)))
    assert size > len(z) or name == "two_oscillators"  # of which nothing is left to take out
    plain, hoisted = z.copy(), np.concatenate([z, np.zeros(size - len(z))])
    InterpretedProgram(scheme_on.program(), len(z), len(c)).run(plain, c, 30)
    InterpretedProgram(program, size, len(c)).run(hoisted, c, 30)
    assert np.max(np.abs(plain - z)) > 0
    np.testing.assert_array_equal(hoisted[: len(z)], plain)


@pytest.mark.parametrize("scheme, m", [("coupled", [7])])
@pytest.mark.parametrize("name, dt", CASES)
def test_prepared_programs_agree_to_rounding(built_in: Load, name: str, dt: float, scheme: str, m: list[int]) -> None:
    """Law: `prepare` changes no more than rounding (a division by a constant becomes a product)."""
    scheme_on, z, c = started(built_in(name), scheme, m, dt)
    prepared = prepare(scheme_on.program(), len(z), len(c))
    plain, ours, ready = z.copy(), prepared.widened(z), prepared.ready(c)
    InterpretedProgram(scheme_on.program(), len(z), len(c)).run(plain, c, 30)
    InterpretedProgram(prepared.program, prepared.z_size, len(ready)).run(ours, ready, 30)
    layout = scheme_on.layout
    for field in ("x", "v", "a", "loop"):
        part = layout.slice(field)
        scale = np.max(np.abs(plain[part]), initial=1e-300)
        np.testing.assert_allclose(ours[part], plain[part], rtol=0, atol=1e-11 * scale)


def arithmetic(program: Program) -> tuple[int, int]:
    """(operations, sines and cosines) of the body of the innermost repetition, reading and copying not counted."""
    if isinstance(program, Sequence):
        return max((arithmetic(part) for part in program.parts), default=(0, 0))
    if not isinstance(program, Repeat):
        return 0, 0
    inner = arithmetic(program.body)
    if inner[0]:
        return inner
    ops = [node.op for stage in program.body.stages() for node in read_tape(stage).nodes]
    work = [op for op in ops if op not in (ca.OP_INPUT, ca.OP_CONST)]
    return len(work), sum(op in (ca.OP_SIN, ca.OP_COS) for op in work)


# fewer sines and cosines: those of q_L; the load of hub_beam depends on time, which sub-steps follow
@pytest.mark.parametrize(
    "name, trigonometry",
    [("hub_beam", 0), ("overdamped_joint", 1), ("flexible_slider_crank_free", 2), ("flexible_four_bar", 2)],
)
def test_sub_steps_get_cheaper(built_in: Load, name: str, trigonometry: int) -> None:
    """Law: what q_L alone decides is not computed in the sub-steps, its sines and cosines least of all."""
    scheme, z, _ = started(built_in(name), "coupled", [4], 1e-5)
    program, _ = hoist_invariants(scheme.program(), len(z))
    before, after = arithmetic(scheme.program()), arithmetic(program)
    assert before[1] - after[1] == trigonometry
    assert 0 < after[0] < before[0]
