"""An SX Function as straight-line code: one list of nodes in single assignment. Printed as Python or as C."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import casadi as ca


class Node(NamedTuple):
    """One value: an input entry (op OP_INPUT: a = argument, b = entry), a constant, or op(a[, b]) of nodes."""

    op: int
    a: int
    b: int
    value: float


@dataclass(frozen=True)
class Tape:
    """Nodes in an order in which each uses earlier ones only; outputs[k] lists the node of every entry."""

    input_names: list[str]
    input_sizes: list[int]
    output_names: list[str]
    output_shapes: list[tuple[int, int]]
    nodes: list[Node]
    outputs: list[list[int]]

    @property
    def operations(self) -> int:
        """How many operations one evaluation takes: arithmetic, without reading inputs and writing outputs."""
        return sum(node.op not in (ca.OP_INPUT, ca.OP_CONST) for node in self.nodes)

    @property
    def instructions(self) -> int:
        """CasADi's count for the Function this tape came from, in which constants, loads and stores are too."""
        return len(self.nodes) + sum(len(entries) for entries in self.outputs)


BINARY = frozenset(
    (
        ca.OP_ADD,
        ca.OP_SUB,
        ca.OP_MUL,
        ca.OP_DIV,
        ca.OP_POW,
        ca.OP_CONSTPOW,
        ca.OP_LT,
        ca.OP_LE,
        ca.OP_EQ,
        ca.OP_NE,
        ca.OP_AND,
        ca.OP_OR,
        ca.OP_FMIN,
        ca.OP_FMAX,
        ca.OP_ATAN2,
        ca.OP_FMOD,
        ca.OP_COPYSIGN,
        ca.OP_IF_ELSE_ZERO,
        ca.OP_HYPOT,
    )
)
UNUSED = -1


def read_tape(function: ca.Function) -> Tape:
    """The tape of an SX Function, structural zeros of its outputs as the number 0.

    Raises ValueError for any other kind of Function.
    """
    if not function.is_a("SXFunction"):
        raise ValueError(f"{function.name()}: only a Function of SX expressions has a tape")
    shapes = [function.size_out(k) for k in range(function.n_out())]
    found = [[UNUSED] * function.nnz_out(k) for k in range(function.n_out())]
    nodes = _read_nodes(function, found)
    outputs = [_dense(function.sparsity_out(k), entries, nodes) for k, entries in enumerate(found)]
    return Tape(
        function.name_in(),
        [function.nnz_in(k) for k in range(function.n_in())],
        function.name_out(),
        shapes,
        nodes,
        outputs,
    )


def _dense(pattern: ca.Sparsity, entries: list[int], nodes: list[Node]) -> list[int]:
    """All entries of an output, column by column, from those of its pattern."""
    if pattern.is_dense():
        return entries
    zero = Node(ca.OP_CONST, UNUSED, UNUSED, 0.0)
    if nodes[-1:] != [zero]:
        nodes.append(zero)
    result = [len(nodes) - 1] * pattern.numel()
    for place, entry in zip(pattern.find(), entries, strict=True):
        result[place] = entry
    return result


def _read_nodes(function: ca.Function, outputs: list[list[int]]) -> list[Node]:
    holder: dict[int, int] = {}  # work register -> node that it holds now
    nodes: list[Node] = []
    operation, inputs, result_of = function.instruction_id, function.instruction_input, function.instruction_output
    for k in range(function.n_instructions()):
        op = operation(k)
        if op in BINARY:  # most of them
            a, b = inputs(k)
            node = Node(op, holder[a], holder[b], 0.0)
        elif op == ca.OP_CONST:
            node = Node(op, UNUSED, UNUSED, function.instruction_constant(k))
        elif op == ca.OP_INPUT:
            argument, entry = inputs(k)
            node = Node(op, argument, entry, 0.0)
        elif op == ca.OP_OUTPUT:
            result, entry = result_of(k)
            outputs[result][entry] = holder[inputs(k)[0]]
            continue
        else:
            node = Node(op, holder[inputs(k)[0]], UNUSED, 0.0)
        holder[result_of(k)[0]] = len(nodes)
        nodes.append(node)
    return nodes


def node_value(node: Node, values: list[ca.SX], entries: list[ca.SX]) -> ca.SX:
    """The SX of a node from those of earlier nodes, and from the entries of its argument if it is an input."""
    if node.op == ca.OP_CONST:
        return ca.SX(node.value)
    if node.op == ca.OP_INPUT:
        return entries[node.b]
    if node.b == UNUSED:
        return ca.SX.unary(node.op, values[node.a])
    return ca.SX.binary(node.op, values[node.a], values[node.b])


def as_function(name: str, tape: Tape) -> ca.Function:
    """The SX Function of a tape, with CasADi's own simplifications."""
    inputs = [ca.SX.sym(label, size) for label, size in zip(tape.input_names, tape.input_sizes, strict=True)]
    entries = [ca.vertsplit(value) if value.numel() else [] for value in inputs]
    values: list[ca.SX] = []
    for node in tape.nodes:
        values.append(node_value(node, values, entries[node.a] if node.op == ca.OP_INPUT else []))
    outputs = [
        ca.densify(_matrix(values, found, shape, tape.nodes))
        for found, shape in zip(tape.outputs, tape.output_shapes, strict=True)
    ]
    return ca.Function(name, inputs, outputs, tape.input_names, tape.output_names)


def _matrix(values: list[ca.SX], found: list[int], shape: tuple[int, int], nodes: list[Node]) -> ca.SX:
    """An output, its zeros left out."""
    kept = [place for place, entry in enumerate(found) if nodes[entry].op != ca.OP_CONST or nodes[entry].value != 0.0]
    pattern = ca.Sparsity.nonzeros(*shape, kept) if kept else ca.Sparsity(*shape)
    return ca.SX(pattern, ca.vertcat(*(values[found[place]] for place in kept)) if kept else ca.SX(0, 1))


def arithmetic(function: ca.Function) -> int:
    """Operations of a Function: `Tape.operations` of its tape."""
    moves = (ca.OP_INPUT, ca.OP_OUTPUT, ca.OP_CONST, ca.OP_PARAMETER)
    return sum(function.instruction_id(k) not in moves for k in range(function.n_instructions()))


def uses(tape: Tape) -> list[int]:
    """How often each node is used, as an argument or as an output entry."""
    count = [0] * len(tape.nodes)
    for node in tape.nodes:
        if node.op not in (ca.OP_INPUT, ca.OP_CONST):
            count[node.a] += 1
            if node.b != UNUSED:
                count[node.b] += 1
    for entries in tape.outputs:
        for entry in entries:
            count[entry] += 1
    return count
