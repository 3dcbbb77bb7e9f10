"""What a scene says of its events, as records."""

from __future__ import annotations

from dataclasses import dataclass, field


@dataclass(frozen=True)
class EventRecord:
    """An event: rising, falling or either; terminal: does it end a run?; inputs that its action sets, in order.

    cool_down: for how long [s] it is not looked for once it has happened.
    """

    name: str
    direction: str
    terminal: bool = False
    sets: list[str] = field(default_factory=list)
    cool_down: float = 0.0
