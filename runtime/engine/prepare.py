"""What a step computes from the run's constants alone is computed once: c -> [c, more], stages read the result.

The step size is baked into the stages, so products of parameters with h are such values; a division by one becomes a
product with its reciprocal.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, replace

import casadi as ca
import numpy as np

from runtime.contract.tape import UNUSED, Node, Tape, node_value, read_tape
from runtime.engine.invariants import hoist_invariants
from runtime.engine.program import Call, Program, Repeat, Sequence, stages

C_ARGUMENT = 1  # stages are functions of (z, c)


@dataclass(frozen=True)
class Prepared:
    """A program as it is run: z has z_size entries, the first of which are the scheme's; constants(c) is what it reads.

    The first entries of constants(c) are c.
    """

    program: Program
    z_size: int
    constants: ca.Function

    def widened(self, z: np.ndarray) -> np.ndarray:
        """A scheme's z with room for what the program keeps besides."""
        return np.concatenate([z, np.zeros(self.z_size - len(z))])

    def ready(self, c: np.ndarray) -> np.ndarray:
        """The constants as an array for an engine."""
        return np.asarray(self.constants(c), dtype=float).ravel().copy()


def prepare(program: Program, z_size: int, c_size: int) -> Prepared:
    """The program with what a repetition or the run's constants fix taken out of its stages."""
    program, z_size = hoist_invariants(program, z_size)
    pool = _Pool(c_size)
    tapes = {stage.name(): read_tape(stage) for stage in stages(program)}
    found = {name: pool.collect(tape) for name, tape in tapes.items()}
    size = c_size + len(pool.values)
    rebuilt = {name: _rebuilt(name, tape, found[name], size) for name, tape in tapes.items()}
    prepared = ca.Function("prepare", [pool.c], [ca.densify(ca.vertcat(pool.c, *pool.values))])
    return Prepared(_with_stages(program, rebuilt), z_size, prepared)


@dataclass(frozen=True)
class Found:
    """What of a tape is prepared: {node: entry of its value}, {division: entry of its divisor's reciprocal}.

    divisors divide several values; one is the entry of the number 1, which SX cannot fold back into the divisions.
    """

    values: dict[int, int]
    reciprocals: dict[int, int]
    divisors: frozenset[int]
    one: int


class _Pool:
    """Values of c over all stages, each once."""

    def __init__(self, c_size: int) -> None:
        self.c = ca.SX.sym("c", c_size)
        self.values: list[ca.SX] = []
        self._entries = ca.vertsplit(self.c)
        self._number: dict[Node, int] = {}
        self._sx: list[ca.SX] = []
        self._position: dict[int, int] = {}

    def collect(self, tape: Tape) -> Found:
        """The largest values of c in a tape, and its divisions by values of c."""
        numbers: dict[int, int] = {}  # nodes of c and plain numbers only
        for k, node in enumerate(tape.nodes):
            if node.op == ca.OP_CONST or (node.op == ca.OP_INPUT and node.a == C_ARGUMENT):
                numbers[k] = self._place(node)
            elif node.op != ca.OP_INPUT and node.a in numbers and (node.b == UNUSED or node.b in numbers):
                second = UNUSED if node.b == UNUSED else numbers[node.b]
                numbers[k] = self._place(Node(node.op, numbers[node.a], second, 0.0))
        read = {entry for entries in tape.outputs for entry in entries}
        for k, node in enumerate(tape.nodes):
            if k not in numbers and node.op != ca.OP_INPUT:
                read |= {node.a, node.b}
        divisions = {
            k: self._place(Node(ca.OP_INV, numbers[node.b], UNUSED, 0.0))
            for k, node in enumerate(tape.nodes)
            if node.op == ca.OP_DIV and node.b in numbers and k not in numbers
        }
        largest = {
            k: number
            for k, number in numbers.items()
            if k in read and tape.nodes[k].op not in (ca.OP_CONST, ca.OP_INPUT)
        }
        divisors = Counter(node.b for k, node in enumerate(tape.nodes) if node.op == ca.OP_DIV and k not in divisions)
        one = self._entry(self._place(Node(ca.OP_CONST, UNUSED, UNUSED, 1.0)))
        return Found(
            {k: self._entry(number) for k, number in largest.items()},
            {k: self._entry(number) for k, number in divisions.items()},
            frozenset(divisor for divisor, count in divisors.items() if count > 1),
            one,
        )

    def _place(self, node: Node) -> int:
        if node not in self._number:
            self._number[node] = len(self._sx)
            self._sx.append(node_value(node, self._sx, self._entries))
        return self._number[node]

    def _entry(self, number: int) -> int:
        if number not in self._position:
            self._position[number] = len(self._entries) + len(self.values)
            self.values.append(self._sx[number])
        return self._position[number]


def _rebuilt(name: str, tape: Tape, found: Found, c_size: int) -> ca.Function:
    """The stage on prepared constants."""
    z, c = ca.SX.sym("z", tape.input_sizes[0]), ca.SX.sym("c", c_size)
    inputs = [ca.vertsplit(z), ca.vertsplit(c)]
    values: list[ca.SX] = []
    shared: dict[int, ca.SX] = {}  # divisors of several values: one division, then products
    for k, node in enumerate(tape.nodes):
        if k in found.values:
            values.append(inputs[C_ARGUMENT][found.values[k]])
        elif k in found.reciprocals:
            values.append(values[node.a] * inputs[C_ARGUMENT][found.reciprocals[k]])
        elif node.op == ca.OP_DIV and node.b in found.divisors:
            if node.b not in shared:
                shared[node.b] = inputs[C_ARGUMENT][found.one] / values[node.b]
            values.append(values[node.a] * shared[node.b])
        else:
            values.append(node_value(node, values, inputs[node.a] if node.op == ca.OP_INPUT else []))
    output = ca.densify(ca.vertcat(*(values[entry] for entry in tape.outputs[0])))
    return ca.Function(name, [z, c], [output], ["z", "c"], ["z_next"])


def _with_stages(node: Program, rebuilt: dict[str, ca.Function]) -> Program:
    if isinstance(node, Call):
        return Call(rebuilt[node.stage.name()])
    if isinstance(node, Sequence):
        return Sequence(tuple(_with_stages(part, rebuilt) for part in node.parts))
    if isinstance(node, Repeat):
        return Repeat(_with_stages(node.body, rebuilt), node.count)
    return replace(node, body=_with_stages(node.body, rebuilt))
