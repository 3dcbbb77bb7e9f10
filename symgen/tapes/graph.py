"""Expressions of the kernels as one graph with shared nodes, simplified as it is built.

Four rules CasADi does not know, all about parameters (p) and rotations:

    (x k1) k2 -> x (k1 k2)              parameters gather and can be hoisted out of the kernel as one constant
    k1 X + k2 X -> (k1 + k2) X          like terms
    k X cos^2 + k X sin^2 -> k X        a rotated arm keeps its length
    k X + k Y -> k (X + Y)              one product less

Negations taken into what they negate: -(x - y) is y - x, -(k X + y) is (-k) X - y with a parameter -k.

Only where nothing else uses the value that is negated, which is known when a kernel is complete; so no count rises.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from typing import NamedTuple

import casadi as ca

from runtime.contract.tape import BINARY, UNUSED, Node, below

MAX_FACTORS, MAX_TERMS = 8, 12
Monomial = tuple[int, tuple[int, ...]]  # (node of the parameter factor, sorted other factors)


class Graph:
    """Nodes by number. of_p[k] tells whether node k depends on parameters and numbers only.

    shared holds nodes with several uses: taking those apart would compute them twice.
    """

    def __init__(self) -> None:
        self.nodes: list[Node] = []
        self.of_p: list[bool] = []
        self.shared: set[int] = set()
        self._number: dict[tuple, int] = {}
        self._monomials: dict[int, Monomial | None] = {}
        self._arguments = 1  # argument 0 is p
        self.one = self.constant(1.0)

    def _add(self, key: tuple[int, int, int, float], of_p: bool) -> int:
        known = self._number.get(key)  # a Node equals its plain tuple
        if known is None:
            known = self._number[key] = len(self.nodes)
            self.nodes.append(Node(*key))
            self.of_p.append(of_p)
        return known

    def new_arguments(self, count: int) -> int:
        """First of `count` fresh argument numbers, for the inputs of one kernel."""
        first = self._arguments
        self._arguments += count
        return first

    def constant(self, value: float) -> int:
        """Node of a number."""
        return self._add((ca.OP_CONST, UNUSED, UNUSED, value), True)

    def entry(self, argument: int, position: int, of_p: bool) -> int:
        """Node of an input entry."""
        return self._add((ca.OP_INPUT, argument, position, 0.0), of_p)

    def apply(self, op: int, a: int, b: int = UNUSED) -> int:
        """Node of op(a[, b]), simplified."""
        if op == ca.OP_SQ:
            op, b = ca.OP_MUL, a
        if op == ca.OP_MUL:
            if self._is_zero(a) or self._is_zero(b):
                return self.constant(0.0)
            plain = not (self.of_p[a] or self.of_p[b]) and a != b
            if plain and self.nodes[a].op != ca.OP_NEG and self.nodes[b].op != ca.OP_NEG:
                return self._add((op, a, b, 0.0) if a < b else (op, b, a, 0.0), False)
            return self._mul(a, b)
        if op in (ca.OP_ADD, ca.OP_SUB, ca.OP_DIV) and (vanishing := self._with_zero(op, a, b)) is not None:
            return vanishing
        if op == ca.OP_ADD:
            return self._add_terms(a, b)
        if op == ca.OP_SUB:
            return self._sub(a, b)
        if op == ca.OP_NEG:
            return self._neg(a)
        if op == ca.OP_TWICE:
            return self._mul(a, self.constant(2.0)) if self._ends_in_p(a) else self._plain(op, a, UNUSED)
        return self._plain(op, a, b)

    def table(self, a: int, value: float) -> int:
        """Node of a table at a; value: which table."""
        return self._add((ca.OP_CALL, a, UNUSED, value), self.of_p[a])

    def _with_zero(self, op: int, a: int, b: int) -> int | None:
        """What is left of a sum, difference or quotient where an operand is zero or both are the same, as in CasADi."""
        if op == ca.OP_SUB and a == b:
            return self.constant(0.0)
        if op == ca.OP_DIV:
            return a if self._is_zero(a) and not self._is_zero(b) else None
        if self._is_zero(b):
            return a
        if self._is_zero(a):
            return b if op == ca.OP_ADD else self._neg(b)
        return None

    def _is_zero(self, k: int) -> bool:
        return self.nodes[k].op == ca.OP_CONST and self.nodes[k].value == 0.0

    def _plain(self, op: int, a: int, b: int) -> int:
        if op not in BINARY:
            b = UNUSED
        return self._add((op, a, b, 0.0), self.of_p[a] and (b == UNUSED or self.of_p[b]))

    def _ends_in_p(self, k: int) -> bool:
        """Is k a product with a parameter factor, used only here?"""
        node = self.nodes[k]
        return node.op == ca.OP_MUL and not self.of_p[k] and self.of_p[node.b] and k not in self.shared

    def _stays_negative(self, k: int, other: int) -> bool:
        """Is k a negation that CasADi would move outwards past `other`? (A hoisted parameter is no negation there.)"""
        return self.nodes[k].op == ca.OP_NEG and self.of_p[k] <= self.of_p[other]

    def _sub(self, a: int, b: int) -> int:
        """CasADi's own rules, so that the emitted text gives the counted operations when it is loaded."""
        if self._stays_negative(b, a):
            return self.apply(ca.OP_ADD, a, self.nodes[b].a)
        if self._stays_negative(a, b):
            return self._neg(self.apply(ca.OP_ADD, self.nodes[a].a, b))
        if self._ends_in_p(b):
            terms = self._terms(a)
            for place, term in enumerate(terms):
                difference = self._with_common_factor(ca.OP_SUB, term, b)
                if difference is not None:
                    return self._sum([difference, *terms[:place], *terms[place + 1 :]])
        return self._plain(ca.OP_SUB, a, b)

    def _mul(self, a: int, b: int) -> int:
        if self.of_p[a] and (not self.of_p[b] or self.nodes[a].op == ca.OP_CONST):
            a, b = b, a
        for negative, other in ((a, b), (b, a)):
            if self._stays_negative(negative, other) and self.of_p[a] == self.of_p[b]:
                return self._neg(self._mul(self.nodes[negative].a, other))
        if a == self.one:
            return b
        if b == self.one:
            return a
        if self.of_p[b] and not self.of_p[a]:
            node = self.nodes[a]
            if self._ends_in_p(a):
                return self._mul(node.a, self._mul(node.b, b))
            if node.op == ca.OP_NEG and a not in self.shared:
                return self._mul(node.a, self._neg(b))
        elif a == b:
            return self._plain(ca.OP_SQ, a, UNUSED)
        if self.nodes[b].op == ca.OP_CONST and self.nodes[b].value in (2.0, -1.0):
            return self._plain(ca.OP_TWICE if self.nodes[b].value == 2.0 else ca.OP_NEG, a, UNUSED)
        if a > b and self.of_p[a] == self.of_p[b] and self.nodes[b].op != ca.OP_CONST:
            a, b = b, a
        return self._plain(ca.OP_MUL, a, b)

    def _neg(self, a: int) -> int:
        node = self.nodes[a]
        if node.op == ca.OP_NEG:
            return node.a
        if node.op == ca.OP_CONST:
            return self.constant(-node.value)
        if self._ends_in_p(a):
            return self._mul(node.a, self._neg(node.b))
        return self._plain(ca.OP_NEG, a, UNUSED)

    def rebuilt(self, op: int, a: int, b: int) -> int:
        """Node of op(a[, b]) as it is."""
        return self._plain(op, a, b)

    # ---- sums ------------------------------------------------------------------------------------------------

    def _add_terms(self, a: int, b: int) -> int:
        for negative, other in ((a, b), (b, a)):
            if self._stays_negative(negative, other):
                return self._sub(other, self.nodes[negative].a)
        if self.of_p[a] != self.of_p[b] or not self.of_p[a]:
            old = self._few_terms(a, MAX_TERMS - 1)
            new = self._few_terms(b, MAX_TERMS - len(old)) if old else []
            if old and new and self._meets(old, new):
                return self._sum(self._merge(old + new))
        return self._plain(ca.OP_ADD, min(a, b), max(a, b))

    def _few_terms(self, k: int, most: int) -> list[int]:
        """The terms of a sum; none where there are more than `most`."""
        found: list[int] = []
        waiting = [k]
        while waiting:
            if len(found) + len(waiting) > most:
                return []
            last = waiting.pop()
            node = self.nodes[last]
            if node.op == ca.OP_ADD and not self.of_p[last] and last not in self.shared:
                waiting += [node.b, node.a]
            else:
                found.append(last)
        return found

    def _terms(self, k: int) -> list[int]:
        node = self.nodes[k]
        if node.op == ca.OP_ADD and not self.of_p[k] and k not in self.shared:
            return self._terms(node.a) + self._terms(node.b)
        return [k]

    def _sum(self, terms: Sequence[int]) -> int:
        result = terms[0]
        for term in terms[1:]:
            result = self._add_terms(result, term)
        return result

    def _meets(self, old: list[int], new: list[int]) -> bool:
        """Does a term of one sum combine with a term of the other? (Within each they have been tried.)"""
        return any(self._combine(x, y) is not None for x in old for y in new)

    def _merge(self, terms: list[int]) -> list[int]:
        """One pass over all pairs; a pair that combines becomes one term."""
        terms = list(terms)
        for i in range(len(terms)):
            for j in range(i + 1, len(terms)):
                combined = self._combine(terms[i], terms[j])
                if combined is not None:
                    rest = [term for k, term in enumerate(terms) if k not in (i, j)]
                    return self._merge([combined, *rest])
        return terms

    def _combine(self, a: int, b: int) -> int | None:
        if self.of_p[a] and self.of_p[b]:
            return self._plain(ca.OP_ADD, min(a, b), max(a, b))
        first, second = self._monomial(a), self._monomial(b)
        if first is None or second is None:
            return None
        if first[1] == second[1] and not {a, b} & self.shared:
            k = self._plain(ca.OP_ADD, min(first[0], second[0]), max(first[0], second[0]))
            return self._product(k, first[1])
        if first[0] == second[0]:
            rest = self._pythagoras(first[1], second[1]) or self._pythagoras(second[1], first[1])
            if rest is not None:
                return self._product(first[0], rest)
        return self._with_common_factor(ca.OP_ADD, a, b)

    def _with_common_factor(self, op: int, a: int, b: int) -> int | None:
        """k X + k Y, or their difference, as k (X + Y), and k1 X - k2 X as (k1 - k2) X."""
        if not (self._ends_in_p(a) and self._ends_in_p(b)):
            return None
        first, second = self.nodes[a], self.nodes[b]
        if first.b == second.b:
            return self._mul(self.apply(op, first.a, second.a), first.b)
        return self._mul(first.a, self._plain(op, first.b, second.b)) if first.a == second.a else None

    def _pythagoras(self, u: tuple[int, ...], v: tuple[int, ...]) -> tuple[int, ...] | None:
        """Common factors X if u = X cos^2 and v = X sin^2 of one angle (as a non-empty marker: X or (one,))."""
        for factor in set(u):
            node = self.nodes[factor]
            if node.op == ca.OP_COS and u.count(factor) >= 2:
                sine = self._number.get((ca.OP_SIN, node.a, UNUSED, 0.0))
                if sine is not None and _without(u, factor) == _without(v, sine) and v.count(sine) >= 2:
                    return _without(u, factor) or (self.one,)
        return None

    def _monomial(self, k: int) -> Monomial | None:
        """k as parameter factor times a product; None if it has too many factors or is a parameter itself."""
        if k not in self._monomials:
            self._monomials[k] = self._factored(k)
        return self._monomials[k]

    def _factored(self, k: int) -> Monomial | None:
        coefficient, factors, stack = self.one, [], [k]
        while stack:
            current = stack.pop()
            node = self.nodes[current]
            if self.of_p[current]:
                coefficient = self._mul(coefficient, current)
            elif node.op == ca.OP_MUL:
                stack += [node.a, node.b]
            elif node.op == ca.OP_SQ:
                stack += [node.a, node.a]
            elif node.op == ca.OP_TWICE:
                coefficient, stack = self._mul(coefficient, self.constant(2.0)), [*stack, node.a]
            elif node.op == ca.OP_NEG:
                coefficient, stack = self._neg(coefficient), [*stack, node.a]
            else:
                factors.append(current)
            if len(factors) + len(stack) > MAX_FACTORS:
                return None
        return (coefficient, tuple(sorted(factors))) if factors else None

    def _product(self, coefficient: int, factors: Sequence[int]) -> int:
        result = factors[0]
        for factor in factors[1:]:
            result = self._mul(result, factor)
        return self._mul(result, coefficient)


def _without(factors: tuple[int, ...], factor: int) -> tuple[int, ...]:
    """factors with two occurrences of `factor` removed."""
    left = list(factors)
    for _ in range(2):
        if factor in left:
            left.remove(factor)
    return tuple(left)


def without_negations(graph: Graph, outputs: list[list[int]]) -> list[list[int]]:
    """The outputs with as few negations as their sums and products allow."""
    new = _Signs(graph, [entry for entries in outputs for entry in entries]).new
    return [[new.get(entry, entry) for entry in entries] for entries in outputs] if new else outputs


class _Signs:
    """One pass from the inputs to the outputs."""

    def __init__(self, graph: Graph, roots: Sequence[int]) -> None:
        self._graph = graph
        self.new: dict[int, int] = {}  # what a node has become
        live = below(graph.nodes, roots, graph.of_p.__getitem__)
        self._uses = Counter(roots)
        above = [node for k in live if (node := graph.nodes[k]).op not in (ca.OP_INPUT, ca.OP_CONST)]
        self._uses.update(operand for node in above for operand in (node.a, node.b))
        for k in live:
            self._enter(k)

    def _now(self, k: int) -> int:
        return self.new.get(k, k)

    def _enter(self, k: int) -> None:
        node = self._graph.nodes[k]
        if node.op == ca.OP_NEG:
            turned = self._turned(node.a)
            if turned is not None:
                self.new[k] = turned
                return
        if node.op != ca.OP_INPUT and (node.a in self.new or node.b in self.new):
            a, b = self._now(node.a), self._now(node.b)
            table = node.op == ca.OP_CALL
            self.new[k] = self._graph.table(a, node.value) if table else self._graph.rebuilt(node.op, a, b)

    def _turned(self, k: int) -> int | None:
        """-k for no operation more than k; None where there is no such form.

        Sums of a long chain are as deep as it is long: the operands that are left to try are on a stack, each with what
        stands above it.
        """
        graph = self._graph
        left: list[tuple[int, _Above | None]] = [(k, None)]
        while left:
            k, above = left.pop()
            node = graph.nodes[k]
            if graph.of_p[k] or self._uses[k] > 1:
                continue
            if node.op == ca.OP_SUB:
                return self._under(above, graph.rebuilt(ca.OP_SUB, self._now(node.b), self._now(node.a)))
            if node.op == ca.OP_MUL and graph.of_p[node.b]:
                turned = graph.rebuilt(ca.OP_MUL, self._now(node.a), graph.apply(ca.OP_NEG, node.b))
                return self._under(above, turned)
            if node.op in (ca.OP_ADD, ca.OP_MUL):
                op = ca.OP_SUB if node.op == ca.OP_ADD else ca.OP_MUL
                left += [(node.b, _Above(op, node.a, above)), (node.a, _Above(op, node.b, above))]
        return None

    def _under(self, above: _Above | None, turned: int) -> int:
        """What a negated operand makes of all that stands above it."""
        while above is not None:
            turned, above = self._graph.rebuilt(above.op, turned, self._now(above.other)), above.above
        return turned


class _Above(NamedTuple):
    """An operation above an operand that may be negated: what it becomes then, its other operand, what is above it."""

    op: int
    other: int
    above: _Above | None
