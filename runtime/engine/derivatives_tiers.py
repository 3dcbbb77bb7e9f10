"""Code at once, better code when it has run long enough: for what is compiled in two forms."""

from __future__ import annotations

import threading
from collections.abc import Callable
from typing import Generic, NamedTuple, TypeVar

from runtime.engine.llvm_code import Effort
from runtime.engine.llvm_ir import Form

T = TypeVar("T")
SECONDS_PER_OPERATION = 6e-5  # of better code, about


class Tier(NamedTuple):
    """How something is compiled."""

    form: Form
    effort: Effort


class Tiers(Generic[T]):
    """What `build` makes of a tier: of the first at once; of the best when so many seconds were spent that it pays.

    kept: is it in the cache? operations: of what is compiled. wait: only the best will do.
    """

    def __init__(
        self,
        build: Callable[[Tier], T],
        kept: Callable[[Tier], bool],
        first: Tier,
        best: Tier,
        operations: int,
        wait: bool,
    ) -> None:
        self._build, self._best = build, best
        self._left = operations * SECONDS_PER_OPERATION  # seconds to be spent before better code is made
        self._builder: threading.Thread | None = None
        self.final = wait or kept(best)
        self.code = build(best if self.final else first)

    def spent(self, seconds: float) -> None:
        """So long a call took: better code is made beside the next ones, and taken when it is there."""
        if self.final:
            return
        self._left -= seconds
        if self._left < 0 and self._builder is None:
            self._builder = threading.Thread(target=self._improve, name="symgen better code")
            self._builder.start()

    def finish(self) -> None:
        """Change to the best code now, and wait for it."""
        if self._builder is not None:
            self._builder.join()
        elif not self.final:
            self._improve()

    def _improve(self) -> None:
        self.code = self._build(self._best)
        self.final = True
