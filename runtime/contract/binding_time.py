"""Binding time: tapes split into what can be computed once and what is left (partial evaluation).

A value is known as soon as everything that it follows from is known. `split` is used for this three times:

    known               computed             by
    parameters p        once a run           symgen/tapes/hoisting.py: constants(p) -> c
    c and steps h       once a run           runtime/engine/prepare.py: c -> [c, more]
    z that is held      once a repetition    runtime/engine/invariants.py: a stage before the repetition
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from enum import IntEnum
from typing import NamedTuple

import casadi as ca

from runtime.contract.tape import UNUSED, Node, Tape


class Time(IntEnum):
    """When a value becomes known, in order. A number is known at RUN."""

    RUN = 0
    REPETITION = 1
    STEP = 2


class Place(NamedTuple):
    """Where what is left reads held values: entry first, first + 1, ... of an input, a new one if there is none."""

    name: str
    first: int


InputTime = Callable[[str, int], Time]  # of entry k of the input of that name


def binding_times(tape: Tape, of_input: InputTime) -> list[Time]:
    """The time of every node: the latest of its arguments'."""
    times: list[Time] = []
    for node in tape.nodes:
        if node.op == ca.OP_CONST:
            times.append(Time.RUN)
        elif node.op == ca.OP_INPUT:
            times.append(of_input(tape.input_names[node.a], node.b))
        elif node.b == UNUSED:
            times.append(times[node.a])
        else:
            times.append(max(times[node.a], times[node.b]))
    return times


def split(
    tapes: Mapping[str, Tape],
    inputs: Mapping[str, int],
    of_input: InputTime,
    at: Time,
    place: Place,
    hold_inputs: bool = False,
) -> tuple[Tape, dict[str, Tape]]:
    """(the values of the tapes that become known just at a time, each once; the tapes that read them from `place`).

    Held are the largest such values: those that something later reads. The first tape has `inputs` (name: size) and
    one output "held"; hold_inputs: plain entries of known inputs are held too, so that what is left does not read these
    inputs at all.
    """
    once = _Once(list(inputs))
    entries: dict[str, dict[int, int]] = {}  # of each tape {held node: its entry}
    for name, tape in tapes.items():
        times = binding_times(tape, of_input)
        later = _read_later(tape, times, at)
        kept = (ca.OP_CONST,) if hold_inputs else (ca.OP_CONST, ca.OP_INPUT)
        held = [k for k, node in enumerate(tape.nodes) if times[k] == at and k in later and node.op not in kept]
        entries[name] = once.take(tape, held)
    shape = (len(once.held), 1)
    values = Tape(list(inputs), list(inputs.values()), ["held"], [shape], once.nodes, [once.held])
    return values, {name: _rest(tape, entries[name], place, shape[0]) for name, tape in tapes.items()}


def _read_later(tape: Tape, times: list[Time], at: Time) -> set[int]:
    """Nodes that are outputs or arguments of a node that becomes known after that time."""
    read = {k for entries in tape.outputs for k in entries}
    for node, time in zip(tape.nodes, times, strict=True):
        if time > at and node.op != ca.OP_INPUT:
            read |= {node.a, node.b}
    return read


def below(nodes: list[Node], roots: Collection[int], stop: Callable[[int], bool] = lambda k: False) -> list[int]:
    """Nodes that the roots need, themselves included, in ascending order; not below nodes that `stop`."""
    seen: set[int] = set()
    stack = list(roots)
    while stack:
        k = stack.pop()
        if k in seen:
            continue
        seen.add(k)
        node = nodes[k]
        if node.op not in (ca.OP_INPUT, ca.OP_CONST) and not stop(k):
            stack += [node.a] if node.b == UNUSED else [node.a, node.b]
    return sorted(seen)


def renumbered(node: Node, number: Mapping[int, int], argument: Mapping[int, int]) -> Node:
    """The node with other numbers of its arguments: of nodes by `number`, of inputs by `argument`."""
    if node.op == ca.OP_CONST:
        return node
    if node.op == ca.OP_INPUT:
        return Node(node.op, argument[node.a], node.b, 0.0)
    return node._replace(a=number[node.a], b=UNUSED if node.b == UNUSED else number[node.b])


class _Once:
    """Nodes of several tapes, equal ones once; held: those that what is left reads, by entry."""

    def __init__(self, inputs: list[str]) -> None:
        self.nodes: list[Node] = []
        self.held: list[int] = []
        self._inputs = {name: k for k, name in enumerate(inputs)}
        self._number: dict[Node, int] = {}
        self._entry: dict[int, int] = {}

    def take(self, tape: Tape, held: list[int]) -> dict[int, int]:
        """{node of the tape: its entry} for nodes to be held."""
        number: dict[int, int] = {}
        argument = {k: self._inputs[name] for k, name in enumerate(tape.input_names) if name in self._inputs}
        for k in below(tape.nodes, held):
            number[k] = self._place(renumbered(tape.nodes[k], number, argument))
        return {k: self._hold(number[k]) for k in held}

    def _place(self, node: Node) -> int:
        if node not in self._number:
            self._number[node] = len(self.nodes)
            self.nodes.append(node)
        return self._number[node]

    def _hold(self, number: int) -> int:
        if number not in self._entry:
            self._entry[number] = len(self.held)
            self.held.append(number)
        return self._entry[number]


def _rest(tape: Tape, held: Mapping[int, int], place: Place, count: int) -> Tape:
    """The tape with held nodes read from their entries."""
    names, sizes = list(tape.input_names), list(tape.input_sizes)
    if place.name not in names:
        names, sizes = [*names, place.name], [*sizes, 0]
    argument = names.index(place.name)
    sizes[argument] = place.first + count
    live = below(tape.nodes, {k for entries in tape.outputs for k in entries}, held.__contains__)
    number = {node: k for k, node in enumerate(live)}
    same = {k: k for k in range(len(names))}
    nodes = [
        Node(ca.OP_INPUT, argument, place.first + held[k], 0.0)
        if k in held
        else renumbered(tape.nodes[k], number, same)
        for k in live
    ]
    outputs = [[number[k] for k in entries] for entries in tape.outputs]
    return Tape(names, sizes, tape.output_names, tape.output_shapes, nodes, outputs)
