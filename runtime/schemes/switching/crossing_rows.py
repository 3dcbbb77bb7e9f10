"""Rows of a list of calls for a broken step: what is run and copied at its start, for each of its parts, at its end."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from runtime.engine.call_list import COPY, Row
from runtime.engine.program import Layout
from runtime.schemes.scheme import Scheme
from runtime.schemes.switching.crossing import ACCOUNT, ACTS, ListedCrossing, remembers
from runtime.schemes.switching.watched import watches
from runtime.schemes.work import AHEAD, accounted, looks_ahead

STEP, CROSS = 1, 2  # programs of a list
LEAD = 3  # rows of whole steps
MARKS: Mapping[str, tuple[str, ...]] = {  # stages of a crossing that are applied together
    "opened": ("power", "open"),
    "restarted": ("restart",),
    "watched": ("power",),
    "set_out": ("restart", "power"),
    "closed": ("power", "close"),
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
        """At the start: the work until now, and in which step an event was seen until now."""
        rows = []
        if accounted(self.scheme):
            rows += [self._given("dt", "dt"), self._given("share", "zero"), *self._cross("opened", "z")]
        if watches(self.scheme):
            flag = self._at("z") + self.scheme.layout.slice("event_step").start
            rows += [Row(COPY, self._in("flagged"), flag, 1), Row(COPY, flag, self._at("never"), 1)]
        return rows

    def made(self) -> list[Row]:
        """A part; with an account of work its half beside it, and the powers at both ends and between."""
        if not accounted(self.scheme):
            return [*self._set_out("whole", "z"), self._go_on("z", "ready1")]
        half = [*self._set_out("half", "other"), self._go_on("other", "ready2")]
        start = [*self._set_out("whole", "z"), *self._watched("whole", "outer_share", "z")]
        middle = self._watched("half", "inner_share", "other")
        return [*half, *start, self._go_on("z", "ready1"), *middle, *self._watched("whole", "outer_share", "z")]

    def closed(self, ahead: np.ndarray) -> list[Row]:
        """Back on the grid, where events are looked for and an account of work begins again; ahead (S,): see there."""
        rows = self._restarted("back", self.step, "z") if remembers(self.scheme) else []
        rows.append(Row(COPY, self._at("z"), self.step.slice("grid").start, 2, own=True))
        if watches(self.scheme):
            state = Row(COPY, self._at("z"), self._in("state"), self.scheme.layout.size)
            rows += [self._given("dt", "dt"), *self._cross("looked", "z"), state]
        return [*rows, *self._counted(ahead)] if accounted(self.scheme) else rows

    def _counted(self, ahead: np.ndarray) -> list[Row]:
        """An account of work begins; ahead (S,): it looks at AHEAD whole steps, or halves of one, or none."""
        rows = [self._given("dt", "dt"), self._given("share", "zero"), self._own("spacing", "spacing", self.step, 1)]
        if looks_ahead(self.scheme):
            lone = (ahead == 1).astype(int)
            go = [self._go("other", "ready", (ahead == AHEAD).astype(int)), self._go("other", "ready_half", lone)]
            rows += [*self._cross("watched", "z"), *self._halved(lone), self._own("dt", "ahead", self.step, 1)]
            rows += [*go, *self._cross("watched", "other"), *go, *self._cross("closed", "other")]
        else:
            rows += self._cross("closed", "z")
        account = self._at("z") + self.scheme.layout.slice(ACCOUNT[0]).start
        return [*rows, Row(COPY, account, self._in("account"), len(ACCOUNT))]

    def _halved(self, lone: np.ndarray) -> list[Row]:
        """At `other` is the state of z; where a whole step is lone (S,), as the start of halves of it."""
        copied = Row(COPY, self._at("other"), self._at("z"), self.n_z)
        if remembers(self.scheme):
            return [copied, *self._restarted("ahead", self.step, "other", lone)]
        return [copied, Row(COPY, self._at("other"), self.step.slice("clock").start, 2 * lone, own=True)]

    # ---- single rows ----------------------------------------------------------------------------------------

    def _at(self, name: str) -> int:
        return int(self.memory.slice(name).start)

    def _in(self, name: str) -> int:
        """Of what a crossing holds."""
        assert self.crossing is not None
        return self._at("cross") + int(self.crossing.layout.slice(name).start)

    def _given(self, name: str, value: str) -> Row:
        return Row(COPY, self._in(name), self._at(value), 1)

    def _own(self, name: str, field: str, of: Layout, n: int) -> Row:
        return Row(COPY, self._in(name), of.slice(field).start, n, own=True)

    def _go(self, z: str, ready: str, n: np.ndarray) -> Row:
        return Row(STEP, self._at(z), self._at(ready), n)

    def _go_on(self, z: str, ready: str) -> Row:
        """One step with constants of the part's own."""
        return Row(STEP, self._at(z), self.part.slice(ready).start, 1, own=True)

    def _cross(self, mark: str, z: str, n: int | np.ndarray = 1) -> list[Row]:
        """Stages of the crossing, for a state; n (S,): 0 where none is applied."""
        return [
            Row(COPY, self._in(ACTS[0]), self._at(mark), len(ACTS)),
            Row(COPY, self._in("state"), self._at(z), self.scheme.layout.size),
            Row(CROSS, self._at("cross"), self._at("constants"), n),
        ]

    def _watched(self, times: str, share: str, z: str) -> list[Row]:
        """The power of a state, with its share of the work of a part."""
        step = self._own("dt", times, self.part, 1)
        return [step, self._own("share", share, self.part, 1), *self._cross("watched", z)]

    def _set_out(self, times: str, to: str) -> list[Row]:
        """At `to` is the state of z from which a part begins, or its half."""
        if remembers(self.scheme):
            return self._restarted(times, self.part, to)
        rows = [Row(COPY, self._at(to), self._at("z"), self.n_z)] if to != "z" else []
        return [*rows, Row(COPY, self._at(to), self.part.slice("clock").start, 2, own=True)]

    def _restarted(self, times: str, of: Layout, to: str, n: int | np.ndarray = 1) -> list[Row]:
        """The state of z started anew, at `to`; n (S,): 0 where it is as it was."""
        state = Row(COPY, self._at(to), self._in("state"), self.scheme.layout.size)
        return [self._own("dt", times, of, 3), *self._cross("restarted", "z", n), state]
