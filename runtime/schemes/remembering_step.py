"""What one-step schemes share that remember what their last step saw, the loop unknowns included."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import factorial
from typing import Any, TypeVar

import casadi as ca
import numpy as np

from runtime.schemes.linear_propagation import polynomial
from runtime.schemes.one_step import OneStep
from runtime.schemes.options import MOST_UNROLLED, AdaptiveOptions, one_of, whole_number
from runtime.schemes.stage_equations import ClosedConfiguration, StageEquations
from runtime.schemes.state_fields import StateField, state
from runtime.schemes.stiff_motion import Along

Vector = TypeVar("Vector", ca.SX, Along)


@dataclass(frozen=True)
class ExponentialAdamsOptions(AdaptiveOptions):
    """closure_iterations: Newton steps on the loop unknowns in each evaluation, from a guess that is right to h^4.

    tolerance: see AdaptiveOptions; error_of: the motion.

    linearisation: what is followed by exponentials: `stiffness`, the constant K and D of the stiff deflections, or
        `jacobian`, the Jacobian of all coordinates at the start of the step; `auto` takes the latter where a step
        with it is hardly longer, by their operations.
    """

    closure_iterations: int = whole_number(1, most=MOST_UNROLLED)
    linearisation: str = one_of("auto", "stiffness", "jacobian")


class RememberingStep(OneStep):
    """Field loop_third: third rates of the loop unknowns, as the last step found them."""

    options: ExponentialAdamsOptions
    damps = True

    def further_fields(self) -> dict[str, StateField]:
        """See above."""
        return {"loop_third": state(len(self.model.loop_unknowns))}

    def evaluations(self) -> tuple[int, int]:
        """Two."""
        return 2, 0

    def loop_motion(
        self, equations: StageEquations, start: ClosedConfiguration, v: ca.SX, a: ca.SX
    ) -> tuple[ca.SX, ca.SX, ca.SX]:
        """The loop unknowns at the start of a step, their rates and second rates."""
        rates = equations.loop_part(equations.rates(start, v))
        return equations.loop_part(start.q_d), rates, equations.loop_accelerations(start, v, a)


def loops_ahead(motion: Sequence[ca.SX], seen: ca.SX, tau: ca.SX, h: ca.SX) -> tuple[ca.SX, ca.SX]:
    """The loop unknowns at the end of a step, and their third rates, of the cubic that leads to `seen` at tau."""
    third = (seen - polynomial(motion, tau)) * (factorial(3) / tau**3)
    return polynomial([*motion, third], h), third


def bends(nodes: Sequence[float], values: Sequence[Vector], h: ca.SX, first: int) -> list[Vector]:
    """b_k, k = first, first + 1, ..., of the polynomial sum_k b_k tau^k / k! through values at nodes [in h]."""
    powers = range(first, first + len(nodes))
    weights: Any = (
        np.linalg.inv([[node**power / factorial(power) for power in powers] for node in nodes]) if nodes else []
    )
    found: list[Vector] = []
    for row, power in zip(weights, powers, strict=True):
        total = values[0] * (float(row[0]) / h**power)
        for weight, one in zip(row[1:], values[1:], strict=True):
            total = total + one * (float(weight) / h**power)
        found.append(total)
    return found
