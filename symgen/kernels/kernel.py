"""A function to be."""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca

from runtime.contract.tape import Tape, read_tape


@dataclass(frozen=True)
class Kernel:
    """A function to be: named SX inputs and named outputs."""

    inputs: dict[str, ca.SX]
    outputs: dict[str, ca.SX]

    def tape(self) -> Tape:
        """The kernel as straight-line code, common subexpressions shared, outputs dense."""
        outputs = ca.cse([ca.densify(value) for value in self.outputs.values()])
        return read_tape(
            ca.Function("kernel", list(self.inputs.values()), outputs, list(self.inputs), list(self.outputs))
        )
