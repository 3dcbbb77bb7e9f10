"""What drives a differentiated run from outside: inputs that are constants, functions of time, or held samples."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from runtime.contract.errors import ArgumentError
from runtime.contract.model import Model
from runtime.gradients.course import Hold
from runtime.running.inputs import InputValue, Sampled, Schedule, bound, scheduled, started
from runtime.running.plan import Plan

Inputs = Mapping[str, InputValue]


@dataclass(frozen=True)
class HeldSample:
    """Sample `number` of an input by name: held from a step on (0: from the start), with this value."""

    input: str
    number: int
    step: int
    value: float

    @property
    def name(self) -> str:
        """As it is differentiated by."""
        return f"{self.input}[{self.number}]"


def driven_by(model: Model, inputs: Inputs | None) -> Model:
    """The model with these inputs. Raises ModelError, and ArgumentError for what is not differentiated."""
    moving = {entry.name for entry in model.description.inputs if entry.rates or entry.filter}
    for name, value in (inputs or {}).items():
        if isinstance(value, Sampled) or (isinstance(value, tuple | list) and name in moving):
            raise ArgumentError(
                f"input {name!r}",
                "a controller, or samples of an input with rates or a filter, are not differentiated",
                "give a constant or a function of time",
            )
    return bound(model, inputs)


def held_samples(model: Model, inputs: Inputs | None, plan: Plan) -> list[HeldSample]:
    """Of all sampled inputs, those that a run sees, by step. Raises ModelError for samples that cannot be used."""
    scheduled(model, inputs, plan.t0, plan.grid.dt_L)
    last: dict[tuple[str, int], HeldSample] = {}
    for name, value in (inputs or {}).items():
        if isinstance(value, tuple | list):
            for k, (t, number) in enumerate(zip(*value, strict=True)):
                step = max(round((float(t) - plan.t0) / plan.grid.dt_L), 0)
                last[name, step] = HeldSample(name, k, step, float(number))
    return sorted((one for one in last.values() if one.step < plan.steps), key=lambda one: one.step)


def holds_of(plan: Plan, samples: list[HeldSample], names: tuple[str, ...]) -> list[Hold]:
    """How the samples after the start are set in z; names: what is differentiated by."""
    if not samples:
        return []
    first, signals = plan.scheme.layout.slice("inputs").start, plan.scheme.model.signals
    found = [Hold(one.step, first + signals.first[one.input], one.value) for one in samples if one.step > 0]
    later = [one.name for one in samples if one.step > 0]
    return [
        replace(hold, place=names.index(name)) if name in names else hold
        for hold, name in zip(found, later, strict=True)
    ]


def parameters_at(model: Model, values: Mapping[str, float], t0: float) -> np.ndarray:
    """p (n_p,) of a run that begins at t0 [s], the numbers of its inputs included. Raises ModelError."""
    return started(model, model.parameter_vector(values), Schedule(model.signals), t0)
