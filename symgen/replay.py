"""Rebuild SX expressions from a tape, node by node, with some nodes replaced."""

from __future__ import annotations

from collections.abc import Callable

import casadi as ca

from runtime.engine.tape import Node

_UNARY: dict[int, Callable[[ca.SX], ca.SX]] = {
    ca.OP_NEG: lambda x: -x, ca.OP_SQ: lambda x: x * x, ca.OP_TWICE: lambda x: 2 * x, ca.OP_INV: lambda x: 1 / x,
    ca.OP_SQRT: ca.sqrt, ca.OP_EXP: ca.exp, ca.OP_LOG: ca.log, ca.OP_SIN: ca.sin, ca.OP_COS: ca.cos,
    ca.OP_TAN: ca.tan, ca.OP_ASIN: ca.asin, ca.OP_ACOS: ca.acos, ca.OP_ATAN: ca.atan, ca.OP_SINH: ca.sinh,
    ca.OP_COSH: ca.cosh, ca.OP_TANH: ca.tanh, ca.OP_FABS: ca.fabs, ca.OP_SIGN: ca.sign, ca.OP_FLOOR: ca.floor,
    ca.OP_CEIL: ca.ceil, ca.OP_NOT: ca.logic_not, ca.OP_ASSIGN: lambda x: x,
}
_BINARY: dict[int, Callable[[ca.SX, ca.SX], ca.SX]] = {
    ca.OP_ADD: lambda x, y: x + y, ca.OP_SUB: lambda x, y: x - y, ca.OP_MUL: lambda x, y: x * y,
    ca.OP_DIV: lambda x, y: x / y, ca.OP_POW: lambda x, y: x**y, ca.OP_CONSTPOW: lambda x, y: x**y,
    ca.OP_LT: lambda x, y: x < y, ca.OP_LE: lambda x, y: x <= y, ca.OP_EQ: lambda x, y: x == y,
    ca.OP_NE: lambda x, y: x != y, ca.OP_AND: ca.logic_and, ca.OP_OR: ca.logic_or, ca.OP_FMIN: ca.fmin,
    ca.OP_FMAX: ca.fmax, ca.OP_ATAN2: ca.atan2, ca.OP_FMOD: ca.fmod,
    ca.OP_IF_ELSE_ZERO: lambda c, x: ca.if_else(c, x, 0),
}


def apply(node: Node, first: ca.SX, second: ca.SX | None) -> ca.SX:
    """SX value of a node at the values of its arguments."""
    if second is None:
        return _UNARY[node.op](first)
    return _BINARY[node.op](first, second)
