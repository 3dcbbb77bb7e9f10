"""The expression language of scene text: our own parser, which executes nothing.

Python's `ast` reads the text; only the nodes in the tables below pass. Numbers, + - * / **, unary - and +,
parentheses, ``pi``, ``t`` and declared names, the functions of `ARITY`. Comparisons (also
chained, ``0 <= t < 1``) stand only in the first argument of ``where(condition, a, b)``, and text only as the name of a
declared table, ``table("name", x)`` or ``table("name", x, y)``.
"""

from __future__ import annotations

import ast
import math
import operator
import re
import warnings
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import reduce
from itertools import pairwise
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

OPERATIONS: dict[str, Callable[..., ca.SX]] = {  # what operators and functions mean; numbers are constants there
    **{"+": operator.add, "-": operator.sub, "*": operator.mul, "/": operator.truediv, "**": operator.pow},
    **{"<": operator.lt, "<=": operator.le, ">": operator.gt, ">=": operator.ge, "==": operator.eq, "!=": operator.ne},
    "negative": operator.neg,
    "all": lambda *holds: reduce(ca.logic_and, holds),
    "where": ca.if_else,
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


@dataclass(frozen=True)
class Node:
    """A number or a name, which is its value; or what is done with parts: an entry of OPERATIONS, or the table `value`.

    kind: "number", "name", "table", or the entry. The first part of "where" is "all" of its comparisons.
    """

    kind: str
    parts: tuple[Node, ...] = ()
    value: float | str = 0.0

    def casadi(self, env: Mapping[str, Any]) -> ca.SX:
        """The CasADi expression that it stands for. Raises KeyError for a name that ``env`` does not hold."""
        if self.kind == "number":
            return ca.SX(float(self.value))
        if self.kind == "name":
            return ca.SX(env[str(self.value)])
        return self.applied([part.casadi(env) for part in self.parts], env)

    def applied(self, given: Sequence[ca.SX], env: Mapping[str, Any]) -> ca.SX:
        """What it does with the values of its parts."""
        act = env[table_name(str(self.value), len(given))] if self.kind == "table" else OPERATIONS[self.kind]
        return ca.SX(act(*given))

    def with_definitions(self, definitions: Mapping[str, Node]) -> Node:
        """The same with what names are defined as in their place."""
        if self.kind == "name":
            return definitions.get(str(self.value), self)
        return Node(self.kind, tuple(part.with_definitions(definitions) for part in self.parts), self.value)

    def names(self) -> set[str]:
        """The entries of an environment that it uses."""
        found = set().union(*(part.names() for part in self.parts))
        if self.kind == "table":
            found.add(table_name(str(self.value), len(self.parts)))
        return found | {str(self.value)} if self.kind == "name" else found


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
    """A parsed expression. ``names``: the parameters, measures, coordinates, tables and ``t`` it uses (not ``pi``)."""

    text: str
    item: str
    node: Node
    names: frozenset[str]

    def to_casadi(self, env: Mapping[str, Any]) -> ca.SX:
        """The expression by what ``env`` has for names; raises SceneError when it lacks one that is used."""
        missing = sorted(self.names - env.keys())
        if missing:
            raise SceneError(self.item, f"nothing was given for '{missing[0]}'", "declare it as a parameter")
        return self.node.casadi(env)

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
        return Expression(repr(text), item, Node("number", value=_finite(text, item)), frozenset())
    node = _Reader(names, item).node(_syntax(text, item), 0)
    return Expression(text, item, node, frozenset(node.names()))


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
                return Node("number", value=_finite(value, self.item))
            case ast.Name(id=name):
                return self._symbol(name)
            case ast.UnaryOp(op=ast.USub(), operand=operand):
                return Node("negative", (self.node(operand, depth + 1),))
            case ast.UnaryOp(op=ast.UAdd(), operand=operand):
                return self.node(operand, depth + 1)
            case ast.BinOp(op=sign) if type(sign) in _OPERATORS:
                return Node(_OPERATORS[type(sign)], self._nodes((tree.left, tree.right), depth))
            case ast.Call(func=ast.Name(id=function), args=arguments, keywords=keywords):
                return self._call(function, arguments, bool(keywords), depth)
            case ast.Attribute() if (name := _dotted(tree)) in self.names:
                return Node("name", value=name)
            case ast.Attribute() if name := _dotted(tree):
                known = sorted(one for one in self.names if "." in one)
                if known:
                    raise self._error(f"there is no coordinate '{_short(name)}'", did_you_mean(name, known))
                raise self._error(
                    f"'{_short(name)}' cannot be read in an expression",
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
            return Node("number", value=math.pi)
        if name in self.names:
            return Node("name", value=name)
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
            return Node(function, (self._condition(arguments[0], depth + 1), *self._nodes(arguments[1:], depth)))
        return Node(function, self._nodes(arguments, depth))

    def _table(self, arguments: list[ast.expr], keywords: bool, depth: int) -> Node:
        match arguments:
            case [ast.Constant(value=str(name)), _, *_] if not keywords and len(arguments) <= 3:
                takes = len(arguments) - 1
                if table_name(name, takes) in self.names:
                    return Node("table", self._nodes(arguments[1:], depth), name)
                if table_name(name, 3 - takes) in self.names:
                    remedy = f'write table("{name}", {"x" if takes == 2 else "x, y"})'
                    raise self._error(f"the table '{name}' takes {3 - takes} value(s), not {takes}", remedy)
                first = table_name("")
                known = sorted(each.split()[1] for each in self.names if each.startswith(first))
                raise self._error(f"there is no table '{_short(name)}'", did_you_mean(name, known))
        raise self._error("table() takes the name of a table and one value, or two", 'write table("name", t)')

    def _condition(self, tree: ast.expr, depth: int) -> Node:
        if not isinstance(tree, ast.Compare) or any(type(sign) not in _COMPARISONS for sign in tree.ops):
            raise self._error("the first argument of where() is not a comparison", "write where(t < 1, a, b)")
        operands = self._nodes((tree.left, *tree.comparators), depth)
        signs = [_COMPARISONS[type(sign)] for sign in tree.ops]
        return Node("all", tuple(Node(sign, pair) for sign, pair in zip(signs, pairwise(operands), strict=True)))

    def _nodes(self, trees: Iterable[ast.expr], depth: int) -> tuple[Node, ...]:
        return tuple(self.node(tree, depth + 1) for tree in trees)

    def _error(self, problem: str, remedy: str) -> SceneError:
        return SceneError(self.item, problem, remedy)


def _finite(value: float, item: str) -> float:
    try:
        number = float(value)
    except OverflowError:
        number = math.inf
    if not math.isfinite(number):
        raise SceneError(item, f"the number {show(value)} is not finite", "use numbers below 1e308")
    return number


def _dotted(tree: ast.expr) -> str:
    """Names with dots between them, or nothing."""
    match tree:
        case ast.Name(id=name):
            return name
        case ast.Attribute(value=before, attr=name) if owner := _dotted(before):
            return f"{owner}.{name}"
    return ""


def _too_deep(item: str) -> SceneError:
    problem = f"the expression is nested more than {MAX_DEPTH} deep"
    return SceneError(item, problem, "group long sums with brackets, or move parts into parameters")


def _short(text: str) -> str:
    return text if len(text) <= 60 else text[:57] + "..."
