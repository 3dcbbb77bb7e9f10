"""A stage of a step program as LLVM IR: one function, or several that pass values through a work array.

A function is `void name(ptr z, ptr c, ptr w[, further arrays][, mask])`. Entry e of lane l is at [e * width + l]
of each array. All loads of z come before its stores, so z is updated in place, changed entries only; with a mask only
lanes where it is set. Most values have numbers for names, which LLVM reads in two thirds of the time.
"""

from __future__ import annotations

import casadi as ca

from runtime.contract.tape import Tape, below
from runtime.engine.angles import Group, side_by_side
from runtime.engine.llvm_operations import Operations

ARGUMENTS = "ptr noalias %z, ptr noalias readonly %c, ptr noalias %w"
PARTNER = {ca.OP_SIN: ca.OP_COS, ca.OP_COS: ca.OP_SIN}


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
        self.partner = self._partners() if operations.own else {}
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

    def _partners(self) -> dict[int, int]:
        """{sine or cosine: the other one of the same angle}."""
        found: dict[tuple[int, int], int] = {}
        for k in self.order:
            node = self.tape.nodes[k]
            if node.op in PARTNER:
                found[node.op, node.a] = k
        pairs = {k: found.get((PARTNER[op], angle)) for (op, angle), k in found.items()}
        return {k: other for k, other in pairs.items() if other is not None}

    def functions(self) -> tuple[list[str], int]:
        """(IR of the functions, entries of the work array)."""
        chunk_of: dict[int, int] = {}
        for position, k in enumerate(self.order):
            chunk_of.setdefault(k, position // self.chunk)
            if k in self.partner:  # a sine and its cosine come from one call, where the first of them stands
                chunk_of.setdefault(self.partner[k], position // self.chunk)
        slots = self._slots(chunk_of)
        count = (len(self.order) - 1) // self.chunk + 1 if self.order else 0
        if count <= 1:
            return ["\n".join(self._whole())], 0
        chunks: list[list[int]] = [[] for _ in range(count)]
        for k in self.order:
            chunks[chunk_of[k]].append(k)
        parts = [self._chunk(n, members, chunk_of, slots) for n, members in enumerate(chunks)]
        groups = [self.stores[k : k + self.chunk] for k in range(0, len(self.stores), self.chunk)]
        parts += [self._store_chunk(n, group, slots) for n, group in enumerate(groups)]
        head, ending = self._head(self.name, "noinline")
        called = [f"{self.name}_{n}" for n in range(count)] + [f"{self.name}_store_{n}" for n in range(len(groups))]
        mask = f", {self.operations.lanes.bit} %mask" if self.masked else ""
        calls = [f"  call void @{name}(ptr %z, ptr %c, ptr %w{self.passed}{mask})" for name in called]
        return [*parts, "\n".join([head, *calls, *ending])], len(slots)

    def _slots(self, chunk_of: dict[int, int]) -> dict[int, int]:
        """{node that is used outside its chunk: its place in the work array}."""
        slots: dict[int, int] = {}
        nodes = self.tape.nodes
        for k in self.order:
            for argument in nodes[k][1:3]:
                if argument in chunk_of and chunk_of[argument] != chunk_of[k]:
                    slots.setdefault(argument, len(slots))
        for _, k in self.stores:  # an entry of z that moves to another place is copied before anything is stored
            if k in chunk_of or nodes[k].op == ca.OP_INPUT:
                slots.setdefault(k, len(slots))
        return slots

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
        found = self.operations.sines_and_cosines(f"%g{group[0]}", angles)
        self.lines.append(found.text)
        names = {ca.OP_SIN: dict(zip(group, found.sines, strict=True))}
        names[ca.OP_COS] = dict(zip(group, found.cosines, strict=True))
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
