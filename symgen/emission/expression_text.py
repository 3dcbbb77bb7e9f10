"""A tape as readable Python statements: values used once are written in place, the rest get a name."""

from __future__ import annotations

from collections.abc import Mapping

import casadi as ca

from runtime.contract.tables import marked
from runtime.contract.tape import UNUSED, Node, Tape, uses

LONGEST_INLINE = 96
_ATOM, _POWER, _UNARY, _PRODUCT, _SUM, _COMPARE = 6, 5, 4, 3, 2, 1

_INFIX = {
    ca.OP_ADD: ("+", _SUM),
    ca.OP_SUB: ("-", _SUM),
    ca.OP_MUL: ("*", _PRODUCT),
    ca.OP_DIV: ("/", _PRODUCT),
    ca.OP_LT: ("<", _COMPARE),
    ca.OP_LE: ("<=", _COMPARE),
    ca.OP_EQ: ("==", _COMPARE),
    ca.OP_NE: ("!=", _COMPARE),
}
_CALL = {
    ca.OP_SQRT: "sqrt",
    ca.OP_EXP: "exp",
    ca.OP_LOG: "log",
    ca.OP_SIN: "sin",
    ca.OP_COS: "cos",
    ca.OP_TAN: "tan",
    ca.OP_ASIN: "asin",
    ca.OP_ACOS: "acos",
    ca.OP_ATAN: "atan",
    ca.OP_SINH: "sinh",
    ca.OP_COSH: "cosh",
    ca.OP_TANH: "tanh",
    ca.OP_FABS: "fabs",
    ca.OP_SIGN: "sign",
    ca.OP_FLOOR: "floor",
    ca.OP_CEIL: "ceil",
    ca.OP_NOT: "logic_not",
    ca.OP_ATAN2: "atan2",
    ca.OP_FMIN: "fmin",
    ca.OP_FMAX: "fmax",
    ca.OP_AND: "logic_and",
    ca.OP_OR: "logic_or",
    ca.OP_FMOD: "fmod",
    ca.OP_COPYSIGN: "copysign",
    ca.OP_HYPOT: "hypot",
}


class TapeText:
    """Statements of one tape and the text of each output entry.

    labels maps an input name to the local names of its entries, tables the key of a table to its name.
    """

    def __init__(self, tape: Tape, labels: Mapping[str, list[str]], tables: Mapping[int, str]) -> None:
        self.tape = tape
        self._labels, self._tables = labels, tables
        self._uses = uses(tape)
        self._text: list[tuple[str, int]] = []
        self.statements: list[str] = []
        self.inputs_used: dict[str, set[int]] = {name: set() for name in tape.input_names}
        self._temporaries = 0
        for k, node in enumerate(tape.nodes):
            text, level = self._render(node)
            if self._needs_name(k, node, text):
                name = f"w{self._temporaries}"
                self._temporaries += 1
                self.statements.append(f"{name} = {text}")
                text, level = name, _ATOM
            self._text.append((text, level))

    def output(self, position: int) -> list[str]:
        """Texts of the entries of an output, column by column."""
        return [self._text[entry][0] for entry in self.tape.outputs[position]]

    def _needs_name(self, k: int, node: Node, text: str) -> bool:
        if node.op in (ca.OP_INPUT, ca.OP_CONST):
            return False
        return self._uses[k] > 1 or len(text) > LONGEST_INLINE

    def _child(self, k: int, level: int) -> str:
        text, own = self._text[k]
        return f"({text})" if own < level else text

    def _render(self, node: Node) -> tuple[str, int]:
        if node.op == ca.OP_CONST:
            return repr(node.value), _ATOM if node.value >= 0 else _UNARY
        if node.op == ca.OP_INPUT:
            name = self.tape.input_names[node.a]
            self.inputs_used[name].add(node.b)
            return self._labels[name][node.b], _ATOM
        if node.op in _INFIX:
            sign, level = _INFIX[node.op]
            # the right operand is bracketed at equal level, so that the order of evaluation is kept bit for bit
            return f"{self._child(node.a, level)} {sign} {self._child(node.b, level + 1)}", level
        if node.op == ca.OP_NEG:
            return f"-{self._child(node.a, _POWER)}", _UNARY
        if node.op == ca.OP_SQ:
            return f"{self._child(node.a, _ATOM)}**2", _POWER
        if node.op == ca.OP_TWICE:
            return f"2 * {self._child(node.a, _UNARY)}", _PRODUCT
        if node.op == ca.OP_INV:
            return f"1 / {self._child(node.a, _UNARY)}", _PRODUCT
        if node.op in (ca.OP_POW, ca.OP_CONSTPOW):
            return f"{self._child(node.a, _ATOM)}**{self._child(node.b, _ATOM)}", _POWER
        if node.op == ca.OP_IF_ELSE_ZERO:
            return f"ca.if_else({self._text[node.a][0]}, {self._text[node.b][0]}, 0)", _ATOM
        if node.op == ca.OP_CALL:
            table, order = marked(node.value)
            which = f'"{self._tables[table.key]}"' + (f", {order}" if order else "")
            return f"table({which})({self._text[node.a][0]})", _ATOM
        if node.op == ca.OP_ASSIGN:
            return self._text[node.a]
        arguments = [node.a] if node.b == UNUSED else [node.a, node.b]
        return f"ca.{_CALL[node.op]}({', '.join(self._text[a][0] for a in arguments)})", _ATOM
