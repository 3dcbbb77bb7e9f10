"""Impacts on rigid stops, by Newton's law of restitution, and bounces that come too close (Zeno behaviour).

The impulses solve a linear complementarity problem (unilateral constraints, Moreau's impact law). Poisson's
hypothesis, which divides the impulse into compression and restitution, is not used: both agree for impacts of a single
stop without friction.

A stop is an end of the way of a direction v = G q_i': its gap changes with v_s = side v. Of all that touch, and do not
leave, the impulses p >= 0 along v_s solve

    v_s+ + e v_s- >= 0,    p >= 0,    p (v_s+ + e v_s-) = 0,    q_i'+ = q_i'- + M_hat^-1 G_s^T p,

which for one is p = -(1 + e) v_s- / A, A = G M_hat^-1 G^T. It takes p^T (1 - e) v_s- / 2 <= 0 out of the energy.
Who comes back under a steady acceleration a < 0 leaves with e v, e^2 v, ...: at 2 v_s+ / (|a| (1 - e)) behind the
impact it rests. Where that is less than TOO_CLOSE, it rests at once.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from runtime.contract.model import EmittedModel
from runtime.schemes.switching.complementarity import balancing, complementary, times

AT_REST = 1e-9  # m/s or rad/s, and of the largest rate: what is slower has come to rest
TOUCH = 1e-9  # m or rad: the gap of what lies on a stop
TOO_CLOSE = 1e-4  # s
MOST_HITS = 50  # at one time, one after another: as in a row of balls; then without restitution


@dataclass(frozen=True)
class Impact:
    """A stop k (among the modes): v_s before and after it; impulse: what it gave away from it [N s or N m s]; rests:
    how much later [s] its bounces are over, or None.
    """

    k: int
    before: float
    after: float
    e: float
    impulse: float
    rests: float | None


@dataclass(frozen=True)
class Stops:
    """row, side (n_m,): of the modes, side 0 of friction; until_now (n_m,): the modes; reached (n_m,): are they
    reached?
    """

    row: np.ndarray
    side: np.ndarray
    until_now: np.ndarray
    reached: np.ndarray

    @classmethod
    def of(cls, model: EmittedModel, c: np.ndarray, reached: np.ndarray | None) -> Stops:
        """Of a model with constants c (c_size,)."""
        events = model.mode_events
        row, side = (np.array([getattr(one, name) for one in events], dtype=int) for name in ("row", "side"))
        modes = c[len(c) - model.signals.size + model.element_modes]
        return cls(
            row, side, modes.copy(), np.zeros(len(row), dtype=bool) if reached is None else reached & (side != 0)
        )

    def _of_stops(self, values: np.ndarray | None, otherwise: float) -> np.ndarray:
        """(n_m,) of values (n_stop,)."""
        found = np.full(len(self.side), otherwise)
        if values is not None:
            found[self.side != 0] = values
        return found

    def _near(self, own: Mapping[str, np.ndarray]) -> np.ndarray:
        """(n_m,) closed, just reached, or not beyond a touch from it."""
        gap = self._of_stops(own.get("gap"), np.inf)
        return np.asarray((self.side != 0) & ((self.until_now == 0) | self.reached | (gap <= TOUCH)))

    def _on(self, own: Mapping[str, np.ndarray]) -> np.ndarray:
        """(n_m,) the same, but for what comes from within a touch and has not arrived."""
        gap = self._of_stops(own.get("gap"), np.inf)
        return np.asarray((self.side != 0) & ((self.until_now == 0) | self.reached | (gap <= 0)))

    def struck(
        self, own: Mapping[str, np.ndarray], slow: float, soon: Mapping[int, float]
    ) -> tuple[np.ndarray, list[Impact]] | None:
        """(n_i,) what all impacts at once add to q_i', and these; soon: stops that are to rest, by the time until then.

        None where no impulses are consistent.
        """
        push, impacts, on = np.zeros(len(own["by"])), dict[int, Impact](), self._on(own)
        if not on.any():
            return push, []
        e = self._of_stops(own.get("restitution"), 0.0)
        e[list(soon)] = 0.0
        A = self.side[:, None] * own["A"][np.ix_(self.row, self.row)] * self.side
        by, speed = own["by"][:, self.row] * self.side, self.side * own["v_rel"][self.row]
        given = np.zeros(len(e))
        for count in range(MOST_HITS + 1):
            comes = on & (speed < -slow)
            if not comes.any():
                break
            last = count == MOST_HITS
            some = np.flatnonzero(on if last else on & (speed <= slow))
            back = np.where(comes, 0.0 if last else e, 0.0)
            p = _impulses(A[np.ix_(some, some)], ((1 + back) * speed)[some])
            if p is None:
                return None
            before, speed = speed, speed + times(A[:, some], p)
            push, given[some] = push + times(by[:, some], p), given[some] + p
            for k in map(int, np.flatnonzero(comes)):
                first = impacts[k].before if k in impacts else float(before[k])
                impacts[k] = Impact(k, first, float(speed[k]), float(e[k]), 0.0, soon.get(k))
        return push, [replace(one, impulse=float(given[one.k])) for one in impacts.values()]

    def touched(self, own: Mapping[str, np.ndarray], rate: np.ndarray, slow: float) -> np.ndarray:
        """(n_m,) stops on which their rows, with rates (n_e,), lie."""
        return np.asarray(self._near(own) & (np.abs(rate[self.row]) <= slow))

    def too_close(self, impacts: list[Impact], rate: np.ndarray, acceleration: np.ndarray) -> dict[int, float]:
        """Those whose bounces are over so soon, with the time until then [s]; rates and their changes by row (n_e,)."""
        found = dict[int, float]()
        for impact in impacts:
            back, speed = (float(self.side[impact.k] * one[self.row[impact.k]]) for one in (acceleration, rate))
            left = -back * (1 - impact.e) * TOO_CLOSE
            if impact.rests is None and 0 < 2 * speed < left:
                found[impact.k] = 2 * speed / left * TOO_CLOSE
        return found


def _impulses(A: np.ndarray, b: np.ndarray) -> np.ndarray | None:
    """(n,) p >= 0 with b + A p >= 0, one or the other zero; None where none was found."""
    zero, endless = np.zeros(len(b)), np.full(len(b), np.inf)
    at = complementary(A, b, zero, endless)
    return None if at is None else np.maximum(0.0, balancing(A, b, zero, endless, at))
