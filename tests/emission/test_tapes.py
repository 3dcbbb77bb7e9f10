"""Straight-line code of functions: what is folded and gathered in it."""

from __future__ import annotations

import casadi as ca

from runtime.contract.tape import UNUSED
from symgen.tapes.graph import Graph, without_negations


def test_numbers_gather_behind_what_varies() -> None:
    """(x 3) 5 is x 15: one product of x, and 15 = 3 * 5 is taken once, outside."""
    graph = Graph()
    x = graph.entry(1, 0, False)
    found = graph.nodes[graph.apply(ca.OP_MUL, graph.apply(ca.OP_MUL, x, graph.constant(3.0)), graph.constant(5.0))]
    assert found.op == ca.OP_MUL and found.a == x and graph.of_p[found.b]


def test_signs_go_into_what_nothing_else_uses() -> None:
    """-(x - y) is y - x and -(3 x + y) is -3 x - y, but where x - y is an output too it is negated as it is."""
    graph = Graph()
    x, y = graph.entry(1, 0, False), graph.entry(1, 1, False)
    less, more = graph.apply(ca.OP_SUB, x, y), graph.apply(ca.OP_ADD, graph.apply(ca.OP_MUL, x, graph.constant(3.0)), y)
    roots = [graph.rebuilt(ca.OP_NEG, k, UNUSED) for k in (less, more)]
    first, second = (graph.nodes[k] for k in without_negations(graph, [roots])[0])
    assert (first.op, first.a, first.b) == (ca.OP_SUB, y, x)
    assert (second.op, graph.nodes[graph.nodes[second.a].b].value, second.b) == (ca.OP_SUB, -3.0, y)
    assert without_negations(graph, [[roots[0], less]]) == [[roots[0], less]]
