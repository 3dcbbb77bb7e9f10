"""Take everything that depends on parameters only out of the kernels: constants(p) -> c.

A run evaluates `constants` once; the kernels of a step read c. Products such as rho A L mu or composite masses
then cost nothing per step, although every physical number stays a run-time input.
"""

from __future__ import annotations

from collections.abc import Mapping
from math import isfinite

import casadi as ca

from runtime.contract.tape import UNUSED, Node, Tape, as_function, read_tape, uses
from symgen.kernels.kernel import Kernel
from symgen.system.errors import DerivationError
from symgen.tapes.expansion import shorter_form
from symgen.tapes.graph import Graph


def hoist(kernels: Mapping[str, Kernel], p: ca.SX) -> dict[str, Tape]:
    """Tapes of `constants` (p -> c) and of the kernels with c instead of p.

    Inputs that no output of a kernel uses are dropped. Raises DerivationError for a constant that is not finite.
    """
    graph = Graph()
    graphed = {name: _Graphed(kernel, graph, p) for name, kernel in kernels.items()}
    position: dict[int, int] = {}
    for kernel in graphed.values():
        for node in kernel.hoisted():
            position.setdefault(node, len(position))
    return {
        "constants": _constants(graph, position, p.numel()),
        **{name: kernel.rebuilt(position) for name, kernel in graphed.items()},
    }


def _constants(graph: Graph, position: Mapping[int, int], p_size: int) -> Tape:
    live = graph.below(list(position), stop_at_p=False)
    number = {node: k for k, node in enumerate(live)}
    nodes = [_renumbered(graph.nodes[k], number, {0: 0}) for k in live]
    tape = Tape(["p"], [p_size], ["c"], [(len(position), 1)], nodes, [[number[node] for node in position]])
    simplified = read_tape(as_function("constants", tape))  # as CasADi will when it loads the emitted text
    return tape if simplified.operations == tape.operations else simplified


def _renumbered(node: Node, number: Mapping[int, int], arguments: Mapping[int, int]) -> Node:
    if node.op == ca.OP_CONST:
        return node
    if node.op == ca.OP_INPUT:
        return Node(node.op, arguments[node.a], node.b, 0.0)
    return Node(node.op, number[node.a], UNUSED if node.b == UNUSED else number[node.b], 0.0)


class _Graphed:
    """One kernel as nodes of the common graph."""

    def __init__(self, kernel: Kernel, graph: Graph, p: ca.SX) -> None:
        self.graph = graph
        self.tape = Kernel({**kernel.inputs, "p": p}, kernel.outputs).tape()
        first = graph.new_arguments(len(self.tape.input_names))
        self.arguments = {
            position: 0 if name == "p" else first + position for position, name in enumerate(self.tape.input_names)
        }
        numbers: list[int] = []
        for node, count in zip(self.tape.nodes, uses(self.tape), strict=True):
            numbers.append(self._entered(node, numbers))
            if count > 1:
                graph.shared.add(numbers[-1])
        factored = [[numbers[entry] for entry in entries] for entries in self.tape.outputs]
        self.outputs = shorter_form(graph, factored)
        self.live = graph.below([entry for entries in self.outputs for entry in entries], stop_at_p=True)

    def _entered(self, node: Node, numbers: list[int]) -> int:
        if node.op == ca.OP_CONST:
            if not isfinite(node.value):
                raise DerivationError(
                    "expressions",
                    "a motion, load or quantity contains a division by zero or a logarithm "
                    "of a number that is not positive",
                    "correct the expression, also in the branches of where() that are not taken",
                )
            return self.graph.constant(node.value)
        if node.op == ca.OP_INPUT:
            argument = self.arguments[node.a]
            return self.graph.entry(argument, node.b, argument == 0)
        return self.graph.apply(node.op, numbers[node.a], UNUSED if node.b == UNUSED else numbers[node.b])

    def hoisted(self) -> list[int]:
        """Maximal parameter-only nodes of this kernel that are not plain numbers."""
        return [k for k in self.live if self.graph.of_p[k] and self.graph.nodes[k].op != ca.OP_CONST]

    def rebuilt(self, position: Mapping[int, int]) -> Tape:
        """The kernel's tape with c as its last input."""
        graph, tape = self.graph, self.tape
        used = {graph.nodes[k].a for k in self.live if graph.nodes[k].op == ca.OP_INPUT}
        kept = [k for k, name in enumerate(tape.input_names) if name != "p" and self.arguments[k] in used]
        arguments = {self.arguments[k]: new for new, k in enumerate(kept)}
        names, sizes = [tape.input_names[k] for k in kept], [tape.input_sizes[k] for k in kept]
        number = {node: k for k, node in enumerate(self.live)}
        c_entries = set(self.hoisted())
        nodes = [
            Node(ca.OP_INPUT, len(kept), position[k], 0.0)
            if k in c_entries
            else _renumbered(graph.nodes[k], number, arguments)
            for k in self.live
        ]
        if c_entries:
            names, sizes = [*names, "c"], [*sizes, len(position)]
        outputs = [[number[entry] for entry in entries] for entries in self.outputs]
        return Tape(names, sizes, tape.output_names, tape.output_shapes, nodes, outputs)
