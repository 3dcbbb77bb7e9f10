"""What becomes of the inputs of a run at which step: samples, and controllers with what they remember."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from runtime.contract.errors import ArgumentError, ModelError
from runtime.contract.model import Model
from runtime.contract.signals import Signals
from runtime.contract.status import Status
from runtime.running.reading import reading
from runtime.schemes.scheme import Scheme


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

    def read_from(self, model: Model, scheme: Scheme, c: np.ndarray) -> None:
        """Let it read the states of a run with the model's constants c (c_size,). Raises ModelError."""
        constants: Any = scheme.constants(c)
        function: Any = reading(model, scheme, scheme.layout.size, self.reads)
        self._read = lambda z: np.asarray(function(z, constants)).ravel()

    def decides(self, t: float, z: np.ndarray) -> float:
        """The input from t [s] on; z: the scheme's part of the state. Raises ArgumentError and EndlessInput."""
        assert self._read is not None
        seen = self._read(z)
        remembered = self.memory is not None and len(self.memory)
        given = self.function(t, seen, self.memory) if remembered else self.function(t, seen)
        try:
            found = float(given)
        except (TypeError, ValueError):
            raise ArgumentError(
                f"the controller of input {self.name!r} gave {given!r} at t = {t:g} s: give a number"
            ) from None
        if not np.isfinite(found):
            cause = f"the controller of input {self.name!r} gave {found}"
            raise EndlessInput(Status("not_finite", t, None, cause, "What was computed until then is kept."))
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
                    f"input {one.name!r}", "its controller does not remember what the checkpoint's did", "give that one"
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
