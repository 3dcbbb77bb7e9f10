"""Every operation in LLVM IR: sin, cos and exp of our own against mpmath, all others against CasADi bit for bit."""

from __future__ import annotations

import math

import casadi as ca
import mpmath
import numpy as np
import pytest

from runtime.contract.tape import UNUSED, Node, Tape, as_function
from runtime.engine.llvm_code import BEST, FIRST_EFFORT
from runtime.engine.llvm_ir import program_ir, side_by_side
from runtime.engine.native import NativeProgram
from runtime.engine.program import Call, Form
from tests.support.step_programs import StepProgram

MOST_ULP = 0.8
RANDOM = np.random.default_rng(0)
SPECIAL = (0.0, -0.0, 1.0, -1.0, 0.5, 3.0, -2.5, 1e-310, 1e300, math.inf, -math.inf, math.nan)


def evaluated(expressions, x: np.ndarray, form: Form, effort=BEST) -> np.ndarray:
    """Values (len(x), number) of expressions(a, b) at rows of x, lanes side by side."""
    z, c = ca.SX.sym("z", x.shape[1]), ca.SX.sym("c", 1)
    values = expressions(*ca.vertsplit(z))
    padded = ca.vertcat(z, ca.SX.zeros(len(values)))
    stage_z = ca.SX.sym("z", padded.numel())
    result = ca.vertcat(stage_z[: x.shape[1]], *expressions(*ca.vertsplit(stage_z[: x.shape[1]])))
    program = Call(ca.Function("f", [stage_z, c], [ca.densify(result)], ["z", "c"], ["z_next"]))
    found = []
    for row in x:
        start = np.concatenate([row, np.zeros(len(values))])
        found.append(StepProgram(program, np.zeros(1), start).run(1, form, effort)[-1][x.shape[1] :])
    return np.array(found)


def ulps(found: float, exact: mpmath.mpf) -> float:
    """Error in units of the last place of the exact value."""
    return float(abs(mpmath.mpf(found) - exact) / math.ulp(abs(float(exact)) or 5e-324))


def near_multiples_of_half_pi() -> np.ndarray:
    factors = [*range(1, 60), *(int(k) for k in RANDOM.integers(1, 10**14, 200))]
    with mpmath.workprec(160):
        return np.array([float(k * mpmath.pi / 2) for k in factors])


ANGLES = {
    **{f"below {limit:g}": RANDOM.uniform(-limit, limit, 600) for limit in (1.0, 10.0, 1e5, 1e9, 1e14)},
    "near multiples of pi/2": near_multiples_of_half_pi(),
}


@pytest.mark.every_push("below 1", "below 100000")
@pytest.mark.parametrize("x", ANGLES.values(), ids=ANGLES.keys())
def test_sine_and_cosine(x: np.ndarray) -> None:
    found = evaluated(lambda a: [ca.sin(a), ca.cos(a)], x[:, None], Form())
    with mpmath.workprec(160):
        for value, (sine, cosine) in zip(x, found, strict=True):
            assert ulps(sine, mpmath.sin(mpmath.mpf(value))) <= MOST_ULP
            assert ulps(cosine, mpmath.cos(mpmath.mpf(value))) <= MOST_ULP


@pytest.mark.every_push("5", "9")
@pytest.mark.parametrize("count", [2, 3, 5, 8, 9, 20])
def test_angles_together_have_the_bits_of_angles_alone(count: int) -> None:
    """By vectors of 2, 4 and 8, some not full; half of the angles wait for sines of the others, and a few have no
    cosine. In functions of one statement each no angle has another beside it."""
    x = RANDOM.uniform(-50.0, 50.0, (20, count))

    def chained(*angles: ca.SX) -> list[ca.SX]:
        first = [ca.sin(a) for a in angles]
        second = [a * b + 0.1 * k for k, (a, b) in enumerate(zip(angles, first, strict=True))]
        return [*first, *(ca.cos(a) for a in angles[1:]), *(ca.sin(s) - ca.cos(s) for s in second)]

    together = evaluated(chained, x, Form())
    alone = evaluated(chained, x, Form(chunk=1, inline=False), FIRST_EFFORT)
    np.testing.assert_array_equal(together, alone)
    z = [ca.SX.sym("z", count), ca.SX.sym("c", 1)]
    stage = ca.Function("f", z, [ca.vertcat(*chained(*ca.vertsplit(z[0])))[:count]], ["z", "c"], ["z_next"])
    width = {2: 2, 3: 4, 5: 8, 8: 8, 9: 8, 20: 8}[count]
    assert f"@own_sincos_{width}(<{width} x double> %" in program_ir(Call(stage), Form())[0]


@pytest.mark.every_push("30.0")
@pytest.mark.parametrize("limit", [1.0, 30.0, 708.0])
def test_exponential(limit: float) -> None:
    x = RANDOM.uniform(-limit, limit, 600)
    found = evaluated(lambda a: [ca.exp(a)], x[:, None], Form())[:, 0]
    with mpmath.workprec(160):
        assert max(ulps(value, mpmath.exp(mpmath.mpf(at))) for at, value in zip(x, found, strict=True)) <= MOST_ULP


def test_ends_of_the_range() -> None:
    x = np.array([0.0, -0.0, 1e-310, math.inf, -math.inf, math.nan, 2.0**50, 1e300, 710.0, -746.0])[:, None]
    sine, cosine, power = evaluated(lambda a: [ca.sin(a), ca.cos(a), ca.exp(a)], x, Form()).T
    assert list(np.signbit(sine[:2])) == [False, True]
    np.testing.assert_array_equal(sine, [0.0, -0.0, 1e-310, *[math.nan] * 5, *sine[8:]])
    np.testing.assert_array_equal(cosine[:8], [1.0, 1.0, 1.0, *[math.nan] * 5])
    np.testing.assert_array_equal(power, [1, 1, 1, math.inf, 0, math.nan, math.inf, math.inf, math.inf, 0])


def every_operation(a: ca.SX, b: ca.SX) -> list[ca.SX]:
    one = [ca.sqrt, ca.log, ca.tan, ca.asin, ca.acos, ca.atan, ca.sinh, ca.cosh, ca.tanh, ca.exp, ca.sin, ca.cos]
    one += [ca.fabs, ca.floor, ca.ceil, ca.sign, lambda x: -x, lambda x: x * x, lambda x: 2 * x, lambda x: 1 / x]
    both = [ca.fmin, ca.fmax, ca.atan2, ca.fmod, ca.copysign, ca.hypot, ca.power]
    tests = [a < b, a <= b, a == b, a != b, ca.logic_and(a, b), ca.logic_or(a, b), ca.logic_not(a)]
    chosen = [ca.if_else(a < b, a, b), ca.if_else(a, b, 0)]
    return [a + b, a - b, a * b, a / b, a**2.5, *(f(a) for f in one), *(f(a, b) for f in both), *tests, *chosen]


@pytest.mark.parametrize("width, effort", [(1, BEST), (1, FIRST_EFFORT), (4, BEST)], ids=["best", "first", "lanes"])
def test_every_operation_equals_casadis(width: int, effort) -> None:
    """Also of zeros, infinities and no numbers; only the sign of a zero from fmin and fmax of zeros is free."""
    a, b = ca.SX.sym("a"), ca.SX.sym("b")
    virtual = ca.Function("f", [a, b], [ca.vertcat(*every_operation(a, b))])
    x = np.array([(one, other) for one in SPECIAL for other in SPECIAL])
    found = evaluated(every_operation, x, Form(width, "library", inline=effort is BEST), effort)
    expected = np.array([np.asarray(virtual(*row)).ravel() for row in x])
    np.testing.assert_array_equal(found, expected)


def test_lanes_and_scalar_code_agree_in_own_mathematics() -> None:
    x = np.concatenate([*ANGLES.values(), np.array(SPECIAL)])[::10, None]
    scalar, lanes = (evaluated(lambda a: [ca.sin(a), ca.cos(a), ca.exp(a / 50)], x, Form(width)) for width in (1, 8))
    np.testing.assert_array_equal(scalar, lanes)


def test_angles_side_by_side_that_stand_twice_have_both_their_values() -> None:
    """Nothing shares what a tape has twice: each node is defined, with the bits of angles that stand alone."""
    tape = Tape(
        ["z", "c"],
        [5, 1],
        ["z_next"],
        [(5, 1)],
        nodes=[
            Node(ca.OP_INPUT, 0, 0, 0.0),
            Node(ca.OP_INPUT, 0, 1, 0.0),
            Node(ca.OP_SIN, 0, UNUSED, 0.0),
            Node(ca.OP_SIN, 0, UNUSED, 0.0),
            Node(ca.OP_COS, 1, UNUSED, 0.0),
            Node(ca.OP_ADD, 2, 4, 0.0),
            Node(ca.OP_MUL, 3, 5, 0.0),
        ],
        outputs=[[0, 1, 2, 3, 6]],
    )
    order, groups = side_by_side(tape.nodes, range(2, 7))
    assert set(groups) == {2, 3, 4} and sorted(order) == list(range(2, 7))
    stage = as_function("twice", tape)
    z = np.array([0.7, -1.3, 0.0, 0.0, 0.0])
    NativeProgram(Call(stage), wait=True).run(z, np.zeros(1), 1)
    sine, cosine = evaluated(lambda a: [ca.sin(a), ca.cos(a)], np.array([[0.7], [-1.3]]), Form())[[0, 1], [0, 1]]
    np.testing.assert_array_equal(z[2:], [sine, sine, sine * (sine + cosine)])
