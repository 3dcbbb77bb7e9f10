"""A step program as LLVM IR, for one run or for several in lanes: the same operations in the same order at every width.

    void run(ptr z, ptr c, ptr w, i64 n)        applies the program n times to z; w is a work array
    void run_blocks(ptr z, ptr c, ptr w, i64 n, i64 blocks, i64 apart)
                                                the same for so many z and c, each `apart` bytes behind the one before
    void run_rows(ptr z, ptr c, ptr w, ptr counts, i64 rows, ptr out, i64 bytes)
                                                counts[k] times, then z is copied to row k of out; of one lane

Entry e of lane l is at [e * width + l]. A short program copies z to a local array and has its stages inlined, so that
values stay in registers over a step; a long one has stages of several functions, since compilers take quadratic time on
long ones.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

import casadi as ca

from runtime.contract.tape import UNUSED, Node, Tape, below, read_tape
from runtime.engine.mathematics import LIBRARY_BINARY, LIBRARY_UNARY, PURE, REPLACED, Lanes, own_functions, sincos
from runtime.engine.program import Form, Program, Repeat, Until
from runtime.engine.table_code import module_ir, table_name

# ---- Sines and cosines of angles that do not wait for each other, side by side in the lanes of one vector.
#
# A sine with its cosine is some 45 instructions, more than all that is done with them on a planar link. In lanes they
# have the same bits.

WIDTHS = (8, 4, 2)  # of vectors; filled to more than half
TRIGONOMETRIC = (ca.OP_SIN, ca.OP_COS)
Group = tuple[int, ...]  # nodes of angles


def side_by_side(nodes: Sequence[Node], order: Sequence[int]) -> tuple[list[int], dict[int, Group]]:
    """(an order in which all angles of a group are known before the first use, {sine or cosine: its group})."""
    groups = _groups(nodes, order)
    if not groups:
        return list(order), {}
    members: dict[Group, list[int]] = {}
    for k in order:
        if k in groups:
            members.setdefault(groups[k], []).append(k)
    inside, placed, found = set(order), set[int](), list[int]()

    def place(wanted: Sequence[int]) -> None:
        for k in wanted:
            if k in placed or k not in inside:
                continue
            if k in groups:
                place(below(list(nodes), groups[k], lambda one: one in placed))
            together = members[groups[k]] if k in groups else [k]
            found.extend(together)
            placed.update(together)

    place(order)
    return found, groups


def _groups(nodes: Sequence[Node], order: Sequence[int]) -> dict[int, Group]:
    """Groups of angles that wait for equally many sines and cosines, one after another."""
    level: dict[int, int] = {}
    angles: dict[int, list[int]] = {}
    for k in order:
        node = nodes[k]
        used = [one for one in (node.a, node.b) if one != UNUSED and one in level]
        level[k] = max((level[one] + (nodes[one].op in TRIGONOMETRIC) for one in used), default=0)
        if node.op in TRIGONOMETRIC:
            known = angles.setdefault(level[k], [])
            if node.a not in known:
                known.append(node.a)
    group_of: dict[int, Group] = {}
    for known in angles.values():
        while len(known) > 1:
            width = next(one for one in WIDTHS if one < 2 * len(known))
            group, known = tuple(known[:width]), known[width:]
            group_of |= dict.fromkeys(group, group)
    found = ((k, group_of.get(nodes[k].a)) for k in order if nodes[k].op in TRIGONOMETRIC)
    return {k: group for k, group in found if group is not None}


PARTNER = {ca.OP_SIN: ca.OP_COS, ca.OP_COS: ca.OP_SIN}


def partners(nodes: Sequence[Node], order: Sequence[int]) -> dict[int, int]:
    """{sine or cosine: the other one of the same angle}."""
    found = {(nodes[k].op, nodes[k].a): k for k in order if nodes[k].op in PARTNER}
    pairs = {k: found.get((PARTNER[op], angle)) for (op, angle), k in found.items()}
    return {k: other for k, other in pairs.items() if other is not None}


def divided(
    nodes: Sequence[Node], order: Sequence[int], partner: Mapping[int, int], stored: Sequence[int], size: int
) -> tuple[dict[int, int], list[list[int]], dict[int, int]]:
    """Functions of so many statements: ({node: its function}, their nodes, {node that others read: place in w})."""
    chunk_of: dict[int, int] = {}
    for position, k in enumerate(order):
        chunk_of.setdefault(k, position // size)
        if k in partner:  # a sine and its cosine come from one call, where the first of them stands
            chunk_of.setdefault(partner[k], position // size)
    slots: dict[int, int] = {}
    for k in order:
        for argument in nodes[k][1:3]:
            if argument in chunk_of and chunk_of[argument] != chunk_of[k]:
                slots.setdefault(argument, len(slots))
    for k in stored:  # an entry that moves to another place is copied before anything is stored
        if k in chunk_of or nodes[k].op == ca.OP_INPUT:
            slots.setdefault(k, len(slots))
    chunks: list[list[int]] = [[] for _ in range((len(order) - 1) // size + 1)]
    for k in order:
        chunks[chunk_of[k]].append(k)
    return chunk_of, chunks, slots


# ---- Each operation of a tape in LLVM IR, for any number of lanes. No fast-math flag: nothing is contracted or
# reordered.
#
# Every text is a template of {r} (the result), {a} and {b} (operands); {D} is the type of a value, {B} that of its
# tests.

_ARITHMETIC = {ca.OP_ADD: "fadd", ca.OP_SUB: "fsub", ca.OP_MUL: "fmul", ca.OP_DIV: "fdiv"}
_TESTS = {ca.OP_LT: "olt", ca.OP_LE: "ole", ca.OP_EQ: "oeq", ca.OP_NE: "une"}
_TRUTH = "  {r} = select {B} {r}c, {D} {one}, {D} {zero}"
_BOTH = "  {r}a = fcmp une {D} {a}, {zero}\n  {r}b = fcmp une {D} {b}, {zero}\n"
# fmax and fmin as the C printer writes them, a > b || b != b ? a : b; the inner choice is one instruction of x86
_EXTREME = (
    "  {{r}}c = fcmp {test} {{D}} {{a}}, {{b}}\n  {{r}}m = select {{B}} {{r}}c, {{D}} {{a}}, {{D}} {{b}}\n"
    "  {{r}}n = fcmp uno {{D}} {{b}}, {{b}}\n  {{r}} = select {{B}} {{r}}n, {{D}} {{a}}, {{D}} {{r}}m"
)
_INTRINSICS = {ca.OP_SQRT: "sqrt", ca.OP_FABS: "fabs", ca.OP_FLOOR: "floor", ca.OP_CEIL: "ceil"}
_FUNCTIONS = {getattr(ca, f"OP_{name.upper()}"): name for name in (*LIBRARY_UNARY, *LIBRARY_BINARY, *REPLACED)}
_FUNCTIONS[ca.OP_CONSTPOW] = "pow"

TEMPLATES = {
    **{op: f"  {{r}} = {name} {{D}} {{a}}, {{b}}" for op, name in _ARITHMETIC.items()},
    **{op: f"  {{r}}c = fcmp {test} {{D}} {{a}}, {{b}}\n{_TRUTH}" for op, test in _TESTS.items()},
    ca.OP_AND: f"{_BOTH}  {{r}}c = and {{B}} {{r}}a, {{r}}b\n{_TRUTH}",
    ca.OP_OR: f"{_BOTH}  {{r}}c = or {{B}} {{r}}a, {{r}}b\n{_TRUTH}",
    ca.OP_NOT: f"  {{r}}c = fcmp oeq {{D}} {{a}}, {{zero}}\n{_TRUTH}",
    ca.OP_FMAX: _EXTREME.format(test="ogt"),
    ca.OP_FMIN: _EXTREME.format(test="olt"),
    ca.OP_IF_ELSE_ZERO: "  {r}c = fcmp une {D} {a}, {zero}\n  {r} = select {B} {r}c, {D} {b}, {D} {zero}",
    ca.OP_SIGN: "  {r}p = fcmp ogt {D} {a}, {zero}\n  {r}m = fcmp olt {D} {a}, {zero}\n"
    "  {r}s = select {B} {r}m, {D} {minus_one}, {D} {a}\n  {r} = select {B} {r}p, {D} {one}, {D} {r}s",
    ca.OP_NEG: "  {r} = fneg {D} {a}",
    ca.OP_SQ: "  {r} = fmul {D} {a}, {a}",
    ca.OP_TWICE: "  {r} = fadd {D} {a}, {a}",
    ca.OP_INV: "  {r} = fdiv {D} {one}, {a}",
    ca.OP_COPYSIGN: "  {r} = call {D} @llvm.copysign.{S}({D} {a}, {D} {b})",
    **{op: f"  {{r}} = call {{D}} @llvm.{name}.{{S}}({{D}} {{a}})" for op, name in _INTRINSICS.items()},
    **{
        op: f"  {{r}} = call {{D}} @{{{name}}}({{D}} {{a}}" + (", {D} {b})" if name in LIBRARY_BINARY else ")")
        for op, name in _FUNCTIONS.items()
    },
}


class Operations:
    """Text of operations on values of `width` lanes, with mathematics `own` or `library`.

    fused: a product and the sum that takes it may be rounded once. Other bits then, so for derivatives only.
    """

    def __init__(self, width: int, mathematics: str, inline: bool, fused: bool = False) -> None:
        self.lanes, self.own, self._inline = Lanes(width), mathematics == "own", inline
        # the functions of a fused one are those of another, which is exact, so it has no vectors of angles
        self.takes_angles_together = self.own and width == 1 and not fused
        self._beside: set[int] = set()  # widths of these vectors
        self.tables: dict[float, None] = {}  # marks of those that were asked for, in order
        lanes = self.lanes
        called = {name: self._name(name) for name in _FUNCTIONS.values()}
        fixed = {
            "D": lanes.double,
            "B": lanes.bit,
            "S": lanes.suffix,
            "zero": lanes.number(0.0),
            "one": lanes.number(1.0),
            "minus_one": lanes.number(-1.0),
            **called,
        }
        operands = {"r": "{r}", "a": "{a}", "b": "{b}"}
        flag = " contract" if fused else ""
        self._templates = {
            op: text.format(**fixed, **operands).replace("fmul ", f"fmul{flag} ").replace("fadd ", f"fadd{flag} ")
            for op, text in TEMPLATES.items()
        }
        self._arithmetic = {op: f"{name}{flag} {lanes.double}" for op, name in _ARITHMETIC.items()}
        # operations of one instruction, so that the result can have a number for a name
        self.single = frozenset(op for op, text in TEMPLATES.items() if text.count("{r}") == 1)

    def _name(self, function: str) -> str:
        if self.own and function in REPLACED:
            return f"own_{function}"
        return function if self.lanes.width == 1 else f"{function}_in_lanes"

    def text(self, op: int, result: str, a: str, b: str) -> str:
        """Instructions that define `result`. Raises KeyError for an operation that no tape of ours has."""
        if op in self._arithmetic:  # most of all operations: without the price of a template
            return f"  {result} = {self._arithmetic[op]} {a}, {b}"
        return self._templates[op].format(r=result, a=a, b=b)

    def table(self, value: float, result: str, a: str) -> str:
        """The call of a table, by its mark."""
        self.tables[value] = None
        D = self.lanes.double
        return f"  {result} = call {D} @{table_name(value)}({D} {a})"

    def sine_and_cosine(self, sine: str, cosine: str, a: str) -> str:
        """Both of one angle by one call."""
        D = self.lanes.double
        pair = f"{{ {D}, {D} }}"
        return (
            f"  {sine}p = call {pair} @own_sincos({D} {a})\n"
            f"  {sine} = extractvalue {pair} {sine}p, 0\n  {cosine} = extractvalue {pair} {sine}p, 1"
        )

    def sines_and_cosines(self, name: str, angles: list[str]) -> tuple[str, list[str], list[str]]:
        """Of several angles by one call: instructions, names; more lanes than angles repeat the last."""
        width = next(one for one in sorted(WIDTHS) if one >= len(angles))
        self._beside.add(width)
        D, lines, vector = Lanes(width).double, [], "poison"
        for lane in range(width):
            angle = angles[min(lane, len(angles) - 1)]
            lines.append(f"  {name}i{lane} = insertelement {D} {vector}, double {angle}, i64 {lane}")
            vector = f"{name}i{lane}"
        lines.append(f"  {name}p = call {{ {D}, {D} }} @own_sincos_{width}({D} {vector})")
        names: list[list[str]] = []
        for part, letter in enumerate("sc"):
            lines.append(f"  {name}{letter} = extractvalue {{ {D}, {D} }} {name}p, {part}")
            names.append([f"{name}{letter}{lane}" for lane in range(len(angles))])
            lines += [f"  {one} = extractelement {D} {name}{letter}, i64 {k}" for k, one in enumerate(names[-1])]
        return "\n".join(lines), names[0], names[1]

    def functions(self) -> str:
        """Declarations and definitions that a module needs."""
        lanes = self.lanes
        beside = [sincos(Lanes(width), f"own_sincos_{width}", self._inline) for width in sorted(self._beside)]
        for width in self._beside:
            kind = Lanes(width)
            for name, count in (("fma", 3), ("fabs", 1)):
                arguments = ", ".join([kind.double] * count)
                beside.append(f"declare {kind.double} @llvm.{name}.{kind.suffix}({arguments})")
        parts = [f"attributes #0 = {{ {PURE} nobuiltin }}"]  # nobuiltin: LLVM must not replace pow(x, 2) by x x
        library = (*LIBRARY_UNARY, *LIBRARY_BINARY, *(() if self.own else REPLACED))
        for name in library:
            count = 2 if name in LIBRARY_BINARY else 1
            parts.append(f"declare double @{name}({', '.join(['double'] * count)}) #0")
            if lanes.width > 1:
                parts.append(self._lane_by_lane(name, count))
        for name, count in (("fma", 3), ("copysign", 2), ("sqrt", 1), ("fabs", 1), ("floor", 1), ("ceil", 1)):
            arguments = ", ".join([lanes.double] * count)
            parts.append(f"declare {lanes.double} @llvm.{name}.{lanes.suffix}({arguments})")
        parts += [*beside, own_functions(lanes, self._inline) if self.own else ""]
        return "\n".join([*parts, module_ir(list(self.tables), lanes, self._inline)])

    def _lane_by_lane(self, name: str, count: int) -> str:
        """A function of the library for all lanes."""
        D, letters = self.lanes.double, "xy"[:count]
        head = f"define internal {D} @{name}_in_lanes({', '.join(f'{D} %{letter}' for letter in letters)}) {PURE} {{"
        lines, result = [], "poison"
        for lane in range(self.lanes.width):
            lines += [f"  %{letter}{lane} = extractelement {D} %{letter}, i64 {lane}" for letter in letters]
            arguments = ", ".join(f"double %{letter}{lane}" for letter in letters)
            lines.append(f"  %f{lane} = call double @{name}({arguments}) #0")
            lines.append(f"  %r{lane} = insertelement {D} {result}, double %f{lane}, i64 {lane}")
            result = f"%r{lane}"
        return "\n".join([head, *lines, f"  ret {D} {result}", "}"])


# ---- A stage of a step program as LLVM IR: one function, or several that pass values through a work array.
#
# A function is `void name(ptr z, ptr c, ptr w[, further arrays][, mask])`. Entry e of lane l is at [e * width + l]
# of each array. All loads of z come before its stores, so z is updated in place, changed entries only; with a mask only
# lanes where it is set. Most values have numbers for names, which LLVM reads in two thirds of the time.

ARGUMENTS = "ptr noalias %z, ptr noalias readonly %c, ptr noalias %w"


class StageWriter:
    """Functions of one stage; chunk: statements of a function, 0 for all in one; arrays: names of further inputs."""

    def __init__(
        self,
        name: str,
        tape: Tape,
        operations: Operations,
        chunk: int,
        masked: bool,
        inline: bool,
        arrays: tuple[str, ...] = (),
    ) -> None:
        self.name, self.tape, self.operations, self.masked = name, tape, operations, masked
        self.stores = [
            (entry, k) for entry, k in enumerate(tape.outputs[0]) if tape.nodes[k][:3] != (ca.OP_INPUT, 0, entry)
        ]
        live = below(tape.nodes, [k for _, k in self.stores])
        self.order = [k for k in live if tape.nodes[k].op not in (ca.OP_INPUT, ca.OP_CONST)]
        self.partner = partners(tape.nodes, self.order) if operations.own else {}
        self.chunk = chunk if 0 < chunk < len(self.order) else max(1, len(self.order))
        self.beside: dict[int, Group] = {}
        if operations.takes_angles_together and chunk == 0:
            self.order, self.beside = side_by_side(tape.nodes, self.order)
        self.kind = "alwaysinline" if inline else "noinline"
        self.arguments = ARGUMENTS + "".join(f", ptr noalias readonly %{array}" for array in arrays)
        self.passed = "".join(f", ptr %{array}" for array in arrays)
        lanes = operations.lanes
        self.double, self.ending = lanes.double, f", align {lanes.align}" if lanes.width > 1 else ""
        self._begin()

    def _begin(self) -> None:
        """A new function: its lines, names of values in it, the next number."""
        self.lines: list[str] = []
        self.names: dict[int, str] = {}
        self.next = 0

    def functions(self) -> tuple[list[str], int]:
        """(IR of the functions, entries of the work array)."""
        if len(self.order) <= self.chunk:
            return ["\n".join(self._whole())], 0
        stored = [k for _, k in self.stores]
        chunk_of, chunks, slots = divided(self.tape.nodes, self.order, self.partner, stored, self.chunk)
        count = len(chunks)
        parts = [self._chunk(n, members, chunk_of, slots) for n, members in enumerate(chunks)]
        groups = [self.stores[k : k + self.chunk] for k in range(0, len(self.stores), self.chunk)]
        parts += [self._store_chunk(n, group, slots) for n, group in enumerate(groups)]
        head, ending = self._head(self.name, "noinline")
        called = [f"{self.name}_{n}" for n in range(count)] + [f"{self.name}_store_{n}" for n in range(len(groups))]
        mask = f", {self.operations.lanes.bit} %mask" if self.masked else ""
        calls = [f"  call void @{name}(ptr %z, ptr %c, ptr %w{self.passed}{mask})" for name in called]
        return [*parts, "\n".join([head, *calls, *ending])], len(slots)

    def _head(self, name: str, kind: str) -> tuple[str, list[str]]:
        mask = f", {self.operations.lanes.bit} %mask" if self.masked else ""
        return f"define internal void @{name}({self.arguments}{mask}) nounwind {kind} {{\nbegin:", ["  ret void", "}"]

    def _whole(self) -> list[str]:
        self._begin()
        for k in self.order:
            self._define(k)
        for _, k in self.stores:
            self._operand(k)  # loads what moves
        self._store_all(self.stores)
        head, ending = self._head(self.name, self.kind)
        return [head, *self.lines, *ending]

    def _chunk(self, n: int, members: list[int], chunk_of: dict[int, int], slots: dict[int, int]) -> str:
        self._begin()
        for k in members:
            for argument in self.tape.nodes[k][1:3]:
                if argument not in self.names and chunk_of.get(argument, n) != n:
                    self._load(argument, "w", slots[argument])
            self._define(k)
        for k in members:
            if k in slots:
                self._store("w", slots[k], self.names[k])
        if n == 0:
            for k, slot in slots.items():
                if k not in chunk_of:
                    self._store("w", slot, self._operand(k))
        head, ending = self._head(f"{self.name}_{n}", "noinline")
        return "\n".join([head, *self.lines, *ending])

    def _store_chunk(self, n: int, group: list[tuple[int, int]], slots: dict[int, int]) -> str:
        self._begin()
        for _, k in group:
            if k in slots and k not in self.names:
                self._load(k, "w", slots[k])
        self._store_all(group)
        head, ending = self._head(f"{self.name}_store_{n}", "noinline")
        return "\n".join([head, *self.lines, *ending])

    # ---- instructions -------------------------------------------------------------------------------------

    def _define(self, k: int) -> None:
        if k in self.names:
            return
        node = self.tape.nodes[k]
        a = self._operand(node.a)
        if node.op == ca.OP_ASSIGN:
            self.names[k] = a
            return
        if k in self.beside:
            self._define_beside(self.beside[k])
            return
        if k in self.partner:
            name, other = (self.names.setdefault(one, f"%v{one}") for one in (k, self.partner[k]))
            sine, cosine = (name, other) if node.op == ca.OP_SIN else (other, name)
            self.lines.append(self.operations.sine_and_cosine(sine, cosine, a))
            return
        if node.op == ca.OP_CALL:
            self.names[k] = f"%v{k}"
            self.lines.append(self.operations.table(node.value, self.names[k], a))
            return
        b = self._operand(node.b) if node.b >= 0 else ""
        name = self.names[k] = self._number() if node.op in self.operations.single else f"%v{k}"
        self.lines.append(self.operations.text(node.op, name, a, b))

    def _define_beside(self, group: Group) -> None:
        """Sines and cosines of a group of angles, in lanes."""
        angles = [self._operand(k) for k in group]
        text, sines, cosines = self.operations.sines_and_cosines(f"%g{group[0]}", angles)
        self.lines.append(text)
        names = {
            op: dict(zip(group, own, strict=True)) for op, own in zip(TRIGONOMETRIC, (sines, cosines), strict=True)
        }
        for k, other in self.beside.items():
            if other == group:
                node = self.tape.nodes[k]
                self.names[k] = names[node.op][node.a]

    def _number(self) -> str:
        name = f"%{self.next}"
        self.next += 1
        return name

    def _operand(self, k: int) -> str:
        """Name of a node's value in this function; inputs are loaded at their first use."""
        known = self.names.get(k)
        if known is not None:
            return known
        node = self.tape.nodes[k]
        if node.op == ca.OP_CONST:
            self.names[k] = self.operations.lanes.number(node.value)
        else:
            assert node.op == ca.OP_INPUT, f"node {k} is used before it is defined"
            self._load(k, self.tape.input_names[node.a], node.b)
        return self.names[k]

    def _load(self, k: int, array: str, entry: int) -> None:
        place, value = self.next, self.next + 1
        self.next += 2
        self.lines.append(
            f"  %{place} = getelementptr {self.double}, ptr %{array}, i64 {entry}\n"
            f"  %{value} = load {self.double}, ptr %{place}{self.ending}"
        )
        self.names[k] = f"%{value}"

    def _store(self, array: str, entry: int, value: str) -> None:
        place = self._number()
        self.lines.append(
            f"  {place} = getelementptr {self.double}, ptr %{array}, i64 {entry}\n"
            f"  store {self.double} {value}, ptr {place}{self.ending}"
        )

    def _store_all(self, group: list[tuple[int, int]]) -> None:
        values = [self._operand(k) for _, k in group]
        bit = self.operations.lanes.bit
        for (entry, _), value in zip(group, values, strict=True):
            if self.masked:
                self.lines.append(
                    f"  %o{entry}p = getelementptr {self.double}, ptr %z, i64 {entry}\n"
                    f"  %o{entry} = load {self.double}, ptr %o{entry}p{self.ending}\n"
                    f"  %m{entry} = select {bit} %mask, {self.double} {value}, {self.double} %o{entry}"
                )
                value = f"%m{entry}"
            self._store("z", entry, value)


MEMCPY = "declare void @llvm.memcpy.p0.p0.i64(ptr, ptr, i64, i1)"
RUN_ROWS = """
define void @run_rows(ptr %z, ptr %c, ptr %w, ptr %counts, i64 %rows, ptr %out, i64 %bytes) nounwind {
entry:
  br label %head
head:
  %k = phi i64 [ 0, %entry ], [ %next, %body ]
  %go = icmp slt i64 %k, %rows
  br i1 %go, label %body, label %done
body:
  %at = getelementptr i64, ptr %counts, i64 %k
  %count = load i64, ptr %at
  call void @run(ptr %z, ptr %c, ptr %w, i64 %count)
  %offset = mul i64 %k, %bytes
  %place = getelementptr i8, ptr %out, i64 %offset
  call void @llvm.memcpy.p0.p0.i64(ptr %place, ptr %z, i64 %bytes, i1 false)
  %next = add i64 %k, 1
  br label %head
done:
  ret void
}
"""
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


def program_ir(program: Program, form: Form) -> tuple[str, int]:
    """(IR text of the module, entries of the work array)."""
    tapes = {stage.name(): read_tape(stage) for stage in program.stages()}
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
    z, lanes = "%z_run" if form.inline else "%z", operations.lanes
    head = f"define void @run(ptr noalias {z}, ptr noalias readonly %c, ptr noalias %w, i64 %n) nounwind {{"
    run = entry(head, control.loops, loop(0, body, "%n"), size, lanes.double, lanes.align, form.inline)
    return "\n".join([*parts, operations.functions(), MEMCPY, run, RUN_BLOCKS, RUN_ROWS]), work


def functions_ir(tapes: Mapping[str, Tape], form: Form) -> tuple[str, int]:
    """(IR of `void name([y, ]x, c, w)` for each tape, entries of the work array): a tape of (z, c) is made in place,
    one of (z, x, c) with z for y.
    """
    operations, parts, work = Operations(form.width, form.mathematics, form.inline), list[str](), 0
    for name, tape in tapes.items():
        arrays = tuple(one for one in tape.input_names if one not in ("z", "c"))
        functions, entries = StageWriter(f"of_{name}", tape, operations, form.chunk, False, False, arrays).functions()
        names = ["z", *arrays, "c", "w"]
        inside = ", ".join(f"ptr %{one}" for one in ("z", "c", "w", *arrays))
        head = f"define void @{name}({', '.join(f'ptr %{one}' for one in names)}) nounwind {{"
        parts += [*functions, "\n".join([head, f"  call void @of_{name}({inside})", "  ret void", "}"])]
        work = max(work, entries)
    return "\n".join([*parts, operations.functions()]), work


def loop(k: int, body: list[str], limit: int | str, test: Sequence[str] = ()) -> list[str]:
    """The body so many times, counted in %jk; test: lines that make %gok of %belowk, where more than the count says."""
    return [
        f"  store i64 0, ptr %j{k}",
        f"  br label %head{k}",
        f"head{k}:",
        f"  %i{k} = load i64, ptr %j{k}",
        f"  %{'below' if test else 'go'}{k} = icmp slt i64 %i{k}, {limit}",
        *test,
        f"  br i1 %go{k}, label %body{k}, label %done{k}",
        f"body{k}:",
        *body,
        f"  %n{k} = add i64 %i{k}, 1",
        f"  store i64 %n{k}, ptr %j{k}",
        f"  br label %head{k}",
        f"done{k}:",
    ]


def entry(head: str, loops: int, body: list[str], size: int, double: str, align: int, local: bool) -> str:
    """An entry function with counters for its loops, on a copy of z where that is to stay in registers."""
    copy = f"  call void @llvm.memcpy.p0.p0.i64(ptr align {align} {{}}, ptr align {align} {{}}, i64 {{}}, i1 false)"
    length = size * align  # bytes: an entry is as long as its alignment
    before = [f"  %z = alloca [{size} x {double}], align {align}", copy.format("%z", "%z_run", length)] * local
    after = [copy.format("%z_run", "%z", length)] * local
    counters = [f"  %j{k} = alloca i64" for k in range(loops + 1)]
    return "\n".join([head, *counters, *before, *body, *after, "  ret void", "}", ""])


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
            if isinstance(node, Repeat):
                return loop(k, body(mask), node.count)
            test, inner = self._test(k, node.flag, mask)
            return loop(k, body(inner), node.limit, test)

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
