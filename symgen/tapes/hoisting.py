"""Take everything that depends on parameters only out of the kernels: constants(p) -> c.

A run evaluates `constants` once; the kernels of a step read c. Products such as rho A L mu or composite masses
then cost nothing per step, although every physical number stays a run-time input.

Tapes that are made when they are first looked at.
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
from symgen.tapes.expansion import shorter_form
from symgen.tapes.graph import Graph, without_negations


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
    tape = _simplified(kernel, Graph(), p)
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


def _simplified(kernel: Kernel, graph: Graph, p: ca.SX) -> Tape:
    """The kernel as a tape of nodes that went through the common graph, p its last input."""
    if kernel.others:
        forms = [replace(kernel, others=()), *kernel.others]
        return _simplified(min(forms, key=lambda form: _operations(form, p)), graph, p)
    tape = Kernel({**kernel.inputs, "p": p}, kernel.outputs).tape()
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
        """Those that were looked at and those of these names, in the order of all."""
        return {name: self[name] for name in self._makers if name in self._made or name in always}

    def __contains__(self, name: object) -> bool:  # without making it
        return name in self._makers

    def __iter__(self) -> Iterator[str]:
        return iter(self._makers)

    def __len__(self) -> int:
        return len(self._makers)
