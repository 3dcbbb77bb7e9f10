"""Take everything that depends on parameters only out of the kernels: constants(p) -> c.

A run evaluates `constants` once; the kernels of a step read c. Products such as rho A L mu or composite masses
then cost nothing per step, although every physical number stays a run-time input.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import casadi as ca

from runtime.engine.tape import UNUSED, Node, Tape, read_tape, uses
from symgen.graph import Graph


@dataclass(frozen=True)
class Kernel:
    """A function to be: named SX inputs and named dense outputs."""

    inputs: dict[str, ca.SX]
    outputs: dict[str, ca.SX]

    def function(self, name: str) -> ca.Function:
        """The CasADi Function with named inputs and outputs, common subexpressions shared."""
        outputs = ca.cse([ca.densify(value) for value in self.outputs.values()])
        return ca.Function(name, list(self.inputs.values()), outputs, list(self.inputs), list(self.outputs))


def hoist(kernels: Mapping[str, Kernel], p: ca.SX) -> tuple[Kernel, dict[str, Kernel]]:
    """(constants: p -> c, kernels with c instead of p). Inputs that no output of a kernel uses are dropped."""
    graph = Graph()
    inputs: list[ca.SX] = [p]
    graphed = {name: _Graphed(kernel, graph, inputs, p) for name, kernel in kernels.items()}
    position: dict[int, int] = {}
    for kernel in graphed.values():
        for node in kernel.hoisted():
            position.setdefault(node, len(position))
    c = ca.SX.sym("c", len(position))
    builder = _Builder(graph, inputs, {})
    constants = Kernel({"p": p}, {"c": ca.vertcat(*(builder.value(node) for node in position))})
    symbols = dict(zip(position, ca.vertsplit(c) if position else [], strict=True))
    return constants, {name: kernel.rebuilt(inputs, symbols, c) for name, kernel in graphed.items()}


class _Graphed:
    """One kernel as nodes of the common graph."""

    def __init__(self, kernel: Kernel, graph: Graph, inputs: list[ca.SX], p: ca.SX) -> None:
        self.graph, self.source = graph, kernel
        names = {**kernel.inputs, "p": p}
        self.tape: Tape = read_tape(Kernel(names, kernel.outputs).function("kernel"))
        first = len(inputs)
        inputs += list(kernel.inputs.values())
        arguments = {position: 0 if name == "p" else first + list(kernel.inputs).index(name)
                     for position, name in enumerate(self.tape.input_names)}
        numbers: list[int] = []
        for node, count in zip(self.tape.nodes, uses(self.tape), strict=True):
            numbers.append(self._place(node, numbers, arguments))
            if count > 1:
                graph.shared.add(numbers[-1])
        self.outputs = [[numbers[entry] for entry in entries] for entries in self.tape.outputs]
        self.live = self._reachable()

    def _place(self, node: Node, numbers: list[int], arguments: dict[int, int]) -> int:
        if node.op == ca.OP_CONST:
            return self.graph.constant(node.value)
        if node.op == ca.OP_INPUT:
            argument = arguments[node.a]
            return self.graph.entry(argument, node.b, argument == 0)
        return self.graph.apply(node.op, numbers[node.a], UNUSED if node.b == UNUSED else numbers[node.b])

    def _reachable(self) -> list[int]:
        """Nodes below the outputs in ascending order, not going below parameter-only ones."""
        seen: set[int] = set()
        stack = [entry for entries in self.outputs for entry in entries]
        while stack:
            k = stack.pop()
            if k in seen:
                continue
            seen.add(k)
            node = self.graph.nodes[k]
            if not self.graph.of_p[k] and node.op != ca.OP_INPUT:
                stack += [node.a] if node.b == UNUSED else [node.a, node.b]
        return sorted(seen)

    def hoisted(self) -> list[int]:
        """Maximal parameter-only nodes of this kernel that are not plain numbers."""
        return [k for k in self.live if self.graph.of_p[k] and self.graph.nodes[k].op != ca.OP_CONST]

    def rebuilt(self, inputs: list[ca.SX], symbols: dict[int, ca.SX], c: ca.SX) -> Kernel:
        """The kernel with c as its last input."""
        builder = _Builder(self.graph, inputs, symbols)
        outputs = {}
        for name, shape, entries in zip(self.tape.output_names, self.tape.output_shapes, self.outputs, strict=True):
            outputs[name] = ca.reshape(ca.vertcat(*(builder.value(entry) for entry in entries)), *shape)
        used = {name: symbol for name, symbol in self.source.inputs.items()
                if any(symbol is inputs[argument] for argument in builder.arguments)}
        if any(k in symbols for k in self.live):
            used["c"] = c
        return Kernel(used, outputs)


class _Builder:
    """SX values of graph nodes; `symbols` replaces some of them."""

    def __init__(self, graph: Graph, inputs: list[ca.SX], symbols: Mapping[int, ca.SX]) -> None:
        self.graph, self.inputs = graph, inputs
        self.values: dict[int, ca.SX] = dict(symbols)
        self.arguments: set[int] = set()
        self._entries: dict[int, list[ca.SX]] = {}

    def value(self, root: int) -> ca.SX:
        """SX of a node, building what it needs without recursion."""
        stack = [root]
        while stack:
            k = stack[-1]
            if k in self.values:
                stack.pop()
                continue
            node = self.graph.nodes[k]
            if node.op == ca.OP_CONST:
                self.values[k] = ca.SX(node.value)
            elif node.op == ca.OP_INPUT:
                self.values[k] = self._entry(node)
            else:
                needed = [node.a] if node.b == UNUSED else [node.a, node.b]
                missing = [a for a in needed if a not in self.values]
                if missing:
                    stack += missing
                    continue
                arguments = [self.values[a] for a in needed]
                combine = ca.SX.unary if node.b == UNUSED else ca.SX.binary
                self.values[k] = combine(node.op, *arguments)
            stack.pop()
        return self.values[root]

    def _entry(self, node: Node) -> ca.SX:
        self.arguments.add(node.a)
        if node.a not in self._entries:
            self._entries[node.a] = ca.vertsplit(self.inputs[node.a])
        return self._entries[node.a][node.b]
