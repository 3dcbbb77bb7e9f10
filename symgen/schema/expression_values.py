"""What an expression's operators and functions mean, in floats and in CasADi symbols.

Each function name appears once in `ARITY`; both tables below must hold all of them (a test compares
the two by value).
"""

from __future__ import annotations

import math
import operator
from collections.abc import Callable, Mapping
from functools import reduce
from typing import Any

import casadi as ca

from symgen.schema.expression_nodes import (
    Binary,
    Condition,
    Constant,
    FunctionCall,
    NamedValue,
    Negative,
    Node,
    TableValue,
    Where,
)

ARITY: dict[str, tuple[int, int]] = {
    **dict.fromkeys(("sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh"), (1, 1)),
    **dict.fromkeys(("exp", "log", "sqrt", "abs", "sign", "step"), (1, 1)),
    "atan2": (2, 2),
    "min": (2, 20),
    "max": (2, 20),
    "where": (3, 3),
}

COMPARISONS: dict[str, Callable[[Any, Any], Any]] = {
    "<": operator.lt,
    "<=": operator.le,
    ">": operator.gt,
    ">=": operator.ge,
    "==": operator.eq,
    "!=": operator.ne,
}

ARITHMETIC: dict[str, Callable[[Any, Any], Any]] = {
    "+": operator.add,
    "-": operator.sub,
    "*": operator.mul,
    "/": operator.truediv,
    "**": operator.pow,
}

# math.pow and not **: a negative base with a broken exponent is an error there, not a complex number.
FLOAT_ARITHMETIC: dict[str, Callable[[float, float], float]] = {**ARITHMETIC, "**": math.pow}

FLOAT_FUNCTIONS: dict[str, Callable[..., float]] = {
    **{name: getattr(math, name) for name in ("sin", "cos", "tan", "asin", "acos", "atan", "atan2")},
    **{name: getattr(math, name) for name in ("sinh", "cosh", "tanh", "exp", "log", "sqrt")},
    "abs": abs,
    "sign": lambda x: float((x > 0) - (x < 0)),
    "step": lambda x: float(x >= 0),
    "min": min,
    "max": max,
}

CASADI_FUNCTIONS: dict[str, Callable[..., ca.SX]] = {
    **{name: getattr(ca, name) for name in ("sin", "cos", "tan", "asin", "acos", "atan", "atan2")},
    **{name: getattr(ca, name) for name in ("sinh", "cosh", "tanh", "exp", "log", "sqrt", "sign")},
    "abs": ca.fabs,
    "step": lambda x: x >= 0,
    "min": lambda *values: reduce(ca.fmin, values),
    "max": lambda *values: reduce(ca.fmax, values),
}


def table_name(table: str) -> str:
    """The entry of an environment that is a table: a function of one number."""
    return f"table {table}"


def float_value(node: Node, env: Mapping[str, Any]) -> float:
    """The number ``node`` stands for; only the chosen branch of a ``where`` is evaluated.

    Raises ArithmeticError, ValueError (outside a function's domain) or KeyError (a name without a value).
    """
    match node:
        case Constant(value):
            return value
        case NamedValue(name):
            return float(env[name])
        case Negative(operand):
            return -float_value(operand, env)
        case Binary(sign, left, right):
            return FLOAT_ARITHMETIC[sign](float_value(left, env), float_value(right, env))
        case FunctionCall(function, arguments):
            return FLOAT_FUNCTIONS[function](*(float_value(part, env) for part in arguments))
        case TableValue(table, argument):
            return float(env[table_name(table)](float_value(argument, env)))
        case Where(condition, chosen, otherwise):
            return float_value(chosen if _float_condition(condition, env) else otherwise, env)


def _float_condition(condition: Condition, env: Mapping[str, Any]) -> bool:
    values = [float_value(part, env) for part in condition.operands]
    pairs = zip(condition.operators, values[:-1], values[1:], strict=True)
    return all(COMPARISONS[sign](left, right) for sign, left, right in pairs)


def casadi_value(node: Node, env: Mapping[str, Any]) -> ca.SX:
    """The CasADi expression ``node`` stands for. Raises KeyError for a name that ``env`` does not hold."""
    match node:
        case Constant(value):
            return ca.SX(value)
        case NamedValue(name):
            return ca.SX(env[name])
        case Negative(operand):
            return -casadi_value(operand, env)
        case Binary(sign, left, right):
            return ca.SX(ARITHMETIC[sign](casadi_value(left, env), casadi_value(right, env)))
        case FunctionCall(function, arguments):
            return CASADI_FUNCTIONS[function](*(casadi_value(part, env) for part in arguments))
        case TableValue(table, argument):
            return ca.SX(env[table_name(table)](casadi_value(argument, env)))
        case Where(condition, chosen, otherwise):
            holds = _casadi_condition(condition, env)
            return ca.if_else(holds, casadi_value(chosen, env), casadi_value(otherwise, env))


def _casadi_condition(condition: Condition, env: Mapping[str, Any]) -> ca.SX:
    values = [casadi_value(part, env) for part in condition.operands]
    pairs = zip(condition.operators, values[:-1], values[1:], strict=True)
    return ca.SX(reduce(ca.logic_and, (COMPARISONS[sign](left, right) for sign, left, right in pairs)))
