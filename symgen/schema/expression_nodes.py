"""The immutable tree an expression is parsed into."""

from __future__ import annotations

from dataclasses import dataclass


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
    """A function of the table in `expression_values` with its arguments."""

    function: str
    arguments: tuple[Node, ...]


@dataclass(frozen=True)
class TableValue:
    """What a declared table gives at an argument."""

    table: str
    argument: Node


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
