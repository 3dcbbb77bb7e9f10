"""The derivative of a step program: along directions, or backwards by recorded values.

`tangent_program` is a program again, on [z, dz] and [c, dc]: any engine runs it, in lanes one direction a lane.
`reversal` is the way back: each stage has an adjoint, which reads what was recorded of z before the stage ran. Both
take an iteration at its fixed point, so nothing of its course is recorded.
"""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca

from runtime.engine.derivatives_stage import Active, AdjointStage, StageDerivatives, body_of
from runtime.engine.program import Call, Program, Repeat, Sequence, Until


def tangent_program(program: Program, active: Active) -> Program:
    """The program on ([z, dz], [c, dc]), dz and dc of what is active."""
    known: dict[str, ca.Function] = {}

    def call(stage: ca.Function) -> Program:
        if stage.name() not in known:
            known[stage.name()] = StageDerivatives(stage, active).tangent()
        return Call(known[stage.name()])

    def again(body: Program, node: Repeat | Until) -> Program:
        if isinstance(node, Repeat):
            return Repeat(body, node.count)
        alone = node.body.map(lambda stage: _beside(stage, active))
        at_the_end = StageDerivatives(body_of(node.body), active, iterated=True).tangent()
        return Sequence((Until(alone, node.flag, node.limit, node.usual), Call(at_the_end)))

    return program.fold(call, lambda parts: Sequence(tuple(parts)), again)


def _beside(stage: ca.Function, active: Active) -> ca.Function:
    """The stage on [z, dz] and [c, dc], dz left as it is."""
    z, c = ca.SX.sym("z", active.z_size + len(active.z)), ca.SX.sym("c", active.c_size + len(active.c))
    following = ca.vertcat(stage(z[: active.z_size], c[: active.c_size]), z[active.z_size :])
    return ca.Function(f"{stage.name()}_alone", [z, c], [following], ["z", "c"], ["z_next"])


@dataclass(frozen=True)
class Back:
    """A part of a program with its way back.

    Of a stage, or of an iteration: `forward` is what runs, `stage` its adjoint, after: what is recorded is that after
    it. Of a sequence: parts. Of a repetition: one part, and count. records: numbers that one pass records.
    """

    records: int
    forward: Program | None = None
    stage: AdjointStage | None = None
    after: bool = False
    parts: tuple[Back, ...] = ()
    count: int = 1

    def leaves(self) -> list[Back]:
        """The parts that are stages or iterations, in order."""
        return [self] if self.stage is not None else [leaf for part in self.parts for leaf in part.leaves()]


def reversal(program: Program, active: Active) -> Back:
    """The program with the adjoints of its stages."""
    known: dict[str, AdjointStage] = {}

    def call(stage: ca.Function) -> Back:
        if stage.name() not in known:
            known[stage.name()] = StageDerivatives(stage, active).adjoint()
        found = known[stage.name()]
        return Back(len(found.saved), Call(stage), found)

    def sequence(parts: list[Back]) -> Back:
        return Back(sum(part.records for part in parts), parts=tuple(parts))

    def again(body: Back, node: Repeat | Until) -> Back:
        if isinstance(node, Repeat):
            return Back(node.count * body.records, parts=(body,), count=node.count)
        found = StageDerivatives(body_of(node.body), active, iterated=True).adjoint()
        return Back(len(found.saved), node, found, after=True)

    return program.fold(call, sequence, again)
