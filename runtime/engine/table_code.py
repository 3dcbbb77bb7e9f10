"""Tables in machine code: one function each, LLVM IR for any number of lanes. C of them is in c_source.py.

The same operations in the same order as runtime/contract/tape.py says. C has the numbers of its tables written out.
Code by LLVM holds no numbers but where to look, in arrays of this process; it lists the marks of its tables
(`table_marks`) and has room for the addresses of their arrays
(`table_arrays`: knots, powers, starts of each), which are filled in when it is loaded.
"""

from __future__ import annotations

import ctypes
from functools import cache
from typing import Any

import numpy as np

from runtime.contract.tape import marked
from runtime.engine.mathematics import Body, Lanes

MARKS, COUNT, ARRAYS = "table_marks", "table_count", "table_arrays"  # what the code of a program exports
PLACES = 3  # arrays of a table
_READS = "nounwind willreturn memory(read)"


@cache  # machine code reads them as long as the process lasts
def numbers_of(value: float) -> tuple[np.ndarray, ...]:
    """The knots, the powers (rows, degree + 1) and the starts of the table with this mark."""
    table, order = marked(value)
    powers = table.coefficients(order)
    return table.knots, np.ascontiguousarray(powers.T), table.starts


def bind_native(engine: Any) -> None:
    """Give code that LLVM has loaded the arrays of its tables."""
    place = engine.get_global_value_address(COUNT)
    count = ctypes.c_int64.from_address(place).value if place else 0
    if count:
        marks = (ctypes.c_int64 * count).from_address(engine.get_global_value_address(MARKS))
        room = (ctypes.c_void_p * (PLACES * count)).from_address(engine.get_global_value_address(ARRAYS))
        room[:] = [array.ctypes.data for value in marks for array in numbers_of(float(value))]


def table_name(value: float) -> str:
    """Of the function of a table."""
    return f"table_{int(value)}"


def module_ir(values: list[float], lanes: Lanes, inline: bool) -> str:
    """Functions of these tables, and what a module exports of them."""
    if not values:
        return ""
    marks = ", ".join(f"i64 {int(value)}" for value in values)
    head = [
        f"@{COUNT} = constant i64 {len(values)}",
        f"@{MARKS} = constant [{len(values)} x i64] [{marks}]",
        f"@{ARRAYS} = global [{PLACES * len(values)} x ptr] zeroinitializer",
    ]
    if lanes.width > 1:
        D, pointers = lanes.double, f"<{lanes.width} x ptr>"
        gather = f"declare {D} @llvm.masked.gather.v{lanes.width}f64.v{lanes.width}p0"
        head.append(f"{gather}({pointers}, i32 immarg, {lanes.bit}, {D})")
    kind = "alwaysinline" if inline else ""
    functions = [_function_ir(k, value, len(values), lanes, kind) for k, value in enumerate(values)]
    return "\n".join([*head, *functions, "!0 = !{}"])


def _function_ir(k: int, value: float, count: int, lanes: Lanes, kind: str) -> str:
    (table, order), D, whole, B = marked(value), lanes.double, lanes.integer, lanes.bit
    degree, body = len(table.coefficients(order)), _Lines(lanes)
    room = f"getelementptr ([{PLACES * count} x ptr], ptr @{ARRAYS}, i64 0, i64 {{}})"
    knots, powers, starts = (
        body.line(f"load ptr, ptr {room.format(PLACES * k + place)}, !invariant.load !0") for place in range(PLACES)
    )
    below = body.line(f"fcmp olt {D} %x, {lanes.number(table.last)}")
    inside = body.line(f"select {B} {below}, {D} %x, {D} {lanes.number(table.last)}")
    away = body.line(f"fsub {D} {inside}, {lanes.number(table.left)}")
    scaled = body.line(f"fmul {D} {away}, {lanes.number(table.scale)}")
    behind = body.line(f"fcmp ogt {D} {scaled}, {lanes.number(0.0)}")
    bucket = body.line(f"select {B} {behind}, {D} {scaled}, {D} {lanes.number(0.0)}")
    row = body.line(f"fptosi {D} {bucket} to {whole}")
    if table.starts.size:
        row = body.line(f"fptosi {D} {body.load(starts, row)} to {whole}")
    for level in reversed(range(table.levels)):
        further = body.line(f"add nsw {whole} {row}, {lanes.whole(1 << level)}")
        passed = body.line(f"fcmp oge {D} {inside}, {body.load(knots, further)}")
        row = body.line(f"select {B} {passed}, {whole} {further}, {whole} {row}")
    beyond = body.line(f"fsub {D} %x, {body.load(knots, row)}")
    first = body.line(f"mul nsw {whole} {row}, {lanes.whole(degree)}") if degree > 1 else row
    at = [first] + [body.line(f"add nsw {whole} {first}, {lanes.whole(power)}") for power in range(1, degree)]
    y = body.load(powers, at[-1])
    for place in reversed(at[:-1]):
        product = body.line(f"fmul {D} {beyond}, {y}")
        y = body.line(f"fadd {D} {body.load(powers, place)}, {product}")
    head = f"define internal {D} @{table_name(value)}({D} %x) {_READS} {kind} {{"
    return "\n".join([head, *body.lines, f"  ret {D} {y}", "}"])


class _Lines(Body):
    """Instructions of one function that reads arrays."""

    def load(self, array: str, entry: str) -> str:
        """An entry of an array, or one for each lane."""
        width, D = self.lanes.width, self.lanes.double
        if width == 1:
            place = self.line(f"getelementptr double, ptr {array}, i64 {entry}")
            return self.line(f"load double, ptr {place}, !invariant.load !0")
        kind = f"<{width} x ptr>"
        places = self.line(f"getelementptr double, ptr {array}, {self.lanes.integer} {entry}")
        gather = f"call {D} @llvm.masked.gather.v{width}f64.v{width}p0"
        return self.line(f"{gather}({kind} {places}, i32 8, {self.lanes.bit} {self.lanes.true}, {D} poison)")
