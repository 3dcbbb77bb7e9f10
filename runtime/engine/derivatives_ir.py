"""A step program that records, and its way back, as LLVM IR.

    void record(ptr z, ptr c, ptr w, ptr tape, i64 n)     applies the program n times to z, and records on the tape
    void reverse(ptr z, ptr c, ptr w, ptr tape, i64 n)    carries z = [zbar, cbar] back over n recorded applications

What runs forward has the bits of the program itself; the adjoints may round a product and its sum once. A tape holds
the numbers of one application after another; `reverse` begins at their end.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

from runtime.contract.tape import read_tape
from runtime.engine.derivatives import Back
from runtime.engine.llvm_ir import Form
from runtime.engine.llvm_operations import Operations
from runtime.engine.llvm_stage import StageWriter
from runtime.engine.program import Call, Program, Repeat, Until

ARGUMENTS = "ptr noalias %z{run}, ptr noalias readonly %c, ptr noalias %w, ptr noalias %tape, i64 %n"


def reversal_ir(back: Back, z_size: int, adjoint_size: int, form: Form) -> tuple[str, int]:
    """(IR text of the module, entries of the work array)."""
    writer = _ReversalWriter(form)
    record = writer.entry("record", writer.recorded(back), back.records, z_size, forward=True)
    reverse = writer.entry("reverse", writer.reversed(back), back.records, adjoint_size, forward=False)
    count = f"@records = constant i64 {back.records}"
    declared = "declare void @llvm.memcpy.p0.p0.i64(ptr, ptr, i64, i1)"
    return "\n".join([writer.exact.functions(), declared, count, *writer.parts, record, reverse]), writer.work


@dataclass
class _ReversalWriter:
    form: Form
    parts: list[str] = field(default_factory=list)
    work: int = 0
    loops: int = 0
    names: dict[str, str] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self.exact = Operations(1, self.form.mathematics, self.form.inline)
        self.fused = Operations(1, self.form.mathematics, self.form.inline, fused=True)
        self.fused.tables = self.exact.tables

    # ---- forward ------------------------------------------------------------------------------------------------

    def recorded(self, back: Back) -> list[str]:
        """Lines that run and record."""
        if back.stage is not None and back.forward is not None:
            save = self._save(back.stage.saved)
            run = self._run(back.forward)
            return [*run, *save] if back.after else [*save, *run]
        return self._again(back, [line for part in back.parts for line in self.recorded(part)])

    def _run(self, program: Program) -> list[str]:
        if isinstance(program, Call):
            function = self._function(program.stage.name(), lambda: program.stage, self.exact, ())
            return [f"  call void @{function}(ptr %z, ptr %c, ptr %w)"]
        if isinstance(program, Until):
            return self._loop(self._run(program.body), program.limit, program.flag)
        inner = [line for part in getattr(program, "parts", ()) for line in self._run(part)]
        return self._loop(self._run(program.body), program.count) if isinstance(program, Repeat) else inner

    def _save(self, entries: tuple[int, ...]) -> list[str]:
        """Put entries of z on the tape, and move on."""
        if not entries:
            return []
        key = f"save {entries}"
        if key not in self.names:
            self.names[key] = f"save_{len(self.names)}"
            lines = [
                f"define internal void @{self.names[key]}(ptr noalias %z, ptr noalias %s) nounwind alwaysinline {{"
            ]
            for n, k in enumerate(entries):
                lines += [
                    f"  %a{n} = getelementptr double, ptr %z, i64 {k}\n  %v{n} = load double, ptr %a{n}",
                    f"  %b{n} = getelementptr double, ptr %s, i64 {n}\n  store double %v{n}, ptr %b{n}",
                ]
            self.parts.append("\n".join([*lines, "  ret void", "}"]))
        k = self._number()
        return [
            f"  %s{k} = load ptr, ptr %at",
            f"  call void @{self.names[key]}(ptr %z, ptr %s{k})",
            f"  %t{k} = getelementptr double, ptr %s{k}, i64 {len(entries)}",
            f"  store ptr %t{k}, ptr %at",
        ]

    # ---- back ---------------------------------------------------------------------------------------------------

    def reversed(self, back: Back) -> list[str]:
        """Lines that carry the adjoint state back."""
        if back.stage is None:
            parts = [line for part in reversed(back.parts) for line in self.reversed(part)]
            return self._again(back, parts)
        stage = back.stage
        function = self._function(stage.function.name(), lambda: stage.function, self.fused, ("s",))
        k = self._number()
        return [
            f"  %t{k} = load ptr, ptr %at",
            f"  %s{k} = getelementptr double, ptr %t{k}, i64 {-len(stage.saved)}",
            f"  store ptr %s{k}, ptr %at",
            f"  call void @{function}(ptr %z, ptr %c, ptr %w, ptr %s{k})",
        ]

    # ---- both ---------------------------------------------------------------------------------------------------

    def _function(self, name: str, stage: Callable[[], object], operations: Operations, arrays: tuple[str, ...]) -> str:
        """Name of the IR function of a stage, written once."""
        if name not in self.names:
            self.names[name] = f"stage_{len(self.names)}"
            tape = read_tape(stage())  # type: ignore[arg-type]
            writer = StageWriter(self.names[name], tape, operations, self.form.chunk, False, self.form.inline, arrays)
            functions, entries = writer.functions()
            self.parts += functions
            self.work = max(self.work, entries)
        return self.names[name]

    def _number(self) -> int:
        self.loops += 1
        return self.loops

    def _again(self, back: Back, lines: list[str]) -> list[str]:
        return lines if back.count == 1 else self._loop(lines, back.count)

    def _loop(self, body: list[str], limit: int | str, flag: int | None = None) -> list[str]:
        """The body so many times; with a flag, while z[flag] > 0."""
        k = self._number()
        test = [f"  %go{k} = icmp slt i64 %i{k}, {limit}"]
        if flag is not None:
            test = [
                f"  %below{k} = icmp slt i64 %i{k}, {limit}",
                f"  %f{k}p = getelementptr double, ptr %z, i64 {flag}\n  %f{k} = load double, ptr %f{k}p",
                f"  %g{k} = fcmp ogt double %f{k}, 0.0\n  %go{k} = and i1 %below{k}, %g{k}",
            ]
        return [
            f"  store i64 0, ptr %j{k}\n  br label %head{k}\nhead{k}:\n  %i{k} = load i64, ptr %j{k}",
            *test,
            f"  br i1 %go{k}, label %body{k}, label %done{k}\nbody{k}:",
            *body,
            f"  %n{k} = add i64 %i{k}, 1\n  store i64 %n{k}, ptr %j{k}\n  br label %head{k}\ndone{k}:",
        ]

    def entry(self, name: str, body: list[str], records: int, size: int, forward: bool) -> str:
        """An entry function: n times the body, on a copy of z where that is to stay in registers."""
        lines = self._loop(body, "%n")
        counters = [f"  %j{k} = alloca i64" for k in range(1, self.loops + 1)]
        local = self.form.inline
        copy = "  call void @llvm.memcpy.p0.p0.i64(ptr {to}, ptr {of}, i64 {n}, i1 false)"
        head = f"define void @{name}({ARGUMENTS.format(run='_run' if local else '')}) nounwind {{"
        lines = [
            *counters,
            "  %at = alloca ptr",
            *([f"  %z = alloca [{size} x double], align 64", copy.format(to="%z", of="%z_run", n=8 * size)] * local),
            *([] if forward else [f"  %all = mul i64 %n, {records}"]),
            f"  %begin = getelementptr double, ptr %tape, i64 {0 if forward else '%all'}\n  store ptr %begin, ptr %at",
            *lines,
            *([copy.format(to="%z_run", of="%z", n=8 * size)] * local),
        ]
        return "\n".join([head, *lines, "  ret void", "}", ""])
