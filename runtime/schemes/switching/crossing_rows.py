"""Rows of a list of calls for a broken step: what is run and copied at its start, for each of its parts, at its end."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from runtime.engine.call_list import COPY, Row
from runtime.engine.program import Layout
from runtime.schemes.scheme import Scheme
from runtime.schemes.switching.crossing import ACTS, ListedCrossing, remembers
from runtime.schemes.switching.watched import watches

STEP, CROSS = 1, 2  # programs of a list
LEAD = 3  # rows of whole steps
MARKS: Mapping[str, tuple[str, ...]] = {  # stages of a crossing that are applied together
    "restarted": ("restart",),
    "looked": ("look",),
}


def marks() -> dict[str, list[bool]]:
    """Which of ACTS are applied, by name."""
    return {mark: [act in acts for act in ACTS] for mark, acts in MARKS.items()}


@dataclass(frozen=True)
class CrossingRows:
    """Of a scheme, in a list with this memory; part, step: the data of each part of a step and of each step.

    n_z: length of z. See ListedBreaks for what the fields hold.
    """

    scheme: Scheme
    n_z: int
    memory: Layout
    part: Layout
    step: Layout
    crossing: ListedCrossing | None

    def whole_steps(self, first: np.ndarray, others: np.ndarray) -> list[Row]:
        """LEAD rows of whole steps (S,): the first one from a clock behind a jump, then those from the grid's."""
        to_grid = Row(COPY, self._at("z"), self._at("t0"), first)
        return [self._go("z", "ready", first), to_grid, self._go("z", "ready", others)]

    def opened(self) -> list[Row]:
        """At the start: in which step an event was seen until now."""
        if not watches(self.scheme):
            return []
        flag = self._at("z") + self.scheme.layout.slice("event_step").start
        return [Row(COPY, self._in("flagged"), flag, 1), Row(COPY, flag, self._at("never"), 1)]

    def made(self) -> list[Row]:
        """A part."""
        go_on = Row(STEP, self._at("z"), self.part.slice("ready").start, 1, own=True)
        if remembers(self.scheme):
            return [*self._restarted("whole", self.part), go_on]
        return [Row(COPY, self._at("z"), self.part.slice("clock").start, 2, own=True), go_on]

    def closed(self) -> list[Row]:
        """Back on the grid, where events are looked for."""
        rows = self._restarted("back", self.step) if remembers(self.scheme) else []
        rows.append(Row(COPY, self._at("z"), self.step.slice("grid").start, 2, own=True))
        if not watches(self.scheme):
            return rows
        return [*rows, Row(COPY, self._in("dt"), self._at("dt"), 1), *self._cross("looked")]

    # ---- single rows ----------------------------------------------------------------------------------------

    def _at(self, name: str) -> int:
        return int(self.memory.slice(name).start)

    def _in(self, name: str) -> int:
        """Of what a crossing holds."""
        assert self.crossing is not None
        return self._at("cross") + int(self.crossing.layout.slice(name).start)

    def _go(self, z: str, ready: str, n: np.ndarray) -> Row:
        return Row(STEP, self._at(z), self._at(ready), n)

    def _cross(self, mark: str) -> list[Row]:
        """Stages of the crossing, for the state."""
        size = self.scheme.layout.size
        return [
            Row(COPY, self._in(ACTS[0]), self._at(mark), len(ACTS)),
            Row(COPY, self._in("state"), self._at("z"), size),
            Row(CROSS, self._at("cross"), self._at("constants"), 1),
            Row(COPY, self._at("z"), self._in("state"), size),
        ]

    def _restarted(self, times: str, of: Layout) -> list[Row]:
        """The state started anew."""
        return [Row(COPY, self._in("dt"), of.slice(times).start, 3, own=True), *self._cross("restarted")]
