"""Take everything that depends on parameters only out of the kernels: constants(p) -> c.

A run evaluates `constants` once; the kernels of a step read c. Products such as rho A L mu or composite masses
then cost nothing per step, although every physical number stays a run-time input.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import casadi as ca

from runtime.engine.tape import UNUSED, Node, Tape, read_tape
from symgen.replay import apply


@dataclass(frozen=True)
class Kernel:
    """A function to be: named SX inputs and named dense outputs."""

    inputs: dict[str, ca.SX]
    outputs: dict[str, ca.SX]

    def function(self, name: str) -> ca.Function:
        """The CasADi Function with named inputs and outputs, common subexpressions shared."""
        outputs = ca.cse([ca.densify(value) for value in self.outputs.values()])
        return ca.Function(name, list(self.inputs.values()), outputs, list(self.inputs), list(self.outputs))


def hoist(kernels: Mapping[str, Kernel], p: ca.SX) -> tuple[Kernel, dict[str, Kernel]]:
    """(constants: p -> c, kernels with c instead of p). Inputs no kernel output uses are dropped."""
    pool = _Constants(p)
    used = {name: _Replay(kernel, pool, p) for name, kernel in kernels.items()}
    c = ca.SX.sym("c", len(pool.values))
    constants = Kernel({"p": p}, {"c": ca.vertcat(*pool.values)})
    return constants, {name: replay.kernel(c) for name, replay in used.items()}


class _Constants:
    """Values that depend on p only, each once over all kernels."""

    def __init__(self, p: ca.SX) -> None:
        self.p = p
        self.values: list[ca.SX] = []
        self._position: dict[int, int] = {}
        self._identity: dict[tuple, int] = {}

    def identity(self, key: tuple) -> int:
        """A number for a structural key (operation, identities of the arguments); equal keys share it."""
        return self._identity.setdefault(key, len(self._identity))

    def position(self, key: int, value: ca.SX) -> int:
        """Index in c of the value with this identity."""
        if key not in self._position:
            self._position[key] = len(self.values)
            self.values.append(value)
        return self._position[key]


class _Replay:
    """One kernel: finds its maximal parameter-only nodes, then rebuilds it on c."""

    def __init__(self, kernel: Kernel, pool: _Constants, p: ca.SX) -> None:
        self.source = kernel
        names = {**kernel.inputs, "p": p}
        self.tape: Tape = read_tape(Kernel(names, kernel.outputs).function("kernel"))
        self.p_argument = self.tape.input_names.index("p")
        self.keys: list[int | None] = []  # identity of nodes of p and numbers only, None for the rest
        self.numbers: set[int] = set()
        self.p_values: dict[int, ca.SX] = {}
        for k, node in enumerate(self.tape.nodes):
            self._classify(k, node, p, pool)
        self.hoisted: dict[int, int] = {}
        for k, node in enumerate(self.tape.nodes):
            if self.keys[k] is None:
                for argument in (node.a, node.b):
                    self._hoist(argument if node.op not in (ca.OP_INPUT, ca.OP_CONST) else UNUSED, pool)
        for entries in self.tape.outputs:
            for entry in entries:
                self._hoist(entry, pool)

    def _classify(self, k: int, node: Node, p: ca.SX, pool: _Constants) -> None:
        if node.op == ca.OP_CONST:
            self.keys.append(pool.identity(("number", node.value)))
            self.numbers.add(k)
            self.p_values[k] = ca.SX(node.value)
        elif node.op == ca.OP_INPUT:
            of_p = node.a == self.p_argument
            self.keys.append(pool.identity(("p", node.b)) if of_p else None)
            if of_p:
                self.p_values[k] = p[node.b]
        else:
            arguments = [node.a] if node.b == UNUSED else [node.a, node.b]
            keys = [self.keys[a] for a in arguments]
            if any(key is None for key in keys):
                self.keys.append(None)
                return
            self.keys.append(pool.identity((node.op, *keys)))
            values = [self.p_values[a] for a in arguments]
            self.p_values[k] = apply(node, values[0], values[1] if len(values) == 2 else None)

    def _hoist(self, k: int, pool: _Constants) -> None:
        if k == UNUSED or k in self.hoisted:
            return
        key = self.keys[k]
        if key is not None and k not in self.numbers:
            self.hoisted[k] = pool.position(key, self.p_values[k])

    def kernel(self, c: ca.SX) -> Kernel:
        """The kernel with c as its last input; unused inputs dropped."""
        symbols = [self.source.inputs.get(name) for name in self.tape.input_names]
        values: list[ca.SX | None] = []
        live: set[int] = set()
        for k, node in enumerate(self.tape.nodes):
            if k in self.hoisted:
                values.append(c[self.hoisted[k]])
            elif self.keys[k] is not None:
                values.append(self.p_values[k])
            elif node.op == ca.OP_INPUT:
                live.add(node.a)
                symbol = symbols[node.a]
                assert symbol is not None
                values.append(symbol[node.b])
            else:
                values.append(apply(node, values[node.a], None if node.b == UNUSED else values[node.b]))
        inputs = {name: symbol for position, (name, symbol) in enumerate(zip(self.tape.input_names, symbols, strict=True))
                  if position in live and symbol is not None}
        if self.hoisted:
            inputs["c"] = c
        outputs = {}
        for name, shape, entries in zip(self.tape.output_names, self.tape.output_shapes, self.tape.outputs, strict=True):
            outputs[name] = ca.reshape(ca.vertcat(*(values[entry] for entry in entries)), *shape)
        return Kernel(inputs, outputs)
