"""A function to be."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import casadi as ca

from runtime.contract.tape import Tape, read_tape
from symgen.algebra.scalar import length

MUCH_LONGER = 1.15  # a form that has this many times the operations of another is not simplified to compare


@dataclass(frozen=True)
class Kernel:
    """A function to be: named SX inputs and named outputs.

    others: further forms of it, of which the shortest is kept once parameters are hoisted.
    """

    inputs: dict[str, ca.SX]
    outputs: dict[str, ca.SX]
    others: tuple[Kernel, ...] = ()

    def tape(self) -> Tape:
        """The kernel as straight-line code, common subexpressions shared, outputs dense."""
        outputs = ca.cse([ca.sparsify(value) for value in self.outputs.values()])
        return read_tape(
            ca.Function("kernel", list(self.inputs.values()), outputs, list(self.inputs), list(self.outputs))
        )


def shortest(inputs: dict[str, ca.SX], forms: Sequence[dict[str, ca.SX]]) -> Kernel:
    """A function by the shortest of several forms of its outputs."""
    counts = [length(list(form.values())) for form in forms] if len(forms) > 1 else [1]
    kernels = [
        Kernel(inputs, form) for form, count in zip(forms, counts, strict=True) if count <= MUCH_LONGER * min(counts)
    ]
    return replace(kernels[0], others=tuple(kernels[1:]))
