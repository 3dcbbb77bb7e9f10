"""A tape split by what is known: put together again it is the same function, and nothing known is left to compute."""

from __future__ import annotations

import casadi as ca
import numpy as np
import pytest

from runtime.contract.tape import Place, Tape, Time, as_function, below, binding_times, read_tape, split

pytestmark = pytest.mark.long

SIZES = {"known": 3, "later": 4}
OPERATIONS = (
    lambda a, b: a + b,
    lambda a, b: a * b,
    lambda a, b: a - b,
    lambda a, b: a / (2 + b**2),
    lambda a, b: ca.sin(a),
    lambda a, b: ca.fmax(a, b),
)


def random_tape(seed: int, operations: int = 60) -> Tape:
    """Random operations on entries of two inputs; every third value is an output."""
    rng = np.random.default_rng(seed)
    inputs = [ca.SX.sym(name, size) for name, size in SIZES.items()]
    values = [entry for value in inputs for entry in ca.vertsplit(value)]
    for _ in range(operations):
        operation = OPERATIONS[rng.integers(len(OPERATIONS))]
        values.append(operation(*(values[k] for k in rng.integers(len(values), size=2))))
    outputs = ca.cse([ca.densify(ca.vertcat(*values[::3]))])
    return read_tape(ca.Function("f", inputs, outputs, list(SIZES), ["y"]))


def of_input(name: str, entry: int) -> Time:
    return Time.RUN if name == "known" else Time.STEP


def arithmetic(tape: Tape, nodes: list[int]) -> list[int]:
    return [k for k in nodes if tape.nodes[k].op not in (ca.OP_INPUT, ca.OP_CONST)]


@pytest.mark.parametrize("hold_inputs", [False, True])
@pytest.mark.parametrize("seed", range(8))
def test_values_once_and_the_rest_make_the_tape(seed: int, hold_inputs: bool) -> None:
    """Law: rest(known, later, once(known)) = tape(known, later) bit by bit, for two tapes that share values."""
    tapes = {"a": random_tape(seed), "b": random_tape(seed, 40)}
    once, rest = split(tapes, {"known": 3}, of_input, Time.RUN, Place("held", 0), hold_inputs)
    rng = np.random.default_rng(seed)
    known, later = rng.normal(size=3), rng.normal(size=4)
    held = as_function("once", once)(known)
    assert held.numel() > 0
    for name, tape in tapes.items():
        given = np.full(3, np.nan) if hold_inputs else known  # then the rest does not read what is known
        np.testing.assert_array_equal(
            np.asarray(as_function("rest", rest[name])(given, later, held)),
            np.asarray(as_function("f", tape)(known, later)),
        )


@pytest.mark.parametrize("seed", range(8))
def test_the_rest_computes_nothing_that_is_known(seed: int) -> None:
    """Law: no operation of the rest depends on known inputs only, and no value is computed in both parts."""
    tape = random_tape(seed)
    once, rest = split({"f": tape}, {"known": 3}, of_input, Time.RUN, Place("held", 0))

    def known(name: str, entry: int) -> Time:
        return Time.STEP if name == "later" else Time.RUN

    left = rest["f"]
    outputs = set(left.outputs[0])
    times = binding_times(left, known)
    everything = list(range(len(left.nodes)))
    assert all(times[k] == Time.STEP for k in arithmetic(left, everything))
    assert below(left.nodes, outputs) == everything
    total = len(arithmetic(tape, below(tape.nodes, tape.outputs[0])))
    assert len(arithmetic(left, everything)) + len(arithmetic(once, list(range(len(once.nodes))))) == total


def test_values_are_placed_in_an_input_that_is_there() -> None:
    """Held values as further entries of an input: what prepare does with c."""
    tape = random_tape(3)
    once, rest = split({"f": tape}, {"known": 3}, of_input, Time.RUN, Place("known", 3))
    rng = np.random.default_rng(0)
    known, later = rng.normal(size=3), rng.normal(size=4)
    held = np.asarray(as_function("once", once)(known)).ravel()
    assert rest["f"].input_names == ["known", "later"]
    np.testing.assert_array_equal(
        np.asarray(as_function("rest", rest["f"])(np.concatenate([known, held]), later)),
        np.asarray(as_function("f", tape)(known, later)),
    )
