"""A motion that chatters: it crosses the same kink of a load, or of a rate of a state, ever again within a few steps.

Where a right-hand side jumps and leads back to its jump from both sides, the motion slides along it (Filippov 1988;
Acary & Brogliato 2008, chapter 2): steps jump to and fro, and their error falls in proportion to their length at best.
"""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from runtime.contract.status import Event

CROSSINGS_OF_CHATTER, WITHIN = (
    20,
    120.0,
)  # so many crossings within so many steps: a vibration would have twelve steps a period


def chattering(events: Iterable[Event], step: float) -> list[Event]:
    """What chatters, in words, by the kinks that a run by steps of about so long [s] has crossed; one event a kink."""
    crossed: dict[str, list[float]] = {}
    for event in events:
        if event.kind == "kink":
            crossed.setdefault(event.name, []).append(event.time)
    found = []
    for name, at in crossed.items():
        times = np.sort(at)
        close = np.flatnonzero(times[CROSSINGS_OF_CHATTER - 1 :] - times[: 1 - CROSSINGS_OF_CHATTER] <= WITHIN * step)
        if len(close):
            within = times[close[0] : close[-1] + CROSSINGS_OF_CHATTER]
            found.append(Event(float(within[0]), "chattering", _text(name, within), name))
    return found


def _text(name: str, times: np.ndarray) -> str:
    return (
        f"{name} chatters: it is crossed {len(times)} times from t = {times[0]:.6g} to {times[-1]:.6g} s, ever again "
        "within a few steps. What jumps there leads back from both sides, so that the motion slides along it, and "
        "steps err in proportion to their length. Let it change smoothly (tanh in place of sign), give a hysteresis "
        "by two events, or dry friction as the friction of a joint"
    )
