"""A step program as LLVM IR, for one run or for several in lanes: the same operations in the same order at every width.

    void run(ptr z, ptr c, ptr w, i64 n)        applies the program n times to z; w is a work array
    void run_blocks(ptr z, ptr c, ptr w, i64 n, i64 blocks, i64 apart)
                                                the same for so many z and c, each `apart` bytes behind the one before

Entry e of lane l is at [e * width + l]. A short program copies z to a local array and has its stages inlined, so that
values stay in registers over a step; a long one has stages of several functions, since compilers take quadratic time on
long ones.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import casadi as ca

from runtime.contract.tape import Tape
from runtime.engine.llvm_operations import Operations
from runtime.engine.llvm_stage import StageWriter
from runtime.engine.mathematics import Lanes
from runtime.engine.program import Program, Repeat, Until


class Form(NamedTuple):
    """How a program is printed: lanes, mathematics (own or library), statements a function, stages inlined or not."""

    width: int = 1
    mathematics: str = "own"
    chunk: int = 0
    inline: bool = True


RUN_BLOCKS = """
define void @run_blocks(ptr %z, ptr %c, ptr %w, i64 %n, i64 %blocks, i64 %apart) nounwind {
entry:
  br label %head
head:
  %k = phi i64 [ 0, %entry ], [ %next, %body ]
  %go = icmp slt i64 %k, %blocks
  br i1 %go, label %body, label %done
body:
  %offset = mul i64 %k, %apart
  %zk = getelementptr i8, ptr %z, i64 %offset
  %ck = getelementptr i8, ptr %c, i64 %offset
  call void @run(ptr %zk, ptr %ck, ptr %w, i64 %n)
  %next = add i64 %k, 1
  br label %head
done:
  ret void
}
"""


def program_ir(program: Program, tapes: dict[str, Tape], form: Form) -> tuple[str, int]:
    """(IR text of the module, entries of the work array); tapes: of the stages by name."""
    operations = Operations(form.width, form.mathematics, form.inline)
    control = _Control(operations.lanes)
    body = program.fold(control.call, control.sequence, control.again)("")
    parts, work = list[str](), 0
    for (name, masked), function in control.functions.items():
        writer = StageWriter(function, tapes[name], operations, form.chunk, masked, form.inline)
        functions, entries = writer.functions()
        parts += functions
        work = max(work, entries)
    size = program.stages()[0].size1_in(0)
    parts += [operations.functions(), _run(operations.lanes, control.loops, body, size, form.inline), RUN_BLOCKS]
    return "\n".join(parts), work


Lines = Callable[[str], list[str]]  # of a part of the program, given the name of the mask of lanes ("" for all lanes)


class _Control:
    """Calls and loops as lines that begin and end in an open block; in lanes, an Until masks what is below it."""

    def __init__(self, lanes: Lanes) -> None:
        self.lanes = lanes
        self.functions: dict[tuple[str, bool], str] = {}  # (stage, masked): name
        self.loops = 0

    def call(self, stage: ca.Function) -> Lines:
        """A call of a stage."""

        def lines(mask: str) -> list[str]:
            key = (stage.name(), bool(mask))
            function = self.functions.setdefault(key, f"stage_{len(self.functions)}")
            argument = f", {self.lanes.bit} {mask}" if mask else ""
            return [f"  call void @{function}(ptr %z, ptr %c, ptr %w{argument})"]

        return lines

    def sequence(self, parts: list[Lines]) -> Lines:
        """One after another."""
        return lambda mask: [line for part in parts for line in part(mask)]

    def again(self, body: Lines, node: Repeat | Until) -> Lines:
        """A loop with a counter of its own; an Until goes on while any lane does."""

        def lines(mask: str) -> list[str]:
            self.loops += 1
            k = self.loops
            limit = node.count if isinstance(node, Repeat) else node.limit
            test, inner = ([f"  %go{k} = and i1 %below{k}, true"], mask)
            if isinstance(node, Until):
                test, inner = self._test(k, node.flag, mask)
            return [
                f"  store i64 0, ptr %j{k}",
                f"  br label %head{k}",
                f"head{k}:",
                f"  %i{k} = load i64, ptr %j{k}",
                f"  %below{k} = icmp slt i64 %i{k}, {limit}",
                *test,
                f"  br i1 %go{k}, label %body{k}, label %done{k}",
                f"body{k}:",
                *body(inner),
                f"  %n{k} = add i64 %i{k}, 1",
                f"  store i64 %n{k}, ptr %j{k}",
                f"  br label %head{k}",
                f"done{k}:",
            ]

        return lines

    def _test(self, k: int, flag: int, mask: str) -> tuple[list[str], str]:
        """z[flag] > 0 in any lane; (lines, mask of what is below)."""
        D, width = self.lanes.double, self.lanes.width
        lines = [
            f"  %a{k} = getelementptr {D}, ptr %z, i64 {flag}",
            f"  %f{k} = load {D}, ptr %a{k}, align {self.lanes.align}",
            f"  %g{k} = fcmp ogt {D} %f{k}, {self.lanes.number(0.0)}",
        ]
        if width == 1:
            return [*lines, f"  %go{k} = and i1 %below{k}, %g{k}"], ""
        lines.append(f"  %m{k} = and {self.lanes.bit} %g{k}, {mask or self.lanes.true}")
        lines.append(f"  %any{k} = call i1 @llvm.vector.reduce.or.v{width}i1({self.lanes.bit} %m{k})")
        return [*lines, f"  %go{k} = and i1 %below{k}, %any{k}"], f"%m{k}"


def _run(lanes: Lanes, loops: int, body: list[str], size: int, local: bool) -> str:
    """The entry: n times the body, on a copy of z where that is to stay in registers."""
    size_of, align = 8 * size * lanes.width, lanes.align
    lines = [f"  %j{k} = alloca i64" for k in range(loops + 1)]
    copy = "  call void @llvm.memcpy.p0.p0.i64(ptr align {a} {to}, ptr align {a} {of}, i64 {n}, i1 false)"
    if local:
        lines.append(f"  %z = alloca [{size} x {lanes.double}], align {align}")
        lines.append(copy.format(a=align, to="%z", of="%z_run", n=size_of))
    lines += [
        "  store i64 0, ptr %j0",
        "  br label %head0",
        "head0:",
        "  %i0 = load i64, ptr %j0",
        "  %go0 = icmp slt i64 %i0, %n",
        "  br i1 %go0, label %body0, label %done0",
        "body0:",
        *body,
        "  %n0 = add i64 %i0, 1",
        "  store i64 %n0, ptr %j0",
        "  br label %head0",
        "done0:",
    ]
    if local:
        lines.append(copy.format(a=align, to="%z_run", of="%z", n=size_of))
    z = "%z_run" if local else "%z"
    head = f"define void @run(ptr noalias {z}, ptr noalias readonly %c, ptr noalias %w, i64 %n) nounwind {{"
    declared = "declare void @llvm.memcpy.p0.p0.i64(ptr, ptr, i64, i1)"
    return "\n".join([declared, head, *lines, "  ret void", "}", ""])
