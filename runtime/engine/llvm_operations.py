"""Each operation of a tape in LLVM IR, for any number of lanes. No fast-math flag: nothing is contracted or reordered.

Every text is a template of {r} (the result), {a} and {b} (operands); {D} is the type of a value, {B} that of its tests.
"""

from __future__ import annotations

from typing import NamedTuple

import casadi as ca

from runtime.engine.angles import WIDTHS
from runtime.engine.mathematics import LIBRARY_BINARY, LIBRARY_UNARY, PURE, REPLACED, Lanes, own_functions, sincos
from runtime.engine.table_code import module_ir, table_name

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


class Beside(NamedTuple):
    """Instructions, and the names of sines and cosines that they define."""

    text: str
    sines: list[str]
    cosines: list[str]


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

    def sines_and_cosines(self, name: str, angles: list[str]) -> Beside:
        """Of several angles by one call; more lanes than angles repeat the last."""
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
        return Beside("\n".join(lines), *names)

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
