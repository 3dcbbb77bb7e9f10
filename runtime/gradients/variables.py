"""What is differentiated by: parameters and initial values, by name."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from difflib import get_close_matches

import numpy as np

from runtime.contract.coordinates import OMEGA
from runtime.contract.errors import ArgumentError, ModelError
from runtime.contract.model import EmittedModel
from runtime.gradients.course import Hold
from runtime.running.inputs import InputValue, Sampled, Schedule, bound, scheduled, started
from runtime.running.problem import Plan


@dataclass(frozen=True)
class Variables:
    """Names in the order asked for; parameters: of those that are, (position in the list, entry of p, its own name).

    initial: of initial values, (position, column of q, is it a rate?). samples: of held samples of inputs after the
    start, (position, value); one that is held from the start on is a parameter. turns: of orientations, (position,
    body, axis, is it an angular velocity?).
    """

    names: tuple[str, ...]
    parameters: tuple[tuple[int, int, str], ...]
    initial: tuple[tuple[int, int, bool], ...]
    samples: tuple[tuple[int, float], ...] = ()
    turns: tuple[tuple[int, str, int, bool], ...] = ()

    def named(self, x: np.ndarray) -> tuple[dict[str, float], dict[str, float]]:
        """(parameters, initial values) by name, of the values x (n,)."""
        return (
            {name: float(x[k]) for k, _, name in self.parameters},
            {self.names[k]: float(x[k]) for k, _, _ in self.initial},
        )

    def checked(self, x: Sequence[float] | np.ndarray | Mapping[str, float]) -> np.ndarray:
        """Values (n,), from a vector or by name. Raises ArgumentError for a wrong length, a wrong name, NaN."""
        if isinstance(x, Mapping):
            wrong = [name for name in x if name not in self.names] + [name for name in self.names if name not in x]
            if wrong:
                raise ArgumentError("x", f"{wrong[0]!r} is not wanted or missing", f"give {', '.join(self.names)}")
            x = [x[name] for name in self.names]
        try:
            values = np.asarray(x, dtype=float)
        except (TypeError, ValueError, OverflowError, RecursionError):
            raise ArgumentError("x", "is not a list of numbers", f"give {', '.join(self.names)}") from None
        if values.shape != (len(self.names),):
            wanted = f"{len(self.names)} values: {', '.join(self.names)}"
            raise ArgumentError("x", f"has shape {values.shape}", f"give {wanted}")
        for name, value in zip(self.names, values, strict=True):
            if not np.isfinite(value):
                raise ArgumentError("x", f"the value of {name} is {value}", "give a finite number")
        return values


def starting_values(model: EmittedModel) -> dict[str, tuple[int, bool]]:
    """{name of an initial value: (column of q, is it a rate?)}."""
    found = {name: (k, False) for k, name in enumerate(model.coordinates)}
    return {**found, **{f"{name}_dot": (k, True) for k, name in enumerate(model.coordinates)}}


def independent_turns(model: EmittedModel) -> list[int]:
    """Positions of the orientations whose turns are all in q_i."""
    return [k for k, turns in enumerate(model.places.turns) if (turns < len(model.q_i)).all()]


def starting_turns(model: EmittedModel) -> dict[str, tuple[str, int, bool]]:
    """{name: (body, axis, is it an angular velocity?)} of orientations that are independent.

    `body.turn_x` [rad] turns the start further, with y and z as one rotation vector in axes of the body;
    `body.omega_x` is its angular velocity there.
    """
    records = [model.description.orientations[k] for k in independent_turns(model)]
    turns = {name: (one.body, k, False) for one in records for k, name in enumerate(one.turns)}
    return turns | {f"{one.body}.{name}": (one.body, k, True) for one in records for k, name in enumerate(OMEGA)}


def variables_of(model: EmittedModel, by: Sequence[str], held: Sequence[HeldSample] = ()) -> Variables:
    """Checked names. Raises ModelError for a name that is neither a parameter nor a coordinate nor its rate.

    The name of a sampled input stands for all its samples, which are called `input[number]`.
    """
    if isinstance(by, str) or not len(by):
        raise ModelError(f"by must be a list of parameters and initial values, not {by!r}")
    if len(set(by)) < len(by):
        raise ModelError(f"by names something twice: {', '.join(by)}")
    own = {parameter.name: k for k, parameter in enumerate(model.parameters)}
    sampled = {one.input for one in held}
    by = [name for given in by for name in ([one.name for one in held if one.input == given] or [given])]
    first = {one.name: one.input for one in held if one.step == 0}
    later = {one.name: one.value for one in held if one.step > 0}
    aliases = {name: name for name in own if name not in sampled} | first
    entries = {name: own[input_] for name, input_ in aliases.items()}
    starts, turns = starting_values(model), starting_turns(model)
    for name in by:
        if all(name not in known for known in (entries, starts, turns, later)):
            raise _unknown(model, str(name), [*entries, *starts, *turns, *later])
    return Variables(
        tuple(by),
        tuple((k, entries[name], aliases[name]) for k, name in enumerate(by) if name in entries),
        tuple((k, *starts[name]) for k, name in enumerate(by) if name in starts and name not in entries),
        tuple((k, later[name]) for k, name in enumerate(by) if name in later),
        tuple((k, *turns[name]) for k, name in enumerate(by) if name in turns),
    )


def _unknown(model: EmittedModel, name: str, known: list[str]) -> ModelError:
    near = get_close_matches(name, known, 1)
    meant = f" (did you mean {near[0]!r}?)" if near else ""
    listed = ", ".join(parameter.name for parameter in model.parameters if parameter.kind != "data")
    return ModelError(
        f"model {model.name} has neither a parameter nor a coordinate {name!r}{meant}; parameters: {listed}; "
        f"initial values: {', '.join(model.coordinates)} (rates end in _dot). Numbers that give a scene its structure "
        "(counts of modes, a length that is zero) are no parameters: change the scene"
    )


# What drives a differentiated run from outside: inputs that are constants, functions of time, or held samples.

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


def driven_by(model: EmittedModel, inputs: Inputs | None) -> EmittedModel:
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


def held_samples(model: EmittedModel, inputs: Inputs | None, plan: Plan) -> list[HeldSample]:
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


def parameters_at(model: EmittedModel, values: Mapping[str, float], t0: float) -> np.ndarray:
    """p (n_p,) of a run that begins at t0 [s], the numbers of its inputs included. Raises ModelError."""
    return started(model, model.parameter_vector(values), Schedule(model.signals), t0)
