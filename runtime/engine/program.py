"""A step as a small program of pure stages z -> z: run interpreted by CasADi or compiled to C, same operations.

z is the whole state of a scheme as one vector, c the constants of the run. Stages are SX Functions (z, c) -> z.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import casadi as ca


@dataclass(frozen=True)
class Call:
    """Apply one stage."""

    stage: ca.Function


@dataclass(frozen=True)
class Sequence:
    """Apply the parts one after another."""

    parts: tuple[Program, ...]


@dataclass(frozen=True)
class Repeat:
    """Apply the body `count` times."""

    body: Program
    count: int


@dataclass(frozen=True)
class Until:
    """Apply the body until z[flag] <= 0, at most `limit` times; tested before each time.

    usual: how often it is expected to be applied, for estimates of the price.
    """

    body: Program
    flag: int
    limit: int
    usual: int = 8


Program = Call | Sequence | Repeat | Until


def stages(program: Program) -> list[ca.Function]:
    """The distinct stages of a program, in order of appearance."""
    found: dict[str, ca.Function] = {}

    def visit(node: Program) -> None:
        if isinstance(node, Call):
            found.setdefault(node.stage.name(), node.stage)
        elif isinstance(node, Sequence):
            for part in node.parts:
                visit(part)
        else:
            visit(node.body)

    visit(program)
    return list(found.values())


@dataclass(frozen=True)
class Layout:
    """Named fields of z, in order."""

    sizes: Mapping[str, int]

    @property
    def size(self) -> int:
        """Length of z."""
        return sum(self.sizes.values())

    def slice(self, name: str) -> slice:
        """Where a field lies in z."""
        start = 0
        for field, size in self.sizes.items():
            if field == name:
                return slice(start, start + size)
            start += size
        raise KeyError(name)

    def unpack(self, z: ca.SX) -> dict[str, ca.SX]:
        """Fields of z by name."""
        return {name: z[self.slice(name)] for name in self.sizes}

    def pack(self, fields: Mapping[str, ca.SX]) -> ca.SX:
        """z from its fields."""
        return ca.densify(ca.vertcat(*(fields[name] for name in self.sizes)))


Fields = dict[str, ca.SX]


def make_stage(name: str, layout: Layout, c_size: int, body: Callable[[Fields, ca.SX], Mapping[str, ca.SX]]) -> Call:
    """A stage from a function of (fields, c) to the fields it changes; the others stay as they are."""
    z, c = ca.SX.sym("z", layout.size), ca.SX.sym("c", c_size)
    fields = layout.unpack(z)
    outputs = ca.cse([layout.pack({**fields, **body(fields, c)})])
    return Call(ca.Function(name, [z, c], outputs, ["z", "c"], ["z_next"]))
