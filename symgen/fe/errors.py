"""The one error that finite-element data can raise."""

from __future__ import annotations


class FiniteElementError(ValueError):
    """Something in finite-element data is wrong; says where, what, and what to do.

    Args:
        item: what is wrong, such as ``stiffness`` or ``interface 'pin'``.
        problem: what is wrong with it.
        remedy: what to do about it.
    """

    def __init__(self, item: str, problem: str, remedy: str) -> None:
        super().__init__(item, problem, remedy)
        self.item = item
        self.problem = problem
        self.remedy = remedy

    def __str__(self) -> str:
        return f"{self.item}: {self.problem}; {self.remedy}"
