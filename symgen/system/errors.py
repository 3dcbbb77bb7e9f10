"""The error of the stages after the scene: what was asked for cannot be derived."""

from __future__ import annotations


class DerivationError(Exception):
    """Names the item, what is wrong with it, and what to do; the pipeline gives it to the user as a SceneError."""

    def __init__(self, item: str, problem: str, remedy: str) -> None:
        super().__init__(item, problem, remedy)
        self.item, self.problem, self.remedy = item, problem, remedy

    def __str__(self) -> str:
        return f"{self.item}: {self.problem}; {self.remedy}"
