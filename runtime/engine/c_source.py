"""C source of straight-line code: one function a tape, split into chunks when long; and of a step program.

One function with tens of thousands of locals makes a compiler slow and greedy (20,000 statements: 13 s); chunks of
STATEMENTS_OF_CHUNK statements that pass values through a work array compile in linear time and cost nothing at run
time. A compiler's passes take quadratic time in the loads and stores of a function, hence small chunks.

A value that is used once stands where it is used: C evaluates what is in parentheses as it is written, so the bits are
those of one statement an operation, in half the text.
"""

from __future__ import annotations

import os
import re
import shlex
import shutil
from collections.abc import Sequence
from dataclasses import dataclass, replace

import casadi as ca
import numpy as np

from runtime.contract.tape import UNUSED, Tape, below, marked, read_tape
from runtime.engine.llvm_ir import TRIGONOMETRIC, WIDTHS, Group, divided, partners, side_by_side
from runtime.engine.program import Program, Repeat, Until
from runtime.engine.table_code import numbers_of, table_name

MAX_CODE_OPERATIONS = 12_000  # operations of one function; a third as many statements
STATEMENTS_OF_CHUNK = 100
WIDEST = 160  # characters of a value that stands where it is used

# the library's fmax and fmin are calls; these give the same values, NaN included (but either zero of +0 and -0)
_CHOICES = {
    "larger": "static inline double {0}larger(double a, double b) {{ return a > b || b != b ? a : b; }}\n",
    "smaller": "static inline double {0}smaller(double a, double b) {{ return a < b || b != b ? a : b; }}\n",
}
# bits are those of operations one by one: no product is joined with a sum. gcc does so outside of ISO C, gcc 12 joins
# pairs of both (vfmaddsub) where it makes vectors of statements, even where contraction is off
HEAD = """#include <math.h>
#include <stdint.h>
#include <string.h>

#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize ("fp-contract=off", "no-tree-slp-vectorize")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

#if defined(__GNUC__)
#define APART __attribute__((noinline))
#else
#define APART
#endif
"""

_BINARY = {
    ca.OP_ADD: "{a} + {b}",
    ca.OP_SUB: "{a} - {b}",
    ca.OP_MUL: "{a} * {b}",
    ca.OP_DIV: "{a} / {b}",
    ca.OP_POW: "pow({a}, {b})",
    ca.OP_CONSTPOW: "pow({a}, {b})",
    ca.OP_LT: "{a} < {b}",
    ca.OP_LE: "{a} <= {b}",
    ca.OP_EQ: "{a} == {b}",
    ca.OP_NE: "{a} != {b}",
    ca.OP_AND: "{a} && {b}",
    ca.OP_OR: "{a} || {b}",
    ca.OP_FMIN: "{p}smaller({a}, {b})",
    ca.OP_FMAX: "{p}larger({a}, {b})",
    ca.OP_ATAN2: "atan2({a}, {b})",
    ca.OP_FMOD: "fmod({a}, {b})",
    ca.OP_COPYSIGN: "copysign({a}, {b})",
    ca.OP_HYPOT: "hypot({a}, {b})",
    ca.OP_IF_ELSE_ZERO: "{a} != 0 ? {b} : 0",
}
_UNARY = {
    ca.OP_NEG: "-{a}",
    ca.OP_SQ: "{a} * {a}",
    ca.OP_TWICE: "2 * {a}",
    ca.OP_INV: "1 / {a}",
    ca.OP_NOT: "!{a}",
    ca.OP_SIGN: "{a} > 0 ? 1 : {a} < 0 ? -1 : {a}",
    ca.OP_ASSIGN: "{a}",
    **{
        getattr(ca, f"OP_{name.upper()}"): name + "({a})"
        for name in "sqrt log tan asin acos atan sinh cosh tanh fabs floor ceil".split()
    },
    **{getattr(ca, f"OP_{name.upper()}"): "{m}" + name + "({a})" for name in ("sin", "cos", "exp")},
}
_CALLED = frozenset(op for op, text in (*_UNARY.items(), *_BINARY.items()) if text.endswith(")"))
_REPEATING = (ca.OP_SQ, ca.OP_SIGN)  # whose argument stands twice


@dataclass(frozen=True)
class Style:
    """How code is called and computes: prefix of its names; own: sin, cos and exp of runtime/engine/mathematics.py."""

    prefix: str = ""
    own: bool = False


@dataclass(frozen=True)
class Code:
    """C functions, how many entries of the work array w they take, and the marks of the tables that they call."""

    text: str
    work: int = 0
    tables: tuple[float, ...] = ()


def source(parts: Sequence[Code], style: Style, between: str = "") -> str:
    """The text of a file: includes, what the parts call, something between, the parts."""
    marks = dict.fromkeys(mark for part in parts for mark in part.tables)
    text = "\n".join([*(table_c(mark, style.prefix) for mark in marks), *(part.text for part in parts)])
    called = [one.format(style.prefix) for name, one in _CHOICES.items() if f"{style.prefix}{name}(" in text]
    return "\n".join([HEAD, *called, between, text])


def program_code(name: str, program: Program, style: Style, kept: str = "") -> Code:
    """`void name(double *z, const double *c, double *w, int64_t n)`; kept: how it is declared, such as "static "."""
    calls: dict[str, str] = {}
    parts, work, tables = list[str](), 0, dict[float, None]()
    for position, stage in enumerate(program.stages()):
        constants = ", c" if stage.size1_in(1) else ""  # a stage without constants has no such argument
        calls[stage.name()] = f"{name}_{position}(z{constants}, w);"
        found = stage_code(f"{name}_{position}", read_tape(stage), style)
        parts.append(found.text)
        work, tables = max(work, found.work), tables | dict.fromkeys(found.tables)
    body = "\n".join(_indented(_indented(_control(program, calls))))
    size = program.stages()[0].size1_in(0)
    copy = f"  memcpy(z, z_run, {size} * sizeof(double));\n"
    # a local z can stay in registers over a step; the caller's may alias anything
    parts.append(
        f"{kept}void {name}(double *z_run, const double *c, double *w, int64_t n) {{\n  double z[{size}];\n{copy}"
        "  (void)c, (void)w;\n  for (int64_t k = 0; k < n; ++k) {\n" + body + "\n  }\n"
        f"  memcpy(z_run, z, {size} * sizeof(double));\n}}\n"
    )
    return Code("\n".join(parts), work, tuple(tables))


def _control(program: Program, calls: dict[str, str]) -> list[str]:
    """Calls of the stages by name, and loops; each loop has a j of its own scope."""

    def again(body: list[str], node: Repeat | Until) -> list[str]:
        test = f"j < {node.count}" if isinstance(node, Repeat) else f"j < {node.limit} && z[{node.flag}] > 0"
        return [f"for (long j = 0; {test}; ++j) {{", *_indented(body), "}"]

    return program.fold(
        lambda stage: [calls[stage.name()]],
        lambda parts: [line for lines in parts for line in lines],
        again,
    )


def _indented(lines: list[str]) -> list[str]:
    return ["  " + line for line in lines]


def stage_code(name: str, tape: Tape, style: Style, kept: str = "static ") -> Code:
    """`void name(double *z, const double *c, double *w)`, by the names of the tape's inputs.

    The first is updated in place by the output, changed entries only.
    """
    first, *others = (one for one, size in zip(tape.input_names, tape.input_sizes, strict=True) if size)
    stores = [
        (f"{first}[{entry}]", node)
        for entry, node in enumerate(tape.outputs[0])
        if tape.nodes[node][:3] != (ca.OP_INPUT, 0, entry)
    ]
    declared = [f"double *{first}", *(f"const double *{one}" for one in others)]
    return _Writer(name, tape, stores, declared, [first, *others], style, kept).code()


def tape_code(name: str, tape: Tape, outputs: Sequence[str], style: Style, kept: str = "static ") -> Code:
    """`void name(double *output, ..., const double *input, ..., double *w)`, inputs by the names that the tape has.

    Outputs are dense, column by column, and must not overlap inputs; inputs without entries are left out.
    """
    stores = [
        (f"{out}[{k}]", node) for out, one in zip(outputs, tape.outputs, strict=True) for k, node in enumerate(one)
    ]
    inputs = [one for one, size in zip(tape.input_names, tape.input_sizes, strict=True) if size]
    declared = [*(f"double *{one}" for one in outputs), *(f"const double *{one}" for one in inputs)]
    return _Writer(name, tape, stores, declared, [*outputs, *inputs], style, kept).code()


def named(function: ca.Function, *names: str) -> Tape:
    """The tape of a Function, its inputs by other names."""
    return replace(read_tape(function), input_names=list(names))


class _Writer:
    """Statements of one tape. All loads precede the stores (targets with their nodes), which may be in place."""

    def __init__(
        self,
        name: str,
        tape: Tape,
        stores: list[tuple[str, int]],
        declared: list[str],
        arguments: list[str],
        style: Style,
        kept: str,
    ) -> None:
        self.name, self.tape, self.stores, self.style, self.kept = name, tape, stores, style, kept
        self.declared = ", ".join([*declared, "double *w"])
        self.arguments = [*arguments, "w"]
        live = below(tape.nodes, [node for _, node in stores])
        order = [k for k in live if tape.nodes[k].op not in (ca.OP_INPUT, ca.OP_CONST)]
        self.beside: dict[int, Group] = {}
        if style.own and len(order) <= MAX_CODE_OPERATIONS:
            order, self.beside = side_by_side(tape.nodes, order)
        self.partner = partners(tape.nodes, [k for k in order if k not in self.beside]) if style.own else {}
        self.order = self._paired(order)
        self.uses = self._uses()

    def _paired(self, order: list[int]) -> list[int]:
        """The second of a pair right behind the first."""
        found: dict[int, None] = {}
        for k in order:
            found[k] = None
            if k in self.partner:
                found[self.partner[k]] = None
        return list(found)

    def _uses(self) -> dict[int, int]:
        """How often each value is read; what is stored counts as read twice, for it needs a name."""
        count = dict.fromkeys(self.order, 0)
        for k in self.order:
            node = self.tape.nodes[k]
            for argument in (node.a, node.b):
                if argument in count:
                    count[argument] += 2 if node.op in _REPEATING or node.op in TRIGONOMETRIC else 1
        for _, k in self.stores:
            if k in count:
                count[k] += 2
        return count

    def code(self) -> Code:
        """One function, or several."""
        text, work = self._chunked() if len(self.order) > MAX_CODE_OPERATIONS else (self._single(), 0)
        return Code(text, work, tuple(dict.fromkeys(node.value for node in self.tape.nodes if node.op == ca.OP_CALL)))

    def _operand(self, k: int, names: dict[int, str]) -> str:
        node = self.tape.nodes[k]
        if node.op == ca.OP_CONST:
            return number(node.value)
        if node.op == ca.OP_INPUT:
            return f"{self.tape.input_names[node.a]}[{node.b}]"
        return names[k]

    def _expression(self, k: int, names: dict[int, str]) -> str:
        node = self.tape.nodes[k]
        a = self._operand(node.a, names)
        if node.op == ca.OP_CALL:
            return f"{self.style.prefix}{table_name(node.value)}({a})"
        if node.b == UNUSED:
            return _UNARY[node.op].format(a=a, m=f"{self.style.prefix}own_" if self.style.own else "")
        return _BINARY[node.op].format(a=a, b=self._operand(node.b, names), p=self.style.prefix)

    def _statements(self, members: list[int], names: dict[int, str], kept: set[int]) -> list[str]:
        """Of these values, which get names; kept: those that need one, for others read them."""
        lines, done = list[str](), set[int]()
        for k in members:
            if k in done:
                continue
            if k in self.beside:
                lines += self._angles(self.beside[k], names)
                done |= {one for one, group in self.beside.items() if group == self.beside[k]}
                continue
            if k in self.partner:
                other = self.partner[k]
                done |= {k, other}
                names[k], names[other] = f"v{k}", f"v{other}"
                sine, cosine = (k, other) if self.tape.nodes[k].op == ca.OP_SIN else (other, k)
                angle = self._operand(self.tape.nodes[k].a, names)
                lines.append(f"  double v{k}, v{other};")
                lines.append(f"  {self.style.prefix}own_sincos({angle}, &v{sine}, &v{cosine});")
                continue
            text = self._expression(k, names)
            if self.uses[k] == 1 and k not in kept and len(text) <= WIDEST:
                names[k] = text if self.tape.nodes[k].op in _CALLED else f"({text})"
                continue
            lines.append(f"  const double v{k} = {text};")
            names[k] = f"v{k}"
        return lines

    def _angles(self, group: Group, names: dict[int, str]) -> list[str]:
        """Sines and cosines of angles side by side, in a loop that a compiler makes vectors of."""
        width = next(one for one in sorted(WIDTHS) if one >= len(group))
        padded = [*group, *[group[-1]] * (width - len(group))]
        a, s, c = (f"{letter}{group[0]}" for letter in "asc")
        for k, other in self.beside.items():
            if other == group:
                node = self.tape.nodes[k]
                names[k] = f"{s if node.op == ca.OP_SIN else c}[{group.index(node.a)}]"
        angles = ", ".join(self._operand(k, names) for k in padded)
        declared = f"  double {s}[{width}], {c}[{width}];\n  const double {a}[{width}] = {{{angles}}};"
        return [declared, f"  {self.style.prefix}own_sincos_{width}({a}, {s}, {c});"]

    def _function(self, name: str, lines: list[str], kept: str, declared: str = "") -> str:
        text = "\n".join(lines)
        unused = [f"(void){one}" for one in self.arguments if not re.search(rf"\b{one}\b", text)]
        head = f"{kept}void {name}({declared or self.declared}) {{"
        return "\n".join([head, *([f"  {', '.join(unused)};"] if unused else []), *lines, "}\n"])

    def _single(self) -> str:
        """One function. An entry that another store reads is copied first."""
        names: dict[int, str] = {}
        lines = self._statements(self.order, names, set())
        moved = {}
        for place, (_, node) in enumerate(self.stores):
            if self.tape.nodes[node].op == ca.OP_INPUT:
                moved[place] = f"m{place}"
                lines.append(f"  const double m{place} = {self._operand(node, names)};")
        lines += [
            f"  {target} = {moved.get(place) or self._operand(node, names)};"
            for place, (target, node) in enumerate(self.stores)
        ]
        return self._function(self.name, lines, self.kept)

    def _chunked(self) -> tuple[str, int]:
        """Functions of STATEMENTS_OF_CHUNK operations; values that outlive their chunk live in the work array,
        stores come last.
        """
        stored = [k for _, k in self.stores]
        chunk_of, members, slots = divided(self.tape.nodes, self.order, self.partner, stored, STATEMENTS_OF_CHUNK)
        parts = [self._chunk(n, own, chunk_of, slots) for n, own in enumerate(members)]
        stores = [self.stores[k : k + STATEMENTS_OF_CHUNK] for k in range(0, len(self.stores), STATEMENTS_OF_CHUNK)]
        parts += [self._store_chunk(n, part, slots) for n, part in enumerate(stores)]
        called = [f"{self.name}_{n}" for n in range(len(members))]
        called += [f"{self.name}_store_{n}" for n in range(len(stores))]
        passed = ", ".join(self.arguments)
        parts.append(self._function(self.name, [f"  {name}({passed});" for name in called], self.kept))
        return "\n".join(parts), len(slots)

    def _store_chunk(self, n: int, part: list[tuple[str, int]], slots: dict[int, int]) -> str:
        lines = [
            f"  {target} = {f'w[{slots[node]}]' if node in slots else self._operand(node, {})};"
            for target, node in part
        ]
        return self._function(f"{self.name}_store_{n}", lines, "static APART ")

    def _chunk(self, n: int, members: list[int], chunk_of: dict[int, int], slots: dict[int, int]) -> str:
        names = {k: f"w[{slot}]" for k, slot in slots.items() if chunk_of.get(k, n) != n}
        lines = self._statements(members, names, set(slots))
        lines += [f"  w[{slots[k]}] = {names[k]};" for k in members if k in slots]
        if n == 0:
            lines += [f"  w[{slot}] = {self._operand(k, {})};" for k, slot in slots.items() if k not in chunk_of]
        # nothing is read where it is written: loads of w need not wait for stores
        apart = self.declared.replace("double *w", "double *restrict w")
        return self._function(f"{self.name}_{n}", lines, "static APART ", apart)


# ---- Tables in C: the same operations in the same order, the numbers written out.


def table_c(value: float, prefix: str = "") -> str:
    """C of the function of a table, and of its arrays, whose numbers are written out."""
    (table, order), name = marked(value), prefix + table_name(value)
    degree, places = len(table.coefficients(order)), [f"{name}_{what}" for what in ("knots", "powers", "starts")]
    lines = [
        *(_written(*one) for one in zip(places, numbers_of(value), strict=True) if one[1].size),
        f"static double {name}(double x) {{",
        f"  const double *knots = {places[0]}, *powers = {places[1]};",
        f"  const double inside = {prefix}smaller(x, {table.last!r});",
        f"  long row = (long){prefix}larger((inside - ({table.left!r})) * {table.scale!r}, 0);",
    ]
    if table.starts.size:
        lines.append(f"  row = (long){places[2]}[row];")
    for level in reversed(range(table.levels)):
        lines.append(f"  if (inside >= knots[row + {1 << level}]) row += {1 << level};")
    lines += ["  const double beyond = x - knots[row];"] if degree > 1 else []
    lines += [f"  powers += {degree} * row;"]
    y = f"powers[{degree - 1}]"
    for power in reversed(range(degree - 1)):
        y = f"powers[{power}] + beyond * ({y})"
    return "\n".join([*lines, f"  return {y};", "}\n"])


def _written(name: str, values: np.ndarray) -> str:
    """A constant array; numbers are read back as they are."""
    flat = values.ravel().tolist()
    rows = ["  " + ", ".join(number(one).strip("()") for one in flat[k : k + 8]) for k in range(0, len(flat), 8)]
    return f"static const double {name}[{len(flat)}] = {{\n" + ",\n".join(rows) + "};"


def number(value: float) -> str:
    """As C reads it back."""
    if not np.isfinite(value):
        return "NAN" if value != value else "INFINITY" if value > 0 else "(-INFINITY)"
    return f"({value!r})" if value < 0 or (value == 0 and str(value)[0] == "-") else repr(value)


def find_compiler() -> str | None:
    """The command of the C compiler to use: $CC alone if set, else cc, gcc or clang; None if there is none."""
    chosen = os.environ.get("CC")
    if chosen:
        return chosen if shutil.which(shlex.split(chosen)[0]) else None
    return next((path for name in ("cc", "gcc", "clang") if (path := shutil.which(name))), None)
