"""Places of a flexible body whose stress is known, with what it follows from; and loads under which it buckles."""

from __future__ import annotations

from dataclasses import dataclass, field


@dataclass(frozen=True)
class GaugeRecord:
    """A place of `body` at `position` [m] in its axes; stresses in the order xx yy zz yz xz xy [Pa].

    shapes (6, nf): per unit of q_f. fields (6, 9 + 9 nf), forces (6, 6) by marker: per unit of each cause of
    runtime.contract.stress_causes; empty where they are not known.
    """

    body: str
    name: str
    position: list[float]
    shapes: list[list[float]]
    fields: list[list[float]] = field(default_factory=list)
    forces: dict[str, list[list[float]]] = field(default_factory=dict)


@dataclass(frozen=True)
class StrutRecord:
    """Critical loads [N] of `body` along the line between two of its markers, 0 where there is none.

    held: both markers are held in place; first, second: this one is clamped, the other free.
    """

    body: str
    markers: list[str]
    held: float = 0.0
    first: float = 0.0
    second: float = 0.0
