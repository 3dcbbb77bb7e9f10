"""Controllers in Python that decide inputs at times which are apart by as much each: what they decide, with slopes.

What a controller remembers is part of the state that repeats: x = (q_i, q_i_dot, memory). At a sample it is called once
with symbols in place of the values it reads and of what it remembers, the time being a number; derivatives follow from
the expressions that it leaves. What cannot be written down so, such as a branch upon a value, is refused.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from math import lcm
from typing import Any

import casadi as ca
import numpy as np

from runtime.contract.errors import ArgumentError
from runtime.contract.model import EmittedModel
from runtime.gradients.differentiable_run import DifferentiableRun
from runtime.orbits.shooting import PeriodMap, Setting, Shot, result_of
from runtime.orbits.states import States
from runtime.running.inputs import SAMPLE_AT_STEP, InputValue, Sampled

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


def refuse_controllers(model: EmittedModel, inputs: Inputs, free: bool) -> None:
    """Raises ArgumentError for controllers that have no derivative; free: is the period unknown?"""
    if free:
        refuse_samples(inputs, "is not known")
    moving = {entry.name for entry in model.description.inputs if entry.rates or entry.filter}
    for name, controller in controllers_in(inputs).items():
        item = f"input {name!r}"
        if controller.memory is None:
            raise ArgumentError(item, "may have a memory that does not repeat", "give memory=[...], () if it has none")
        if name in moving:
            raise ArgumentError(item, "has rates or a filter, which samples do not set", "take an input without them")
        if controller.every <= 0:
            raise ArgumentError(item, f"is sampled every {controller.every:g} s", "give a positive time")


def samples_in(period: float, inputs: Inputs) -> int:
    """Into how many pieces of equal length samples divide a period (1: there are none). Raises ArgumentError."""
    return lcm(1, *(_times(period, name, one) for name, one in controllers_in(inputs).items()))


def _times(period: float, name: str, controller: Sampled) -> int:
    count = round(period / controller.every)
    if count < 1 or abs(period / controller.every - count) > SAMPLE_AT_STEP * count:
        raise ArgumentError(
            f"input {name!r}",
            f"is sampled every {controller.every:.6g} s: the period, {period:.9g} s, is not a whole multiple of that",
            "give a period that is one, or another sampling time",
        )
    return count


class RememberingStates(States):
    """States of a motion, and behind them what its controllers remember, one after the other."""

    def __init__(self, model: EmittedModel, controllers: Mapping[str, Sampled]) -> None:
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


def states_of(model: EmittedModel, inputs: Inputs) -> States:
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
    readings, kept = (np.array(ca.vertsplit(one) if one.numel() else [], dtype=object) for one in (values, memory))
    try:
        given: Any = controller.function(t, readings, kept) if len(kept) else controller.function(t, readings)
        decided = ca.densify(ca.vertcat(ca.SX(given.item() if isinstance(given, np.ndarray) else given), *kept))
        slopes = ca.densify(ca.jacobian(ca.SX(decided), ca.vertcat(values, memory)))
    except Exception as error:  # whatever a function says that gets symbols
        raise ArgumentError(
            f"input {name!r}",
            f"is set by a function that cannot be differentiated, as it takes no symbols: {str(error)[:80]}",
            "write it with +, -, *, / and functions of CasADi (ca.fmin, ca.if_else), or as states of the scene",
        ) from None
    return ca.Function("decision", [values, memory], [decided, slopes])


# The map of a period in which controllers decide inputs: from sample to sample, with derivatives by the chain rule.
#
# Between two samples inputs are constant: (s, u) -> s' is a run with its tangents, s = (q_i, q_i_dot). At a sample
# r(s) is read, and (u, memory) = f(t, r, memory). A period holds a whole number of samples of each controller.
# Source: Astrom & Wittenmark, Computer-Controlled Systems, ch. 2 and 3.

Moving = tuple[np.ndarray, np.ndarray]  # numbers (k,), and their slopes (k, n + n_by) by the start and parameters


def period_map(setting: Setting, period: float, parameters: Mapping[str, float], by: Sequence[str]) -> PeriodMap:
    """By what drives the model."""
    kind = SampledMap if controllers_in(setting.inputs) else PeriodMap
    return kind(setting, period, parameters, by)


class SampledMap(PeriodMap):
    """Of a model with controllers; x: see `RememberingStates`. Raises ArgumentError for what has no derivative."""

    def __init__(self, setting: Setting, period: float, parameters: Mapping[str, float], by: Sequence[str]) -> None:
        self._controllers = controllers_in(setting.inputs)
        self._reads = list(dict.fromkeys(name for one in self._controllers.values() for name in one.reads))
        self._decisions: dict[tuple[str, int], ca.Function] = {}
        super().__init__(setting, period, parameters, by)
        self._motion, self.states = self.states, states_of(setting.model, setting.inputs)

    def _first(self, period: float) -> DifferentiableRun:
        plain = {name: value for name, value in self.setting.inputs.items() if name not in self._controllers}
        return self._prepared(period, [*self.states.outputs, *self._reads], [*self._controllers, *self.by], plain)

    def shot(self, x: np.ndarray, period: float, values: Sequence[float]) -> Shot:
        """From states x (K, n) at parameters `by` with these values. Raises NoPeriodicMotion and ArgumentError."""
        parts, n = self.setting.parts, self.size
        found = [self._through(k, x[k], period, values, x[(k + 1) % parts]) for k in range(parts)]
        slopes = np.array([one[1] for one in found])
        return Shot(
            x, np.array([one[0] for one in found]), slopes[:, :, :n], slopes[:, :, n:], np.array([r for *_, r in found])
        )

    def _end(self, k: int, x: np.ndarray, period: float, values: Sequence[float], beside: np.ndarray) -> np.ndarray:
        return self._through(k, x, period, values, beside)[0]

    # ---- from sample to sample -----------------------------------------------------------------------------------

    def _through(
        self, k: int, x: np.ndarray, period: float, values: Sequence[float], beside: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """(end (n,), its slopes (n, n + n_by), rates (n,)) of part k from x."""
        count = samples_in(period, self.setting.inputs)
        strides = self._strides(period, count)
        n, pieces, length, states = self.states.own, count // self.setting.parts, period / count, self._motion
        D = np.eye(len(x), len(x) + len(self.by))
        by_p = np.eye(len(self.by), D.shape[1], len(x))
        z, memory = (x[:n], D[:n]), (x[n:], D[n:])
        u = np.zeros(len(strides)), np.zeros((len(strides), D.shape[1]))
        readings, own = self._read_first(k * pieces * length, length, z, values, by_p), len(states.outputs)
        rates = np.zeros(len(x))
        for j in range(k * pieces, (k + 1) * pieces):
            memory, u = self._decided(j, length, strides, readings, memory, u)
            run = self._piece(j * length, length, self.setting.steps // pieces)
            found = result_of(run.jacobian, np.concatenate([z[0], u[0], values]))
            shown, slopes = found.values[-1], found.derivatives[-1] @ np.vstack([z[1], u[1], by_p])
            end, rates[:n] = states.state_of_outputs(shown[:own], beside[:n] if j + 1 == (k + 1) * pieces else z[0])
            z, readings = (end, states.slopes(shown[:own], slopes[:own], end)), (shown[own:], slopes[own:])
        return np.append(z[0], memory[0]), np.vstack([z[1], memory[1]]), rates

    def _strides(self, period: float, count: int) -> dict[str, int]:
        """Every so many pieces each controller decides. Raises ArgumentError for parts that do not begin with all."""
        times = {name: samples_in(period, {name: one}) for name, one in self._controllers.items()}
        parts = self.setting.parts
        if any(number % parts for number in times.values()):
            raise ArgumentError(
                "parts", f"are {parts}, and controllers decide {sorted(times.values())} times a period",
                "give a number that divides these",
            )  # fmt: skip
        return {name: count // number for name, number in times.items()}

    def _read_first(self, start: float, length: float, z: Moving, values: Sequence[float], by_p: np.ndarray) -> Moving:
        """What is read at the start of a part. Raises ArgumentError for what inputs act on at once."""
        n, n_u, own = len(z[0]), len(self._controllers), len(self._motion.outputs)
        run = self._piece(start, length / self.setting.steps, 1)
        found = result_of(run.jacobian, np.concatenate([z[0], np.zeros(n_u), values]))
        slopes = found.derivatives[0, own:]
        at_once = np.abs(slopes[:, n : n + n_u]).max(axis=1, initial=0.0) > 0
        if at_once.any():
            name = self._reads[int(at_once.argmax())]
            raise ArgumentError(
                f"what controllers read, {name!r}", "changes with inputs at once, and no state tells it at the start",
                "let them read coordinates, rates, and measures of these",
            )  # fmt: skip
        return found.values[0, own:], slopes[:, :n] @ z[1] + slopes[:, n + n_u :] @ by_p

    def _piece(self, start: float, length: float, steps: int) -> DifferentiableRun:
        key = (self.setting.t0 + start, length)
        if key not in self._placed:
            self._placed[key] = self._run.over(*key, steps)
        return self._placed[key]

    def _decided(
        self, j: int, length: float, strides: Mapping[str, int], readings: Moving, memory: Moving, u: Moving
    ) -> tuple[Moving, Moving]:
        """(memory, inputs) behind sample j."""
        memory, u, first = (memory[0].copy(), memory[1].copy()), (u[0].copy(), u[1].copy()), 0
        for k, (name, one) in enumerate(self._controllers.items()):
            own = slice(first, first := first + len(one.memory or ()))
            if j % strides[name]:
                continue
            if (name, j) not in self._decisions:
                self._decisions[name, j] = decision(name, one, self.setting.t0 + j * length)
            reads = [self._reads.index(read) for read in one.reads]
            found, slopes = (np.asarray(part) for part in self._decisions[name, j](readings[0][reads], memory[0][own]))
            moved = slopes @ np.vstack([readings[1][reads], memory[1][own]])
            u[0][k], u[1][k] = found[0, 0], moved[0]
            memory[0][own], memory[1][own] = found[1:, 0], moved[1:]
        return memory, u
