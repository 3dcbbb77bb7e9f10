"""Expressions mean what they say in Python, of numbers and of symbols; random text never gives another exception."""

from __future__ import annotations

import math
from collections.abc import Callable

import casadi as ca
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from symgen.scene import SceneError, parse_expression
from symgen.schema.expressions import ARITY, OPERATIONS

NAMES = frozenset({"a", "b", "t"})
OF_MATH = ("sin cos tan asin acos atan atan2 sinh cosh tanh exp log sqrt").split()
IN_PYTHON: dict[str, Callable[..., float]] = {
    **{name: getattr(math, name) for name in OF_MATH},
    "abs": abs,
    "sign": lambda x: float((x > 0) - (x < 0)),
    "step": lambda x: float(x >= 0),
    "min": min,
    "max": max,
    "where": lambda holds, x, y: x if holds else y,
}


def both(text: str, values: dict[str, float]) -> tuple[float, float]:
    """The value of ``text`` by numbers, and by symbols that become these."""
    expression = parse_expression(text, NAMES, "item")
    symbols = {name: ca.SX.sym(name) for name in values}
    function = ca.Function("f", list(symbols.values()), [expression.to_casadi(symbols)])
    return expression.evaluate(values), float(function(*values.values()))


def test_every_function_has_a_meaning() -> None:
    assert set(ARITY) == set(IN_PYTHON) and set(ARITY) < set(OPERATIONS)


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("1 + 2*3", 7.0),
        ("-2**2", -4.0),
        ("2**3**2", 512.0),
        ("2**-1", 0.5),
        ("+a - -b", 0.75),
        ("7/2", 3.5),
        ("sin(pi/2)", 1.0),
        ("atan2(1, -1)", 0.75 * math.pi),
        ("min(3, a, 2) + max(3, a, 2)", 3.5),
        ("sign(-3) + sign(0) + abs(-2)", 1.0),
        ("step(0) + step(-1e-9) + step(2)", 2.0),
        ("where(a < b, 10, 20)", 20.0),
        ("where(0 <= a < 1, 10, 20)", 10.0),
        ("where(a == 0.5, where(b != 0.25, 1, 2), 3)", 2.0),
        ("where(a > 0, a, log(a - 1))", 0.5),
        ("exp(log(2)) + sqrt(4) + cosh(0) + tanh(0)", 5.0),
        ("1_000 + .5e1", 1005.0),
    ],
)
def test_meaning(text: str, value: float) -> None:
    assert both(text, {"a": 0.5, "b": 0.25}) == pytest.approx((value, value), rel=1e-15)


def test_names_are_those_that_are_used() -> None:
    assert parse_expression("a*sin(t) + pi", NAMES, "item").names == {"a", "t"}
    assert parse_expression(3, frozenset(), "item").evaluate({}) == 3.0


def test_derivatives_of_powers_stay_finite_at_zero() -> None:
    a = ca.SX.sym("a")
    cube = parse_expression("a**3", NAMES, "item").to_casadi({"a": a})
    assert float(ca.Function("f", [a], [ca.jacobian(cube, a)])(0.0)) == 0.0


def test_a_missing_value_is_a_scene_error() -> None:
    expression = parse_expression("a + b", NAMES, "item")
    with pytest.raises(SceneError, match="'b'"):
        expression.evaluate({"a": 1.0})
    with pytest.raises(SceneError, match="'a'"):
        expression.to_casadi({})


@settings(max_examples=200, deadline=None)
@given(st.sampled_from(sorted(ARITY)), st.floats(-30, 30), st.floats(-30, 30))
def test_every_function_is_that_of_python(name: str, a: float, b: float) -> None:
    arguments = {1: "a", 2: "a, b", 3: "a < b, a, b"}[ARITY[name][0]]
    given = {1: (a,), 2: (a, b), 3: (a < b, a, b)}[ARITY[name][0]]
    try:
        expected = IN_PYTHON[name](*given)
    except (ArithmeticError, ValueError):
        with pytest.raises(SceneError, match="no finite value"):
            both(f"{name}({arguments})", {"a": a, "b": b})
        return
    assert both(f"{name}({arguments})", {"a": a, "b": b}) == pytest.approx((expected, expected), rel=1e-14, abs=1e-300)


def _well_conditioned(inner: st.SearchStrategy[str]) -> st.SearchStrategy[str]:
    """Compositions that keep rounding small: CasADi simplifies, and a jump or a pole would magnify it."""
    return st.one_of(
        st.builds("({} {} {})".format, inner, st.sampled_from("+-*"), inner),
        st.builds("({} / (1 + abs({})))".format, inner, inner),
        st.builds("{}({})".format, st.sampled_from(["sin", "cos", "atan", "tanh", "abs", "-", "+"]), inner),
        st.builds("{}({}, {})".format, st.sampled_from(["min", "max"]), inner, inner),
        st.builds("where({} < {}, {}, {})".format, LEAVES, LEAVES, inner, inner),
    )


LEAVES = st.sampled_from(
    ["a", "b", "pi", "0", "2", "0.5", "3e-2", "a**2", "sign(a)", "step(b)", "atan2(a, 2)"],
)


@settings(max_examples=150, deadline=None)
@given(st.recursive(LEAVES, _well_conditioned, max_leaves=8), st.floats(-3, 3), st.floats(-3, 3))
def test_compositions_of_numbers_and_of_symbols_agree(text: str, a: float, b: float) -> None:
    numbers, symbols = both(text, {"a": a, "b": b})
    assert symbols == pytest.approx(numbers, rel=1e-9, abs=1e-9)


PIECES = [*"at().,9<=:['e_*\\\n", "sin", "where", "**", "lambda "]


@settings(max_examples=100, deadline=None)
@given(st.one_of(st.text(max_size=60), st.lists(st.sampled_from(PIECES), max_size=25).map("".join)))
def test_random_text_gives_an_expression_or_a_scene_error(text: str) -> None:
    try:
        parse_expression(text, NAMES, "item").evaluate({"a": 1.0, "b": 2.0, "t": 0.0})
    except SceneError as error:
        assert error.item == "item" and error.problem and error.remedy
