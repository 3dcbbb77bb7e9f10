"""Controllers in Python that decide inputs at times which are apart by as much each: what they decide, with slopes.

What a controller remembers is part of the state that repeats: x = (q_i, q_i_dot, memory). At a sample it is called once
with symbols in place of the values it reads and of what it remembers, the time being a number; derivatives follow from
the expressions that it leaves. What cannot be written down so, such as a branch upon a value, is refused.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from math import lcm
from typing import Any

import casadi as ca
import numpy as np

from runtime.contract.errors import ArgumentError
from runtime.contract.model import Model
from runtime.orbits.states import States
from runtime.running.inputs import ON_THE_GRID, InputValue, Sampled

Inputs = Mapping[str, InputValue]


def controllers_in(inputs: Inputs) -> dict[str, Sampled]:
    """Those among the inputs, by name."""
    return {name: value for name, value in inputs.items() if isinstance(value, Sampled)}


def refuse_samples(inputs: Inputs, period: str) -> None:
    """Raises ArgumentError where there are controllers, for what the period does."""
    for name in controllers_in(inputs):
        problem = f"is decided at times of its own, and the period {period}"
        raise ArgumentError(
            f"input {name!r}", problem, "hold the period, or write the controller as states of the scene"
        )


def refuse_controllers(model: Model, inputs: Inputs, free: bool) -> None:
    """Raises ArgumentError for controllers that have no derivative; free: is the period unknown?"""
    if free:
        refuse_samples(inputs, "is not known")
    moving = {entry.name for entry in model.description.inputs if entry.rates or entry.filter}
    for name, controller in controllers_in(inputs).items():
        item = f"input {name!r}"
        if controller.memory is None:
            raise ArgumentError(item, "may remember what does not repeat", "give memory=[...], () if it has none")
        if name in moving:
            raise ArgumentError(item, "has rates or a filter, which samples do not set", "take an input without them")
        if controller.every <= 0:
            raise ArgumentError(item, f"is decided every {controller.every:g} s", "give a positive time")


def samples_in(period: float, inputs: Inputs) -> int:
    """Into how many pieces of equal length samples divide a period (1: there are none). Raises ArgumentError."""
    return lcm(1, *(_times(period, name, one) for name, one in controllers_in(inputs).items()))


def _times(period: float, name: str, controller: Sampled) -> int:
    count = round(period / controller.every)
    if count < 1 or abs(period / controller.every - count) > ON_THE_GRID * count:
        raise ArgumentError(
            f"input {name!r}",
            f"is decided every {controller.every:.6g} s, and the period of {period:.9g} s is no whole multiple of that",
            "give a period that is one, or another sampling time",
        )
    return count


class RememberingStates(States):
    """States of a motion, and behind them what its controllers remember, one after the other."""

    def __init__(self, model: Model, controllers: Mapping[str, Sampled]) -> None:
        super().__init__(model)
        self.motion = States(model)
        self._first = np.array([number for one in controllers.values() for number in one.memory or ()], dtype=float)
        self.names = [
            *self.motion.names,
            *(f"memory[{k}] of {name}" for name, one in controllers.items() for k in range(len(one.memory or ()))),
        ]

    def of(self, q: np.ndarray, q_dot: np.ndarray) -> np.ndarray:
        """With what controllers remember at first."""
        return np.append(self.motion.of(q, q_dot), self._first)

    def by_name(self, x: np.ndarray) -> dict[str, float]:
        """Of the motion."""
        return self.motion.by_name(x[: self.own])

    def sizes(self, x: np.ndarray, period: float) -> np.ndarray:
        """A number that is remembered is judged by itself."""
        n = self.own
        kept = np.abs(x[n:])
        return np.append(self.motion.sizes(x[:n], period), np.maximum(kept, 1e-6 * kept.max(initial=1e-6)))


def states_of(model: Model, inputs: Inputs) -> States:
    """What the numbers of x are."""
    controllers = controllers_in(inputs)
    return RememberingStates(model, controllers) if controllers else States(model)


def remembering(inputs: Inputs, x: np.ndarray) -> dict[str, InputValue]:
    """The inputs with controllers that remember what the state x (n,) holds."""
    found, end = dict(inputs), len(x)
    for name, one in reversed(controllers_in(inputs).items()):
        first = end - len(one.memory or ())
        found[name], end = replace(one, memory=x[first:end].tolist()), first
    return found


def decision(name: str, controller: Sampled, t: float) -> ca.Function:
    """(values, memory) -> ((input, memory afterwards), its slopes by both) at t [s].

    Raises ArgumentError for a function that takes no symbols.
    """
    values, memory = ca.SX.sym("values", len(controller.reads)), ca.SX.sym("memory", len(controller.memory or ()))
    seen, kept = (np.array(ca.vertsplit(one) if one.numel() else [], dtype=object) for one in (values, memory))
    try:
        given: Any = controller.function(t, seen, kept) if len(kept) else controller.function(t, seen)
        decided = ca.densify(ca.vertcat(ca.SX(given.item() if isinstance(given, np.ndarray) else given), *kept))
        slopes = ca.densify(ca.jacobian(ca.SX(decided), ca.vertcat(values, memory)))
    except Exception as error:  # whatever a function says that gets symbols
        raise ArgumentError(
            f"input {name!r}",
            f"is decided by a function that is not differentiated, for it takes no symbols: {str(error)[:80]}",
            "write it with +, -, *, / and functions of CasADi (ca.fmin, ca.if_else), or as states of the scene",
        ) from None
    return ca.Function("decision", [values, memory], [decided, slopes])
