"""What a step computes from the run's constants alone is computed once: c -> [c, more], stages read the result.

The constants are the model's c and the steps h of the groups, so products of parameters with h are such values; a
division by one becomes a product with its reciprocal.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, replace
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
from runtime.engine.program import LONG_STAGE_NODES, Call, Program, Repeat, Sequence, Until
from runtime.engine.rows import Direct

# ---- Loop-invariant values of a repeated part are computed once before it: sub-steps keep only what changes in
# them.
#
# For Repeat(body): entries of z that no stage of the body changes are held during the repetition, and so is all that
# follows from them and from c. Such values get entries of their own at the end of z, filled by a stage before the
# repetition. What follows from c alone is left to prepare.py, which computes it once a run.


def hoist_invariants(program: Program, z_size: int) -> tuple[Program, int]:
    """(the program with invariants taken out of its repetitions, the length of its z).

    Stages that are not concerned still take and give a shorter z: `widened` makes their tapes as long as the others.
    """
    hoister = _Hoister(z_size)
    return program.fold(Call, lambda parts: Sequence(tuple(parts)), hoister.again), hoister.size


def widened(tape: Tape, size: int) -> Tape:
    """A stage's tape on z of the final length: it leaves alone what it does not know."""
    known = len(tape.outputs[0])
    if tape.input_sizes[0] == known == size:
        return tape
    behind = [Node(ca.OP_INPUT, 0, entry, 0.0) for entry in range(known, size)]
    passed = range(len(tape.nodes), len(tape.nodes) + len(behind))
    return replace(
        tape,
        input_sizes=[size, *tape.input_sizes[1:]],
        output_shapes=[(size, 1)],
        nodes=[*tape.nodes, *behind],
        outputs=[[*tape.outputs[0], *passed]],
    )


class _Hoister:
    def __init__(self, z_size: int) -> None:
        self.size = z_size
        self._repetitions = 0

    def again(self, body: Program, node: Repeat | Until) -> Program:
        """The repetition, after a stage for what it holds."""
        if isinstance(node, Until):
            return Until(body, node.flag, node.limit, node.usual)
        if node.count < 2 or not _only_calls(body):
            return Repeat(body, node.count)
        tapes = {stage.name(): read_tape(stage) for stage in body.stages()}
        changed = {k for tape in tapes.values() for k in _changed(tape)}
        first, c_size = self.size, body.stages()[0].size1_in(1)

        def of_input(name: str, entry: int) -> Time:
            return Time.RUN if name == "c" else Time.STEP if entry in changed else Time.REPETITION

        once, rest = split(tapes, {"z": first, "c": c_size}, of_input, Time.REPETITION, Place("z", first))
        if not once.outputs[0]:
            return Repeat(body, node.count)
        self.size += len(once.outputs[0])
        self._repetitions += 1
        ending = f"_{self._repetitions}"  # a stage may stand in several repetitions, each with entries of its own
        inside = body.map(lambda stage: as_function(stage.name() + ending, rest[stage.name()]))
        return Sequence((Call(_before(f"before{ending}", once)), Repeat(inside, node.count)))


def _only_calls(body: Program) -> bool:
    return body.fold(lambda stage: True, all, lambda inner, node: False)


def _changed(tape: Tape) -> list[int]:
    """Entries of z that a stage does not pass on as they are."""
    return [
        entry
        for entry, k in enumerate(tape.outputs[0])
        if tape.nodes[k].op != ca.OP_INPUT or tape.nodes[k].b != entry or tape.input_names[tape.nodes[k].a] != "z"
    ]


def _before(name: str, once: Tape) -> ca.Function:
    """The stage that fills the held entries, behind the others of z."""
    z, c = (ca.SX.sym(label, size) for label, size in zip(once.input_names, once.input_sizes, strict=True))
    z_next = ca.densify(ca.vertcat(z, as_function("held", once)(z, c)))
    return ca.Function(name, [z, c], [z_next], ["z", "c"], ["z_next"])


@dataclass(frozen=True, eq=False)
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

    @cached_property
    def ready(self) -> Direct:
        """c -> the constants as an array for an engine."""
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
    return Prepared(program.map(lambda stage: as_function(stage.name(), rest[stage.name()])), z_size, constants)


def _input_time(name: str, entry: int) -> Time:
    return Time.RUN if name == "c" else Time.STEP


def _shared(tape: Tape) -> Tape:
    """What stands twice in a long stage once; short ones share it already (see make_stage)."""
    return tape if len(tape.nodes) <= LONG_STAGE_NODES else without_repetitions(tape)


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
