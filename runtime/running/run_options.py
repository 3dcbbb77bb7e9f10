"""How a run goes, and what is kept of it."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

from runtime.running.problem import whole_number
from runtime.schemes.options import SchemeError

Progress = Callable[[float, float], None]


@dataclass(frozen=True)
class RunOptions:
    """How a run goes, and what is kept of it; see `simulate`."""

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

    def checked(self) -> RunOptions:
        """The same: checkpoints can be written. Raises SchemeError or OutputError."""
        every = self.checkpoint_every
        if every is not None and not (whole_number(every) or 0) >= 1:
            raise SchemeError(
                "checkpoint_every",
                f"must be a whole number of major steps of at least 1, not {every!r}",
                "leave it out for a checkpoint every minute",
            )
        if every is not None and self.checkpoint is None:
            raise SchemeError("checkpoint_every", "needs a file", "give checkpoint = ...")
        if self.checkpoint is not None:
            from runtime.running.checkpoint import claim

            claim(self.checkpoint)
        return self
