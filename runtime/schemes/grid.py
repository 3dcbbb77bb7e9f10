"""Steps of nested groups: dt_1 = dt_S, dt_2 = m_2 dt_1, ... (Eq. 72)."""

from __future__ import annotations

from dataclasses import dataclass
from numbers import Real
from typing import Any

from runtime.schemes.options import SchemeError

MAX_RATIO = 10_000  # as in a scene


@dataclass(frozen=True)
class Grid:
    """Groups as positions in q_i, slow to fast, the steps h [s], and ratios m[g] = h[g] / h[g + 1].

    Group g has step h[g]. A scheme that sub-steps all coordinates has one group and two steps.
    """

    groups: list[list[int]]
    h: list[float]
    m: list[int]

    @property
    def dt_L(self) -> float:
        """The major step."""
        return self.h[0]

    def scaled(self, dt: float) -> Grid:
        """The same groups and ratios with a major step of dt [s]."""
        return Grid(self.groups, [h * (dt / self.h[0]) for h in self.h], self.m)

    def first_of(self, level: int) -> list[int]:
        """Positions in q_i of the groups slower than `level`."""
        return [k for group in self.groups[:level] for k in group]

    def from_level(self, level: int) -> list[int]:
        """Positions in q_i of the groups from `level` on."""
        return [k for group in self.groups[level:] for k in group]


def make_grid(groups: list[list[int]], dt: Any, m: list[Any], ratios: int, names: str) -> Grid:
    """Grid with major step dt and one more step for each ratio in m, (8) and (72).

    names: what the ratios belong to, for errors. Raises SchemeError for steps that are not positive, ratios that
    are not whole, or a wrong number of ratios.
    """
    if isinstance(dt, bool) or not isinstance(dt, Real) or not 0 < float(dt) < float("inf"):
        raise SchemeError(f"the step dt must be a positive number of seconds, not {dt!r}")
    if len(m) != ratios:
        count = "one number" if ratios == 1 else f"{ratios} numbers"
        if ratios == 0:
            raise SchemeError(f"m: {names} takes all coordinates in one step, so it has no ratio; leave m out, not {m}")
        if len(groups) > 1:
            meaning = f"how many steps each next of the groups {names} takes in one of the group before it"
        else:
            meaning = f"how many sub-steps {names} takes in one step dt"
        given = f"{len(m)} were given: {m}" if m else "none was given"
        raise SchemeError(f"m must hold {count}, {meaning}, such as {[4] * ratios}; {given}")
    for ratio in m:
        if isinstance(ratio, bool) or not isinstance(ratio, int) or not 1 <= ratio <= MAX_RATIO:
            raise SchemeError(f"m must hold whole numbers from 1 to {MAX_RATIO}, not {ratio!r}")
    steps = [float(dt)]
    for ratio in m:
        steps.append(steps[-1] / ratio)
    return Grid(groups, steps, list(m))
