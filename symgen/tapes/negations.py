"""Negations taken into what they negate: -(x - y) is y - x, -(k X + y) is (-k) X - y with a parameter -k.

Only where nothing else uses the value that is negated, which is known when a kernel is complete; so no count rises.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

import casadi as ca

from runtime.contract.tape import UNUSED, below
from symgen.tapes.graph import Graph


def without_negations(graph: Graph, outputs: list[list[int]]) -> list[list[int]]:
    """The outputs with as few negations as their sums and products allow."""
    signs = _Signs(graph, [entry for entries in outputs for entry in entries])
    return [[signs.now(entry) for entry in entries] for entries in outputs]


class _Signs:
    """One pass from the inputs to the outputs."""

    def __init__(self, graph: Graph, roots: Sequence[int]) -> None:
        self._graph = graph
        self._new: dict[int, int] = {}
        live = below(graph.nodes, roots, graph.of_p.__getitem__)
        self._uses = Counter(roots)
        for node in (graph.nodes[k] for k in live):
            if node.op not in (ca.OP_INPUT, ca.OP_CONST):
                self._uses.update([node.a] if node.b == UNUSED else [node.a, node.b])
        for k in live:
            self._enter(k)

    def now(self, k: int) -> int:
        """What node k has become."""
        return self._new.get(k, k)

    def _enter(self, k: int) -> None:
        node = self._graph.nodes[k]
        if node.op == ca.OP_NEG:
            turned = self._turned(node.a)
            if turned is not None:
                self._new[k] = turned
                return
        if node.op != ca.OP_INPUT and (node.a in self._new or node.b in self._new):
            a, b = self.now(node.a), self.now(node.b)
            table = node.op == ca.OP_CALL
            self._new[k] = self._graph.table(a, node.value) if table else self._graph.rebuilt(node.op, a, b)

    def _turned(self, k: int) -> int | None:
        """-k for no operation more than k; None where there is no such form."""
        graph, node = self._graph, self._graph.nodes[k]
        if graph.of_p[k] or self._uses[k] > 1:
            return None
        if node.op == ca.OP_SUB:
            return graph.rebuilt(ca.OP_SUB, self.now(node.b), self.now(node.a))
        if node.op == ca.OP_MUL and graph.of_p[node.b]:
            return graph.rebuilt(ca.OP_MUL, self.now(node.a), graph.apply(ca.OP_NEG, node.b))
        if node.op not in (ca.OP_ADD, ca.OP_MUL):
            return None
        for own, other in ((node.a, node.b), (node.b, node.a)):
            turned = self._turned(own)
            if turned is not None:
                op = ca.OP_SUB if node.op == ca.OP_ADD else ca.OP_MUL
                return graph.rebuilt(op, turned, self.now(other))
        return None
