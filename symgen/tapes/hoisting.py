"""Take everything that depends on parameters only out of the kernels: constants(p) -> c.

A run evaluates `constants` once; the kernels of a step read c. Products such as rho A L mu or composite masses
then cost nothing per step, although every physical number stays a run-time input.

Tapes that are made when they are first looked at.

Small kernels multiplied out, as a person would write them: kept where that takes fewer operations.

The sweeps of the condensation leave products of sums. For a pendulum or a double pendulum, multiplying out makes
terms cancel and sines and cosines of two bodies merge into those of the angle between them. For larger systems the
factored form is shorter, so the smaller of the two is taken.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping
from dataclasses import replace
from math import isfinite

import casadi as ca

from runtime.contract.tape import (
    UNUSED,
    Node,
    Place,
    Tape,
    Time,
    as_function,
    below,
    read_tape,
    renumbered,
    split,
    uses,
)
from symgen.kernels.kernel import Kernel
from symgen.system.constraint import DerivationError
from symgen.tapes.graph import Graph, without_negations

LARGEST_KERNEL = 100  # nodes
MAX_TERMS = 80
Monomial = tuple[tuple[int, ...], tuple[int, ...]]  # (parameter factors, other factors), both sorted
Polynomial = dict[Monomial, float]
Coefficient = tuple[tuple[tuple[int, ...], float], ...]  # a polynomial in parameters, sorted
Terms = dict[tuple[int, ...], Coefficient]


class TooLarge(Exception):
    """The expression has too many terms to be worth expanding."""


class Expansion:
    """Expands nodes of a graph and rebuilds them as new nodes."""

    def __init__(self, graph: Graph) -> None:
        self.graph = graph
        self._known: dict[int, Polynomial] = {}

    def rebuilt(self, root: int) -> int:
        """Node with the same value as `root`, multiplied out. Raises TooLarge."""
        terms: dict[tuple[int, ...], dict[tuple[int, ...], float]] = {}
        for (parameters, factors), value in self._expand(root).items():
            terms.setdefault(factors, {})[parameters] = value
        return self._sum(self._merged({factors: tuple(sorted(c.items())) for factors, c in terms.items()}))

    # ---- to polynomials -----------------------------------------------------------------------------------

    def _expand(self, k: int) -> Polynomial:
        if k not in self._known:
            self._known[k] = self._polynomial(k)
        return self._known[k]

    def _polynomial(self, k: int) -> Polynomial:
        node = self.graph.nodes[k]
        if node.op == ca.OP_CONST:
            return {((), ()): node.value} if node.value else {}
        if node.op == ca.OP_ADD:
            return _add(self._expand(node.a), self._expand(node.b), 1.0)
        if node.op == ca.OP_SUB:
            return _add(self._expand(node.a), self._expand(node.b), -1.0)
        if node.op in (ca.OP_NEG, ca.OP_TWICE):
            factor = -1.0 if node.op == ca.OP_NEG else 2.0
            return {monomial: factor * value for monomial, value in self._expand(node.a).items()}
        if node.op == ca.OP_MUL:
            return _multiply(self._expand(node.a), self._expand(node.b))
        if node.op == ca.OP_SQ:
            return _multiply(self._expand(node.a), self._expand(node.a))
        return {(((k,), ()) if self.graph.of_p[k] else ((), (k,))): 1.0}

    # ---- trigonometric rules ------------------------------------------------------------------------------

    def _merged(self, terms: Terms) -> Terms:
        """Apply cos^2 + sin^2 and the addition theorems until nothing changes."""
        for u in terms:
            for v in terms:
                result = self._rule(u, v, terms[u], terms[v]) if u != v else None
                if result is not None:
                    factors, coefficient = result
                    left = {key: value for key, value in terms.items() if key not in (u, v)}
                    if factors in left:
                        coefficient = _added(left.pop(factors), coefficient)
                    return self._merged({**left, factors: coefficient} if coefficient else left)
        return terms

    def _rule(
        self, u: tuple[int, ...], v: tuple[int, ...], a: Coefficient, b: Coefficient
    ) -> tuple[tuple[int, ...], Coefficient] | None:
        only_u, only_v = _difference(u, v), _difference(v, u)
        if len(only_u) != 2 or len(only_v) != 2:
            return None
        common = _difference(u, only_u)
        (f1, x1), (f2, x2) = self._trig(only_u[0]), self._trig(only_u[1])
        (g1, y1), (g2, y2) = self._trig(only_v[0]), self._trig(only_v[1])
        if (f1, f2) == ("cos", "cos") and (g1, g2) == ("sin", "sin") and {x1, x2} == {y1, y2} and a == b:
            extra = () if x1 == x2 else (self._of_difference(ca.OP_COS, x1, x2),)
            return tuple(sorted((*common, *extra))), a
        if {f1, f2} == {"sin", "cos"} == {g1, g2} and a == _negated(b):
            sine, cosine = (x1, x2) if f1 == "sin" else (x2, x1)
            if (sine, cosine) == ((y2, y1) if g1 == "sin" else (y1, y2)) and sine != cosine:
                if sine > cosine:
                    return tuple(sorted((*common, self._of_difference(ca.OP_SIN, sine, cosine)))), a
                return tuple(sorted((*common, self._of_difference(ca.OP_SIN, cosine, sine)))), _negated(a)
        return None

    def _trig(self, k: int) -> tuple[str, int]:
        node = self.graph.nodes[k]
        name = {ca.OP_COS: "cos", ca.OP_SIN: "sin"}.get(node.op, "")
        return name, node.a

    def _of_difference(self, op: int, a: int, b: int) -> int:
        return self.graph.apply(op, self.graph.apply(ca.OP_SUB, max(a, b), min(a, b)))

    # ---- back to nodes ------------------------------------------------------------------------------------

    def _sum(self, terms: Terms) -> int:
        plus: list[int] = []
        minus: list[int] = []
        for factors, coefficient in sorted(terms.items()):
            negative = coefficient[0][1] < 0
            value = self._product(factors, _negated(coefficient) if negative else coefficient)
            (minus if negative else plus).append(value)
        if not plus and not minus:
            return self.graph.constant(0.0)
        result = plus[0] if plus else self.graph.apply(ca.OP_NEG, minus.pop(0))
        for value in plus[1:]:
            result = self.graph.apply(ca.OP_ADD, result, value)
        for value in minus:
            result = self.graph.apply(ca.OP_SUB, result, value)
        return result

    def _product(self, factors: tuple[int, ...], coefficient: Coefficient) -> int:
        """The coefficient goes with the sines and cosines first: that product is the one terms share."""
        trig = [k for k in factors if self._trig(k)[0]]
        rest = [k for k in factors if not self._trig(k)[0]]
        parameter = self._parameter(coefficient)
        if not factors:
            return parameter
        result = self._times(trig)
        result = parameter if result is None else self.graph.apply(ca.OP_MUL, result, parameter)
        other = self._times(rest)
        if other is not None:
            self.graph.shared.add(result)
            result = self.graph.apply(ca.OP_MUL, result, other)
        return result

    def _times(self, factors: list[int]) -> int | None:
        result = None
        for k in factors:
            result = k if result is None else self.graph.apply(ca.OP_MUL, result, k)
        return result

    def _parameter(self, coefficient: Coefficient) -> int:
        result = None
        for parameters, value in coefficient:
            term = self.graph.constant(value)
            for k in parameters:
                term = self.graph.apply(ca.OP_MUL, term, k)
            result = term if result is None else self.graph.apply(ca.OP_ADD, result, term)
        return self.graph.constant(0.0) if result is None else result


def _add(u: Polynomial, v: Polynomial, sign: float) -> Polynomial:
    result = dict(u)
    for monomial, value in v.items():
        total = result.pop(monomial, 0.0) + sign * value
        if total:
            result[monomial] = total
    return result


def _multiply(u: Polynomial, v: Polynomial) -> Polynomial:
    if len(u) * len(v) > MAX_TERMS * MAX_TERMS:
        raise TooLarge
    result: Polynomial = {}
    for (p, x), a in u.items():
        for (q, y), b in v.items():
            monomial = tuple(sorted(p + q)), tuple(sorted(x + y))
            total = result.pop(monomial, 0.0) + a * b
            if total:
                result[monomial] = total
    if len(result) > MAX_TERMS:
        raise TooLarge
    return result


def _negated(coefficient: Coefficient) -> Coefficient:
    return tuple((parameters, -value) for parameters, value in coefficient)


def _added(a: Coefficient, b: Coefficient) -> Coefficient:
    total = dict(a)
    for parameters, value in b:
        total[parameters] = total.get(parameters, 0.0) + value
    return tuple(sorted((parameters, value) for parameters, value in total.items() if value))


def _difference(u: tuple[int, ...], v: tuple[int, ...]) -> tuple[int, ...]:
    """Multiset difference u - v."""
    left = list(u)
    for factor in v:
        if factor in left:
            left.remove(factor)
    return tuple(left)


def shorter_form(graph: Graph, outputs: list[list[int]]) -> list[list[int]]:
    """The outputs multiplied out where that takes fewer nodes, or as they are."""
    before = _size(graph, outputs)
    if before > LARGEST_KERNEL:
        return outputs
    expansion = Expansion(graph)
    try:
        expanded = [[expansion.rebuilt(entry) for entry in entries] for entries in outputs]
    except TooLarge:
        return outputs
    return expanded if _size(graph, expanded) < before else outputs


def _size(graph: Graph, outputs: list[list[int]]) -> int:
    """Nodes of a kernel, whatever depends on parameters only taken out."""
    roots = [entry for entries in outputs for entry in entries]
    return len(below(graph.nodes, roots, graph.of_p.__getitem__))


def hoist(kernels: Mapping[str, Kernel], p: ca.SX) -> dict[str, Tape]:
    """Tapes of `constants` (p -> c) and of the kernels with c instead of p.

    Inputs that no output of a kernel uses are dropped. Raises DerivationError for a constant that is not finite.
    """
    graph = Graph()
    tapes = {name: _simplified(kernel, graph, p) for name, kernel in kernels.items()}
    once, rest = split(tapes, {"p": p.numel()}, _input_time, Time.RUN, Place("c", 0), hold_inputs=True)
    tapes = {"constants": replace(once, output_names=["c"])}
    tapes |= {name: _without_unused_inputs(tape) for name, tape in rest.items()}
    return {name: _as_loaded(name, tape) for name, tape in tapes.items()}


def unhoisted(kernel: Kernel, p: ca.SX) -> Tape:
    """The tape of one kernel with c standing for p itself: what depends on c only is left to a run's preparation.

    Inputs that no output uses are dropped. Raises DerivationError for a constant that is not finite.
    """
    tape = _simplified(kernel, Graph(), p, packed=True)
    return _without_unused_inputs(replace(tape, input_names=[*tape.input_names[:-1], "c"]))


def _input_time(name: str, entry: int) -> Time:
    return Time.RUN if name == "p" else Time.STEP


def _as_loaded(name: str, tape: Tape) -> Tape:
    """The tape as CasADi will simplify it when it loads the emitted text."""
    loaded = as_function(name, tape)
    return tape if loaded.n_instructions() == tape.instructions else read_tape(loaded)


def _without_unused_inputs(tape: Tape) -> Tape:
    used = sorted({node.a for node in tape.nodes if node.op == ca.OP_INPUT})
    if len(used) == len(tape.input_names):
        return tape
    argument = {k: position for position, k in enumerate(used)}
    same = {k: k for k in range(len(tape.nodes))}
    return replace(
        tape,
        input_names=[tape.input_names[k] for k in used],
        input_sizes=[tape.input_sizes[k] for k in used],
        nodes=[renumbered(node, same, argument) for node in tape.nodes],
    )


def _simplified(kernel: Kernel, graph: Graph, p: ca.SX, packed: bool = False) -> Tape:
    """The kernel as a tape of nodes that went through the common graph, p its last input."""
    if kernel.others:
        forms = [replace(kernel, others=()), *kernel.others]
        return _simplified(min(forms, key=lambda form: _operations(form, p)), graph, p, packed)
    tape = Kernel({**kernel.inputs, "p": p}, kernel.outputs).tape(packed)
    first, last = graph.new_arguments(len(kernel.inputs)), len(kernel.inputs)
    numbers: list[int] = []
    for node, count in zip(tape.nodes, uses(tape), strict=True):
        argument = 0 if node.a == last else first + node.a
        numbers.append(_entered(node, argument, graph, numbers))
        if count > 1:
            graph.shared.add(numbers[-1])
    roots = shorter_form(graph, [[numbers[entry] for entry in entries] for entries in tape.outputs])
    roots = without_negations(graph, roots)
    live = below(graph.nodes, [entry for entries in roots for entry in entries])
    number = {node: k for k, node in enumerate(live)}
    own = {0: last, **{first + k: k for k in range(last)}}
    nodes = [renumbered(graph.nodes[k], number, own) for k in live]
    return replace(tape, nodes=nodes, outputs=[[number[entry] for entry in entries] for entries in roots])


def _operations(kernel: Kernel, p: ca.SX) -> int:
    """Of the kernel by itself, whatever depends on parameters only taken out."""
    graph = Graph()
    tape = _simplified(kernel, graph, p)
    roots = [entry for entries in tape.outputs for entry in entries]
    of_p = _of_p(tape)
    return len(below(tape.nodes, roots, of_p.__getitem__))


def _of_p(tape: Tape) -> list[bool]:
    """Which nodes depend on the last input, p, and numbers only."""
    last, found = len(tape.input_names) - 1, []
    for node in tape.nodes:
        if node.op == ca.OP_INPUT:
            found.append(node.a == last)
        else:
            operands = [node.a, node.b] if node.op != ca.OP_CONST else []
            found.append(all(found[k] for k in operands if k != UNUSED))
    return found


def _entered(node: Node, argument: int, graph: Graph, numbers: list[int]) -> int:
    if node.op == ca.OP_CONST:
        if not isfinite(node.value):
            raise DerivationError(
                "expressions",
                "a motion, load or quantity contains a division by zero or a logarithm "
                "of a number that is not positive",
                "correct the expression, also in the branches of where() that are not taken",
            )
        return graph.constant(node.value)
    if node.op == ca.OP_INPUT:
        return graph.entry(argument, node.b, argument == 0)
    if node.op == ca.OP_CALL:
        return graph.table(numbers[node.a], node.value)
    return graph.apply(node.op, numbers[node.a], UNUSED if node.b == UNUSED else numbers[node.b])


class TapesOnDemand(Mapping[str, Tape]):
    """By name, from what makes each; made once."""

    def __init__(self, makers: Mapping[str, Callable[[], Tape]]) -> None:
        self._makers = makers
        self._made: dict[str, Tape] = {}

    def __getitem__(self, name: str) -> Tape:
        if name not in self._made:
            self._made[name] = self._makers[name]()
        return self._made[name]

    def made(self, always: Collection[str] = ()) -> dict[str, Tape]:
        """Those that were looked at and those of these names, in the order of all, with every entry."""
        return {name: self[name].unpacked() for name in self._makers if name in self._made or name in always}

    def __contains__(self, name: object) -> bool:  # without making it
        return name in self._makers

    def __iter__(self) -> Iterator[str]:
        return iter(self._makers)

    def __len__(self) -> int:
        return len(self._makers)
