"""The arguments of a run besides the problem and the method: how it goes, and what is kept of it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TypedDict

from runtime.contract.coordinates import Initial
from runtime.running.checkpoint import CheckpointRule, claim
from runtime.running.inputs import InputValue
from runtime.running.plan import whole_number
from runtime.running.run import Progress
from runtime.schemes.options import SchemeError


class RunArguments(TypedDict, total=False):
    """The arguments of `simulate` besides the model and the scheme, for those who pass them on."""

    tolerance: float | None
    t_end: float | None
    dt: float | None
    m: list[int] | None
    options: Mapping[str, Any] | None
    parameters: Mapping[str, float] | None
    initial: Initial
    start: str | None
    t0: float
    inputs: Mapping[str, InputValue] | None
    error: str
    save_every: int | None
    engine: str
    progress: Progress | bool | None
    force: bool
    outputs: Sequence[str] | None
    stream: str | Path | None
    checkpoint: str | Path | None
    checkpoint_every: int | None


@dataclass(frozen=True)
class Further:
    """How a run goes, and what is kept of it; see `simulate`."""

    save_every: int | None = None
    progress: Progress | bool | None = None
    force: bool = False
    outputs: Sequence[str] | None = None
    stream: str | Path | None = None
    checkpoint: str | Path | None = None
    checkpoint_every: int | None = None

    @property
    def bounded(self) -> bool:
        """Do whole states not stay in memory?"""
        return self.outputs is not None or self.stream is not None

    def rule(self) -> CheckpointRule:
        """When checkpoints are written, and that they can be. Raises SchemeError or OutputError."""
        every = None if self.checkpoint_every is None else whole_number(self.checkpoint_every)
        if self.checkpoint_every is not None and (every is None or every < 1):
            raise SchemeError(
                "checkpoint_every",
                f"must be a whole number of major steps of at least 1, not {self.checkpoint_every!r}",
                "leave it out for a checkpoint every minute",
            )
        if every is not None and self.checkpoint is None:
            raise SchemeError("checkpoint_every", "needs a file", "give checkpoint = ...")
        if self.checkpoint is not None:
            claim(self.checkpoint)
        return CheckpointRule(None if self.checkpoint is None else Path(self.checkpoint), every)
