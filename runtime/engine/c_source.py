"""C source of a step program: stages as straight-line code, split into chunks when long.

One function with tens of thousands of locals makes a compiler slow and greedy (20,000 statements: 13 s); chunks of
CHUNK statements that pass values through a work array compile in linear time and cost nothing at run time. A
compiler's passes take quadratic time in the loads and stores of a function, hence small chunks.
"""

from __future__ import annotations

from math import isinf, isnan

import casadi as ca

from runtime.contract.tape import UNUSED, Node, Tape, read_tape
from runtime.engine.program import Program, Repeat, Until
from runtime.engine.table_code import table_c, table_name

LONGEST = 4000  # statements of one function
CHUNK = 100

# the library's fmax and fmin are calls; these give the same values, NaN included (but either zero of +0 and -0)
HEADER = """#include <math.h>
#include <string.h>

static inline double larger(double a, double b) { return a > b || b != b ? a : b; }
static inline double smaller(double a, double b) { return a < b || b != b ? a : b; }
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
    ca.OP_FMIN: "smaller({a}, {b})",
    ca.OP_FMAX: "larger({a}, {b})",
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
        op: name + "({a})"
        for op, name in (
            (ca.OP_SQRT, "sqrt"),
            (ca.OP_EXP, "exp"),
            (ca.OP_LOG, "log"),
            (ca.OP_SIN, "sin"),
            (ca.OP_COS, "cos"),
            (ca.OP_TAN, "tan"),
            (ca.OP_ASIN, "asin"),
            (ca.OP_ACOS, "acos"),
            (ca.OP_ATAN, "atan"),
            (ca.OP_SINH, "sinh"),
            (ca.OP_COSH, "cosh"),
            (ca.OP_TANH, "tanh"),
            (ca.OP_FABS, "fabs"),
            (ca.OP_FLOOR, "floor"),
            (ca.OP_CEIL, "ceil"),
        )
    },
}


def program_source(program: Program) -> str:
    """C source with `void run(double *z, const double *c, long n)`, which applies the program n times."""
    parts = [HEADER, *map(table_c, program_tables(program))]
    numbers: dict[str, int] = {}
    for position, stage in enumerate(program.stages()):
        numbers[stage.name()] = position
        parts.append(stage_source(f"stage_{position}", read_tape(stage)))
    body = "\n".join(_indented(_indented(_control(program, numbers))))
    size = program.stages()[0].size1_in(0)
    copy = f"  memcpy(z, z_run, {size} * sizeof(double));\n"
    # a local z can stay in registers over a step; the caller's may alias anything
    parts.append(
        f"void run(double *z_run, const double *c, long n) {{\n  double z[{size}];\n{copy}"
        "  for (long k = 0; k < n; ++k) {\n" + body + "\n  }\n"
        f"  memcpy(z_run, z, {size} * sizeof(double));\n}}\n"
    )
    return "\n".join(parts)


def program_tables(program: Program) -> list[float]:
    """The marks of its tables, each once."""
    nodes = (node for stage in program.stages() if stage.find_functions() for node in read_tape(stage).nodes)
    return list(dict.fromkeys(node.value for node in nodes if node.op == ca.OP_CALL))


def _control(program: Program, numbers: dict[str, int]) -> list[str]:
    """Calls and loops; each loop has a j of its own scope."""

    def again(body: list[str], node: Repeat | Until) -> list[str]:
        test = f"j < {node.count}" if isinstance(node, Repeat) else f"j < {node.limit} && z[{node.flag}] > 0"
        return [f"for (long j = 0; {test}; ++j) {{", *_indented(body), "}"]

    return program.fold(
        lambda stage: [f"stage_{numbers[stage.name()]}(z, c);"],
        lambda parts: [line for lines in parts for line in lines],
        again,
    )


def _indented(lines: list[str]) -> list[str]:
    return ["  " + line for line in lines]


def stage_source(name: str, tape: Tape) -> str:
    """C source of `static void name(double *z, const double *c)`: z is updated in place, changed entries only."""
    stores = [
        (entry, node) for entry, node in enumerate(tape.outputs[0]) if not _is_same_entry(tape.nodes[node], entry)
    ]
    needed = _needed(tape, [node for _, node in stores])
    order = [k for k in range(len(tape.nodes)) if needed[k] and tape.nodes[k].op not in (ca.OP_INPUT, ca.OP_CONST)]
    writer = _Writer(tape, order, stores)
    return writer.chunked(name) if len(order) > LONGEST else writer.single(name)


def _is_same_entry(node: Node, entry: int) -> bool:
    return node.op == ca.OP_INPUT and node.a == 0 and node.b == entry


def _needed(tape: Tape, roots: list[int]) -> list[bool]:
    needed = [False] * len(tape.nodes)
    for root in roots:
        needed[root] = True
    for k in range(len(tape.nodes) - 1, -1, -1):
        node = tape.nodes[k]
        if needed[k] and node.op not in (ca.OP_INPUT, ca.OP_CONST):
            needed[node.a] = True
            if node.b != UNUSED:
                needed[node.b] = True
    return needed


def _number(value: float) -> str:
    if isnan(value):
        return "NAN"
    if isinf(value):
        return "INFINITY" if value > 0 else "(-INFINITY)"
    return f"({value!r})" if value < 0 else repr(value)


class _Writer:
    """Statements of one stage. All loads of z precede its stores, so the update can be in place."""

    def __init__(self, tape: Tape, order: list[int], stores: list[tuple[int, int]]) -> None:
        self.tape, self.order, self.stores = tape, order, stores

    def _operand(self, k: int, names: dict[int, str]) -> str:
        node = self.tape.nodes[k]
        if node.op == ca.OP_CONST:
            return _number(node.value)
        if node.op == ca.OP_INPUT:
            return f"{self.tape.input_names[node.a]}[{node.b}]"
        return names[k]

    def _expression(self, k: int, names: dict[int, str]) -> str:
        node = self.tape.nodes[k]
        a = self._operand(node.a, names)
        if node.op == ca.OP_CALL:
            return f"{table_name(node.value)}({a})"
        if node.b == UNUSED:
            return _UNARY[node.op].format(a=a)
        return _BINARY[node.op].format(a=a, b=self._operand(node.b, names))

    def single(self, name: str) -> str:
        """One function."""
        names = {k: f"v{k}" for k in self.order}
        lines = [f"static void {name}(double *z, const double *c) {{"]
        lines += [f"  const double v{k} = {self._expression(k, names)};" for k in self.order]
        return "\n".join([*lines, *self._store(names), "}\n"])

    def _store(self, names: dict[int, str]) -> list[str]:
        """Stores at the end; an entry of z that another store reads is copied first."""
        lines = [f"  const double s{entry} = {self._operand(node, names)};" for entry, node in self.stores]
        return lines + [f"  z[{entry}] = s{entry};" for entry, _ in self.stores]

    def chunked(self, name: str) -> str:
        """Functions of CHUNK statements; values that outlive their chunk live in a work array, stores come last."""
        chunk_of = {k: position // CHUNK for position, k in enumerate(self.order)}
        slots: dict[int, int] = {}
        for k in self.order:
            node = self.tape.nodes[k]
            for argument in (node.a, node.b):
                if argument in chunk_of and chunk_of[argument] != chunk_of[k]:
                    slots.setdefault(argument, len(slots))
        for _, k in self.stores:  # an entry of z that moves to another place is copied before anything is stored
            if k in chunk_of or self.tape.nodes[k].op == ca.OP_INPUT:
                slots.setdefault(k, len(slots))
        chunks = range((len(self.order) - 1) // CHUNK + 1)
        parts = [f"static _Thread_local double {name}_w[{max(1, len(slots))}];"]
        parts += [self._chunk(name, chunk, chunk_of, slots) for chunk in chunks]
        stores = [self.stores[k : k + CHUNK] for k in range(0, len(self.stores), CHUNK)]
        parts += [self._store_chunk(name, k, part, slots) for k, part in enumerate(stores)]
        calls = [f"  {name}_{chunk}(z, c, {name}_w);" for chunk in chunks]
        calls += [f"  {name}_store_{k}(z, {name}_w);" for k in range(len(stores))]
        parts.append("\n".join([f"static void {name}(double *z, const double *c) {{", *calls, "}\n"]))
        return "\n".join(parts)

    def _store_chunk(self, name: str, k: int, part: list[tuple[int, int]], slots: dict[int, int]) -> str:
        lines = [f"static __attribute__((noinline)) void {name}_store_{k}(double *restrict z, const double *w) {{"]
        for entry, node in part:
            source = f"w[{slots[node]}]" if node in slots else self._operand(node, {})
            lines.append(f"  z[{entry}] = {source};")
        return "\n".join([*lines, "}\n"])

    def _chunk(self, name: str, chunk: int, chunk_of: dict[int, int], slots: dict[int, int]) -> str:
        members = self.order[chunk * CHUNK : (chunk + 1) * CHUNK]
        names = {k: f"w[{slot}]" for k, slot in slots.items() if chunk_of.get(k, chunk) != chunk}
        lines = [
            f"static __attribute__((noinline)) void {name}_{chunk}"
            "(const double *z, const double *c, double *restrict w) {"
        ]
        for k in members:
            names[k] = f"v{k}"
            lines.append(f"  const double v{k} = {self._expression(k, names)};")
        lines += [f"  w[{slots[k]}] = v{k};" for k in members if k in slots]
        if chunk == 0:
            lines += [f"  w[{slot}] = {self._operand(k, {})};" for k, slot in slots.items() if k not in chunk_of]
        return "\n".join([*lines, "}\n"])
