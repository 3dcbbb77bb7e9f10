"""A run that begins where another ended goes on with what that had besides positions and rates.

Inputs that events had set, modes of friction and stops, memories of controllers and cool-downs of events go along. What
drives an input is a function, which no solution keeps: it is to be given again, and is refused by name where it is not.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from runtime.contract.coordinates import Initial
from runtime.contract.errors import ModelError
from runtime.contract.model import EmittedModel
from runtime.contract.signals import SINCE, SUFFIXES
from runtime.running.inputs import InputValue, Sampled, Schedule
from runtime.solutions.solution import Solution

START_AT_END = 1e-9  # of the end of the run before: a start that far from it is there
ON_ITS_GRID = 1e-6  # of the period of a controller


@dataclass(frozen=True)
class GoesOn:
    """w (n_w,): the inputs at the start; inputs: what drives them, with what controllers remember; quiet: events that
    are not looked for, and until when [s].
    """

    w: np.ndarray
    inputs: Mapping[str, InputValue]
    quiet: Mapping[str, float] = field(default_factory=dict)


def driven_inputs(model: EmittedModel, schedule: Schedule | None, inputs: Mapping[str, Any]) -> dict[str, Any]:
    """Which inputs are driven in a run, and what their controllers remember: (k,) numbers, None where nobody knows."""
    found: dict[str, Any] = {name: [] for name in (*model.sources, *inputs) if name in model.inputs}
    found = {name: one for name, one in found.items() if not isinstance(inputs.get(name), int | float | np.number)}
    for one in schedule.controllers if schedule is not None else ():
        found[one.name] = None if one.memory is None else one.memory.tolist()
    return found


def goes_on(
    model: EmittedModel,
    initial: Initial,
    t0: float,
    p: np.ndarray,
    parameters: Mapping[str, float],
    inputs: Mapping[str, InputValue],
) -> GoesOn | None:
    """What goes along into a run from t0 [s] with parameters p (n_p,); None where it does not begin at another's end.

    parameters, inputs: what is given anew, and stays as it is given. Raises ModelError for what cannot be continued.
    """
    if not isinstance(initial, Solution) or initial.model.digest != model.digest or not len(initial.t):
        return None
    if abs(float(initial.t[-1]) - t0) > START_AT_END * max(1.0, abs(t0)):
        return None
    for name in initial.driven:
        if name not in inputs and name not in parameters:
            raise ModelError(
                f"input {name!r}",
                "was driven in the run that is to go on, and a solution keeps no functions",
                "give what drives it among inputs, or a number among parameters",
            )
    events = {event.name: event for event in model.description.events if event.cool_down}
    last = {one.name: one.time + events[one.name].cool_down for one in initial.events if one.name in events}
    quiet = {name: until for name, until in last.items() if until > t0}
    remembered = {name: _remembering(name, value, initial, t0) for name, value in inputs.items()}
    n = model.signals.size
    return GoesOn(_inputs(model, initial.parameters[-n:], p[-n:], t0, {*parameters, *inputs}) if n else p[:0],
                  remembered, quiet)  # fmt: skip


def _inputs(model: EmittedModel, before: np.ndarray, given: np.ndarray, t0: float, names: set[str]) -> np.ndarray:
    """(n_w,) what was, with the own numbers of inputs that are given by name."""
    signals = model.signals
    if len(before) != len(given):
        return given
    found, own = signals.moved(before, t0), signals.moved(given, t0)
    for entry in signals.inputs:
        if names & {entry.name + end for end in SUFFIXES}:
            k = signals.first[entry.name]
            following = [one for one in signals.first.values() if one > k]
            end = min(following, default=signals.size - (SINCE in signals.names))
            found[k:end] = own[k:end]
    return found


def _remembering(name: str, value: InputValue, initial: Solution, t0: float) -> InputValue:
    """A controller with what it remembered. Raises ModelError."""
    if not isinstance(value, Sampled) or name not in initial.driven:
        return value
    kept, own = initial.driven[name], value.memory
    if kept is None and own is None:
        raise ModelError(
            f"input {name!r}",
            "the memory of its controller cannot be continued",
            "give its numbers as Sampled(..., memory=[...]), memory=() if it has none, or initial=run.initial_values()",
        )
    phase = (t0 - float(initial.t[0])) / value.every
    if abs(phase - round(phase)) > ON_ITS_GRID * max(1.0, abs(phase)):
        raise ModelError(
            f"input {name!r}",
            f"its controller is sampled every {value.every:g} s from {initial.t[0]:g} s on, and t0 = {t0:g} s lies "
            "between two samples",
            "start at a sample, or with initial=run.initial_values()",
        )
    if kept is None or own is None:
        return value
    if len(kept) != len(own):
        raise ModelError(
            f"input {name!r}", "its controller has another memory than that of the run", "pass the same controller"
        )
    return replace(value, memory=list(kept))
