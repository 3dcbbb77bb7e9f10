"""A step as a small program of pure stages z -> z: run interpreted by CasADi or compiled to C, same operations.

z is the whole state of a scheme as one vector, c the constants of the run. Stages are SX Functions (z, c) -> z.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from typing import NamedTuple, TypeVar

import casadi as ca
import numpy as np

from runtime.contract.tape import code_length, shared

T = TypeVar("T")
LONG_STAGE_NODES = 30_000  # nodes of a stage


class Program:
    """A step: Call, Sequence, Repeat or Until. What is done with programs is a `fold` or a `map` of them."""

    def fold(
        self,
        call: Callable[[ca.Function], T],
        sequence: Callable[[list[T]], T],
        again: Callable[[T, Repeat | Until], T],
    ) -> T:
        """What `call` makes of the stages, put together by `sequence` and, from that of its body, by `again`."""
        if isinstance(self, Call):
            return call(self.stage)
        if isinstance(self, Sequence):
            return sequence([part.fold(call, sequence, again) for part in self.parts])
        if isinstance(self, Repeat | Until):
            return again(self.body.fold(call, sequence, again), self)
        raise TypeError(f"{type(self).__name__} is not a kind of program")

    def map(self, change: Callable[[ca.Function], ca.Function]) -> Program:
        """The same program of changed stages; each distinct stage is changed once."""
        done = {stage.name(): change(stage) for stage in self.stages()}
        return self.fold(
            lambda stage: Call(done[stage.name()]),
            lambda parts: Sequence(tuple(parts)),
            lambda body, node: replace(node, body=body),
        )

    def stages(self) -> list[ca.Function]:
        """The distinct stages, in order of appearance."""
        found: dict[str, ca.Function] = {}
        self.fold(lambda stage: found.setdefault(stage.name(), stage), lambda parts: None, lambda body, node: None)
        return list(found.values())


@dataclass(frozen=True)
class Call(Program):
    """Apply one stage."""

    stage: ca.Function


@dataclass(frozen=True)
class Sequence(Program):
    """Apply the parts one after another."""

    parts: tuple[Program, ...]


@dataclass(frozen=True)
class Repeat(Program):
    """Apply the body `count` times."""

    body: Program
    count: int


@dataclass(frozen=True)
class Until(Program):
    """Apply the body until z[flag] <= 0, at most `limit` times; tested before each time.

    usual: how often it is expected to be applied, for estimates of the price.
    """

    body: Program
    flag: int
    limit: int
    usual: int = 8


@dataclass(frozen=True)
class Layout:
    """Named fields of z, in order."""

    sizes: Mapping[str, int]

    @property
    def size(self) -> int:
        """Length of z."""
        return sum(self.sizes.values())

    @cached_property
    def _slices(self) -> dict[str, slice]:
        ends = np.cumsum([0, *self.sizes.values()]).tolist()
        return {name: slice(*ends[k : k + 2]) for k, name in enumerate(self.sizes)}

    def slice(self, name: str) -> slice:
        """Where a field lies in z."""
        return self._slices[name]

    def unpack(self, z: ca.SX) -> dict[str, ca.SX]:
        """Fields of z by name."""
        return {name: z[self.slice(name)] for name in self.sizes}

    def pack(self, fields: Mapping[str, ca.SX]) -> ca.SX:
        """z from its fields. Raises ValueError for one of another size: what stands behind it would be read amiss."""
        # as columns: nothing of a scalar, x[:0], is a row without columns, of which CasADi's vertcat makes a zero
        parts = {name: ca.vec(ca.SX(fields[name])) for name in self.sizes}
        wrong = [f"{name} ({part.numel()})" for name, part in parts.items() if part.numel() != self.sizes[name]]
        if wrong:
            raise ValueError(f"fields of z have other sizes than the layout: {', '.join(wrong)}")
        return ca.densify(ca.vertcat(*parts.values()))


Fields = dict[str, ca.SX]


def make_stage(name: str, layout: Layout, c_size: int, body: Callable[[Fields, ca.SX], Mapping[str, ca.SX]]) -> Call:
    """A stage from a function of (fields, c) to the fields it changes; the others stay as they are.

    What stands twice in a short stage is shared here; in a long one by prepare.py, which takes a fraction of the time.
    """
    z, c = ca.SX.sym("z", layout.size), ca.SX.sym("c", c_size)
    fields = layout.unpack(z)
    z_next = layout.pack({**fields, **body(fields, c)})
    if ca.n_nodes(z_next) <= LONG_STAGE_NODES:
        (z_next,) = shared([z_next])
    return Call(ca.Function(name, [z, c], [z_next], ["z", "c"], ["z_next"]))


class Form(NamedTuple):
    """How a program is printed: lanes, mathematics (own or library), statements a function, stages inlined or not."""

    width: int = 1
    mathematics: str = "own"
    chunk: int = 0
    inline: bool = True


def operations_per_step(program: Program) -> int:
    """Operations of one application (each Until body counted as often as is usual)."""

    def again(body: int, node: Repeat | Until) -> int:
        return body * (node.count if isinstance(node, Repeat) else node.usual)

    return program.fold(code_length, lambda parts: sum(parts), again)
