"""The derivative of a step program: along directions, or backwards by recorded values.

`tangent_program` is a program again, on [z, dz] and [c, dc]: any engine runs it, in lanes one direction a lane.
`reversal` is the way back: each stage has an adjoint, which reads what was recorded of z before the stage ran. Both
take an iteration at its fixed point, so nothing of its course is recorded.
"""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import casadi as ca
import numpy as np

from runtime.contract.tape import read_tape, shared
from runtime.engine.llvm_code import (
    BEST,
    FIRST_EFFORT,
    INLINED,
    OPTIMISED,
    Code,
    Compiler,
    ProgramCompiler,
    Tier,
    Tiers,
    best_tier,
    first_tier,
    host,
    program_digest,
    program_length,
    written_out,
)
from runtime.engine.llvm_ir import MEMCPY, Operations, StageWriter, entry, loop
from runtime.engine.native import blocks_of
from runtime.engine.program import Call, Form, Program, Repeat, Sequence, Until

# ---- Derivatives of one stage of a step program, and of an iteration at what it has converged to.
#
# Of a stage z' = S(z, c), with dots along a direction and bars for the derivative of a number by what stands below:
#
#     tangent   dz' = S_z dz + S_c dc
#     adjoint   zbar = S_z^T zbar',   cbar = cbar' + S_c^T cbar'
#
# An iteration x <- G(x, r, c) on the entries x that its body changes is differentiated by the implicit-function theorem
# at its end, however it got there: (1 - G_x) dx = G_r dr + G_c dc, and for the adjoint (1 - G_x)^T l = xbar',
# rbar = rbar' + G_r^T l, cbar = cbar' + G_c^T l, xbar = 0.


@dataclass(frozen=True)
class Active:
    """Entries of z (z_size) and c (c_size) by which is differentiated, ascending: all others count as fixed."""

    z: tuple[int, ...]
    c: tuple[int, ...]
    z_size: int
    c_size: int

    @property
    def size(self) -> int:
        """Entries of a tangent [dz, dc], or of an adjoint state [zbar, cbar]."""
        return len(self.z) + len(self.c)

    def spread(self, dz: ca.SX, dc: ca.SX) -> ca.SX:
        """(z_size + c_size,) with structural zeros in what is fixed."""
        whole = ca.SX(self.z_size + self.c_size, 1)
        whole[list(self.z)] = dz
        whole[[self.z_size + k for k in self.c]] = dc
        return whole


@dataclass(frozen=True)
class AdjointStage:
    """function: ([zbar, cbar], c, saved) -> [zbar, cbar] before the stage; saved: the entries of z that it reads.

    They are those before the stage, of an iteration those after it.
    """

    function: ca.Function
    saved: tuple[int, ...]


class StageDerivatives:
    """The derivatives of a stage by what is active; iterated: the stage is the body of an iteration."""

    def __init__(self, stage: ca.Function, active: Active, iterated: bool = False) -> None:
        self.name, self.active = stage.name(), active
        self.z, self.c = ca.SX.sym("z", active.z_size), ca.SX.sym("c", active.c_size)
        self.by = ca.vertcat(self.z, self.c)
        self.next = stage(self.z, self.c)
        rows = list(active.z)
        self.moving = self.next[rows]
        self.iterated = [n for n, k in enumerate(rows) if not _passed_on(self.next, k, self.z)] if iterated else []

    def tangent(self) -> ca.Function:
        """([z, dz], [c, dc]) -> [z', dz']; of an iteration [z, dz'], for it has been made before."""
        dz, dc = ca.SX.sym("dz", len(self.active.z)), ca.SX.sym("dc", len(self.active.c))
        if not self.iterated:
            after, following = self._along(self.moving, dz, dc), self.next
        else:
            kept, after = ca.SX(dz), ca.SX(dz)
            kept[self.iterated] = 0
            pushed = self._along(self.moving[self.iterated], ca.sparsify(kept), dc)
            after[self.iterated] = ca.solve(self._of_iteration(), pushed)
            following = self.z
        return _function(
            f"{self.name}_tangent",
            [ca.vertcat(self.z, dz), ca.vertcat(self.c, dc)],
            ca.vertcat(following, after),
            ["z", "c"],
        )

    def adjoint(self) -> AdjointStage:
        """See AdjointStage."""
        zbar, cbar = ca.SX.sym("zbar", len(self.active.z)), ca.SX.sym("cbar", len(self.active.c))
        if not self.iterated:
            pulled = ca.jtimes(self.moving, self.by, zbar, True)
        else:
            multipliers = ca.solve(self._of_iteration().T, zbar[self.iterated])
            pulled = ca.jtimes(self.moving[self.iterated], self.by, multipliers, True)
            through = ca.SX(zbar)
            through[self.iterated] = 0
            columns = [self.active.z[n] for n in self.iterated]
            pulled[columns] = 0
            pulled += self.active.spread(through, ca.SX.zeros(len(self.active.c)))
        before = ca.vertcat(pulled[list(self.active.z)], cbar + pulled[[self.active.z_size + k for k in self.active.c]])
        before = shared([ca.densify(before)])[0]
        read = {symbol.name() for symbol in ca.symvar(before)}
        entries = ca.vertsplit(self.z) if self.active.z_size else []
        saved = tuple(k for k, entry in enumerate(entries) if entry.name() in read)
        kept = ca.vertcat(*(entries[k] for k in saved)) if saved else ca.SX(0, 1)
        inputs = [ca.vertcat(zbar, cbar), self.c, kept]
        return AdjointStage(_function(f"{self.name}_adjoint", inputs, before, ["z", "c", "s"]), saved)

    def _along(self, rows: ca.SX, dz: ca.SX, dc: ca.SX) -> ca.SX:
        return ca.jtimes(rows, self.by, self.active.spread(dz, dc))

    def _of_iteration(self) -> ca.SX:
        """1 - G_x."""
        x = ca.vertcat(*(self.z[self.active.z[n]] for n in self.iterated))
        return ca.SX.eye(len(self.iterated)) - ca.jacobian(self.moving[self.iterated], x)


def body_of(program: Program) -> ca.Function:
    """The stages of a part of a program as one Function (z, c) -> z. Raises TypeError for an iteration inside it."""
    if isinstance(program, Call):
        return program.stage
    parts = [program.body] * program.count if isinstance(program, Repeat) else list(getattr(program, "parts", ()))
    if not parts:
        raise TypeError("an iteration inside an iteration has no derivative here")
    bodies = [body_of(part) for part in parts]
    z, c = ca.SX.sym("z", bodies[0].size1_in(0)), ca.SX.sym("c", bodies[0].size1_in(1))
    following = z
    for body in bodies:
        following = body(following, c)
    return ca.Function(bodies[0].name(), [z, c], [following], ["z", "c"], ["z_next"])


def _passed_on(following: ca.SX, k: int, z: ca.SX) -> bool:
    """Is an entry what it was?"""
    return bool(ca.is_equal(following[k], z[k], 0))


def _function(name: str, inputs: list[ca.SX], output: ca.SX, names: list[str]) -> ca.Function:
    function = ca.Function(name, inputs, shared([ca.densify(output)]), names, ["z_next"])
    read_tape(function)  # raises where an operation has none
    return function


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


# ---- A step program that records, and its way back, as LLVM IR.
#
#     void record(ptr z, ptr c, ptr w, ptr tape, i64 n)     applies the program n times to z, and records on the tape
#     void reverse(ptr z, ptr c, ptr w, ptr tape, i64 n)    carries z = [zbar, cbar] back over n recorded applications
#
# What runs forward has the bits of the program itself; the adjoints may round a product and its sum once. A tape holds
# the numbers of one application after another; `reverse` begins at their end.

ARGUMENTS = "ptr noalias %z{run}, ptr noalias readonly %c, ptr noalias %w, ptr noalias %tape, i64 %n"


def reversal_ir(back: Back, z_size: int, adjoint_size: int, form: Form) -> tuple[str, int]:
    """(IR text of the module, entries of the work array)."""
    writer = _ReversalWriter(form)
    record = writer.entry("record", writer.recorded(back), back.records, z_size, forward=True)
    reverse = writer.entry("reverse", writer.reversed(back), back.records, adjoint_size, forward=False)
    count = f"@records = constant i64 {back.records}"
    return "\n".join([writer.exact.functions(), MEMCPY, count, *writer.parts, record, reverse]), writer.work


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
        test = [
            f"  %f{k}p = getelementptr double, ptr %z, i64 {flag}\n  %f{k} = load double, ptr %f{k}p",
            f"  %g{k} = fcmp ogt double %f{k}, 0.0\n  %go{k} = and i1 %below{k}, %g{k}",
        ]
        return loop(k, body, limit, () if flag is None else test)

    def entry(self, name: str, body: list[str], records: int, size: int, forward: bool) -> str:
        """An entry function: n times the body."""
        local, lines = self.form.inline, self._loop(body, "%n")
        head = f"define void @{name}({ARGUMENTS.format(run='_run' if local else '')}) nounwind {{"
        begin = [
            "  %at = alloca ptr",
            *([] if forward else [f"  %all = mul i64 %n, {records}"]),
            f"  %begin = getelementptr double, ptr %tape, i64 {0 if forward else '%all'}\n  store ptr %begin, ptr %at",
        ]
        return entry(head, self.loops, [*begin, *lines], size, "double", 8, local)


# ---- Machine code for derivatives: a program along directions in lanes, and a program that records with its way
# back.

ADJOINT = 4  # operations of a stage with its adjoint, of one of the stage
MAX_CODE_STATEMENTS = 1000  # statements of a function of the first code
Entry = Callable[[int, int, int, int, int], None]


def most_lanes() -> int:
    """Values in a register of this processor, at least 2."""
    features = host().features
    return 8 if "+avx512f" in features else 4 if "+avx2" in features else 2


class LaneArrays:
    """z (rows, width) and c (rows, width) where native code expects them: every row begins at its own alignment."""

    def __init__(self, z_rows: int, c_rows: int, width: int) -> None:
        self.width = width
        self.z, self.c = (blocks_of(1, rows, width)[0] for rows in (z_rows, c_rows))


class TangentCode:
    """A program on [z, dz] and [c, dc] in lanes: one direction a lane. For one thread at a time. Raises NoLlvm."""

    def __init__(self, program: Program, active: Active, width: int, wait: bool = False) -> None:
        tangents, self.width = tangent_program(program, active), width
        first, best = (chosen(tangents, "own") for chosen in (first_tier, best_tier))
        first, best = (tier._replace(form=tier.form._replace(width=width)) for tier in (first, best))
        self.tiers = Tiers(ProgramCompiler(tangents), first, best, program_length(tangents), wait)
        self._work = blocks_of(1, 1, width)[0]

    def run(self, arrays: LaneArrays, n: int) -> None:
        """Apply the program n times, in place."""
        self.tiers.use(lambda code: self._go(code, arrays, n))

    def _go(self, code: Code, arrays: LaneArrays, n: int) -> None:
        if len(self._work) < code.work + 1:
            self._work = blocks_of(1, code.work + 1, self.width)[0]
        code.run(arrays.z.ctypes.data, arrays.c.ctypes.data, self._work.ctypes.data, n)


class _Recording(NamedTuple):
    record: Entry
    reverse: Entry
    records: int
    work: int
    keep: Any


class _ReversalCompiler(Compiler[_Recording]):
    """Of a program that records, with its way back; kept, neither derivatives nor code have to be made."""

    def __init__(self, program: Program, active: Active) -> None:
        self._program, self._active = program, active
        super().__init__(program_digest(program) + repr(active).encode())

    def printed(self, form: Form) -> tuple[str, int]:
        back = reversal(self._program, self._active)
        return reversal_ir(back, self._active.z_size, self._active.size, form)

    def loaded(self, engine: Any, work: int) -> _Recording:
        kind = ctypes.CFUNCTYPE(None, *[ctypes.c_void_p] * 4, ctypes.c_int64)
        record, reverse = (kind(engine.get_function_address(name)) for name in ("record", "reverse"))
        records = ctypes.c_int64.from_address(engine.get_global_value_address("records")).value
        return _Recording(record, reverse, records, work, engine)


class Recorder:
    """A program that records what its way back reads. For one thread at a time. Raises NoLlvm.

    records: numbers that one application puts on the tape.
    """

    def __init__(self, program: Program, active: Active, wait: bool = False) -> None:
        size = ADJOINT * program_length(program)
        chunk, inline = (300, False) if size > OPTIMISED else (0, written_out(program) <= INLINED)
        best = Tier(Form(1, "own", chunk, inline), BEST)
        first = Tier(Form(1, "own", MAX_CODE_STATEMENTS, False), FIRST_EFFORT)
        self.tiers = Tiers(_ReversalCompiler(program, active), first, best, size, wait)
        self.records = self.tiers.code.records
        self._work = np.zeros(1)

    def record(self, z: np.ndarray, c: np.ndarray, tape: np.ndarray, n: int) -> None:
        """Apply the program n times to z (z_size,), in place; the tape takes n times `records` numbers."""
        self.tiers.use(lambda code: self._go(code, code.record, (z, c, tape), n))

    def reverse(self, adjoint: np.ndarray, c: np.ndarray, tape: np.ndarray, n: int) -> None:
        """[zbar, cbar] after n recorded applications becomes that before them, in place."""
        self.tiers.use(lambda code: self._go(code, code.reverse, (adjoint, c, tape), n))

    def _go(self, code: _Recording, entry: Entry, arrays: tuple[np.ndarray, np.ndarray, np.ndarray], n: int) -> None:
        z, c, tape = (array.ctypes.data for array in arrays)
        if len(self._work) < code.work + 1:
            self._work = np.zeros(code.work + 1)
        entry(z, c, self._work.ctypes.data, tape, n)
