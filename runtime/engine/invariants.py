"""Loop-invariant values of a repeated part are computed once before it: sub-steps keep only what changes in them.

For Repeat(body): entries of z that no stage of the body changes are held during the repetition, and so is all that
follows from them and from c. Such values get entries of their own at the end of z, filled by a stage before the
repetition. What follows from c alone is left to prepare.py, which computes it once a run.
"""

from __future__ import annotations

from dataclasses import replace

import casadi as ca

from runtime.contract.tape import Node, Place, Tape, Time, as_function, read_tape, split
from runtime.engine.program import Call, Program, Repeat, Sequence, Until


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
