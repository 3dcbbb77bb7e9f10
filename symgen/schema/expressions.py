"""The expression language of scene text: our own parser, which executes nothing.

Python's `ast` reads the text; only the nodes in the tables below pass. Numbers, + - * / **, unary - and +,
parentheses, ``pi``, ``t`` and declared names, the functions of `ARITY`. Comparisons (also
chained, ``0 <= t < 1``) stand only in the first argument of ``where(condition, a, b)``, and text only as the name of a
declared table, ``table("name", x)`` or ``table("name", x, y)``.

The immutable tree an expression is parsed into.

What an expression's operators and functions mean, in CasADi: numbers are constants there.
"""

from __future__ import annotations

import ast
import math
import operator
import re
import warnings
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import reduce
from typing import Any

import casadi as ca

from symgen.schema.errors import SceneError, did_you_mean, show

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

CASADI_FUNCTIONS: dict[str, Callable[..., ca.SX]] = {
    **{name: getattr(ca, name) for name in ("sin", "cos", "tan", "asin", "acos", "atan", "atan2")},
    **{name: getattr(ca, name) for name in ("sinh", "cosh", "tanh", "exp", "log", "sqrt", "sign")},
    "abs": ca.fabs,
    "step": lambda x: x >= 0,
    "min": lambda *values: reduce(ca.fmin, values),
    "max": lambda *values: reduce(ca.fmax, values),
}


def table_name(table: str, takes: int = 1) -> str:
    """The entry of an environment that is a table: a function of so many numbers."""
    return f"table {table}" if takes == 1 else f"table {table} of {takes}"


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
        case TableValue(table, arguments):
            symbols = [casadi_value(part, env) for part in arguments]
            return ca.SX(env[table_name(table, len(symbols))](*symbols))
        case Where(condition, chosen, otherwise):
            holds = _casadi_condition(condition, env)
            return ca.if_else(holds, casadi_value(chosen, env), casadi_value(otherwise, env))


def _casadi_condition(condition: Condition, env: Mapping[str, Any]) -> ca.SX:
    values = [casadi_value(part, env) for part in condition.operands]
    pairs = zip(condition.operators, values[:-1], values[1:], strict=True)
    return ca.SX(reduce(ca.logic_and, (COMPARISONS[sign](left, right) for sign, left, right in pairs)))


@dataclass(frozen=True)
class Constant:
    """A number."""

    value: float


@dataclass(frozen=True)
class NamedValue:
    """A declared name, or ``t``."""

    name: str


@dataclass(frozen=True)
class Negative:
    """Minus one operand."""

    operand: Node


@dataclass(frozen=True)
class Binary:
    """``left operator right`` with one of + - * / **."""

    operator: str
    left: Node
    right: Node


@dataclass(frozen=True)
class FunctionCall:
    """A function of the table `ARITY` with its arguments."""

    function: str
    arguments: tuple[Node, ...]


@dataclass(frozen=True)
class TableValue:
    """What a declared table gives at its one or two arguments."""

    table: str
    arguments: tuple[Node, ...]


@dataclass(frozen=True)
class Condition:
    """Comparisons ``operands[k] operators[k] operands[k + 1]``, all of which must hold."""

    operators: tuple[str, ...]
    operands: tuple[Node, ...]


@dataclass(frozen=True)
class Where:
    """``chosen`` where the condition holds, ``otherwise`` elsewhere."""

    condition: Condition
    chosen: Node
    otherwise: Node


Node = Constant | NamedValue | Negative | Binary | FunctionCall | TableValue | Where


MAX_CHARACTERS = 10_000
MAX_DEPTH = 100
RESERVED = frozenset({"t", "pi", "table", *ARITY})

_OPERATORS: dict[type[ast.operator], str] = {
    ast.Add: "+", ast.Sub: "-", ast.Mult: "*", ast.Div: "/", ast.Pow: "**",
}  # fmt: skip
_COMPARISONS: dict[type[ast.cmpop], str] = {
    ast.Lt: "<", ast.LtE: "<=", ast.Gt: ">", ast.GtE: ">=", ast.Eq: "==", ast.NotEq: "!=",
}  # fmt: skip
_HINTS = {
    "^": "write a power with **",
    "[": "indexing and lists are not part of the language; use declared names",
    "{": "sets and dictionaries are not part of the language; use declared names",
    ":": "only arithmetic is allowed; functions cannot be defined here",
    "%": "the remainder operator is not part of the language",
    '"': "text inside an expression is not allowed; use declared names",
    "'": "text inside an expression is not allowed; use declared names",
}


@dataclass(frozen=True)
class Expression:
    """A parsed expression. ``names``: the parameters, measures, tables and ``t`` it uses (not ``pi``)."""

    text: str
    item: str
    node: Node
    names: frozenset[str]

    def to_casadi(self, env: Mapping[str, Any]) -> ca.SX:
        """The expression by what ``env`` has for names; raises SceneError when it lacks one that is used."""
        missing = sorted(self.names - env.keys())
        if missing:
            raise SceneError(self.item, f"nothing was given for '{missing[0]}'", "declare it as a parameter")
        return ca.SX(casadi_value(self.node, env))

    def evaluate(self, env: Mapping[str, Any]) -> float:
        """The expression as a number; raises SceneError when it is not finite or ``env`` lacks a name."""
        value = float(ca.evalf(self.to_casadi(env)))
        if not math.isfinite(value):
            problem = f"'{_short(self.text)}' has no finite value ({value})"
            remedy = "look for a division by zero or what has no root or logarithm, at t = 0 and default parameters"
            raise SceneError(self.item, problem, remedy)
        return value


def parse_expression(text: str | float, names: frozenset[str], item: str) -> Expression:
    """Parse ``text`` (or a plain number) that may use ``names``; ``t`` only if it is among them.

    Raises SceneError, with ``item`` as its item, for everything outside the language.
    """
    if not isinstance(text, str):
        return Expression(repr(text), item, Constant(_finite(text, item)), frozenset())
    node = _Reader(names, item).node(_syntax(text, item), 0)
    return Expression(text, item, node, frozenset(_names(node)))


def _syntax(text: str, item: str) -> ast.expr:
    if len(text) > MAX_CHARACTERS:
        remedy = f"shorten it to at most {MAX_CHARACTERS}, for instance with parameters"
        raise SceneError(item, f"the expression has {len(text)} characters", remedy)
    if not text.strip():
        raise SceneError(item, "the expression is empty", "give a number or an expression")
    bad = re.search(r"[^A-Za-z0-9_.+\-*/(),<>=! \t\r\n]", _OF_TABLE.sub("table(", text))
    if bad:
        hint = _HINTS.get(bad.group(), "use plain arithmetic, declared names and the listed functions")
        raise SceneError(item, f"the character {bad.group()!r} is not allowed in '{_short(text)}'", hint)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            return ast.parse(text.strip(), mode="eval").body
    except (MemoryError, RecursionError):
        raise _too_deep(item) from None
    except (SyntaxError, ValueError) as error:
        if "too many nested" in str(error):
            raise _too_deep(item) from None
        reason = error.msg if isinstance(error, SyntaxError) else str(error)
        problem = f"'{_short(text)}' is not an expression ({reason})"
        if _WITH_UNIT.fullmatch(text.strip()):
            remedy = f"write the number alone: all are in SI units (m, kg, s, N, rad), here {text.split()[0]}"
            raise SceneError(item, f"'{_short(text)}' is a number with a unit", remedy) from None
        raise SceneError(item, problem, "check brackets and operators") from None


_OF_TABLE = re.compile(r"""\btable\s*\(\s*(?:"\w{1,64}"|'\w{1,64}')""")  # the only place for text
_WITH_UNIT = re.compile(r"[-+]?[0-9.]+(?:[eE][-+]?[0-9]+)?\s+[A-Za-z][A-Za-z0-9 /*()-]*")  # such as 3.0 kg, 2 N/m


class _Reader:
    """Turns the syntax tree into ours, refusing every node that is not listed here."""

    def __init__(self, names: frozenset[str], item: str) -> None:
        self.names = names
        self.item = item

    def node(self, tree: ast.expr, depth: int) -> Node:
        if depth > MAX_DEPTH:
            raise _too_deep(self.item)
        match tree:
            case ast.Constant(value=value) if isinstance(value, int | float) and not isinstance(value, bool):
                return Constant(_finite(value, self.item))
            case ast.Name(id=name):
                return self._symbol(name)
            case ast.UnaryOp(op=ast.USub(), operand=operand):
                return Negative(self.node(operand, depth + 1))
            case ast.UnaryOp(op=ast.UAdd(), operand=operand):
                return self.node(operand, depth + 1)
            case ast.BinOp(op=sign) if type(sign) in _OPERATORS:
                left, right = self.node(tree.left, depth + 1), self.node(tree.right, depth + 1)
                return Binary(_OPERATORS[type(sign)], left, right)
            case ast.Call(func=ast.Name(id=function), args=arguments, keywords=keywords):
                return self._call(function, arguments, bool(keywords), depth)
            case ast.Attribute(value=ast.Name(id=item), attr=name):
                raise self._error(
                    f"'{_short(f'{item}.{name}')}' cannot be read in an expression",
                    "declare a measure of it, and use the measure's name and its rate <measure>_dot",
                )
            case ast.IfExp(test=test, body=body, orelse=orelse):
                parts = ", ".join(_short(ast.unparse(part)) for part in (test, body, orelse))
                raise self._error("if and else are not part of the language", f"write where({parts})")
            case ast.Compare():
                raise self._error("a comparison stands outside of where()", "write where(condition, a, b)")
        kind = type(tree.value if isinstance(tree, ast.Constant) else tree).__name__
        raise self._error(f"{kind} is not part of the language", "use arithmetic, declared names and functions")

    def _symbol(self, name: str) -> Node:
        if name == "pi":
            return Constant(math.pi)
        if name in self.names:
            return NamedValue(name)
        if name == "t":
            raise self._error("t is not available here", "this quantity must be constant in time")
        if name in ARITY:
            raise self._error(f"the function '{name}' is used without arguments", f"write {name}(...)")
        known = sorted({each for each in self.names if " " not in each} | {"pi"}) + sorted(ARITY)
        raise self._error(f"unknown name '{_short(name)}'", f"{did_you_mean(name, known)} Otherwise declare it")

    def _call(self, function: str, arguments: list[ast.expr], keywords: bool, depth: int) -> Node:
        if function == "table":
            return self._table(arguments, keywords, depth)
        if function not in ARITY:
            raise self._error(
                f"unknown function '{_short(function)}'", did_you_mean(function, sorted([*ARITY, "table"]))
            )
        low, high = ARITY[function]
        if keywords or not low <= len(arguments) <= high:
            count = str(low) if low == high else f"{low} to {high}"
            problem = f"{function}() takes {count} plain argument(s)"
            raise self._error(problem, f"call it with {count}; keywords are not allowed")
        if function == "where":
            condition = self._condition(arguments[0], depth + 1)
            return Where(condition, *(self.node(part, depth + 1) for part in arguments[1:]))
        return FunctionCall(function, tuple(self.node(part, depth + 1) for part in arguments))

    def _table(self, arguments: list[ast.expr], keywords: bool, depth: int) -> Node:
        match arguments:
            case [ast.Constant(value=str(name)), _, *_] if not keywords and len(arguments) <= 3:
                takes = len(arguments) - 1
                if table_name(name, takes) in self.names:
                    return TableValue(name, tuple(self.node(part, depth + 1) for part in arguments[1:]))
                if table_name(name, 3 - takes) in self.names:
                    remedy = f'write table("{name}", {"x" if takes == 2 else "x, y"})'
                    raise self._error(f"the table '{name}' takes {3 - takes} value(s), not {takes}", remedy)
                first = table_name("")
                known = sorted(each.split()[1] for each in self.names if each.startswith(first))
                raise self._error(f"there is no table '{_short(name)}'", did_you_mean(name, known))
        raise self._error("table() takes the name of a table and one value, or two", 'write table("name", t)')

    def _condition(self, tree: ast.expr, depth: int) -> Condition:
        if not isinstance(tree, ast.Compare) or any(type(sign) not in _COMPARISONS for sign in tree.ops):
            raise self._error("the first argument of where() is not a comparison", "write where(t < 1, a, b)")
        operands = tuple(self.node(part, depth + 1) for part in (tree.left, *tree.comparators))
        return Condition(tuple(_COMPARISONS[type(sign)] for sign in tree.ops), operands)

    def _error(self, problem: str, remedy: str) -> SceneError:
        return SceneError(self.item, problem, remedy)


def _names(node: Node | Condition) -> set[str]:
    match node:
        case NamedValue(name):
            return {name}
        case Negative(operand):
            return _names(operand)
        case Binary(_, left, right):
            return _names(left) | _names(right)
        case FunctionCall(_, parts) | Condition(_, parts):
            return set().union(*(_names(part) for part in parts))
        case Where(condition, chosen, otherwise):
            return _names(condition) | _names(chosen) | _names(otherwise)
        case TableValue(table, parts):
            return {table_name(table, len(parts))}.union(*(_names(part) for part in parts))
    return set()


def _finite(value: float, item: str) -> float:
    try:
        number = float(value)
    except OverflowError:
        number = math.inf
    if not math.isfinite(number):
        raise SceneError(item, f"the number {show(value)} is not finite", "use numbers below 1e308")
    return number


def _too_deep(item: str) -> SceneError:
    problem = f"the expression is nested more than {MAX_DEPTH} deep"
    return SceneError(item, problem, "group long sums with brackets, or move parts into parameters")


def _short(text: str) -> str:
    return text if len(text) <= 60 else text[:57] + "..."
