"""The arguments of a run besides the model: how it goes, and what is kept of it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TypedDict

from runtime.contract.initial_values import Initial
from runtime.running.checkpoint import CheckpointRule, claim
from runtime.running.inputs import InputValue
from runtime.running.plan import whole_number
from runtime.running.run import Progress
from runtime.schemes.options import SchemeError


class FurtherArguments(TypedDict, total=False):
    """How a run goes and what is kept of it; see `Further`."""

    save_every: int | None
    engine: str
    progress: Progress | bool | None
    force: bool
    outputs: Sequence[str] | None
    stream: str | Path | None
    checkpoint: str | Path | None
    checkpoint_every: int | None


class RunArguments(FurtherArguments, total=False):
    """The arguments of `simulate` besides the model and the scheme, for those who pass them on."""

    t_end: float | None
    dt: float | None
    m: list[int] | None
    tolerance: float | None
    parameters: Mapping[str, float] | None
    initial: Initial
    options: Mapping[str, Any] | None
    t0: float
    start: str | None
    inputs: Mapping[str, InputValue] | None


@dataclass(frozen=True)
class Further:
    """How a run goes, and what is kept of it.

    save_every counts major steps. engine: `auto`, `compiled` or `interpreted`. progress(t, t_end) is called between
    native calls. force: run although the step is above the stability limit at the start.
    outputs: names of coordinates, rates, measures or energies; only these are kept of the saved samples, in
    Solution.outputs. stream: a folder that takes the samples instead of memory (runtime.results.stream). checkpoint:
    a file that `resume` goes on from, written every `checkpoint_every` major steps (None: every minute) and on Ctrl-C.
    """

    save_every: int | None = None
    engine: str = "auto"
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
