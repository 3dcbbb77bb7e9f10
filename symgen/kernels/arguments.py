"""The SX arguments that the kernels of a system share, in the one order."""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca

from symgen.condensed.condensation import Condensed


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
