"""What drives a run from outside: inputs as constants, functions of time, held samples, and sampled controllers."""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from runtime.contract.errors import ModelError
from runtime.contract.model import Model
from runtime.contract.signals import SINCE, SUFFIXES
from runtime.running.schedule import Controller, Schedule

ON_THE_GRID = 1e-6  # of a step: a sample that far from the end of a step is at it


@dataclass(frozen=True)
class Sampled:
    """A controller: function(t, values) decides an input every so many seconds; it is held in between.

    values (k,): coordinates, rates and measures named in `reads`, as they are at t. memory: numbers that the function
    remembers, as each run begins with them; it is called as function(t, values, memory) and changes that array (k,) in
    place. Checkpoints keep it. () says that it remembers nothing; None that it may remember what cannot be kept, and
    such a run has no checkpoints.
    """

    function: Callable[..., float]
    every: float
    reads: Sequence[str] = ()
    memory: Sequence[float] | None = None


InputValue = float | Callable[[Any], Any] | tuple[Sequence[float], Sequence[float]] | Sampled


def bound(model: Model, inputs: Mapping[str, InputValue] | None) -> Model:
    """The model with the constants and functions among the inputs; driven_by is a hash of functions and samples.

    By it a checkpoint is gone on with by a run that is driven alike. Raises ModelError and ArgumentError.
    """
    if not inputs:
        return model
    sampled = {name: value for name, value in inputs.items() if isinstance(value, tuple | list | Sampled)}
    for name in sampled:
        if name not in model.inputs:
            raise ModelError(f"model {model.name} has no input {name!r}; it has {', '.join(model.inputs) or 'none'}")
    plain: dict[str, Any] = {name: value for name, value in inputs.items() if name not in sampled}
    found = model.with_inputs(plain)
    arrays = {name: value for name, value in sampled.items() if isinstance(value, tuple | list)}
    controllers = {name: value for name, value in sampled.items() if isinstance(value, Sampled)}
    if not sampled and not found.sources:
        return found
    digest = hashlib.sha256()
    for name, function in sorted(found.sources.items()):
        digest.update(f"{name} {function.serialize()}".encode())
    for name, (times, values) in sorted(arrays.items()):
        digest.update(f"{name} {list(map(float, times))} {list(map(float, values))}".encode())
    for name, controller in sorted(controllers.items()):
        digest.update(f"{name} {controller.every!r} {list(controller.reads)}".encode())
    return replace(found, driven_by=digest.hexdigest())


def scheduled(model: Model, inputs: Mapping[str, InputValue] | None, t0: float, dt: float) -> Schedule:
    """The samples and controllers among the inputs on a grid of steps. Raises ModelError."""
    schedule = Schedule(model.signals)
    for name, value in (inputs or {}).items():
        if isinstance(value, Sampled):
            every = _steps(name, value.every, dt)
            if every < 1:
                raise ModelError(
                    f"input {name!r}", "its controller must be asked every dt or less often", f"dt = {dt:g}"
                )
            schedule.controllers.append(
                Controller(name, every, value.function, tuple(value.reads), _memory(name, value))
            )
        elif isinstance(value, tuple | list):
            _add_samples(schedule, model, name, value, t0, dt)
    return schedule


def _add_samples(schedule: Schedule, model: Model, name: str, value: Any, t0: float, dt: float) -> None:
    times, values = _arrays(name, value)
    steps = [_steps(name, float(t) - t0, dt) for t in times]
    record = next(entry for entry in model.description.inputs if entry.name == name)
    if not record.rates or record.filter:
        rows = [{name: float(one)} for one in values]
    elif len(times) == 1:
        rows = [{name: float(values[0])}]
    else:  # twice continuously differentiable, at rest before the first and after the last sample
        from scipy.interpolate import CubicSpline  # takes long to load, and few runs need it

        spline = CubicSpline(times, values, bc_type="clamped")
        rows = [{f"{name}{suffix}": float(spline(t, k)) for k, suffix in enumerate(SUFFIXES)} for t in times[:-1]]
        rows.append({name: float(values[-1]), **{f"{name}{suffix}": 0.0 for suffix in SUFFIXES[1:]}})
    for step, row in zip(steps, rows, strict=True):
        at = max(step, 0)  # of samples before the start the last one counts
        schedule.samples[at] = {**schedule.samples.get(at, {}), **row}


def _memory(name: str, controller: Sampled) -> np.ndarray | None:
    if controller.memory is None:
        return None
    try:
        found = np.array(controller.memory, dtype=float)
    except (TypeError, ValueError):
        found = np.full(1, np.nan)
    if found.ndim != 1 or not np.isfinite(found).all():
        raise ModelError(f"input {name!r}", "what its controller remembers is no list of finite numbers", "give one")
    return found


def _arrays(name: str, value: Any) -> tuple[np.ndarray, np.ndarray]:
    remedy = "give (times, values): as many of both, the times rising"
    try:
        times, values = (np.asarray(part, dtype=float) for part in value)
    except (TypeError, ValueError):
        raise ModelError(f"input {name!r}", "its samples are not two lists of numbers", remedy) from None
    if times.ndim != 1 or times.shape != values.shape or not len(times):
        raise ModelError(f"input {name!r}", f"its samples have shapes {times.shape} and {values.shape}", remedy)
    if not (np.isfinite(times).all() and np.isfinite(values).all() and np.all(np.diff(times) > 0)):
        raise ModelError(f"input {name!r}", "its samples are not finite, or their times do not rise", remedy)
    return times, values


def _steps(name: str, time: float, dt: float) -> int:
    """How many steps a time is. Raises ModelError if it lies within one."""
    if not np.isfinite(time):
        raise ModelError(f"input {name!r}", f"its samples are {time} s apart", "give a time in seconds")
    count = round(time / dt)
    if abs(time / dt - count) > ON_THE_GRID * max(1.0, abs(count)):
        raise ModelError(
            f"input {name!r}", f"its sample at {time:g} s after the start lies within a step of {dt:g} s",
            "choose dt so that samples are at the ends of steps",
        )  # fmt: skip
    return count


def started(model: Model, p: np.ndarray, schedule: Schedule, t0: float) -> np.ndarray:
    """p (n_p,) with the inputs as they are at t0: samples of the start taken, and rates counted from there."""
    n = model.signals.size
    if not n:
        return p
    found = p.copy()
    if SINCE in model.signals.names:
        found[-1] = t0
    found[-n:] = model.signals.changed(found[-n:], t0, schedule.samples.get(0, {}))
    return found
