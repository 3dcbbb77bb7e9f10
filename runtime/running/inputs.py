"""What drives a run from outside: inputs as constants, functions of time, held samples, and sampled controllers."""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import casadi as ca
import numpy as np

from runtime.contract.errors import ArgumentError, ModelError
from runtime.contract.model import EmittedModel
from runtime.contract.signals import SINCE, SUFFIXES, Signals
from runtime.contract.status import Status
from runtime.schemes.scheme import Scheme, direct

SAMPLE_AT_STEP = 1e-6  # of a step: a sample that far from the end of a step is at it


@dataclass(frozen=True)
class Sampled:
    """A controller that decides an input every so many seconds, held in between (zero-order hold).

    Parameters
    ----------
    function : callable
        Called as function(t, values) with the time [s] and the values (k,) named in `reads`; it gives the input.
    every : float
        Time between its calls [s].
    reads : sequence of str
        Coordinates, rates and measures that it sees, as they are at t.
    memory : sequence of float, optional
        Numbers that it remembers, as each run begins with them: it is called as function(t, values, memory) and
        changes that array in place; checkpoints keep it. () says that it remembers nothing; None that it may remember
        what cannot be kept, and such a run has no checkpoints.
    """

    function: Callable[..., float]
    every: float
    reads: Sequence[str] = ()
    memory: Sequence[float] | None = None


InputValue = float | Callable[[Any], Any] | tuple[Sequence[float], Sequence[float]] | Sampled


def bound(model: EmittedModel, inputs: Mapping[str, InputValue] | None) -> EmittedModel:
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
    for name, samples in sorted(arrays.items()):
        times, values = (part.tolist() for part in _arrays(name, samples))
        digest.update(f"{name} {times} {values}".encode())
    for name, controller in sorted(controllers.items()):
        digest.update(f"{name} {controller.every!r} {list(controller.reads)}".encode())
    return replace(found, driven_by=digest.hexdigest())


def scheduled(model: EmittedModel, inputs: Mapping[str, InputValue] | None, t0: float, dt: float) -> Schedule:
    """The samples and controllers among the inputs on a grid of steps. Raises ModelError."""
    schedule = Schedule(model.signals)
    for name, value in (inputs or {}).items():
        if isinstance(value, Sampled):
            every = _steps(name, value.every, dt)
            if every < 1:
                raise ModelError(
                    f"input {name!r}", "its controller must be sampled every dt or less often", f"dt = {dt:g}"
                )
            schedule.controllers.append(
                Controller(name, every, value.function, tuple(value.reads), _memory(name, value))
            )
        elif isinstance(value, tuple | list):
            _add_samples(schedule, model, name, value, t0, dt)
    return schedule


def _add_samples(schedule: Schedule, model: EmittedModel, name: str, value: Any, t0: float, dt: float) -> None:
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
        raise ModelError(f"input {name!r}", "what its controller remembers is not a list of finite numbers", "give one")
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
    if abs(time / dt - count) > SAMPLE_AT_STEP * max(1.0, abs(count)):
        raise ModelError(
            f"input {name!r}", f"its sample at {time:g} s after the start lies within a step of {dt:g} s",
            "choose dt so that samples are at the ends of steps",
        )  # fmt: skip
    return count


def started(model: EmittedModel, p: np.ndarray, schedule: Schedule, t0: float) -> np.ndarray:
    """p (n_p,) with the inputs as they are at t0: samples of the start taken, and rates counted from there."""
    n = model.signals.size
    if not n:
        return p
    found = p.copy()
    if SINCE in model.signals.names:
        found[-1] = t0
    found[-n:] = model.signals.changed(found[-n:], t0, schedule.samples.get(0, {}))
    return found


# What becomes of the inputs of a run at which step: samples, and controllers with what they remember.


class EndlessInput(Exception):
    """A controller gave a number that is not finite; status: how the run ends by it."""

    def __init__(self, status: Status) -> None:
        super().__init__(str(status))
        self.status = status


DONE = ""  # in what a schedule remembers, beside the names of inputs


@dataclass
class Controller:
    """An input that a function decides every so many steps from what it reads; memory: see `Sampled`."""

    name: str
    every: int
    function: Callable[..., float]
    reads: tuple[str, ...]
    memory: np.ndarray | None = None
    _read: Callable[[np.ndarray], np.ndarray] | None = None

    def read_from(self, scheme: Scheme, c: np.ndarray) -> None:
        """Let it read the states of a run with the model's constants c (c_size,). Raises ModelError."""
        constants: Any = scheme.constants(c)
        function = direct(scheme, f"read {self.reads}", lambda: reading(scheme, scheme.layout.size, self.reads))
        self._read = lambda z: function(z, constants)

    def decides(self, t: float, z: np.ndarray) -> float:
        """The input from t [s] on; z: the scheme's part of the state. Raises ArgumentError and EndlessInput."""
        assert self._read is not None
        read = self._read(z)
        remembered = self.memory is not None and len(self.memory)
        given = self.function(t, read, self.memory) if remembered else self.function(t, read)
        try:
            found = float(given)
        except (TypeError, ValueError):
            raise ArgumentError(
                f"the controller of input {self.name!r} gave {given!r} at t = {t:g} s: give a number"
            ) from None
        if not np.isfinite(found):
            cause = f"the controller of input {self.name!r} gave {found}"
            raise EndlessInput(Status("not_finite", t, None, cause, "Results up to that time are kept."))
        return found


@dataclass
class Schedule:
    """What becomes of the inputs at which step: samples by step, and controllers. done: the last step looked at."""

    signals: Signals
    samples: dict[int, dict[str, float]] = field(default_factory=dict)
    controllers: list[Controller] = field(default_factory=list)
    done: int = -1

    def until_next(self, step: int) -> int | None:
        """Steps from this one to the next change; None if there is none."""
        following = [at - step for at in self.samples if at > step]
        following += [controller.every - step % controller.every for controller in self.controllers]
        return min(following, default=None)

    def changes(self, steps: int) -> set[int]:
        """The steps, of so many, behind whose start an input may change; what is given for 0 is there at once."""
        by_function = (set(range(0, steps, one.every)) for one in self.controllers)
        return {step for step in self.samples if 0 < step < steps}.union(*by_function)

    def apply(self, step: int, t: float, z: np.ndarray, w: np.ndarray) -> np.ndarray | None:
        """(n_w,) w from this step on, where something is to change; z: the scheme's part of the state."""
        values: dict[str, float] = {}
        for at in sorted(at for at in self.samples if self.done < at <= step):
            values |= self.samples[at]
        for controller in self.controllers:
            if step % controller.every == 0 and step > self.done:
                values[controller.name] = controller.decides(t, z)
        self.done = max(self.done, step)
        return self.signals.changed(w, t, values) if values else None

    def memory(self) -> dict[str, list[float]]:
        """What a checkpoint keeps of it."""
        kept = {one.name: one.memory.tolist() for one in self.controllers if one.memory is not None}
        return {DONE: [self.done], **kept}

    def resume(self, kept: Mapping[str, list[float]]) -> None:
        """Go on as the schedule whose memory this was. Raises ModelError where a controller remembers other numbers."""
        self.done = int(kept[DONE][0]) if DONE in kept else self.done
        for one in self.controllers:
            if one.memory is None or len(one.memory) != len(kept.get(one.name, [])):
                raise ModelError(
                    f"input {one.name!r}",
                    "its controller has another memory than that of the checkpoint",
                    "pass the same controller",
                )
            one.memory[:] = kept[one.name]

    def rows(self, times: np.ndarray, dt: float, w: np.ndarray) -> np.ndarray:
        """(N, n_w) the numbers of the inputs at times that are steps of dt apart, or multiples of it."""
        found, steps = [], np.rint((times - times[0]) / dt).astype(int)
        for step in steps:
            due = sorted(at for at in self.samples if self.done < at <= step)
            for at in due:
                w = self.signals.changed(w, float(times[0]) + at * dt, self.samples[at])
            self.done = int(step)
            found.append(w)
        return np.array(found)


# Outputs of a scheme's state by name, as one Function.


def reading(scheme: Scheme, z_size: int, names: Sequence[str]) -> ca.Function:
    """(z, c) -> the named values (k,); z may be longer than the scheme's part. Raises ModelError for another name."""
    z, c = ca.SX.sym("z", z_size), ca.SX.sym("c", scheme.c_size)
    from runtime.results.named_outputs import output_values

    values = output_values(scheme, names, z[: scheme.layout.size], c)
    return ca.Function("reading", [z, c], [ca.densify(values)])
