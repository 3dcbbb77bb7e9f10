"""Kinks of loads that a run has crossed: where the motion came to a condition of theirs and no step ended."""

from __future__ import annotations

import numpy as np

from runtime.contract.status import Event
from runtime.engine.rows import evaluate
from runtime.results.samples import Samples


def crossed_kinks(solution: Samples) -> list[Event]:
    """The first one of each load between two samples, for the inputs at the end."""
    model = solution.model
    owners = model.description.kinks
    first = sum(not event.mode for event in model.description.events)
    if not owners or len(solution.t) < 2:
        return []
    at = {"q": solution.q, "q_dot": solution.q_dot, "t": solution.t[:, None]}
    values = evaluate(model.kernel("events"), at, model.constants(solution.parameters))["events"][:, first:]
    passes = (values[:-1] < 0) & (values[1:] >= 0) | (values[:-1] > 0) & (values[1:] <= 0)
    found: dict[str, float] = {}
    for owner, column in zip(owners, passes.T, strict=True):
        if column.any():
            time = float(solution.t[1 + int(column.argmax())])
            found[owner] = min(time, found.get(owner, np.inf))
    text = (
        "a step crosses a kink of {}, so that errors are those of order 1 or 2; "
        'take options = {{"kinks": "located"}}, or declare an event there'
    )
    return [Event(time, "kink_crossed", text.format(owner), owner) for owner, time in found.items()]
