"""What a benchmark reports: measured lines, each with its goal where there is one."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any


@dataclass(frozen=True)
class Line:
    """One measured number; goal: the most it should be (None: for information)."""

    name: str
    value: float
    unit: str
    goal: float | None = None
    note: str = ""

    @property
    def met(self) -> bool | None:
        """Is the goal reached?"""
        return None if self.goal is None else self.value <= self.goal


@dataclass(frozen=True)
class Result:
    """Lines of one benchmark; details go to the JSON file only. remark: what stands above the table."""

    name: str
    title: str
    lines: list[Line]
    details: dict[str, Any] = field(default_factory=dict)
    remark: str = ""


class Skipped(RuntimeError):
    """A benchmark that cannot run here; the message says what is missing."""


Benchmark = Callable[[], Result]
