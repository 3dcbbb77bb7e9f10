"""Where an expression jumps or kinks: the values that change their sign there, read off its tree."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import reduce
from typing import Any

import casadi as ca

from symgen.scene.tables import CurveTable
from symgen.schema.expression_nodes import Binary, Condition, FunctionCall, Negative, Node, TableValue, Where
from symgen.schema.expression_values import casadi_value

MOST_POINTS = 100  # of a table: one with more is taken to be smooth


def switching_values(node: Node, env: Mapping[str, Any]) -> Iterator[ca.SX]:
    """What changes sign where the expression jumps or kinks, inner conditions first, tables left out.

    Of `where` the two sides of each comparison, of `step`, `sign` and `abs` the argument, of `min` and `max` the
    distance to the least and largest of those before. Raises KeyError for a name that env does not hold.
    """
    for part in _parts(node):
        yield from switching_values(part, env)
    match node:
        case Where(condition, _, _):
            values = [casadi_value(part, env) for part in condition.operands]
            yield from (left - right for left, right in zip(values, values[1:], strict=False))
        case FunctionCall("step" | "sign" | "abs", (argument,)):
            yield casadi_value(argument, env)
        case FunctionCall("min" | "max" as name, arguments):
            values = [casadi_value(part, env) for part in arguments]
            extreme = ca.fmin if name == "min" else ca.fmax
            yield from (values[k] - reduce(extreme, values[:k]) for k in range(1, len(values)))


def knot_values(node: Node, env: Mapping[str, Any], tables: Mapping[str, CurveTable]) -> Iterator[ca.SX]:
    """What changes sign where the tables of the expression kink: their arguments, from their points."""
    for part in _parts(node):
        yield from knot_values(part, env, tables)
    if isinstance(node, TableValue):
        x = casadi_value(node.argument, env)
        yield from (x - tables[node.table].x[k] for k in _kinks(tables[node.table]))


def _parts(node: Node | Condition) -> tuple[Node, ...]:
    match node:
        case Negative(operand):
            return (operand,)
        case Binary(_, left, right):
            return (left, right)
        case FunctionCall(_, arguments):
            return arguments
        case Where(condition, chosen, otherwise):
            return (*condition.operands, chosen, otherwise)
        case TableValue(_, argument):
            return (argument,)
    return ()


def _kinks(table: CurveTable) -> Sequence[int]:
    """Points: all of lines and of monotone pieces; of a natural spline the ends, if it is held there."""
    count = len(table.x)
    if table.interpolation == "cubic":
        return () if table.outside == "extend" else (0, count - 1)
    return range(count) if count <= MOST_POINTS else ()
