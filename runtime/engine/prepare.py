"""What a step computes from the run's constants alone is computed once: c -> [c, more], stages read the result.

The constants are the model's c and the steps h of the groups, so products of parameters with h are such values; a
division by one becomes a product with its reciprocal.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property

import casadi as ca
import numpy as np

from runtime.contract.tape import (
    UNUSED,
    Node,
    Place,
    Tape,
    Time,
    as_function,
    binding_times,
    no_collection,
    read_tape,
    split,
    without_repetitions,
)
from runtime.engine.direct import Direct
from runtime.engine.invariants import hoist_invariants, widened
from runtime.engine.program import LONG, Program


@dataclass(frozen=True, eq=False)
class Prepared:
    """A program as it is run: z has z_size entries, the first of which are the scheme's; constants(c) is what it reads.

    The first entries of constants(c) are c. tapes: of the stages, by name, for who compiles them at once.
    """

    program: Program
    z_size: int
    constants: ca.Function
    tapes: Mapping[str, Tape] = field(default_factory=dict)

    def widened(self, z: np.ndarray) -> np.ndarray:
        """A scheme's z with room for what the program keeps besides."""
        return np.concatenate([z, np.zeros(self.z_size - len(z))])

    def ready(self, c: np.ndarray) -> np.ndarray:
        """The constants as an array for an engine."""
        return self._constants(c)

    @cached_property
    def _constants(self) -> Direct:
        return Direct(self.constants)


def prepare(program: Program, z_size: int, c_size: int) -> Prepared:
    """The program with what a repetition or the run's constants fix taken out of its stages."""
    with no_collection():
        return _prepared(program, z_size, c_size)


def _prepared(program: Program, z_size: int, c_size: int) -> Prepared:
    program, z_size = hoist_invariants(program, z_size)
    tapes = {stage.name(): _with_reciprocals(_shared(widened(read_tape(stage), z_size))) for stage in program.stages()}
    once, rest = split(tapes, {"c": c_size}, _input_time, Time.RUN, Place("c", c_size))
    c = ca.SX.sym("c", c_size)
    constants = ca.Function("prepare", [c], [ca.densify(ca.vertcat(c, as_function("more", once)(c)))])
    program = program.map(lambda stage: as_function(stage.name(), rest[stage.name()]))
    lengths = {stage.name(): stage.n_instructions() for stage in program.stages()}
    return Prepared(
        program, z_size, constants, {name: tape for name, tape in rest.items() if _is_of(tape, lengths[name])}
    )


def _is_of(tape: Tape, length: int) -> bool:
    """Is a tape that of its Function? It is unless CasADi found something to simplify."""
    return tape.instructions == length


def _input_time(name: str, entry: int) -> Time:
    return Time.RUN if name == "c" else Time.STEP


def _shared(tape: Tape) -> Tape:
    """What stands twice in a long stage once; short ones share it already (see make_stage)."""
    return tape if len(tape.nodes) <= LONG else without_repetitions(tape)


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
            b = UNUSED if node.b == UNUSED else number[node.b]
            number.append(added(node.op, number[node.a], b, node.value))
    outputs = [[number[k] for k in entries] for entries in tape.outputs]
    return Tape(tape.input_names, tape.input_sizes, tape.output_names, tape.output_shapes, nodes, outputs)
