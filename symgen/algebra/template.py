"""A template: SymPy closed forms derived once per body, joint or load type, evaluated on CasADi SX per scene.

SymPy derives each type once, in that type's own symbols; every body and joint of a scene then evaluates the
result with its own SX values. Structural zeros disappear on the way because SX folds 0*x and x+0.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache

import casadi as ca
import sympy as sp

from symgen.algebra.scalar import ONE, div, mul, neg, sub, total

Rules = Mapping[sp.Symbol, sp.Expr]


def derivative(expression: sp.Expr, rules: Rules) -> sp.Expr:
    """Total derivative by a table {symbol: derivative of that symbol}; symbols not in it are constant.

    Working with a table keeps intermediates such as the world arm A(theta) rho as one symbol, which keeps
    the emitted code short (the alternative, expanding every sine and cosine, costs 1.2 to 1.5 times more).
    """
    return sp.Add(*(sp.diff(expression, symbol) * rate for symbol, rate in rules.items()))


_UNARY: dict[type, Callable[[ca.SX], ca.SX]] = {sp.sin: ca.sin, sp.cos: ca.cos}


def to_casadi(expression: sp.Expr, values: Mapping[sp.Symbol, ca.SX], memo: dict[sp.Expr, ca.SX]) -> ca.SX:
    """SX value of a SymPy expression; `memo` shares repeated subexpressions.

    Only the operations that templates contain are known; anything else raises TypeError.
    """
    known = memo.get(expression)
    if known is not None:
        return known
    result = _convert(expression, values, memo)
    memo[expression] = result
    return result


def _convert(expression: sp.Expr, values: Mapping[sp.Symbol, ca.SX], memo: dict[sp.Expr, ca.SX]) -> ca.SX:
    if isinstance(expression, sp.Symbol):
        return values[expression]
    if isinstance(expression, sp.Rational):
        return ca.SX(int(expression.p)) / int(expression.q)
    if isinstance(expression, sp.Add):
        return _sum(expression, values, memo)
    if isinstance(expression, sp.Mul):
        return _product(expression, values, memo)
    if isinstance(expression, sp.Pow):
        return _power(expression, values, memo)
    unary = _UNARY.get(type(expression))
    if unary is not None:
        return unary(to_casadi(expression.args[0], values, memo))
    raise TypeError(f"no CasADi form for {type(expression).__name__} in a template")


def _sum(expression: sp.Expr, values: Mapping[sp.Symbol, ca.SX], memo: dict[sp.Expr, ca.SX]) -> ca.SX:
    plus, minus = _signs(expression)
    result = total(to_casadi(term, values, memo) for term in plus)
    for term in minus:
        result = sub(result, to_casadi(term, values, memo))
    return result


@cache
def _signs(expression: sp.Expr) -> tuple[list[sp.Expr], list[sp.Expr]]:
    """Terms of a sum that are added, and those that are subtracted (without their minus sign)."""
    plus = [term for term in expression.args if not term.could_extract_minus_sign()]
    return plus, [-term for term in expression.args if term.could_extract_minus_sign()]


def _product(expression: sp.Expr, values: Mapping[sp.Symbol, ca.SX], memo: dict[sp.Expr, ca.SX]) -> ca.SX:
    negative, factors = _factors(expression)
    result = ONE
    for factor in factors:
        result = mul(result, to_casadi(factor, values, memo))
    return neg(result) if negative else result


@cache
def _factors(expression: sp.Expr) -> tuple[bool, list[sp.Expr]]:
    """(is there a factor -1, the other factors in the order in which they are multiplied)."""
    negative = expression.args[0] == -1
    return negative, sorted(expression.args[1:] if negative else expression.args, key=_sharing)


def _sharing(factor: sp.Expr) -> tuple[int, str]:
    """Numbers first, then a body's rates, then the rest: 2 theta_dot is one value for all modes of a body."""
    if factor.is_number:
        return 0, ""
    base, _ = factor.as_base_exp()
    rate = base.is_Symbol and base.name.endswith("_dot")
    return (1 if rate else 2), str(factor)


def _power(expression: sp.Expr, values: Mapping[sp.Symbol, ca.SX], memo: dict[sp.Expr, ca.SX]) -> ca.SX:
    base, exponent = expression.as_base_exp()
    if exponent.is_negative:
        return div(ONE, to_casadi(sp.Pow(base, -exponent), values, memo))
    value = to_casadi(base, values, memo)
    if exponent == sp.Rational(1, 2):
        return ca.sqrt(value)
    if isinstance(exponent, sp.Integer):
        result = value
        for _ in range(int(exponent) - 1):
            result = mul(result, value)
        return result
    raise TypeError(f"no CasADi form for the power {exponent} in a template")


@dataclass(frozen=True)
class Template:
    """Named closed forms in a type's own symbols. `outputs` maps a name to its SymPy expression."""

    outputs: Mapping[str, sp.Expr]

    def evaluate(self, values: Mapping[sp.Symbol, ca.SX], names: Sequence[str] | None = None) -> dict[str, ca.SX]:
        """The named outputs (all by default) at the given SX values of the symbols."""
        memo: dict[sp.Expr, ca.SX] = {}
        chosen = self.outputs if names is None else {name: self.outputs[name] for name in names}
        return {name: to_casadi(expression, values, memo) for name, expression in chosen.items()}
