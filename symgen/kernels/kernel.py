"""A function to be, and the SX arguments that the kernels of a system share, in the one order."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import casadi as ca

from runtime.contract.records import Group
from runtime.contract.tape import Tape, read_tape, shared
from symgen.algebra.rows import Row
from symgen.algebra.scalar import length
from symgen.condensed.condensation import Condensed
from symgen.kernels.specification import block_signals

MANY_ENTRIES, MOSTLY = 20_000, 0.9  # of matrices of a long chain only what is not zero is written
MUCH_LONGER = 1.15  # a form that has this many times the operations of another is not simplified to compare


@dataclass(frozen=True)
class Kernel:
    """A function to be: named SX inputs and named outputs.

    others: further forms of it, of which the shortest is kept once parameters are hoisted.
    """

    inputs: dict[str, ca.SX]
    outputs: dict[str, ca.SX]
    others: tuple[Kernel, ...] = ()

    def tape(self, packed: bool = False) -> Tape:
        """The kernel as straight-line code, common subexpressions shared, outputs dense.

        packed: of large outputs that are nearly all zeros only what is not zero.
        """
        outputs = shared([ca.sparsify(value) for value in self.outputs.values()])
        entries, zeros = sum(one.numel() for one in outputs), sum(one.numel() - one.nnz() for one in outputs)
        return read_tape(
            ca.Function("kernel", list(self.inputs.values()), outputs, list(self.inputs), list(self.outputs)),
            packed=packed and entries >= MANY_ENTRIES and zeros > MOSTLY * entries,
        )


def shortest(inputs: dict[str, ca.SX], forms: Sequence[dict[str, ca.SX]]) -> Kernel:
    """A function by the shortest of several forms of its outputs."""
    counts = [length(list(form.values())) for form in forms] if len(forms) > 1 else [1]
    kernels = [
        Kernel(inputs, form) for form, count in zip(forms, counts, strict=True) if count <= MUCH_LONGER * min(counts)
    ]
    return replace(kernels[0], others=tuple(kernels[1:]))


@dataclass(frozen=True)
class Arguments:
    """The SX arguments of the kernels of one system."""

    q_i: ca.SX
    q_d: ca.SX
    q_i_dot: ca.SX
    q_d_dot: ca.SX
    q_i_ddot: ca.SX
    signals: dict[str, ca.SX]
    dependent: list[int]

    def select(self, *names: str, **extra: ca.SX) -> dict[str, ca.SX]:
        """Named inputs in the common order, extras before t and u."""
        inputs = {name: getattr(self, name) for name in names}
        return {**inputs, **extra, **self.signals}


def arguments_of(system: Condensed) -> Arguments:
    """Arguments of a condensed system; q_d sorted by scene order."""
    eq, independent = system.reduced, system.choice.independent
    dependent = sorted(system.choice.dependent)

    def stack(source: list[ca.SX], columns: list[int]) -> ca.SX:
        return ca.vertcat(*(source[c] for c in columns)) if columns else ca.SX(0, 1)

    return Arguments(
        stack(eq.q, independent),
        stack(eq.q, dependent),
        stack(eq.q_dot, independent),
        stack(eq.q_dot, dependent),
        ca.SX.sym("q_i_ddot", len(independent)),
        eq.signals,
        dependent,
    )


def dynamics(system: Condensed, a: Arguments, forms: Sequence[Row]) -> Kernel:
    """Accelerations by the shortest of several forms, each by column."""
    rows = [ca.vertcat(*(found[c] for c in system.choice.independent)) for found in forms]
    return shortest(a.select("q_i", "q_d", "q_i_dot", "q_d_dot"), [{"q_i_ddot": ca.densify(form)} for form in rows])


def blocks(a: Arguments, M_hat: ca.SX, Q_hat: ca.SX, groups: Sequence[Group]) -> Kernel:
    """M_hat_LL, M_hat_LS, ... and Q_hat_L, ... by the names of the groups (Eq. 39)."""
    values = [M_hat[row.positions, column.positions] for row in groups for column in groups]
    values += [Q_hat[group.positions] for group in groups]
    names = [signal.name for signal in block_signals(groups)]
    return Kernel(a.select("q_i", "q_d", "q_i_dot", "q_d_dot"), dict(zip(names, values, strict=True)))
