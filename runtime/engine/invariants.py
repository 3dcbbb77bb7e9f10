"""Loop-invariant values of a repeated part are computed once before it: sub-steps keep only what changes in them.

For Repeat(body): entries of z that no stage of the body changes are constant during the repetition, and so is all that
follows from them and from c. Such values get entries of their own at the end of z, filled by a stage before the
repetition. What follows from c alone is left to prepare.py, which computes it once a run.
"""

from __future__ import annotations

from dataclasses import replace

import casadi as ca

from runtime.contract.tape import UNUSED, Node, Tape, read_tape
from runtime.engine.program import Call, Program, Repeat, Sequence, Until, stages

Z_ARGUMENT = 0


def hoist_invariants(program: Program, z_size: int) -> tuple[Program, int]:
    """(the program with invariants taken out of its repetitions, the length of its z)."""
    hoister = _Hoister(z_size)
    rebuilt = hoister.visit(program)
    return hoister.widened(rebuilt), hoister.size


class _Hoister:
    def __init__(self, z_size: int) -> None:
        self.z_size = self.size = z_size
        self._stages = 0

    def visit(self, node: Program) -> Program:
        if isinstance(node, Call):
            return node
        if isinstance(node, Sequence):
            return Sequence(tuple(self.visit(part) for part in node.parts))
        if isinstance(node, Until):
            return replace(node, body=self.visit(node.body))
        if node.count < 2 or not _only_calls(node.body):
            return Repeat(self.visit(node.body), node.count)
        return self._repeat(node)

    def _repeat(self, node: Repeat) -> Program:
        tapes = {stage.name(): read_tape(stage) for stage in stages(node.body)}
        changed = {
            entry
            for tape in tapes.values()
            for entry, k in enumerate(tape.outputs[0])
            if not _passes(tape.nodes[k], entry)
        }
        before: list[Program] = []
        rebuilt: dict[str, ca.Function] = {}
        for name, tape in tapes.items():
            found = _invariant_nodes(tape, changed)
            if not found:
                continue
            entries = {k: self.size + position for position, k in enumerate(found)}
            self.size += len(found)
            self._stages += 1
            before.append(Call(_stage(f"before_{self._stages}_{name}", tape, {}, entries, self.size)))
            # a stage may stand in several repetitions, each with entries of its own
            rebuilt[name] = _stage(f"{name}_{self._stages}", tape, entries, None, self.size)
        return Sequence((*before, Repeat(_replaced(node.body, rebuilt), node.count)))

    def widened(self, node: Program) -> Program:
        """The same program on z of the final length."""
        if self.size == self.z_size:
            return node
        done: dict[str, ca.Function] = {}
        for stage in stages(node):
            z, c = ca.SX.sym("z", self.size), ca.SX.sym("c", stage.size1_in(1))
            n = stage.size1_in(0)
            result = stage(z[:n], c)
            done[stage.name()] = ca.Function(stage.name(), [z, c], [ca.vertcat(result, z[n:])], ["z", "c"], ["z_next"])
        return _replaced(node, done)


def _only_calls(node: Program) -> bool:
    if isinstance(node, Sequence):
        return all(isinstance(part, Call) for part in node.parts)
    return isinstance(node, Call)


def _passes(node: Node, entry: int) -> bool:
    return node.op == ca.OP_INPUT and node.a == Z_ARGUMENT and node.b == entry


def _invariant_nodes(tape: Tape, changed: set[int]) -> list[int]:
    """The largest operations on unchanged entries of z (and c); those on c alone are not counted."""
    fixed: dict[int, bool] = {}  # node: does it read z?
    for k, node in enumerate(tape.nodes):
        if node.op == ca.OP_CONST:
            fixed[k] = False
        elif node.op == ca.OP_INPUT:
            if node.a != Z_ARGUMENT:
                fixed[k] = False
            elif node.b not in changed:
                fixed[k] = True
        elif node.a in fixed and (node.b == UNUSED or node.b in fixed):
            fixed[k] = fixed[node.a] or (node.b != UNUSED and fixed[node.b])
    read = {k for entries in tape.outputs for k in entries}
    for k, node in enumerate(tape.nodes):
        if k not in fixed and node.op not in (ca.OP_INPUT, ca.OP_CONST):
            read |= {node.a, node.b}
    return [
        k
        for k, reads_z in fixed.items()
        if reads_z and k in read and tape.nodes[k].op not in (ca.OP_INPUT, ca.OP_CONST)
    ]


def _stage(name: str, tape: Tape, held: dict[int, int], wanted: dict[int, int] | None, size: int) -> ca.Function:
    """The stage with `held` nodes read from z; with `wanted`, only those nodes, written to their entries."""
    z, c = ca.SX.sym("z", size), ca.SX.sym("c", tape.input_sizes[1])
    inputs = [ca.vertsplit(z), ca.vertsplit(c)]
    values: list[ca.SX] = []
    for k, node in enumerate(tape.nodes):
        if k in held:
            values.append(inputs[Z_ARGUMENT][held[k]])
        elif node.op == ca.OP_CONST:
            values.append(ca.SX(node.value))
        elif node.op == ca.OP_INPUT:
            values.append(inputs[node.a][node.b])
        elif node.b == UNUSED:
            values.append(ca.SX.unary(node.op, values[node.a]))
        else:
            values.append(ca.SX.binary(node.op, values[node.a], values[node.b]))
    out = list(inputs[Z_ARGUMENT])
    if wanted is None:
        out[: len(tape.outputs[0])] = [values[k] for k in tape.outputs[0]]
    else:
        for k, entry in wanted.items():
            out[entry] = values[k]
    return ca.Function(name, [z, c], [ca.densify(ca.vertcat(*out))], ["z", "c"], ["z_next"])


def _replaced(node: Program, functions: dict[str, ca.Function]) -> Program:
    if isinstance(node, Call):
        return Call(functions.get(node.stage.name(), node.stage))
    if isinstance(node, Sequence):
        return Sequence(tuple(_replaced(part, functions) for part in node.parts))
    if isinstance(node, Repeat):
        return Repeat(_replaced(node.body, functions), node.count)
    return replace(node, body=_replaced(node.body, functions))
