"""What a step computes from the run's constants alone is computed once: c -> [c, more], stages read the result.

The constants are the model's c and the steps h of the groups, so products of parameters with h are such values; a
division by one becomes a product with its reciprocal.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass

import casadi as ca
import numpy as np

from runtime.contract.binding_time import Place, Time, binding_times, split
from runtime.contract.collection import no_collection
from runtime.contract.tape import UNUSED, Node, Tape, as_function, read_tape
from runtime.engine.invariants import hoist_invariants
from runtime.engine.program import Program


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
    with no_collection():
        return _prepared(program, z_size, c_size)


def _prepared(program: Program, z_size: int, c_size: int) -> Prepared:
    program, z_size = hoist_invariants(program, z_size)
    tapes = {stage.name(): _with_reciprocals(read_tape(stage)) for stage in program.stages()}
    once, rest = split(tapes, {"c": c_size}, _input_time, Time.RUN, Place("c", c_size))
    c = ca.SX.sym("c", c_size)
    constants = ca.Function("prepare", [c], [ca.densify(ca.vertcat(c, as_function("more", once)(c)))])
    return Prepared(program.map(lambda stage: as_function(stage.name(), rest[stage.name()])), z_size, constants)


def _input_time(name: str, entry: int) -> Time:
    return Time.RUN if name == "c" else Time.STEP


def _with_reciprocals(tape: Tape) -> Tape:
    """x / k with k known as x (1 / k), and divisions by one unknown y as products with one reciprocal of y."""
    times = binding_times(tape, _input_time)
    divisions = {
        k for k, node in enumerate(tape.nodes) if node.op == ca.OP_DIV and times[k] == Time.STEP and node.b != UNUSED
    }
    divisors = Counter(tape.nodes[k].b for k in divisions)
    nodes: list[Node] = []
    number: list[int] = []
    reciprocal: dict[int, int] = {}

    def added(op: int, a: int, b: int = UNUSED, value: float = 0.0) -> int:
        nodes.append(Node(op, a, b, value))
        return len(nodes) - 1

    # an entry of the prepared constants that holds 1, which SX cannot fold back into the divisions
    one = added(ca.OP_INV, added(ca.OP_CONST, UNUSED, UNUSED, 1.0))
    for k, node in enumerate(tape.nodes):
        known = k in divisions and times[node.b] == Time.RUN
        if known or (k in divisions and divisors[node.b] > 1):
            y = number[node.b]
            if node.b not in reciprocal:
                reciprocal[node.b] = added(ca.OP_INV, y) if known else added(ca.OP_DIV, one, y)
            number.append(added(ca.OP_MUL, number[node.a], reciprocal[node.b]))
        elif node.op in (ca.OP_CONST, ca.OP_INPUT):
            number.append(added(*node))
        else:
            number.append(added(node.op, number[node.a], UNUSED if node.b == UNUSED else number[node.b]))
    outputs = [[number[k] for k in entries] for entries in tape.outputs]
    return Tape(tape.input_names, tape.input_sizes, tape.output_names, tape.output_shapes, nodes, outputs)
